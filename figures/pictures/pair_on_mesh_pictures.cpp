// Figure 9: the four moves of a pair as four pairs of arrows on a mesh in space.
#include <algorithm>

#include "figures/panels/space_panel.hpp"
#include "figures/pictures/paper_pictures.hpp"
#include "mesh/geometry/drawing.hpp"
#include "mesh/irregular/possible_moves.hpp"

namespace requad::figures {

namespace {

using Eigen::Vector3d;
using mesh::VertexId;

constexpr int kRounds = 20;
constexpr std::array<Colour Palette::*, 4> kColours{&Palette::odd, &Palette::side, &Palette::path, &Palette::ink};

// A region, bent: v3s lie on a dome and v5s on a saddle.
Stage bent(const mesh::Region& region, double x_bend, double y_bend) {
  Stage stage{region.mesh, {}};
  const std::vector<Eigen::Vector2d> flat = mesh::draw(region);
  for (const Eigen::Vector2d& p : flat) {
    const double x = p.x(), y = p.y();
    stage.positions.emplace_back(x, y, -x_bend * x * x - y_bend * y * y);
  }
  return stage;
}

// Each move is made, with the mesh fitted to the surface, and seen where it brings the two vertices.
std::vector<SpaceArrow> arrows_of_moves(const Stage& stage, std::array<VertexId, 2> pair) {
  Stage edited = stage;
  mesh::Editor editor(edited.mesh, nullptr, &edited.positions);
  mesh::ShapeKeeper shape(editor);
  std::vector<SpaceArrow> arrows;
  int number = 0;
  require_performed(mesh::for_each_move(editor, pair[0], pair[1], [&](const mesh::PossibleMove& move) {
    require_performed(move.refusal);
    shape.fit_since(0, kRounds);
    for (std::size_t i = 0; i < 2; ++i)
      arrows.push_back({stage.positions[pair[i].slot()], edited.positions[move.after[i].slot()],
                        kColours.at(static_cast<std::size_t>(number)), std::to_string(number + 1)});
    ++number;
    return false;
  }));
  return arrows;
}

}  // namespace

Paint paint_pair_on_mesh() {
  struct Example {
    mesh::Region region;
    double x_bend, y_bend;
    const char* words;
  };
  const std::vector<Example> examples{
      {region_with(theory::kQuad, 2, 3, {3, 3, 3, 3}), 0.03, 0.03, "(a) a 3-5 pair"},
      {region_with(theory::kDigon, 3, 4, {4, 4}), 0.035, 0.035, "(b) a 3-3 pair"},
      {region_with(theory::kHexagon, 3, 3, {3, 3, 3, 3, 3, 3}), 0.03, -0.03, "(c) a 5-5 pair"}};
  Sheet sheet(24, 10);
  for (std::size_t i = 0; i < examples.size(); ++i) {
    const Example& example = examples[i];
    const Stage stage = bent(example.region, example.x_bend, example.y_bend);
    const std::vector<VertexId> pair = mesh::irregular_vertices(stage.mesh);
    SpacePanel panel{stage, {example.words}};
    panel.arrows = arrows_of_moves(stage, {pair.at(0), pair.at(1)});
    const Setting setting = setting_for(stage, {.azimuth = 15, .elevation = 50, .z_up = true}, 240);
    sheet.add(cell(panel, setting), 0, static_cast<double>(i));
  }
  return sheet.paint();
}

}  // namespace requad::figures
