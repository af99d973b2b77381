#include "figures/graph_files.hpp"

#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <stdexcept>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graphml.hpp>
#include <graphviz/cgraph.h>

#include "mesh/pictures/mesh_picture.hpp"
#include "theory/joined.hpp"

namespace requad::figures {

namespace {

constexpr double kUnit = 62;  // points between neighbours of the grid

struct GraphCloser {
  void operator()(Agraph_t* graph) const { agclose(graph); }
};
using GraphPointer = std::unique_ptr<Agraph_t, GraphCloser>;

// cgraph takes char* for strings that it only reads.
char* text(const std::string& s) { return const_cast<char*>(s.c_str()); }

void set(void* object, const char* name, const std::string& value) {
  agsafeset(object, const_cast<char*>(name), text(value), const_cast<char*>(""));
}

std::string decimals(double x) {
  std::array<char, 32> buffer;
  return {buffer.data(),
          std::to_chars(buffer.data(), buffer.data() + buffer.size(), x + 0.0, std::chars_format::fixed, 2).ptr};
}

// What a reader of the graph wants to know, as names and values.
using Attributes = std::vector<std::pair<const char*, std::string>>;

Attributes attributes(const GridFigure& figure, const GridNode& node) {
  const Grid& grid = figure.grids[static_cast<std::size_t>(node.grid)];
  const theory::GridPoint at = theory::grid_point(
      grid.type, grid.type.symmetric() ? node.configuration : theory::canonical(grid.type, node.configuration));
  return {{"label", node.label},
          {"d1", std::to_string(node.configuration.d1())},
          {"d2", std::to_string(node.configuration.d2())},
          {"p", std::to_string(node.configuration.p)},
          {"m", std::to_string(at.m)},
          {"n", std::to_string(at.n)},
          {"faces", std::to_string(node.faces())},
          {"sides", theory::joined(grid.sides, ",")},
          {"signature", node.signature},
          {"same_as", node.same_as < 0 ? "" : figure.nodes[static_cast<std::size_t>(node.same_as)].name}};
}

Attributes attributes(const GridEdge& edge) {
  return {{"step", edge.step},
          {"direction", edge.direction},
          {"operations", std::to_string(edge.operations())},
          {"splits", std::to_string(edge.splits)},
          {"collapses", std::to_string(edge.collapses)},
          {"flips", std::to_string(edge.flips)},
          {"faces", std::to_string(edge.faces())}};
}

}  // namespace

std::string to_dot(const GridFigure& figure) {
  const GraphPointer graph(agopen(const_cast<char*>("grid"), Agundirected, nullptr));
  Agraph_t* g = graph.get();
  set(g, "label", figure.title);
  set(g, "labelloc", "b");
  set(g, "fontname", "Helvetica");
  set(g, "outputorder", "edgesfirst");
  set(g, "pad", "0.2");
  const auto colour = [&figure](const GridNode& node) {
    return to_hex(figure.grids[static_cast<std::size_t>(node.grid)].colour());
  };
  std::vector<Agnode_t*> nodes;
  for (const GridNode& node : figure.nodes) {
    Agnode_t* n = agnode(g, text(node.name), 1);
    nodes.push_back(n);
    for (const auto& [name, value] : attributes(figure, node)) set(n, name, value);
    set(n, "pos", decimals(node.at[0] * kUnit) + "," + decimals(node.at[1] * kUnit) + "!");
    set(n, "shape", "ellipse");
    set(n, "fixedsize", "true");
    set(n, "width", "0.62");
    set(n, "height", "0.36");
    set(n, "fontname", "Helvetica");
    set(n, "fontsize", "11");
    set(n, "style", node.same_as >= 0 ? "filled,dashed" : "filled");
    set(n, "fillcolor", "white");
    set(n, "color", colour(node));
    set(n, "fontcolor", colour(node));
  }
  for (const GridEdge& edge : figure.edges) {
    Agedge_t* e =
        agedge(g, nodes[static_cast<std::size_t>(edge.from)], nodes[static_cast<std::size_t>(edge.to)], nullptr, 1);
    for (const auto& [name, value] : attributes(edge)) set(e, name, value);
    set(e, "color", colour(figure.nodes[static_cast<std::size_t>(edge.from)]));
  }
  char* data = nullptr;
  std::size_t size = 0;
  std::FILE* stream = open_memstream(&data, &size);
  if (stream == nullptr) throw std::runtime_error("no memory for the graph's text");
  agwrite(g, stream);
  std::fclose(stream);
  std::string result(data, size);
  std::free(data);
  return result;
}

std::string to_graphml(const GridFigure& figure) {
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                      boost::property<boost::edge_index_t, std::size_t>>;
  Graph graph(figure.nodes.size());
  for (std::size_t i = 0; i < figure.edges.size(); ++i) {
    add_edge(static_cast<std::size_t>(figure.edges[i].from), static_cast<std::size_t>(figure.edges[i].to), i, graph);
  }
  // A column of values for each attribute, looked up by index.
  std::map<std::string, std::vector<std::string>> node_columns, edge_columns;
  for (const GridNode& node : figure.nodes) {
    node_columns["name"].push_back(node.name);
    for (const auto& [name, value] : attributes(figure, node)) node_columns[name].push_back(value);
    node_columns["x"].push_back(decimals(node.at[0]));
    node_columns["y"].push_back(decimals(node.at[1]));
  }
  for (const GridEdge& edge : figure.edges) {
    for (const auto& [name, value] : attributes(edge)) edge_columns[name].push_back(value);
  }
  boost::dynamic_properties properties;
  for (auto& [name, column] : node_columns) {
    properties.property(name, make_iterator_property_map(column.begin(), get(boost::vertex_index, graph)));
  }
  for (auto& [name, column] : edge_columns) {
    properties.property(name, make_iterator_property_map(column.begin(), get(boost::edge_index, graph)));
  }
  std::ostringstream out;
  boost::write_graphml(out, graph, properties, true);
  return out.str();
}

}  // namespace requad::figures
