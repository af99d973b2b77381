// Why edits of irregular vertices are refused, beside what basic operations and features refuse.
#pragma once

#include "mesh/topology/refusal.hpp"

namespace requad::mesh {

namespace reasons {
inline constexpr Refusal::Reason kTouchesBoundary{8, "a boundary vertex would change its valence"};
inline constexpr Refusal::Reason kNoSuchStep{9, "the pair has no configuration in this direction"};
inline constexpr Refusal::Reason kIrregularInTheWay{10, "another irregular vertex is in the way"};
inline constexpr Refusal::Reason kOverlapsItself{11, "the pair's rectangle overlaps itself, or the faces round it do"};
inline constexpr Refusal::Reason kNoPath{13, "no path leads the 3-5 pair to a vertex that can take it"};
inline constexpr Refusal::Reason kWrongValences{14, "the vertices do not have the valences that this needs"};
inline constexpr Refusal::Reason kNoRectangle{
    15, "the separatrices of the two span no rectangle (Lemma 7.8), which this needs"};
inline constexpr Refusal::Reason kOddDistance{
    16, "the pair is an odd number of edges apart, and parity never changes (Theorems 7.2, 7.3)"};
inline constexpr Refusal::Reason kLonePair{
    17, "a 3-5 pair cannot be cancelled without a third irregular vertex (Theorem 7.4)"};
inline constexpr Refusal::Reason kLoneVertex{18, "a single irregular vertex cannot be moved (Theorem 7.1)"};
inline constexpr Refusal::Reason kIndex{19, "the sum of 4 - l(v) is fixed by the surface (discrete Gauss-Bonnet)"};
}  // namespace reasons

struct EditRefusal {
  // Of atomic operations and pair moves.
  static constexpr Refusal touches_boundary{reasons::kTouchesBoundary};  // a boundary vertex would change its valence
  static constexpr Refusal no_such_step{reasons::kNoSuchStep};  // the pair has no configuration in this direction
  // Another irregular vertex lies on the path of the move, or the mesh there is not what the move needs.
  static constexpr Refusal irregular_in_the_way{reasons::kIrregularInTheWay};
  // The move does not work out, and R_alpha with the faces round it is not embedded (Law irregular-13).
  static constexpr Refusal overlaps_itself{reasons::kOverlapsItself};
  // Of transport.
  static constexpr Refusal no_path{reasons::kNoPath};  // no path leads the adjacent pair to a vertex that can take it
  // Of complementary operations: what no sequence of operations can do.
  static constexpr Refusal wrong_valences{reasons::kWrongValences};  // the vertices do not have the valences needed
  static constexpr Refusal no_rectangle{
      reasons::kNoRectangle};  // the pair's separatrices span no rectangle (Lemma 7.8)
  static constexpr Refusal odd_distance{reasons::kOddDistance};  // 3-3 and 5-5 pairs merge at even distance (7.2, 7.3)
  static constexpr Refusal lone_pair{reasons::kLonePair};  // a 3-5 pair needs a third irregular vertex (Theorem 7.4)
  static constexpr Refusal lone_vertex{reasons::kLoneVertex};  // a single irregular vertex cannot move (Theorem 7.1)
  static constexpr Refusal index{reasons::kIndex};             // discrete Gauss-Bonnet leaves no room (Equation 1)
};

}  // namespace requad::mesh
