// requad-edit apply: replays the edits of a script, or undoes them.

#include "mesh/commands/session.hpp"
#include "mesh/editing/script.hpp"
#include "mesh/files/text_scanner.hpp"

namespace requad::edit {

namespace {

using program::Options;
using program::UsageError;

int apply(const Options& options) {
  output_path(options, "apply");
  const auto& words = options.words();
  if (words.size() != 2) throw UsageError("apply: expected a mesh file and a script; see --help");
  wants_features(options);
  const bool undo = options.has("undo");
  mesh::Script script = mesh::parse_script(mesh::read_text(words[1]), words[1]);
  mesh::Surface input = mesh::read_surface(words[0], options.has("subdivide"));
  if (undo) {
    mesh::restore_ids(script, input);
    script = mesh::inverse(script);
  }
  Session session(options, "apply", std::move(input));
  const mesh::Replay result = mesh::replay(session.editor(), script);
  if (result.refusal != mesh::Refusal::none)
    return session.refused(words[1] + ":" + std::to_string(result.line), result.refusal);
  const auto edits = static_cast<int>(script.changes.size());
  return session.done({{"edits", edits}, {"undone", undo}},
                      counted(edits, "edit", "edits") + (undo ? " undone\n" : " made\n"));
}

}  // namespace

Command apply_command() {
  return {
      "apply",
      "  requad-edit apply IN SCRIPT -o OUT [--undo] [--map FILE] [--feature-angle DEG | --features FILE]\n"
      "      makes the edits that another command wrote by --script, with IN as that command read it: OUT is what "
      "that\n"
      "      wrote, to the last bit. --undo takes them back: IN is then what that wrote, and OUT what it read.\n"
      "      A script for another mesh is refused. --map FILE, as JSON: vertices[i] is the number in OUT of vertex "
      "i + 1\n"
      "      of IN, null if it was removed; faces likewise; new_vertices and new_faces are the numbers in OUT of "
      "what IN\n"
      "      does not have, new_vertices_from and new_faces_from those in IN of what they were split from, so that "
      "what\n"
      "      belongs to a vertex or face can follow. All are counted from 1 in the order of the files, or with "
      "--subdivide as `subdivide` "
      "writes\n"
      "      them. (Scripts count from 0.)\n"
      "      Exit code 1: an edit would change a feature, and a line says which; then nothing is written.\n",
      {"requad-edit reduce spot.obj -o spot8.obj --script spot8.txt --map map.json",
       "requad-edit apply spot.obj spot8.txt -o again.obj", "requad-edit apply spot8.obj spot8.txt --undo -o back.obj"},
      {{"subdivide", "undo"}, {"feature-angle", "features"}, {}, {"output,o", "map"}},
      apply};
}

}  // namespace requad::edit
