// A study: all facts about one region, collected before any claim is judged.
//
// The facts come from three independent sources. theory/ predicts them from the side lengths. Moves on meshes find them
// (enumerate/exploration.hpp), with labels that are read off the meshes. A search fills the boundary with quads and
// uses neither theory nor moves (enumerate/search/). The claims (claims/claims.hpp) only compare these facts.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "enumerate/edits.hpp"
#include "enumerate/exploration.hpp"
#include "enumerate/walk.hpp"
#include "theory/configuration_graph.hpp"
#include "theory/counts.hpp"
#include "verify/studies/region_case.hpp"

namespace requad::verify {

// How configurations are found:
//   moves    pair moves lead from one configuration to all others.
//   search   a search lists the fillings of the boundary. It uses no theorem about pairs and no move.
//   walk     pair moves change one mesh, which visits every configuration (enumerate/walk.hpp). Of the three methods,
//            this one reaches the largest regions.
enum class Method { moves, search, walk };
const char* name(Method method);

// How long each method took, in seconds.
using MethodSeconds = std::map<Method, double>;

// The signatures of the fillings that a search found, sorted.
using Signatures = std::vector<std::string>;

struct PairStudy {
  theory::RegionShape shape;
  // Predicted.
  theory::Integer exact_count = 0;
  theory::ConfigurationMap map;  // with apex; empty if neither moves nor a search are asked for
  // Found by moves. They start from the first predicted configuration, which is glued from its parameters. Empty if
  // moves are not asked for.
  enumerate::Exploration found;
  std::vector<int> predicted_of;  // the index in map.nodes of each found node; -1 if its label is not predicted
  // Found by a search, if that is asked for.
  std::optional<Signatures> searched;         // fillings with the pair
  std::optional<Signatures> searched_merged;  // fillings with the merged vertex alone; equal valences only
  // The result of the walk, if that is asked for.
  std::optional<enumerate::WalkResult> walked;
  bool search_asked = false;
  MethodSeconds seconds = {};

  int pairs_predicted() const;  // configurations of the parameter set, which hold the pair
  int pairs_found() const;
};

struct VertexStudy {
  theory::IntegerVector sides;
  std::vector<mesh::Region> glued;     // the predicted configurations
  std::optional<Signatures> searched;  // fillings with the vertex, if a search is asked for and the region is small
  MethodSeconds seconds = {};

  int valence() const { return static_cast<int>(sides.size()); }
};

struct TripleStudy {
  TripleCase region;
  bool searched = false;  // if not, everything below is empty
  // Found by a search.
  std::vector<mesh::Region> fillings;            // with the three vertices
  Signatures signatures;                         // of these, in the same order
  std::map<std::vector<int>, Signatures> fewer;  // fillings with fewer irregular vertices, by their valences
  // Found by edits.
  std::vector<std::vector<enumerate::EditResult>> edits;  // what one edit makes of each filling
  MethodSeconds seconds = {};                             // edits count as moves

  // The valences of the two vertices that remain when two equal ones merge, and of the one that remains when a v3 and a
  // v5 cancel (nothing without such a pair).
  std::vector<int> after_merging() const;
  std::optional<std::vector<int>> after_cancelling() const;
  const Signatures& fewer_with(const std::vector<int>& valences) const;  // empty if there are none
};

using Study = std::variant<PairStudy, VertexStudy, TripleStudy>;
Family family_of(const Study& study);
const MethodSeconds& seconds_of(const Study& study);
// The number of fillings that the search found with the irregular vertices of the region; nothing if there was no
// search.
std::optional<std::int64_t> fillings_searched(const Study& study);

// Studies a region by these methods. A walk calls `progress` with the number of configurations that it has visited.
// Throws std::logic_error if the program contradicts itself. Moves take O(nodes * moves * mesh) time. A walk takes
// O(L^3) time and O(L^2) memory.
Study study(const RegionCase& region, const std::set<Method>& methods, const enumerate::WalkProgress& progress = {});
// The same for a pair.
PairStudy study_pair(const theory::RegionShape& shape, const std::set<Method>& methods,
                     const enumerate::WalkProgress& progress = {});
// What the search finds of a region with three irregular vertices: the fillings, and those with fewer; no edits.
TripleStudy search_triple(const TripleCase& region);
// The study of a pair that explore() has explored before. Its only method is moves.
PairStudy study_moves(enumerate::Exploration found);

}  // namespace requad::verify
