#include "mesh/editing/mirror.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "mesh/geometry/nearest_points.hpp"
#include "mesh/topology/id_lists.hpp"

namespace requad::mesh {

using Eigen::Vector3d;

std::optional<Mirror> Mirror::find(const QuadMesh& m, const Positions& positions, Axis axis, VertexId* without_image) {
  const std::vector<VertexId> all = m.vertices();
  const auto k = static_cast<Eigen::Index>(axis);
  std::vector<Vector3d> points;
  std::map<std::array<double, 3>, VertexId> at;
  double low = positions[all.front().slot()][k], high = low;
  for (const VertexId v : all) {
    const Vector3d& p = positions[v.slot()];
    points.push_back(p);
    at.emplace(std::array{p.x(), p.y(), p.z()}, v);
    low = std::min(low, p[k]);
    high = std::max(high, p[k]);
  }
  const double tolerance = kTolerance * bounding_box_diagonal(m, positions);
  const double middle = (low + high) / 2;
  // Modellers mirror at 0.
  Mirror mirror(axis, std::abs(middle) <= tolerance ? 0 : middle);
  mirror.images_.assign(static_cast<std::size_t>(m.vertex_capacity()), VertexId());
  const PointIndex index(points);
  const auto fails = [&](VertexId v) {
    if (without_image) *without_image = v;
    return std::nullopt;
  };
  for (const VertexId v : all) {
    Vector3d reflected = positions[v.slot()];
    reflected[k] = 2 * mirror.plane_ - reflected[k];
    const Vector3d q = index.nearest(reflected);
    if ((q - reflected).norm() > tolerance) return fails(v);
    mirror.images_[v.slot()] = at.at({q.x(), q.y(), q.z()});
  }
  for (const VertexId v : all) {
    if (!mirror.has_faces_mirrored(m, v)) return fails(v);
  }
  return mirror;
}

// Whether the vertex is the image of its image, and each face at it has an image.
bool Mirror::has_faces_mirrored(const QuadMesh& m, VertexId v) const {
  const VertexId w = image(v);
  if (!w.valid() || !m.is_live(w) || image(w) != v || m.face_valence(v) != m.face_valence(w)) return false;
  bool all = true;
  m.for_each_out(v, [&](HalfEdgeId h) {
    // The face a, b, c, d has the image b', a', d', c'.
    std::array<VertexId, 4> images;
    HalfEdgeId g = h;
    for (VertexId& x : images) {
      x = image(m.origin(g));
      all = all && x.valid() && m.is_live(x);
      g = QuadMesh::next(g);
    }
    if (!all) return;
    HalfEdgeId other = m.find_half_edge(images[1], images[0]);
    all = other.valid();
    for (const std::size_t k : {std::size_t{1}, std::size_t{0}, std::size_t{3}, std::size_t{2}}) {
      all = all && m.origin(other) == images[k];
      if (all) other = QuadMesh::next(other);
    }
  });
  return all;
}

// What the operation of an edit is on the other side; nothing if the mesh there has no such place.
std::optional<BasicOperation> Mirror::image_of(const QuadMesh& m, const Edit& edit) const {
  using Kind = BasicOperation::Kind;
  const Kind kind = edit.operation.kind;
  std::array<VertexId, 4> images;
  for (std::size_t i = 0; i < (kind == Kind::split ? 3 : 4); ++i) {
    images[i] = image(edit.changed[i]);
    if (!images[i].valid() || !m.is_live(images[i])) return std::nullopt;
  }
  if (kind == Kind::split) {
    // The sector from a to b, counter-clockwise, has the image from b' to a'.
    const HalfEdgeId first = m.find_half_edge(images[0], images[2]), last = m.find_half_edge(images[1], images[0]);
    if (!first.valid() || !last.valid()) return std::nullopt;
    return BasicOperation{kind, first, last, 0};
  }
  if (kind == Kind::collapse) {
    const auto kept = static_cast<std::size_t>(edit.operation.h.index() & 3);
    const HalfEdgeId h = m.find_half_edge(images[kept], images[(kept + 3) % 4]);
    if (!h.valid() || m.target(QuadMesh::next(h)) != images[(kept + 2) % 4]) return std::nullopt;
    return BasicOperation{kind, h, {}, 0};
  }
  const HalfEdgeId h = m.find_half_edge(images[0], images[1]);
  if (!h.valid() || !m.twin(h).valid()) return std::nullopt;
  return BasicOperation{kind == Kind::flip_ccw ? Kind::flip_cw : Kind::flip_ccw, h, {}, 0};
}

bool Mirror::follow(Editor& editor, std::size_t mark) {
  const QuadMesh& m = editor.mesh();
  const std::size_t end = editor.mark();
  std::vector<VertexId> near;
  for (std::size_t i = mark; i < end; ++i) {
    const Edit edit = editor.edits()[i];
    if (!edit.operates) continue;
    const std::optional<BasicOperation> operation = image_of(m, edit);
    if (!operation || editor.run(*operation).refusal != Refusal::none) return false;
    const Edit& there = editor.edits().back();
    if (edit.made_vertex().valid()) {
      set_image(edit.made_vertex(), there.made_vertex());
      set_image(there.made_vertex(), edit.made_vertex());
    }
    if (edit.removed_vertex().valid()) {
      set_image(edit.removed_vertex(), VertexId());
      set_image(there.removed_vertex(), VertexId());
    }
    for (const Edit* one : {&edit, &there}) {
      for (const VertexId v : one->changed) {
        if (v.valid()) near.push_back(v);
      }
    }
  }
  sort_once(near);
  return std::all_of(near.begin(), near.end(), [&](VertexId v) { return !m.is_live(v) || has_faces_mirrored(m, v); });
}

void Mirror::symmetrise(Editor& editor, std::span<const VertexId> vertices) const {
  std::vector<VertexId> both;
  for (const VertexId v : vertices) {
    const VertexId w = image(v);
    if (editor.is_fixed(v) || !w.valid() || editor.is_fixed(w)) continue;
    both.push_back(v);
    both.push_back(w);
  }
  sort_once(both);
  editor.rearrange(both, [&](Positions& positions) {
    for (const VertexId v : both) {
      const VertexId w = image(v);
      if (w < v) continue;
      Vector3d &p = positions[v.slot()], &q = positions[w.slot()];
      const double half = v == w ? 0 : (p[axis_] - q[axis_]) / 2;
      p = (p + q) / 2;
      q = p;
      p[axis_] = plane_ + half;
      q[axis_] = plane_ - half;
    }
  });
}

void Mirror::set_image(VertexId v, VertexId image) {
  changes_.emplace_back(v, this->image(v));
  if (v.slot() >= images_.size()) images_.resize(v.slot() + 1);
  images_[v.slot()] = image;
}

void Mirror::roll_back(std::size_t mark) {
  while (changes_.size() > mark) {
    images_[changes_.back().first.slot()] = changes_.back().second;
    changes_.pop_back();
  }
}

}  // namespace requad::mesh
