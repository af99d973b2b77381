// requad-edit cancel: cancels a v3 and a v5 with the help of third vertices.

#include <utility>
#include <vector>

#include "mesh/commands/commands.hpp"
#include "mesh/commands/pair_edit.hpp"

namespace requad::edit {

namespace {

using mesh::Refusal;
using mesh::VertexId;
using nlohmann::ordered_json;
using program::UsageError;

// The vertices of --with, or the irregular vertices nearest to the pair.
std::vector<VertexId> helpers_of(Session& session, VertexId three, VertexId five) {
  std::vector<VertexId> helpers;
  for (const std::string& word : session.options().list("with")) {
    helpers.push_back(session.vertex(word));
    if (helpers.back() == three || helpers.back() == five)
      throw UsageError("cancel: --with " + word + " is one of the pair");
  }
  if (!helpers.empty()) return helpers;
  mesh::BreadthFirstDistances distances;
  return mesh::usual_helpers(session.editor(), distances, three, five);
}

int cancel(const program::Options& options) {
  Session session(options, "cancel");
  output_path(options, "cancel");
  auto [three, five] = pair_of(session);
  if (!session.editor().sectors().lacks(three)) std::swap(three, five);
  const std::string subject = session.describe(three, five);
  const std::vector<VertexId> helpers = helpers_of(session, three, five);
  mesh::PairTransport transport(session.editor());
  const std::size_t mark = session.begin();
  const mesh::Cancellation result = mesh::cancel_pair(session.editor(), transport, three, five, helpers,
                                                      [&](std::size_t made) { session.fit_transport(made); });
  if (result.refusal != Refusal::none) return session.refused(subject, result.refusal, result.obstacles);
  session.fit_since(mark);
  if (session.is_worse(subject)) return program::kCheckFailed;
  ordered_json moved = ordered_json::array();
  std::string where;
  for (const VertexId v : result.helpers) {
    moved.push_back({{"vertex", session.number(v)}, {"valence", session.mesh().valence(v)}});
    where += (where.empty() ? "" : ", ") + session.describe(v);
  }
  return session.done({{"couriers", result.transports}, {"operations", result.steps}, {"helpers", moved}},
                      subject + " cancelled by " + counted(result.transports, "transport", "transports") + " in " +
                          counted(result.steps, "operation", "operations") + "; " +
                          (where.empty() ? "the helpers cancelled with them" : "the helpers are now " + where) + "\n");
}

}  // namespace

program::Command cancel_command() {
  return {
      .name = "cancel",
      .usage = {"IN A B -o OUT"},
      .summary = "cancels a v3 and a v5 with the help of third vertices (section 8)",
      .text = R"(A third vertex moves by an edge with each transport of an adjacent 3-5 pair to
it. A v3 and a v5 that are left as the last pair can cancel together with
A and B.
)",
      .examples = {"requad-edit cancel mesh/examples/figure-17.obj 153 163 -o less.obj",
                   "requad-edit cancel mesh/examples/figure-17.obj 153 163 --with 366 -o less.obj"},
      .options =
          editing_options({allow_inverted_option(),
                           program::list("with", "C",
                                         "a third vertex that helps; may be repeated (default: the " +
                                             std::to_string(mesh::kUsualHelpers) + " nearest irregular vertices)")}),
      .words = {3, 3},
      .files = {0},
      .run = cancel,
  };
}

}  // namespace requad::edit
