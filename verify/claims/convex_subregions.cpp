#include "verify/claims/convex_subregions.hpp"

#include <algorithm>
#include <set>

namespace requad::verify {

using mesh::FaceId;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::VertexId;

namespace {

class Enumeration {
 public:
  Enumeration(const QuadMesh& mesh, BoundaryIrregular on_boundary)
      : mesh_(mesh), on_boundary_(on_boundary), state_(static_cast<std::size_t>(mesh.face_count()), State::open) {}

  std::vector<ConvexSubregion> run() {
    // The regions whose first face is f: the faces before it are out.
    for (std::size_t f = 0; f < state_.size(); ++f) {
      state_[f] = State::in;
      if (possible(f)) decide();
      state_[f] = State::out;
    }
    return std::move(found_);
  }

 private:
  enum class State { open, in, out };

  // A face that is open and shares an edge with one that is in; state_.size() if there is none.
  std::size_t next_face() const {
    for (std::size_t f = 0; f < state_.size(); ++f) {
      if (state_[f] != State::in) continue;
      for (int k = 0; k < 4; ++k) {
        const HalfEdgeId beyond = mesh_.twin(QuadMesh::half_edge(id(f), k));
        if (beyond.valid() && state_[index(beyond)] == State::open) return index(beyond);
      }
    }
    return state_.size();
  }

  void decide() {
    const std::size_t f = next_face();
    if (f == state_.size()) {
      keep_if_convex();
      return;
    }
    for (const State choice : {State::in, State::out}) {
      state_[f] = choice;
      if (possible(f)) decide();
    }
    state_[f] = State::open;
  }

  // Whether the corners of a face allow a convex region still.
  bool possible(std::size_t f) const {
    const auto corners = mesh_.corners(id(f));
    return std::all_of(corners.begin(), corners.end(), [this](VertexId v) { return vertex_fits(v, false); });
  }

  // Whether the faces at v are none, all, or consecutive ones with enough others outside. `closed`: open faces are out.
  bool vertex_fits(VertexId v, bool closed) const {
    int in = 0, out = 0, starts = 0;
    bool first = false, before = false, is_first = true;
    mesh_.for_each_out(v, [&](HalfEdgeId h) {
      State state = state_[index(h)];
      if (closed && state == State::open) state = State::out;
      const bool is_in = state == State::in;
      in += is_in ? 1 : 0;
      out += state == State::out ? 1 : 0;
      if (is_in && !before && !is_first) ++starts;
      if (is_first) first = is_in;
      is_first = false;
      before = is_in;
    });
    const bool cyclic = !mesh_.is_boundary(v);
    if (first && !(cyclic && before)) ++starts;  // the run at the start is no continuation of that at the end
    if (in == 0) return true;
    if (cyclic && out > 0) {
      const int valence = mesh_.valence(v);
      if (valence != 4 && on_boundary_ == BoundaryIrregular::none) return false;
      if (valence - in < 2) return false;  // concave
    }
    return !closed || starts <= 1;
  }

  void keep_if_convex() {
    ConvexSubregion region{FaceSet(state_.size()), {}, {}};
    std::set<VertexId> vertices;
    int edges = 0;
    for (std::size_t f = 0; f < state_.size(); ++f) {
      if (state_[f] != State::in) continue;
      region.faces.set(f);
      for (int k = 0; k < 4; ++k) {
        const HalfEdgeId h = QuadMesh::half_edge(id(f), k);
        vertices.insert(mesh_.origin(h));
        const HalfEdgeId t = mesh_.twin(h);
        edges += !t.valid() || state_[index(t)] != State::in || h < t ? 1 : 0;
      }
    }
    const int euler = static_cast<int>(vertices.size()) - edges + static_cast<int>(region.faces.count());
    if (euler != 1) return;
    for (const VertexId v : vertices) {
      if (!vertex_fits(v, true)) return;
      if (!mesh::is_irregular(mesh_, v)) continue;
      bool all = true;
      mesh_.for_each_out(v, [&](HalfEdgeId h) { all = all && region.faces.test(index(h)); });
      (all ? region.inside : region.on_boundary).push_back(v);
    }
    found_.push_back(std::move(region));
  }

  static FaceId id(std::size_t f) { return FaceId(static_cast<std::int32_t>(f)); }
  static std::size_t index(HalfEdgeId h) { return static_cast<std::size_t>(QuadMesh::face(h).index()); }

  const QuadMesh& mesh_;
  BoundaryIrregular on_boundary_;
  std::vector<State> state_;
  std::vector<ConvexSubregion> found_;
};

bool holds(const FaceSet& faces, HalfEdgeId h) {
  return h.valid() && faces.test(static_cast<std::size_t>(QuadMesh::face(h).index()));
}

}  // namespace

std::vector<ConvexSubregion> convex_subregions(const QuadMesh& mesh, BoundaryIrregular on_boundary) {
  return Enumeration(mesh, on_boundary).run();
}

std::vector<HalfEdgeId> boundary_of(const QuadMesh& m, const FaceSet& faces) {
  HalfEdgeId first;
  for (std::size_t f = faces.find_first(); f != FaceSet::npos && !first.valid(); f = faces.find_next(f)) {
    for (int k = 0; k < 4 && !first.valid(); ++k) {
      const HalfEdgeId h = QuadMesh::half_edge(FaceId(static_cast<std::int32_t>(f)), k);
      if (!holds(faces, m.twin(h))) first = h;
    }
  }
  std::vector<HalfEdgeId> loop;
  HalfEdgeId h = first;
  do {
    loop.push_back(h);
    h = QuadMesh::next(h);
    while (holds(faces, m.twin(h))) h = QuadMesh::next(m.twin(h));
  } while (h != first);
  return loop;
}

std::vector<std::vector<HalfEdgeId>> sides_of(const QuadMesh& m, const FaceSet& faces) {
  const std::vector<HalfEdgeId> loop = boundary_of(m, faces);
  // The corners at the origin of a half-edge of the loop.
  const auto corners_at = [&](HalfEdgeId h) {
    const VertexId v = m.origin(h);
    int inside = 0;
    m.for_each_out(v, [&](HalfEdgeId g) { inside += holds(faces, g) ? 1 : 0; });
    return (m.is_boundary(v) ? 4 : m.valence(v)) - inside - 2;
  };
  std::size_t start = 0;
  while (start < loop.size() && corners_at(loop[start]) == 0) ++start;
  std::vector<std::vector<HalfEdgeId>> sides;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const HalfEdgeId h = loop[(start + i) % loop.size()];
    for (int corner = corners_at(h); corner > 0; --corner) sides.emplace_back();
    if (!sides.empty()) sides.back().push_back(h);
  }
  return sides;
}

}  // namespace requad::verify
