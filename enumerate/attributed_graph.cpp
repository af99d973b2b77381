#include "enumerate/attributed_graph.hpp"

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

}  // namespace

std::string to_dot(AttributedGraph graph) {
  const BoostGraph structure = boost_graph(graph);
  boost::dynamic_properties properties = attributes(graph, structure);
  properties.property("node_id", make_iterator_property_map(graph.names.begin(), get(boost::vertex_index, structure)));
  std::ostringstream out;
  boost::write_graphviz_dp(out, structure, properties);
  return out.str();
}

std::string to_graphml(AttributedGraph graph) {
  const BoostGraph structure = boost_graph(graph);
  std::ostringstream out;
  boost::write_graphml(out, structure, attributes(graph, structure), true);
  return out.str();
}

}  // namespace requad::enumerate
