// Figures 16, 17 and 18: a defect of a mesh, repaired by hand. mesh/examples/run makes the same edits.
#include "figures/panels/space_panel.hpp"
#include "figures/pictures/examples.hpp"
#include "figures/pictures/paper_pictures.hpp"

namespace requad::figures {

namespace {

constexpr double kFeatureAngle = 40;

// The stages in a row, with arrows between them.
Paint row(const std::vector<Stage>& stages, const std::vector<std::string>& words, const View& view) {
  const Setting setting = setting_for(stages[0], view, 190);
  Sheet sheet(44, 10);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const std::size_t added = sheet.add(cell(SpacePanel{stages[i], {words[i]}}, setting), 0, static_cast<double>(i));
    if (i > 0) sheet.arrow(added - 1, added);
  }
  return sheet.paint();
}

}  // namespace

Paint paint_rounded_block() {
  static const Paint paint = [] {
    EditSequence edits(examples::rounded_block);
    std::vector<Stage> stages{edits.stage()};
    edits.make("move-v3 collapse left", edits.vertex(389), edits.vertex(99));
    stages.push_back(edits.stage());
    edits.cancel(edits.vertex(388), edits.vertex(97), {edits.vertex(93), edits.vertex(91)});
    stages.push_back(edits.stage());
    return row(stages,
               {"a v3 beside its corner, and a v3 and a v5", "(1) a quad collapse moves the v3 to the corner",
                "(2) the 3-5 pair that this left cancels with the other two"},
               {.azimuth = 32, .elevation = 30, .z_up = true});
  }();
  return paint;
}

Paint paint_cylinder() {
  static const Paint paint = [] {
    EditSequence edits(examples::cylinder, kFeatureAngle);
    std::vector<Stage> stages{edits.stage()};
    edits.make("move-v3 flip left", edits.vertex(366), edits.vertex(149));
    stages.push_back(edits.stage());
    edits.cancel(edits.vertex(148), edits.vertex(195), {edits.vertex(153), edits.vertex(163)});
    stages.push_back(edits.stage());
    return row(stages,
               {"one of four v3s is not aligned with the others", "(1) an edge flip moves the v3",
                "(2) the 3-5 pair that this left cancels with the other two"},
               {.azimuth = 10, .elevation = 55, .z_up = true});
  }();
  return paint;
}

Paint paint_sharp_block() {
  static const Paint paint = [] {
    EditSequence edits(examples::sharp_block, kFeatureAngle);
    std::vector<Stage> stages{edits.stage()};
    edits.move("from 360 to 350", edits.vertex(222), edits.vertex(360));
    stages.push_back(edits.stage());
    edits.reduce();
    stages.push_back(edits.stage());
    return row(stages,
               {"a v3 on a feature: a quad is flattened to a triangle", "(1) a 3-5 pair movement pulls it off the edge",
                "(2) what is irregular on this side cancels"},
               {.azimuth = -25, .elevation = 40, .z_up = true});
  }();
  return paint;
}

}  // namespace requad::figures
