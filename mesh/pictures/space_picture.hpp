// Pictures of meshes in space: parallel projection, hidden surfaces removed, one light.
//
// Terms
//   view   The direction from the mesh to the viewer, by two angles in degrees: its elevation over the horizontal plane,
//          and its azimuth, which is 0 in front (z points to the viewer, y up; with `z_up`, y points away and z up) and
//          grows to the right of the mesh.
//   scale  Points on the page for each unit of length.
//
// Legend, beside that of mesh_picture.hpp
//   quad       light, or in the two colours of a checkerboard; brown as seen from the back; pink if it is inverted
//   edge       thin; features bold and black, boundaries bold and green
//   irregular vertex   its polygon if it is not hidden
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "mesh/geometry/measures.hpp"
#include "mesh/pictures/canvas.hpp"
#include "mesh/pictures/hidden_surface.hpp"
#include "mesh/topology/quad_mesh.hpp"

namespace requad::pictures {

struct View {
  double azimuth = 30;
  double elevation = 20;
  bool z_up = false;

  // The rows point right, up and to the viewer. It is orthogonal.
  Eigen::Matrix3d frame() const;
};

// The view of a mesh for which none is asked: from the front if all vertices have the same z, else the default.
View usual_view(const mesh::QuadMesh& mesh, const mesh::Positions& positions);

struct SpaceSubject {
  const mesh::QuadMesh& mesh;
  const mesh::Positions& positions;
  std::span<const std::array<mesh::VertexId, 2>> features = {};
  std::vector<std::string> words = {};  // lines of text below the mesh
};

class SpacePicture {
 public:
  // The mesh with the point `origin` of space at `centre` of the page. With `checkerboard`, neighbouring quads have
  // different colours wherever a greedy colouring achieves it; where it does not, an irregular vertex of odd valence is
  // the reason. O(F log F) in practice (hidden_surface.hpp).
  SpacePicture(const SpaceSubject& subject, const View& view, const Eigen::Vector3d& origin, Point centre, double scale,
               bool checkerboard);

  // Paints the picture, moved on the page by a vector.
  void paint(Canvas& canvas, const Point& by = Point::Zero()) const;
  // Where a point of space lies on the page, and whether the mesh hides it.
  Point at(const Eigen::Vector3d& p) const { return projected(p).head<2>(); }
  bool hides(const Eigen::Vector3d& p) const { return surface_.covers(projected(p)); }
  // The radius of an irregular vertex's mark.
  double mark_radius() const;
  Point low() const { return low_; }    // lower left corner of the bounding box
  Point high() const { return high_; }  // upper right corner

 private:
  enum class Line : char { plain, feature, boundary };
  struct Quad {
    Colour Palette::*front;
    Colour Palette::*back;
    double front_light, back_light;
    std::array<Line, 4> sides;
  };
  struct Mark {
    Point at;
    int valence;
  };
  Eigen::Vector3d projected(const Eigen::Vector3d& p) const;

  Eigen::Matrix3d frame_;
  Eigen::Vector3d origin_;
  Point centre_, low_, high_;
  double scale_;
  double edge_ = 1;  // a usual length of an edge on the page, in points
  std::vector<Quad> quads_;
  HiddenSurface surface_;
  std::vector<Mark> marks_;
  std::vector<std::string> words_;
};

// The meshes beside each other, in the same view and scale. Each is `size` points wide or high at most.
Paint side_by_side(const std::vector<SpaceSubject>& subjects, const View& view, bool checkerboard, double size = 480);

}  // namespace requad::pictures
