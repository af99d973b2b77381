// Generators, which are compared with each other; exploration, realisation and graph output.
#include <sstream>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/isomorphism.hpp>

#include "enumerate/generators.hpp"
#include "enumerate/graphs/graph_output.hpp"
#include "enumerate/realisation.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/enumerate/census.hpp"
#include "theory/counts.hpp"

using namespace requad;
using namespace requad::enumerate;
using requad::tests::sides;

TEST_CASE("enumerate-1: three generators make the same mesh", "[generators]") {
  for (const tests::CensusEntry& entry : tests::census(18, true)) {
    INFO(entry.shape.type().name() << " " << theory::label(entry.shape.type(), entry.configuration));
    REQUIRE(mesh::validate(entry.region.mesh).empty());
    REQUIRE(mesh::region_problem(entry.region).empty());
    const auto lengths = mesh::side_lengths(entry.region);
    REQUIRE(std::equal(lengths.begin(), lengths.end(), entry.shape.sides().begin(), entry.shape.sides().end()));
    REQUIRE(entry.region.mesh.face_count() ==
            theory::PairSystem(entry.shape.type()).face_count(entry.configuration.parameters));
    const std::string expected = mesh::signature(entry.region);
    REQUIRE(mesh::signature(grow_region(entry.shape.type(), entry.configuration)) == expected);
    const auto start = simplest_configuration(entry.shape);
    REQUIRE(mesh::signature(realise(entry.shape, start, entry.configuration).region) == expected);
    // The labels that are read off the mesh are those from which it was made.
    const Reading reading = read(entry.region, entry.shape.type());
    REQUIRE(reading.problem.empty());
    REQUIRE(reading.configuration == entry.configuration);
  }
}

TEST_CASE("both labellings of a segment generate the same mesh", "[generators]") {
  for (const tests::CensusEntry& entry : tests::census(18, false)) {
    if (!entry.configuration.degenerate()) continue;
    const auto other = theory::other_labelling(entry.shape.type(), entry.configuration);
    REQUIRE(mesh::signature(glue_region(entry.shape.type(), other)) == mesh::signature(entry.region));
    REQUIRE(mesh::signature(grow_region(entry.shape.type(), other)) == mesh::signature(entry.region));
  }
}

TEST_CASE("bad parameters are refused", "[generators]") {
  theory::Configuration c;
  c.parameters = {1, 1, sides({1, 0})};
  CHECK_THROWS_AS(glue_region(theory::kDigon, c), std::invalid_argument);
  c.parameters = {1, 1, sides({1, 1, 1})};
  CHECK_THROWS_AS(grow_region(theory::kDigon, c), std::invalid_argument);
  c.parameters = {500000, 500000, sides({1, 1})};
  CHECK_THROWS_AS(glue_region(theory::kDigon, c), std::invalid_argument);
}

TEST_CASE("enumerate-2: exploration finds tau(9) = 16 configurations from any of them", "[exploration]") {
  // Theorem 7.2: N^2 with N = 4.
  const auto all = theory::parameter_set({theory::kDigon, sides({9, 9})});
  for (const auto& c : all) {
    const Exploration found = explore({theory::kDigon, sides({9, 9})}, {glue_region(theory::kDigon, c)});
    CHECK(found.nodes.size() == 16);
  }
  const auto json =
      graph_json(explore_all({theory::kDigon, sides({9, 9})}, theory::Apex::without), theory::Apex::without);
  CHECK(json["nodes"].size() == 16);
  CHECK(json["edges"].size() == 28);  // level s = 1, 3, 5, 7 has s edges; 2 + 4 + 6 lie between levels
  CHECK(json["components"] == 1);
}

TEST_CASE("Boost's isomorphism agrees on graphs without parallel edges", "[exploration]") {
  // requad-verify compares graphs by labels; this test does not. Graphs of hexagons have no parallel edges and no
  // loops.
  for (const auto length : {3, 4, 5, 6}) {
    const auto s = theory::IntegerVector::Constant(6, length).eval();
    const auto found = found_graph(explore_all({theory::kHexagon, s}, theory::Apex::with), theory::Apex::with);
    const auto predicted =
        theory::configuration_graph(theory::configuration_map({theory::kHexagon, s}, theory::Apex::with));
    CHECK(boost::isomorphism(found, predicted));
  }
}

namespace {

// "flip_ccw 12", "collapse 12", "split 12 34 0".
mesh::BasicOperation operation_of(const std::string& line) {
  using Kind = mesh::BasicOperation::Kind;
  std::istringstream text(line);
  std::string kind;
  int h = -1, last = -1, corner = 0;
  text >> kind >> h >> last >> corner;
  return {kind == "flip_ccw"  ? Kind::flip_ccw
          : kind == "flip_cw" ? Kind::flip_cw
          : kind == "split"   ? Kind::split
                              : Kind::collapse,
          mesh::HalfEdgeId(h), mesh::HalfEdgeId(kind == "split" ? last : -1), corner};
}

}  // namespace

TEST_CASE("the script of each edge leads from the mesh of one signature to that of the other", "[exploration]") {
  for (const theory::RegionShape& shape :
       {theory::RegionShape(theory::kDigon, sides({9, 9})), theory::RegionShape(theory::kDigon, sides({3, 3})),
        theory::RegionShape(theory::kHexagon, sides({3, 3, 3, 3, 3, 3})),
        theory::RegionShape(theory::kQuad, sides({3, 5, 4, 4}))}) {
    for (const theory::Apex apex : {theory::Apex::without, theory::Apex::with}) {
      const nlohmann::json graph = graph_json(explore_all(shape, apex), apex);
      REQUIRE(graph["steps"].size() == graph["edges"].size());
      REQUIRE(graph["scripts"].size() == graph["edges"].size());
      for (std::size_t e = 0; e < graph["edges"].size(); ++e) {
        mesh::Region region =
            mesh::from_signature(std::string(graph["nodes"][graph["edges"][e][0].get<std::size_t>()]["signature"]));
        for (const std::string line : graph["scripts"][e])
          REQUIRE(mesh::apply(region.mesh, operation_of(line)).refusal == mesh::Refusal::none);
        REQUIRE(mesh::signature(region) == graph["nodes"][graph["edges"][e][1].get<std::size_t>()]["signature"]);
      }
    }
  }
}

TEST_CASE("graphs are written in three formats", "[exploration]") {
  const Exploration found = explore_all({theory::kDigon, sides({6, 6})}, theory::Apex::with);
  const auto with = graph_json(found, theory::Apex::with);
  const auto without = graph_json(found, theory::Apex::without);
  CHECK(with["nodes"].size() == 7);
  CHECK(without["nodes"].size() == 6);
  CHECK(with["edges"].size() == without["edges"].size() + 1);  // one edge joins the apex to (1,1)
  for (const auto& node : without["nodes"]) {
    for (const char* key : {"d1", "d2", "p", "faces"}) CHECK(node.contains(key));
    CHECK(node["p"] == 1);  // a digon has one labelling
  }
  const std::string dot = graph_dot(found, theory::Apex::without);
  CHECK(dot.find("graph G {") != std::string::npos);
  CHECK(graph_graphml(found, theory::Apex::without).find("<graphml") != std::string::npos);
  // If there is no configuration, the graph is empty. This is no error.
  const auto none =
      graph_json(explore_all({theory::kQuad, sides({5, 4, 5, 4})}, theory::Apex::without), theory::Apex::without);
  CHECK(none["nodes"].empty());
  CHECK(none["components"] == 0);
}

TEST_CASE("a step of a 3-5 pair leads where its name says, from a segment, too", "[exploration]") {
  // The steps by the change of (m,n), as the grid of Theorem 7.4 has them.
  const std::map<std::pair<int, int>, std::string> names{
      {{1, 0}, "slide_second"}, {{0, 1}, "close"}, {{-1, 0}, "slide_first"}, {{0, -1}, "open"}};
  for (const theory::IntegerVector& s : {sides({7, 5, 4, 8}), sides({8, 5, 4, 9}), sides({7, 6, 4, 9})}) {
    const auto graph = graph_json(explore_all({theory::kQuad, s}, theory::Apex::without), theory::Apex::without);
    REQUIRE(graph["edges"].size() > 4);
    for (std::size_t i = 0; i < graph["edges"].size(); ++i) {
      const auto& from = graph["nodes"][graph["edges"][i][0].get<std::size_t>()];
      const auto& to = graph["nodes"][graph["edges"][i][1].get<std::size_t>()];
      CAPTURE(from.dump(), to.dump());
      const auto change = [&](const char* key) { return to[key].get<int>() - from[key].get<int>(); };
      CHECK(graph["steps"][i] == names.at({change("m"), change("n")}));
    }
  }
}

TEST_CASE("paths are shortest", "[exploration]") {
  // From (1,1) to (5,1) in a digon of side 8, m + n and m - n both grow by 4. Each step changes only one of them, by 2.
  const auto s = sides({8, 8});
  const auto all = theory::parameter_set({theory::kDigon, s});
  const auto at = [&](theory::Integer d1, theory::Integer d2) {
    return *std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.d1() == d1 && c.d2() == d2; });
  };
  const Realisation made = realise({theory::kDigon, s}, at(1, 1), at(5, 1));
  CHECK(made.path.size() == 5);
  CHECK(made.moves.size() == 4);
  CHECK(mesh::signature(made.region) == mesh::signature(glue_region(theory::kDigon, at(5, 1))));
  // The operations alone make the same mesh from the first one.
  mesh::Region replay = glue_region(theory::kDigon, at(1, 1));
  CHECK(mesh::apply_all(replay.mesh, made.operations) == mesh::Refusal::none);
  CHECK(mesh::signature(replay) == mesh::signature(made.region));
}
