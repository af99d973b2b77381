// Figures 1, 15 and 19: meshes whose irregular vertices cancel.
#include "figures/panels/space_panel.hpp"
#include "figures/pictures/examples.hpp"
#include "figures/pictures/paper_pictures.hpp"
#include "mesh/files/read_polygons.hpp"
#include "mesh/irregular/pair_frame.hpp"

namespace requad::figures {

namespace {

using mesh::VertexId;

// The stages in a row, and below each the same with a checkerboard.
Sheet twice(const std::vector<Stage>& stages, const std::vector<std::string>& words, const Setting& setting,
            double column_gap) {
  Sheet sheet(column_gap, 10);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    sheet.add(cell(SpacePanel{stages[i], {}}, setting), 0, static_cast<double>(i));
    sheet.add(cell(SpacePanel{stages[i], {words[i]}, true}, setting), 1, static_cast<double>(i));
  }
  return sheet;
}

std::string letter(std::size_t i) { return "(" + std::string(1, static_cast<char>('a' + i)) + ") "; }

// Aligns irregular vertices in pairs, first those that are nearest to each other and not yet aligned.
void align_in_pairs(EditSequence& edits) {
  std::vector<VertexId> free = mesh::irregular_vertices(edits.stage().mesh);
  while (free.size() > 1) {
    const Stage now = edits.stage();
    int least = 0;
    std::array<VertexId, 2> nearest;
    for (std::size_t i = 0; i < free.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (const mesh::PairFrame& frame : mesh::find_frames(now.mesh, free[i], free[j])) {
          if (frame.degenerate() || (least > 0 && frame.distance() >= least)) continue;
          least = frame.distance();
          nearest = {free[i], free[j]};
        }
      }
    }
    if (least == 0) return;
    std::erase_if(free, [&](VertexId v) { return v == nearest[0] || v == nearest[1]; });
    edits.align(nearest[0], nearest[1]);
  }
}

}  // namespace

Paint paint_roof() {
  static const Paint paint = [] {
    EditSequence edits(examples::roof);
    std::vector<Stage> stages{edits.stage()};
    edits.reduce();
    stages.push_back(edits.stage());
    const Setting setting = setting_for(stages[0], {.azimuth = 20, .elevation = 50, .z_up = true}, 300);
    std::vector<std::string> words;
    for (std::size_t i = 0; i < stages.size(); ++i) words.push_back(letter(i) + irregular_words(stages[i]));
    return twice(stages, words, setting, 24).paint();
  }();
  return paint;
}

Paint paint_dome() {
  static const Paint paint = [] {
    EditSequence edits(examples::dome);
    std::vector<Stage> stages{edits.stage()};
    EditSequence parted(examples::dome);
    parted.part();
    stages.push_back(parted.stage());
    edits.reduce();  // parts the v12 itself
    stages.push_back(edits.stage());
    align_in_pairs(edits);
    stages.push_back(edits.stage());
    const std::vector<std::string> words{"the original: ", "(1) parted: ", "(2) cancelled: ", "(3) aligned: "};
    const Setting setting = setting_for(stages[0], {.azimuth = 0, .elevation = 55, .z_up = true}, 170);
    Sheet sheet(20, 10);
    for (std::size_t i = 0; i < stages.size(); ++i)
      sheet.add(cell(SpacePanel{stages[i], {words[i] + irregular_words(stages[i])}}, setting), 0,
                static_cast<double>(i));
    return sheet.paint();
  }();
  return paint;
}

namespace {

Paint reduction_in_stages(mesh::Surface surface, const View& view) {
  EditSequence edits(std::move(surface));
  std::vector<Stage> stages{edits.stage()};
  const int all = stages[0].irregular();
  for (Stage& stage : edits.reduce({all * 400 / 956, all * 48 / 956})) stages.push_back(std::move(stage));
  stages.push_back(edits.stage());
  const Setting setting = setting_for(stages[0], view, 215);
  std::vector<std::string> words;
  for (std::size_t i = 0; i < stages.size(); ++i)
    words.push_back(letter(i) + (i + 1 < stages.size() ? std::to_string(stages[i].irregular()) + " irregular vertices"
                                                       : irregular_words(stages[i])));
  return twice(stages, words, setting, 14).paint();
}

}  // namespace

Paint paint_reduction(const mesh::Surface* surface) {
  if (surface != nullptr) return reduction_in_stages(*surface, usual_view(surface->mesh, surface->positions));
  static const Paint paint = reduction_in_stages(mesh::to_surface(mesh::parse_obj(examples::rabbit, "rabbit"), false),
                                                 {.azimuth = 35, .elevation = 15});
  return paint;
}

}  // namespace requad::figures
