// Why an operation is refused.
//
// Each layer of mesh/ refuses for reasons of its own: the basic operations for those listed here, features for those of
// FeatureRefusal (editing/features.hpp), edits of irregular vertices for those of EditRefusal
// (irregular/edit_refusal.hpp). A Refusal can be any of them, so it reaches the user unchanged, whichever layer
// refused. It is as cheap as a pointer.
#pragma once

#include <compare>
#include <string_view>

namespace requad::mesh {

class Refusal {
 public:
  // A reason, which lives as long as the program. Each reason has its own `rank`: reports list reasons by it. `clause`
  // says it in one short clause without full stop.
  struct Reason {
    int rank;
    std::string_view clause;
  };

  constexpr Refusal() = default;  // none
  explicit constexpr Refusal(const Reason& reason) : reason_(&reason) {}

  static const Refusal none;             // not refused
  static const Refusal dead_element;     // a handle does not name a live element
  static const Refusal boundary_edge;    // a boundary edge cannot be flipped
  static const Refusal valence_too_low;  // an interior vertex would keep one edge only, or a boundary vertex no face
  static const Refusal edge_exists;  // two edges would join the same vertices, or an edge would join a vertex to itself
  static const Refusal boundary_corner;  // the vertex to remove lies on the boundary
  static const Refusal same_edge;        // both edges of the path are one
  static const Refusal not_one_fan;      // the two half-edges do not bound a sector of one vertex, in this order

  int rank() const { return reason_ == nullptr ? 0 : reason_->rank; }
  std::string_view clause() const { return reason_ == nullptr ? "legal" : reason_->clause; }

  friend constexpr bool operator==(Refusal, Refusal) = default;
  friend std::strong_ordering operator<=>(Refusal a, Refusal b) { return a.rank() <=> b.rank(); }

 private:
  const Reason* reason_ = nullptr;
};

namespace reasons {
inline constexpr Refusal::Reason kDeadElement{1, "no such element"};
inline constexpr Refusal::Reason kBoundaryEdge{2, "a boundary edge cannot be flipped"};
inline constexpr Refusal::Reason kValenceTooLow{3, "a vertex would be left with too few edges"};
inline constexpr Refusal::Reason kEdgeExists{4, "two edges would join the same vertices"};
inline constexpr Refusal::Reason kBoundaryCorner{5, "the vertex to remove lies on the boundary"};
inline constexpr Refusal::Reason kSameEdge{6, "both edges of the path are the same"};
inline constexpr Refusal::Reason kNotOneFan{7, "the two edges do not bound a sector of one vertex"};
}  // namespace reasons

inline constexpr Refusal Refusal::none{};
inline constexpr Refusal Refusal::dead_element{reasons::kDeadElement};
inline constexpr Refusal Refusal::boundary_edge{reasons::kBoundaryEdge};
inline constexpr Refusal Refusal::valence_too_low{reasons::kValenceTooLow};
inline constexpr Refusal Refusal::edge_exists{reasons::kEdgeExists};
inline constexpr Refusal Refusal::boundary_corner{reasons::kBoundaryCorner};
inline constexpr Refusal Refusal::same_edge{reasons::kSameEdge};
inline constexpr Refusal Refusal::not_one_fan{reasons::kNotOneFan};

}  // namespace requad::mesh
