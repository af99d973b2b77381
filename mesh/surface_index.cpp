#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include <Eigen/Geometry>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include "mesh/geometry.hpp"

namespace requad::mesh {

using Eigen::Vector3d;

namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using Box = bg::model::box<Point>;

Point to_point(const Vector3d& p) { return {p.x(), p.y(), p.z()}; }

// The number and what lies under it. Packed (built at once), whose queries are the fastest.
template <class Shape>
using PackedTree = bgi::rtree<std::pair<Shape, std::uint32_t>, bgi::rstar<16>>;

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
    // In a triangle that is nearly flat rounding decides of the three signs, and a side may be nearer.
    if (sum > kFlat * ab.squaredNorm() * ac.squaredNorm()) return best;
  }
  // Outside one side, or outside two at an obtuse corner, or flat: the nearest of the sides.
  for (const Vector3d& q : {nearest_on_segment(a, b, p), nearest_on_segment(b, c, p), nearest_on_segment(c, a, p)}) {
    if ((q - p).squaredNorm() < (best - p).squaredNorm()) best = q;
  }
  return best;
}

struct SurfaceIndex::Tree {
  std::vector<Triangle> triangles;
  std::vector<FaceId> faces;  // two triangles each
  PackedTree<Box> boxes;
};

SurfaceIndex::SurfaceIndex(const QuadMesh& m, const Positions& positions) {
  auto tree = std::make_unique<Tree>();
  tree->faces = m.faces();
  std::vector<std::pair<Box, std::uint32_t>> boxes;
  for (const FaceId f : tree->faces) {
    for (const Triangle& t : mesh::triangles(m, positions, f)) {
      const Vector3d low = t[0].cwiseMin(t[1]).cwiseMin(t[2]), high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
      boxes.emplace_back(Box(to_point(low), to_point(high)), static_cast<std::uint32_t>(tree->triangles.size()));
      tree->triangles.push_back(t);
    }
  }
  tree->boxes = PackedTree<Box>(boxes);
  tree_ = std::move(tree);
}

SurfaceIndex::~SurfaceIndex() = default;
SurfaceIndex::SurfaceIndex(SurfaceIndex&&) noexcept = default;
SurfaceIndex& SurfaceIndex::operator=(SurfaceIndex&&) noexcept = default;

SurfaceIndex::Nearest SurfaceIndex::nearest(const Vector3d& p) const {
  const Point at = to_point(p);
  // The k nearest boxes hold the answer if one of them is farther than what was found, or if there are no more. Mostly
  // 8 are enough. (Boost's incremental query would need no k, but takes memory for all boxes each time.)
  std::vector<std::pair<Box, std::uint32_t>> candidates;
  for (std::size_t k = 8;; k *= 4) {
    candidates.clear();
    tree_->boxes.query(bgi::nearest(at, static_cast<unsigned>(std::min(k, tree_->triangles.size()))),
                       std::back_inserter(candidates));
    Nearest best{p, std::numeric_limits<double>::infinity(), FaceId()};
    double farthest_box = 0;
    std::uint32_t best_triangle = 0;
    for (const auto& [box, number] : candidates) {
      farthest_box = std::max(farthest_box, bg::comparable_distance(at, box));
      const Vector3d q = nearest_on_triangle(tree_->triangles[number], p);
      const double squared = (q - p).squaredNorm();
      // Of equals the least number, whatever the order in which the tree gives them.
      if (squared > best.distance || (squared == best.distance && number > best_triangle)) continue;
      best = {q, squared, tree_->faces[number / 2]};
      best_triangle = number;
    }
    if (farthest_box <= best.distance && k < tree_->triangles.size()) continue;
    best.distance = std::sqrt(best.distance);
    return best;
  }
}

struct PointIndex::Tree {
  PackedTree<Point> points;
};

PointIndex::PointIndex(std::span<const Vector3d> points) {
  std::vector<std::pair<Point, std::uint32_t>> numbered;
  for (const Vector3d& p : points) numbered.emplace_back(to_point(p), static_cast<std::uint32_t>(numbered.size()));
  tree_ = std::make_unique<const Tree>(Tree{PackedTree<Point>(numbered)});
}

PointIndex::~PointIndex() = default;
PointIndex::PointIndex(PointIndex&&) noexcept = default;
PointIndex& PointIndex::operator=(PointIndex&&) noexcept = default;

Vector3d PointIndex::nearest(const Vector3d& p) const {
  std::array<std::pair<Point, std::uint32_t>, 1> found;
  tree_->points.query(bgi::nearest(to_point(p), 1), found.begin());
  const Point& q = found[0].first;
  return {q.get<0>(), q.get<1>(), q.get<2>()};
}

double hausdorff_distance(Sampled a, Sampled b, int density) {
  const auto one_sided = [density](const Sampled& from, const Sampled& to) {
    const SurfaceIndex index(to.mesh, to.positions);
    double farthest = 0;
    for (const FaceId f : from.mesh.faces()) {
      for (const Triangle& t : triangles(from.mesh, from.positions, f)) {
        for (int i = 0; i <= density; ++i) {
          for (int j = 0; i + j <= density; ++j) {
            const Vector3d p = (i * t[0] + j * t[1] + (density - i - j) * t[2]) / density;
            farthest = std::max(farthest, index.nearest(p).distance);
          }
        }
      }
    }
    return farthest;
  };
  return std::max(one_sided(a, b), one_sided(b, a));
}

}  // namespace requad::mesh
