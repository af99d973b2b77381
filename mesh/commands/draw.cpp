// requad-edit draw: pictures of meshes in space.

#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "mesh/commands/arguments.hpp"
#include "mesh/commands/commands.hpp"
#include "mesh/geometry/diagnosis.hpp"
#include "mesh/pictures/page_options.hpp"
#include "mesh/pictures/space_picture.hpp"

namespace requad::edit {

namespace {

using nlohmann::ordered_json;
using program::Options;
using program::UsageError;

pictures::View view_of(const Options& options, const mesh::Surface& surface) {
  pictures::View view = pictures::usual_view(surface.mesh, surface.positions);
  if (options.has("view")) {
    const std::vector<std::int64_t> angles = options.integers("view", -360, 360);
    if (angles.size() != 2) throw UsageError("--view: expected two angles in degrees, as 30,20");
    view.azimuth = static_cast<double>(angles[0]);
    view.elevation = static_cast<double>(angles[1]);
  }
  view.z_up = options.choice("up", {"y", "z"}, "y") == "z";
  return view;
}

std::string caption(const std::string& name, const mesh::Diagnosis& d) {
  return name + counted(d.faces, "quad", "quads") + ", " + std::to_string(d.interior_irregular) + " irregular" +
         (d.inverted > 0 ? ", " + std::to_string(d.inverted) + " inverted" : "");
}

ordered_json sizes(const mesh::Diagnosis& d) {
  return {{"faces", d.faces}, {"interior_irregular", d.interior_irregular}, {"inverted", d.inverted}};
}

std::vector<std::string> formats(const Options& options) { return {options.format().name}; }

int draw(const Options& options) {
  options.required("output", "a picture to write, as OUT.svg, OUT.pdf, OUT.png or OUT.tex");
  const std::string format = options.format().name;
  const double size = options.number("size", 480, 10, 10'000);
  pictures::Page page = pictures::page_of(options);
  const mesh::Surface surface = read_input(options);
  const pictures::View view = view_of(options, surface);
  const mesh::FeatureEdges features = read_features(options, surface);
  const mesh::Diagnosis sized = mesh::diagnose(surface.mesh, surface.positions);

  ordered_json summary;
  std::vector<pictures::SpaceSubject> subjects;
  std::optional<mesh::Surface> before;
  mesh::FeatureEdges features_before;
  if (options.has("before")) {
    before = mesh::read_surface(options.text("before"), options.has("subdivide"), options.has("weld"));
    if (options.has("feature-angle")) features_before = read_features(options, *before);
    const mesh::Diagnosis d = mesh::diagnose(before->mesh, before->positions);
    subjects.push_back({before->mesh, before->positions, features_before, {caption("before: ", d)}});
    summary["before"] = sizes(d);
  }
  subjects.push_back({surface.mesh, surface.positions, features, {caption(before ? "after: " : "", sized)}});
  summary["mesh"] = sizes(sized);

  page.title = options.words()[0];
  for (const pictures::SpaceSubject& subject : subjects)
    page.description += (page.description.empty() ? "" : "; ") + subject.words.front();
  program::Outputs outputs;
  outputs.add(
      options.text("output"),
      pictures::render(pictures::side_by_side(subjects, view, options.has("checkerboard"), size), format, page));
  program::finish(options, summary.dump(), "", std::move(outputs));
  return program::kDone;
}

}  // namespace

program::Command draw_command() {
  std::vector<program::Option> options{
      program::output("output,o", "OUT",
                      "the picture to write: OUT.svg, OUT.pdf, OUT.png, OUT.tex (TikZ, for LaTeX), or - for SVG",
                      {{"svg", {"svg"}}, {"pdf", {"pdf"}}, {"png", {"png"}}, {"tikz", {"tex", "tikz"}}}),
      program::value("view", "AZ,EL",
                     "where the viewer stands, in degrees: to the right of the front, and over the horizon (default "
                     "30,20; in front if the mesh is flat)"),
      program::value("up", "y|z", "the axis that points upwards (default y; z points to the front then, else -y)"),
      program::flag("checkerboard", "colour the quads like a checkerboard, as far as irregular vertices allow"),
      program::input("before", "IN0", "draw IN0 to the left, in the same view and scale"),
      program::not_with(program::value("size", "POINTS", "the larger side of a mesh on the page (default 480)"),
                        {"width"}),
  };
  for (program::Option& option : pictures::page_options(formats)) options.push_back(std::move(option));
  for (program::Option& option : input_options()) options.push_back(std::move(option));
  return {
      .name = "draw",
      .usage = {"IN -o OUT.svg|pdf|png|tex"},
      .summary = "draws the mesh in space, with hidden surfaces removed",
      .text = R"(An irregular vertex is a polygon with as many corners as its valence. Features
are bold and black, boundaries bold and green. The back of a quad is brown, and
an inverted quad is pink. The features of --feature-angle are drawn in IN0 too,
those of --features in IN alone.
)",
      .examples = {"requad-edit draw mesh/examples/figure-17.obj -o figure-17.svg",
                   "requad-edit draw mesh/examples/figure-18.obj --view=-40,30 --checkerboard --feature-angle 40 "
                   "-o figure-18.png",
                   "requad-edit draw mesh/examples/figure-16.obj --width 85mm --palette print -o figure-16.pdf"},
      .options = std::move(options),
      .words = {1, 1},
      .files = {0},
      .run = draw,
  };
}

}  // namespace requad::edit
