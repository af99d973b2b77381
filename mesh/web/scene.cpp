#include "mesh/web/scene.hpp"

#include <algorithm>
#include <array>

namespace requad::web {

using mesh::FaceId;
using mesh::Positions;
using mesh::QuadMesh;

void Scene::write(const QuadMesh& m, const Positions& positions, FaceId f, float number) {
  float* at = corners_.data() + kFloats * f.slot();
  std::uint32_t* triangle = triangles_.data() + 6 * f.slot();
  const std::uint32_t first = 4 * static_cast<std::uint32_t>(f.index());
  if (!m.is_live(f)) {
    std::fill(at, at + kFloats, 0.0F);
    std::fill(triangle, triangle + 6, first);
    return;
  }
  const Eigen::Vector3d normal = face_normal(m, positions, f);
  const std::array<mesh::VertexId, 4> corners = m.corners(f);
  for (const mesh::VertexId v : corners) {
    for (const double x : positions[v.slot()]) *at++ = static_cast<float>(x);
    for (const double x : normal) *at++ = static_cast<float>(x);
    *at++ = number;
  }
  // The diagonal of mesh::triangles() starts at the first corner or at the second.
  const mesh::Triangle half = mesh::triangles(m, positions, f)[0];
  const std::uint32_t start = mesh::same_bits(half[0], positions[corners[0].slot()]) ? 0 : 1;
  for (const std::uint32_t k : {0U, 1U, 2U, 0U, 2U, 3U}) *triangle++ = first + (start + k) % 4;
}

bool Scene::make_room(const QuadMesh& m) {
  const auto needed = static_cast<std::size_t>(m.face_capacity());
  if (6 * needed <= triangles_.size()) return false;
  const std::size_t before = triangles_.size() / 6, room = needed + needed / 4 + 64;
  corners_.resize(kFloats * room, 0.0F);
  triangles_.resize(6 * room);
  for (std::size_t f = before; f < room; ++f)
    std::fill_n(triangles_.begin() + static_cast<std::ptrdiff_t>(6 * f), 6, static_cast<std::uint32_t>(4 * f));
  return true;
}

void Scene::write_all(const QuadMesh& m, const Positions& positions) {
  const std::vector<float> numbers = paint_all(m, positions, paint_);
  for (const FaceId f : m.faces()) write(m, positions, f, numbers[f.slot()]);
}

void Scene::set_paint(const QuadMesh& m, const Positions& positions, Paint paint) {
  paint_ = paint;
  write_all(m, positions);
}

void Scene::rebuild(const QuadMesh& m, const Positions& positions) {
  corners_.clear();
  triangles_.clear();
  make_room(m);
  write_all(m, positions);
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = low;
  bool first = true;
  for (const mesh::VertexId v : m.vertices()) {
    const Eigen::Vector3d& p = positions[v.slot()];
    low = first ? p : low.cwiseMin(p).eval();
    high = first ? p : high.cwiseMax(p).eval();
    first = false;
  }
  centre_ = 0.5 * (low + high);
  radius_ = 0.5 * (high - low).norm();
}

bool Scene::update(const QuadMesh& m, const Positions& positions, std::span<const FaceId> quads) {
  const bool grown = make_room(m);
  for (const FaceId f : quads) {
    if (f.index() < quad_capacity()) write(m, positions, f, m.is_live(f) ? local_paint(m, positions, f, paint_) : 0);
  }
  if (is_global(paint_)) write_all(m, positions);
  return grown || is_global(paint_);
}

}  // namespace requad::web
