// requad-edit atomic: the atomic operations of section 5 at a vertex or along an edge.

#include <optional>

#include "mesh/commands/session.hpp"
#include "mesh/irregular/atomic_operations.hpp"

namespace requad::edit {

namespace {

using mesh::AtomicChoice;
using mesh::AtomicName;
using mesh::EditRefusal;
using mesh::HalfEdgeId;
using mesh::Refusal;
using mesh::VertexId;
using nlohmann::ordered_json;
using program::Options;
using program::UsageError;

// What the command line names: V, or the edge V -> W.
struct Place {
  VertexId v;
  HalfEdgeId along;  // none if there is no W
};

Place place_of(const Session& session) {
  const auto& words = session.options().words();
  if (words.size() != 2 && words.size() != 3)
    throw UsageError("atomic: expected a mesh file and one or two vertices; see --help");
  Place place{session.vertex(words[1]), {}};
  if (words.size() == 2 || session.mesh().is_boundary(place.v)) return place;
  place.along = session.mesh().find_half_edge(place.v, session.vertex(words[2]));
  if (!place.along.valid()) throw UsageError("atomic: no edge joins the vertices " + words[1] + " and " + words[2]);
  return place;
}

std::vector<AtomicChoice> choices_at(Session& session, const Place& place) {
  return place.along.valid() ? mesh::atomic_operations(session.editor(), place.along)
                             : mesh::atomic_operations(session.editor(), place.v);
}

std::string ends(const Session& session, HalfEdgeId along) {
  const mesh::QuadMesh& m = session.mesh();
  return session.describe(m.origin(along)) + " to " + session.describe(m.target(along));
}

// An operation with its effect, in the numbers of the mesh as it is. Tries the operation and takes it back.
struct Told {
  ordered_json json;
  std::string text;
};
Told tell(Session& session, const AtomicChoice& choice) {
  const mesh::QuadMesh& m = session.mesh();
  const HalfEdgeId along = choice.operation.along;
  const std::string name = to_string(choice.operation.name);
  const bool legal = choice.refusal == Refusal::none;
  Told told;
  told.json = {{"operation", name},
               {"from", session.number(m.origin(along))},
               {"to", session.number(m.target(along))},
               {"legal", legal}};
  told.text = ends(session, along) + ", " + name + ": ";
  if (!legal) {
    told.json["why"] = choice.refusal.clause();
    told.text += "no: " + std::string(choice.refusal.clause()) + "\n";
    return told;
  }
  const std::size_t mark = session.editor().mark();
  const mesh::AtomicReport report = mesh::perform(session.editor(), choice.operation);
  session.editor().roll_back(mark);

  const auto valence = [](int l) { return l > 0 ? "v" + std::to_string(l) : std::string("gone"); };
  const auto known = [](bool is, int number) { return is ? ordered_json(number) : ordered_json(); };
  ordered_json valences = ordered_json::array();
  for (const mesh::ValenceChange& c : report.changes) {
    const bool old = c.before > 0;
    const int number = old ? session.number(c.vertex) : 0;
    if (!valences.empty()) told.text += ", ";
    told.text += (old ? std::to_string(number) + " " + valence(c.before) + " -> " : "new ") + valence(c.after);
    valences.push_back(
        {{"vertex", known(old, number)}, {"before", known(old, c.before)}, {"after", known(c.after > 0, c.after)}});
  }
  told.json["valences"] = std::move(valences);
  told.json["inverse"] = to_string(report.inverse.name);
  told.text += "; inverse: " + to_string(report.inverse.name) + "\n";
  return told;
}

int list(Session& session, const Place& place) {
  ordered_json operations = ordered_json::array();
  std::string text;
  for (const AtomicChoice& choice : choices_at(session, place)) {
    Told told = tell(session, choice);
    operations.push_back(std::move(told.json));
    text += told.text;
  }
  program::finish(session.options(), ordered_json{{"operations", operations}}.dump(), text);
  return program::kDone;
}

// The operation of this name at the place. An edge has one, listed or not; a vertex must have just one legal one.
AtomicChoice chosen(Session& session, const Place& place, const AtomicName& name) {
  std::optional<AtomicChoice> found;
  for (const AtomicChoice& choice : choices_at(session, place)) {
    if (!(choice.operation.name == name)) continue;
    if (place.along.valid()) return choice;
    const bool both = found && found->refusal == Refusal::none && choice.refusal == Refusal::none;
    if (both) throw UsageError("atomic: '" + to_string(name) + "' can be made along several edges; name one by W");
    if (!found || choice.refusal == Refusal::none) found = choice;
  }
  if (found) return *found;
  if (!place.along.valid())
    throw UsageError("atomic: there is no '" + to_string(name) + "' here; without --make all there are are listed");
  const mesh::AtomicOperation operation{name, place.along};
  return {operation, mesh::plan(session.editor(), operation).refusal};
}

int make(Session& session, const Place& place, const std::string& wanted) {
  output_path(session.options(), "atomic");
  const std::optional<AtomicName> name = mesh::parse_atomic_name(wanted);
  if (!name) throw UsageError("atomic: '" + wanted + "' is no atomic operation; expected such as 'move-v3 flip left'");
  const AtomicChoice choice = chosen(session, place, *name);
  if (choice.refusal != Refusal::none)
    return session.refused(ends(session, choice.operation.along) + ", " + wanted, choice.refusal);
  Told told = tell(session, choice);
  const std::size_t mark = session.editor().mark();
  mesh::perform(session.editor(), choice.operation);
  session.smooth_since(mark);
  return session.done(std::move(told.json), told.text);
}

int atomic(const Options& options) {
  Session session(options, "atomic");
  const Place place = place_of(session);
  if (session.mesh().is_boundary(place.v))
    return session.refused(session.describe(place.v), EditRefusal::touches_boundary);
  return options.has("make") ? make(session, place, options.text("make")) : list(session, place);
}

std::string usage() {
  std::string text =
      "  requad-edit atomic IN V [W]\n"
      "  requad-edit atomic IN V [W] --make NAME -o OUT\n"
      "      lists the atomic operations (section 5) at the vertex V, or along its edge to W, with the valences "
      "before\n"
      "      and after, and what is in the way of those that can not be made; or makes the one of that name. Left and\n"
      "      right are seen from V to W, in a 3-5 pair from the v3 to the v5. NAME is a kind, a way and a hand:\n";
  for (const mesh::AtomicRule& r : mesh::atomic_rules()) {
    std::string ways;
    for (const auto way :
         {mesh::TransportStep::Kind::collapse, mesh::TransportStep::Kind::flip, mesh::TransportStep::Kind::split}) {
      if (r.has(way)) ways += (ways.empty() ? "" : "|") + std::string(mesh::name(way));
    }
    const std::string turn = r.kind == mesh::AtomicKind::lower ? " K" : "";
    text +=
        "        " + std::string(r.name) + " " + ways + " left|right" + turn + "  (" + std::string(r.source) + ")\n";
  }
  return text + "      K: the split's path goes on by the K-th edge of V from W on that hand.\n" + kEditingHelp;
}

}  // namespace

Command atomic_command() {
  return {
      "atomic",
      usage(),
      {"requad-edit atomic spot.obj 12", "requad-edit atomic spot.obj 12 40 --make 'move-v3 flip left' -o moved.obj"},
      editing_options({{}, {"make"}, {}}),
      atomic};
}

}  // namespace requad::edit
