#include "figures/pictures/panel.hpp"

#include "enumerate/generators.hpp"

namespace requad::figures {

mesh::Region region_with(theory::PairType type, theory::Integer d1, theory::Integer d2,
                         const std::vector<theory::Integer>& strips) {
  theory::Configuration c;
  c.parameters = {d1, d2, theory::to_vector(strips)};
  return enumerate::glue_region(type, c);
}

void paint_panel(Canvas& canvas, const Panel& panel, Point centre, double unit, double angle, double text) {
  const MeshPicture picture(panel.region, centre, unit, angle);
  picture.background(canvas, rgb(0xffffff));
  picture.faces(canvas, panel.stay, ink::kIce);
  picture.faces(canvas, panel.grey, ink::kGrey);
  picture.faces(canvas, panel.blue, ink::kPaleBlue);
  picture.made(canvas, panel.made);
  picture.deleted(canvas, panel.deleted);
  picture.edges(canvas);
  for (const Panel::Line& line : panel.lines) {
    if (!line.arrow) {
      picture.path(canvas, line.path, line.stroke);
    } else {
      canvas.arrow(picture.at(picture.mesh().origin(line.path.front())),
                   picture.at(picture.mesh().target(line.path.back())), line.stroke);
    }
  }
  for (const mesh::VertexId v : panel.dots) canvas.circle(picture.at(v), 3, ink::kFaint, Stroke{ink::kBlack, 0.5});
  picture.irregular(canvas, 4.6);
  Point below((picture.low().x() + picture.high().x()) / 2, picture.low().y() - 1.5 * text);
  for (const std::string& line : panel.words) {
    canvas.text(below, line, text);
    below.y() -= 1.25 * text;
  }
}

}  // namespace requad::figures
