#include "mesh/commands/pair_edit.hpp"

namespace requad::edit {

using mesh::PairFrame;
using mesh::Refusal;
using mesh::VertexId;
using nlohmann::ordered_json;

std::array<VertexId, 2> pair_of(const Session& session) {
  const auto& words = session.options().words();
  return {session.vertex(words[1]), session.vertex(words[2])};
}

std::string extents_text(const PairFrame& frame) {
  return "(" + std::to_string(frame.d1) + "," + std::to_string(frame.d2) + ")";
}

int edit_pair(const program::Options& options, const std::string& command, PairOperation operation) {
  Session session(options, command);
  output_path(options, command);
  const auto [a, b] = pair_of(session);
  const std::string subject = session.describe(a, b);
  const std::size_t mark = session.editor().mark();
  const mesh::PairResult result = operation(session.editor(), a, b);
  if (result.refusal != Refusal::none) return session.refused(subject, result.refusal);
  session.smooth_since(mark);
  const PairFrame& frame = result.frame;
  const bool is_merged = frame.v1 == frame.v2;
  ordered_json vertices = ordered_json::array({session.number(frame.v1)});
  if (!is_merged) vertices.push_back(session.number(frame.v2));
  return session.done({{"moves", result.moves}, {"vertices", vertices}, {"d1", frame.d1}, {"d2", frame.d2}},
                      subject + " are now " +
                          (is_merged ? session.describe(frame.v1) : session.describe(frame.v1, frame.v2)) + " at " +
                          extents_text(frame) + ", after " + counted(result.moves, "move", "moves") + "\n");
}

}  // namespace requad::edit
