// Which ids of vertices and faces exist at a line of a script. Internal to the sources of script.hpp.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/editing/script.hpp"

namespace requad::mesh {

// The ids of the mesh after the first lines of a script. They are known without the mesh, because before the script it
// has no free ids.
class ScriptIds {
 public:
  explicit ScriptIds(const MeshDigest& before) : vertices_(before.vertices), faces_(before.faces) {}

  // All ids, live and free, are below these.
  std::int64_t vertices() const { return vertices_; }
  std::int64_t faces() const { return faces_; }
  // What the next split makes.
  VertexId next_vertex() const { return next(free_vertices_, vertices_); }
  FaceId next_face() const { return next(free_faces_, faces_); }
  std::int64_t live_vertices() const { return vertices_ - static_cast<std::int64_t>(free_vertices_.size()); }
  std::int64_t live_faces() const { return faces_ - static_cast<std::int64_t>(free_faces_.size()); }

  // Goes on to the ids after this change.
  void advance(const Change& change) {
    using Kind = BasicOperation::Kind;
    if (!change.operation) return;
    if (change.operation->kind == Kind::collapse) {
      free_vertices_.push_back(change.vertex);
      free_faces_.push_back(QuadMesh::face(change.operation->h));
    } else if (change.operation->kind == Kind::split) {
      take(free_vertices_, vertices_);
      take(free_faces_, faces_);
    }
  }
  std::vector<VertexId>& free_vertices() { return free_vertices_; }
  std::vector<FaceId>& free_faces() { return free_faces_; }

 private:
  template <class Id>
  static Id next(const std::vector<Id>& free_ids, std::int64_t count) {
    return free_ids.empty() ? Id(static_cast<std::int32_t>(count)) : free_ids.back();
  }
  template <class Id>
  static void take(std::vector<Id>& free_ids, std::int64_t& count) {
    if (free_ids.empty()) {
      ++count;
    } else {
      free_ids.pop_back();
    }
  }

  std::int64_t vertices_;
  std::int64_t faces_;
  std::vector<VertexId> free_vertices_;
  std::vector<FaceId> free_faces_;
};

}  // namespace requad::mesh
