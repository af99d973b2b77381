// A correspondence: where each sample of a surface lies on a mesh that is edited.
//
// Terms
//   surface   A mesh with positions that stay as they are: the input of an edit. It is taken at its vertices, the
//             midpoints of its edges and the centres of its faces: its samples.
//   home      of a sample: a point of the edited mesh, as a face and the weights of its corners. At the start the edited
//             mesh is the surface, and each sample is at home where it lies.
//   residual  of a sample: its home less the sample. If all residuals vanish, the mesh covers the surface.
//
// The nearest point of the mesh would not do as a home: the two sides of an ear are near each other, and where an edit
// has cut off the ear, its samples all have the wrong nearest point. Homes are kept through each edit instead. What lay
// on a face that was removed moves across the nearest of its edges, and then each sample follows the mesh, from face to
// face, downhill to a point that is nearer to it than all around.
//
// Law geometry-8. roll_back(mark) restores each home of that mark to the last bit, and the order in which
//         for_each_sample() visits a face.
//
// Costs: O(1) per sample for each face that it leaves; memory of about 150 bytes per sample.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "mesh/geometry/in_chunks.hpp"
#include "mesh/geometry/measures.hpp"

namespace requad::mesh {

class Correspondence {
 public:
  struct Sample {
    Eigen::Vector3d point;
    Eigen::Vector3d normal;  // of the surface, the mean where faces meet; zero if they have none
    double area;             // the mean area of the faces of the surface there
    double along;   // in 0..1, what a distance along the surface counts for, squared: 1 at tips and sharp edges
    double weight;  // 1 / squared length, so that the weighted square of a residual is a number
  };
  struct Home {
    FaceId face;
    std::array<double, 4> weights;  // of the corners, 0 or more; their sum is 1, and one of them is 0
  };

  // Takes the samples of the mesh, each at home where it lies. Precondition: the mesh has a face. O(F).
  Correspondence(const QuadMesh& mesh, const Positions& positions);

  std::size_t size() const { return samples_.size(); }
  // The mean of 1 / squared length over the faces of the surface.
  double mean_weight() const { return mean_weight_; }
  // The unit normal and the area of a face of the surface.
  const Eigen::Vector3d& surface_normal(FaceId f) const { return normals_[f.slot()]; }
  double surface_area(FaceId f) const { return areas_[f.slot()]; }
  const Sample& sample(std::size_t i) const { return samples_[i]; }
  const Home& home(std::size_t i) const { return homes_[i].home; }
  // Calls visit(i) for each sample at home on the face. It must not move samples.
  template <class Visit>
  void for_each_sample(FaceId f, Visit&& visit) const {
    if (f.slot() >= first_.size()) return;
    for (int i = first_[f.slot()]; i >= 0; i = homes_[static_cast<std::size_t>(i)].next)
      visit(static_cast<std::size_t>(i));
  }
  // The home as a point, and the residual.
  Eigen::Vector3d point_at(const QuadMesh& mesh, const Positions& positions, const Home& home) const;
  Eigen::Vector3d residual(const QuadMesh& mesh, const Positions& positions, std::size_t i) const {
    return point_at(mesh, positions, homes_[i].home) - samples_[i].point;
  }

  // Moves the samples of a face that is removed across its edges, each across the edge that it is nearest to.
  // beside[k]: the face beyond the edge of corner k and the next, if there is one. Their weights are to be found by
  // settle() then. Precondition: at least one is there.
  void leave(FaceId removed, const std::array<FaceId, 4>& beside);
  // Moves the samples of these faces, which are live, to points nearest to them: from face to adjacent face as long as
  // a nearer point is met. The faces may name one face more than once. About a microsecond for each sample that stays.
  void settle(const QuadMesh& mesh, const Positions& positions, std::span<const FaceId> faces,
              const RunTasks& run = {});

  // A place in the history of the homes, to which they can be rolled back; forget() empties the history.
  std::size_t mark() const { return moves_.size(); }
  void roll_back(std::size_t mark);
  void forget() { moves_.clear(); }

 private:
  struct Node {
    Home home;
    int next = -1;  // in the list of the face
    int previous = -1;
  };
  struct Move {
    int sample;
    Node before;
  };

  int& first(FaceId f);
  void add(const Eigen::Vector3d& point, const Eigen::Vector3d& normals, int count, double area, double weight,
           const Home& home);
  void move(int sample, const Home& home);
  Home settled(const QuadMesh& mesh, const Positions& positions, std::size_t sample) const;

  double mean_weight_ = 0;
  std::vector<Eigen::Vector3d> normals_;  // by face slot of the surface
  std::vector<double> areas_;
  std::vector<Sample> samples_;
  std::vector<Node> homes_;
  std::vector<int> first_;  // by face slot
  std::vector<Move> moves_;
  std::vector<int> settling_;  // samples, in settle()
  std::vector<Home> settled_;  // their homes
};

// The point of a face that is nearest to p, as the weights of its corners, with its squared distance.
struct NearestOnFace {
  std::array<double, 4> weights;
  double squared;
};
NearestOnFace nearest_on_face(const QuadMesh& mesh, const Positions& positions, FaceId f, const Eigen::Vector3d& p);

}  // namespace requad::mesh
