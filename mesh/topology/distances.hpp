// Breadth-first distances round some vertices of a mesh, as far as they are needed.
//
// The working memory (an integer for each vertex) is kept and cleared by what was met, so that a look round costs what
// it sees and nothing that grows with the mesh.
#pragma once

#include <span>
#include <vector>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

class BreadthFirstDistances {
 public:
  // Measures distances in edges from the sources. enters(v): whether v is measured at all; passes(v): whether the
  // search goes on from v (sources always do); done(v, d) is asked for each vertex in order of distance before it goes
  // on from there, and ends the search if true. Forgets what was measured before.
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

  // -1 if v was not met.
  int distance(VertexId v) const { return v.slot() < distance_.size() ? distance_[v.slot()] : -1; }
  // In order of distance.
  const std::vector<VertexId>& met() const { return met_; }

 private:
  void meet(VertexId v, int d) {
    distance_[v.slot()] = d;
    met_.push_back(v);
  }

  std::vector<int> distance_;  // by vertex slot
  std::vector<VertexId> met_;
};

}  // namespace requad::mesh
