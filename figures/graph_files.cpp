#include "figures/graph_files.hpp"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include <graphviz/cgraph.h>

#include "enumerate/graphs/attributed_graph.hpp"
#include "mesh/text/fixed_decimals.hpp"
#include "theory/joined.hpp"

namespace requad::figures {

namespace {

using enumerate::AttributedGraph;

constexpr double kPointsPerUnit = 62;  // points between neighbours of the grid

// The values of an attribute, which a function gives for each node or edge.
template <class Element, class Value>
auto column(const std::vector<Element>& elements, const Value& value) {
  using Result = std::decay_t<decltype(value(elements[0]))>;
  using Kind = std::conditional_t<std::is_floating_point_v<Result>, double,
                                  std::conditional_t<std::is_integral_v<Result>, long, std::string>>;
  std::vector<Kind> values;
  for (const Element& element : elements) values.emplace_back(value(element));
  return values;
}

// The figure with the attributes that both formats have.
AttributedGraph attributed_graph(const GridFigure& figure) {
  const auto at_nodes = [&figure](auto value) { return column(figure.nodes, value); };
  const auto at_edges = [&figure](auto value) { return column(figure.edges, value); };
  const auto grid = [&figure](const GridNode& n) -> const Grid& {
    return figure.grids[static_cast<std::size_t>(n.grid)];
  };
  const auto grid_point = [&grid](const GridNode& n) {
    const theory::PairType type = grid(n).shape.type();
    return theory::grid_point(type, type.symmetric() ? n.configuration : theory::canonical(type, n.configuration));
  };
  const auto original = [&figure](const GridNode& n) {
    return n.same_as < 0 ? "" : figure.nodes[static_cast<std::size_t>(n.same_as)].name;
  };

  AttributedGraph graph;
  graph.names = at_nodes([](const GridNode& n) { return n.name; });
  graph.at_nodes = {
      {"label", at_nodes([](const GridNode& n) { return n.label; })},
      {"d1", at_nodes([](const GridNode& n) { return n.configuration.d1(); })},
      {"d2", at_nodes([](const GridNode& n) { return n.configuration.d2(); })},
      {"p", at_nodes([](const GridNode& n) { return n.configuration.p; })},
      {"m", at_nodes([&](const GridNode& n) { return grid_point(n).m; })},
      {"n", at_nodes([&](const GridNode& n) { return grid_point(n).n; })},
      {"faces", at_nodes([](const GridNode& n) { return n.faces(); })},
      {"sides", at_nodes([&](const GridNode& n) { return theory::joined(grid(n).shape.sides(), ","); })},
      {"signature", at_nodes([](const GridNode& n) { return n.signature; })},
      {"same_as", at_nodes(original)},
  };
  for (const GridEdge& edge : figure.edges) graph.edges.push_back({edge.from, edge.to});
  graph.at_edges = {
      {"step", at_edges([](const GridEdge& e) { return e.step; })},
      {"direction", at_edges([](const GridEdge& e) { return e.direction; })},
      {"operations", at_edges([](const GridEdge& e) { return e.operations(); })},
      {"splits", at_edges([](const GridEdge& e) { return e.splits; })},
      {"collapses", at_edges([](const GridEdge& e) { return e.collapses; })},
      {"flips", at_edges([](const GridEdge& e) { return e.flips; })},
      {"faces", at_edges([](const GridEdge& e) { return e.faces(); })},
  };
  return graph;
}

// Adds the positions of the nodes, and the attributes by which Graphviz draws them.
void add_drawing(AttributedGraph& graph, const GridFigure& figure) {
  const auto at_nodes = [&figure](auto value) { return column(figure.nodes, value); };
  const auto all_nodes = [&at_nodes](const char* value) {
    return at_nodes([value](const GridNode&) { return value; });
  };
  const auto grid = [&figure](const GridNode& n) -> const Grid& {
    return figure.grids[static_cast<std::size_t>(n.grid)];
  };
  const auto colour = [&](const GridNode& n) { return to_hex(grid(n).colour({})); };
  graph.at_nodes["pos"] = at_nodes([](const GridNode& n) {
    return mesh::fixed_decimals(n.at[0] * kPointsPerUnit, 2) + "," + mesh::fixed_decimals(n.at[1] * kPointsPerUnit, 2) +
           "!";
  });
  graph.at_nodes["shape"] = all_nodes("ellipse");
  graph.at_nodes["fixedsize"] = all_nodes("true");
  graph.at_nodes["width"] = all_nodes("0.62");
  graph.at_nodes["height"] = all_nodes("0.36");
  graph.at_nodes["fontname"] = all_nodes("Helvetica");
  graph.at_nodes["fontsize"] = all_nodes("11");
  graph.at_nodes["style"] = at_nodes([](const GridNode& n) { return n.same_as >= 0 ? "filled,dashed" : "filled"; });
  graph.at_nodes["fillcolor"] = all_nodes("white");
  graph.at_nodes["color"] = at_nodes(colour);
  graph.at_nodes["fontcolor"] = at_nodes(colour);
  const auto at_edges = [&](auto value) {
    return column(figure.edges,
                  [&](const GridEdge& e) { return value(figure.nodes[static_cast<std::size_t>(e.from)]); });
  };
  graph.at_edges["color"] = at_edges(colour);
  graph.at_edges["style"] =
      at_edges([&](const GridNode& n) { return grid(n).parity == Parity::odd ? "dashed" : "solid"; });
}

struct GraphCloser {
  void operator()(Agraph_t* graph) const { agclose(graph); }
};

// The DOT file that libcgraph writes, with these attributes of the graph. Each attribute is on a line of its own, and
// empty ones are left out.
// Throws std::logic_error if libcgraph cannot read it.
std::string laid_out(const std::string& dot, const std::vector<std::pair<const char*, std::string>>& attributes) {
  const std::unique_ptr<Agraph_t, GraphCloser> graph(agmemread(dot.c_str()));
  if (!graph) throw std::logic_error("Graphviz cannot read a figure's graph");
  for (const auto& [name, value] : attributes) {
    // cgraph takes char* for strings that it only reads.
    agsafeset(graph.get(), const_cast<char*>(name), const_cast<char*>(value.c_str()), const_cast<char*>(""));
  }
  char* data = nullptr;
  std::size_t size = 0;
  std::FILE* stream = open_memstream(&data, &size);
  if (stream == nullptr) throw std::runtime_error("no memory for the graph's text");
  agwrite(graph.get(), stream);
  std::fclose(stream);
  std::string result(data, size);
  std::free(data);
  return result;
}

}  // namespace

std::string to_dot(const GridFigure& figure) {
  AttributedGraph graph = attributed_graph(figure);
  add_drawing(graph, figure);
  std::string dot = enumerate::to_dot(std::move(graph));
  dot.replace(0, dot.find('{'), "graph grid ");  // Boost calls every graph G
  return laid_out(dot, {{"label", figure.title},
                        {"labelloc", "b"},
                        {"fontname", "Helvetica"},
                        {"outputorder", "edgesfirst"},
                        {"pad", "0.2"}});
}

GridFigure grid_alone(const GridFigure& figure, std::size_t grid) {
  GridFigure alone{figure.title, {figure.grids[grid]}, {}, {}};
  std::vector<int> index(figure.nodes.size(), -1);
  for (std::size_t i = 0; i < figure.nodes.size(); ++i) {
    if (figure.nodes[i].grid != static_cast<int>(grid)) continue;
    index[i] = static_cast<int>(alone.nodes.size());
    alone.nodes.push_back(figure.nodes[i]);
    alone.nodes.back().grid = 0;
  }
  const auto now = [&index](int node) { return index[static_cast<std::size_t>(node)]; };
  for (GridNode& node : alone.nodes) {
    if (node.same_as >= 0) node.same_as = now(node.same_as);
  }
  for (GridEdge edge : figure.edges) {
    if (now(edge.from) < 0) continue;
    edge.from = now(edge.from);
    edge.to = now(edge.to);
    alone.edges.push_back(edge);
  }
  return alone;
}

std::string to_graphml(const GridFigure& figure) {
  AttributedGraph graph = attributed_graph(figure);
  graph.at_nodes["name"] = graph.names;
  graph.at_nodes["x"] = column(figure.nodes, [](const GridNode& n) { return n.at[0]; });
  graph.at_nodes["y"] = column(figure.nodes, [](const GridNode& n) { return n.at[1]; });
  return enumerate::to_graphml(std::move(graph));
}

}  // namespace requad::figures
