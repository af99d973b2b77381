#include "enumerate/graphs/graph_output.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <unordered_map>
#include <utility>

#include <boost/algorithm/string/join.hpp>
#include <boost/graph/connected_components.hpp>

#include "enumerate/graphs/attributed_graph.hpp"
#include "enumerate/graphs/configuration_rows.hpp"
#include "enumerate/graphs/grid_position.hpp"
#include "mesh/text/fixed_decimals.hpp"
#include "mesh/topology/signature.hpp"

namespace requad::enumerate {

namespace {

// An edge of the configuration graph, read from node i to node j: the move that leads there, and its operations on the
// mesh of node i's signature.
struct Edge {
  int i;
  int j;
  mesh::PairStep step;
  std::vector<mesh::BasicOperation> script;

  friend bool operator<(const Edge& a, const Edge& b) {
    return std::tie(a.i, a.j, a.step) < std::tie(b.i, b.j, b.step);
  }
};

// The edges of the graph, between the nodes `node_of`, in the order of their ends. The moves are made again, on the
// meshes that from_signature() gives, so that whoever has the signatures can follow the scripts.
std::vector<Edge> edges_with_scripts(const Exploration& found, const theory::ConfigurationGraph& graph,
                                     const std::vector<int>& node_of) {
  std::unordered_map<std::string, int> index;
  const auto signature_of = [&](std::size_t node) -> const std::string& {
    return found.nodes[static_cast<std::size_t>(node_of[node])].signature;
  };
  for (std::size_t i = 0; i < node_of.size(); ++i) index.emplace(signature_of(i), static_cast<int>(i));
  std::vector<Edge> result;
  for (std::size_t i = 0; i < node_of.size(); ++i) {
    const mesh::Region region = mesh::from_signature(signature_of(i));
    for (const mesh::PairMove& move : moves_of(region, read(region, found.shape.type()))) {
      mesh::Region after = region;
      mesh::MoveReport report = mesh::move_pair(after.mesh, move);
      if (report.refusal != mesh::Refusal::none) continue;
      const auto to = index.find(mesh::signature(after));
      if (to == index.end() || to->second < static_cast<int>(i)) continue;
      // Of the two moves along a loop, which undo each other, one stands for it.
      if (to->second == static_cast<int>(i) && move.step > mesh::inverse(move.step)) continue;
      result.push_back({static_cast<int>(i), to->second, move.step, std::move(report.operations)});
    }
  }
  if (result.size() != num_edges(graph)) throw std::logic_error("moves made again lead elsewhere");
  std::stable_sort(result.begin(), result.end());
  return result;
}

std::vector<std::string> script_lines(const std::vector<mesh::BasicOperation>& script) {
  std::vector<std::string> lines;
  for (const mesh::BasicOperation& operation : script) lines.push_back(mesh::to_string(operation));
  return lines;
}

AttributedGraph attributed_graph(const Exploration& found, theory::Apex apex) {
  std::vector<int> node_of;
  const theory::ConfigurationGraph graph = found_graph(found, apex, &node_of);
  AttributedGraph result;
  std::vector<std::string> labels, signatures, steps, scripts;
  std::vector<long> d1, d2, p, faces;
  std::vector<double> x, y;
  for (const int index : node_of) {
    const FoundNode& node = found.nodes[static_cast<std::size_t>(index)];
    const theory::Configuration& c = node.reading.configuration;
    result.names.push_back("n" + std::to_string(result.names.size()));
    labels.push_back(theory::label(found.shape.type(), c));
    signatures.push_back(node.signature);
    d1.push_back(c.d1());
    d2.push_back(c.d2());
    p.push_back(c.p);
    faces.push_back(node.region.mesh.face_count());
    const GridPosition at = grid_position(found.shape.type(), c);
    x.push_back(at[0]);
    y.push_back(at[1]);
  }
  result.at_nodes = {{"d1", d1}, {"d2", d2}, {"faces", faces}, {"label", labels}, {"p", p}, {"signature", signatures},
                     {"x", x},   {"y", y}};
  for (const Edge& edge : edges_with_scripts(found, graph, node_of)) {
    result.edges.push_back({edge.i, edge.j});
    steps.push_back(mesh::name(edge.step));
    scripts.push_back(boost::algorithm::join(script_lines(edge.script), "; "));
  }
  result.at_edges = {{"step", steps}, {"script", scripts}};
  return result;
}

}  // namespace

nlohmann::ordered_json node_json(theory::PairType type, const FoundNode& node) {
  const theory::Configuration& c = node.reading.configuration;
  nlohmann::ordered_json json{{"d1", c.d1()}, {"d2", c.d2()}, {"p", c.p}};
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

nlohmann::ordered_json empty_graph_json() {
  const auto list = nlohmann::ordered_json::array();
  return {{"nodes", list}, {"edges", list}, {"steps", list}, {"scripts", list}, {"components", 0}, {"complete", true}};
}

nlohmann::ordered_json graph_json(const Exploration& found, theory::Apex apex) {
  std::vector<int> node_of;
  const theory::ConfigurationGraph graph = found_graph(found, apex, &node_of);
  nlohmann::ordered_json json = empty_graph_json();
  for (const int node : node_of)
    json["nodes"].push_back(node_json(found.shape.type(), found.nodes[static_cast<std::size_t>(node)]));
  for (const Edge& edge : edges_with_scripts(found, graph, node_of)) {
    json["edges"].push_back({edge.i, edge.j});
    json["steps"].push_back(mesh::name(edge.step));
    json["scripts"].push_back(script_lines(edge.script));
  }
  std::vector<int> component(num_vertices(graph));
  json["components"] = component.empty() ? 0 : boost::connected_components(graph, component.data());
  return json;
}

std::string graph_dot(const Exploration& found, theory::Apex apex) {
  constexpr double kPointsPerUnit = 124;
  AttributedGraph graph = attributed_graph(found, apex);
  const auto take = [&graph](const char* name) {
    return std::get<std::vector<double>>(graph.at_nodes.extract(name).mapped());
  };
  const std::vector<double> x = take("x"), y = take("y");
  std::vector<std::string> positions;
  for (std::size_t i = 0; i < x.size(); ++i)
    positions.push_back(mesh::fixed_decimals(kPointsPerUnit * x[i], 3) + "," +
                        mesh::fixed_decimals(kPointsPerUnit * y[i], 3) + "!");
  graph.at_nodes["pos"] = positions;
  return to_dot(std::move(graph));
}

std::string graph_graphml(const Exploration& found, theory::Apex apex) {
  return to_graphml(attributed_graph(found, apex));
}

nlohmann::ordered_json graph_node_link(const Exploration& found, theory::Apex apex) {
  return to_node_link(attributed_graph(found, apex));
}

std::string graph_csv(const Exploration& found, theory::Apex apex) {
  ConfigurationRows rows(found.shape.type());
  for (std::size_t i = 0; i < found.nodes.size(); ++i) {
    if (apex == theory::Apex::without && !found.holds_pair(static_cast<int>(i))) continue;
    const FoundNode& node = found.nodes[i];
    rows.add(node.reading.configuration, node.region.mesh.face_count(), node.signature);
  }
  return rows.csv();
}

}  // namespace requad::enumerate
