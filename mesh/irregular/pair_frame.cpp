#include "mesh/irregular/pair_frame.hpp"

#include <algorithm>
#include <unordered_map>

#include "mesh/topology/separatrix.hpp"

namespace requad::mesh {

namespace {

// Counter-clockwise and clockwise neighbours of a half-edge at an interior vertex.
HalfEdgeId left_of(const QuadMesh& m, HalfEdgeId arriving) { return m.next(arriving); }
HalfEdgeId right_of(const QuadMesh& m, HalfEdgeId arriving) {
  const HalfEdgeId back = m.twin(arriving);
  return back.valid() ? m.ccw(back) : back;
}

bool regular(const QuadMesh& m, VertexId v) { return !m.is_boundary(v) && m.face_valence(v) == 4; }

}  // namespace

std::optional<PairFrame> frame_at(const QuadMesh& m, HalfEdgeId first_leg, int d1, int d2) {
  const HalfEdgeId second_leg = m.ccw(first_leg);
  if (!second_leg.valid()) return std::nullopt;
  PairFrame frame{first_leg, second_leg, m.origin(first_leg), VertexId(), d1, d2};
  if (frame.degenerate()) {
    const auto end = end_of_straight_path(m, d2 == 0 ? second_leg : first_leg, frame.distance());
    if (!end) return std::nullopt;
    frame.v2 = m.target(*end);
    return frame;
  }
  // Both ways round the rectangle must end at the same vertex, turning at regular corners.
  const auto to_x = end_of_straight_path(m, first_leg, d2);
  const auto to_y = end_of_straight_path(m, second_leg, d1);
  if (!to_x || !to_y || !regular(m, m.target(*to_x)) || !regular(m, m.target(*to_y))) return std::nullopt;
  const auto from_x = end_of_straight_path(m, left_of(m, *to_x), d1);
  const auto from_y = end_of_straight_path(m, right_of(m, *to_y), d2);
  // R_alpha has one corner at v2: the two ways arrive there by edges that follow each other.
  if (!from_x || !from_y || m.twin(*from_y) != m.cw(m.twin(*from_x))) return std::nullopt;
  frame.v2 = m.target(*from_x);
  return frame;
}

std::vector<PairFrame> find_frames(const QuadMesh& m, VertexId v1, VertexId v2) {
  // Half-edges that point to v2 along its separatrices, with their distance from it.
  std::unordered_map<HalfEdgeId, int> towards_v2;
  m.for_each_out(v2, [&](HalfEdgeId h) {
    int distance = 0;
    for (const HalfEdgeId g : trace(m, h).path) {
      ++distance;
      if (m.twin(g).valid()) towards_v2.emplace(m.twin(g), distance);
    }
  });
  std::vector<PairFrame> frames;
  const auto add = [&](HalfEdgeId first_leg, int d1, int d2) {
    const auto frame = frame_at(m, first_leg, d1, d2);
    if (frame && frame->v2 == v2) frames.push_back(*frame);
  };
  m.for_each_out(v1, [&](HalfEdgeId leg) {
    const Separatrix s = trace(m, leg);
    for (int i = 0; i < s.length(); ++i) {
      const HalfEdgeId arriving = s.path[static_cast<std::size_t>(i)];
      if (m.target(arriving) == v2) {
        add(leg, 0, i + 1);
        add(m.cw(leg), i + 1, 0);
        break;
      }
      const auto turn = towards_v2.find(left_of(m, arriving));
      if (turn != towards_v2.end() && regular(m, m.target(arriving))) add(leg, turn->second, i + 1);
    }
  });
  return frames;
}

PairFrame seen_from_other_end(const QuadMesh& m, const PairFrame& f) {
  PairFrame other{HalfEdgeId(), HalfEdgeId(), f.v2, f.v1, f.d1, f.d2};
  if (f.d1 == 0) {
    other.first_leg = m.twin(*end_of_straight_path(m, f.first_leg, f.d2));
  } else {
    // The last half-edge arrives at v2 along its second leg.
    HalfEdgeId start = f.second_leg;
    if (f.d2 > 0) start = left_of(m, *end_of_straight_path(m, f.first_leg, f.d2));
    other.first_leg = m.cw(m.twin(*end_of_straight_path(m, start, f.d1)));
  }
  other.second_leg = m.ccw(other.first_leg);
  return other;
}

std::array<PairFrame, 2> both_ends(const QuadMesh& m, const PairFrame& f) { return {f, seen_from_other_end(m, f)}; }

std::vector<HalfEdgeId> outward(const QuadMesh& m, const PairFrame& f) {
  std::vector<HalfEdgeId> result;
  for (HalfEdgeId h = m.ccw(f.second_leg); h != f.first_leg; h = m.ccw(h)) result.push_back(h);
  return result;
}

std::vector<HalfEdgeId> outward_of_both(const QuadMesh& m, const PairFrame& f) {
  std::vector<HalfEdgeId> result;
  if (f.merged()) {
    HalfEdgeId h = f.first_leg;
    do {
      result.push_back(h);
      h = m.ccw(h);
    } while (h != f.first_leg);
    return result;
  }
  for (const PairFrame& end : both_ends(m, f)) {
    const std::vector<HalfEdgeId> of_end = outward(m, end);
    result.insert(result.end(), of_end.begin(), of_end.end());
  }
  return result;
}

std::vector<HalfEdgeId> path_between(const QuadMesh& m, const PairFrame& f) {
  std::vector<HalfEdgeId> path;
  const auto go = [&](HalfEdgeId h, int steps) {
    for (int i = 0; i < steps; ++i) {
      path.push_back(h);
      if (i + 1 < steps) h = m.straight(h);
    }
  };
  go(f.first_leg, f.d2);
  if (f.d1 > 0) go(f.d2 > 0 ? left_of(m, path.back()) : f.second_leg, f.d1);
  return path;
}

std::vector<HalfEdgeId> rim(const QuadMesh& m, const PairFrame& f) {
  if (f.merged()) return {};
  std::vector<HalfEdgeId> path = path_between(m, f);
  const std::vector<HalfEdgeId> back = path_between(m, seen_from_other_end(m, f));
  path.insert(path.end(), back.begin(), back.end());
  return path;
}

std::optional<std::vector<FaceId>> grid(const QuadMesh& m, const PairFrame& f) {
  std::vector<FaceId> faces;
  const auto clean = [&](VertexId v) { return v == f.v1 || v == f.v2 || regular(m, v); };
  if (f.degenerate()) {
    HalfEdgeId h = f.d2 == 0 ? f.second_leg : f.first_leg;
    for (int i = 0; i < f.distance(); ++i) {
      if (i > 0) h = m.straight(h);
      if (!clean(m.target(h)) || (m.target(h) == f.v2) != (i + 1 == f.distance())) return std::nullopt;
    }
    return faces;
  }
  HalfEdgeId row = f.first_leg;  // the bottom edge of the row's first face
  for (int j = 0; j < f.d1; ++j) {
    HalfEdgeId h = row;
    for (int i = 0; i < f.d2; ++i) {
      for (const VertexId v : m.corners(m.face(h))) {
        if (!clean(v)) return std::nullopt;
      }
      faces.push_back(m.face(h));
      // The next face of the row shares next(h); its bottom edge continues h.
      if (i + 1 < f.d2) h = m.next(m.twin(m.next(h)));
    }
    if (j + 1 == f.d1 && m.target(m.next(h)) != f.v2) return std::nullopt;
    if (j + 1 < f.d1) row = m.twin(m.opposite(row));
  }
  return faces;
}

std::vector<FaceId> ring(const QuadMesh& m, const PairFrame& f) {
  std::vector<VertexId> core{f.v1};
  for (const HalfEdgeId h : rim(m, f)) core.push_back(m.target(h));
  for (const FaceId face : grid(m, f).value_or(std::vector<FaceId>{})) {
    for (const VertexId v : m.corners(face)) core.push_back(v);
  }
  std::vector<FaceId> faces;
  for (const VertexId v : core) m.for_each_out(v, [&](HalfEdgeId h) { faces.push_back(QuadMesh::face(h)); });
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

namespace {

// The vertices of some faces, each once, in the order of their ids.
std::vector<VertexId> vertices_of(const QuadMesh& m, const std::vector<FaceId>& faces) {
  std::vector<VertexId> vertices;
  for (const FaceId face : faces) {
    for (const VertexId v : m.corners(face)) vertices.push_back(v);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

// Whether the ring has as many faces and vertices as it has in the plane. There each edge of the rim has a face outside
// R_alpha. At v1 and v2, and at the other two corners of a rectangle, there are faces that have no edge of the rim: in
// all l(v1) + l(v2) - 4 of them. A face of the first kind has one edge on the outer boundary, one of the second has two.
bool has_planar_size(const QuadMesh& m, const PairFrame& f, const std::vector<FaceId>& faces,
                     const std::vector<VertexId>& vertices) {
  const int rim_edges = 2 * f.distance();
  const int l1 = m.face_valence(f.v1);
  const int corners = f.merged() ? l1 : l1 + m.face_valence(f.v2) - 4;
  const int face_count = f.d1 * f.d2 + rim_edges + corners;
  const int vertex_count = (f.d1 + 1) * (f.d2 + 1) + rim_edges + 2 * corners;
  return static_cast<int>(faces.size()) == face_count && static_cast<int>(vertices.size()) == vertex_count;
}

}  // namespace

bool overlaps_itself(const QuadMesh& m, const PairFrame& f) {
  if (!f.merged() && !grid(m, f)) return false;
  const std::vector<FaceId> faces = ring(m, f);
  return !has_planar_size(m, f, faces, vertices_of(m, faces));
}

bool has_room(const QuadMesh& m, const PairFrame& f) {
  if (!f.merged() && !grid(m, f)) return false;
  const std::vector<FaceId> faces = ring(m, f);
  const std::vector<VertexId> vertices = vertices_of(m, faces);
  if (!has_planar_size(m, f, faces, vertices)) return false;
  const auto in_ring = [&](const auto& list, auto id) { return std::binary_search(list.begin(), list.end(), id); };
  for (const VertexId v : vertices) {
    if (v != f.v1 && v != f.v2 && !regular(m, v)) return false;
    bool induced = true;
    m.for_each_out(v, [&](HalfEdgeId h) {
      const bool of_a_face = in_ring(faces, QuadMesh::face(h)) || in_ring(faces, QuadMesh::face(m.twin(h)));
      induced = induced && (of_a_face || !in_ring(vertices, m.target(h)));
    });
    if (!induced) return false;
  }
  return true;
}

}  // namespace requad::mesh
