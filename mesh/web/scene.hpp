// The mesh as a graphics card draws it: arrays that change where the mesh changes, and nowhere else.
//
// Terms
//   corner      of a quad, numbered as its half-edge: 4 * quad + k. Each corner has its own entry, so that each quad has
//               its own normal and colour, and its number tells which quad was drawn at a pixel.
//   triangles   the two of each quad (measures.hpp), as six corners; six times the same one for an id that is free.
// Law web-4. After update() the arrays are those that a new Scene of the same mesh would have.
// Costs: update() costs the number of quads that are listed; a new Scene, growth, and update() with a paint that is global
// cost O(F).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/geometry/measures.hpp"
#include "mesh/web/paint.hpp"

namespace requad::web {

class Scene {
 public:
  static constexpr std::size_t kFloatsPerCorner = 7;            // position, then the quad's unit normal and its paint
  static constexpr std::size_t kFloats = 4 * kFloatsPerCorner;  // of a quad

  Scene(const mesh::QuadMesh& mesh, const mesh::Positions& positions, Paint paint = Paint::plain) : paint_(paint) {
    rebuild(mesh, positions);
  }

  void rebuild(const mesh::QuadMesh& mesh, const mesh::Positions& positions);
  Paint paint() const { return paint_; }
  void set_paint(const mesh::QuadMesh& mesh, const mesh::Positions& positions, Paint paint);
  // Writes these quads anew. Returns whether the arrays grew, or all quads are painted anew, so that all of them must be
  // uploaded.
  bool update(const mesh::QuadMesh& mesh, const mesh::Positions& positions, std::span<const mesh::FaceId> quads);

  // The arrays have room for more quads than there are.
  int quad_capacity() const { return static_cast<int>(triangles_.size() / 6); }
  const std::vector<float>& corners() const { return corners_; }
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  // The middle of the bounding box and half its diagonal, as the mesh was at the last rebuild().
  const Eigen::Vector3d& centre() const { return centre_; }
  double radius() const { return radius_; }

 private:
  void write(const mesh::QuadMesh& mesh, const mesh::Positions& positions, mesh::FaceId f, float number);
  void write_all(const mesh::QuadMesh& mesh, const mesh::Positions& positions);
  bool make_room(const mesh::QuadMesh& mesh);

  Paint paint_;
  std::vector<float> corners_;
  std::vector<std::uint32_t> triangles_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double radius_ = 1;
};

}  // namespace requad::web
