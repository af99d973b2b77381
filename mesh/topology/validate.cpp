#include "mesh/topology/validate.hpp"

#include <algorithm>
#include <array>

namespace requad::mesh {

namespace {

std::string at(const char* what, int index) { return std::string(what) + " " + std::to_string(index) + ": "; }

class Validator {
 public:
  explicit Validator(const QuadMesh& mesh) : m_(mesh) {}

  // Each check follows only indices that the checks before have found to be in range.
  std::vector<Defect> run() {
    if (!check_sizes() || !check_ranges()) return std::move(defects_);
    half_edges_ = m_.half_edges();
    const bool paired = check_twins();
    check_faces();
    check_edges();
    check_fans(paired);
    return std::move(defects_);
  }

 private:
  using Kind = Defect::Kind;

  void report(Kind kind, std::string message) { defects_.push_back({kind, std::move(message)}); }

  bool check_sizes() {
    if (m_.half_edge_capacity() % 4 == 0) return true;
    report(Kind::sizes, std::to_string(m_.half_edge_capacity()) + " half-edges are not four for each face");
    return false;
  }

  // Whether all indices are those of live elements.
  bool check_ranges() {
    const std::size_t before = defects_.size();
    for (int f = 0; f < m_.face_capacity(); ++f) {
      int live = 0;
      for (int k = 0; k < 4; ++k) live += m_.origin(QuadMesh::half_edge(FaceId(f), k)).valid() ? 1 : 0;
      if (live != 0 && live != 4)
        report(Kind::half_deleted, at("face", f) + std::to_string(4 - live) + " of its corners are deleted");
    }
    for (int i = 0; i < m_.half_edge_capacity(); ++i) {
      const HalfEdgeId h(i);
      const VertexId v = m_.origin(h);
      if (!v.valid()) continue;
      if (v.index() >= m_.vertex_capacity()) {
        report(Kind::range, at("half-edge", i) + "its origin " + std::to_string(v.index()) + " is no vertex");
      } else if (!m_.out(v).valid()) {
        report(Kind::isolated, at("half-edge", i) + "its origin " + std::to_string(v.index()) + " is deleted");
      }
      const HalfEdgeId t = m_.twin(h);
      if (t.valid() && !m_.is_live(t))
        report(Kind::range, at("half-edge", i) + "its twin " + std::to_string(t.index()) + " does not exist");
    }
    for (int v = 0; v < m_.vertex_capacity(); ++v) {
      const HalfEdgeId out = m_.out(VertexId(v));
      if (out.valid() && !m_.is_live(out))
        report(Kind::range, at("vertex", v) + "its half-edge " + std::to_string(out.index()) + " does not exist");
    }
    return defects_.size() == before;
  }

  // Whether twins are paired and have the same ends.
  bool check_twins() {
    const std::size_t before = defects_.size();
    for (const HalfEdgeId h : half_edges_) {
      const HalfEdgeId t = m_.twin(h);
      if (!t.valid()) continue;
      if (t == h || m_.twin(t) != h) {
        report(Kind::twin, at("half-edge", h.index()) + "twin " + std::to_string(t.index()) + " does not answer");
      } else if (m_.origin(t) != m_.target(h)) {
        report(Kind::twin_ends, at("half-edge", h.index()) + "its twin starts at vertex " +
                                    std::to_string(m_.origin(t).index()) + ", not at " +
                                    std::to_string(m_.target(h).index()));
      }
    }
    return defects_.size() == before;
  }

  void check_faces() {
    for (const FaceId f : m_.faces()) {
      std::array<VertexId, 4> c = m_.corners(f);
      std::sort(c.begin(), c.end());
      if (std::adjacent_find(c.begin(), c.end()) != c.end())
        report(Kind::repeated_vertex, at("face", f.index()) + "one vertex occurs twice");
    }
  }

  void check_edges() {
    std::vector<std::array<int, 2>> edges;
    for (const HalfEdgeId h : half_edges_) {
      if (!m_.twin(h).valid() || h < m_.twin(h))
        edges.push_back({std::min(m_.origin(h), m_.target(h)).index(), std::max(m_.origin(h), m_.target(h)).index()});
    }
    std::sort(edges.begin(), edges.end());
    for (auto it = edges.begin(); (it = std::adjacent_find(it, edges.end())) != edges.end();) {
      report(Kind::repeated_edge, "vertices " + std::to_string((*it)[0]) + " and " + std::to_string((*it)[1]) +
                                      " are joined by more than one edge");
      it = std::upper_bound(it, edges.end(), *it);
    }
  }

  // `paired`: whether twins are in order, so that fans can be walked.
  void check_fans(bool paired) {
    std::vector<int> degree(static_cast<std::size_t>(m_.vertex_capacity()), 0);
    for (const HalfEdgeId h : half_edges_) ++degree[m_.origin(h).slot()];
    for (const VertexId v : m_.vertices()) {
      const int half_edges = degree[v.slot()];
      if (half_edges == 0) {
        report(Kind::isolated, at("vertex", v.index()) + "no face has it");
      } else if (m_.origin(m_.out(v)) != v) {
        report(Kind::out,
               at("vertex", v.index()) + "its half-edge leaves vertex " + std::to_string(m_.origin(m_.out(v)).index()));
      } else if (paired) {
        check_fan(v, half_edges);
      }
    }
  }

  // `half_edges`: how many leave v.
  void check_fan(VertexId v, int half_edges) {
    // Since twins are paired and have the same ends, ccw is injective on the half-edges out of v, and the walk is
    // bounded.
    int reached = 0;
    bool open = true;
    for (HalfEdgeId h = m_.out(v); h.valid() && reached <= half_edges; h = m_.ccw(h)) {
      ++reached;
      if (m_.ccw(h) == m_.out(v)) {
        open = false;
        break;
      }
    }
    if (open && !m_.is_boundary(m_.out(v))) {
      report(Kind::out, at("vertex", v.index()) + "its fan does not start on the boundary");
    } else if (reached != half_edges) {
      report(Kind::fan,
             at("vertex", v.index()) + "its " + std::to_string(half_edges) + " faces form more than one fan");
    }
  }

  const QuadMesh& m_;
  std::vector<HalfEdgeId> half_edges_;  // the live ones
  std::vector<Defect> defects_;
};

}  // namespace

std::vector<Defect> validate(const QuadMesh& m) { return Validator(m).run(); }

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
