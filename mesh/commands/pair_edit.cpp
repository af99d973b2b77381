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

bool names_one_vertex(const Session& session) { return session.options().words().size() == 2; }

int refuse_one_vertex(Session& session) {
  const VertexId v = session.vertex(session.options().words()[1]);
  const bool irregular = session.editor().sectors().is_irregular(v);
  return session.refused(session.describe(v),
                         irregular ? mesh::EditRefusal::lone_vertex : mesh::EditRefusal::wrong_valences);
}

int edit_pair(const program::Options& options, const std::string& command, PairOperation operation) {
  Session session(options, command);
  output_path(options, command);
  const auto [a, b] = pair_of(session);
  const std::string subject = session.describe(a, b);
  const std::size_t mark = session.begin();
  const mesh::PairResult result = operation(session.editor(), a, b);
  if (result.refusal != Refusal::none) return session.refused(subject, result.refusal);
  session.fit_since(mark);
  if (session.is_worse(subject)) return program::kCheckFailed;
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
