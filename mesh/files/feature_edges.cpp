#include "mesh/files/feature_edges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/text/text_scanner.hpp"

namespace requad::mesh {

namespace {

std::array<VertexId, 2> edge(VertexId a, VertexId b) { return {std::min(a, b), std::max(a, b)}; }

class FeatureEdgeReader {
 public:
  FeatureEdgeReader(std::string_view text, const std::string& name, const Surface& surface)
      : scanner_(name, text), surface_(surface) {}

  FeatureEdges read() {
    for (bool more = !scanner_.at_end_of_line() || scanner_.next_line(); more; more = scanner_.next_line()) read_line();
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    return std::move(edges_);
  }

 private:
  void read_line() {
    std::string_view word = scanner_.word();
    const bool chain = word == "l";
    const auto is_number = [](char c) { return (c >= '0' && c <= '9') || c == '-'; };
    if (!chain && !is_number(word.front())) {
      const char c = word.front();
      if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) return;
      scanner_.fail(TextScanner::quoted(word) + " is not a vertex");
    }
    if (chain) word = scanner_.word();
    int count = 0;
    VertexId last;
    for (; !word.empty(); word = scanner_.word()) {
      const VertexId v = vertex(word);
      if (++count > 2 && !chain) scanner_.fail("more than two vertices; expected an edge, or a chain after `l`");
      if (count > 1) add_edge(last, v);
      last = v;
    }
    if (count < 2) scanner_.fail("fewer than two vertices; expected an edge");
  }

  VertexId vertex(std::string_view word) const {
    const auto vertices = static_cast<std::int64_t>(surface_.from_file.size());
    std::string_view rest;
    const std::int64_t number = scanner_.integer(word, rest);
    if (rest.starts_with('/')) rest = {};  // OBJ allows a texture coordinate here
    if (!rest.empty()) scanner_.fail(TextScanner::quoted(word) + " is not a vertex");
    if (number == 0 || number > vertices || number < -vertices) {
      scanner_.fail("vertex " + std::to_string(number) + " does not exist; there are " + std::to_string(vertices) +
                    ", counted from 1");
    }
    const int slot = surface_.from_file[static_cast<std::size_t>(number > 0 ? number - 1 : vertices + number)];
    if (slot < 0) scanner_.fail("vertex " + std::to_string(number) + " is in no face");
    return VertexId(slot);
  }

  void add_edge(VertexId a, VertexId b) {
    const std::vector<VertexId> path = edge_path(a, b);
    if (path.empty()) {
      const auto number = [this](VertexId v) { return std::to_string(surface_.file_vertex[v.slot()] + 1); };
      scanner_.fail("no edge joins the vertices " + number(a) + " and " + number(b));
    }
    for (std::size_t i = 1; i < path.size(); ++i) {
      const HalfEdgeId h = surface_.mesh.find_half_edge(path[i - 1], path[i]);
      if (h.valid() && !surface_.mesh.is_boundary(h)) edges_.push_back(edge(path[i - 1], path[i]));
    }
  }

  // The path from a to b along an edge of the file: a, b; or a, the middle of the edge, b if it was subdivided; empty
  // if the file has no such edge.
  std::vector<VertexId> edge_path(VertexId a, VertexId b) const {
    const QuadMesh& m = surface_.mesh;
    if (m.adjacent(a, b)) return {a, b};
    // In a subdivided mesh the neighbours of a vertex of the file are the middles of its edges, and each middle is
    // adjacent to just two vertices of the file. (In other meshes all vertices are in the file.)
    const auto in_file = [this](VertexId v) { return surface_.file_vertex[v.slot()] < surface_.file_vertices; };
    if (!in_file(a) || !in_file(b)) return {};
    for (const VertexId middle : m.neighbours(a)) {
      if (!in_file(middle) && m.adjacent(middle, b)) return {a, middle, b};
    }
    return {};
  }

  TextScanner scanner_;
  const Surface& surface_;
  FeatureEdges edges_;
};

}  // namespace

FeatureEdges sharp_edges(const QuadMesh& m, const Positions& positions, double degrees) {
  FeatureEdges edges;
  const double least = degrees * std::numbers::pi / 180;
  for (const HalfEdgeId h : m.half_edges()) {
    if (m.is_boundary(h) || m.twin(h) < h) continue;
    if (std::abs(dihedral_angle(m, positions, h)) >= least) edges.push_back(edge(m.origin(h), m.target(h)));
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

FeatureEdges parse_feature_edges(std::string_view text, const std::string& name, const Surface& surface) {
  return FeatureEdgeReader(text, name, surface).read();
}

FeatureEdges texture_seams(const Surface& surface) {
  const QuadMesh& m = surface.mesh;
  const Attributes::Values& uvs = surface.attributes.uvs;
  FeatureEdges edges;
  if (uvs.at_corner.empty()) return edges;
  const auto same = [&uvs](HalfEdgeId a, HalfEdgeId b) {
    const int i = uvs.at(a.slot()), j = uvs.at(b.slot());
    return i == j ||
           (i >= 0 && j >= 0 && uvs.numbers[static_cast<std::size_t>(i)] == uvs.numbers[static_cast<std::size_t>(j)]);
  };
  for (const HalfEdgeId h : m.half_edges()) {
    const HalfEdgeId t = m.twin(h);
    if (!t.valid() || t < h || (same(h, QuadMesh::next(t)) && same(QuadMesh::next(h), t))) continue;
    edges.push_back({std::min(m.origin(h), m.target(h)), std::max(m.origin(h), m.target(h))});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

bool has_texture_by_faces(const Surface& surface, const FeatureEdges& seams) {
  // A closed mesh has two edges for each face.
  return 10 * seams.size() >= 3 * 2 * static_cast<std::size_t>(surface.mesh.face_count()) && !seams.empty();
}

std::vector<VertexId> feature_corners(const QuadMesh& m, const FeatureEdges& edges) {
  std::vector<int> count(static_cast<std::size_t>(m.vertex_capacity()), 0);
  for (const auto& [a, b] : edges) {
    ++count[a.slot()];
    ++count[b.slot()];
  }
  std::vector<VertexId> corners;
  for (const VertexId v : m.vertices()) {
    const int here = count[v.slot()] + (m.is_boundary(v) ? 2 : 0);
    if (here != 0 && here != 2) corners.push_back(v);
  }
  return corners;
}

}  // namespace requad::mesh
