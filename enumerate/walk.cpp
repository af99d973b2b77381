#include "enumerate/walk.hpp"

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "enumerate/generators.hpp"
#include "mesh/irregular/pair_moves.hpp"
#include "mesh/topology/separatrix.hpp"
#include "theory/separatrix_vector.hpp"

namespace requad::enumerate {

using mesh::HalfEdgeId;
using mesh::PairFrame;
using mesh::PairMove;
using mesh::PairStep;
using mesh::QuadMesh;
using mesh::VertexId;
using theory::ConfigurationTable;
using theory::Crossing;
using theory::PairType;
using theory::Place;

namespace {

// The move that makes each of the theorem's steps (theory::step_offset): d1 = b, d2 = a, and the table of pair_moves.hpp.
PairStep mesh_step(PairType type, int step) {
  using enum PairStep;
  static constexpr std::array<PairStep, 4> kThrees{close, slide_second, open, slide_first};
  static constexpr std::array<PairStep, 4> kFives{open, slide_first, close, slide_second};
  static constexpr std::array<PairStep, 4> kMixed{slide_second, close, slide_first, open};
  const auto& steps = !type.symmetric() ? kMixed : type.l1 == 3 ? kThrees : kFives;
  return steps[static_cast<std::size_t>(step)];
}

class Walker {
 public:
  Walker(const ConfigurationTable& table, mesh::Region start, const WalkProgress& progress)
      : table_(table),
        type_(table.shape().type()),
        region_(std::move(start)),
        m_(region_.mesh),
        positions_(mesh::boundary_positions(region_)),
        mover_(region_.mesh),
        progress_(progress) {
    // A slide may split all along a side before it collapses.
    const auto room = static_cast<int>(table.shape().longest()) + 4;
    region_.mesh.reserve(static_cast<int>(table.most_faces()) + room, static_cast<int>(table.most_vertices()) + room);
    tried_.assign(static_cast<std::size_t>(table.size()), 0);
    way_back_.assign(static_cast<std::size_t>(table.size()), kUnseen);
    result_.predicted = table.pairs();
    result_.predicted_edges = table.count_edges();
  }

  WalkResult run() {
    const auto irregular = mesh::irregular_vertices(m_);
    if (irregular.size() == 1) pair_ = {irregular[0], irregular[0]};
    if (irregular.size() == 2) {
      pair_ = {irregular[0], irregular[1]};
      if (m_.valence(pair_[0]) < m_.valence(pair_[1])) std::swap(pair_[0], pair_[1]);
    }
    if (irregular.empty() || irregular.size() > 2) {
      fail("the region to start from does not hold a pair");
    } else if (identify("the region to start from")) {
      visit(kStart);
      while (result_.problem.empty() && advance()) {
      }
    }
    if (progress_) progress_(visited_since_);
    if (!result_.problem.empty()) result_.mesh = region_;
    result_.mesh_bytes = static_cast<std::int64_t>(region_.mesh.bytes());
    result_.other_bytes = static_cast<std::int64_t>(table_.bytes() + positions_.capacity() * sizeof(positions_[0]) +
                                                    tried_.capacity() + way_back_.capacity());
    return std::move(result_);
  }

 private:
  static constexpr std::uint8_t kUnseen = 255;
  static constexpr std::uint8_t kStart = 254;

  // Where the mesh is, as identified last.
  struct Here {
    int number = -1;
    Place place;
    PairFrame frame;  // of the labelling that the place stands for, or of the merged vertex
    PairFrame other;  // of its other labelling (theory-3), if there is one
  };

  void fail(std::string problem) {
    if (!result_.problem.empty()) return;
    result_.problem = std::move(problem);
    if (here_.number >= 0) {
      result_.configuration = "(" + std::to_string(here_.place.at.m) + "," + std::to_string(here_.place.at.n);
      if (type_.symmetric() && type_.rotation_count() > 1) result_.configuration += "," + std::to_string(here_.place.p);
      result_.configuration += ")";
    }
  }

  // The separatrices of the pair, those of pair_[1] from count_[0] on, each vertex's counter-clockwise from out(v).
  // False if there are too many, or one ends neither at the boundary nor at the other vertex.
  bool trace_all() {
    std::size_t n = 0;
    const std::size_t vertices = pair_[0] == pair_[1] ? 1 : 2;
    count_ = {0, 0};
    for (std::size_t i = 0; i < vertices; ++i) {
      const VertexId v = pair_[i];
      if (!m_.is_live(v) || m_.is_boundary(v)) return false;
      HalfEdgeId h = m_.out(v);
      do {
        if (n == starts_.size()) return false;
        starts_[n] = h;
        arrivals_[n].last = h;
        ++n, ++count_[i];
        h = m_.ccw(h);
      } while (h != m_.out(v));
    }
    mesh::trace_ends(m_, std::span(arrivals_).first(n), m_.half_edge_capacity());
    for (std::size_t i = 0; i < n; ++i) {
      const mesh::SeparatrixEnd& arrival = arrivals_[i];
      result_.traced += arrival.length;
      const VertexId at = m_.target(arrival.last);
      Crossing& crossing = crossings_[i];
      crossing = {-1, -1, arrival.length};
      if (arrival.end == mesh::Separatrix::End::boundary) {
        if (at.slot() >= positions_.size()) return false;
        crossing.side = positions_[at.slot()].side;
        crossing.distance = positions_[at.slot()].distance;
      } else if (vertices == 1 || at != pair_[i < count_[0] ? 1 : 0]) {
        return false;
      }
    }
    return true;
  }

  // Reads off the mesh where it is, by the pair's separatrices.
  bool identify(const char* after) {
    ++result_.identifications;
    Here found;
    const bool merged = pair_[0] == pair_[1];
    const bool traced = trace_all();
    const auto vector = [&](std::size_t i) {
      return std::span<const Crossing>(crossings_).subspan(i == 0 ? 0 : count_[0], count_[i]);
    };
    const auto start = [&](std::size_t i, int separatrix) {
      return starts_[(i == 0 ? 0 : count_[0]) + static_cast<std::size_t>(separatrix)];
    };
    if (traced && merged && type_.symmetric()) {
      const int first = theory::locate_merged(table_.shape(), vector(0));
      if (first >= 0) {
        found.place = {1, {0, 0}};
        const HalfEdgeId h = start(0, first);
        found.frame = {h, m_.ccw(h), pair_[0], pair_[0], 0, 0};
        found.number = table_.find(found.place);
      }
    } else if (traced && !merged &&
               count_ == std::array{static_cast<std::size_t>(type_.l1), static_cast<std::size_t>(type_.l2)}) {
      if (const auto located = theory::locate(table_.shape(), vector(0), vector(1))) {
        const theory::Labelling& l = located->labelling;
        found.place.p = l.p;
        found.place.at = type_.symmetric() ? theory::GridPoint{l.d1, l.d2} : theory::GridPoint{l.e[0], l.e[1]};
        // Seen from the vertex whose labels come first.
        const std::size_t from = located->swapped ? 1 : 0;
        const HalfEdgeId leg = start(from, from == 0 ? located->leg1 : located->leg2);
        found.frame = {leg, m_.ccw(leg), pair_[from], pair_[1 - from], static_cast<int>(l.d1), static_cast<int>(l.d2)};
        found.other = {
            found.frame.second_leg, m_.ccw(found.frame.second_leg), pair_[from], pair_[1 - from], found.frame.d2,
            found.frame.d1};
        found.number = table_.find(found.place);
      }
    }
    here_ = found;
    if (found.number < 0) fail(std::string("after ") + after + " the separatrices are those of no configuration");
    return found.number >= 0;
  }

  void visit(std::uint8_t way_back) {
    way_back_[static_cast<std::size_t>(here_.number)] = way_back;
    ++(table_.is_merged(here_.place) ? result_.merged : result_.configurations);
    if (++visited_since_ == 1024) {
      if (progress_) progress_(visited_since_);
      visited_since_ = 0;
    }
  }

  PairMove move_of(const ConfigurationTable::Move& predicted, int slot) const {
    PairMove move{predicted.other ? here_.other : here_.frame, mesh_step(type_, predicted.step)};
    if (table_.is_merged(here_.place)) {
      // Into quadrant p: the separatrix that ends on side p + 1 becomes a middle outward one, label 2.
      const int p = table_.move(here_.place, slot).to.p;
      for (int i = 0; i < p && type_.rotation_count() > 1; ++i) move.frame.first_leg = m_.ccw(move.frame.first_leg);
      move.frame.second_leg = m_.ccw(move.frame.first_leg);
    }
    return move;
  }

  // Makes the move of a slot and identifies the result, which must be as predicted. False if the mesh refused, or failed.
  bool make(const ConfigurationTable::Move& predicted, int slot) {
    const mesh::PairMover::Moved moved = mover_.move(move_of(predicted, slot));
    if (moved.refusal != mesh::Refusal::none) {
      if (predicted.target >= 0) {
        fail(std::string("a step that theory allows was refused: ") + std::string(moved.refusal.clause()));
        return false;
      }
      ++result_.refusals;
      const Place before = here_.place;
      if (identify("a refused move") && !(here_.place == before)) fail("a refused move changed the mesh");
      return false;
    }
    if (predicted.target < 0) {
      fail("a step that theory excludes was made");
      return false;
    }
    ++result_.moves;
    result_.operations += moved.operations;
    pair_ = {moved.v1, moved.v2};
    const Here before = here_;
    if (!identify("a move")) {
      here_ = before;
      return false;
    }
    if (here_.number != predicted.target || !(here_.place == predicted.to)) {
      here_ = before;
      fail("a step leads elsewhere than theory says");
      return false;
    }
    return true;
  }

  // One more edge, or the way back; false at the end.
  bool advance() {
    const auto at = static_cast<std::size_t>(here_.number);
    const Place place = here_.place;
    const auto bit = [](int slot) { return static_cast<std::uint8_t>(1U << static_cast<unsigned>(slot)); };
    for (int slot = 0; slot < table_.slot_count(place); ++slot) {
      if ((tried_[at] & bit(slot)) != 0) continue;
      const ConfigurationTable::Move predicted = table_.move(place, slot);
      tried_[at] |= bit(slot);
      if (!make(predicted, slot)) return result_.problem.empty();
      ++result_.edges;
      std::uint8_t& there = tried_[static_cast<std::size_t>(predicted.target)];
      if ((there & bit(predicted.back_slot)) != 0) {
        fail("two moves make one step");
        return false;
      }
      there |= bit(predicted.back_slot);
      if (way_back_[static_cast<std::size_t>(predicted.target)] == kUnseen) {
        visit(static_cast<std::uint8_t>(predicted.back_slot));
        return true;
      }
      return go_back(predicted.back_slot, place);
    }
    if (way_back_[at] == kStart) return false;
    const int slot = way_back_[at];
    return go_back(slot, table_.move(place, slot).to);
  }

  // The inverse of a move that led here.
  bool go_back(int slot, const Place& where) {
    if (!make(table_.move(here_.place, slot), slot)) return false;
    if (!(here_.place == where)) fail("the inverse of a move does not lead back");
    return result_.problem.empty();
  }

  const ConfigurationTable& table_;
  PairType type_;
  mesh::Region region_;
  const QuadMesh& m_;
  std::vector<mesh::BoundaryPosition> positions_;  // no move touches the boundary
  mesh::PairMover mover_;
  const WalkProgress& progress_;
  std::array<VertexId, 2> pair_;
  Here here_;
  // The separatrices as traced last.
  std::array<HalfEdgeId, 2 * theory::kMostSeparatrices> starts_;
  std::array<mesh::SeparatrixEnd, 2 * theory::kMostSeparatrices> arrivals_;
  std::array<Crossing, 2 * theory::kMostSeparatrices> crossings_;
  std::array<std::size_t, 2> count_{};
  std::vector<std::uint8_t> tried_;     // by number: a bit for each slot
  std::vector<std::uint8_t> way_back_;  // by number: the slot that leads towards the start
  std::int64_t visited_since_ = 0;
  WalkResult result_;
};

}  // namespace

WalkResult walk(const ConfigurationTable& table, mesh::Region start, const WalkProgress& progress) {
  return Walker(table, std::move(start), progress).run();
}

WalkResult walk(const theory::RegionShape& shape, const WalkProgress& progress) {
  const ConfigurationTable table(shape);
  if (table.pairs() == 0) return {};
  return walk(table, glue_region(shape.type(), table.smallest()), progress);
}

}  // namespace requad::enumerate
