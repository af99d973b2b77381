#include "verify/check/moves.hpp"

#include <algorithm>

#include "verify/check/reading.hpp"

namespace check {

namespace {

constexpr std::array kSteps{Step::slide_first, Step::slide_second, Step::open, Step::close};

struct Change {
  const char* name;
  Step inverse;
  int d1;  // of a 3-3 pair; the opposite of a 5-5 pair
  int d2;
  int e1;  // of a 3-5 pair
  int e2;
  int towards;  // the label of a side
};
constexpr std::array<Change, 4> kChanges{{
    {"slide_first", Step::slide_second, +1, -1, -1, 0, 1},
    {"slide_second", Step::slide_first, -1, +1, +1, 0, 3},
    {"open", Step::close, -1, -1, 0, -1, 2},
    {"close", Step::open, +1, +1, 0, +1, 4},
}};
const Change& change(Step step) { return kChanges[static_cast<std::size_t>(step)]; }

}  // namespace

Step step_of(std::string_view word) {
  for (const Step step : kSteps) {
    if (word == name(step)) return step;
  }
  throw Rejected("there is no such step");
}

const char* name(Step step) { return change(step).name; }
Step inverse(Step step) { return change(step).inverse; }

Moves::Moves(const Region& region, std::vector<std::vector<Labelling>> labellings)
    : region_(region), labellings_(std::move(labellings)) {
  for (std::size_t node = 0; node < labellings_.size(); ++node) {
    for (const Labelling& l : labellings_[node])
      require(node_.emplace(key(l), static_cast<int>(node)).second, "two meshes have one label");
  }
}

std::vector<int> Moves::key(const Labelling& l) const {
  if (region_.symmetric()) return {l.d1, l.d2, l.p};
  return {l.d1, l.d2, l.p, l.e[0], l.e[1]};
}

std::vector<int> Moves::stepped(const Labelling& labelling, Step step) const {
  std::vector<int> to = key(labelling);
  const Change& by = change(step);
  if (region_.symmetric()) {
    const int sign = region_.l1 == 3 ? 1 : -1;
    to[0] += sign * by.d1;
    to[1] += sign * by.d2;
  } else {
    to[3] += by.e1;
    to[4] += by.e2;
  }
  return to;
}

Moves::Slot Moves::slot(const Labelling& l, Step step) const {
  if (region_.symmetric()) return {l.d1, l.d2, l.p, static_cast<int>(step)};
  return {(l.p + change(step).towards - 2) % region_.side_count(), 0, 0, 0};
}

const Labelling& Moves::labelling(const End& end) const {
  for (const Labelling& l : labellings_[static_cast<std::size_t>(end.node)]) {
    if (l.d1 == end.d1 && l.d2 == end.d2 && l.p == end.p) return l;
  }
  throw Rejected("an edge gives a mesh a labelling that it does not have");
}

void Moves::add(const End& from, Step step, const End& to) {
  const Labelling& before = labelling(from);
  const Labelling& after = labelling(to);
  require(stepped(before, step) == key(after), "an edge's step does not lead from the one labelling to the other");
  require(noted_.insert({from.node, slot(before, step)}).second, "a move is given twice");
  noted_.insert({to.node, slot(after, inverse(step))});
}

void Moves::require_all() const {
  for (std::size_t node = 0; node < labellings_.size(); ++node) {
    for (const Labelling& l : labellings_[node]) {
      for (const Step step : kSteps) {
        if (node_.count(stepped(l, step)) == 0) continue;
        if (noted_.count({static_cast<int>(node), slot(l, step)}) == 0)
          throw Rejected("mesh " + std::to_string(node) + " lacks a move: " + name(step) + " from " +
                         std::to_string(l.d1) + " " + std::to_string(l.d2) + " " + std::to_string(l.p));
      }
    }
  }
}

namespace {

// Whether the irregular vertices are a pair of the region or its merged vertex.
bool is_configuration(const Region& region, const std::vector<Irregular>& irregular) {
  if (irregular.size() == 1) return region.symmetric() && irregular[0].index == 4 - region.side_count();
  if (irregular.size() != 2) return false;
  const auto [low, high] = std::minmax(irregular[0].index, irregular[1].index);
  return low == 4 - region.l1 && high == 4 - region.l2;
}

int index_at(const std::vector<Irregular>& irregular, int vertex) {
  const auto it =
      std::find_if(irregular.begin(), irregular.end(), [=](const Irregular& i) { return i.vertex == vertex; });
  return it == irregular.end() ? 0 : it->index;
}

// Takes index off a vertex's entry.
void subtract(std::vector<Irregular>& from, const Irregular& what) {
  const auto it = std::find_if(from.begin(), from.end(), [&](const Irregular& i) { return i.vertex == what.vertex; });
  if (it == from.end()) {
    from.push_back({what.vertex, -what.index});
  } else {
    it->index -= what.index;
    if (it->index == 0) from.erase(it);
  }
}

}  // namespace

Transport::Transport(const Region& region, const Disk& before)
    : region_(region), before_(before.irregular()), pair_(before_) {
  if (pair_.size() == 1) {
    pair_[0].index /= 2;
    pair_.push_back(pair_[0]);
  }
}

// Whether what is left without p' and q is an adjacent 3-5 pair.
bool Transport::fits(const Disk& disk, const Guess& guess) const {
  std::vector<Irregular> left = disk.irregular();
  subtract(left, guess.q);
  subtract(left, guess.moved);
  if (left.size() != 2 || left[0].index * left[1].index != -1) return false;
  const Disk::Star star = disk.star(left[0].vertex);
  const auto end = star.ends.begin() + static_cast<std::ptrdiff_t>(star.size);
  return std::find(star.ends.begin(), end, left[1].vertex) != end;
}

void Transport::pass(const Disk& disk) {
  require(!is_configuration(region_, disk.irregular()), "a script is made of two moves");
  if (!started_) {
    started_ = true;
    for (std::size_t q = 0; q < 2; ++q) {
      const int p = pair_[1 - q].vertex;
      if (index_at(disk.irregular(), p) == index_at(before_, p)) continue;
      for (const Irregular& vertex : disk.irregular())
        guesses_.push_back({pair_[q], {vertex.vertex, pair_[1 - q].index}});
    }
  }
  std::erase_if(guesses_, [&](const Guess& guess) { return !fits(disk, guess); });
  require(!guesses_.empty(), "a script is no transport of one adjacent 3-5 pair");
}

void Transport::arrive(const Disk& disk) const {
  const std::vector<Irregular>& irregular = disk.irregular();
  const bool q_absorbs = std::any_of(guesses_.begin(), guesses_.end(), [&](const Guess& guess) {
    return irregular.size() == 1 ? irregular[0].vertex == guess.moved.vertex
                                 : index_at(irregular, guess.moved.vertex) == guess.moved.index;
  });
  require(!started_ || q_absorbs, "a transported pair comes back to the vertex that sent it");
}

}  // namespace check
