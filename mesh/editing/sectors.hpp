// Sectors: how many quads should lie at a vertex on either side of a feature, or at a boundary vertex.
//
//   cut edge   a feature edge or a boundary edge. No operation removes one.
//   fixed      A fixed vertex lies on a cut edge. Any other vertex is free.
//   sector     The faces of a fixed vertex from one cut edge counter-clockwise to the next, which may be the same one.
//              A free vertex has one sector, its whole ring. A half-edge out of the vertex names the sector of its
//              face.
//   patch      The faces that can be reached from a face without crossing a cut edge. A sector lies in one patch.
//   excess     The number of faces of a sector less the number that it should have. For a free vertex it is l(v) - 4.
//              At a sharp corner a sector of 90 degrees should have one face, on a crease either side should have two.
//
// Law editing-6 (discrete Gauss-Bonnet for a patch). An operation that keeps the cut edges keeps the sum of the
// excesses over each patch. So in a patch whose excesses all have one sign nothing can be cancelled. A vertex that is
// irregular as its features ask is no defect.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "mesh/editing/features.hpp"
#include "mesh/geometry/measures.hpp"

namespace requad::mesh {

// How many faces the sectors of fixed vertices should have.
class SectorPlan {
 public:
  // For the sector of v that starts at the cut edge v -> first, counter-clockwise. Size >= 1.
  void set(VertexId v, VertexId first, int size);
  std::optional<int> get(VertexId v, VertexId first) const;

 private:
  static std::uint64_t key(VertexId v, VertexId first);
  std::unordered_map<std::uint64_t, int> sizes_;
};

// A mesh seen with its cut edges. The mesh, and features and plan where they are given, must outlive it.
class Sectors {
 public:
  // Without a plan, no fixed vertex has an excess, and none may change.
  explicit Sectors(const QuadMesh& mesh, const FeatureSet* features = nullptr, const SectorPlan* plan = nullptr)
      : mesh_(mesh), features_(features), plan_(plan) {}

  bool is_feature(VertexId v) const { return features_ != nullptr && features_->is_vertex(v); }
  bool is_fixed(VertexId v) const { return mesh_.is_boundary(v) || is_feature(v); }
  // Whether the edge of h is a cut edge.
  bool is_cut(HalfEdgeId h) const;
  // Whether an edit may change the number of faces in the sectors of v.
  bool may_change(VertexId v) const { return plan_ != nullptr || !is_fixed(v); }

  // The first half-edge of the sector, which lies on a cut edge; for a free vertex, h. O(valence).
  HalfEdgeId start(HalfEdgeId h) const;
  // The number of faces of the sector. O(valence).
  int size(HalfEdgeId h) const;
  // 0 for a fixed vertex that may not change. O(valence).
  int excess(HalfEdgeId h) const;

  // Calls visit(h) for the first half-edge of each sector of v. O(valence^2).
  template <class Visit>
  void for_each_sector(VertexId v, Visit&& visit) const {
    if (!is_fixed(v)) {
      visit(mesh_.out(v));
      return;
    }
    mesh_.for_each_out(v, [&](HalfEdgeId h) {
      if (is_cut(h)) visit(h);
    });
  }
  // Calls visit(x, at) for each neighbour x of v, once for every sector that has the edge to x and an excess of this
  // sign. `at` is the half-edge of the edge in the sector's patch. O(valence^2).
  template <class Visit>
  void for_each_edge(VertexId v, int sign, Visit&& visit) const {
    mesh_.for_each_out(v, [&](HalfEdgeId h) {
      if (sign * excess(h) <= 0) return;
      visit(mesh_.target(h), h);
      const HalfEdgeId last = QuadMesh::previous(h);  // the sector's last edge, if it is cut
      if (is_cut(last)) visit(mesh_.origin(last), last);
    });
  }
  // Whether a sector of v has negative (positive) excess.
  bool lacks(VertexId v) const {
    return any(v, [](int e) { return e < 0; });
  }
  bool exceeds(VertexId v) const {
    return any(v, [](int e) { return e > 0; });
  }
  bool is_irregular(VertexId v) const {
    return any(v, [](int e) { return e != 0; });
  }

  // Whether no patch has excesses of both signs. O(mesh).
  bool is_minimal() const;

 private:
  template <class Holds>
  bool any(VertexId v, Holds&& holds) const {
    if (!is_fixed(v)) return holds(mesh_.face_valence(v) - 4);
    if (plan_ == nullptr) return false;
    bool found = false;
    for_each_sector(v, [&](HalfEdgeId h) { found = found || holds(excess(h)); });
    return found;
  }

  const QuadMesh& mesh_;
  const FeatureSet* features_;
  const SectorPlan* plan_;
};

// How many faces the sectors of boundary vertices should have.
enum class BoundaryPlan {
  angle,  // what angles ask for, as on features
  free,   // any number: none of them has an excess
  fixed   // as many as they have now
};

// The plan that angles ask for: a sector should have one face for each 90 degrees between its cut edges, measured along
// the surface and rounded, and at least one. At boundary vertices another plan may hold. O(mesh).
SectorPlan plan_by_angles(const QuadMesh& mesh, const FeatureSet& features, const Positions& positions,
                          BoundaryPlan boundary = BoundaryPlan::angle);

}  // namespace requad::mesh
