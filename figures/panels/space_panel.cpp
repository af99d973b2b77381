#include "figures/panels/space_panel.hpp"

#include <algorithm>
#include <map>
#include <memory>

namespace requad::figures {

using Eigen::Vector3d;
using mesh::VertexId;

Setting setting_for(const Stage& stage, const View& view, double size) {
  const Eigen::Matrix3d frame = view.frame();
  const std::vector<VertexId> vertices = stage.mesh.vertices();
  Vector3d low = frame * stage.positions[vertices.front().slot()], high = low;
  for (const VertexId v : vertices) {
    const Vector3d p = frame * stage.positions[v.slot()];
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Point extent = (high - low).head<2>();
  const double scale = size / extent.maxCoeff();
  return {view, frame.transpose() * (low + high) / 2, scale, scale * extent};
}

namespace {

// From the rim of a vertex's mark to the middle of the number at the head.
void paint_arrow(Canvas& canvas, const SpacePicture& picture, const SpaceArrow& arrow, const Point& by) {
  constexpr double kHead = 7, kWidth = 2, kShortest = 17;
  const Point from = picture.at(arrow.from) + by, along = (picture.at(arrow.to) + by - from).normalized();
  const double start = picture.mark_radius() + 1;
  const Point tip = from + along * std::max((picture.at(arrow.to) + by - from).norm(), start + kShortest);
  const Colour colour = canvas.palette().*arrow.colour;
  canvas.stroke({{from + start * along, tip - kHead / 2 * along}}, {canvas.palette().paper, kWidth + 2});
  canvas.arrow(from + start * along, tip, {colour, kWidth}, kHead);
  const Point middle = tip + along * (0.65 * canvas.em());
  canvas.label(middle - Point(0, 0.35 * canvas.em()), arrow.label, canvas.palette().ink);
}

}  // namespace

Cell cell(const SpacePanel& panel, const Setting& setting) {
  const SpaceSubject subject{panel.stage.mesh, panel.stage.positions, panel.stage.features};
  auto picture = std::make_shared<SpacePicture>(subject, setting.view, setting.origin, Point(0, 0), setting.scale,
                                                panel.checkerboard);
  Cell cell{setting.size, {}, panel.words, {}};
  cell.paint = [picture, arrows = panel.arrows](Canvas& canvas, const Point& centre) {
    picture->paint(canvas, centre);
    for (const SpaceArrow& arrow : arrows) paint_arrow(canvas, *picture, arrow, centre);
  };
  return cell;
}

std::string irregular_words(const Stage& stage) {
  std::map<int, int> counts;
  for (const VertexId v : mesh::irregular_vertices(stage.mesh)) ++counts[stage.mesh.valence(v)];
  std::string words;
  for (const auto& [valence, count] : counts)
    words += (words.empty() ? "" : ", ") + std::to_string(count) + " v" + std::to_string(valence);
  const int all = stage.irregular();
  if (counts.size() < 2) return words.empty() ? "no irregular vertices" : words;
  return std::to_string(all) + " irregular vertices: " + words;
}

}  // namespace requad::figures
