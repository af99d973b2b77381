#include "enumerate/labels.hpp"

#include <algorithm>

#include "mesh/topology/separatrix.hpp"

namespace requad::enumerate {

using mesh::BoundaryPosition;
using mesh::HalfEdgeId;
using mesh::PairFrame;
using mesh::Region;
using theory::Configuration;
using theory::PairType;

std::optional<Configuration> labelling_of(const Region& region, const std::vector<BoundaryPosition>& positions,
                                          PairType type, const PairFrame& frame) {
  const int k = type.side_count();
  const std::vector<HalfEdgeId> outward = mesh::outward_of_both(region.mesh, frame);

  Configuration labelling;
  labelling.parameters = {frame.d1, frame.d2, theory::IntegerVector::Zero(k)};
  for (int i = 0; i < k; ++i) {
    const mesh::Separatrix s = mesh::trace(region.mesh, outward[static_cast<std::size_t>(i)]);
    if (s.end != mesh::Separatrix::End::boundary) return std::nullopt;
    const int side = positions[region.mesh.target(s.path.back()).slot()].side;
    if (i == 0) labelling.p = side + 1;
    if (side != (labelling.p - 1 + i) % k) return std::nullopt;
    labelling.parameters.e(i) = s.length();
  }
  if (type.symmetric() && labelling.p > k / 2) {
    // v1 and v2 have swapped names.
    labelling.p -= k / 2;
    theory::IntegerVector& e = labelling.parameters.e;
    std::rotate(e.begin(), e.begin() + k / 2, e.end());
  }
  return labelling;
}

namespace {

// A merged vertex: its separatrices meet the sides one by one.
void read_merged(const Region& region, PairType type, Reading& reading) {
  const mesh::QuadMesh& m = region.mesh;
  const mesh::VertexId v = reading.irregular[0];
  const int k = type.side_count();
  const auto positions = mesh::boundary_positions(region);
  Configuration c;
  c.parameters.e = theory::IntegerVector::Zero(k);
  m.for_each_out(v, [&](HalfEdgeId h) {
    const mesh::Separatrix s = mesh::trace(m, h);
    const int side = positions[m.target(s.path.back()).slot()].side;
    if (s.end == mesh::Separatrix::End::boundary && side < k) c.parameters.e(side) = s.length();
  });
  if (c.parameters.e.minCoeff() == 0) {
    reading.problem = "the separatrices of the merged vertex do not meet the sides one by one";
    return;
  }
  reading.configuration = c;
  reading.frames.push_back({{m.out(v), m.ccw(m.out(v)), v, v, 0, 0}, c});
}

}  // namespace

Reading read(const Region& region, PairType type) {
  const mesh::QuadMesh& m = region.mesh;
  Reading reading;
  reading.irregular = mesh::irregular_vertices(m);
  const auto& v = reading.irregular;
  if (v.size() == 1 && type.symmetric() && m.valence(v[0]) == type.side_count()) {
    read_merged(region, type, reading);
    return reading;
  }
  const bool pair = v.size() == 2 && std::max(m.valence(v[0]), m.valence(v[1])) == type.l1 &&
                    std::min(m.valence(v[0]), m.valence(v[1])) == type.l2;
  if (!pair) {
    reading.problem = "the irregular vertices are not a " + type.name() + " pair";
    return reading;
  }
  const bool in_order = m.valence(v[0]) == type.l1;
  const auto positions = mesh::boundary_positions(region);
  for (const PairFrame& frame : mesh::find_frames(m, in_order ? v[0] : v[1], in_order ? v[1] : v[0])) {
    const auto labelling = labelling_of(region, positions, type, frame);
    if (!labelling) {
      reading.problem = "an outward separatrix meets the wrong side";
      return reading;
    }
    reading.frames.push_back({frame, *labelling});
  }
  if (reading.frames.empty()) {
    reading.problem = "the separatrices of the pair span no rectangle";
    return reading;
  }
  reading.configuration = theory::canonical(type, reading.frames[0].labelling);
  for (const LabelledFrame& f : reading.frames) {
    if (!(theory::canonical(type, f.labelling) == reading.configuration))
      reading.problem = "two frames give two configurations";
  }
  return reading;
}

std::vector<BoundaryPosition> separatrix_vector(const Region& region, const PairFrame& frame) {
  const auto positions = mesh::boundary_positions(region);
  std::vector<BoundaryPosition> vector;
  for (const PairFrame& f : mesh::both_ends(region.mesh, frame)) {
    HalfEdgeId h = f.first_leg;
    do {
      const mesh::Separatrix s = mesh::trace(region.mesh, h);
      vector.push_back(s.end == mesh::Separatrix::End::boundary ? positions[region.mesh.target(s.path.back()).slot()]
                                                                : BoundaryPosition{});
      h = region.mesh.ccw(h);
    } while (h != f.first_leg);
  }
  return vector;
}

}  // namespace requad::enumerate
