#include "figures/panels/panel.hpp"

#include <algorithm>

#include "enumerate/generators.hpp"

namespace requad::figures {

namespace {

// An arrow from a vertex, clear of its mark and at least kShortest long.
void paint_direction(Canvas& canvas, const MeshPicture& picture, mesh::HalfEdgeId h, double aside) {
  constexpr double kShortest = 19, kBeyond = 6;
  const mesh::VertexId v = picture.mesh().origin(h);
  const Point edge = picture.at(picture.mesh().target(h)) - picture.at(v);
  const Point along = edge.normalized();
  const Point from = picture.at(v) + aside * Point(-along.y(), along.x());
  const double start = picture.mark_radius(v) + 1;
  const Point tip = from + along * std::max(edge.norm() + kBeyond, start + kShortest);
  canvas.stroke({{from + start * along, tip - 4 * along}}, {canvas.palette().paper, 4.5});
  canvas.arrow(from + start * along, tip, {canvas.palette().side, 2}, 8);
}

}  // namespace

mesh::Region region_with(theory::PairType type, theory::Integer d1, theory::Integer d2,
                         const std::vector<theory::Integer>& strips) {
  theory::Configuration c;
  c.parameters = {d1, d2, theory::to_vector(strips)};
  return enumerate::glue_region(type, c);
}

Stroke stroke_of(const Canvas& canvas, Panel::Line::Kind kind) {
  switch (kind) {
    case Panel::Line::Kind::path: return {canvas.palette().path, 2.4};
    case Panel::Line::Kind::feature: return {canvas.palette().ink, 3.4};
    case Panel::Line::Kind::thin: return {canvas.palette().path, 1.1};
  }
  return {};
}

void paint_panel(Canvas& canvas, const Panel& panel, const MeshPicture& picture) {
  picture.background(canvas, canvas.palette().paper);
  picture.faces(canvas, panel.stay, canvas.palette().stay);
  picture.faces(canvas, panel.grey, canvas.palette().ring);
  picture.faces(canvas, panel.blue, canvas.palette().pair);
  picture.made(canvas, panel.made);
  picture.deleted(canvas, panel.deleted);
  picture.edges(canvas);
  for (const Panel::Line& line : panel.lines) picture.path(canvas, line.path, stroke_of(canvas, line.kind));
  for (const mesh::VertexId v : panel.dots)
    canvas.circle(picture.at(v), 3, canvas.palette().faint, Stroke{canvas.palette().ink, 0.5});
  picture.irregular(canvas);
  if (panel.direction.valid()) paint_direction(canvas, picture, panel.direction, panel.aside);
  if (panel.overlay) panel.overlay(canvas, picture);
}

}  // namespace requad::figures
