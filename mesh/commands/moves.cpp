// requad-edit moves: lists the moves of a pair.

#include "mesh/commands/commands.hpp"
#include "mesh/commands/pair_edit.hpp"
#include "mesh/commands/possible_moves.hpp"

namespace requad::edit {

namespace {

using mesh::Refusal;
using nlohmann::ordered_json;

std::string signed_text(int n) { return (n > 0 ? "+" : "") + std::to_string(n); }

int moves(const program::Options& options) {
  Session session(options, "moves");
  if (names_one_vertex(session)) return refuse_one_vertex(session);
  const auto [a, b] = pair_of(session);
  ordered_json list = ordered_json::array();
  std::string text;
  const Refusal refusal = for_each_move(session, a, b, [&](const PossibleMove& move) {
    const bool legal = move.refusal == Refusal::none;
    ordered_json entry{{"move", move.name}, {"legal", legal}};
    text += move.name + ": ";
    if (legal) {
      entry.update(
          ordered_json{{"effect", move.effect}, {"operations", move.operations}, {"faces", move.faces_gained}});
      text += move.effect + ", " + signed_text(move.faces_gained) + " faces by " +
              counted(move.operations, "operation", "operations");
    } else {
      entry["why"] = move.refusal.clause();
      text += "no: " + std::string(move.refusal.clause());
    }
    list.push_back(entry);
    text += "\n";
    return false;
  });
  if (refusal != Refusal::none) return session.refused(session.describe(a, b), refusal);
  program::finish(options, ordered_json{{"moves", list}}.dump(), text);
  return program::kDone;
}

}  // namespace

program::Command moves_command() {
  return {
      .name = "moves",
      .usage = {"IN A B"},
      .summary = "lists the moves that the pair A, B can make (section 6)",
      .text = R"(Each move has its name, its effect, the number of faces that the mesh gains, and
the number of operations; or the reason why it cannot be made. For a pair whose
separatrices span a rectangle, the effect is the change of (d1,d2).
)",
      .examples = {"requad-edit moves mesh/examples/figure-17.obj 153 163",
                   "requad-edit moves mesh/examples/figure-18.obj 222 360 --feature-angle 40"},
      .options = input_options(),
      .words = {2, 3},
      .run = moves,
  };
}

}  // namespace requad::edit
