// requad-enumerate region: makes the region with given parameters.

#include "enumerate/commands/arguments.hpp"
#include "enumerate/commands/commands.hpp"
#include "enumerate/generators.hpp"
#include "enumerate/realisation.hpp"
#include "mesh/topology/signature.hpp"
#include "theory/joined.hpp"

namespace requad::enumerate {

namespace {

using program::Options;
using program::UsageError;
using theory::Configuration;
using theory::IntegerVector;
using theory::PairType;

PairType parse_shape(const std::string& text) {
  if (text == "digon") return theory::kDigon;
  if (text == "hexagon") return theory::kHexagon;
  if (text == "quad") return theory::kQuad;
  if (const auto type = theory::pair_type(text)) return *type;
  throw UsageError("region: '" + text + "' is not one of digon, hexagon, quad, nor two valences as in 3-6");
}

mesh::Region make_region(PairType type, const IntegerVector& sides, const Configuration& c,
                         const std::string& generator) {
  if (generator == "glue") return glue_region(type, c);
  if (generator == "grow") return grow_region(type, c);
  require_moves(type);
  const theory::RegionShape shape(type, sides);
  return realise(shape, simplest_configuration(shape), c).region;
}

int region(const Options& options) {
  const auto& words = options.words();
  const PairType type = parse_shape(words[0]);
  Configuration c;
  c.parameters = {program::parse_integer(words[1], "D1"), program::parse_integer(words[2], "D2"),
                  theory::to_vector(program::parse_integers(words[3], "strip counts"))};
  if (const std::string problem = theory::parameters_problem(type, c.parameters); !problem.empty())
    throw UsageError("region: " + problem);
  const IntegerVector sides = theory::region_sides(type, c);
  const std::string generator = options.choice("generator", {"glue", "grow", "moves"}, "glue");
  const mesh::Region made = make_region(type, sides, c, generator);
  const std::string signature = mesh::signature(made);
  const std::string text = "sides " + theory::joined(sides, " ") + "\nfaces " + std::to_string(made.mesh.face_count()) +
                           "\nvertices " + std::to_string(made.mesh.vertex_count()) + "\nsignature " + signature + "\n";
  finish(options,
         {{"pair", type.name()},
          {"sides", as_ints(sides)},
          {"faces", made.mesh.face_count()},
          {"vertices", made.mesh.vertex_count()},
          {"signature", signature}},
         text, &made,
         "region with a " + type.name() + " pair, parameters " + words[1] + " " + words[2] + " " + words[3]);
  return program::kDone;
}

}  // namespace

program::Command region_command() {
  return {
      .name = "region",
      .usage = {"digon|hexagon|quad|L1-L2 D1 D2 E1,E2,..."},
      .summary = "makes the region that has these separatrix-strip parameters",
      .text = R"(R_alpha is a D1 x D2 grid. E1,E2,... are the strip counts: 2 for a digon with a
3-3 pair, 6 for a hexagon with a 5-5 pair, 4 for a quadrilateral with a 3-5
pair; L1 + L2 - 4 for any two valences L1, L2.
)",
      .examples = {"requad-enumerate region digon 2 1 3,2 -o region.obj",
                   "requad-enumerate region hexagon 1 2 1,1,2,1,1,1 --generator grow",
                   "requad-enumerate region 3-6 1 1 2,1,2,1,1"},
      .options =
          {
              mesh_output(),
              program::value("generator", "glue|grow|moves",
                             "how the region is made; all three ways give the same mesh (default glue)"),
          },
      .words = {4, 4},
      .run = region,
  };
}

}  // namespace requad::enumerate
