#include "enumerate/pair_locator.hpp"

namespace requad::enumerate {

using mesh::HalfEdgeId;
using mesh::VertexId;

PairLocator::PairLocator(const theory::ConfigurationTable& table, const mesh::Region& region)
    : table_(table), type_(table.shape().type()), m_(region.mesh), positions_(mesh::boundary_positions(region)) {}

Location PairLocator::locate(const Pair& pair) {
  ++calls_;
  if (!trace(pair)) return {};
  return merged(pair) ? locate_merged(pair[0]) : locate_parted(pair);
}

// Sets the crossings of all separatrices. Returns false if one ends where a separatrix of a pair cannot end.
bool PairLocator::trace(const Pair& pair) {
  count_ = {0, 0};
  if (!collect(pair[0], 0)) return false;
  if (!merged(pair) && !collect(pair[1], 1)) return false;
  const std::size_t total = count_[0] + count_[1];
  // Traces all of them by turns, since following a half-edge is mostly waiting for memory.
  mesh::trace_ends(m_, std::span(arrivals_).first(total), m_.half_edge_capacity());
  for (std::size_t i = 0; i < total; ++i) traced_ += arrivals_[i].length;
  for (std::size_t i = 0; i < total; ++i) {
    if (!set_crossing(i, merged(pair) ? VertexId() : pair[i < count_[0] ? 1 : 0])) return false;
  }
  return true;
}

// Appends the starts of a vertex's separatrices. Returns false if the vertex is not an interior one, or has too many.
bool PairLocator::collect(VertexId v, std::size_t which) {
  if (!m_.is_live(v) || m_.is_boundary(v)) return false;
  const std::size_t before = which == 0 ? 0 : count_[0];
  HalfEdgeId h = m_.out(v);
  do {
    const std::size_t i = before + count_[which];
    if (i == starts_.size()) return false;
    starts_[i] = h;
    arrivals_[i].last = h;
    ++count_[which];
    h = m_.ccw(h);
  } while (h != m_.out(v));
  return true;
}

// Sets the crossing of one separatrix. Returns false if it ends neither at the boundary nor at the vertex `other`.
bool PairLocator::set_crossing(std::size_t i, VertexId other) {
  const mesh::SeparatrixEnd& arrival = arrivals_[i];
  const VertexId at = m_.target(arrival.last);
  theory::Crossing& crossing = crossings_[i];
  crossing = {-1, -1, arrival.length};
  if (arrival.end != mesh::Separatrix::End::boundary) return at == other;
  if (at.slot() >= positions_.size()) return false;
  crossing.side = positions_[at.slot()].side;
  crossing.distance = positions_[at.slot()].distance;
  return true;
}

Location PairLocator::locate_merged(VertexId v) const {
  if (!type_.symmetric()) return {};
  const int first = theory::locate_merged(table_.shape(), of_vertex(crossings_, 0));
  if (first < 0) return {};
  const HalfEdgeId leg = of_vertex(starts_, 0)[static_cast<std::size_t>(first)];
  Location found;
  found.place = {1, {0, 0}};
  found.number = table_.find(found.place);
  found.frame = {leg, m_.ccw(leg), v, v, 0, 0};
  return found;
}

Location PairLocator::locate_parted(const Pair& pair) const {
  if (count_ != std::array{static_cast<std::size_t>(type_.l1), static_cast<std::size_t>(type_.l2)}) return {};
  const auto located = theory::locate(table_.shape(), of_vertex(crossings_, 0), of_vertex(crossings_, 1));
  if (!located) return {};
  const theory::Labelling& l = located->labelling;
  // A frame belongs to the vertex whose labels come first.
  const std::size_t v1 = located->swapped ? 1 : 0;
  const std::size_t v2 = 1 - v1;
  const HalfEdgeId first_leg =
      of_vertex(starts_, v1)[static_cast<std::size_t>(located->swapped ? located->leg2 : located->leg1)];
  const HalfEdgeId second_leg = m_.ccw(first_leg);
  const int d1 = static_cast<int>(l.d1);
  const int d2 = static_cast<int>(l.d2);
  Location found;
  found.place.p = l.p;
  found.place.at = type_.symmetric() ? theory::GridPoint{l.d1, l.d2} : theory::GridPoint{l.e[0], l.e[1]};
  found.number = table_.find(found.place);
  found.frame = {first_leg, second_leg, pair[v1], pair[v2], d1, d2};
  found.other_frame = {second_leg, m_.ccw(second_leg), pair[v1], pair[v2], d2, d1};
  return found;
}

}  // namespace requad::enumerate
