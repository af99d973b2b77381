#include "mesh/files/feature_edges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/files/text_scanner.hpp"

namespace requad::mesh {

namespace {

std::array<VertexId, 2> edge(VertexId a, VertexId b) { return {std::min(a, b), std::max(a, b)}; }

// From a to b along what was an edge in the file: a, b, or by the edge's middle if it was subdivided; empty if it was
// none.
std::vector<VertexId> edge_path(const Surface& surface, VertexId a, VertexId b) {
  if (surface.mesh.adjacent(a, b)) return {a, b};
  // After subdividing, a vertex of the file has edges to the middles of its edges only, and each of those to two of the
  // file's vertices. (Before, no vertex is beyond the file's, and nothing is in the middle.)
  const auto in_file = [&surface](VertexId v) { return surface.file_vertex[v.slot()] < surface.file_vertices; };
  if (!in_file(a) || !in_file(b)) return {};
  for (const VertexId middle : surface.mesh.neighbours(a)) {
    if (!in_file(middle) && surface.mesh.adjacent(middle, b)) return {a, middle, b};
  }
  return {};
}

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
  TextScanner scanner(name, text);
  const auto vertices = static_cast<std::int64_t>(surface.from_file.size());
  const auto vertex = [&](std::string_view word) {
    std::string_view rest;
    const std::int64_t number = scanner.integer(word, rest);
    if (rest.starts_with('/')) rest = {};  // OBJ allows a texture coordinate here
    if (!rest.empty()) scanner.fail(TextScanner::quoted(word) + " is not a vertex");
    if (number == 0 || number > vertices || number < -vertices) {
      scanner.fail("vertex " + std::to_string(number) + " does not exist; there are " + std::to_string(vertices) +
                   ", counted from 1");
    }
    const int slot = surface.from_file[static_cast<std::size_t>(number > 0 ? number - 1 : vertices + number)];
    if (slot < 0) scanner.fail("vertex " + std::to_string(number) + " is in no face");
    return VertexId(slot);
  };
  const auto is_number = [](char c) { return (c >= '0' && c <= '9') || c == '-'; };

  FeatureEdges edges;
  for (bool more = !scanner.at_end_of_line() || scanner.next_line(); more; more = scanner.next_line()) {
    std::string_view word = scanner.word();
    const bool chain = word == "l";
    if (!chain && !is_number(word.front())) {
      const char c = word.front();
      if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) continue;
      scanner.fail(TextScanner::quoted(word) + " is not a vertex");
    }
    if (chain) word = scanner.word();
    int count = 0;
    VertexId last;
    for (; !word.empty(); word = scanner.word()) {
      const VertexId v = vertex(word);
      if (++count > 2 && !chain) scanner.fail("more than two vertices; expected an edge, or a chain after `l`");
      if (count > 1) {
        const std::vector<VertexId> path = edge_path(surface, last, v);
        if (path.empty()) {
          const auto number = [&surface](VertexId u) { return std::to_string(surface.file_vertex[u.slot()] + 1); };
          scanner.fail("no edge joins the vertices " + number(last) + " and " + number(v));
        }
        for (std::size_t i = 1; i < path.size(); ++i) {
          const HalfEdgeId h = surface.mesh.find_half_edge(path[i - 1], path[i]);
          if (h.valid() && !surface.mesh.is_boundary(h)) edges.push_back(edge(path[i - 1], path[i]));
        }
      }
      last = v;
    }
    if (count < 2) scanner.fail("fewer than two vertices; expected an edge");
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

FeatureEdges read_feature_edges(const std::string& path, const Surface& surface) {
  return parse_feature_edges(read_text(path), path, surface);
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
