#include "enumerate/graph_output.hpp"

#include <algorithm>

#include <boost/graph/connected_components.hpp>

#include "enumerate/attributed_graph.hpp"

namespace requad::enumerate {

namespace {

int third_index(theory::PairType type, const theory::Configuration& c) {
  return type.has_third_index() && !c.merged() ? c.p : 0;
}

AttributedGraph attributed_graph(const Exploration& found, theory::Apex apex) {
  std::vector<int> node_of;
  const theory::ConfigurationGraph graph = found_graph(found, apex, &node_of);
  AttributedGraph result;
  std::vector<std::string> labels, signatures;
  std::vector<long> d1, d2, p, faces;
  for (const int index : node_of) {
    const FoundNode& node = found.nodes[static_cast<std::size_t>(index)];
    const theory::Configuration& c = node.reading.configuration;
    result.names.push_back("n" + std::to_string(result.names.size()));
    labels.push_back(theory::label(found.shape.type(), c));
    signatures.push_back(node.signature);
    d1.push_back(c.d1());
    d2.push_back(c.d2());
    p.push_back(third_index(found.shape.type(), c));
    faces.push_back(node.region.mesh.face_count());
  }
  result.at_nodes = {{"d1", d1}, {"d2", d2}, {"faces", faces}, {"label", labels}, {"p", p}, {"signature", signatures}};
  for (const auto e : boost::make_iterator_range(edges(graph))) {
    result.edges.push_back({static_cast<int>(source(e, graph)), static_cast<int>(target(e, graph))});
  }
  return result;
}

}  // namespace

nlohmann::ordered_json node_json(theory::PairType type, const FoundNode& node) {
  const theory::Configuration& c = node.reading.configuration;
  nlohmann::ordered_json json{{"d1", c.d1()}, {"d2", c.d2()}, {"p", third_index(type, c)}};
  if (!type.symmetric()) {
    const theory::GridPoint at = theory::grid_point(type, c);
    json["m"] = at.m;
    json["n"] = at.n;
  }
  json["faces"] = node.region.mesh.face_count();
  json["label"] = theory::label(type, c);
  json["signature"] = node.signature;
  return json;
}

nlohmann::ordered_json graph_json(const Exploration& found, theory::Apex apex) {
  std::vector<int> node_of;
  const theory::ConfigurationGraph graph = found_graph(found, apex, &node_of);
  nlohmann::ordered_json json{{"nodes", nlohmann::ordered_json::array()}, {"edges", nlohmann::ordered_json::array()}};
  for (const int node : node_of)
    json["nodes"].push_back(node_json(found.shape.type(), found.nodes[static_cast<std::size_t>(node)]));
  std::vector<std::array<std::size_t, 2>> ends;
  for (const auto e : boost::make_iterator_range(edges(graph))) {
    ends.push_back({std::min(source(e, graph), target(e, graph)), std::max(source(e, graph), target(e, graph))});
  }
  std::sort(ends.begin(), ends.end());
  for (const auto& e : ends) json["edges"].push_back(e);
  std::vector<int> component(num_vertices(graph));
  json["components"] = component.empty() ? 0 : boost::connected_components(graph, component.data());
  return json;
}

std::string graph_dot(const Exploration& found, theory::Apex apex) { return to_dot(attributed_graph(found, apex)); }

std::string graph_graphml(const Exploration& found, theory::Apex apex) {
  return to_graphml(attributed_graph(found, apex));
}

}  // namespace requad::enumerate
