#include "enumerate/labels.hpp"

#include <algorithm>

#include "mesh/topology/separatrix.hpp"

namespace requad::enumerate {

using mesh::BoundaryPosition;
using mesh::HalfEdgeId;
using mesh::PairFrame;
using mesh::Region;
using mesh::VertexId;
using theory::Configuration;
using theory::PairType;

namespace {

// Where the separatrix that starts with h meets the boundary, and its length.
struct Crossing {
  BoundaryPosition at;  // {-1, -1}: it ends at a vertex inside
  int length;
};
Crossing crossing_of(const Region& region, const std::vector<BoundaryPosition>& positions, HalfEdgeId h) {
  const mesh::Separatrix s = mesh::trace(region.mesh, h);
  if (s.end != mesh::Separatrix::End::boundary) return {{}, s.length()};
  return {positions[region.mesh.target(s.path.back()).slot()], s.length()};
}

// The labelling after v1 and v2 have swapped names, if that brings p into 1..k/2.
void reduce_third_index(PairType type, Configuration& labelling) {
  const int k = type.side_count();
  if (type.symmetric() && labelling.p > k / 2) {
    labelling.p -= k / 2;
    theory::IntegerVector& e = labelling.parameters.e;
    std::rotate(e.begin(), e.begin() + k / 2, e.end());
  }
}

}  // namespace

std::optional<Configuration> labelling_of(const Region& region, const std::vector<BoundaryPosition>& positions,
                                          PairType type, const PairFrame& frame) {
  const int k = type.side_count();
  const std::vector<HalfEdgeId> outward = mesh::outward_of_both(region.mesh, frame);
  Configuration labelling;
  labelling.parameters = {frame.d1, frame.d2, theory::IntegerVector::Zero(k)};
  for (int i = 0; i < k; ++i) {
    const Crossing crossing = crossing_of(region, positions, outward[static_cast<std::size_t>(i)]);
    const int side = crossing.at.side;
    if (i == 0) labelling.p = side + 1;
    if (side < 0 || side != (labelling.p - 1 + i) % k) return std::nullopt;
    labelling.parameters.e(i) = crossing.length;
  }
  reduce_third_index(type, labelling);
  return labelling;
}

namespace {

// The separatrices of a merged vertex meet the sides one by one.
void read_merged(const Region& region, PairType type, VertexId v, Reading& reading) {
  const mesh::QuadMesh& m = region.mesh;
  const int k = type.side_count();
  const auto positions = mesh::boundary_positions(region);
  Configuration c;
  c.parameters.e = theory::IntegerVector::Zero(k);
  m.for_each_out(v, [&](HalfEdgeId h) {
    const Crossing crossing = crossing_of(region, positions, h);
    if (crossing.at.side >= 0 && crossing.at.side < k) c.parameters.e(crossing.at.side) = crossing.length;
  });
  if (c.parameters.e.minCoeff() == 0) {
    reading.problem = "the separatrices of the merged vertex do not meet the sides one by one";
    return;
  }
  reading.configuration = c;
  reading.frames.push_back({{m.out(v), m.ccw(m.out(v)), v, v, 0, 0}, c});
}

// A segment has two frames, whose labellings are those of one configuration.
void read_pair(const Region& region, PairType type, VertexId v1, VertexId v2, Reading& reading) {
  const auto positions = mesh::boundary_positions(region);
  for (const PairFrame& frame : mesh::find_frames(region.mesh, v1, v2)) {
    const auto labelling = labelling_of(region, positions, type, frame);
    if (!labelling) {
      reading.problem = "an outward separatrix meets the wrong side";
      return;
    }
    reading.frames.push_back({frame, *labelling});
  }
  if (reading.frames.empty()) {
    reading.problem = "the separatrices of the pair span no rectangle";
    return;
  }
  reading.configuration = theory::canonical(type, reading.frames[0].labelling);
  for (const LabelledFrame& f : reading.frames) {
    if (!(theory::canonical(type, f.labelling) == reading.configuration))
      reading.problem = "two frames give two configurations";
  }
}

}  // namespace

Reading read(const Region& region, PairType type) {
  const mesh::QuadMesh& m = region.mesh;
  Reading reading;
  reading.irregular = mesh::irregular_vertices(m);
  const auto& v = reading.irregular;
  const auto are_pair = [&](VertexId v1, VertexId v2) { return m.valence(v1) == type.l1 && m.valence(v2) == type.l2; };
  if (v.size() == 1 && type.symmetric() && m.valence(v[0]) == type.side_count()) {
    read_merged(region, type, v[0], reading);
  } else if (v.size() == 2 && are_pair(v[0], v[1])) {
    read_pair(region, type, v[0], v[1], reading);
  } else if (v.size() == 2 && are_pair(v[1], v[0])) {
    read_pair(region, type, v[1], v[0], reading);
  } else {
    reading.problem = "the irregular vertices are not a " + type.name() + " pair";
  }
  return reading;
}

std::vector<BoundaryPosition> separatrix_vector(const Region& region, const PairFrame& frame) {
  const auto positions = mesh::boundary_positions(region);
  std::vector<BoundaryPosition> vector;
  for (const PairFrame& end : mesh::both_ends(region.mesh, frame)) {
    HalfEdgeId h = end.first_leg;
    do {
      vector.push_back(crossing_of(region, positions, h).at);
      h = region.mesh.ccw(h);
    } while (h != end.first_leg);
  }
  return vector;
}

}  // namespace requad::enumerate
