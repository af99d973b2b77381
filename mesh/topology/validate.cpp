#include "mesh/topology/validate.hpp"

#include <algorithm>
#include <array>

namespace requad::mesh {

namespace {

std::string at(const char* what, int index) { return std::string(what) + " " + std::to_string(index) + ": "; }

}  // namespace

std::vector<Defect> validate(const QuadMesh& m) {
  std::vector<Defect> defects;
  const auto report = [&defects](Defect::Kind kind, std::string message) {
    defects.push_back({kind, std::move(message)});
  };
  using Kind = Defect::Kind;

  const int half_edges = m.half_edge_capacity();
  if (half_edges % 4 != 0) {
    report(Kind::sizes, std::to_string(half_edges) + " half-edges are not four for each face");
    return defects;
  }

  // Ranges first: nothing below may follow an index that was not checked here.
  bool followable = true;
  const auto vertex_in_range = [&m](VertexId v) { return v.index() >= 0 && v.index() < m.vertex_capacity(); };
  for (int f = 0; f < m.face_capacity(); ++f) {
    int live = 0;
    for (int k = 0; k < 4; ++k) live += m.origin(QuadMesh::half_edge(FaceId(f), k)).valid() ? 1 : 0;
    if (live != 0 && live != 4) {
      report(Kind::half_deleted, at("face", f) + std::to_string(4 - live) + " of its corners are deleted");
      followable = false;
    }
  }
  for (int i = 0; i < half_edges; ++i) {
    const HalfEdgeId h(i);
    const VertexId v = m.origin(h);
    if (!v.valid()) continue;
    if (!vertex_in_range(v)) {
      report(Kind::range, at("half-edge", i) + "its origin " + std::to_string(v.index()) + " is no vertex");
      followable = false;
    } else if (!m.out(v).valid()) {
      report(Kind::isolated, at("half-edge", i) + "its origin " + std::to_string(v.index()) + " is deleted");
      followable = false;
    }
    const HalfEdgeId t = m.twin(h);
    if (t.valid() && !m.is_live(t)) {
      report(Kind::range, at("half-edge", i) + "its twin " + std::to_string(t.index()) + " does not exist");
      followable = false;
    }
  }
  for (int v = 0; v < m.vertex_capacity(); ++v) {
    const HalfEdgeId out = m.out(VertexId(v));
    if (out.valid() && !m.is_live(out)) {
      report(Kind::range, at("vertex", v) + "its half-edge " + std::to_string(out.index()) + " does not exist");
      followable = false;
    }
  }
  if (!followable) return defects;

  for (const HalfEdgeId h : m.half_edges()) {
    const HalfEdgeId t = m.twin(h);
    if (!t.valid()) continue;
    if (t == h || m.twin(t) != h) {
      report(Kind::twin, at("half-edge", h.index()) + "twin " + std::to_string(t.index()) + " does not answer");
      followable = false;
    } else if (m.origin(t) != m.target(h)) {
      report(Kind::twin_ends, at("half-edge", h.index()) + "its twin starts at vertex " +
                                  std::to_string(m.origin(t).index()) + ", not at " +
                                  std::to_string(m.target(h).index()));
      followable = false;
    }
  }

  std::vector<int> degree(static_cast<std::size_t>(m.vertex_capacity()), 0);
  std::vector<std::array<int, 2>> edges;
  for (const HalfEdgeId h : m.half_edges()) {
    ++degree[m.origin(h).slot()];
    if (!m.twin(h).valid() || h < m.twin(h)) {
      edges.push_back({std::min(m.origin(h), m.target(h)).index(), std::max(m.origin(h), m.target(h)).index()});
    }
  }
  for (const FaceId f : m.faces()) {
    std::array<VertexId, 4> c = m.corners(f);
    std::sort(c.begin(), c.end());
    if (std::adjacent_find(c.begin(), c.end()) != c.end()) {
      report(Kind::repeated_vertex, at("face", f.index()) + "one vertex occurs twice");
    }
  }
  std::sort(edges.begin(), edges.end());
  for (auto it = edges.begin(); (it = std::adjacent_find(it, edges.end())) != edges.end();) {
    report(Kind::repeated_edge, "vertices " + std::to_string((*it)[0]) + " and " + std::to_string((*it)[1]) +
                                    " are joined by more than one edge");
    it = std::upper_bound(it, edges.end(), *it);
  }

  for (const VertexId v : m.vertices()) {
    if (degree[v.slot()] == 0) {
      report(Kind::isolated, at("vertex", v.index()) + "no face has it");
      continue;
    }
    if (m.origin(m.out(v)) != v) {
      report(Kind::out,
             at("vertex", v.index()) + "its half-edge leaves vertex " + std::to_string(m.origin(m.out(v)).index()));
      continue;
    }
    if (!followable) continue;
    // With twins paired and ends matching, ccw is a partial injection on the half-edges out of v: the walk is bounded.
    int reached = 0;
    bool open = true;
    for (HalfEdgeId h = m.out(v); h.valid() && reached <= degree[v.slot()]; h = m.ccw(h)) {
      ++reached;
      if (m.ccw(h) == m.out(v)) {
        open = false;
        break;
      }
    }
    if (open && !m.is_boundary(m.out(v))) {
      report(Kind::out, at("vertex", v.index()) + "its fan does not start on the boundary");
    } else if (reached != degree[v.slot()]) {
      report(Kind::fan,
             at("vertex", v.index()) + "its " + std::to_string(degree[v.slot()]) + " faces form more than one fan");
    }
  }
  return defects;
}

int euler_characteristic(const QuadMesh& m) { return m.vertex_count() - m.edge_count() + m.face_count(); }

int boundary_loop_count(const QuadMesh& m) {
  std::vector<bool> seen(static_cast<std::size_t>(m.half_edge_capacity()), false);
  int loops = 0;
  for (const HalfEdgeId start : m.half_edges()) {
    if (!m.is_boundary(start) || seen[start.slot()]) continue;
    ++loops;
    for (HalfEdgeId h = start; !seen[h.slot()]; h = m.next_on_boundary(h)) seen[h.slot()] = true;
  }
  return loops;
}

int component_count(const QuadMesh& m) {
  std::vector<bool> seen(static_cast<std::size_t>(m.face_capacity()), false);
  int components = 0;
  std::vector<FaceId> stack;
  for (const FaceId start : m.faces()) {
    if (seen[start.slot()]) continue;
    ++components;
    stack.push_back(start);
    seen[start.slot()] = true;
    while (!stack.empty()) {
      const FaceId f = stack.back();
      stack.pop_back();
      for (int k = 0; k < 4; ++k) {
        const HalfEdgeId t = m.twin(QuadMesh::half_edge(f, k));
        if (!t.valid() || seen[QuadMesh::face(t).slot()]) continue;
        seen[QuadMesh::face(t).slot()] = true;
        stack.push_back(QuadMesh::face(t));
      }
    }
  }
  return components;
}

}  // namespace requad::mesh
