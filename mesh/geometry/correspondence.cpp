#include "mesh/geometry/correspondence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "mesh/geometry/nearest_points.hpp"
#include "mesh/topology/id_lists.hpp"

namespace requad::mesh {

using Eigen::Vector3d;

namespace {

// The weights of the corners of a triangle at the point of it that is nearest to p.
std::array<double, 3> weights_on_triangle(const Triangle& t, const Vector3d& q) {
  // q is in the triangle. Project along the longest component of the normal.
  const Vector3d ab = t[1] - t[0], ac = t[2] - t[0], aq = q - t[0];
  const double d00 = ab.squaredNorm(), d01 = ab.dot(ac), d11 = ac.squaredNorm(), d20 = aq.dot(ab), d21 = aq.dot(ac);
  const double det = d00 * d11 - d01 * d01;
  double v = 0, w = 0;
  if (det > 1e-12 * d00 * d11) {
    v = (d11 * d20 - d01 * d21) / det;
    w = (d00 * d21 - d01 * d20) / det;
  } else if (d00 >= d11) {
    v = d00 > 0 ? d20 / d00 : 0;  // a flat triangle: along its longer side
  } else {
    w = d21 / d11;
  }
  // A point that lies on a side up to rounding is on it.
  constexpr double kTiny = 1e-9;
  std::array<double, 3> weights{1 - v - w, v, w};
  double sum = 0;
  for (double& x : weights) {
    if (x < kTiny) x = 0;
    if (x > 1 - kTiny) x = 1;
    sum += x;
  }
  for (double& x : weights) x /= sum;
  return weights;
}

}  // namespace

NearestOnFace nearest_on_face(const QuadMesh& m, const Positions& positions, FaceId f, const Vector3d& p) {
  NearestOnFace best{{}, std::numeric_limits<double>::infinity()};
  const FaceTriangles two = triangles_of(m, positions, f);
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector3d q = nearest_on_triangle(two.triangles[i], p);
    const double squared = (q - p).squaredNorm();
    if (!(squared < best.squared)) continue;
    const std::array<double, 3> w = weights_on_triangle(two.triangles[i], q);
    best.squared = squared;
    best.weights = {};
    for (std::size_t k = 0; k < 3; ++k) best.weights[static_cast<std::size_t>(two.corners[i][k])] = w[k];
  }
  return best;
}

Correspondence::Correspondence(const QuadMesh& m, const Positions& positions) {
  const std::vector<FaceId> faces = m.faces();
  first_.assign(static_cast<std::size_t>(m.face_capacity()), -1);
  double total = 0;
  normals_.assign(first_.size(), Vector3d::Zero());
  areas_.assign(first_.size(), 0);
  for (const FaceId f : faces) {
    normals_[f.slot()] = face_normal(m, positions, f);
    areas_[f.slot()] = area(m, positions, f);
    total += areas_[f.slot()];
  }
  const double mean = std::max(total / static_cast<double>(faces.size()), std::numeric_limits<double>::min());
  // A face counts 1 for a distance of its own size; of a size halfway to the mean, so that large faces count for more
  // and small ones still count.
  for (double& a : areas_) a = std::max(a, 1e-3 * mean);
  const auto scale = [&](FaceId f) { return std::sqrt(areas_[f.slot()] * mean); };
  for (const FaceId f : faces) mean_weight_ += 1 / scale(f) / static_cast<double>(faces.size());
  samples_.reserve(4 * faces.size());
  homes_.reserve(4 * faces.size());
  for (const FaceId f : faces)
    add(face_centre(m, positions, f), normals_[f.slot()], 1, areas_[f.slot()], 0.25 / scale(f),
        {f, {0.25, 0.25, 0.25, 0.25}});
  for (const FaceId f : faces) {
    for (int k = 0; k < 4; ++k) {
      const HalfEdgeId h = QuadMesh::half_edge(f, k);
      const HalfEdgeId t = m.twin(h);
      if (t.valid() && t.index() < h.index()) continue;
      Vector3d normals = normals_[f.slot()];
      double areas = areas_[f.slot()];
      if (t.valid()) {
        normals += normals_[QuadMesh::face(t).slot()];
        areas = (areas + areas_[QuadMesh::face(t).slot()]) / 2;
      }
      Home home{f, {}};
      home.weights[static_cast<std::size_t>(k)] = home.weights[static_cast<std::size_t>((k + 1) % 4)] = 0.5;
      add((positions[m.origin(h).slot()] + positions[m.target(h).slot()]) / 2, normals, t.valid() ? 2 : 1, areas,
          0.125 / scale(f) + (t.valid() ? 0.125 / scale(QuadMesh::face(t)) : 0), home);
    }
  }
  for (const VertexId v : m.vertices()) {
    Vector3d normals = Vector3d::Zero();
    int count = 0;
    double weight = 0, areas = 0;
    m.for_each_out(v, [&](HalfEdgeId h) {
      normals += normals_[QuadMesh::face(h).slot()];
      areas += areas_[QuadMesh::face(h).slot()];
      weight += 0.0625 / scale(QuadMesh::face(h));
      ++count;
    });
    const HalfEdgeId h = m.out(v);
    Home home{QuadMesh::face(h), {}};
    home.weights[static_cast<std::size_t>(h.index() & 3)] = 1;
    add(positions[v.slot()], normals, count, areas / count, weight, home);
  }
}

void Correspondence::add(const Vector3d& point, const Vector3d& normals, int count, double area, double weight,
                         const Home& home) {
  constexpr double kAlong = 0.05;
  // Normals that spread, as at a tip or a sharp edge, have a short mean.
  const double length = normals.norm() / count;
  const double along = std::clamp(kAlong + 4 * (1 - length), kAlong, 1.0);
  samples_.push_back({point, length > 0 ? Vector3d(normals / (count * length)) : normals, area, along, weight});
  Node node{home, first_[home.face.slot()], -1};
  const int i = static_cast<int>(homes_.size());
  if (node.next >= 0) homes_[static_cast<std::size_t>(node.next)].previous = i;
  homes_.push_back(node);
  first_[home.face.slot()] = i;
}

Vector3d Correspondence::point_at(const QuadMesh& m, const Positions& positions, const Home& home) const {
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k < 4; ++k) {
    const double w = home.weights[static_cast<std::size_t>(k)];
    if (w != 0) sum += w * positions[m.origin(QuadMesh::half_edge(home.face, k)).slot()];
  }
  return sum;
}

int& Correspondence::first(FaceId f) {
  if (f.slot() >= first_.size()) first_.resize(f.slot() + 1, -1);
  return first_[f.slot()];
}

void Correspondence::move(int sample, const Home& home) {
  Node& node = homes_[static_cast<std::size_t>(sample)];
  moves_.push_back({sample, node});
  if (node.home.face != home.face) {
    // The links that are kept in the history tell where the sample was.
    (node.previous >= 0 ? homes_[static_cast<std::size_t>(node.previous)].next : first(node.home.face)) = node.next;
    if (node.next >= 0) homes_[static_cast<std::size_t>(node.next)].previous = node.previous;
    int& head = first(home.face);
    node.previous = -1;
    node.next = head;
    if (head >= 0) homes_[static_cast<std::size_t>(head)].previous = sample;
    head = sample;
  }
  node.home = home;
}

void Correspondence::roll_back(std::size_t mark) {
  while (moves_.size() > mark) {
    const Move& move = moves_.back();
    Node& node = homes_[static_cast<std::size_t>(move.sample)];
    if (node.home.face != move.before.home.face) {
      first(node.home.face) = node.next;
      if (node.next >= 0) homes_[static_cast<std::size_t>(node.next)].previous = -1;
      const Node& before = move.before;
      (before.previous >= 0 ? homes_[static_cast<std::size_t>(before.previous)].next : first(before.home.face)) =
          move.sample;
      if (before.next >= 0) homes_[static_cast<std::size_t>(before.next)].previous = move.sample;
      node = before;
    } else {
      node.home = move.before.home;
    }
    moves_.pop_back();
  }
}

void Correspondence::leave(FaceId removed, const std::array<FaceId, 4>& beside) {
  while (first(removed) >= 0) {
    const int i = first(removed);
    const std::array<double, 4>& w = homes_[static_cast<std::size_t>(i)].home.weights;
    std::size_t best = 4;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!beside[k].valid()) continue;
      if (best == 4 || w[k] + w[(k + 1) % 4] > w[best] + w[(best + 1) % 4]) best = k;
    }
    move(i, {beside[best], {0.25, 0.25, 0.25, 0.25}});
  }
}

void Correspondence::settle(const QuadMesh& m, const Positions& positions, std::span<const FaceId> faces,
                            const RunTasks& run) {
  settling_.clear();
  for (const FaceId f : faces) for_each_sample(f, [&](std::size_t i) { settling_.push_back(static_cast<int>(i)); });
  sort_once(settling_);
  settled_.resize(settling_.size());
  in_chunks(run, settling_.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k)
      settled_[k] = settled(m, positions, static_cast<std::size_t>(settling_[k]));
  });
  for (std::size_t k = 0; k < settling_.size(); ++k) {
    const Home& before = homes_[static_cast<std::size_t>(settling_[k])].home;
    if (settled_[k].face != before.face || settled_[k].weights != before.weights) move(settling_[k], settled_[k]);
  }
}

// Where a sample is at home when it has followed the mesh downhill.
Correspondence::Home Correspondence::settled(const QuadMesh& m, const Positions& positions, std::size_t sample) const {
  constexpr int kMostSteps = 100;
  const Vector3d& p = samples_[sample].point;
  Home best = homes_[sample].home;
  NearestOnFace at = nearest_on_face(m, positions, best.face, p);
  best.weights = at.weights;
  for (int step = 0; step < kMostSteps; ++step) {
    // Only across the edges and round the corners that the nearest point lies on.
    FaceId better;
    const FaceId here = best.face;
    const auto look = [&](FaceId g) {
      if (g == here || g == better) return;
      const NearestOnFace there = nearest_on_face(m, positions, g, p);
      if (!(there.squared < at.squared)) return;
      at = there;
      better = g;
    };
    for (int k = 0; k < 4; ++k) {
      const HalfEdgeId h = QuadMesh::half_edge(here, k);
      const double w = best.weights[static_cast<std::size_t>(k)];
      const double beyond1 = best.weights[static_cast<std::size_t>((k + 2) % 4)];
      const double beyond2 = best.weights[static_cast<std::size_t>((k + 3) % 4)];
      if (w == 1) {
        m.for_each_out(m.origin(h), [&](HalfEdgeId x) { look(QuadMesh::face(x)); });
      } else if (beyond1 == 0 && beyond2 == 0 && m.twin(h).valid()) {
        look(QuadMesh::face(m.twin(h)));
      }
    }
    if (!better.valid()) break;
    best = {better, at.weights};
  }
  return best;
}

}  // namespace requad::mesh
