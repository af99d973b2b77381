// A region on a page, with the marks of the paper's figures.
//
// Legend of all figures. A shape says what a colour says (style.hpp).
//   irregular vertex   a polygon with as many corners as its valence: v3 blue, v5 orange, v6 red, v2 (a rhombus) purple;
//                      from v7 on a star with as many points
//   R_alpha            blue quads; its ring, the smallest convex region with the pair, grey
//   face               made: yellow with a plus; deleted: red with a cross; both signs stand upright on the page
#pragma once

#include <span>

#include "mesh/pictures/canvas.hpp"
#include "mesh/topology/region.hpp"

namespace requad::pictures {

inline constexpr double kMarkRadius = 4.6;  // of an irregular vertex, where its edges are long enough

// Draws the mark of an irregular vertex, filled with the colour of its valence unless another is given.
void mark_vertex(Canvas& canvas, Point at, int valence, double radius);
void mark_vertex(Canvas& canvas, Point at, int valence, double radius, Colour fill, Colour outline);
void mark_star(Canvas& canvas, Point at, double radius, Colour colour);

class MeshPicture {
 public:
  // The region as mesh::draw() draws it, with edges about `unit` points long and the centre of its outline at `centre`,
  // turned counter-clockwise by an angle in radians.
  MeshPicture(mesh::Region region, Point centre, double unit, double angle = 0);

  // The same picture elsewhere: moved by a vector, or with the middle of its bounding box at the origin. O(V).
  MeshPicture moved(const Point& by) const;
  MeshPicture centred() const { return moved(-(low_ + high_) / 2); }

  const mesh::Region& region() const { return region_; }
  const mesh::QuadMesh& mesh() const { return region_.mesh; }
  Point at(mesh::VertexId v) const { return at_[v.slot()]; }
  Point middle(mesh::FaceId f) const;
  Point low() const { return low_; }    // lower left corner of the bounding box
  Point high() const { return high_; }  // upper right corner

  void background(Canvas& canvas, Colour colour) const;
  void faces(Canvas& canvas, std::span<const mesh::FaceId> faces, Colour colour) const;
  void made(Canvas& canvas, std::span<const mesh::FaceId> faces) const;
  void deleted(Canvas& canvas, std::span<const mesh::FaceId> faces) const;
  // Draws all edges, with the boundary twice as thick. Each straight path of edges becomes one line of the picture.
  void edges(Canvas& canvas, Colour colour, double width = 0.5) const;
  void edges(Canvas& canvas) const { edges(canvas, canvas.palette().line); }
  void boundary(Canvas& canvas, const Stroke& stroke) const;
  // Draws a path of half-edges, each of which starts where the one before it ends.
  void path(Canvas& canvas, std::span<const mesh::HalfEdgeId> half_edges, const Stroke& stroke) const;
  // Marks all irregular vertices, or draws faint outlines of their marks.
  void irregular(Canvas& canvas) const;
  void faint_irregular(Canvas& canvas) const;
  // The radius of a vertex's mark: kMarkRadius, or less where its edges are short.
  double mark_radius(mesh::VertexId v) const;
  // The line of straight segments along half-edges.
  Polyline line(std::span<const mesh::HalfEdgeId> half_edges) const;
  Polyline outline() const;

 private:
  std::pair<Point, double> roomiest(mesh::FaceId f) const;
  // Draws a plus or, turned by an eighth, a cross in each face. It keeps away from sides and marks.
  void signs(Canvas& canvas, std::span<const mesh::FaceId> faces, Colour colour, double turned) const;

  mesh::Region region_;
  std::vector<Point> at_;
  Point low_, high_;
};

}  // namespace requad::pictures
