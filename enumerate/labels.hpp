// Reading a configuration's parameters off a mesh: where the separatrices run and which sides they meet. Nothing is
// carried along from how the mesh was made.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesh/irregular/pair_frame.hpp"
#include "mesh/topology/region.hpp"
#include "theory/configurations.hpp"

namespace requad::enumerate {

// One frame of the pair with the labelling it gives. The labelling has p in 1..k/2 for equal valences, 1..k otherwise;
// it is not made canonical: a segment has two.
struct LabelledFrame {
  mesh::PairFrame frame;
  theory::Configuration labelling;
};

// Reads the labelling of a frame: extents are d1 = b, d2 = a; outward separatrix i has length e_i and must meet side
// i + p - 1. Nothing if a separatrix ends elsewhere, which Lemmas 7.12-7.14 exclude. `positions` is
// mesh::boundary_positions(region). O(d1 + d2 + sum of e_i).
std::optional<theory::Configuration> labelling_of(const mesh::Region& region,
                                                  const std::vector<mesh::BoundaryPosition>& positions,
                                                  theory::PairType type, const mesh::PairFrame& frame);

// What the region holds, found by looking at all of it: the irregular vertices, their frames and labellings.
struct Reading {
  std::vector<mesh::VertexId> irregular;
  std::vector<LabelledFrame> frames;    // of the pair, or one with a = b = 0 for a merged vertex
  theory::Configuration configuration;  // canonical
  std::string problem;                  // "" if the region holds one pair of this type, or one merged vertex
};
Reading read(const mesh::Region& region, theory::PairType type);

// Theorem 7.11's vector: for each separatrix of each irregular vertex, counter-clockwise from its first leg, the side
// and distance from the side's start where it meets the boundary; {-1,-1} where it ends at the other vertex.
std::vector<mesh::BoundaryPosition> separatrix_vector(const mesh::Region& region, const mesh::PairFrame& frame);

}  // namespace requad::enumerate
