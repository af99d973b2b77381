// requad-edit moves, move, cancel, merge, align and part: edits of a few irregular vertices.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

#include "mesh/commands/session.hpp"

namespace requad::edit {

namespace {

using mesh::Editor;
using mesh::EditRefusal;
using mesh::HalfEdgeId;
using mesh::PairMove;
using mesh::QuadMesh;
using mesh::Refusal;
using mesh::VertexId;
using nlohmann::ordered_json;
using program::Options;
using program::UsageError;

// Whether the wish is to move one vertex alone, as Theorem 7.1 says none can be.
bool is_lone(const Session& session) { return session.options().words().size() == 2; }
int refuse_lone(Session& session) {
  const VertexId v = session.vertex(session.options().words()[1]);
  const bool irregular = session.editor().sectors().is_irregular(v);
  return session.refused(session.describe(v), irregular ? EditRefusal::lone_vertex : EditRefusal::wrong_valences);
}

// The session's two vertices: the second and third word.
std::array<VertexId, 2> pair_of(const Session& session, const std::string& command) {
  const auto& words = session.options().words();
  if (words.size() != 3) throw UsageError(command + ": expected a mesh file and two vertices; see --help");
  return {session.vertex(words[1]), session.vertex(words[2])};
}

std::string and_(const Session& s, VertexId a, VertexId b) { return s.describe(a) + " and " + s.describe(b); }

// --- moves -----------------------------------------------------------------------------------------------------------

// A way to move a pair: by a step of its rectangle, or by a courier that leaves along an edge and finds its own path.
struct Way {
  std::string name;  // "open", or "from 12 to 13"
  std::string effect;
  Refusal refusal = Refusal::none;
  int operations = 0;
  int faces = 0;  // gained
};

std::string signed_text(int n) { return (n > 0 ? "+" : "") + std::to_string(n); }

// Makes the move; the caller takes it back.
Way try_step(Editor& editor, const PairMove& move) {
  Way way{name(move.step), "", Refusal::none, 0, 0};
  const mesh::MoveReport report = mesh::move_pair(editor, move);
  way.refusal = report.refusal;
  if (way.refusal != Refusal::none) return way;
  const mesh::PairFrame& to = report.inverse.frame;
  way.operations = static_cast<int>(report.operations.size());
  way.faces = report.faces_made() - report.faces_deleted();
  way.effect = "(" + std::to_string(move.frame.d1) + "," + std::to_string(move.frame.d2) + ") becomes (" +
               std::to_string(to.d1) + "," + std::to_string(to.d2) + ")";
  return way;
}

// Sends a courier from the pair's vertex `from` along an edge, for the other to take; the caller takes it back.
Way try_transport(Session& session, mesh::PairTransport& transport, VertexId from, VertexId to,
                  mesh::AdjacentPair place) {
  const QuadMesh& m = session.mesh();
  const int faces = m.face_count();
  const VertexId next = place.u(m) == from ? place.v(m) : place.u(m);
  Way way{"from " + std::to_string(session.number(from)) + " to " + std::to_string(session.number(next)), "",
          Refusal::none, 0, 0};
  const mesh::TransportReport report = transport.carry(place, std::array{to});
  way.refusal = report.refusal;
  if (way.refusal != Refusal::none) return way;
  way.operations = report.steps;
  way.faces = m.face_count() - faces;
  way.effect = "the other moves by an edge too";
  return way;
}

// Four directions by the pair's rectangle if it has one; couriers in all directions if not.
template <class Visit>
Refusal for_each_way(Session& session, VertexId a, VertexId b, Visit&& visit) {
  const QuadMesh& m = session.mesh();
  Editor& editor = session.editor();
  const mesh::Sectors& sectors = editor.sectors();
  const auto is_one = [&](VertexId v) {
    bool one = false;
    sectors.for_each_sector(v, [&](HalfEdgeId h) { one = one || std::abs(sectors.excess(h)) == 1; });
    return one;
  };
  if (a == b || !is_one(a) || !is_one(b)) return EditRefusal::wrong_valences;
  const std::size_t mark = editor.mark();
  std::vector<PairMove> steps;  // of free vertices; features and boundaries allow couriers only
  if (!editor.is_fixed(a) && !editor.is_fixed(b)) steps = mesh::pair_moves(m, a, b);
  for (const PairMove& step : steps) {
    if (visit(try_step(editor, step))) return Refusal::none;
    editor.roll_back(mark);
  }
  if (!steps.empty()) return Refusal::none;
  mesh::PairTransport transport(editor);
  for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
    // A v3 is a courier's u, a v5 its v.
    std::vector<mesh::AdjacentPair> places;
    for (const int sign : {-1, 1}) {
      sectors.for_each_edge(from, sign, [&, from = from](VertexId, HalfEdgeId at) {
        const bool at_u = m.origin(at) == from;
        places.push_back({at, (sign < 0) != at_u});
      });
    }
    for (const mesh::AdjacentPair place : places) {
      if (visit(try_transport(session, transport, from, to, place))) return Refusal::none;
      editor.roll_back(mark);
    }
  }
  return Refusal::none;
}

int moves(const Options& options) {
  Session session(options, "moves");
  if (is_lone(session)) return refuse_lone(session);
  const auto [a, b] = pair_of(session, "moves");
  ordered_json list = ordered_json::array();
  std::string text;
  const Refusal refusal = for_each_way(session, a, b, [&](const Way& way) {
    const bool legal = way.refusal == Refusal::none;
    ordered_json entry{{"move", way.name}, {"legal", legal}};
    if (legal) {
      entry.update(ordered_json{{"effect", way.effect}, {"operations", way.operations}, {"faces", way.faces}});
    } else {
      entry["why"] = way.refusal.clause();
    }
    list.push_back(entry);
    text += way.name + ": " +
            (legal ? way.effect + ", " + signed_text(way.faces) + " faces by " +
                         counted(way.operations, "operation", "operations")
                   : "no: " + std::string(way.refusal.clause())) +
            "\n";
    return false;
  });
  if (refusal != Refusal::none) return session.refused(and_(session, a, b), refusal);
  program::finish(options, ordered_json{{"moves", list}}.dump(), text);
  return program::kDone;
}

int move(const Options& options) {
  Session session(options, "move");
  output_path(options, "move");
  if (is_lone(session)) return refuse_lone(session);
  const auto [a, b] = pair_of(session, "move");
  if (!options.has("step")) throw UsageError("move: --step is missing; `requad-edit moves` lists the steps of a pair");
  const std::string wanted = options.text("step");
  const std::string wish = and_(session, a, b);
  const std::size_t mark = session.editor().mark();
  Way made;
  bool found = false;
  const Refusal refusal = for_each_way(session, a, b, [&](const Way& way) {
    if (way.name != wanted || (found && made.refusal == Refusal::none)) return false;
    made = way;
    found = true;
    return way.refusal == Refusal::none;
  });
  if (refusal != Refusal::none) return session.refused(wish, refusal);
  if (!found) throw UsageError("move: '" + wanted + "' is no step of this pair; `requad-edit moves` lists them");
  if (made.refusal != Refusal::none) return session.refused(wish, made.refusal);
  session.smooth_since(mark);
  return session.done(
      {{"move", made.name}, {"effect", made.effect}, {"operations", made.operations}, {"faces", made.faces}},
      made.name + ": " + made.effect + "\n");
}

// --- cancel, merge, align, part --------------------------------------------------------------------------------------

int cancel(const Options& options) {
  constexpr int kHelpers = 8;
  Session session(options, "cancel");
  output_path(options, "cancel");
  auto [three, five] = pair_of(session, "cancel");
  const QuadMesh& m = session.mesh();
  if (!session.editor().sectors().lacks(three)) std::swap(three, five);
  const std::string wish = and_(session, three, five);
  std::vector<VertexId> helpers;
  for (const std::string& word : options.list("with")) {
    helpers.push_back(session.vertex(word));
    if (helpers.back() == three || helpers.back() == five)
      throw UsageError("cancel: --with " + word + " is one of the pair");
  }
  mesh::BreadthFirstDistances around;
  const auto third = [&, a = three, b = five](VertexId v) {
    return v != a && v != b && session.editor().sectors().is_irregular(v);
  };
  if (helpers.empty()) helpers = nearest(session.editor(), around, three, kHelpers, third);
  mesh::PairTransport transport(session.editor());
  const std::size_t mark = session.editor().mark();
  const mesh::Cancellation result = mesh::cancel_pair(session.editor(), transport, three, five, helpers);
  if (result.refusal != Refusal::none) return session.refused(wish, result.refusal, result.obstacles);
  session.smooth_since(mark);
  ordered_json moved = ordered_json::array();
  std::string where;
  for (const VertexId v : result.helpers) {
    moved.push_back({{"vertex", session.number(v)}, {"valence", m.valence(v)}});
    where += (where.empty() ? "" : ", ") + session.describe(v);
  }
  return session.done({{"couriers", result.transports}, {"operations", result.steps}, {"helpers", moved}},
                      wish + " cancelled by " + counted(result.transports, "courier", "couriers") + " in " +
                          counted(result.steps, "operation", "operations") + "; " +
                          (where.empty() ? "the helpers with them" : "helpers are now " + where) + "\n");
}

// Merging and aligning differ by the function alone.
template <class Operation>
int change_pair(const Options& options, const std::string& command, Operation&& operation) {
  Session session(options, command);
  output_path(options, command);
  const auto [a, b] = pair_of(session, command);
  const std::string wish = and_(session, a, b);
  const std::size_t mark = session.editor().mark();
  const mesh::PairResult result = operation(session.editor(), a, b);
  if (result.refusal != Refusal::none) return session.refused(wish, result.refusal);
  session.smooth_since(mark);
  const mesh::PairFrame& f = result.frame;
  const std::string now = f.v1 == f.v2 ? session.describe(f.v1) : and_(session, f.v1, f.v2);
  ordered_json vertices = ordered_json::array({session.number(f.v1)});
  if (f.v1 != f.v2) vertices.push_back(session.number(f.v2));
  return session.done({{"moves", result.moves}, {"vertices", vertices}, {"d1", f.d1}, {"d2", f.d2}},
                      wish + " are now " + now + " at (" + std::to_string(f.d1) + "," + std::to_string(f.d2) +
                          "), after " + counted(result.moves, "move", "moves") + "\n");
}

int merge(const Options& options) { return change_pair(options, "merge", mesh::merge_pair); }
int align(const Options& options) { return change_pair(options, "align", mesh::align_pair); }

int part(const Options& options) {
  Session session(options, "part");
  output_path(options, "part");
  const auto& words = options.words();
  if (words.size() > 2) throw UsageError("part: expected a mesh file and at most one vertex; see --help");
  const std::size_t mark = session.editor().mark();
  int made = 1;
  if (words.size() == 2) {
    const VertexId v = session.vertex(words[1]);
    const std::string wish = session.describe(v);
    if (const Refusal refusal = mesh::part_vertex(session.editor(), v); refusal != Refusal::none) {
      return session.refused(wish, refusal);
    }
  } else {
    made = mesh::part_all(session.editor());
  }
  session.smooth_since(mark);
  return session.done({{"operations", made}}, "parted by " + counted(made, "operation", "operations") + "\n");
}

std::string usage(const std::string& head, const std::string& what) {
  return "  requad-edit " + head + "\n      " + what + "\n" + kEditingHelp;
}

}  // namespace

Command moves_command() {
  return {"moves",
          std::string(
              "  requad-edit moves IN A B\n"
              "      the moves that the pair A, B can make, each with its effect, before any is made (section 6)\n") +
              kLookingHelp,
          {"requad-edit moves spot.obj 12 40"},
          looking_options(),
          moves};
}
Command move_command() {
  return {"move",
          usage("move IN A B --step NAME -o OUT", "makes one of them"),
          {"requad-edit move spot.obj 12 40 --step slide_first -o moved.obj"},
          editing_options({{}, {"step"}, {}}),
          move};
}
Command cancel_command() {
  return {"cancel",
          usage("cancel IN A B [--with C]... -o OUT",
                "cancels a v3 and a v5 with the help of third vertices (section 8): those of --with, or the nearest"),
          {"requad-edit cancel spot.obj 12 40 -o less.obj"},
          editing_options({{}, {}, {"with"}}),
          cancel};
}
Command merge_command() {
  return {"merge",
          usage("merge IN A B -o OUT", "merges a 3-3 pair to a v2, a 5-5 pair to a v6; their distance must be even"),
          {"requad-edit merge spot.obj 12 40 -o merged.obj"},
          editing_options(),
          merge};
}
Command align_command() {
  return {"align",
          usage("align IN A B -o OUT", "moves a 3-3 or 5-5 pair until a separatrix joins them"),
          {"requad-edit align spot.obj 12 40 -o aligned.obj"},
          editing_options(),
          align};
}
Command part_command() {
  return {"part",
          usage("part IN [V] -o OUT",
                "parts a vertex of valence 2 or more than 5 (Figure 5), or all of them, into v3s and v5s"),
          {"requad-edit part pawn.obj -o parted.obj"},
          editing_options(),
          part};
}

}  // namespace requad::edit
