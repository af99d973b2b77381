// requad-edit merge: merges a pair into one vertex.

#include "mesh/commands/commands.hpp"
#include "mesh/commands/pair_edit.hpp"

namespace requad::edit {

program::Command merge_command() {
  return {
      .name = "merge",
      .usage = {"IN A B -o OUT"},
      .summary = "merges a 3-3 pair into a v2, or a 5-5 pair into a v6",
      .text = "The distance of A and B must be even.\n",
      .examples = {"requad-enumerate region digon 2 2 3,3 -o digon.obj && "
                   "requad-edit merge digon.obj 1 9 -o merged.obj"},
      .options = editing_options({allow_inverted_option()}),
      .words = {3, 3},
      .files = {0},
      .run = [](const program::Options& options) { return edit_pair(options, "merge", mesh::merge_pair); },
  };
}

}  // namespace requad::edit
