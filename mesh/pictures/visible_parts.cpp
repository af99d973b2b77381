#include "mesh/pictures/visible_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace requad::pictures {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kSamples = 4;  // of the depth buffer, on a length of one point

}  // namespace

double area(const Outline& outline) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
    twice += cross(outline[i].at - outline[0].at, outline[i + 1].at - outline[0].at);
  return twice / 2;
}

Vector2d Part::middle() const {
  Vector2d sum = Vector2d::Zero();
  for (const Piece::Corner& c : outline) sum += c.at;
  return sum / static_cast<double>(outline.size());
}

Part Part::over(Outline other) const {
  Part part = *this;
  part.offset = depth(other.front().at);
  part.outline = std::move(other);
  part.sibling = -1;
  part.measure();
  return part;
}

void Part::measure() {
  low = high = outline.front().at;
  for (const Piece::Corner& c : outline) {
    low = low.cwiseMin(c.at);
    high = high.cwiseMax(c.at);
  }
}

std::vector<Part> triangles_of(const Facet& facet, int index) {
  std::vector<Part> parts;
  const auto d = static_cast<std::size_t>(facet.diagonal);
  const std::array<std::array<std::size_t, 3>, 2> triangles{{{d, d + 1, d + 2}, {d, d + 2, (d + 3) % 4}}};
  for (const auto& triangle : triangles) {
    std::array<Vector3d, 3> c;
    Part part;
    part.facet = index;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t corner = triangle[k] % 4, next = triangle[(k + 1) % 3] % 4;
      c[k] = facet.corners[corner];
      part.outline.push_back({c[k].head<2>(), next == (corner + 1) % 4 ? static_cast<int>(corner) : -1});
    }
    const Vector2d u = (c[1] - c[0]).head<2>(), v = (c[2] - c[0]).head<2>();
    const double twice = cross(u, v);
    if (std::abs(twice) < 2 * kNoOverlap) continue;
    const double du = c[1].z() - c[0].z(), dv = c[2].z() - c[0].z();
    part.gradient = Vector2d(du * v.y() - dv * u.y(), dv * u.x() - du * v.x()) / twice;
    part.offset = c[0].z();
    part.front = twice > 0;
    if (!part.front) {
      const Outline o = part.outline;
      part.outline = {{o[2].at, o[1].side}, {o[1].at, o[0].side}, {o[0].at, o[2].side}};
      part.offset = c[2].z();
    }
    part.measure();
    parts.push_back(std::move(part));
  }
  return parts;
}

template <class Visit>
void DepthBuffer::visit(const Part& part, Visit&& visit) const {
  const auto first = [](double x) { return static_cast<std::size_t>(std::max(0.0, std::ceil(x))); };
  const std::size_t last = static_cast<std::size_t>((part.high.y() - low_.y()) * kSamples);
  for (std::size_t j = first((part.low.y() - low_.y()) * kSamples); j <= last; ++j) {
    const double y = low_.y() + static_cast<double>(j) / kSamples;
    double from = part.high.x(), to = part.low.x();
    for (std::size_t k = 0; k < part.outline.size(); ++k) {
      const Vector2d &p = part.outline[k].at, &q = part.outline[(k + 1) % part.outline.size()].at;
      if ((p.y() <= y) == (q.y() <= y)) continue;
      const double x = p.x() + (y - p.y()) / (q.y() - p.y()) * (q.x() - p.x());
      from = std::min(from, x);
      to = std::max(to, x);
    }
    for (std::size_t i = first((from - low_.x()) * kSamples); i < width_; ++i) {
      const double x = low_.x() + static_cast<double>(i) / kSamples;
      if (x > to) break;
      visit(j * width_ + i, static_cast<float>(part.depth({x, y})));
    }
  }
}

DepthBuffer::DepthBuffer(const std::vector<Part>& parts) {
  Vector2d high = low_ = parts.front().low;
  for (const Part& part : parts) {
    low_ = low_.cwiseMin(part.low);
    high = high.cwiseMax(part.high);
  }
  low_ -= Vector2d(0.31, 0.57) / kSamples;  // no point lies on a line where the coordinates are round numbers
  width_ = static_cast<std::size_t>((high.x() - low_.x()) * kSamples) + 1;
  const auto height = static_cast<std::size_t>((high.y() - low_.y()) * kSamples) + 1;
  depths_.assign(width_ * height, -std::numeric_limits<float>::infinity());
  for (const Part& part : parts) {
    visit(part, [this](std::size_t at, float depth) { depths_[at] = std::max(depths_[at], depth); });
  }
}

bool DepthBuffer::shows(const Part& part) const {
  bool any = false, nearest = false;
  visit(part, [&](std::size_t at, float depth) {
    any = true;
    nearest = nearest || depth >= depths_[at];
  });
  return nearest || !any;
}

}  // namespace requad::pictures
