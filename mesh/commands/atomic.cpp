// requad-edit atomic: lists or makes the atomic operations of section 5 at a vertex or along an edge.

#include <algorithm>
#include <optional>

#include "mesh/commands/commands.hpp"
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

// The site that the command line names: the vertex V, or the edge V -> W.
struct Site {
  VertexId v;
  HalfEdgeId along;  // none if there is no W
};

Site site_of(const Session& session) {
  const auto& words = session.options().words();
  Site site{session.vertex(words[1]), {}};
  if (words.size() == 2 || session.mesh().is_boundary(site.v)) return site;
  site.along = session.mesh().find_half_edge(site.v, session.vertex(words[2]));
  if (!site.along.valid()) throw UsageError("atomic: no edge joins the vertices " + words[1] + " and " + words[2]);
  return site;
}

std::vector<AtomicChoice> choices_at(Session& session, const Site& site) {
  return site.along.valid() ? mesh::atomic_operations(session.editor(), site.along)
                            : mesh::atomic_operations(session.editor(), site.v);
}

std::string ends(const Session& session, HalfEdgeId along) {
  const mesh::QuadMesh& m = session.mesh();
  return session.describe(m.origin(along)) + " to " + session.describe(m.target(along));
}

// An operation and its effect, as JSON and as a line of text. Vertices have their numbers in the mesh before it.
struct Description {
  ordered_json json;
  std::string text;
};
// Performs the operation to see its effect, then undoes it.
Description describe(Session& session, const AtomicChoice& choice) {
  const mesh::QuadMesh& m = session.mesh();
  const HalfEdgeId along = choice.operation.along;
  const std::string name = to_string(choice.operation.name);
  const bool legal = choice.refusal == Refusal::none;
  Description description;
  description.json = {{"operation", name},
                      {"from", session.number(m.origin(along))},
                      {"to", session.number(m.target(along))},
                      {"legal", legal}};
  description.text = ends(session, along) + ", " + name + ": ";
  if (!legal) {
    description.json["why"] = choice.refusal.clause();
    description.text += "no: " + std::string(choice.refusal.clause()) + "\n";
    return description;
  }
  const std::size_t mark = session.editor().mark();
  const mesh::AtomicReport report = mesh::perform(session.editor(), choice.operation);
  session.editor().roll_back(mark);

  const auto valence = [](int l) { return l > 0 ? "v" + std::to_string(l) : std::string("gone"); };
  const auto number_or_null = [](bool is_known, int number) {
    return is_known ? ordered_json(number) : ordered_json();
  };
  ordered_json valences = ordered_json::array();
  for (const mesh::ValenceChange& c : report.changes) {
    const bool old = c.before > 0;
    const int number = old ? session.number(c.vertex) : 0;
    if (!valences.empty()) description.text += ", ";
    description.text += (old ? std::to_string(number) + " " + valence(c.before) + " -> " : "new ") + valence(c.after);
    valences.push_back({{"vertex", number_or_null(old, number)},
                        {"before", number_or_null(old, c.before)},
                        {"after", number_or_null(c.after > 0, c.after)}});
  }
  description.json["valences"] = std::move(valences);
  description.json["inverse"] = to_string(report.inverse.name);
  description.text += "; inverse: " + to_string(report.inverse.name) + "\n";
  return description;
}

int list(Session& session, const Site& site) {
  ordered_json operations = ordered_json::array();
  std::string text;
  for (const AtomicChoice& choice : choices_at(session, site)) {
    Description description = describe(session, choice);
    operations.push_back(std::move(description.json));
    text += description.text;
  }
  program::finish(session.options(), ordered_json{{"operations", operations}}.dump(), text);
  return program::kDone;
}

// The operation with this name at the site. An edge has one, listed or not. Of several at a vertex this is the legal
// one, or any of them if all are refused. Throws UsageError if several are legal or the site has none.
AtomicChoice chosen(Session& session, const Site& site, const AtomicName& name) {
  std::optional<AtomicChoice> found;
  for (const AtomicChoice& choice : choices_at(session, site)) {
    if (!(choice.operation.name == name)) continue;
    if (site.along.valid()) return choice;
    const bool both = found && found->refusal == Refusal::none && choice.refusal == Refusal::none;
    if (both)
      throw UsageError("atomic: '" + to_string(name) + "' can be made along several edges; expected W, to name one");
    if (!found || choice.refusal == Refusal::none) found = choice;
  }
  if (found) return *found;
  if (!site.along.valid())
    throw UsageError("atomic: there is no '" + to_string(name) +
                     "' here; without --make the command lists those that there are");
  const mesh::AtomicOperation operation{name, site.along};
  return {operation, mesh::plan(session.editor(), operation).refusal};
}

int make(Session& session, const Site& site, const std::string& wanted) {
  output_path(session.options(), "atomic");
  const std::optional<AtomicName> name = mesh::parse_atomic_name(wanted);
  if (!name)
    throw UsageError("atomic: '" + wanted + "' is no atomic operation; expected a name such as 'move-v3 flip left'");
  const AtomicChoice choice = chosen(session, site, *name);
  if (choice.refusal != Refusal::none)
    return session.refused(ends(session, choice.operation.along) + ", " + wanted, choice.refusal);
  Description description = describe(session, choice);
  const std::size_t mark = session.begin();
  mesh::perform(session.editor(), choice.operation);
  session.fit_since(mark);
  return session.done(std::move(description.json), description.text);
}

int atomic(const Options& options) {
  Session session(options, "atomic");
  const Site site = site_of(session);
  if (session.mesh().is_boundary(site.v))
    return session.refused(session.describe(site.v), EditRefusal::touches_boundary);
  return options.has("make") ? make(session, site, options.text("make")) : list(session, site);
}

// "  move-v3 collapse|flip left|right  (Figure 4a-c)" for each kind of operation.
std::string names_text() {
  using Kind = mesh::TransportStep::Kind;
  std::string text;
  for (const mesh::AtomicRule& rule : mesh::atomic_rules()) {
    std::string steps;
    for (const Kind step : {Kind::collapse, Kind::flip, Kind::split}) {
      if (rule.has(step)) steps += (steps.empty() ? "" : "|") + std::string(mesh::name(step));
    }
    text += "  " + std::string(rule.name) + " " + steps + " left|right" +
            (rule.kind == mesh::AtomicKind::lower ? " K" : "") + "  (" + std::string(rule.source) + ")\n";
  }
  return text;
}

// Those of an editing command, which need --make, and that option.
std::vector<program::Option> atomic_options() {
  std::vector<program::Option> options;
  const std::vector<program::Option> reading = input_options();
  for (program::Option& option : editing_options()) {
    const bool reads = std::any_of(reading.begin(), reading.end(),
                                   [&option](const program::Option& other) { return other.name == option.name; });
    options.push_back(reads ? std::move(option) : program::only_with(std::move(option), {"make"}));
  }
  options.insert(options.begin(), program::value("make", "NAME", "make the operation of this name"));
  return options;
}

}  // namespace

program::Command atomic_command() {
  return {
      .name = "atomic",
      .usage = {"IN V [W]", "IN V [W] --make NAME -o OUT"},
      .summary = "lists the atomic operations at V or along the edge V W, or makes one (section 5)",
      .text = R"(Each operation is listed with its name, the valences before and after, and its
inverse; or with the reason why it cannot be made. Left and right are seen from
V to W, in a 3-5 pair from the v3 to the v5. These are the names:
)" + names_text() +
              R"(K means that the path of the split goes on by the K-th edge of V, counted from W
on that hand.
)",
      .examples = {"requad-edit atomic mesh/examples/figure-17.obj 366",
                   "requad-edit atomic mesh/examples/figure-17.obj 366 149 --make 'move-v3 flip left' -o moved.obj"},
      .options = atomic_options(),
      .words = {2, 3},
      .files = {0},
      .run = atomic,
  };
}

}  // namespace requad::edit
