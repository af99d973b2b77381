#include "enumerate/graph_output.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/graphml.hpp>
#include <boost/graph/graphviz.hpp>

namespace requad::enumerate {

namespace {

int third_index(theory::PairType type, const theory::Configuration& c) {
  return type.symmetric() && type.rotation_count() > 1 && !c.merged() ? c.p : 0;
}

// The graph with plain attributes that Boost's writers understand.
struct PlainNode {
  std::string name, label, signature;
  long d1 = 0, d2 = 0, p = 0, faces = 0;
};
using PlainGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, PlainNode>;

PlainGraph plain_graph(const Exploration& found, theory::Apex apex) {
  std::vector<int> node_of;
  const theory::ConfigurationGraph graph = found_graph(found, apex, &node_of);
  PlainGraph plain(num_vertices(graph));
  for (std::size_t v = 0; v < node_of.size(); ++v) {
    const FoundNode& node = found.nodes[static_cast<std::size_t>(node_of[v])];
    const theory::Configuration& c = node.reading.configuration;
    plain[v] = {"n" + std::to_string(v),    theory::label(found.type, c), node.signature, c.d1(), c.d2(),
                third_index(found.type, c), node.region.mesh.face_count()};
  }
  for (const auto e : boost::make_iterator_range(edges(graph))) add_edge(source(e, graph), target(e, graph), plain);
  return plain;
}

boost::dynamic_properties attributes(PlainGraph& graph) {
  boost::dynamic_properties properties;
  properties.property("label", get(&PlainNode::label, graph));
  properties.property("d1", get(&PlainNode::d1, graph));
  properties.property("d2", get(&PlainNode::d2, graph));
  properties.property("p", get(&PlainNode::p, graph));
  properties.property("faces", get(&PlainNode::faces, graph));
  properties.property("signature", get(&PlainNode::signature, graph));
  return properties;
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
    json["nodes"].push_back(node_json(found.type, found.nodes[static_cast<std::size_t>(node)]));
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

std::string graph_dot(const Exploration& found, theory::Apex apex) {
  PlainGraph graph = plain_graph(found, apex);
  boost::dynamic_properties properties = attributes(graph);
  properties.property("node_id", get(&PlainNode::name, graph));
  std::ostringstream out;
  boost::write_graphviz_dp(out, graph, properties);
  return out.str();
}

std::string graph_graphml(const Exploration& found, theory::Apex apex) {
  PlainGraph graph = plain_graph(found, apex);
  std::ostringstream out;
  boost::write_graphml(out, graph, attributes(graph), true);
  return out.str();
}

}  // namespace requad::enumerate
