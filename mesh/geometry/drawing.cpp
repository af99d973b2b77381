#include "mesh/geometry/drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/SparseCholesky>

namespace requad::mesh {

namespace {

using Eigen::Vector2d;
using std::numbers::pi;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }
double doubled_area(const Vector2d& a, const Vector2d& b, const Vector2d& c) { return cross(b - a, c - a); }

// The root of an increasing function between two numbers.
template <class Function>
double bisect(double low, double high, Function&& f) {
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (f(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

// --- outlines --------------------------------------------------------------------------------------------------------

// The polygon with these side lengths, inscribed in a circle: its corners as angles, the first of which is 0.
std::vector<double> inscribed_angles(std::vector<double> lengths) {
  const auto longest = std::max_element(lengths.begin(), lengths.end());
  double sum = 0;
  for (const double l : lengths) sum += l;
  // If the longest side is nearly as long as the others together, or longer, it is drawn shorter, or the polygon would
  // be flat.
  *longest = std::min(*longest, 0.8 * (sum - *longest));
  // With x = 1 / (2 radius), the arcs over all sides make a full turn; if the centre lies beyond the longest side, that
  // side has the greater arc of its chord. excess() is what the arcs make above a full turn.
  const double most = 1 / *longest;
  const auto excess = [&](double x, bool beyond) {
    double total = 0;
    for (auto it = lengths.begin(); it != lengths.end(); ++it) {
      const double arc = 2 * std::asin(std::min(1.0, *it * x));
      total += it == longest && beyond ? 2 * pi - arc : arc;
    }
    return total - 2 * pi;
  };
  const bool beyond = excess(most, false) < 0;
  // If the centre lies beyond, the excess is positive between 0 and the root; if not, it is negative there.
  const double x = beyond ? bisect(0, most, [&](double t) { return -excess(t, true); })
                          : bisect(0, most, [&](double t) { return excess(t, false); });
  std::vector<double> angles;
  double angle = 0;
  for (auto it = lengths.begin(); it != lengths.end(); ++it) {
    angles.push_back(angle);
    const double arc = 2 * std::asin(std::min(1.0, *it * x));
    angle += it == longest && beyond ? 2 * pi - arc : arc;
  }
  return angles;
}

std::vector<Vector2d> polygon(const std::vector<int>& sides) {
  const std::vector<double> angles = inscribed_angles({sides.begin(), sides.end()});
  std::vector<Vector2d> points;
  const auto corner = [&](std::size_t i) {
    const double turned = angles[i % angles.size()] - (angles[1] + pi) / 2;  // the first side is horizontal, and lowest
    return Vector2d(std::cos(turned), std::sin(turned));
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Vector2d from = corner(i), to = corner(i + 1);
    for (int j = 0; j < sides[i]; ++j) points.emplace_back(from + (to - from) * (static_cast<double>(j) / sides[i]));
  }
  return points;
}

// The angle between the arcs of a lens. It makes the angle of the quads at the ends about a right one.
constexpr double kLensAngle = 2.1;

std::vector<Vector2d> lens(int lower, int upper) {
  // The length of half an arc over a chord of length 2 that it leaves at angle t.
  const auto length = [](double t) { return std::abs(t) < 1e-9 ? 1.0 : t / std::sin(t); };
  const double least = 0.25;
  const double first =
      bisect(least, kLensAngle - least, [&](double t) { return length(t) * upper - length(kLensAngle - t) * lower; });
  std::vector<Vector2d> points;
  const auto add = [&points](double t, int edges, double direction) {
    const double radius = 1 / std::sin(t);
    for (int j = 0; j < edges; ++j) {
      const double angle = t * (2.0 * j / edges - 1);
      points.emplace_back(direction * radius * std::sin(angle), -direction * radius * (std::cos(angle) - std::cos(t)));
    }
  };
  add(first, lower, 1);
  add(kLensAngle - first, upper, -1);
  return points;
}

// The corner is at the bottom and makes a quarter of the full turn. An arc of a circle and its two tangents make the
// rest.
std::vector<Vector2d> drop(int edges) {
  const double arc = 1.5 * pi;
  const double total = 2 + arc;  // the tangents are as long as the radius
  std::vector<Vector2d> points;
  for (int j = 0; j < edges; ++j) {
    const double s = total * j / edges;
    const double angle = -pi / 4 + std::clamp(s - 1, 0.0, arc);
    Vector2d p(std::cos(angle), std::sin(angle));
    const Vector2d along(-p.y(), p.x());
    if (s < 1) p -= (1 - s) * along;
    if (s > 1 + arc) p += (s - 1 - arc) * along;
    points.push_back(p);
  }
  return points;
}

// --- energy ----------------------------------------------------------------------------------------------------------

struct Corner {
  std::array<int, 3> vertex;  // slots of the corner's vertex, the next vertex and the previous one
};

// Gradient of the energy of a corner, and its Hessian without a negative eigenvalue, in the coordinates
// (e1.x, e1.y, e2.x, e2.y) of the corner's two edges.
struct CornerTerms {
  Eigen::Vector4d gradient;
  Eigen::Matrix4d hessian;
};

double corner_energy(const Vector2d& e1, const Vector2d& e2) {
  const double det = cross(e1, e2);
  if (!(det > 0)) return std::numeric_limits<double>::infinity();
  return (e1.squaredNorm() + e2.squaredNorm()) * (1 + 1 / (det * det));
}

CornerTerms corner_terms(const Vector2d& e1, const Vector2d& e2) {
  const double det = cross(e1, e2);
  const double square = e1.squaredNorm() + e2.squaredNorm();
  const Eigen::Vector4d x(e1.x(), e1.y(), e2.x(), e2.y());
  const Eigen::Vector4d d(e2.y(), -e2.x(), -e1.y(), e1.x());  // the gradient of det
  Eigen::Matrix4d dd = Eigen::Matrix4d::Zero();               // and its derivative
  dd(0, 3) = dd(3, 0) = 1;
  dd(1, 2) = dd(2, 1) = -1;
  const double d2 = det * det, d3 = d2 * det;
  CornerTerms terms;
  terms.gradient = (2 + 2 / d2) * x - 2 * square / d3 * d;
  terms.hessian = (2 + 2 / d2) * Eigen::Matrix4d::Identity() - 4 / d3 * (x * d.transpose() + d * x.transpose()) -
                  2 * square / d3 * dd + 6 * square / (d2 * d2) * d * d.transpose();
  // The rotation nearest to J, turned by 90 degrees, is an eigenvector. Its eigenvalue is
  // 2 - 2 (s1^-3 + s2^-3) / (s1 + s2), where s1 and s2 are the singular values.
  const double sum_square = square + 2 * det;  // (s1 + s2)^2
  const double eigenvalue = 2 - 2 * (sum_square - 3 * det) / d3;
  if (eigenvalue < 0) {
    const double c = e1.x() + e2.y(), s = e1.y() - e2.x();
    const Eigen::Vector4d turned(-s, c, -c, -s);
    terms.hessian -= eigenvalue / (2 * sum_square) * turned * turned.transpose();
  }
  return terms;
}

class Drawer {
 public:
  Drawer(const QuadMesh& mesh, std::vector<Vector2d>& at) : mesh_(mesh), at_(at) {
    unknown_.assign(static_cast<std::size_t>(mesh.vertex_capacity()), -1);
    for (const VertexId v : mesh.vertices()) {
      if (!mesh.is_boundary(v)) unknown_[v.slot()] = count_++;
    }
    for (const FaceId f : mesh.faces()) {
      const auto c = mesh.corners(f);
      for (std::size_t k = 0; k < 4; ++k) {
        // The two quads at a vertex of valence 2 share 360 degrees, so one of the angles there is 180 or more.
        if (!mesh.is_boundary(c[k]) && mesh.face_valence(c[k]) == 2) continue;
        corners_.push_back({{c[k].index(), c[(k + 1) % 4].index(), c[(k + 3) % 4].index()}});
      }
    }
  }

  void run() {
    if (count_ == 0) return;
    tutte();
    if (mesh_.face_count() <= kMostFacesImproved) improve();
  }

 private:
  static constexpr int kMostSteps = 60;

  void tutte() {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(count_, 2);
    for (const VertexId v : mesh_.vertices()) {
      const int row = unknown_[v.slot()];
      if (row < 0) continue;
      for (const VertexId w : mesh_.neighbours(v)) {
        entries.emplace_back(row, row, 1.0);
        if (unknown_[w.slot()] >= 0) {
          entries.emplace_back(row, unknown_[w.slot()], -1.0);
        } else {
          right.row(row) += at_[w.slot()].transpose();
        }
      }
    }
    Eigen::SparseMatrix<double> laplacian(count_, count_);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(laplacian);
    const Eigen::MatrixX2d solution = solver.solve(right);
    for (std::size_t v = 0; v < unknown_.size(); ++v) {
      if (unknown_[v] >= 0) at_[v] = solution.row(unknown_[v]).transpose();
    }
  }

  double energy(const std::vector<Vector2d>& at) const {
    double sum = 0;
    for (const Corner& c : corners_) sum += corner_energy(edge(at, c, 1), edge(at, c, 2));
    return sum;
  }
  Vector2d edge(const std::vector<Vector2d>& at, const Corner& c, std::size_t i) const {
    return (at[static_cast<std::size_t>(c.vertex[i])] - at[static_cast<std::size_t>(c.vertex[0])]) / size_;
  }

  void improve() {
    double area = 0;
    for (const FaceId f : mesh_.faces()) {
      const auto c = mesh_.corners(f);
      area += cross(at_[c[2].slot()] - at_[c[0].slot()], at_[c[3].slot()] - at_[c[1].slot()]) / 2;
    }
    size_ = std::sqrt(area / mesh_.face_count());
    double value = energy(at_);
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
    for (int step = 0; step < kMostSteps && std::isfinite(value); ++step) {
      Eigen::VectorXd gradient = Eigen::VectorXd::Zero(2 * count_);
      const Eigen::SparseMatrix<double> hessian = assemble(gradient);
      if (step == 0) solver.analyzePattern(hessian);
      solver.factorize(hessian);
      const Eigen::VectorXd direction = solver.solve(-gradient);
      const double slope = gradient.dot(direction);
      if (!(slope < 0)) return;
      // Backtracks to a step with less energy. (A step that flattens a corner has infinite energy.)
      std::vector<Vector2d> next;
      double next_value = 0;
      double length = 1;
      for (;; length /= 2) {
        if (length < 1e-9) return;
        next = at_;
        for (std::size_t v = 0; v < unknown_.size(); ++v) {
          if (unknown_[v] >= 0) next[v] += size_ * length * direction.segment<2>(2 * unknown_[v]);
        }
        next_value = energy(next);
        if (next_value <= value + 1e-4 * length * slope) break;
      }
      const double gain = value - next_value;
      at_ = std::move(next);
      value = next_value;
      if (gain < 1e-7 * value) return;
    }
  }

  Eigen::SparseMatrix<double> assemble(Eigen::VectorXd& gradient) const {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(corners_.size() * 36 + static_cast<std::size_t>(2 * count_));
    for (const Corner& c : corners_) {
      const CornerTerms terms = corner_terms(edge(at_, c, 1), edge(at_, c, 2));
      // e1 = next - corner, e2 = previous - corner.
      const std::array<int, 3> row{unknown_[static_cast<std::size_t>(c.vertex[0])],
                                   unknown_[static_cast<std::size_t>(c.vertex[1])],
                                   unknown_[static_cast<std::size_t>(c.vertex[2])]};
      const auto coefficient = [](std::size_t vertex, int e) {
        return vertex == 0 ? -1.0 : (static_cast<int>(vertex) == e + 1 ? 1.0 : 0.0);
      };
      for (std::size_t i = 0; i < 3; ++i) {
        if (row[i] < 0) continue;
        for (int e = 0; e < 2; ++e)
          gradient.segment<2>(2 * row[i]) += coefficient(i, e) * terms.gradient.segment<2>(2 * e);
        for (std::size_t j = 0; j < 3; ++j) {
          if (row[j] < 0) continue;
          Eigen::Matrix2d block = Eigen::Matrix2d::Zero();
          for (int e = 0; e < 2; ++e) {
            for (int f = 0; f < 2; ++f) {
              block += coefficient(i, e) * coefficient(j, f) * terms.hessian.block<2, 2>(2 * e, 2 * f);
            }
          }
          for (int a = 0; a < 2; ++a) {
            for (int b = 0; b < 2; ++b) entries.emplace_back(2 * row[i] + a, 2 * row[j] + b, block(a, b));
          }
        }
      }
    }
    for (int i = 0; i < 2 * count_; ++i) entries.emplace_back(i, i, 1e-6);  // a v2 between two boundary vertices
    Eigen::SparseMatrix<double> hessian(2 * count_, 2 * count_);
    hessian.setFromTriplets(entries.begin(), entries.end());
    return hessian;
  }

  const QuadMesh& mesh_;
  std::vector<Vector2d>& at_;
  std::vector<int> unknown_;  // by vertex slot: row, or -1 for boundary vertices and dead ones
  int count_ = 0;
  std::vector<Corner> corners_;
  double size_ = 1;
};

// Whether two segments have a point in common. If they lie on one line, rounding decides of the signs of areas, but
// their bounding boxes tell.
bool meet(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  if ((a.cwiseMin(b).array() > c.cwiseMax(d).array()).any() || (c.cwiseMin(d).array() > a.cwiseMax(b).array()).any()) {
    return false;
  }
  const auto apart = [](double x, double y) { return (x > 0 && y > 0) || (x < 0 && y < 0); };
  return !apart(doubled_area(a, b, c), doubled_area(a, b, d)) && !apart(doubled_area(c, d, a), doubled_area(c, d, b));
}

}  // namespace

std::vector<Vector2d> outline(const std::vector<int>& sides, bool corners) {
  std::vector<Vector2d> points;
  if (!corners) {
    for (int j = 0; j < sides[0]; ++j)
      points.emplace_back(std::cos(2 * pi * j / sides[0]), std::sin(2 * pi * j / sides[0]));
  } else if (sides.size() == 1) {
    points = drop(sides[0]);
  } else if (sides.size() == 2) {
    points = lens(sides[0], sides[1]);
  } else {
    points = polygon(sides);
  }
  double length = 0;
  Vector2d low = points[0], high = points[0];
  for (std::size_t i = 0; i < points.size(); ++i) {
    length += (points[(i + 1) % points.size()] - points[i]).norm();
    low = low.cwiseMin(points[i]);
    high = high.cwiseMax(points[i]);
  }
  for (Vector2d& p : points) p = (p - (low + high) / 2) * (static_cast<double>(points.size()) / length);
  return points;
}

void draw_inside(const QuadMesh& mesh, std::vector<Vector2d>& at) { Drawer(mesh, at).run(); }

std::vector<Vector2d> draw(const Region& region) {
  const QuadMesh& m = region.mesh;
  std::vector<Vector2d> at(static_cast<std::size_t>(m.vertex_capacity()), Vector2d::Zero());
  const std::vector<Vector2d> boundary = outline(side_lengths(region), turn(m, m.origin(region.root)) > 0);
  std::size_t next = 0;
  for (const HalfEdgeId h : boundary_loop(m, region.root)) at[m.origin(h).slot()] = boundary[next++];
  draw_inside(m, at);
  return at;
}

std::string drawing_problem(const Region& region, const std::vector<Vector2d>& at, double* smallest) {
  const QuadMesh& m = region.mesh;
  double least = std::numeric_limits<double>::infinity();
  std::string problem;
  for (const FaceId f : m.faces()) {
    const auto c = m.corners(f);
    std::array<double, 4> area{};
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector2d &p = at[c[k].slot()], &next = at[c[(k + 1) % 4].slot()], &previous = at[c[(k + 3) % 4].slot()];
      area[k] = doubled_area(p, next, previous);
      const bool open = !m.is_boundary(c[k]) && m.face_valence(c[k]) == 2;
      if (!open) least = std::min(least, area[k] / ((next - p).norm() * (previous - p).norm()));
    }
    // A simple quad is cut by one of its diagonals into two triangles of its own orientation.
    const bool simple = (area[0] > 0 && area[2] > 0) || (area[1] > 0 && area[3] > 0);
    if (!simple && problem.empty()) problem = "quad " + std::to_string(f.index()) + " is turned over or flat";
  }
  if (smallest != nullptr) *smallest = least;
  if (!problem.empty()) return problem;

  const std::vector<HalfEdgeId> loop = boundary_loop(m, region.root);
  const auto point = [&](std::size_t i) -> const Vector2d& { return at[m.origin(loop[i % loop.size()]).slot()]; };
  double area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    area += cross(point(i), point(i + 1));
    if (loop.size() > 3 && point(i) == point(i + 1)) return "two boundary vertices are at one place";
    for (std::size_t j = i + 2; j < loop.size(); ++j) {
      if (i == 0 && j + 1 == loop.size()) continue;  // consecutive too
      if (meet(point(i), point(i + 1), point(j), point(j + 1))) return "the boundary crosses itself";
    }
    // Consecutive edges that lie on each other.
    const Vector2d in = point(i + 1) - point(i), out = point(i + 2) - point(i + 1);
    if (cross(in, out) == 0 && in.dot(out) < 0) return "the boundary runs back on itself";
  }
  return area > 0 ? "" : "the boundary runs clockwise";
}

}  // namespace requad::mesh
