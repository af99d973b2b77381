// Panels of meshes in space, as cells of a sheet (sheet.hpp).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "figures/panels/edit_sequence.hpp"
#include "figures/panels/sheet.hpp"
#include "mesh/pictures/space_picture.hpp"

namespace requad::figures {

// How the stages of one figure are seen, so that panels can be compared: from one side, in one scale, in one place.
struct Setting {
  View view;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // in the middle of a panel
  double scale = 1;                                  // points for each unit of length
  Point size = Point::Zero();                        // of a panel
};
// The setting in which the stage is `size` points wide or high at most.
Setting setting_for(const Stage& stage, const View& view, double size);

// An arrow over a mesh, with a number at its head that tells it apart without colours.
struct SpaceArrow {
  Eigen::Vector3d from, to;
  Colour Palette::*colour;
  std::string label;
};

struct SpacePanel {
  Stage stage;
  std::vector<std::string> words = {};
  bool checkerboard = false;
  std::vector<SpaceArrow> arrows = {};
};
Cell cell(const SpacePanel& panel, const Setting& setting);

// "183 irregular vertices: 96 v3, 75 v5, 11 v6, 1 v7".
std::string irregular_words(const Stage& stage);

}  // namespace requad::figures
