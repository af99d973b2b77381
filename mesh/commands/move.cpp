// requad-edit move: makes one of the moves of a pair.

#include "mesh/commands/commands.hpp"
#include "mesh/commands/pair_edit.hpp"

namespace requad::edit {

namespace {

using mesh::Refusal;
using program::UsageError;

int move(const program::Options& options) {
  Session session(options, "move");
  output_path(options, "move");
  if (names_one_vertex(session)) return refuse_one_vertex(session);
  const auto [a, b] = pair_of(session);
  if (!options.has("step")) throw UsageError("move: --step is missing; `requad-edit moves` lists the steps of a pair");
  const std::string wanted = options.text("step");
  const std::string subject = session.describe(a, b);
  const std::size_t mark = session.begin();
  // A step can stand for several moves. The first legal one is made; if there is none, the last reason is reported.
  mesh::PossibleMove made;
  bool found = false;
  const Refusal refusal = mesh::for_each_move(session.editor(), a, b, [&](const mesh::PossibleMove& move) {
    if (!move.is_called(wanted)) return false;
    made = move;
    found = true;
    return move.refusal == Refusal::none;
  });
  if (refusal != Refusal::none) return session.refused(subject, refusal);
  if (!found) throw UsageError("move: '" + wanted + "' is no step of this pair; `requad-edit moves` lists them");
  if (made.refusal != Refusal::none) return session.refused(subject, made.refusal);
  session.fit_since(mark);
  return session.done({{"move", made.name},
                       {"effect", made.effect},
                       {"operations", made.counts.operations},
                       {"faces", made.faces_gained()}},
                      made.name + ": " + made.effect + "\n");
}

}  // namespace

program::Command move_command() {
  return {
      .name = "move",
      .usage = {"IN A B --step NAME -o OUT"},
      .summary = "makes one of the moves that `requad-edit moves` lists",
      .examples = {"requad-edit move mesh/examples/figure-17.obj 153 163 --step slide_first -o moved.obj"},
      .options = editing_options({program::value(
          "step", "NAME", "the move, by its name in `requad-edit moves`, or by its step: the first\nlegal one")}),
      .words = {2, 3},
      .files = {0},
      .run = move,
  };
}

}  // namespace requad::edit
