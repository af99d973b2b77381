// Distances in edges, by breadth-first search.
#pragma once

#include <span>
#include <vector>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

// Distances from some vertices of a mesh, as far as they are needed. The working memory, an integer for each vertex, is
// kept from one search to the next, and only the entries that were used are cleared: so a search costs O(its edges),
// whatever the size of the mesh.
class BreadthFirstDistances {
 public:
  // Measures distances in edges from the sources, and forgets those measured before.
  //   enters(v)    whether v is measured at all; sources always are
  //   passes(v)    whether the search continues from v; it always does from sources
  //   done(v, d)   is called for each vertex in order of its distance d, before the search continues from it; the
  //                search ends when it returns true
  template <class Enters, class Passes, class Done>
  void measure(const QuadMesh& mesh, std::span<const VertexId> sources, Enters&& enters, Passes&& passes, Done&& done) {
    for (const VertexId v : met_) distance_[v.slot()] = -1;
    met_.clear();
    distance_.resize(static_cast<std::size_t>(mesh.vertex_capacity()), -1);
    for (const VertexId v : sources) {
      if (distance_[v.slot()] < 0) meet(v, 0);
    }
    for (std::size_t i = 0; i < met_.size(); ++i) {  // NOLINT(modernize-loop-convert): it grows
      const VertexId v = met_[i];
      const int d = distance_[v.slot()];
      if (done(v, d)) return;
      if (d > 0 && !passes(v)) continue;
      const auto visit = [&](VertexId w) {
        if (distance_[w.slot()] < 0 && enters(w)) meet(w, d + 1);
      };
      HalfEdgeId last;
      mesh.for_each_out(v, [&](HalfEdgeId h) {
        visit(mesh.target(h));
        last = h;
      });
      if (mesh.is_boundary(v)) visit(mesh.origin(QuadMesh::previous(last)));
    }
  }

  // The distance of v; -1 if the last search did not reach it.
  int distance(VertexId v) const { return v.slot() < distance_.size() ? distance_[v.slot()] : -1; }
  // The vertices that the last search reached, in order of distance.
  const std::vector<VertexId>& met() const { return met_; }

 private:
  void meet(VertexId v, int d) {
    distance_[v.slot()] = d;
    met_.push_back(v);
  }

  std::vector<int> distance_;  // by vertex slot
  std::vector<VertexId> met_;
};

// The number of edges on a shortest path from one vertex to another; -1 if there is none. O(V).
inline int graph_distance(const QuadMesh& mesh, VertexId from, VertexId to) {
  const auto always = [](VertexId) { return true; };
  BreadthFirstDistances distances;
  distances.measure(mesh, std::span(&from, 1), always, always, [to](VertexId v, int) { return v == to; });
  return distances.distance(to);
}

}  // namespace requad::mesh
