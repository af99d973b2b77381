// Sharp features: edges that no operation may break.
//
// A feature is a set of edges, named by their end vertices. A vertex keeps its id under every operation that does not
// remove it, so the set needs no update. "The feature is kept" means exactly this: every edge of the set is an edge of
// the mesh between the same two vertices. The Editor keeps their positions.
//
// Law editing-5 (features). An operation keeps every feature edge iff
//   flip      the edge is no feature edge
//   collapse  the corner that is removed is no end of a feature edge (the other corner of the diagonal may be one)
//   split     no feature edge at v lies strictly inside the sector that the new vertex takes
//
// Boundary edges need no listing: no operation breaks one (law topology-6).
#pragma once

#include <array>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "mesh/topology/basic_operations.hpp"

namespace requad::mesh {

// Why an edit is refused for the sake of a feature.
namespace reasons {
inline constexpr Refusal::Reason kBreaksFeature{11, "a feature edge would go"};
inline constexpr Refusal::Reason kMovesFeature{12, "a vertex on a feature would move"};
}  // namespace reasons

struct FeatureRefusal {
  static constexpr Refusal breaks_feature{reasons::kBreaksFeature};
  static constexpr Refusal moves_feature{reasons::kMovesFeature};
};

class FeatureSet {
 public:
  // Makes the edge between a and b a feature edge. Twice is once. O(1).
  void insert(VertexId a, VertexId b);

  bool empty() const { return edges_.empty(); }
  std::size_t size() const { return edges_.size(); }
  bool is_edge(VertexId a, VertexId b) const { return edges_.count(key(a, b)) != 0; }
  // The number of feature edges at v. A vertex where it is neither 0 nor 2 is a feature corner.
  int edges_at(VertexId v) const { return v.slot() < degree_.size() ? degree_[v.slot()] : 0; }
  bool is_vertex(VertexId v) const { return edges_at(v) > 0; }
  // All edges, least vertex first, in increasing order. O(n log n).
  std::vector<std::array<VertexId, 2>> edges() const;

  // By Law editing-5: FeatureRefusal::breaks_feature or Refusal::none. Precondition: the operation is legal on the
  // mesh. O(valence).
  Refusal why_not(const QuadMesh& mesh, const BasicOperation& operation) const;

 private:
  static std::uint64_t key(VertexId a, VertexId b);

  std::unordered_set<std::uint64_t> edges_;
  std::vector<int> degree_;  // by vertex slot
};

}  // namespace requad::mesh
