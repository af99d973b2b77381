#include "enumerate/walk.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "enumerate/generators.hpp"
#include "enumerate/pair_locator.hpp"
#include "mesh/irregular/pair_moves.hpp"

namespace requad::enumerate {

using mesh::PairMove;
using mesh::PairStep;
using theory::ConfigurationTable;
using theory::PairType;
using theory::Place;

namespace {

// The pair move that makes each of the theorem's steps (theory::step_offset), by the table of pair_moves.hpp.
PairStep mesh_step(PairType type, int step) {
  using enum PairStep;
  static constexpr std::array<PairStep, 4> kThrees{close, slide_second, open, slide_first};
  static constexpr std::array<PairStep, 4> kFives{open, slide_first, close, slide_second};
  static constexpr std::array<PairStep, 4> kMixed{slide_second, close, slide_first, open};
  const auto& steps = !type.symmetric() ? kMixed : type.l1 == 3 ? kThrees : kFives;
  return steps[static_cast<std::size_t>(step)];
}

// The irregular vertices of a mesh as a pair. Nothing if they do not form one.
std::optional<PairLocator::Pair> find_pair(const mesh::QuadMesh& m) {
  const auto irregular = mesh::irregular_vertices(m);
  if (irregular.size() == 1) return PairLocator::Pair{irregular[0], irregular[0]};
  if (irregular.size() != 2) return std::nullopt;
  PairLocator::Pair pair{irregular[0], irregular[1]};
  if (m.valence(pair[0]) < m.valence(pair[1])) std::swap(pair[0], pair[1]);
  return pair;
}

// The memory of a depth-first traversal of the predicted graph. The number of a configuration and a slot there name a
// move.
class Traversal {
 public:
  static constexpr int kStart = 254;

  explicit Traversal(int configurations)
      : tried_(static_cast<std::size_t>(configurations), 0),
        way_back_(static_cast<std::size_t>(configurations), kUnseen) {}

  bool tried(int number, int slot) const { return (tried_[at(number)] & bit(slot)) != 0; }
  void set_tried(int number, int slot) { tried_[at(number)] |= bit(slot); }
  bool seen(int number) const { return way_back_[at(number)] != kUnseen; }
  // The slot of the move that undoes the one by which this configuration was first reached; kStart where the walk
  // began.
  int way_back(int number) const { return way_back_[at(number)]; }
  void set_way_back(int number, int slot) { way_back_[at(number)] = static_cast<std::uint8_t>(slot); }

  std::size_t bytes() const { return tried_.capacity() + way_back_.capacity(); }

 private:
  static constexpr std::uint8_t kUnseen = 255;
  static std::size_t at(int number) { return static_cast<std::size_t>(number); }
  static std::uint8_t bit(int slot) { return static_cast<std::uint8_t>(1U << static_cast<unsigned>(slot)); }

  std::vector<std::uint8_t> tried_;     // a bit for each slot
  std::vector<std::uint8_t> way_back_;  // a slot, kStart or kUnseen
};

class Walker {
 public:
  Walker(const ConfigurationTable& table, mesh::Region start, const WalkProgress& progress)
      : table_(table),
        type_(table.shape().type()),
        region_(std::move(start)),
        locator_(table, region_),
        mover_(region_.mesh),
        progress_(progress),
        traversal_(table.size()) {
    // A slide may make splits all along a side before it makes a collapse.
    const auto room = static_cast<int>(table.shape().longest()) + 4;
    region_.mesh.reserve(static_cast<int>(table.most_faces()) + room, static_cast<int>(table.most_vertices()) + room);
    result_.predicted = table.pairs();
    result_.predicted_edges = table.count_edges();
  }

  WalkResult run();

 private:
  void fail(std::string problem);
  bool locate(const char* when);
  void visit(int way_back);
  void report_progress();

  bool advance();
  bool walk_edge(int slot);
  bool go_back(int slot, const Place& where);

  bool make(int slot);
  PairMove mesh_move(const ConfigurationTable::Move& predicted) const;
  void check_refusal(const ConfigurationTable::Move& predicted, mesh::Refusal refusal);
  bool check_arrival(const ConfigurationTable::Move& predicted);

  const ConfigurationTable& table_;
  PairType type_;
  mesh::Region region_;
  PairLocator locator_;
  mesh::PairMover mover_;
  const WalkProgress& progress_;
  Traversal traversal_;
  PairLocator::Pair pair_;
  Location here_;  // as it was located last
  std::int64_t visited_since_ = 0;
  WalkResult result_;
};

WalkResult Walker::run() {
  if (const auto pair = find_pair(region_.mesh); !pair) {
    fail("the region to start from does not hold a pair");
  } else if (pair_ = *pair; locate("in the region to start from")) {
    visit(Traversal::kStart);
    while (result_.problem.empty() && advance()) {
    }
  }
  report_progress();
  if (!result_.problem.empty()) result_.mesh = region_;
  result_.identifications = locator_.calls();
  result_.traced = locator_.traced();
  result_.mesh_bytes = static_cast<std::int64_t>(region_.mesh.bytes());
  result_.other_bytes = static_cast<std::int64_t>(table_.bytes() + locator_.bytes() + traversal_.bytes());
  return std::move(result_);
}

// Keeps the first problem.
void Walker::fail(std::string problem) {
  if (!result_.problem.empty()) return;
  result_.problem = std::move(problem);
  if (here_.known()) result_.configuration = theory::label(type_, here_.place.at, here_.place.p);
}

// Locates the mesh again.
bool Walker::locate(const char* when) {
  here_ = locator_.locate(pair_);
  if (!here_.known()) fail(std::string(when) + ", the separatrices are those of no configuration");
  return here_.known();
}

// Counts a configuration that was reached for the first time.
void Walker::visit(int way_back) {
  traversal_.set_way_back(here_.number, way_back);
  ++(table_.is_merged(here_.place) ? result_.merged : result_.configurations);
  if (++visited_since_ == 1024) report_progress();
}

void Walker::report_progress() {
  if (progress_) progress_(visited_since_);
  visited_since_ = 0;
}

// --- the traversal ---------------------------------------------------------------------------------------------------

// Walks one more edge, or goes back when none is left here. Returns false at the end.
bool Walker::advance() {
  for (int slot = 0; slot < table_.slot_count(here_.place); ++slot) {
    if (!traversal_.tried(here_.number, slot)) return walk_edge(slot);
  }
  const int slot = traversal_.way_back(here_.number);
  return slot != Traversal::kStart && go_back(slot, table_.move(here_.place, slot).to);
}

// Tries a move. If it leads to a new configuration the walk continues from there. Otherwise the move is undone at once.
bool Walker::walk_edge(int slot) {
  const Place from = here_.place;
  const ConfigurationTable::Move predicted = table_.move(from, slot);
  traversal_.set_tried(here_.number, slot);
  if (!make(slot)) return result_.problem.empty();
  ++result_.edges;
  if (traversal_.tried(predicted.target, predicted.back_slot)) {
    fail("two moves make one step");
    return false;
  }
  traversal_.set_tried(predicted.target, predicted.back_slot);
  if (traversal_.seen(predicted.target)) return go_back(predicted.back_slot, from);
  visit(predicted.back_slot);
  return true;
}

// Makes the inverse of a move that led here. It must lead back to `where`.
bool Walker::go_back(int slot, const Place& where) {
  if (!make(slot)) return false;
  if (!(here_.place == where)) fail("the inverse of a move does not lead back");
  return result_.problem.empty();
}

// --- one move --------------------------------------------------------------------------------------------------------

// Makes the move of a slot and compares the mesh with the prediction. Returns false if the mesh refused the move or the
// walk failed.
bool Walker::make(int slot) {
  const ConfigurationTable::Move predicted = table_.move(here_.place, slot);
  const mesh::PairMover::Moved moved = mover_.move(mesh_move(predicted));
  if (moved.refusal != mesh::Refusal::none) {
    check_refusal(predicted, moved.refusal);
    return false;
  }
  if (predicted.target < 0) {
    fail("a step that theory excludes was made");
    return false;
  }
  ++result_.moves;
  result_.operations += moved.operations;
  pair_ = {moved.v1, moved.v2};
  return check_arrival(predicted);
}

PairMove Walker::mesh_move(const ConfigurationTable::Move& predicted) const {
  PairMove move{predicted.other ? here_.other_frame : here_.frame, mesh_step(type_, predicted.step)};
  if (table_.is_merged(here_.place) && type_.has_third_index()) {
    // Into quadrant p: the separatrix that ends on side p + 1 becomes a middle outward one, label 2.
    for (int i = 0; i < predicted.to.p; ++i) move.frame.first_leg = region_.mesh.ccw(move.frame.first_leg);
    move.frame.second_leg = region_.mesh.ccw(move.frame.first_leg);
  }
  return move;
}

void Walker::check_refusal(const ConfigurationTable::Move& predicted, mesh::Refusal refusal) {
  if (predicted.target >= 0) return fail("a step that theory allows was refused: " + std::string(refusal.clause()));
  ++result_.refusals;
  const Place before = here_.place;
  if (locate("after a refused move") && !(here_.place == before)) fail("a refused move changed the mesh");
}

bool Walker::check_arrival(const ConfigurationTable::Move& predicted) {
  const Location before = here_;
  const bool known = locate("after a move");
  if (known && here_.number == predicted.target && here_.place == predicted.to) return true;
  here_ = before;  // the step failed there
  fail("a step leads elsewhere than theory says");
  return false;
}

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
