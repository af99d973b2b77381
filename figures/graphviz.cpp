#include "figures/graphviz.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include <graphviz/cgraph.h>
#include <graphviz/gvc.h>

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

std::string points(double x) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.2f", x * kUnit + 0.0);
  return buffer.data();
}

GraphPointer build(const GridFigure& figure) {
  GraphPointer graph(agopen(const_cast<char*>("grid"), Agundirected, nullptr));
  Agraph_t* g = graph.get();
  set(g, "label", figure.title);
  set(g, "labelloc", "b");
  set(g, "fontname", "Helvetica");
  set(g, "outputorder", "edgesfirst");
  set(g, "pad", "0.2");
  std::vector<Agnode_t*> nodes;
  for (const GridNode& node : figure.nodes) {
    Agnode_t* n = agnode(g, text(node.name), 1);
    nodes.push_back(n);
    const bool copy = node.same_as >= 0;
    set(n, "label", node.label);
    set(n, "pos", points(node.at[0]) + "," + points(node.at[1]) + "!");
    set(n, "shape", "ellipse");
    set(n, "fixedsize", "true");
    set(n, "width", "0.62");
    set(n, "height", "0.36");
    set(n, "fontname", "Helvetica");
    set(n, "fontsize", "11");
    set(n, "style", copy ? "filled,dashed" : "filled");
    set(n, "fillcolor", "white");
    set(n, "color", node.colour);
    set(n, "fontcolor", node.colour);
    set(n, "d1", std::to_string(node.configuration.d1()));
    set(n, "d2", std::to_string(node.configuration.d2()));
    set(n, "p", std::to_string(node.configuration.p));
    set(n, "faces", std::to_string(node.faces));
    set(n, "signature", node.signature);
    if (copy) set(n, "same_as", figure.nodes[static_cast<std::size_t>(node.same_as)].name);
  }
  for (const GridEdge& edge : figure.edges) {
    Agedge_t* e = agedge(g, nodes[static_cast<std::size_t>(edge.from)], nodes[static_cast<std::size_t>(edge.to)], nullptr, 1);
    set(e, "color", edge.colour);
    set(e, "step", edge.step);
    set(e, "operations", std::to_string(edge.operations));
    set(e, "faces", std::to_string(edge.faces));
  }
  return graph;
}

}  // namespace

std::string to_dot(const GridFigure& figure) {
  const GraphPointer graph = build(figure);
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

std::string render(const GridFigure& figure, const std::string& format) {
  const GraphPointer graph = build(figure);
  // One context for the whole process: libgvc keeps pointers into the first one that outlive it.
  static const std::unique_ptr<GVC_t, int (*)(GVC_t*)> context(gvContext(), gvFreeContext);
  if (gvLayout(context.get(), graph.get(), "nop2") != 0) throw std::runtime_error("Graphviz can not lay out the figure");
  char* data = nullptr;
  unsigned int size = 0;
  const bool done = gvRenderData(context.get(), graph.get(), format.c_str(), &data, &size) == 0;
  std::string result(done ? std::string(data, size) : std::string());
  if (data != nullptr) gvFreeRenderData(data);
  gvFreeLayout(context.get(), graph.get());
  if (!done) throw std::runtime_error("Graphviz can not write " + format);
  return result;
}

}  // namespace requad::figures
