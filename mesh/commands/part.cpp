// requad-edit part: parts vertices of valence 2, or of high valence, into v3s and v5s.

#include "mesh/commands/commands.hpp"
#include "mesh/commands/session.hpp"

namespace requad::edit {

namespace {

using mesh::Refusal;

int part(const program::Options& options) {
  Session session(options, "part");
  output_path(options, "part");
  const auto& words = options.words();
  const std::size_t mark = session.begin();
  int made = 1;
  if (words.size() == 2) {
    const mesh::VertexId v = session.vertex(words[1]);
    const std::string subject = session.describe(v);
    const Refusal refusal = mesh::part_vertex(session.editor(), v);
    if (refusal != Refusal::none) return session.refused(subject, refusal);
  } else {
    made = mesh::part_all(session.editor());
  }
  session.fit_since(mark);
  return session.done({{"operations", made}}, "parted by " + counted(made, "operation", "operations") + "\n");
}

}  // namespace

program::Command part_command() {
  return {
      .name = "part",
      .usage = {"IN [V] -o OUT"},
      .summary = "parts a vertex of valence 2 or above 5 into v3s and v5s (Figure 5)",
      .text = R"(Without V, all such vertices are parted until none is left. With V, one
operation is made at V.
)",
      .examples = {"requad-enumerate region hexagon 1 1 1,1,1,1,1,1 -o hexagon.obj && "
                   "requad-edit merge hexagon.obj 1 4 -o merged.obj && requad-edit part merged.obj -o parted.obj"},
      .options = editing_options(),
      .words = {1, 2},
      .files = {0},
      .run = part,
  };
}

}  // namespace requad::edit
