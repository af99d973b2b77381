// The edits of a region with several irregular vertices: what single edits make of it, and what basic operations reach.
//
// An edit is one of three:
//   move        a pair move of any two of the irregular vertices (mesh/irregular/pair_moves.hpp), merging included
//   transport   Any irregular vertex moves by an edge, in any direction, and leaves an adjacent 3-5 pair. The pair is
//               transported to another one of them, or to whichever is nearest (mesh/irregular/transport.hpp).
//   operation   a single basic operation
//
// No edit changes a valence on the boundary.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mesh/editing/features.hpp"
#include "mesh/topology/region.hpp"

namespace requad::enumerate {

// A mesh of the same boundary.
struct EditResult {
  std::vector<int> valences;  // of its irregular vertices, the least first
  std::string signature;      // from the root of the region

  friend bool operator==(const EditResult&, const EditResult&) = default;
  friend auto operator<=>(const EditResult&, const EditResult&) = default;
};

// The results of all edits that leave at most as many irregular vertices as the region has: each once, sorted. For n
// irregular vertices it takes O(n^2) moves, O(n 2^n) transports and O(F) operations.
std::vector<EditResult> edit_results(const mesh::Region& region);
// The results of all single basic operations that leave at most `most` irregular vertices, likewise.
std::vector<EditResult> operation_results(const mesh::Region& region, std::size_t most);

// Exhausts the basic operations: visits every mesh that they reach from the region while the sum of |4 - l| over the
// interior stays at most `most_irregularity`, and returns the first one with fewer irregular vertices than the region
// has; nothing if there is none. The number of meshes is exponential in most_irregularity.
std::optional<EditResult> fewer_by_operations(const mesh::Region& region, int most_irregularity);

// Exhausts the transports of one adjacent pair round features: makes basic operations in every order, as long as the
// region has its irregular vertices and one adjacent pair besides, until the pair is gone. No operation breaks a feature
// edge or changes the valence of its ends. Returns the signatures of the meshes at the end, sorted. It uses none of the
// steps of mesh/irregular/transport.hpp. The number of meshes on the way grows fast with the region.
std::vector<std::string> transports_round(const mesh::Region& region, const mesh::FeatureSet& features);

// Whether the adjacent pair may pass the vertex `last`, which then is a v6 or a v2 for a while.
enum class Passing { allowed, not_allowed };

// Exhausts the pipelines of section 6 that start at one vertex of a pair and end at the other, in the same way. The first
// operation moves `first` and leaves `last` as it is. Without passing, only the last operation changes the valence of
// `last`. Precondition: the region has no other irregular vertex.
std::vector<std::string> pipelines(const mesh::Region& region, mesh::VertexId first, mesh::VertexId last,
                                   Passing passing);

}  // namespace requad::enumerate
