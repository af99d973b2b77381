// A study: all facts about one region, collected before any claim is judged.
//
// The facts come from two independent sources. theory/ predicts from the side lengths. enumerate/ moves pairs on meshes
// and reads labels off them. The claims (claims/claims.hpp) only compare.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "enumerate/exploration.hpp"
#include "enumerate/walk.hpp"
#include "theory/configuration_graph.hpp"
#include "theory/counts.hpp"
#include "verify/studies/region_case.hpp"

namespace requad::verify {

// How configurations are found: by pair moves from one of them, by a search for fillings of the boundary that uses no
// theorem, or by a walk on one mesh (enumerate/walk.hpp), which reaches much larger regions.
enum class Method { moves, search, walk };
const char* name(Method method);

// The fillings of a boundary that a search found: their signatures, sorted.
using Signatures = std::vector<std::string>;

struct PairStudy {
  theory::RegionShape shape;
  // Predicted.
  theory::Integer exact_count = 0;
  theory::ConfigurationMap map;  // with apex; empty if neither moves nor a search are asked for
  // Found by moves from one start, the glued first predicted configuration. Empty if moves are not asked for.
  enumerate::Exploration found;
  std::vector<int> predicted_of;  // for each found node: its index in map.nodes, -1 if its label is not predicted
  // Found by a search, if that is asked for.
  std::optional<Signatures> searched;         // fillings with the pair
  std::optional<Signatures> searched_merged;  // fillings with the merged vertex alone; equal valences only
  // The walk over all configurations, if that is asked for.
  std::optional<enumerate::WalkResult> walked;

  int pairs_predicted() const;  // configurations of the parameter set, which hold the pair
  int pairs_found() const;
};

struct VertexStudy {
  theory::IntegerVector sides;
  std::vector<mesh::Region> glued;     // the predicted configurations
  std::optional<Signatures> searched;  // fillings with the vertex, if a search is asked for and the region is small

  int valence() const { return static_cast<int>(sides.size()); }
};

struct TripleStudy {
  TripleCase region;
  std::vector<mesh::Region> fillings;  // all, by search; empty if that is not asked for
  Signatures with_one;                 // fillings with one vertex instead, a v3 cancelled with a v5
  Signatures with_two;                 // fillings with two vertices instead, two equal ones merged
};

using Study = std::variant<PairStudy, VertexStudy, TripleStudy>;
Family family_of(const Study& study);

// Studies a region by these methods. A walk reports the configurations that it visits to `progress`. Throws
// std::logic_error if the program contradicts itself. Moves take O(nodes * moves * mesh) time. A walk takes O(L^3) time
// and O(L^2) memory.
Study study(const RegionCase& region, const std::set<Method>& methods, const enumerate::WalkProgress& progress = {});
// The same for a pair.
PairStudy study_pair(const theory::RegionShape& shape, const std::set<Method>& methods,
                     const enumerate::WalkProgress& progress = {});
// The study, by moves alone, of an exploration that was made before.
PairStudy study_moves(enumerate::Exploration found);

// The moves that were found, as a map like the predicted one: each node has the same labellings and steps in the same
// order round it, but the targets are where the moves led. Throws std::logic_error on a move that is none of the
// theorem's steps; the message says which.
theory::ConfigurationMap found_map(const PairStudy& study);

}  // namespace requad::verify
