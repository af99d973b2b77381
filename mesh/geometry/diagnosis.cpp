#include "mesh/geometry/diagnosis.hpp"

#include <algorithm>
#include <limits>

#include "mesh/topology/region.hpp"
#include "mesh/topology/validate.hpp"

namespace requad::mesh {

namespace {

// The statistics of measure(element) over a list of elements.
template <class Element, class Measure>
Diagnosis::Statistics statistics(const std::vector<Element>& elements, const Measure& measure) {
  if (elements.empty()) return {};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Diagnosis::Statistics s{kInfinity, 0, -kInfinity};
  for (const Element e : elements) {
    const double value = measure(e);
    s.least = std::min(s.least, value);
    s.greatest = std::max(s.greatest, value);
    s.mean += value;
  }
  s.mean /= static_cast<double>(elements.size());
  return s;
}

}  // namespace

Diagnosis diagnose(const QuadMesh& m, const Positions& positions) {
  Diagnosis d;
  std::vector<HalfEdgeId> edges = m.half_edges();
  std::erase_if(edges, [&m](HalfEdgeId h) { return !m.is_boundary(h) && m.twin(h) < h; });
  const std::vector<FaceId> faces = m.faces();
  d.vertices = m.vertex_count();
  d.edges = static_cast<int>(edges.size());
  d.faces = m.face_count();
  d.components = component_count(m);
  d.boundary_loops = boundary_loop_count(m);
  d.euler_characteristic = d.vertices - d.edges + d.faces;
  d.genus = (2 * d.components - d.boundary_loops - d.euler_characteristic) / 2;

  for (const VertexId v : m.vertices()) {
    ++(m.is_boundary(v) ? d.turns[turn(m, v)] : d.valences[m.valence(v)]);
  }
  for (const auto& [valence, count] : d.valences) {
    if (valence != 4) d.interior_irregular += count;
    if (valence == 2) d.doublets += count;
  }
  for (const auto& [turn, count] : d.turns) {
    if (turn != 0) d.boundary_irregular += count;
  }

  d.scaled_jacobian = statistics(faces, [&](FaceId f) {
    const double value = scaled_jacobian(m, positions, f);
    d.inverted += is_inverted(value) ? 1 : 0;
    return value;
  });
  d.aspect_ratio = statistics(faces, [&](FaceId f) { return aspect_ratio(m, positions, f); });
  d.edge_length = statistics(edges, [&](HalfEdgeId h) { return edge_length(m, positions, h); });
  for (const FaceId f : faces) d.degenerate += area(m, positions, f) > 0 ? 0 : 1;
  d.bounding_box_diagonal = bounding_box_diagonal(m, positions);
  return d;
}

}  // namespace requad::mesh
