#include "enumerate/search/partial_mesh.hpp"

namespace requad::enumerate {

// Two edges that join the same vertices enclose a disk. If one of the two vertices had only one quad in the disk, both
// edges would be sides of that quad, and the quad would have the other vertex twice. So each vertex has at least two
// quads there, and by Gauss-Bonnet the irregular vertices inside have index 4 or more. A budget with a smaller index
// needs no test for doubled edges.
PartialMesh::PartialMesh(const std::vector<int>& irregular)
    : budget_(irregular), edges_can_double_(budget_.largest_sum() >= 4) {}

int PartialMesh::add_vertex() {
  if (static_cast<std::size_t>(filling_.vertices) == latest_edge_.size()) latest_edge_.push_back(kNone);
  return filling_.vertices++;
}

void PartialMesh::add_edge(int a, int b) {
  if (!edges_can_double_) return;
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    int& latest = latest_edge_[static_cast<std::size_t>(from)];
    edges_.push_back({to, latest});
    latest = static_cast<int>(edges_.size()) - 1;
  }
}

bool PartialMesh::adjacent(int a, int b) const {
  int e = latest_edge_[static_cast<std::size_t>(a)];
  while (e != kNone && edges_[static_cast<std::size_t>(e)].to != b) e = edges_[static_cast<std::size_t>(e)].earlier;
  return e != kNone;
}

int PartialMesh::add_node(int vertex, int need) {
  nodes_.push_back({vertex, need, kNone, kNone});
  return static_cast<int>(nodes_.size()) - 1;
}

void PartialMesh::open_hole(const std::vector<BoundaryVertex>& ring) {
  RingSums sums;
  const int first = static_cast<int>(nodes_.size());
  for (const auto& [vertex, need] : ring) {
    const int n = add_node(vertex, need);
    if (n > first) link(n - 1, n);
    sums += RingSums(need);
  }
  link(static_cast<int>(nodes_.size()) - 1, first);
  push_hole(sums, first);
  least_faces_ = static_cast<int>(filling_.faces.size()) + least_faces(sums);
}

void PartialMesh::push_hole(RingSums sums, int start) {
  if (sums.empty()) return;
  holes_.push_back({sums, start, first_hole_});
  first_hole_ = static_cast<int>(holes_.size()) - 1;
}

void PartialMesh::place(int v, const Placement& placement) {
  const auto& [x_corner, y_corner, before, middle, after] = placement;
  const auto size = [](const auto& stack) { return static_cast<int>(stack.size()); };
  records_.push_back({x_corner.kind, y_corner.kind, size(nodes_), size(saved_), size(holes_), size(edges_),
                      filling_.vertices, first_hole_, least_faces_});
  const Hole hole = first_hole();
  const bool x_is_new = x_corner.node == kNone;
  const bool y_is_new = y_corner.node == kNone;
  const int w = at(v).next;
  const int x = x_is_new ? add_node(add_vertex(), x_corner.inner) : x_corner.node;
  const int y = y_is_new ? add_node(add_vertex(), y_corner.inner) : y_corner.node;
  save(v), save(w);
  if (!x_is_new) save(x), save(at(x).next);
  if (!y_is_new) save(at(y).previous), save(y);

  if (x_corner.kind != kNone) budget_.take(x_corner.kind);
  if (y_corner.kind != kNone) budget_.take(y_corner.kind);
  filling_.faces.push_back({at(v).vertex, at(w).vertex, at(x).vertex, at(y).vertex});
  if (x_is_new || !before.empty()) add_edge(at(w).vertex, at(x).vertex);
  if (!middle.empty()) add_edge(at(x).vertex, at(y).vertex);
  if (y_is_new || !after.empty()) add_edge(at(y).vertex, at(v).vertex);

  --at(v).need, --at(w).need;
  const int middle_start = middle.empty() ? kNone : close_middle_ring(v, w, x, y, placement);
  if (!before.empty()) at(x).need = x_corner.outer, link(x, w);
  if (!after.empty()) at(y).need = y_corner.outer, link(v, y);

  first_hole_ = hole.next;
  push_hole(after, y);
  push_hole(middle, middle_start);
  push_hole(before, w);
  least_faces_ += 1 - least_faces(hole.sums) + least_faces(before) + least_faces(middle) + least_faces(after);
}

// Links the ring of `middle` and returns its node from which the rest of the old ring continues. A new corner lies on
// this ring only. An old corner that also has a hole on its other side gets a second node here.
int PartialMesh::close_middle_ring(int v, int w, int x, int y, const Placement& placement) {
  const bool x_is_new = placement.x.node == kNone;
  const bool y_is_new = placement.y.node == kNone;
  const int after_x = at(x).next;
  const int before_y = at(y).previous;
  int from = x_is_new ? w : x;
  int to = y_is_new ? v : y;
  if (!placement.before.empty()) from = add_node(at(x).vertex, 0), link(from, after_x);
  if (!placement.after.empty()) to = add_node(at(y).vertex, 0), link(before_y, to);
  if (!x_is_new) at(from).need = placement.x.inner;
  if (!y_is_new) at(to).need = placement.y.inner;
  const int start = from;
  if (y_is_new) link(to, y), to = y;
  if (x_is_new) link(x, from), from = x;
  link(to, from);
  return start;
}

void PartialMesh::undo() {
  const Record& record = records_.back();
  least_faces_ = record.least_faces;
  first_hole_ = record.first_hole;
  holes_.erase(holes_.begin() + record.holes, holes_.end());
  while (static_cast<int>(edges_.size()) > record.edges) {
    // The two half-edges of an edge are stored side by side, so each starts where its neighbour ends.
    const HalfEdge back = edges_.back();
    edges_.pop_back();
    const HalfEdge forth = edges_.back();
    edges_.pop_back();
    latest_edge_[static_cast<std::size_t>(forth.to)] = back.earlier;
    latest_edge_[static_cast<std::size_t>(back.to)] = forth.earlier;
  }
  filling_.faces.pop_back();
  if (record.x_kind != kNone) budget_.give_back(record.x_kind);
  if (record.y_kind != kNone) budget_.give_back(record.y_kind);
  for (; static_cast<int>(saved_.size()) > record.saved; saved_.pop_back()) {
    at(saved_.back().first) = saved_.back().second;
  }
  nodes_.erase(nodes_.begin() + record.nodes, nodes_.end());
  filling_.vertices = record.vertices;
  records_.pop_back();
}

}  // namespace requad::enumerate
