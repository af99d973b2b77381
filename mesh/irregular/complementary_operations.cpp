#include "mesh/irregular/complementary_operations.hpp"

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

// A path from one vertex to another.
struct Path {
  std::vector<VertexId> vertices;  // with its ends; none if there is no path
  HalfEdgeId first;                // on the first edge, in the patch that the path leaves by

  bool exists() const { return !vertices.empty(); }
  int length() const { return static_cast<int>(vertices.size()) - 1; }
  VertexId from() const { return vertices.front(); }
  VertexId to() const { return vertices.back(); }
};

// The vertices over which a path may lead.
bool is_passable(const Sectors& sectors, VertexId v) { return sectors.may_change(v) && !sectors.is_irregular(v); }

// A shortest path over regular, free vertices; before its end it may touch a feature. Its ends may run along one. It
// leaves `from` by a sector whose excess has the given sign, and reaches `to` by a sector of the other sign.
Path shortest_path(const Editor& editor, BreadthFirstDistances& around, VertexId from, VertexId to, int sign) {
  const QuadMesh& m = editor.mesh();
  const Sectors& sectors = editor.sectors();
  Path result;
  std::vector<VertexId> last;  // vertices of the path before `to`
  std::vector<HalfEdgeId> direct;
  sectors.for_each_edge(to, -sign, [&](VertexId x, HalfEdgeId at) {
    if (x == from) direct.push_back(at);
    if (is_passable(sectors, x)) last.push_back(x);
  });
  sectors.for_each_edge(from, sign, [&](VertexId x, HalfEdgeId at) {
    const bool adjacent = x == to && std::any_of(direct.begin(), direct.end(), [&](HalfEdgeId h) {
                            return h == at || (h == m.twin(at) && !sectors.is_cut(at));
                          });
    if (adjacent) result = {{from, to}, at};
  });
  if (result.exists()) return result;
  around.measure(
      m, last, [&](VertexId v) { return v == from || is_passable(sectors, v); },
      [&](VertexId v) { return v != from && !sectors.is_fixed(v); }, [&](VertexId v, int) { return v == from; });
  VertexId second;
  sectors.for_each_edge(from, sign, [&](VertexId x, HalfEdgeId at) {
    const int d = around.distance(x);
    if (d < 0 || x == from || (second.valid() && d >= around.distance(second))) return;
    second = x;
    result.first = at;
  });
  if (!second.valid()) return result;
  result.vertices = {from, second};
  for (int d = around.distance(second) - 1; d >= 0; --d) {
    const std::vector<VertexId> near = m.neighbours(result.to());
    const auto nearer = [&](VertexId v) { return around.distance(v) == d && v != from; };
    result.vertices.push_back(*std::find_if(near.begin(), near.end(), nearer));
  }
  result.vertices.push_back(to);
  return result;
}

// Whether a path leads over free vertices, with its ends, and still does so.
bool is_open(const Editor& editor, const Path& path) {
  const QuadMesh& m = editor.mesh();
  const Sectors& sectors = editor.sectors();
  for (std::size_t i = 0; i < path.vertices.size(); ++i) {
    const VertexId v = path.vertices[i];
    if (!m.is_live(v) || sectors.is_fixed(v)) return false;
    if (v != path.from() && v != path.to() && sectors.is_irregular(v)) return false;
    if (i > 0 && !m.find_half_edge(path.vertices[i - 1], v).valid()) return false;
  }
  return true;
}

// Of an open path: itself with its first half-edge, and the path back.
Path starting(const QuadMesh& m, Path path) {
  path.first = m.find_half_edge(path.vertices[0], path.vertices[1]);
  return path;
}
Path reversed(const QuadMesh& m, Path path) {
  std::reverse(path.vertices.begin(), path.vertices.end());
  return starting(m, std::move(path));
}

// The helpers after one of them absorbed a pair: it has moved, or is regular, or has become two.
void update_helpers(const Editor& editor, const TransportReport& report, std::vector<VertexId>& helpers) {
  const QuadMesh& m = editor.mesh();
  std::erase_if(helpers, [&](VertexId v) { return !m.is_live(v) || !editor.sectors().is_irregular(v); });
  for (const VertexId v : {report.pair.u(m), report.pair.v(m)}) {
    if (editor.sectors().is_irregular(v) && !contains(helpers, v)) helpers.push_back(v);
  }
}

// What a cancellation tries first. No order is best everywhere, since a helper may be led into a corner.
struct CancellationOrder {
  bool five_walks;  // first; the v3 otherwise
  bool may_cross;   // an adjacent pair may cross a helper
};
constexpr std::array<CancellationOrder, 4> kCancellationOrders{
    {{false, false}, {true, false}, {false, true}, {true, true}}};

Cancellation cancel_in_order(Editor& editor, PairTransport& transport, VertexId three, VertexId five,
                             std::vector<VertexId> helpers, CancellationOrder order, const CancellationEffort& effort) {
  const QuadMesh& m = editor.mesh();
  Cancellation result;
  BreadthFirstDistances around;
  int nearest_yet = std::numeric_limits<int>::max();  // the length of the shortest path yet
  int detours = 0;                                    // transports since then
  int positions_left = effort.positions;
  Path path;  // from the v3 to the v5
  const auto refuse = [&result](Refusal refusal) {
    Cancellation refused;
    refused.refusal = refusal;
    refused.obstacles = result.obstacles;
    return refused;
  };
  for (bool adjacent = false; !adjacent;) {
    // What the last transport left open of its path will do.
    if (!path.exists()) path = shortest_path(editor, around, three, five, -1);
    if (!path.exists() || positions_left < 0) return refuse(EditRefusal::no_path);
    // Splits on the way may make the path longer, and longer again each time that it has become shorter.
    if (path.length() < nearest_yet) {
      nearest_yet = path.length();
      detours = 0;
    } else if (++detours > effort.detours) {
      return refuse(EditRefusal::no_path);
    }
    if (helpers.empty()) return refuse(EditRefusal::lone_pair);
    adjacent = path.length() == 1;
    // The v3 takes the path's first edge, or the v5 its last one.
    TransportReport report;
    report.refusal = EditRefusal::no_path;
    for (const bool five_walks : {order.five_walks, !order.five_walks}) {
      const bool back = five_walks && !adjacent;
      Path way = path;
      if (back) way = is_open(editor, path) ? reversed(m, path) : shortest_path(editor, around, five, three, 1);
      if (!way.exists()) continue;
      // The adjacent pair runs from the v3, or from where the v5 goes.
      const bool from_origin = (m.origin(way.first) == three) || (five_walks && m.origin(way.first) != five);
      const AdjacentPair start{way.first, !from_origin};
      if (!five_walks && editor.sectors().excess(start.at_u()) != -1) continue;
      const VertexId next = five_walks ? start.u(m) : start.v(m);
      report = transport.carry(start, helpers, order.may_cross);
      result.obstacles |= report.obstacles;
      positions_left -= static_cast<int>(report.states);
      if (report.refusal != Refusal::none) continue;
      (five_walks ? five : three) = next;
      way.vertices.erase(way.vertices.begin());
      path = adjacent || !is_open(editor, way) ? Path() : back ? reversed(m, way) : starting(m, way);
      break;
    }
    if (report.refusal != Refusal::none) return refuse(report.refusal);
    ++result.transports;
    result.steps += report.steps;
    update_helpers(editor, report, helpers);
    result.ends.push_back(static_cast<std::size_t>(result.steps));
  }
  result.helpers = std::move(helpers);
  return result;
}

}  // namespace

std::vector<VertexId> usual_helpers(const Editor& editor, BreadthFirstDistances& distances, VertexId three,
                                    VertexId five) {
  return nearest(editor, distances, three, kUsualHelpers,
                 [&](VertexId v) { return v != three && v != five && editor.sectors().is_irregular(v); });
}

Cancellation cancel_pair(Editor& editor, PairTransport& transport, VertexId three, VertexId five,
                         const std::vector<VertexId>& helpers,
                         const std::function<void(std::size_t mark)>& after_transport,
                         const CancellationEffort& effort) {
  const Sectors& sectors = editor.sectors();
  Cancellation result;
  if (!sectors.lacks(three) || !sectors.exceeds(five)) {
    const bool same =
        (sectors.lacks(three) && sectors.lacks(five)) || (sectors.exceeds(three) && sectors.exceeds(five));
    result.refusal = same ? EditRefusal::index : EditRefusal::wrong_valences;
  } else if (helpers.empty()) {
    result.refusal = EditRefusal::lone_pair;
  } else {
    const std::size_t start = editor.mark();
    for (const CancellationOrder order : kCancellationOrders) {
      result = cancel_in_order(editor, transport, three, five, helpers, order, effort);
      if (result.refusal == Refusal::none) break;
      editor.roll_back(start);
    }
    if (result.refusal != Refusal::none) return result;
    for (std::size_t i = start; i < editor.mark(); ++i) result.operations.push_back(editor.edits()[i].operation);
    // The caller may take its time over each transport, so it is shown those that get through only.
    if (after_transport) {
      editor.roll_back(start);
      repeat(editor, result, [&](std::size_t mark) { return after_transport(mark), true; });
    }
  }
  return result;
}

bool repeat(Editor& editor, const Cancellation& made, const std::function<bool(std::size_t mark)>& goes_on) {
  std::size_t done = 0;
  for (const std::size_t end : made.ends) {
    const std::size_t mark = editor.mark();
    for (; done < end; ++done) editor.run(made.operations[done]);
    if (!goes_on(mark)) return false;
  }
  return true;
}

// --- merging and aligning --------------------------------------------------------------------------------------------

namespace {

struct Delta {
  int d1;
  int d2;
};

// The step that changes the extents of an equal pair so (the table of pair_moves.hpp).
PairStep step_for(int valence, Delta delta) {
  const bool three = valence == 3;
  if (delta.d1 == delta.d2) return (delta.d1 < 0) == three ? PairStep::open : PairStep::close;
  return (delta.d2 < 0) == three ? PairStep::slide_first : PairStep::slide_second;
}

// Moves the pair again and again, each time by what `choose` says of its frame, until it says nothing. Makes all moves
// or none.
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
    return {EditRefusal::wrong_valences, {}};
  std::vector<PairFrame> frames = find_frames(m, v1, v2);
  const Refusal refusal = frames.empty() ? EditRefusal::no_rectangle : Refusal::none;
  return {refusal, std::move(frames)};
}

}  // namespace

PairResult merge_pair(Editor& editor, VertexId v1, VertexId v2) {
  const auto [refusal, frames] = frames_of(editor, v1, v2);
  if (refusal != Refusal::none) return {refusal, 0, {}};
  PairResult result;
  for (const PairFrame& frame : frames) {
    if (frame.distance() % 2 != 0) return {EditRefusal::odd_distance, 0, {}};
    // A segment bends first, so that it can shrink along both legs.
    result = move_repeatedly(editor, frame, [](const PairFrame& f) -> std::optional<Delta> {
      if (f.merged()) return std::nullopt;
      return Delta{f.d1 == 0 ? 1 : -1, f.d2 == 0 ? 1 : -1};
    });
    if (result.refusal == Refusal::none) break;
  }
  return result;
}

PairResult align_pair(Editor& editor, VertexId v1, VertexId v2) {
  const auto [refusal, frames] = frames_of(editor, v1, v2);
  PairResult result{refusal, 0, {}};
  for (const PairFrame& frame : frames) {
    const Delta along = frame.d2 <= frame.d1 ? Delta{1, -1} : Delta{-1, 1};
    for (const Delta delta : {along, Delta{-1, -1}, Delta{-along.d1, -along.d2}}) {
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

// How far some excesses are from 0. Large ones count more.
int irregularity(std::span<const int> excesses) {
  int sum = 0;
  for (const int e : excesses) sum += e * e;
  return sum;
}

struct Parting {
  BasicOperation operation;
  int gain;  // by which the irregularity falls
};

// All operations that part a free vertex v: collapses of a v2, or splits that are as even as possible.
std::vector<Parting> partings(const QuadMesh& m, const Sectors& sectors, VertexId v) {
  std::vector<Parting> result;
  const int l = m.face_valence(v);
  std::vector<HalfEdgeId> out;
  m.for_each_out(v, [&](HalfEdgeId h) { out.push_back(h); });
  if (l == 2) {
    for (const HalfEdgeId h : out) {
      const HalfEdgeId keep = QuadMesh::opposite(h);  // the far corner keeps its name: it takes v in
      const int far = sectors.excess(keep);
      const int b = sectors.excess(QuadMesh::next(h));
      const int d = sectors.excess(QuadMesh::previous(h));
      const std::array<int, 4> before{-2, far, b, d};
      const std::array<int, 3> after{far, b - 1, d - 1};
      result.push_back({{BasicOperation::Kind::collapse, keep, {}, 0}, irregularity(before) - irregularity(after)});
    }
    return result;
  }
  const int half = l / 2;
  for (int i = 0; i < l; ++i) {
    const HalfEdgeId first = out[static_cast<std::size_t>(i)];
    const HalfEdgeId last = m.twin(out[static_cast<std::size_t>((i + half) % l)]);
    const int a = sectors.excess(QuadMesh::next(first));
    const int b = sectors.excess(last);
    const std::array<int, 3> before{l - 4, a, b};
    const std::array<int, 4> after{half - 3, l - half - 3, a + 1, b + 1};
    result.push_back({{BasicOperation::Kind::split, first, last, 0}, irregularity(before) - irregularity(after)});
  }
  return result;
}

}  // namespace

Refusal part_vertex(Editor& editor, VertexId v) {
  const QuadMesh& m = editor.mesh();
  const Sectors& sectors = editor.sectors();
  if (sectors.is_fixed(v) || (m.face_valence(v) != 2 && m.face_valence(v) < 6)) return EditRefusal::wrong_valences;
  std::vector<Parting> ways = partings(m, sectors, v);
  std::stable_sort(ways.begin(), ways.end(), [](const Parting& a, const Parting& b) { return a.gain > b.gain; });
  Refusal refusal = EditRefusal::irregular_in_the_way;
  for (const Parting& way : ways) {
    if (way.gain <= 0) break;
    refusal = Refusal::none;
    for (const VertexId x : changed_vertices(m, way.operation)) {
      if (!x.valid() || sectors.may_change(x)) continue;
      refusal = m.is_boundary(x) ? EditRefusal::touches_boundary : FeatureRefusal::breaks_feature;
    }
    if (refusal == Refusal::none) refusal = editor.run(way.operation).refusal;
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
