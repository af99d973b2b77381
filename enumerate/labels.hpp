// The parameters of a configuration, read off a mesh: where the separatrices of its pair run, and which sides they
// meet. They do not depend on how the mesh was made.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesh/irregular/pair_frame.hpp"
#include "mesh/topology/region.hpp"
#include "theory/configurations.hpp"

namespace requad::enumerate {

// The labelling that a frame gives: outward separatrix i, of length e_i, meets side i + p - 1 of the region. p is in
// 1..k/2 for equal valences, where v1 and v2 may be exchanged, and in 1..k otherwise. Nothing if a separatrix ends
// elsewhere, which Lemmas 7.12-7.14 exclude. `positions` is mesh::boundary_positions(region).
// O(d1 + d2 + sum of the e_i).
std::optional<theory::Configuration> labelling_of(const mesh::Region& region,
                                                  const std::vector<mesh::BoundaryPosition>& positions,
                                                  theory::PairType type, const mesh::PairFrame& frame);

struct LabelledFrame {
  mesh::PairFrame frame;
  theory::Configuration labelling;  // as labelling_of() gives it; not canonical, since a segment has two frames
};

// The pair or the merged vertex that a region holds.
struct Reading {
  std::vector<mesh::VertexId> irregular;
  std::vector<LabelledFrame> frames;    // of the pair; a merged vertex has one, with d1 = d2 = 0
  theory::Configuration configuration;  // canonical
  std::string problem;                  // "" if the region holds one pair of this type, or one merged vertex
};
// Reads the whole region. Precondition: region_problem(region) is "". O(V).
Reading read(const mesh::Region& region, theory::PairType type);

// The vector of Theorem 7.11: for each separatrix of v1, then of v2, counter-clockwise from the first leg, where it
// meets the boundary. {-1, -1} stands for a separatrix that ends at the other vertex. O(V).
std::vector<mesh::BoundaryPosition> separatrix_vector(const mesh::Region& region, const mesh::PairFrame& frame);

}  // namespace requad::enumerate
