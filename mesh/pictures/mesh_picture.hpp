// A region on a page, with the marks of the paper's figures.
//
// Legend of all figures. A shape says what a colour says, for print without colours and for readers who do not see
// them. The colours are Okabe and Ito's palette and tints of it.
//   irregular vertex   a polygon with as many corners as its valence: v3 blue, v5 orange, v6 and more red,
//                      v2 (a rhombus) purple
//   R_alpha            blue quads; its ring, the smallest convex region with the pair, grey
//   face               made: yellow with a plus; deleted: red with a cross
#pragma once

#include <span>

#include "mesh/pictures/canvas.hpp"
#include "mesh/topology/region.hpp"

namespace requad::pictures {

namespace ink {
inline constexpr Colour kBlack = rgb(0x000000);
inline constexpr Colour kLine = rgb(0x404040);  // edges of meshes
inline constexpr Colour kFaint = rgb(0x9a9a9a);
inline constexpr Colour kBlue = rgb(0x0072b2);
inline constexpr Colour kOrange = rgb(0xe69f00);
inline constexpr Colour kRed = rgb(0xd55e00);
inline constexpr Colour kPurple = rgb(0xcc79a7);
inline constexpr Colour kGreen = rgb(0x009e73);
inline constexpr Colour kPaleBlue = rgb(0x8fc3e3);  // R_alpha
inline constexpr Colour kGrey = rgb(0xdedede);      // its ring
inline constexpr Colour kYellow = rgb(0xf6ec7a);    // made
inline constexpr Colour kPaleRed = rgb(0xf0a080);   // deleted
inline constexpr Colour kIce = rgb(0xdcecf6);       // strips that stay
}  // namespace ink

// The colour of irregular vertices of a valence.
Colour valence_colour(int valence);
// Draws the polygon of an irregular vertex. The radius, here and below, is in points.
void mark_vertex(Canvas& canvas, Point at, int valence, double radius);
void mark_star(Canvas& canvas, Point at, double radius, Colour colour);

class MeshPicture {
 public:
  // The region as mesh::draw() draws it, with edges about `unit` points long and the centre of its outline at `centre`,
  // turned counter-clockwise by an angle in radians.
  MeshPicture(mesh::Region region, Point centre, double unit, double angle = 0);

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
  void edges(Canvas& canvas, double width = 0.5, Colour colour = ink::kLine) const;
  void boundary(Canvas& canvas, const Stroke& stroke) const;
  // Draws a path of half-edges, each of which starts where the one before it ends.
  void path(Canvas& canvas, std::span<const mesh::HalfEdgeId> half_edges, const Stroke& stroke) const;
  // Marks all irregular vertices.
  void irregular(Canvas& canvas, double radius) const;

 private:
  Polyline outline() const;
  // Draws a plus (upright) or a cross in each face.
  void crosses(Canvas& canvas, std::span<const mesh::FaceId> faces, Colour colour, bool upright) const;

  mesh::Region region_;
  std::vector<Point> at_;
  Point low_, high_;
};

}  // namespace requad::pictures
