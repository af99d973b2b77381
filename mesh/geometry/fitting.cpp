#include "mesh/geometry/fitting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "mesh/geometry/in_chunks.hpp"
#include "mesh/geometry/quad_shape.hpp"

namespace requad::mesh {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr int kMostHalvings = 5;  // of a step, until the energy falls
// Where the solution of a joint step's equations ends: the residual over that at the start, and the iterations.
constexpr double kEnough = 1e-2;
constexpr int kMostIterations = 100;

IdealQuad ideal_of(const QuadCorners& c, FaceId f, const Correspondence& homes, const SurfaceIndex& surface) {
  IdealQuad result;
  double weight = 0;
  homes.for_each_sample(f, [&](std::size_t i) {
    const Correspondence::Sample& sample = homes.sample(i);
    result.normal += sample.weight * sample.normal;
    result.area += sample.weight * sample.area;
    weight += sample.weight;
  });
  const double length = result.normal.norm();
  if (weight > 0) result.area /= weight;
  if (length > 0.2 * weight) {
    result.normal /= length;
  } else {
    const FaceId near = surface.nearest((c[0] + c[1] + c[2] + c[3]) / 4).face;
    result.normal = homes.surface_normal(near);
    if (weight == 0) result.area = homes.surface_area(near);
  }
  return result;
}

// The squared distance of a residual, with its derivatives by the residual; the second ones without a negative part.
struct Distance {
  double energy;
  Vector3d gradient;
  Matrix3d hessian;
};
double distance_energy(const Vector3d& r, const Vector3d& normal, double along, double tolerance2) {
  const double squared = r.squaredNorm(), across = normal.dot(r);
  return (along * squared + (1 - along) * across * across) * (1 + squared / (2 * tolerance2));
}
Distance distance(const Vector3d& r, const Vector3d& normal, double along, double tolerance2) {
  const double squared = r.squaredNorm(), across = normal.dot(r);
  const double quadratic = along * squared + (1 - along) * across * across;
  const double factor = 1 + squared / (2 * tolerance2);
  const Vector3d slope = 2 * (along * r + ((1 - along) * across) * normal);
  Distance result{quadratic * factor, factor * slope + quadratic / tolerance2 * r, Matrix3d::Zero()};
  result.hessian.diagonal().array() = 2 * factor * along + quadratic / tolerance2;
  result.hessian += (2 * factor * (1 - along)) * normal * normal.transpose();
  result.hessian += (4 * along / tolerance2) * r * r.transpose();
  return result;
}

class Fitter {
 public:
  Fitter(const QuadMesh& mesh, Positions& positions, std::span<const VertexId> vertices, Correspondence& homes,
         const SurfaceIndex& surface, const FitOptions& options)
      : m_(mesh), positions_(positions), homes_(homes), surface_(surface), options_(options) {
    for (const VertexId v : vertices) {
      m_.for_each_out(v, [&](HalfEdgeId h) { faces_.push_back(QuadMesh::face(h)); });
      if (!m_.is_boundary(v) && !(options.fixed && options.fixed(v))) vertices_.push_back(v);
    }
    std::sort(faces_.begin(), faces_.end());
    faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
    unknowns_.assign(faces_.size(), {-1, -1, -1, -1});
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      first_corner_.push_back(corners_.size());
      m_.for_each_out(vertices_[i], [&](HalfEdgeId h) {
        const auto found = std::lower_bound(faces_.begin(), faces_.end(), QuadMesh::face(h));
        const Corner corner{static_cast<std::size_t>(found - faces_.begin()), static_cast<std::size_t>(h.index() & 3)};
        corners_.push_back(corner);
        unknowns_[corner.face][corner.k] = static_cast<int>(i);
      });
    }
    first_corner_.push_back(corners_.size());
    ideals_.resize(faces_.size());
    derivatives_.resize(options.joint ? faces_.size() : 0);
    energies_.resize(faces_.size());
    colour();
  }

  void run() {
    for (int round = 0; round < options_.rounds; ++round) {
      homes_.settle(m_, positions_, faces_, options_.run);
      look();
      if (options_.joint) step_jointly();
      for (int sweep = 0; sweep < options_.sweeps; ++sweep) step_each();
    }
    homes_.settle(m_, positions_, faces_, options_.run);
  }

 private:
  struct Corner {      // of one of the faces
    std::size_t face;  // in faces_
    std::size_t k;
  };
  struct Around {  // a vertex
    std::size_t face;
    std::size_t k;  // the vertex's corner
    QuadCorners corners;
  };
  struct Pulled {  // a sample whose home moves with the vertex
    const Correspondence::Sample* sample;
    double weight;
    Vector3d residual;
  };
  struct Foot {  // the nearest point of the surface
    Vector3d point;
    Vector3d normal;
  };
  struct StepMemory {  // of one vertex
    std::vector<Around> around;
    std::vector<Pulled> pulled;
  };

  // Calls body(i) for each i < count, on several threads if there are some.
  template <class Body>
  void each(std::size_t count, Body&& body) const {
    in_chunks(options_.run, count, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) body(i);
    });
  }

  // Gives each vertex the first colour that no vertex of its faces before it has.
  void colour() {
    std::vector<std::size_t> colours(vertices_.size());
    std::vector<std::size_t> taken_by;  // of each colour, the last vertex with a neighbour that has it, and 1
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      for (std::size_t c = first_corner_[i]; c < first_corner_[i + 1]; ++c) {
        for (const int k : unknowns_[corners_[c].face]) {
          if (k >= 0 && static_cast<std::size_t>(k) < i) taken_by[colours[static_cast<std::size_t>(k)]] = i + 1;
        }
      }
      const auto free = std::find_if(taken_by.begin(), taken_by.end(), [i](std::size_t v) { return v != i + 1; });
      colours[i] = static_cast<std::size_t>(free - taken_by.begin());
      if (free == taken_by.end()) {
        taken_by.push_back(0);
        coloured_.emplace_back();
      }
      coloured_[colours[i]].push_back(i);
    }
  }

  // Finds what a round needs of the surface.
  void look() {
    each(faces_.size(), [this](std::size_t f) { ideals_[f] = ideal_of(corners_of(f), faces_[f], homes_, surface_); });
    const bool first = feet_.empty();
    feet_.resize(vertices_.size());
    each(vertices_.size(), [&](std::size_t i) {
      const Vector3d& at = positions_[vertices_[i].slot()];
      const SurfaceIndex::Nearest nearest = surface_.nearest(at, first ? near_sample(i) : feet_[i].point);
      feet_[i] = {nearest.point, homes_.surface_normal(nearest.face)};
    });
  }
  // A point of the surface near the vertex: the nearest of the samples at home on one of its faces, or infinity.
  Vector3d near_sample(std::size_t i) const {
    const Vector3d& at = positions_[vertices_[i].slot()];
    Vector3d best = Vector3d::Constant(std::numeric_limits<double>::infinity());
    for (std::size_t c = first_corner_[i]; c < first_corner_[i + 1] && !best.allFinite(); ++c) {
      homes_.for_each_sample(faces_[corners_[c].face], [&](std::size_t s) {
        const Vector3d& point = homes_.sample(s).point;
        if ((point - at).squaredNorm() < (best - at).squaredNorm()) best = point;
      });
    }
    return best;
  }

  double foot_weight() const { return 0.25 * homes_.mean_weight(); }
  static constexpr double kFootAlong = 0.01;
  double foot_energy(std::size_t i, const Vector3d& at) const {
    return foot_weight() * distance_energy(at - feet_[i].point, feet_[i].normal, kFootAlong, tolerance2_);
  }

  QuadCorners corners_of(std::size_t face) const {
    const auto at = [&](int k) { return positions_[m_.origin(QuadMesh::half_edge(faces_[face], k)).slot()]; };
    return {at(0), at(1), at(2), at(3)};
  }
  // E(f), with the ideal that was looked up.
  double energy(std::size_t face, const QuadCorners& corners) const {
    double sum = options_.quality / 4 * shape_energy(corners, ideals_[face]);
    homes_.for_each_sample(faces_[face], [&](std::size_t s) {
      const Correspondence::Sample& sample = homes_.sample(s);
      sum += sample.weight * distance_energy(residual(s, corners), sample.normal, sample.along, tolerance2_);
    });
    return sum;
  }
  Vector3d residual(std::size_t s, const QuadCorners& corners) const {
    Vector3d r = -homes_.sample(s).point;
    for (std::size_t k = 0; k < 4; ++k) r += homes_.home(s).weights[k] * corners[k];
    return r;
  }

  // Each vertex alone, one colour after another.
  void step_each() {
    for (const std::vector<std::size_t>& apart : coloured_) {
      in_chunks(options_.run, apart.size(), [&](std::size_t first, std::size_t last) {
        StepMemory memory;
        for (std::size_t i = first; i < last; ++i) step(apart[i], memory);
      });
    }
  }
  void step(std::size_t i, StepMemory& memory) {
    const VertexId v = vertices_[i];
    Vector3d& at = positions_[v.slot()];
    memory.around.clear();
    for (std::size_t c = first_corner_[i]; c < first_corner_[i + 1]; ++c)
      memory.around.push_back({corners_[c].face, corners_[c].k, corners_of(corners_[c].face)});
    CornerDerivatives sums;
    const Distance off = distance(at - feet_[i].point, feet_[i].normal, kFootAlong, tolerance2_);
    sums.gradient = foot_weight() * off.gradient;
    sums.hessian = foot_weight() * off.hessian;
    double before = foot_weight() * off.energy;
    memory.pulled.clear();
    for (const Around& face : memory.around) {
      homes_.for_each_sample(faces_[face.face], [&](std::size_t s) {
        const double w = homes_.home(s).weights[face.k];
        if (w == 0) return;
        const Correspondence::Sample& sample = homes_.sample(s);
        const Vector3d r = residual(s, face.corners);
        memory.pulled.push_back({&sample, w, r});
        const Distance d = distance(r, sample.normal, sample.along, tolerance2_);
        before += sample.weight * d.energy;
        sums.gradient += (sample.weight * w) * d.gradient;
        sums.hessian += (sample.weight * w * w) * d.hessian;
      });
      const double factor = options_.quality / 4;
      before += factor * shape_energy(face.corners, ideals_[face.face]);
      add_shape(face.corners, face.k, ideals_[face.face], factor, sums);
    }
    const Vector3d newton = -sums.hessian.ldlt().solve(sums.gradient);
    if (!newton.allFinite()) return;
    double length = 1;
    for (int attempt = 0; attempt <= kMostHalvings; ++attempt, length /= 2) {
      const Vector3d step = length * newton;
      double after = foot_energy(i, at + step);
      for (const Pulled& p : memory.pulled) {
        after += p.sample->weight *
                 distance_energy(p.residual + p.weight * step, p.sample->normal, p.sample->along, tolerance2_);
      }
      for (Around& face : memory.around) {
        face.corners[face.k] = at + step;
        after += options_.quality / 4 * shape_energy(face.corners, ideals_[face.face]);
      }
      if (!(after < before)) continue;
      at += step;
      return;
    }
  }

  // All vertices at once.
  void step_jointly() {
    if (vertices_.empty()) return;
    const auto size = static_cast<Eigen::Index>(3 * vertices_.size());
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(size);
    entries_.clear();
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const Vector3d r = positions_[vertices_[i].slot()] - feet_[i].point;
      const Distance off = distance(r, feet_[i].normal, kFootAlong, tolerance2_);
      const auto row = static_cast<int>(3 * i);
      gradient.segment<3>(row) += foot_weight() * off.gradient;
      add_block(row, row, foot_weight() * off.hessian);
    }
    double before = 0;
    each(faces_.size(), [this](std::size_t f) { energies_[f] = derive(f, derivatives_[f]); });
    for (std::size_t f = 0; f < faces_.size(); ++f) add_face(f, gradient);
    before += sum_of_energies();
    for (std::size_t i = 0; i < vertices_.size(); ++i) before += foot_energy(i, positions_[vertices_[i].slot()]);
    Eigen::SparseMatrix<double> hessian(size, size);
    hessian.setFromTriplets(entries_.begin(), entries_.end());
    // Conjugate gradients lead downhill however early they stop.
    solver_.setTolerance(kEnough);
    solver_.setMaxIterations(kMostIterations);
    solver_.compute(hessian);
    const Eigen::VectorXd newton = -solver_.solve(gradient);
    if (!newton.allFinite()) return;
    from_.clear();
    for (const VertexId v : vertices_) from_.push_back(positions_[v.slot()]);
    double length = 1;
    for (int attempt = 0; attempt <= kMostHalvings; ++attempt, length /= 2) {
      double after = 0;
      for (std::size_t i = 0; i < vertices_.size(); ++i) {
        Vector3d& at = positions_[vertices_[i].slot()];
        at = from_[i] + length * newton.segment<3>(static_cast<Eigen::Index>(3 * i));
        after += foot_energy(i, at);
      }
      each(faces_.size(), [this](std::size_t f) { energies_[f] = energy(f, corners_of(f)); });
      after += sum_of_energies();
      if (after < before) return;
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i) positions_[vertices_[i].slot()] = from_[i];
  }
  double sum_of_energies() const { return std::accumulate(energies_.begin(), energies_.end(), 0.0); }
  // Finds the derivatives of E(f), and returns E(f).
  double derive(std::size_t face, QuadDerivatives& sums) const {
    const QuadCorners corners = corners_of(face);
    sums = {};
    add_shape(corners, ideals_[face], options_.quality / 4, sums);
    double sum = options_.quality / 4 * shape_energy(corners, ideals_[face]);
    homes_.for_each_sample(faces_[face], [&](std::size_t s) {
      const Correspondence::Sample& sample = homes_.sample(s);
      const std::array<double, 4>& weights = homes_.home(s).weights;
      const Distance d = distance(residual(s, corners), sample.normal, sample.along, tolerance2_);
      sum += sample.weight * d.energy;
      for (std::size_t i = 0; i < 4; ++i) {
        if (weights[i] == 0) continue;
        const auto row = static_cast<Eigen::Index>(3 * i);
        sums.gradient.segment<3>(row) += (sample.weight * weights[i]) * d.gradient;
        for (std::size_t k = 0; k < 4; ++k) {
          if (weights[k] == 0) continue;
          sums.hessian.block<3, 3>(row, static_cast<Eigen::Index>(3 * k)) +=
              (sample.weight * weights[i] * weights[k]) * d.hessian;
        }
      }
    });
    return sum;
  }
  void add_face(std::size_t face, Eigen::VectorXd& gradient) {
    const QuadDerivatives& sums = derivatives_[face];
    for (int i = 0; i < 4; ++i) {
      const int row = unknowns_[face][static_cast<std::size_t>(i)];
      if (row < 0) continue;
      gradient.segment<3>(3 * row) += sums.gradient.segment<3>(3 * i);
      for (int k = 0; k < 4; ++k) {
        const int column = unknowns_[face][static_cast<std::size_t>(k)];
        if (column >= 0 && column <= row) add_block(3 * row, 3 * column, sums.hessian.block<3, 3>(3 * i, 3 * k));
      }
    }
  }
  // Below the diagonal, which is all that the solver reads.
  void add_block(int row, int column, const Matrix3d& block) {
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        if (row + i >= column + k) entries_.emplace_back(row + i, column + k, block(i, k));
      }
    }
  }

  const QuadMesh& m_;
  Positions& positions_;
  Correspondence& homes_;
  const SurfaceIndex& surface_;
  const FitOptions& options_;
  double tolerance2_ = options_.tolerance * options_.tolerance;
  std::vector<VertexId> vertices_;            // those that may move
  std::vector<FaceId> faces_;                 // round all that were given
  std::vector<Corner> corners_;               // of all faces that lie at one of vertices_, vertex by vertex
  std::vector<std::size_t> first_corner_;     // of each vertex, and one more
  std::vector<std::array<int, 4>> unknowns_;  // of each face, the places of its corners in vertices_, or -1
  std::vector<IdealQuad> ideals_;             // of faces_
  std::vector<Foot> feet_;                    // of vertices_
  std::vector<std::vector<std::size_t>>
      coloured_;                              // by colour, places in vertices_ of which no two have a face together
  std::vector<QuadDerivatives> derivatives_;  // of faces_, in a joint step
  std::vector<double> energies_;              // of faces_, in a joint step
  std::vector<Vector3d> from_;                // positions of vertices_ before a joint step
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower> solver_;
};

}  // namespace

void fit(const QuadMesh& m, Positions& positions, std::span<const VertexId> vertices, Correspondence& homes,
         const SurfaceIndex& surface, const FitOptions& options) {
  Fitter(m, positions, vertices, homes, surface, options).run();
}

}  // namespace requad::mesh
