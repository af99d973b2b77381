#include "mesh/complementary.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

namespace requad::mesh {

// --- cancelling ------------------------------------------------------------------------------------------------------

namespace {

bool contains(std::span<const VertexId> list, VertexId v) {
  return std::find(list.begin(), list.end(), v) != list.end();
}

// The first half-edge of a shortest path from one vertex to another over regular, unfixed vertices; none if there is no
// such path.
HalfEdgeId first_step(const Editor& editor, Surroundings& around, VertexId from, VertexId to) {
  const QuadMesh& m = editor.mesh();
  const std::array<VertexId, 1> source{to};
  around.measure(
      m, source, [&](VertexId v) { return v == from || (!editor.is_fixed(v) && m.face_valence(v) == 4); },
      [&](VertexId v) { return v != from; }, [&](VertexId v, int) { return v == from; });
  const int d = around.distance(from);
  HalfEdgeId best;
  if (d <= 0) return best;
  m.for_each_out(from, [&](HalfEdgeId h) {
    if (!best.valid() && around.distance(m.target(h)) == d - 1) best = h;
  });
  return best;
}

// The helpers after one of them took a courier: it has moved, or is regular, or has become two.
void update_helpers(const QuadMesh& m, const Transport& journey, std::vector<VertexId>& helpers) {
  std::erase_if(helpers, [&](VertexId v) { return !m.is_live(v) || m.face_valence(v) == 4; });
  for (const VertexId v : {m.origin(journey.courier), m.target(journey.courier)}) {
    if (m.face_valence(v) != 4 && !contains(helpers, v)) helpers.push_back(v);
  }
}

// In what order a cancellation tries things. No order is best everywhere: a helper may be led into a corner.
struct Manner {
  bool five_walks;  // first; the v3 otherwise
  bool may_cross;   // couriers may cross a helper
};
constexpr std::array<Manner, 4> kManners{{{false, false}, {true, false}, {false, true}, {true, true}}};

Cancellation cancel_in_manner(Editor& editor, Courier& courier, VertexId three, VertexId five,
                              std::vector<VertexId> helpers, Manner manner) {
  const QuadMesh& m = editor.mesh();
  Cancellation result;
  Surroundings around;
  int couriers_left = -1;
  for (bool adjacent = false; !adjacent;) {
    const HalfEdgeId first = first_step(editor, around, three, five);
    // Splits on the way may make the path longer, but not for ever.
    if (couriers_left < 0) couriers_left = 3 * around.distance(three) + 8;
    if (!first.valid() || couriers_left-- == 0) return {Refusal::no_way, 0, 0, {}};
    if (helpers.empty()) return {Refusal::lone_pair, 0, 0, {}};
    adjacent = m.target(first) == five;
    const HalfEdgeId last = adjacent ? first : m.twin(first_step(editor, around, five, three));
    // The v3 takes the path's first edge, or the v5 its last one.
    Transport journey;
    journey.refusal = Refusal::no_way;
    for (const bool five_walks : {manner.five_walks, !manner.five_walks}) {
      const HalfEdgeId edge = five_walks ? last : first;
      if (!edge.valid() || (!five_walks && m.face_valence(three) != 3)) continue;
      const VertexId next = five_walks ? m.origin(edge) : m.target(edge);
      journey = courier.carry(edge, helpers, manner.may_cross);
      if (journey.refusal != Refusal::none) continue;
      (five_walks ? five : three) = next;
      break;
    }
    if (journey.refusal != Refusal::none) return {journey.refusal, 0, 0, {}};
    ++result.couriers;
    result.steps += journey.steps;
    update_helpers(m, journey, helpers);
  }
  result.helpers = std::move(helpers);
  return result;
}

}  // namespace

Cancellation cancel_pair(Editor& editor, Courier& courier, VertexId three, VertexId five,
                         const std::vector<VertexId>& helpers) {
  const QuadMesh& m = editor.mesh();
  Cancellation result;
  if (editor.is_fixed(three) || editor.is_fixed(five) || m.face_valence(three) > 3 || m.face_valence(five) < 5) {
    result.refusal = Refusal::wrong_valences;
  } else if (helpers.empty()) {
    result.refusal = Refusal::lone_pair;
  } else {
    const std::size_t start = editor.mark();
    for (const Manner manner : kManners) {
      result = cancel_in_manner(editor, courier, three, five, helpers, manner);
      if (result.refusal == Refusal::none) break;
      editor.roll_back(start);
    }
  }
  return result;
}

// --- merging and aligning --------------------------------------------------------------------------------------------

namespace {

struct Delta {
  int a;
  int b;
};

// The step that changes the extents of an equal pair so (the table of pair_moves.hpp).
PairStep step_for(int valence, Delta delta) {
  const bool three = valence == 3;
  if (delta.a == delta.b) return (delta.a < 0) == three ? PairStep::open : PairStep::close;
  return (delta.a < 0) == three ? PairStep::slide_first : PairStep::slide_second;
}

// Moves the pair again and again, each time by what `choose` says of its frame, until that is nothing. All or none.
template <class Choose>
PairResult move_repeatedly(Editor& editor, PairFrame frame, Choose&& choose) {
  const int valence = editor.mesh().face_valence(frame.v1);
  const std::size_t start = editor.mark();
  PairResult result;
  while (const std::optional<Delta> delta = choose(frame)) {
    const MoveReport report = move_pair(editor, {frame, step_for(valence, *delta)});
    if (report.refusal != Refusal::none) {
      editor.roll_back(start);
      return {report.refusal, 0, {}};
    }
    ++result.moves;
    frame = report.inverse.frame;
  }
  result.frame = frame;
  return result;
}

// The frames of an equal pair, or why there are none.
std::pair<Refusal, std::vector<PairFrame>> frames_of(const Editor& editor, VertexId v1, VertexId v2) {
  const QuadMesh& m = editor.mesh();
  const auto wrong = [&](VertexId v) { return m.is_boundary(v) || (m.face_valence(v) != 3 && m.face_valence(v) != 5); };
  if (v1 == v2 || wrong(v1) || wrong(v2) || m.face_valence(v1) != m.face_valence(v2))
    return {Refusal::wrong_valences, {}};
  std::vector<PairFrame> frames = find_frames(m, v1, v2);
  const Refusal refusal = frames.empty() ? Refusal::no_such_step : Refusal::none;
  return {refusal, std::move(frames)};
}

}  // namespace

PairResult merge_pair(Editor& editor, VertexId v1, VertexId v2) {
  const auto [refusal, frames] = frames_of(editor, v1, v2);
  if (refusal != Refusal::none) return {refusal, 0, {}};
  PairResult result;
  for (const PairFrame& frame : frames) {
    if ((frame.a + frame.b) % 2 != 0) return {Refusal::odd_distance, 0, {}};
    // A segment bends first, so that it can shrink along both legs.
    result = move_repeatedly(editor, frame, [](const PairFrame& f) -> std::optional<Delta> {
      if (f.a == 0 && f.b == 0) return std::nullopt;
      return Delta{f.a == 0 ? 1 : -1, f.b == 0 ? 1 : -1};
    });
    if (result.refusal == Refusal::none) break;
  }
  return result;
}

PairResult align_pair(Editor& editor, VertexId v1, VertexId v2) {
  const auto [refusal, frames] = frames_of(editor, v1, v2);
  PairResult result{refusal, 0, {}};
  for (const PairFrame& frame : frames) {
    const Delta along = frame.a <= frame.b ? Delta{-1, 1} : Delta{1, -1};
    for (const Delta delta : {along, Delta{-1, -1}, Delta{-along.a, -along.b}}) {
      result = move_repeatedly(editor, frame, [delta](const PairFrame& f) {
        return f.degenerate() ? std::nullopt : std::optional<Delta>(delta);
      });
      if (result.refusal == Refusal::none) return result;
    }
  }
  return result;
}

// --- changes of type -------------------------------------------------------------------------------------------------

namespace {

// How far some valences are from regular, large ones counting more than their share.
int irregularity(std::span<const int> valences) {
  int sum = 0;
  for (const int l : valences) sum += (l - 4) * (l - 4);
  return sum;
}

struct Parting {
  BasicOperation operation;
  int gain;  // by which the irregularity falls
};

// All operations that part v, as even splits as there are or collapses.
std::vector<Parting> partings(const QuadMesh& m, VertexId v) {
  std::vector<Parting> result;
  const int l = m.face_valence(v);
  std::vector<HalfEdgeId> out;
  m.for_each_out(v, [&](HalfEdgeId h) { out.push_back(h); });
  if (l == 2) {
    for (const HalfEdgeId h : out) {
      const std::array<VertexId, 4> c = m.corners(QuadMesh::face(h));
      std::array<int, 4> before{};
      std::transform(c.begin(), c.end(), before.begin(), [&](VertexId x) { return m.valence(x); });
      // The far corner keeps its name: it takes v in.
      const HalfEdgeId keep = QuadMesh::opposite(h);
      const std::array<int, 3> after{m.valence(m.origin(keep)), m.valence(m.target(h)) - 1,
                                     m.valence(m.target(keep)) - 1};
      result.push_back({{BasicOperation::Kind::collapse, keep, {}, 0}, irregularity(before) - irregularity(after)});
    }
    return result;
  }
  const int half = l / 2;
  for (int i = 0; i < l; ++i) {
    const HalfEdgeId first = out[static_cast<std::size_t>(i)];
    const HalfEdgeId end = out[static_cast<std::size_t>((i + half) % l)];
    const int la = m.valence(m.target(first));
    const int lb = m.valence(m.target(end));
    const std::array<int, 3> before{l, la, lb};
    const std::array<int, 4> after{half + 1, l - half + 1, la + 1, lb + 1};
    result.push_back(
        {{BasicOperation::Kind::split, first, m.twin(end), 0}, irregularity(before) - irregularity(after)});
  }
  return result;
}

}  // namespace

Refusal part_vertex(Editor& editor, VertexId v) {
  const QuadMesh& m = editor.mesh();
  if (m.is_boundary(v) || (m.face_valence(v) != 2 && m.face_valence(v) < 6)) return Refusal::wrong_valences;
  std::vector<Parting> ways = partings(m, v);
  std::stable_sort(ways.begin(), ways.end(), [](const Parting& a, const Parting& b) { return a.gain > b.gain; });
  Refusal refusal = Refusal::irregular_in_the_way;
  for (const Parting& way : ways) {
    if (way.gain <= 0) break;
    bool boundary = false;
    for (const VertexId x : changed_vertices(m, way.operation)) boundary = boundary || (x.valid() && m.is_boundary(x));
    refusal = boundary ? Refusal::touches_boundary : editor.run(way.operation).refusal;
    if (refusal == Refusal::none) break;
  }
  return refusal;
}

int part_all(Editor& editor) {
  const QuadMesh& m = editor.mesh();
  int made = 0;
  for (bool again = true; again;) {
    again = false;
    for (const VertexId v : m.vertices()) {
      if (!m.is_live(v) || editor.is_fixed(v)) continue;
      const int l = m.face_valence(v);
      if (l >= 3 && l <= 5) continue;
      if (part_vertex(editor, v) == Refusal::none) ++made, again = true;
    }
  }
  return made;
}

}  // namespace requad::mesh
