// Figures. Tests read the DOT through libcgraph, merge copies with their originals, and compare the graph with the
// predicted one. They read the SVG through libxml2, and count what it holds.
#include <array>
#include <cstdlib>
#include <functional>
#include <memory>

#include <graphviz/cgraph.h>
#include <libxml/parser.h>
#include <libxml/tree.h>

#include "figures/graph_files.hpp"
#include "figures/pictures/catalogue.hpp"
#include "figures/pictures/grid_picture.hpp"
#include "mesh/pictures/page.hpp"
#include "mesh/topology/signature.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"
#include "theory/configuration_graph.hpp"

using namespace requad;
using namespace requad::figures;

namespace {

struct ReadBack {
  std::map<std::string, int> nodes;                          // the number of nodes with a label
  std::map<std::pair<std::string, std::string>, int> edges;  // by the sorted labels of the originals
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
  const auto graph = theory::configuration_graph(theory::configuration_map({type, sides}, apex));
  for (const auto v : boost::make_iterator_range(vertices(graph)))
    ++result.nodes[theory::label(type, graph[v].configuration)];
  for (const auto e : boost::make_iterator_range(edges(graph))) {
    std::string a = theory::label(type, graph[source(e, graph)].configuration),
                b = theory::label(type, graph[target(e, graph)].configuration);
    if (b < a) std::swap(a, b);
    ++result.edges[{a, b}];
  }
  return result;
}

using Document = std::unique_ptr<xmlDoc, void (*)(xmlDoc*)>;
Document parsed(const std::string& xml) {
  return {
      xmlReadMemory(xml.data(), static_cast<int>(xml.size()), nullptr, nullptr, XML_PARSE_NOERROR | XML_PARSE_NONET),
      xmlFreeDoc};
}
std::string attribute(const xmlNode* node, const char* name) {
  xmlChar* value = xmlGetProp(node, reinterpret_cast<const xmlChar*>(name));
  std::string text = value == nullptr ? "" : reinterpret_cast<const char*>(value);
  xmlFree(value);
  return text;
}
void for_each_element(const xmlNode* node, const std::string& name, const std::function<void(const xmlNode*)>& visit) {
  for (; node != nullptr; node = node->next) {
    if (node->type == XML_ELEMENT_NODE && name == reinterpret_cast<const char*>(node->name)) visit(node);
    for_each_element(node->children, name, visit);
  }
}

const Palette kColours;
const Page kWithoutCaptions{.style = {.captions = false}};  // legends show marks too

// The closed pieces of the paths in an SVG, by the first words of their style.
class Paths {
 public:
  explicit Paths(const std::string& svg) {
    const Document document = parsed(svg);
    REQUIRE(document != nullptr);
    REQUIRE(std::string(reinterpret_cast<const char*>(xmlDocGetRootElement(document.get())->name)) == "svg");
    for_each_element(xmlDocGetRootElement(document.get()), "path", [this](const xmlNode* node) {
      const std::string d = attribute(node, "d");
      REQUIRE(d.find("nan") == std::string::npos);
      paths_.push_back({attribute(node, "style"), static_cast<std::size_t>(std::count(d.begin(), d.end(), 'Z')),
                        static_cast<std::size_t>(std::count(d.begin(), d.end(), 'M'))});
    });
  }
  // The number of filled polygons of a colour, in paths of at least `least` polygons.
  std::size_t filled(Colour colour) const {
    return count("fill:rgb(" + percent(colour.red) + "%," + percent(colour.green) + "%," + percent(colour.blue) + "%)",
                 &Path::polygons);
  }
  std::size_t outlines(const std::string& width) const { return count("stroke-width:" + width + ";", &Path::polygons); }
  std::size_t all() const { return paths_.size(); }

 private:
  struct Path {
    std::string style;
    std::size_t polygons;
    std::size_t pieces;
  };
  static std::string percent(double x) {
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%f", 100 * x);
    std::string text = buffer.data();
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
  }
  std::size_t count(const std::string& words, std::size_t Path::*what) const {
    std::size_t sum = 0;
    for (const Path& path : paths_) {
      if (path.style.find(words) != std::string::npos) sum += path.*what;
    }
    return sum;
  }
  std::vector<Path> paths_;
};

}  // namespace

TEST_CASE("the DOT of each figure is the predicted graph", "[figures]") {
  for (int length = 4; length <= 9; ++length) {
    const std::string ten = to_dot(figure_10(length));
    const std::string eleven = to_dot(figure_11(length));
    for (int l = length - 1; l <= length; ++l) {
      const std::string prefix = "L" + std::to_string(l) + "_";
      const ReadBack digon = read_back(ten, prefix);
      const ReadBack digon_expected =
          predicted(theory::kDigon, theory::IntegerVector::Constant(2, l), theory::Apex::with);
      CHECK(digon.nodes == digon_expected.nodes);
      CHECK(digon.edges == digon_expected.edges);
      const ReadBack hexagon = read_back(eleven, prefix);
      const ReadBack hexagon_expected =
          predicted(theory::kHexagon, theory::IntegerVector::Constant(6, l), theory::Apex::with);
      CHECK(hexagon.nodes == hexagon_expected.nodes);
      CHECK(hexagon.edges == hexagon_expected.edges);
    }
  }
  const ReadBack twelve = read_back(to_dot(figure_12(2, 1, 4, 3)), "n");
  CHECK(twelve.nodes.size() == 12);
  CHECK(twelve.edges.size() == 17);  // a 4 x 3 grid
}

TEST_CASE("nodes lie on the paper's grids, and figures are byte-identical", "[figures]") {
  const GridFigure ten = figure_10(8);
  for (const GridNode& node : ten.nodes) {
    // The label (m,n) lies at (m - n, m + n).
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

TEST_CASE("dual figures are the predicted graphs, with self-loops and double edges", "[figures]") {
  for (const theory::PairType type : {theory::kDigon, theory::kHexagon}) {
    const std::string dot = to_dot(dual_figure(type, 7));
    for (int l = 6; l <= 7; ++l) {
      const ReadBack found = read_back(dot, "L" + std::to_string(l) + "_");
      const ReadBack expected =
          predicted(type, theory::IntegerVector::Constant(type.side_count(), l), theory::Apex::with);
      CHECK(found.nodes == expected.nodes);
      CHECK(found.edges == expected.edges);
    }
  }
  // The other figures of hexagons: non-regular ones, and the half cube cut open.
  const std::vector<theory::Integer> sides{4, 5, 4, 4, 5, 4};
  const ReadBack hexagon = read_back(to_dot(hexagon_figure(sides)), "n");
  const ReadBack expected = predicted(theory::kHexagon, theory::to_vector(sides), theory::Apex::with);
  CHECK(hexagon.nodes == expected.nodes);
  CHECK(hexagon.edges == expected.edges);
  const ReadBack unfolded = read_back(to_dot(unfolded_figure(6)), "L6_");
  CHECK(unfolded.nodes == predicted(theory::kHexagon, theory::IntegerVector::Constant(6, 6), theory::Apex::with).nodes);
  CHECK(unfolded.edges == predicted(theory::kHexagon, theory::IntegerVector::Constant(6, 6), theory::Apex::with).edges);
}

TEST_CASE("the attributes of a grid's DOT and GraphML", "[figures]") {
  const GridFigure figure = figure_11(6);
  const std::string dot = to_dot(figure);
  Agraph_t* g = agmemread(dot.c_str());
  REQUIRE(g != nullptr);
  const auto number = [](void* object, const char* name) {
    const char* text = agget(object, const_cast<char*>(name));
    REQUIRE(text != nullptr);
    return std::stoi(text);
  };
  int edges = 0;
  for (Agnode_t* n = agfstnode(g); n != nullptr; n = agnxtnode(g, n)) {
    // The signature is that of the mesh: the mesh that is made from it has as many faces as the node says.
    CHECK(mesh::from_signature(agget(n, const_cast<char*>("signature"))).mesh.face_count() == number(n, "faces"));
    for (Agedge_t* e = agfstout(g, n); e != nullptr; e = agnxtout(g, e)) {
      ++edges;
      const int made = number(aghead(e), "faces") - number(agtail(e), "faces");
      CHECK(number(e, "faces") == made);
      CHECK(number(e, "splits") - number(e, "collapses") == made);
      CHECK(number(e, "operations") == number(e, "splits") + number(e, "collapses") + number(e, "flips"));
      // (d1,d2) changes by (+-1,+-1). If the quadrant stays, this is the difference of the labels (Theorem 7.3).
      int dm = 0, dn = 0;
      REQUIRE(std::sscanf(agget(e, const_cast<char*>("direction")), "(%d,%d)", &dm, &dn) == 2);
      CHECK(std::abs(dm) == 1);
      CHECK(std::abs(dn) == 1);
      CHECK(number(aghead(e), "d1") + number(aghead(e), "d2") - number(agtail(e), "d1") - number(agtail(e), "d2") ==
            dm + dn);
    }
  }
  CHECK(edges == static_cast<int>(figure.edges.size()));
  agclose(g);

  const Document graphml = parsed(to_graphml(figure));
  REQUIRE(graphml != nullptr);
  std::size_t nodes = 0, links = 0;
  for_each_element(xmlDocGetRootElement(graphml.get()), "node", [&](const xmlNode*) { ++nodes; });
  for_each_element(xmlDocGetRootElement(graphml.get()), "edge", [&](const xmlNode*) { ++links; });
  CHECK(nodes == figure.nodes.size());
  CHECK(links == figure.edges.size());
}

TEST_CASE("Graphviz reads the DOT", "[figures]") {
  for (const CatalogueEntry& entry : catalogue()) {
    if (!entry.is_grid) continue;
    const std::filesystem::path file = tests::scratch() / (entry.file() + ".dot");
    tests::spill(file, to_dot(*entry.make({}).grid));
    CHECK(std::system(("dot -Tcanon " + file.string() + " > " + file.string() + ".canon").c_str()) == 0);
    CHECK(std::system(("neato -n2 -Tplain " + file.string() + " > " + file.string() + ".plain").c_str()) == 0);
  }
}

TEST_CASE("pictures of grids show every mesh, irregular vertex and R_alpha", "[figures]") {
  for (int length = 3; length <= 12; ++length) {
    for (const bool hexagon : {false, true}) {
      if (hexagon && length > 7) continue;
      const GridFigure figure = hexagon ? figure_11(length) : figure_10(length);
      const Paths paths(render(paint_grid(figure), "svg", kWithoutCaptions));
      // By the theorems, all (m,n) with m + n = 1 or 2, 3, ..., L - 2 are drawn. In the digon (0,n) is a copy.
      std::size_t pairs = 0, copies = 0, merged = 0, quads = 0;
      for (int l = std::max(3, length - 1); l <= length; ++l) {
        merged += l % 2 == 0 ? 1 : 0;
        for (int m = 0; m <= l - 2; ++m) {
          for (int n = 0; m + n <= l - 2; ++n) {
            if ((m + n - l) % 2 != 0 || m + n == 0 || (hexagon && m == 0)) continue;
            pairs += hexagon ? 3 : 1;
            copies += !hexagon && m == 0 ? 1 : 0;
            quads += static_cast<std::size_t>((hexagon ? 3 : 1) * m * n);
          }
        }
      }
      CHECK(figure.nodes.size() == pairs + merged);
      CHECK(paths.outlines("0.9") == pairs + merged);
      CHECK(paths.filled(hexagon ? kColours.v5 : kColours.v3) == 2 * (pairs - copies));  // copies are faint
      CHECK(paths.filled(hexagon ? kColours.v6 : kColours.v2) == merged);
      CHECK(paths.filled(kColours.pair) == quads);
    }
  }
  const Paths twelve(render(paint_grid(figure_12(2, 1, 4, 3)), "svg", kWithoutCaptions));
  CHECK(twelve.outlines("0.9") == 12);
  CHECK(twelve.filled(kColours.pair) == 12 * 2);
  CHECK(twelve.filled(kColours.v5) == 12);
  CHECK(twelve.filled(kColours.first_star) == 12);
}

TEST_CASE("pictures of operations show what the operations do", "[figures]") {
  const auto paths = [](const std::string& id) {
    for (const CatalogueEntry& entry : catalogue()) {
      if (entry.id == id) return Paths(render(entry.make({}).paint, "svg"));
    }
    throw std::logic_error("no figure " + id);
  };
  struct Expected {
    const char* id;
    std::size_t meshes, v3, v5, made, deleted;
  };
  // The numbers follow from sections 4 to 6. A collapse makes two v3s and a v6; a split or a flip makes two v3s and two
  // v5s. An adjacent pair has six steps. A v3 and a v5 have four moves each in the figure, each drawn
  // before and after. Each of two types changes once. A 3-3 pair is shown in three configurations.
  for (const Expected& e : {Expected{"2", 10, 2 + 5 * 2, 5 * 2, 2, 2}, Expected{"3", 7, 7, 7, 2, 2},
                            Expected{"4", 16, 4 + 4 * 2 + 4, 4 + 4 + 4 * 2, 2, 2}, Expected{"5", 4, 2, 2, 1, 1},
                            Expected{"8", 3, 6, 0, 1, 5}}) {
    INFO("figure " << e.id);
    const Paths p = paths(e.id);
    CHECK(p.outlines("1") == e.meshes);
    CHECK(p.filled(kColours.v3) == e.v3);
    CHECK(p.filled(kColours.v5) == e.v5);
    CHECK(p.filled(kColours.made) == e.made);
    CHECK(p.filled(kColours.deleted) == e.deleted);
  }
  // Law irregular-11: each move of a 3 x 0 pair makes or deletes 3 quads. The moves of a 2 x 1 pair change 1, 1, 3, 3.
  const Paths six = paths("6");
  CHECK(six.outlines("1") == 16);
  CHECK(six.filled(kColours.made) == 3 + 3 + 1 + 3);
  CHECK(six.filled(kColours.deleted) == 3 + 3 + 1 + 3);
  CHECK(paths("7").outlines("1") == 4);
  CHECK(paths("13").outlines("1") == 2 + 9);
  CHECK(paths("14").outlines("1") == 3);
  CHECK(paths("octagon").outlines("1") == 9);  // (L-1)^2
  CHECK(paths("octagon").filled(kColours.v6) == 9);
}

TEST_CASE("every figure has the same bytes each time, in every format", "[figures]") {
  for (const CatalogueEntry& entry : catalogue()) {
    INFO(entry.id);
    const std::string svg = render(entry.make({}).paint, "svg");
    CHECK(Paths(svg).all() > 10);
    CHECK((svg == render(entry.make({}).paint, "svg")));
    const std::string pdf = render(entry.make({}).paint, "pdf");
    CHECK(pdf.rfind("%PDF-", 0) == 0);
    CHECK((pdf == render(entry.make({}).paint, "pdf")));
    if (entry.is_grid) CHECK(to_graphml(*entry.make({}).grid) == to_graphml(*entry.make({}).grid));
  }
  CHECK(render(catalogue().front().make({}).paint, "tikz") == render(catalogue().front().make({}).paint, "tikz"));
  const std::string png = render(catalogue().front().make({}).paint, "png");
  CHECK(png.rfind("\x89PNG", 0) == 0);
  CHECK((png == render(catalogue().front().make({}).paint, "png")));
  CHECK_THROWS_AS(render(catalogue().front().make({}).paint, "bmp"), std::invalid_argument);
}

TEST_CASE("the gallery's page is up to date, and its pictures exist", "[figures]") {
  const std::filesystem::path folder = std::filesystem::path(REQUAD_SOURCE_DIR) / "figures" / "gallery";
  CHECK(tests::slurp(folder / "README.md") == gallery_page(true));
  for (const char* screenshot : {"explorer.png", "editor.png"}) CHECK(std::filesystem::exists(folder / screenshot));
  for (const CatalogueEntry& entry : catalogue())
    CHECK(Paths(tests::slurp(folder / (entry.file() + ".svg"))).all() > 10);
}
