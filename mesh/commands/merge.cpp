// requad-edit merge: merges a pair into one vertex.

#include "mesh/commands/commands.hpp"
#include "mesh/commands/pair_edit.hpp"

namespace requad::edit {

program::Command merge_command() {
  return {
      .name = "merge",
      .usage = {"IN A B -o OUT"},
      .summary = "merges a 3-3 pair into a v2, or a 5-5 pair into a v6",
      .text = R"(The distance of A and B must be even. In a flat part of a mesh, one of the two
quads of a v2 is inverted: for a 3-3 pair say --allow-inverted there.
)",
      .examples = {"requad-enumerate region hexagon 1 1 1,1,1,1,1,1 -o hexagon.obj && "
                   "requad-edit merge hexagon.obj 1 4 -o merged.obj"},
      .options = editing_options({allow_inverted_option()}),
      .words = {3, 3},
      .files = {0},
      .run = [](const program::Options& options) { return edit_pair(options, "merge", mesh::merge_pair); },
  };
}

}  // namespace requad::edit
