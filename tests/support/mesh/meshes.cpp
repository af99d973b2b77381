#include "tests/support/mesh/meshes.hpp"

#include <algorithm>
#include <numeric>

#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/validate.hpp"

namespace requad::tests {

using mesh::FaceId;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Region;
using mesh::VertexId;

Relabelled relabel(const QuadMesh& m, std::mt19937& random) {
  std::vector<int> vertex(static_cast<std::size_t>(m.vertex_capacity()), -1);
  std::vector<int> names(static_cast<std::size_t>(m.vertex_count()));
  std::iota(names.begin(), names.end(), 0);
  std::shuffle(names.begin(), names.end(), random);
  std::size_t next = 0;
  for (const VertexId v : m.vertices()) vertex[v.slot()] = names[next++];

  std::vector<FaceId> order = m.faces();
  std::shuffle(order.begin(), order.end(), random);
  Relabelled result;
  result.half_edge.resize(static_cast<std::size_t>(m.half_edge_capacity()));
  FaceList faces;
  for (std::size_t f = 0; f < order.size(); ++f) {
    const int turn = std::uniform_int_distribution<int>(0, 3)(random);
    std::array<int, 4> corners{};
    for (int k = 0; k < 4; ++k) {
      const HalfEdgeId old = QuadMesh::half_edge(order[f], (k + turn) & 3);
      corners[static_cast<std::size_t>(k)] = vertex[m.origin(old).slot()];
      result.half_edge[old.slot()] = HalfEdgeId(static_cast<int>(4 * f) + k);
    }
    faces.push_back(corners);
  }
  result.mesh = QuadMesh::from_faces(m.vertex_count(), faces);
  return result;
}

mesh::BasicOperation renamed(const mesh::BasicOperation& op, const Relabelled& by) {
  mesh::BasicOperation result = op;
  result.h = by.half_edge[op.h.slot()];
  if (op.last.valid()) result.last = by.half_edge[op.last.slot()];
  return result;
}

mesh::BasicOperation random_operation(const QuadMesh& m, std::mt19937& random) {
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const HalfEdgeId h(pick(m.half_edge_capacity()));
  using Kind = mesh::BasicOperation::Kind;
  const auto kind = static_cast<Kind>(pick(4));
  mesh::BasicOperation op{kind, h, {}, 0};
  if (kind == Kind::split && m.is_live(h)) {
    std::vector<HalfEdgeId> in;
    m.for_each_out(m.origin(h), [&](HalfEdgeId g) { in.push_back(QuadMesh::previous(g)); });
    op.last = in[static_cast<std::size_t>(pick(static_cast<int>(in.size())))];
  }
  return op;
}

FaceList face_list(const QuadMesh& m) {
  FaceList faces;
  for (const FaceId f : m.faces()) {
    std::array<int, 4> face{};
    for (std::size_t k = 0; k < 4; ++k) face[k] = m.corners(f)[k].index();
    faces.push_back(face);
  }
  return faces;
}

namespace {

std::array<int, 4> corners_from(const QuadMesh& m, HalfEdgeId h) {
  return {m.origin(h).index(), m.target(h).index(), m.target(m.next(h)).index(), m.origin(m.previous(h)).index()};
}

}  // namespace

FaceList flipped(const QuadMesh& m, HalfEdgeId h, mesh::Rotation rotation) {
  FaceList faces = face_list(m);
  // The hexagon is u r s v p q, and the edge u-v lies inside it.
  const auto [u, v, p, q] = corners_from(m, h);
  const auto other = corners_from(m, m.twin(h));
  const int r = other[2];
  const int s = other[3];
  auto& left = faces[m.face(h).slot()];
  auto& right = faces[m.face(m.twin(h)).slot()];
  if (rotation == mesh::Rotation::counter_clockwise) {
    left = {u, r, p, q};
    right = {r, s, v, p};
  } else {
    left = {s, v, p, q};
    right = {q, u, r, s};
  }
  return faces;
}

FaceList collapsed(const QuadMesh& m, HalfEdgeId h) {
  FaceList faces = face_list(m);
  const auto corners = corners_from(m, h);
  faces.erase(faces.begin() + m.face(h).index());
  for (auto& face : faces) std::replace(face.begin(), face.end(), corners[2], corners[0]);
  return faces;
}

FaceList split(const QuadMesh& m, const std::vector<FaceId>& sector, HalfEdgeId first, HalfEdgeId last) {
  FaceList faces = face_list(m);
  const int v = m.origin(first).index();
  const int w = m.vertex_capacity();
  for (const FaceId f : sector) std::replace(faces[f.slot()].begin(), faces[f.slot()].end(), v, w);
  faces.push_back({v, m.target(first).index(), w, m.origin(last).index()});
  return faces;
}

std::vector<int> boundary_cycle(const QuadMesh& m) {
  std::vector<int> cycle;
  for (const HalfEdgeId h : m.half_edges()) {
    if (!m.is_boundary(h)) continue;
    for (const HalfEdgeId g : mesh::boundary_loop(m, h)) cycle.push_back(m.origin(g).index());
    break;
  }
  if (!cycle.empty()) std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  return cycle;
}

LegalResult is_legal_result(const QuadMesh& before, const FaceList& faces, int vertices, int gone) {
  // Closes the gap that a removed vertex leaves, and remembers the names.
  std::vector<int> name(static_cast<std::size_t>(vertices));
  std::vector<int> old;
  for (int v = 0; v < vertices; ++v) {
    name[static_cast<std::size_t>(v)] = static_cast<int>(old.size());
    if (v != gone) old.push_back(v);
  }
  FaceList compact = faces;
  for (auto& face : compact) {
    for (int& v : face) v = name[static_cast<std::size_t>(v)];
  }
  LegalResult result;
  result.name = name;
  try {
    result.mesh = QuadMesh::from_faces(static_cast<int>(old.size()), compact);
  } catch (const mesh::MeshError&) {
    return result;
  }
  std::vector<int> cycle = boundary_cycle(result.mesh);
  for (int& v : cycle) v = old[static_cast<std::size_t>(v)];
  if (!cycle.empty()) std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  result.legal = mesh::validate(result.mesh).empty() && cycle == boundary_cycle(before) &&
                 mesh::euler_characteristic(result.mesh) == mesh::euler_characteristic(before);
  return result;
}

QuadMesh torus(int columns, int rows) {
  FaceList faces;
  const auto at = [=](int i, int j) { return (i % columns) * rows + j % rows; };
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  return QuadMesh::from_faces(columns * rows, faces);
}

QuadMesh cube() {
  const FaceList faces{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return QuadMesh::from_faces(8, faces);
}

Region grid(int columns, int rows) {
  FaceList faces;
  const auto at = [=](int i, int j) { return i * (rows + 1) + j; };
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  Region region{QuadMesh::from_faces((columns + 1) * (rows + 1), faces), {}};
  region.root = region.mesh.out(VertexId(at(0, 0)));
  return region;
}

mesh::Positions random_positions(const mesh::QuadMesh& m, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  mesh::Positions result;
  for (int v = 0; v < m.vertex_capacity(); ++v) result.push_back({unit(random), unit(random), unit(random)});
  return result;
}

std::map<int, int> irregular_valences(const mesh::QuadMesh& m) {
  std::map<int, int> result;
  for (const VertexId v : mesh::irregular_vertices(m)) ++result[m.valence(v)];
  return result;
}

void backwards(std::size_t count, const std::function<void(std::size_t)>& task) {
  for (std::size_t i = count; i > 0; --i) task(i - 1);
}

}  // namespace requad::tests
