// A mesh that is symmetric about a plane, and edits of it that keep it so.
//
// Terms
//   plane     x = c, y = c or z = c, through the middle of the bounding box.
//   image     of a vertex: the vertex where its reflection lies. The images of a face's corners, in reverse order, are the
//             corners of a face. A vertex on the plane is its own image.
//   followed  An edit on one side of the plane is, if the same is done with the images on the other side.
//
// Law editing-22. After follow() and symmetrise() the mesh is symmetric: each vertex has an image, and its reflection has
//         the coordinates of the image, to the last bit if c = 0. Fixed vertices keep their positions.
//
// Costs: O(V log V) to find the images, O(edits) to follow them. The changes of images are kept until they are rolled back.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "mesh/editing/editor.hpp"

namespace requad::mesh {

enum class Axis { x, y, z };  // the normal of the plane

class Mirror {
 public:
  // The distance of a vertex from the reflection of its image, over the diagonal, that still counts as symmetric.
  static constexpr double kTolerance = 1e-5;

  // Nothing if the mesh is not symmetric; then `without_image`, if given, becomes a vertex without an image, or one with a
  // face that has none.
  static std::optional<Mirror> find(const QuadMesh& mesh, const Positions& positions, Axis axis,
                                    VertexId* without_image = nullptr);

  VertexId image(VertexId v) const { return v.slot() < images_.size() ? images_[v.slot()] : VertexId(); }
  // On which side of the plane the vertex lies: -1, 1, or 0 if it is its own image.
  int side(const Positions& positions, VertexId v) const {
    return image(v) == v ? 0 : positions[v.slot()][axis_] < plane_ ? -1 : 1;
  }

  // Performs on the other side what the editor has performed since the mark. Returns whether this is possible, and leaves
  // a symmetric mesh; if not, the editor and this object must be rolled back to where they were before.
  bool follow(Editor& editor, std::size_t mark);
  // Moves these vertices and their images, as one edit, so that they lie where reflections of one another are. Those on
  // the plane move onto it. Precondition: the editor has positions, and the vertices are live.
  void symmetrise(Editor& editor, std::span<const VertexId> vertices) const;

  // A place in the history of the images, to which they can be rolled back.
  std::size_t mark() const { return changes_.size(); }
  void roll_back(std::size_t mark);

 private:
  Mirror(Axis axis, double plane) : axis_(static_cast<Eigen::Index>(axis)), plane_(plane) {}

  std::optional<BasicOperation> image_of(const QuadMesh& mesh, const Edit& edit) const;
  void set_image(VertexId v, VertexId image);
  bool has_faces_mirrored(const QuadMesh& mesh, VertexId v) const;

  Eigen::Index axis_;
  double plane_;                                        // its coordinate
  std::vector<VertexId> images_;                        // by vertex slot
  std::vector<std::pair<VertexId, VertexId>> changes_;  // vertices, and the images that they had before
};

}  // namespace requad::mesh
