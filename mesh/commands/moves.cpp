// requad-edit moves: lists the moves of a pair.

#include <array>

#include "mesh/commands/commands.hpp"
#include "mesh/commands/pair_edit.hpp"

namespace requad::edit {

namespace {

using mesh::Refusal;
using mesh::VertexId;
using nlohmann::ordered_json;

std::string signed_text(int n) { return (n > 0 ? "+" : "") + std::to_string(n); }

// What the move does, as JSON. Each vertex of the pair has its number before and after the move; the number is null if
// the vertex is regular then.
ordered_json details(const Session& session, std::array<int, 2> numbers, const mesh::PossibleMove& move) {
  ordered_json result{{"effect", move.effect},
                      {"operations", move.counts.operations},
                      {"faces", move.faces_gained()},
                      {"faces_made", move.counts.faces_made},
                      {"faces_deleted", move.counts.faces_deleted}};
  const auto extents = [](const mesh::PairFrame& frame) { return ordered_json{{"d1", frame.d1}, {"d2", frame.d2}}; };
  if (move.from) result["from"] = extents(*move.from);
  if (move.to) result["to"] = extents(*move.to);
  ordered_json vertices = ordered_json::array();
  for (std::size_t i = 0; i < 2; ++i) {
    const VertexId after = move.after[i];
    vertices.push_back(
        {{"before", numbers[i]}, {"after", after.valid() ? ordered_json(session.number(after)) : ordered_json()}});
  }
  result["vertices"] = vertices;
  return result;
}

int moves(const program::Options& options) {
  Session session(options, "moves");
  if (names_one_vertex(session)) return refuse_one_vertex(session);
  const auto [a, b] = pair_of(session);
  const std::array numbers{session.number(a), session.number(b)};
  ordered_json list = ordered_json::array();
  std::string text;
  const Refusal refusal = mesh::for_each_move(session.editor(), a, b, [&](const mesh::PossibleMove& move) {
    const bool legal = move.refusal == Refusal::none;
    ordered_json entry{{"name", move.name}, {"move", move.step}, {"legal", legal}};
    text += move.name + ": ";
    if (legal) {
      entry.update(details(session, numbers, move));
      text += move.effect + ", " + signed_text(move.faces_gained()) + " faces by " +
              counted(move.counts.operations, "operation", "operations");
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
separatrices span a rectangle, the effect is the change of (d1,d2). Where the
pair has several moves of one step, they are open.1, open.2 and so on. --json
adds the numbers of the two vertices before and after each move.
)",
      .examples = {"requad-edit moves mesh/examples/figure-17.obj 153 163",
                   "requad-edit moves mesh/examples/figure-18.obj 222 360 --feature-angle 40"},
      .options = input_and_seam_options(),
      .words = {2, 3},
      .files = {0},
      .run = moves,
  };
}

}  // namespace requad::edit
