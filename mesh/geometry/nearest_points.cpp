#include "mesh/geometry/nearest_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>

namespace requad::mesh {

using Eigen::Vector3d;

namespace {

using Box = Eigen::AlignedBox3d;
using BoxTree = Eigen::KdBVH<double, 3, std::size_t>;  // whose objects are the numbers of triangles or points

BoxTree box_tree(const std::vector<Box>& boxes) {
  std::vector<std::size_t> numbers(boxes.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return {numbers.begin(), numbers.end(), boxes.begin(), boxes.end()};
}

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
constexpr double kFar = std::numeric_limits<double>::infinity();

struct Nearest {
  std::size_t number = kNone;
  double squared = kFar;  // distance
};

// Makes `best` the nearest of the objects below a node and of what it was. Of objects at the same distance the one with
// the least number wins, whatever the order of the tree. squared_distance(number) is the distance of an object from p.
// Descends into the nearer of two boxes first. (Eigen's BVMinimize keeps a queue of boxes, and so allocates memory for
// each query.)
template <class SquaredDistance>
void find_nearest(const BoxTree& tree, BoxTree::Index node, const Vector3d& p, const SquaredDistance& squared_distance,
                  Nearest& best) {
  BoxTree::VolumeIterator box = nullptr, last_box = nullptr;
  BoxTree::ObjectIterator number = nullptr, last_number = nullptr;
  tree.getChildren(node, box, last_box, number, last_number);
  for (; number != last_number; ++number) {
    const double squared = squared_distance(*number);
    if (squared < best.squared || (squared == best.squared && *number < best.number)) best = {*number, squared};
  }
  std::array<std::pair<double, BoxTree::Index>, 2> below;
  std::size_t count = 0;
  for (; box != last_box; ++box) below[count++] = {tree.getVolume(*box).squaredExteriorDistance(p), *box};
  if (count == 2 && below[1].first < below[0].first) std::swap(below[0], below[1]);
  for (std::size_t i = 0; i < count; ++i) {
    if (below[i].first <= best.squared) find_nearest(tree, below[i].second, p, squared_distance, best);
  }
}

// Looks no farther than the bound, a squared distance; nothing may be there.
template <class SquaredDistance>
Nearest nearest_in(const BoxTree& tree, const Vector3d& p, const SquaredDistance& squared_distance, double bound) {
  Nearest best;
  if (bound < kFar) best.squared = bound;
  find_nearest(tree, tree.getRootIndex(), p, squared_distance, best);
  return best;
}

Vector3d nearest_on_segment(const Vector3d& a, const Vector3d& b, const Vector3d& p) {
  const Vector3d ab = b - a;
  const double length = ab.squaredNorm();
  return length > 0 ? Vector3d(a + std::clamp((p - a).dot(ab) / length, 0.0, 1.0) * ab) : a;
}

}  // namespace

Vector3d nearest_on_triangle(const Triangle& t, const Vector3d& p) {
  constexpr double kFlat = 1e-6;
  const auto& [a, b, c] = t;
  const Vector3d ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (d1 <= 0 && d2 <= 0) return a;
  if (d3 >= 0 && d4 <= d3) return b;
  if (d6 >= 0 && d5 <= d6) return c;
  Vector3d best = a;
  if (va > 0 && vb > 0 && vc > 0) {
    const double sum = va + vb + vc;  // twice the area, squared
    best = a + ab * (vb / sum) + ac * (vc / sum);
    // In a nearly flat triangle the three signs depend on rounding, and a point of a side may be nearer.
    if (sum > kFlat * ab.squaredNorm() * ac.squaredNorm()) return best;
  }
  // p lies beyond one side, or beyond two at an obtuse corner, or the triangle is flat: the nearest point is on a side.
  for (const Vector3d& q : {nearest_on_segment(a, b, p), nearest_on_segment(b, c, p), nearest_on_segment(c, a, p)}) {
    if ((q - p).squaredNorm() < (best - p).squaredNorm()) best = q;
  }
  return best;
}

struct SurfaceIndex::Tree {
  std::vector<Triangle> triangles;
  std::vector<FaceId> faces;  // two triangles each
  BoxTree boxes;
};

SurfaceIndex::SurfaceIndex(const QuadMesh& m, const Positions& positions) {
  auto tree = std::make_unique<Tree>();
  tree->faces = m.faces();
  std::vector<Box> boxes;
  for (const FaceId f : tree->faces) {
    for (const Triangle& t : mesh::triangles(m, positions, f)) {
      boxes.push_back(Box(t[0]).extend(t[1]).extend(t[2]));
      tree->triangles.push_back(t);
    }
  }
  tree->boxes = box_tree(boxes);
  tree_ = std::move(tree);
}

SurfaceIndex::~SurfaceIndex() = default;
SurfaceIndex::SurfaceIndex(SurfaceIndex&&) noexcept = default;
SurfaceIndex& SurfaceIndex::operator=(SurfaceIndex&&) noexcept = default;

SurfaceIndex::Nearest SurfaceIndex::nearest(const Vector3d& p) const { return nearest(p, Vector3d::Constant(kFar)); }

SurfaceIndex::Nearest SurfaceIndex::nearest(const Vector3d& p, const Vector3d& guess) const {
  const auto squared_distance = [&](std::size_t triangle) {
    return (nearest_on_triangle(tree_->triangles[triangle], p) - p).squaredNorm();
  };
  // A guess that is right must not be lost by rounding.
  const double bound = (1 + 1e-6) * (guess - p).squaredNorm() + 1e-24 * p.squaredNorm();
  mesh::Nearest best = nearest_in(tree_->boxes, p, squared_distance, bound);
  if (best.number == kNone) best = nearest_in(tree_->boxes, p, squared_distance, kFar);
  return {nearest_on_triangle(tree_->triangles[best.number], p), std::sqrt(best.squared),
          tree_->faces[best.number / 2]};
}

struct PointIndex::Tree {
  std::vector<Vector3d> points;
  BoxTree boxes;
};

PointIndex::PointIndex(std::span<const Vector3d> points) {
  const std::vector<Box> boxes(points.begin(), points.end());
  tree_ = std::make_unique<const Tree>(Tree{{points.begin(), points.end()}, box_tree(boxes)});
}

PointIndex::~PointIndex() = default;
PointIndex::PointIndex(PointIndex&&) noexcept = default;
PointIndex& PointIndex::operator=(PointIndex&&) noexcept = default;

Vector3d PointIndex::nearest(const Vector3d& p) const {
  const auto squared_distance = [&](std::size_t point) { return (tree_->points[point] - p).squaredNorm(); };
  return tree_->points[nearest_in(tree_->boxes, p, squared_distance, kFar).number];
}

}  // namespace requad::mesh
