#include "tests/mesh/geometry/shape_of_files.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>

#include <Eigen/Geometry>

#include "tests/support/catch.hpp"

namespace requad::tests {

using Eigen::Vector3d;
namespace fs = std::filesystem;

namespace {

double diagonal(const Quads& quads) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : quads.points) box.extend(p);
  return box.diagonal().norm();
}

// The distance of p from a triangle, by the regions of its plane (C. Ericson, Real-Time Collision Detection, 5.1.5).
double distance(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const auto from_segment = [&p](const Vector3d& x, const Vector3d& y) {
    const Vector3d d = y - x;
    const double t = d.squaredNorm() > 0 ? std::clamp(d.dot(p - x) / d.squaredNorm(), 0.0, 1.0) : 0;
    return (p - x - t * d).norm();
  };
  const Vector3d n = (b - a).cross(c - a);
  if (n.squaredNorm() > 0 && n.dot((b - a).cross(p - a)) >= 0 && n.dot((c - b).cross(p - b)) >= 0 &&
      n.dot((a - c).cross(p - c)) >= 0)
    return std::abs(n.dot(p - a)) / n.norm();
  return std::min({from_segment(a, b), from_segment(b, c), from_segment(c, a)});
}

double one_way(const Quads& from, const Quads& to) {
  // Triangles by cells of a grid, so that few are looked at.
  const double size = diagonal(to) / 100;
  std::map<std::array<int, 3>, std::vector<std::size_t>> cells;
  const auto cell = [size](const Vector3d& p) {
    return std::array<int, 3>{int(std::floor(p.x() / size)), int(std::floor(p.y() / size)),
                              int(std::floor(p.z() / size))};
  };
  for (std::size_t f = 0; f < to.faces.size(); ++f) {
    Eigen::AlignedBox3d box;
    for (const std::size_t v : to.faces[f]) box.extend(to.points[v]);
    const auto low = cell(box.min()), high = cell(box.max());
    for (int x = low[0]; x <= high[0]; ++x) {
      for (int y = low[1]; y <= high[1]; ++y) {
        for (int z = low[2]; z <= high[2]; ++z) cells[{x, y, z}].push_back(f);
      }
    }
  }
  const auto from_quad = [&](const Vector3d& p, std::size_t f) {
    const auto& q = to.faces[f];
    const auto at = [&](std::size_t k) { return to.points[q[k & 3]]; };
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 4; ++k) least = std::min(least, distance(p, at(k), at(k + 1), at(k + 2)));
    return least;
  };
  const auto nearest = [&](const Vector3d& p) {
    const auto middle = cell(p);
    double least = std::numeric_limits<double>::infinity();
    for (int reach = 0; reach < 200; ++reach) {
      for (int x = -reach; x <= reach; ++x) {
        for (int y = -reach; y <= reach; ++y) {
          for (int z = -reach; z <= reach; ++z) {
            if (std::max({std::abs(x), std::abs(y), std::abs(z)}) != reach) continue;
            const auto found = cells.find({middle[0] + x, middle[1] + y, middle[2] + z});
            if (found == cells.end()) continue;
            for (const std::size_t f : found->second) least = std::min(least, from_quad(p, f));
          }
        }
      }
      if (least <= reach * size) break;
    }
    return least;
  };
  double farthest = 0;
  for (const Vector3d& p : from.points) farthest = std::max(farthest, nearest(p));
  for (const auto& f : from.faces) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (f[k] < f[(k + 1) & 3])  // once for each edge inside
        farthest = std::max(farthest, nearest((from.points[f[k]] + from.points[f[(k + 1) & 3]]) / 2));
    }
  }
  return farthest;
}

}  // namespace

Quads read_quads(const fs::path& path) {
  Quads result;
  std::ifstream file(path);
  REQUIRE(file);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      Vector3d p;
      words >> p.x() >> p.y() >> p.z();
      result.points.push_back(p);
    } else if (word == "f") {
      std::array<std::size_t, 4> face{};
      for (std::size_t& corner : face) {
        words >> word;
        corner = std::stoul(word) - 1;
      }
      result.faces.push_back(face);
    }
  }
  return result;
}

double shape_lost(const fs::path& input, const fs::path& output) {
  const Quads a = read_quads(input), b = read_quads(output);
  return std::max(one_way(a, b), one_way(b, a)) / diagonal(a);
}

}  // namespace requad::tests
