// A study: everything that is found out about one region, before any claim is judged.
//
// Facts come from two sides that do not know each other: theory/ predicts from the side lengths, enumerate/ moves pairs
// on meshes and reads labels off them. The claims (claims.hpp) only compare.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "enumerate/exploration.hpp"
#include "enumerate/walk.hpp"
#include "theory/configuration_graph.hpp"
#include "theory/counts.hpp"

namespace requad::verify {

enum class Family { regular_digon, regular_hexagon, quad, other_digon, other_hexagon, single_vertex, three_vertices };
const char* name(Family family);  // "regular digons", ...

// How configurations are found: by pair moves from one of them, by filling the boundary without any theorem, or by a walk
// on one mesh (enumerate/walk.hpp), which goes much further.
enum class Method { moves, search, walk };
const char* name(Method method);

// What to study. A region for a single irregular vertex of valence k has k sides; its type is {k + 1, 3}, whose merged
// configurations they are. So is that of a region for three vertices, which would become that one if they could.
struct RegionCase {
  Family family;
  theory::PairType type;
  theory::IntegerVector sides;
  std::vector<int> irregular = {};  // three vertices only: their valences
};

struct Study {
  RegionCase region;
  // Predicted.
  theory::Integer exact_count = 0;
  theory::ConfigurationMap map;  // with apex; only if moves or search are asked for
  // Found by moves from one start, the first predicted configuration, glued.
  enumerate::Exploration found{theory::RegionShape::regular(theory::kDigon, 2), {}, {}};
  std::vector<int> predicted_of;  // per found node: index into map.nodes, -1 if its label is not predicted
  // Found by search: signatures of all fillings with the pair, and with the merged vertex alone; nothing if not asked for.
  std::optional<std::vector<std::string>> searched;
  std::optional<std::vector<std::string>> searched_merged;
  // The walk over all configurations; nothing if not asked for, or if there is none.
  std::optional<enumerate::WalkResult> walked;
  // Three vertices: all fillings, by search. `searched` are those with one vertex instead (if a v3 is cancelled with a v5),
  // `searched_merged` those with two (if equal ones are merged); empty if the valences do not allow it.
  std::vector<mesh::Region> fillings;
  // Predicted configurations of a single vertex, glued.
  std::vector<mesh::Region> single;

  int pairs_predicted() const;  // configurations of the parameter set, which hold the pair
  int pairs_found() const;
};

// Throws std::invalid_argument on impossible sides. O(nodes * moves * mesh), and the search; a walk alone O(L^3) time and
// O(L^2) memory. `progress` is told of configurations that the walk visits.
Study study(const RegionCase& region, const std::set<Method>& methods, const enumerate::WalkProgress& progress = {});

// The moves that were found, as a map like the predicted one: at each node the same labellings and steps in the same order
// round the node, but the targets are where the moves led. A move that is none of the theorem's steps throws
// std::logic_error with what it is.
theory::ConfigurationMap found_map(const Study& study);

// "5-5 region with sides 3 3 3 3 3 3".
std::string describe(const RegionCase& region);

}  // namespace requad::verify
