// Graphs, tables and signatures as other programs read them: networkx, Graphviz, and our own commands once more.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"

using namespace requad::tests;

namespace {

nlohmann::json printed_json(const std::string& command) {
  const Outcome outcome = shell(command);
  INFO(command << "\n" << outcome.err);
  REQUIRE(outcome.code == 0);
  return nlohmann::json::parse(outcome.out);
}

}  // namespace

TEST_CASE("networkx reads the graphs, with the types of their attributes", "[programs][graphs]") {
  if (shell("python3 -c 'import networkx'").code != 0) {
    if (std::getenv("REQUAD_REQUIRE_NETWORKX") != nullptr) FAIL("python3-networkx is missing");
    WARN("skipped: python3-networkx is missing");
    return;
  }
  // A digon of side 7: loops and parallel edges at (1,0) and (2,0), and the apex.
  const std::string graph = "requad-enumerate graph --sides 7,7 --pair 3-3 --with-apex ";
  REQUIRE(shell(graph + "-o g.graphml && " + graph + "--format node_link -o n.json && " + graph + "-o own.json").code ==
          0);
  REQUIRE(shell("requad-figures --figure 10 --side 7 --format graphml -o .").code == 0);
  spill(scratch() / "read.py", R"(
import json, networkx as nx
own = json.load(open('own.json'))
for g in (nx.read_graphml('g.graphml', force_multigraph=True),
          nx.node_link_graph(json.load(open('n.json')))):
    assert g.is_multigraph() and not g.is_directed()
    assert g.number_of_nodes() == len(own['nodes']) and g.number_of_edges() == len(own['edges'])
    assert nx.number_connected_components(g) == own['components']
    nodes = [g.nodes['n%d' % i] for i in range(len(g))]
    for mine, other in zip(own['nodes'], nodes):
        assert all(other[k] == mine[k] for k in ('d1', 'd2', 'p', 'faces', 'label', 'signature'))
        assert all(type(other[k]) is int for k in ('d1', 'd2', 'p', 'faces'))
        assert type(other['x']) is float and type(other['label']) is str
    steps = sorted((min(a, b), max(a, b), d['step']) for a, b, d in g.edges(data=True))
    assert steps == sorted((min(a, b), max(a, b), s)
                           for (a, b), s in zip((('n%d' % i, 'n%d' % j) for i, j in own['edges']), own['steps']))
for side, nodes in ((7, 9 + 3), (6, 6 + 1 + 2)):  # tau; copies of (x,0), and the apex of an even side
    g = nx.read_graphml('figure-10-side-%d.graphml' % side, force_multigraph=True)
    assert g.number_of_nodes() == nodes, (side, g.number_of_nodes())
    assert all(type(d['faces']) is int and type(d['x']) is float for _, d in g.nodes(data=True))
    assert all(type(d['operations']) is int and type(d['step']) is str for _, _, d in g.edges(data=True))
print('read')
)");
  const Outcome outcome = shell("python3 read.py");
  INFO(outcome.err);
  CHECK(outcome.out == "read\n");
}

TEST_CASE("DOT has the places of the nodes, and Graphviz keeps them", "[programs][graphs]") {
  REQUIRE(shell("requad-enumerate graph --sides 5,4,4,7 --pair 3-5 -o g.dot").code == 0);
  const std::string plain = shell("neato -n2 -Tplain g.dot").out;
  std::set<std::string> places;
  std::vector<std::array<double, 4>> ellipses;
  for (std::size_t at = 0; (at = plain.find("\nnode ", at)) != std::string::npos; ++at) {
    std::string name, x, y;
    std::istringstream(plain.substr(at + 6)) >> name >> x >> y;
    places.insert(x + " " + y);
    std::array<double, 4>& ellipse = ellipses.emplace_back();  // the middle, the width and the height
    std::istringstream numbers(plain.substr(at + 6));
    numbers >> name >> ellipse[0] >> ellipse[1] >> ellipse[2] >> ellipse[3];
  }
  // An edge between two nodes of a row can be seen.
  for (const auto& a : ellipses) {
    for (const auto& b : ellipses) {
      if (&a != &b && a[1] == b[1]) CHECK(std::abs(a[0] - b[0]) > 1.2 * a[2]);
    }
  }
  CHECK(places.size() == 6);  // 3 x 2, each at a place of its own
  const std::string dot = slurp(scratch() / "g.dot");
  CHECK(dot.find("pos=\"124.000,124.000!\"") != std::string::npos);
  CHECK(dot.find("step=") != std::string::npos);
}

TEST_CASE("configurations as CSV, text and JSON, also of 3-6 and 5-6 pairs", "[programs][graphs]") {
  const auto lines = [](const std::string& file) {
    std::vector<std::string> all;
    std::istringstream in(slurp(scratch() / file));
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
  };
  // The law against the moves.
  REQUIRE(shell("requad-enumerate graph --sides 5,5,5,5,5,5 --pair 5-5 -o found.csv && "
                "requad-enumerate configurations --sides 5,5,5,5,5,5 --pair 5-5 -o law.csv")
              .code == 0);
  std::vector<std::string> found = lines("found.csv"), law = lines("law.csv");
  CHECK(found.size() == 1 + 12);
  CHECK(found[0] == "d1,d2,p,m,n,e1,e2,e3,e4,e5,e6,faces,signature");
  std::sort(found.begin(), found.end());
  std::sort(law.begin(), law.end());
  CHECK(found == law);
  // The law against the search, which knows no law.
  for (const auto& [sides, pair] : std::vector<std::pair<std::string, std::string>>{
           {"2,4,3,3,4", "3-6"}, {"4,4,4,3,3", "6-3"}, {"4,3,4,3,3,3,4", "5-6"}}) {
    const std::string valences = pair.substr(0, 1) + "," + pair.substr(2);
    const auto listed = printed_json("requad-enumerate configurations --json - --sides " + sides + " --pair " + pair);
    const auto searched =
        printed_json("requad-enumerate search --list --json - --sides " + sides + " --irregular " + valences);
    CHECK(listed["count"] == searched["count"]);
    CHECK(listed["count"] > 0);
    std::set<std::string> one, other;
    for (const auto& c : listed["configurations"]) one.insert(c["signature"]);
    for (const auto& signature : searched["fillings"]) other.insert(signature);
    CHECK(one == other);
  }
  CHECK(shell("requad-enumerate configurations --sides 5,4,4,7 --pair 3-5").out.starts_with("count 6\nd1  d2  p  "));
  const Outcome graph = shell("requad-enumerate graph --sides 4,4,4,3,3 --pair 3-6");
  CHECK(graph.code == 2);
  CHECK(graph.err.find("`requad-enumerate configurations`") != std::string::npos);
  CHECK(printed_json("requad-enumerate region 3-6 1 1 2,1,2,1,1 --json -")["pair"] == "3-6");
  const auto tau = printed_json("requad-enumerate tau --side 3..9 --json -")["tau"];
  CHECK(tau.size() == 7);
  CHECK(tau[6] == nlohmann::json{{"side", 9}, {"3-3", 16}, {"5-5", 48}});  // Theorems 7.2 and 7.3
}

TEST_CASE("every signature that is printed makes its mesh again", "[programs][graphs]") {
  // Closed, a disk, an annulus, and a torus.
  spill(scratch() / "annulus.obj",
        "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\n"
        "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  std::string torus;
  for (int i = 0; i < 16; ++i) torus += "v " + std::to_string(i) + " 0 0\n";
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      const auto at = [](int i, int j) { return std::to_string(4 * (j % 4) + i % 4 + 1); };
      torus += "f " + at(x, y) + " " + at(x + 1, y) + " " + at(x + 1, y + 1) + " " + at(x, y + 1) + "\n";
    }
  }
  spill(scratch() / "torus.obj", torus);
  REQUIRE(shell("requad-enumerate region hexagon 1 2 1,1,2,1,1,1 -o disk.obj").code == 0);
  REQUIRE(shell("cp '" REQUAD_SOURCE_DIR "/mesh/examples/figure-17.obj' sphere.obj").code == 0);
  std::vector<std::string> signatures;
  for (const std::string name : {"annulus", "torus", "disk", "sphere"}) {
    const auto said = printed_json("requad-enumerate signature --json - " + name + ".obj");
    for (const char* key : {"canonical", "oriented"}) signatures.push_back(said[key]);
  }
  const auto graph = printed_json("requad-enumerate graph --sides 5,4,4,7 --pair 3-5");
  for (const auto& node : graph["nodes"]) signatures.push_back(node["signature"]);
  const auto found = printed_json("requad-enumerate search --sides 4,4,4 --irregular 3,3,5 --list --json -");
  for (const auto& filling : found["fillings"]) signatures.push_back(filling);
  CHECK(signatures.size() > 15);
  for (const std::string& signature : signatures) {
    INFO(signature);
    const auto made =
        printed_json("requad-enumerate signature --from-signature '" + signature + "' -o made.obj --json -");
    const auto again = printed_json("requad-enumerate signature made.obj --json -");
    CHECK(again["canonical"] == made["canonical"]);
    CHECK(again["faces"] == made["faces"]);
  }
}

TEST_CASE("lists of plantri are read, also from a pipe", "[programs][graphs]") {
  // The cube: a, b, c, d round one side, e, f, g, h over them.
  REQUIRE(shell("requad-enumerate sphere --irregular 3,3,3,3,3,3,3,3 --vertices 8 --list | tail -n 1 >cube").code == 0);
  const std::string cube = slurp(scratch() / "cube");
  spill(scratch() / "cube.txt", "8 bde,afc,bgd,cha,ahf,gbe,hcf,edg\n8 bde,afc,bgd,cha,ahf,gbe,hcf,edg\n");
  CHECK(shell("requad-enumerate signature - --plantri <cube.txt").out == cube + cube);
  std::string binary = ">>planar_code<<";
  for (const bool wide : {false, true}) {
    std::string graph = wide ? std::string("\0\x08\0", 3) : "\x08";
    for (const std::string around : {"bde", "afc", "bgd", "cha", "ahf", "gbe", "hcf", "edg"}) {
      for (const char c : around)
        graph += std::string(1, static_cast<char>(c - 'a' + 1)) + (wide ? std::string(1, '\0') : "");
      graph += std::string(wide ? 2 : 1, '\0');
    }
    binary += graph;
  }
  spill(scratch() / "cube.bin", binary);
  CHECK(shell("requad-enumerate signature cube.bin --plantri").out == cube + cube);
  CHECK(printed_json("requad-enumerate signature --plantri --json - cube.bin")["count"] == 2);
  for (const auto& [text, why] : std::vector<std::pair<std::string, std::string>>{
           {"4 bcd,adc,abd,acb\n", "graph 1: a face has 3 sides"},
           {"8 bde,afc,bgd,cha,ahf,gbe,hcf\n", "7 lists of neighbours; expected 8"},
           {"2 b,z\n", "vertex 26 does not exist"},
           {"cube\n", "expected a number and a blank"},
           {binary.substr(0, 30), "the text ends too early"}}) {
    spill(scratch() / "bad", text);
    const Outcome outcome = shell("requad-enumerate signature bad --plantri");
    CHECK(outcome.code == 2);
    CHECK(line_count(outcome.err) == 1);
    CHECK(outcome.err.find(why) != std::string::npos);
  }
}
