// requad-edit apply: makes the edits of a script, or undoes them.

#include <array>
#include <cstdio>

#include "mesh/commands/commands.hpp"
#include "mesh/commands/session.hpp"
#include "mesh/editing/script.hpp"
#include "mesh/text/text_scanner.hpp"

namespace requad::edit {

namespace {

using program::Options;

int apply(const Options& options) {
  output_path(options, "apply");
  const auto& words = options.words();
  const bool undo = options.has("undo");
  mesh::Script script = mesh::parse_script(mesh::read_text(words[1]), mesh::name_in_messages(words[1]));
  mesh::Surface input = read_input(options);
  if (undo) {
    mesh::restore_ids(script, input);
    script = mesh::inverse(script);
  }
  const double rounded = mesh::accept_rounded(script, input);
  Session session(options, "apply", std::move(input));
  const mesh::Replay result = mesh::replay(session.editor(), script);
  if (result.refusal != mesh::Refusal::none)
    return session.refused(mesh::name_in_messages(words[1]) + ":" + std::to_string(result.line), result.refusal);
  const auto edits = static_cast<int>(script.changes.size());
  nlohmann::ordered_json summary{{"edits", edits}, {"undone", undo}};
  std::string text = counted(edits, "edit", "edits") + (undo ? " undone\n" : " made\n");
  if (script.rounded) {
    summary["rounded_by"] = rounded;
    std::array<char, 80> line;
    std::snprintf(line.data(), line.size(), "coordinates of IN were rounded, by at most %.2g\n", rounded);
    text += line.data();
  }
  return session.done(std::move(summary), text);
}

}  // namespace

program::Command apply_command() {
  std::vector<program::Option> options{
      output_option(),
      program::flag("undo", "undo the edits: IN is what the command wrote, OUT what it read"),
      program::output("map", "FILE", "write where each vertex and face is now, as JSON", {{"json", {"json"}}}),
  };
  for (program::Option& option : input_options()) options.push_back(std::move(option));
  return {
      .name = "apply",
      .usage = {"IN SCRIPT -o OUT"},
      .summary = "makes the edits that another command wrote to a script (--script)",
      .text = R"(IN must be the mesh that the other command read. OUT is then what that command
wrote, to the last bit. A script for another mesh is refused.

IN may come from another program that rounded the coordinates, if its vertices
and faces are in the same order. Each vertex that the script moves may then be
away from its place by 1e-5 of the diagonal of the bounding box, and is put back
there; the others keep the coordinates of IN.

The map that --map writes has these keys. Everything is counted from 1 in the
order of the files; with --subdivide in the order that `requad-edit subdivide`
writes. (Scripts count from 0.)
  vertices, faces  for each element of IN its number in OUT, or null if it was
                   removed
  new_vertices, new_faces
                   the numbers in OUT of the elements that IN does not have
  new_vertices_from, new_faces_from
                   for each of these the number in IN of the element that it was
                   split from, so that what belongs to an element can follow
)",
      .examples = {"requad-edit reduce mesh/examples/figure-16.obj -o less.obj --script edits.txt && "
                   "requad-edit apply mesh/examples/figure-16.obj edits.txt -o again.obj --map map.json",
                   "requad-edit apply less.obj edits.txt --undo -o back.obj"},
      .options = std::move(options),
      .words = {2, 2},
      .files = {0, 1},
      .run = apply,
  };
}

}  // namespace requad::edit
