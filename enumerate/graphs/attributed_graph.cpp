#include "enumerate/graphs/attributed_graph.hpp"

#include <locale>
#include <sstream>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graphml.hpp>
#include <boost/graph/graphviz.hpp>

namespace requad::enumerate {

namespace {

using BoostGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                         boost::property<boost::edge_index_t, std::size_t>>;

BoostGraph boost_graph(const AttributedGraph& graph) {
  BoostGraph result(graph.names.size());
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const auto [from, to] = graph.edges[i];
    add_edge(static_cast<std::size_t>(from), static_cast<std::size_t>(to), i, result);
  }
  return result;
}

// While one lives, the global locale is the classic one. Boost writes numbers with the global locale.
class ClassicLocale {
 public:
  ClassicLocale() : before_(std::locale::global(std::locale::classic())) {}
  ~ClassicLocale() { std::locale::global(before_); }
  ClassicLocale(const ClassicLocale&) = delete;
  ClassicLocale& operator=(const ClassicLocale&) = delete;

 private:
  std::locale before_;
};

template <class Index>
void add_columns(boost::dynamic_properties& properties, std::map<std::string, AttributedGraph::Column>& columns,
                 Index index) {
  for (auto& [name, column] : columns) {
    std::visit([&, &name = name](
                   auto& values) { properties.property(name, make_iterator_property_map(values.begin(), index)); },
               column);
  }
}

// Refers to the columns of `graph`.
boost::dynamic_properties attributes(AttributedGraph& graph, const BoostGraph& structure) {
  boost::dynamic_properties properties;
  add_columns(properties, graph.at_nodes, get(boost::vertex_index, structure));
  add_columns(properties, graph.at_edges, get(boost::edge_index, structure));
  return properties;
}

void add_attributes(nlohmann::ordered_json& json, const std::map<std::string, AttributedGraph::Column>& columns,
                    std::size_t i) {
  for (const auto& [name, column] : columns) {
    std::visit([&, &name = name](const auto& values) { json[name] = values[i]; }, column);
  }
}

}  // namespace

nlohmann::ordered_json to_node_link(const AttributedGraph& graph) {
  using nlohmann::ordered_json;
  ordered_json json{{"directed", false},
                    {"multigraph", true},
                    {"graph", ordered_json::object()},
                    {"nodes", ordered_json::array()},
                    {"links", ordered_json::array()}};
  for (std::size_t i = 0; i < graph.names.size(); ++i) {
    ordered_json node{{"id", graph.names[i]}};
    add_attributes(node, graph.at_nodes, i);
    json["nodes"].push_back(std::move(node));
  }
  std::map<std::array<int, 2>, int> met;
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const auto [from, to] = graph.edges[i];
    ordered_json link{{"source", graph.names[static_cast<std::size_t>(from)]},
                      {"target", graph.names[static_cast<std::size_t>(to)]},
                      {"key", met[graph.edges[i]]++}};
    add_attributes(link, graph.at_edges, i);
    json["links"].push_back(std::move(link));
  }
  json["edges"] = json["links"];
  return json;
}

std::string to_dot(AttributedGraph graph) {
  const BoostGraph structure = boost_graph(graph);
  boost::dynamic_properties properties = attributes(graph, structure);
  properties.property("node_id", make_iterator_property_map(graph.names.begin(), get(boost::vertex_index, structure)));
  const ClassicLocale classic;
  std::ostringstream out;
  boost::write_graphviz_dp(out, structure, properties);
  return out.str();
}

std::string to_graphml(AttributedGraph graph) {
  const BoostGraph structure = boost_graph(graph);
  const ClassicLocale classic;
  std::ostringstream out;
  boost::write_graphml(out, structure, attributes(graph, structure), true);
  return out.str();
}

}  // namespace requad::enumerate
