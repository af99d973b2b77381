#include "mesh/topology/quad_mesh.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace requad::mesh {

namespace {

std::string edge_name(int a, int b) { return "edge " + std::to_string(a) + "-" + std::to_string(b); }

// Throws for the first edge, in the order of its ends, that has more than two faces, or two that are not oriented
// alike. Precondition: there is such an edge.
[[noreturn]] void fail_at_first_edge(std::span<const std::array<int, 4>> faces) {
  struct Side {
    int low, high;
    std::size_t half_edge;
    bool forward;
  };
  std::vector<Side> sides;
  sides.reserve(4 * faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 4; ++k) {
      const int a = faces[f][k];
      const int b = faces[f][(k + 1) % 4];
      sides.push_back({std::min(a, b), std::max(a, b), 4 * f + k, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    return std::tie(x.low, x.high, x.half_edge) < std::tie(y.low, y.high, y.half_edge);
  });
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high;) ++end;
    const std::string name = edge_name(sides[i].low, sides[i].high);
    if (end - i > 2) throw MeshError(name + " has " + std::to_string(end - i) + " faces");
    if (end - i == 2 && sides[i].forward == sides[i + 1].forward) {
      throw MeshError(name + ": faces " + std::to_string(sides[i].half_edge / 4) + " and " +
                      std::to_string(sides[i + 1].half_edge / 4) + " are not oriented alike");
    }
  }
  throw std::logic_error("from_faces() refused an edge that is in order");
}

}  // namespace

QuadMesh QuadMesh::from_faces(int vertex_count, std::span<const std::array<int, 4>> faces) {
  constexpr std::size_t kMostFaces = (std::size_t{1} << 29) - 1;
  if (faces.size() > kMostFaces) throw MeshError("too many faces: " + std::to_string(faces.size()));
  QuadMesh mesh;
  mesh.sides_.resize(4 * faces.size());
  mesh.out_.resize(static_cast<std::size_t>(vertex_count));
  std::vector<int> degree(static_cast<std::size_t>(vertex_count), 0);  // number of faces at each vertex
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 4; ++k) {
      const int a = faces[f][k];
      if (a < 0 || a >= vertex_count) {
        throw MeshError("face " + std::to_string(f) + ": vertex " + std::to_string(a) + " is not in 0.." +
                        std::to_string(vertex_count - 1));
      }
      if (a == faces[f][(k + 1) % 4] || a == faces[f][(k + 2) % 4]) {
        throw MeshError("face " + std::to_string(f) + ": vertex " + std::to_string(a) + " occurs twice");
      }
      const HalfEdgeId h(static_cast<std::int32_t>(4 * f + k));
      mesh.sides_[h.slot()].origin = VertexId(a);
      mesh.out_[static_cast<std::size_t>(a)] = h;
      ++degree[static_cast<std::size_t>(a)];
    }
  }
  if (!mesh.pair_twins(degree)) fail_at_first_edge(faces);

  // The fan of a boundary vertex starts on the boundary; then it must hold all faces of the vertex.
  for (int i = 0; i < mesh.half_edge_capacity(); ++i) {
    const HalfEdgeId h(i);
    if (mesh.is_boundary(h)) mesh.out_[mesh.origin(h).slot()] = h;
  }
  for (int v = 0; v < vertex_count; ++v) {
    const VertexId vertex(v);
    if (!mesh.out(vertex).valid()) throw MeshError("vertex " + std::to_string(v) + " has no face");
    if (mesh.face_valence(vertex) != degree[vertex.slot()]) {
      throw MeshError("vertex " + std::to_string(v) + " is not manifold: its faces form more than one fan");
    }
  }
  return mesh;
}

bool QuadMesh::pair_twins(const std::vector<int>& degree) {
  // The first half-edge of an edge joins a list that one end of the edge heads, where the second one finds it. That end
  // is the one of lower degree: on a surface of bounded genus the lower degrees of all edges sum to O(F), whatever the
  // valences (N. Chiba, T. Nishizeki, Arboricity and subgraph listing algorithms, 1985).
  std::vector<HalfEdgeId> head(out_.size());
  std::vector<HalfEdgeId> following(sides_.size());
  const auto rank = [&degree](VertexId v) { return std::pair(degree[v.slot()], v); };
  bool paired = true;
  for (int i = 0; i < half_edge_capacity(); ++i) {
    const HalfEdgeId h(i);
    const VertexId from = origin(h);
    const VertexId to = target(h);
    HalfEdgeId& first = head[std::min(rank(from), rank(to)).second.slot()];
    HalfEdgeId other = first;
    while (other.valid() && !(origin(other) == to && target(other) == from)) {
      paired = paired && !(origin(other) == from && target(other) == to);
      other = following[other.slot()];
    }
    if (!other.valid()) {
      following[h.slot()] = first;
      first = h;
    } else {
      paired = paired && !twin(other).valid();
      sides_[h.slot()].twin = other;
      sides_[other.slot()].twin = h;
    }
  }
  return paired;
}

QuadMesh QuadMesh::from_arrays_unchecked(const std::vector<HalfEdgeId>& twin, const std::vector<VertexId>& origin,
                                         std::vector<HalfEdgeId> out) {
  QuadMesh mesh;
  mesh.sides_.reserve(twin.size());
  for (std::size_t h = 0; h < twin.size(); ++h) mesh.sides_.push_back({twin[h], origin[h]});
  mesh.out_ = std::move(out);
  for (std::size_t f = 0; 4 * f + 3 < mesh.sides_.size(); ++f) {
    if (!mesh.sides_[4 * f].origin.valid()) mesh.free_faces_.emplace_back(static_cast<std::int32_t>(f));
  }
  for (std::size_t v = 0; v < mesh.out_.size(); ++v) {
    if (!mesh.out_[v].valid()) mesh.free_vertices_.emplace_back(static_cast<std::int32_t>(v));
  }
  return mesh;
}

void QuadMesh::reserve(int faces, int vertices) {
  sides_.reserve(4 * static_cast<std::size_t>(faces));
  out_.reserve(static_cast<std::size_t>(vertices));
  free_faces_.reserve(static_cast<std::size_t>(faces));
  free_vertices_.reserve(static_cast<std::size_t>(vertices));
}

std::size_t QuadMesh::bytes() const {
  return sides_.capacity() * sizeof(Side) + out_.capacity() * sizeof(HalfEdgeId) +
         free_faces_.capacity() * sizeof(FaceId) + free_vertices_.capacity() * sizeof(VertexId);
}

int QuadMesh::edge_count() const {
  int twice = 0;
  for (const HalfEdgeId h : half_edges()) twice += is_boundary(h) ? 2 : 1;
  return twice / 2;
}

std::vector<VertexId> QuadMesh::vertices() const {
  std::vector<VertexId> live;
  live.reserve(static_cast<std::size_t>(vertex_count()));
  for (int v = 0; v < vertex_capacity(); ++v) {
    if (is_live(VertexId(v))) live.emplace_back(v);
  }
  return live;
}

std::vector<FaceId> QuadMesh::faces() const {
  std::vector<FaceId> live;
  live.reserve(static_cast<std::size_t>(face_count()));
  for (int f = 0; f < face_capacity(); ++f) {
    if (is_live(FaceId(f))) live.emplace_back(f);
  }
  return live;
}

std::vector<HalfEdgeId> QuadMesh::half_edges() const {
  std::vector<HalfEdgeId> live;
  live.reserve(4 * static_cast<std::size_t>(face_count()));
  for (int h = 0; h < half_edge_capacity(); ++h) {
    if (is_live(HalfEdgeId(h))) live.emplace_back(h);
  }
  return live;
}

std::array<VertexId, 4> QuadMesh::corners(FaceId f) const {
  return {origin(half_edge(f, 0)), origin(half_edge(f, 1)), origin(half_edge(f, 2)), origin(half_edge(f, 3))};
}

std::vector<VertexId> QuadMesh::neighbours(VertexId v) const {
  std::vector<VertexId> around;
  HalfEdgeId last;
  for_each_out(v, [&](HalfEdgeId h) {
    around.push_back(target(h));
    last = h;
  });
  if (is_boundary(v)) around.push_back(origin(previous(last)));
  return around;
}

bool QuadMesh::adjacent(VertexId a, VertexId b) const {
  // Each edge of an interior vertex has a half-edge out of it, but the last edge of a boundary vertex has none.
  if (find_half_edge(a, b).valid()) return true;
  return is_boundary(a) && find_half_edge(b, a).valid();
}

HalfEdgeId QuadMesh::find_half_edge(VertexId a, VertexId b) const {
  const HalfEdgeId first = out(a);
  HalfEdgeId h = first;
  do {
    if (target(h) == b) return h;
    h = ccw(h);
  } while (h.valid() && h != first);
  return HalfEdgeId();
}

std::vector<std::array<int, 4>> QuadMesh::compact_faces() const {
  std::vector<int> number(out_.size(), -1);
  int count = 0;
  for (const VertexId v : vertices()) number[v.slot()] = count++;
  std::vector<std::array<int, 4>> result;
  for (const FaceId f : faces()) {
    std::array<int, 4> face{};
    for (int k = 0; k < 4; ++k) face[static_cast<std::size_t>(k)] = number[origin(half_edge(f, k)).slot()];
    result.push_back(face);
  }
  return result;
}

namespace {

// The `count` least ids that are not in the list, in increasing order. Throws MeshError unless the list holds different
// ids below `count` and its own size together.
template <class Id>
std::vector<Id> ids_beside(const std::vector<Id>& free_ids, int count, const char* what) {
  std::vector<bool> taken(static_cast<std::size_t>(count) + free_ids.size(), false);
  for (const Id id : free_ids) {
    if (!id.valid() || id.slot() >= taken.size() || taken[id.slot()])
      throw MeshError(std::string(what) + " " + std::to_string(id.index()) + " cannot be free");
    taken[id.slot()] = true;
  }
  std::vector<Id> ids;
  ids.reserve(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (!taken[i]) ids.emplace_back(static_cast<std::int32_t>(i));
  }
  return ids;
}

}  // namespace

QuadMesh QuadMesh::with_free_ids(std::vector<FaceId> free_faces, std::vector<VertexId> free_vertices) const {
  const std::vector<FaceId> face_ids = ids_beside(free_faces, face_capacity(), "face");
  const std::vector<VertexId> vertex_ids = ids_beside(free_vertices, vertex_capacity(), "vertex");
  const auto renamed = [&face_ids](HalfEdgeId h) {
    return h.valid() ? half_edge(face_ids[face(h).slot()], h.index() & 3) : h;
  };
  QuadMesh mesh;
  mesh.sides_.resize(4 * (face_ids.size() + free_faces.size()));
  mesh.out_.resize(vertex_ids.size() + free_vertices.size());
  for (const HalfEdgeId h : half_edges()) {
    mesh.sides_[renamed(h).slot()] = {renamed(twin(h)), vertex_ids[origin(h).slot()]};
  }
  for (const VertexId v : vertices()) mesh.out_[vertex_ids[v.slot()].slot()] = renamed(out(v));
  mesh.free_faces_ = std::move(free_faces);
  mesh.free_vertices_ = std::move(free_vertices);
  return mesh;
}

namespace {

// The number of free ids at the top of the arrays that wait at the bottom of the free list, in the order in which
// growing the arrays would hand them out. Without them a mesh would behave the same.
template <class Id>
std::size_t trailing_free_ids(const std::vector<Id>& free_ids, std::size_t capacity) {
  std::size_t n = 0;
  while (n < free_ids.size() && free_ids[n].slot() == capacity - 1 - n) ++n;
  return n;
}

template <class T>
bool equal_up_to(const std::vector<T>& a, std::size_t drop_a, const std::vector<T>& b, std::size_t drop_b,
                 bool from_front) {
  const auto first = [from_front](const std::vector<T>& v, std::size_t drop) {
    return v.begin() + static_cast<std::ptrdiff_t>(from_front ? drop : 0);
  };
  const auto last = [from_front](const std::vector<T>& v, std::size_t drop) {
    return v.end() - static_cast<std::ptrdiff_t>(from_front ? 0 : drop);
  };
  return std::equal(first(a, drop_a), last(a, drop_a), first(b, drop_b), last(b, drop_b));
}

}  // namespace

bool operator==(const QuadMesh& a, const QuadMesh& b) {
  const std::size_t faces_a = trailing_free_ids(a.free_faces_, a.sides_.size() / 4);
  const std::size_t faces_b = trailing_free_ids(b.free_faces_, b.sides_.size() / 4);
  const std::size_t vertices_a = trailing_free_ids(a.free_vertices_, a.out_.size());
  const std::size_t vertices_b = trailing_free_ids(b.free_vertices_, b.out_.size());
  return a.out_.size() - vertices_a == b.out_.size() - vertices_b &&
         equal_up_to(a.sides_, 4 * faces_a, b.sides_, 4 * faces_b, false) &&
         equal_up_to(a.free_faces_, faces_a, b.free_faces_, faces_b, true) &&
         equal_up_to(a.free_vertices_, vertices_a, b.free_vertices_, vertices_b, true);
}

std::vector<VertexId> irregular_vertices(const QuadMesh& m) {
  std::vector<VertexId> found;
  for (const VertexId v : m.vertices()) {
    if (is_irregular(m, v)) found.push_back(v);
  }
  return found;
}

std::multiset<int> sorted_irregular_valences(const QuadMesh& m) {
  std::multiset<int> valences;
  for (const VertexId v : irregular_vertices(m)) valences.insert(m.face_valence(v));
  return valences;
}

}  // namespace requad::mesh
