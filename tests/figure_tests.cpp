// Figures: the DOT is read back through libcgraph and compared with the predicted graph; copies folded.
#include <graphviz/cgraph.h>

#include "figures/graphviz.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"
#include "theory/configuration_graph.hpp"

using namespace requad;
using namespace requad::figures;

namespace {

struct ReadBack {
  std::map<std::string, int> nodes;                            // label -> how many
  std::map<std::pair<std::string, std::string>, int> edges;    // by labels of the originals, sorted
};

ReadBack read_back(const std::string& dot, const std::string& prefix) {
  Agraph_t* g = agmemread(dot.c_str());
  REQUIRE(g != nullptr);
  ReadBack result;
  const auto original = [g](Agnode_t* n) {
    const char* same = agget(n, const_cast<char*>("same_as"));
    return same != nullptr && *same != '\0' ? agnode(g, const_cast<char*>(same), 0) : n;
  };
  const auto label = [](Agnode_t* n) { return std::string(agget(n, const_cast<char*>("label"))); };
  const auto mine = [&](Agnode_t* n) { return std::string(agnameof(n)).rfind(prefix, 0) == 0; };
  for (Agnode_t* n = agfstnode(g); n != nullptr; n = agnxtnode(g, n)) {
    if (mine(n) && original(n) == n) ++result.nodes[label(n)];
    for (Agedge_t* e = agfstout(g, n); e != nullptr; e = agnxtout(g, e)) {
      if (!mine(n)) continue;
      std::string a = label(original(agtail(e))), b = label(original(aghead(e)));
      if (b < a) std::swap(a, b);
      ++result.edges[{a, b}];
    }
  }
  agclose(g);
  return result;
}

ReadBack predicted(theory::PairType type, const theory::IntegerVector& sides, theory::Apex apex) {
  ReadBack result;
  const auto graph = theory::configuration_graph(theory::configuration_map(type, sides, apex));
  for (const auto v : boost::make_iterator_range(vertices(graph))) ++result.nodes[theory::label(type, graph[v].configuration)];
  for (const auto e : boost::make_iterator_range(edges(graph))) {
    std::string a = theory::label(type, graph[source(e, graph)].configuration), b = theory::label(type, graph[target(e, graph)].configuration);
    if (b < a) std::swap(a, b);
    ++result.edges[{a, b}];
  }
  return result;
}

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("the DOT of each figure is the predicted graph", "[figures]") {
  for (int length = 4; length <= 9; ++length) {
    const std::string ten = to_dot(figure_10(length));
    const std::string eleven = to_dot(figure_11(length));
    for (int l = length - 1; l <= length; ++l) {
      const std::string prefix = "L" + std::to_string(l) + "_";
      const ReadBack digon = read_back(ten, prefix);
      const ReadBack digon_expected = predicted(theory::kDigon, theory::IntegerVector::Constant(2, l), theory::Apex::with);
      CHECK(digon.nodes == digon_expected.nodes);
      CHECK(digon.edges == digon_expected.edges);
      const ReadBack hexagon = read_back(eleven, prefix);
      const ReadBack hexagon_expected = predicted(theory::kHexagon, theory::IntegerVector::Constant(6, l), theory::Apex::with);
      CHECK(hexagon.nodes == hexagon_expected.nodes);
      CHECK(hexagon.edges == hexagon_expected.edges);
    }
  }
  const ReadBack twelve = read_back(to_dot(figure_12(2, 1, 4, 3)), "n");
  CHECK(twelve.nodes.size() == 12);
  CHECK(twelve.edges.size() == 17);  // a 4 x 3 grid
}

TEST_CASE("figures are places on the paper's grids, and byte-identical", "[figures]") {
  const GridFigure ten = figure_10(8);
  for (const GridNode& node : ten.nodes) {
    // (m,n) of the label at (m - n, m + n).
    int m = 0, n = 0;
    REQUIRE(std::sscanf(node.label.c_str(), "(%d,%d)", &m, &n) == 2);
    CHECK(node.at[0] == m - n);
    CHECK(node.at[1] == m + n);
    CHECK((node.same_as >= 0) == (m == 0 && n > 0));
  }
  for (const GridNode& node : figure_12(1, 0, 3, 2).nodes) {
    int m = 0, n = 0;
    REQUIRE(std::sscanf(node.label.c_str(), "(%d,%d)", &m, &n) == 2);
    CHECK(node.at[0] == m);
    CHECK(node.at[1] == n);
  }
  CHECK(to_dot(figure_11(5)) == to_dot(figure_11(5)));
  CHECK_THROWS_AS(figure_10(2), std::invalid_argument);
  CHECK_THROWS_AS(figure_12(0, 0, 2, 2), std::invalid_argument);
}

TEST_CASE("pictures hold every node and edge", "[figures]") {
  const GridFigure figure = figure_11(6);
  const std::string svg = render(figure, "svg");
  CHECK(occurrences(svg, "class=\"node\"") == figure.nodes.size());
  CHECK(occurrences(svg, "class=\"edge\"") == figure.edges.size());
  CHECK(svg.find("</svg>") != std::string::npos);
}
