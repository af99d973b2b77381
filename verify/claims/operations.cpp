// Claims about basic and atomic operations (sections 2, 4, 5). The checks try every operation that keeps the boundary,
// at every site of generated neighbourhoods.
#include <algorithm>
#include <map>
#include <set>

#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "verify/claims/judging.hpp"

namespace requad::verify {

using mesh::BasicOperation;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Refusal;
using mesh::Region;
using mesh::VertexId;
using Kind = mesh::BasicOperation::Kind;

namespace {

constexpr int kLargestNeighbourhood = 60;  // faces; checks that try all pairs of operations use smaller regions only

// All legal operations that change no valence on the boundary, each once: two flips for each edge, two collapses for
// each face (one for each diagonal), and one split for any two edges at a vertex.
std::vector<BasicOperation> all_operations(const QuadMesh& m) {
  std::vector<BasicOperation> operations;
  const auto add = [&](const BasicOperation& op) {
    if (mesh::why_not(m, op) != Refusal::none) return;
    for (const VertexId v : mesh::changed_vertices(m, op)) {
      if (v.valid() && m.is_boundary(v)) return;
    }
    operations.push_back(op);
  };
  for (const HalfEdgeId h : m.half_edges()) {
    if (h < m.twin(h)) {
      add({Kind::flip_ccw, h, {}, 0});
      add({Kind::flip_cw, h, {}, 0});
    }
    if (h.index() % 4 < 2) add({Kind::collapse, h, {}, 0});
  }
  for (const VertexId v : m.vertices()) {
    if (m.is_boundary(v)) continue;
    std::vector<HalfEdgeId> out;
    m.for_each_out(v, [&out](HalfEdgeId h) { out.push_back(h); });
    for (std::size_t i = 0; i < out.size(); ++i) {
      for (std::size_t k = i + 1; k < out.size(); ++k) add({Kind::split, out[i], m.twin(out[k]), 0});
    }
  }
  return operations;
}

struct Result {
  BasicOperation operation;
  QuadMesh mesh;
  std::vector<VertexId> irregular;
  std::multiset<int> valences;  // of the irregular ones
};

Result performed(const QuadMesh& m, const BasicOperation& op) {
  Result r{op, m, {}, {}};
  mesh::apply(r.mesh, op);
  r.irregular = mesh::irregular_vertices(r.mesh);
  for (const VertexId v : r.irregular) r.valences.insert(r.mesh.valence(v));
  return r;
}

bool is_flip(Kind kind) { return kind == Kind::flip_ccw || kind == Kind::flip_cw; }

// A region whose vertex is at least two rings of quads away from the boundary, so that no operation at the vertex comes
// near the boundary. Null if there is none.
const Region* neighbourhood(const VertexStudy& s) {
  for (const Region& region : s.glued) {
    const auto irregular = mesh::irregular_vertices(region.mesh);
    if (irregular.size() > 1) continue;
    if (irregular.empty()) return &region;
    std::set<VertexId> reached{irregular[0]};
    for (int ring = 0; ring < 2; ++ring) {
      std::set<VertexId> wider = reached;
      for (const VertexId v : reached) {
        if (region.mesh.is_boundary(v)) continue;
        region.mesh.for_each_out(v, [&](HalfEdgeId h) {
          for (const VertexId w : region.mesh.corners(QuadMesh::face(h))) wider.insert(w);
        });
      }
      reached = std::move(wider);
    }
    if (std::none_of(reached.begin(), reached.end(), [&](VertexId v) { return region.mesh.is_boundary(v); }))
      return &region;
  }
  return nullptr;
}

// Places a violation in a region, for for_each_of().
auto placed_in(const Region& region) {
  return [&region](const auto&, std::string what) { return Violation{std::move(what), "", "", region}; };
}

// Meshes to try single operations on: the neighbourhood, or the first configuration of a small region.
const Region* sample(const Study& study) {
  const Region* region = nullptr;
  if (const auto* vertex = std::get_if<VertexStudy>(&study)) region = neighbourhood(*vertex);
  if (const auto* pair = std::get_if<PairStudy>(&study); pair != nullptr && !pair->found.nodes.empty())
    region = &pair->found.nodes[0].region;
  return region != nullptr && region->mesh.face_count() <= kLargestNeighbourhood ? region : nullptr;
}

// How far the valences are outside 3 to 5, summed.
int excess(const std::multiset<int>& valences) {
  int sum = 0;
  for (const int l : valences) sum += std::max(l - 5, 0) + std::max(3 - l, 0);
  return sum;
}

// Whether a sequence of splits leads to v3s and v5s alone. Each split must bring the valences nearer to these. Tries
// the split with the largest gain first, and backtracks.
bool reducible_by_splits(const QuadMesh& m, int now) {
  if (now == 0) return true;
  std::multimap<int, BasicOperation> better;
  for (const BasicOperation& op : all_operations(m)) {
    if (op.kind != Kind::split) continue;
    const int then = excess(performed(m, op).valences);
    if (then < now) better.emplace(then, op);
  }
  return std::any_of(better.begin(), better.end(), [&m](const auto& step) {
    return reducible_by_splits(performed(m, step.second).mesh, step.first);
  });
}

// What is wrong with the valences after an operation, compared with those that section 4 gives, or "".
std::string check_valences(const QuadMesh& m, const BasicOperation& op) {
  QuadMesh after = m;
  const mesh::Applied done = mesh::apply(after, op);
  std::map<VertexId, int> expected;  // valence of every vertex afterwards
  for (const VertexId v : m.vertices()) expected[v] = m.valence(v);
  const auto c = mesh::changed_vertices(m, op);
  if (is_flip(op.kind)) {
    --expected[c[0]], --expected[c[1]], ++expected[c[2]], ++expected[c[3]];
  } else if (op.kind == Kind::collapse) {
    const VertexId keep = m.origin(op.h), gone = m.target(m.next(op.h));
    expected[keep] += expected[gone] - 2;
    expected.erase(gone);
    --expected[m.target(op.h)], --expected[m.origin(m.previous(op.h))];
  } else {
    // The edges strictly between the two edges of the path, counted on the mesh before the split.
    int group = 0;
    for (HalfEdgeId h = m.ccw(op.h); h != m.twin(op.last); h = m.ccw(h)) ++group;
    const VertexId made = after.origin(QuadMesh::opposite(done.made));
    expected[made] = group + 2;
    expected[c[0]] = m.valence(c[0]) - 2 - group + 2;
    ++expected[c[1]], ++expected[c[2]];
  }
  bool same = static_cast<int>(expected.size()) == after.vertex_count();
  for (const auto& [v, valence] : expected) same = same && after.is_live(v) && after.valence(v) == valence;
  return same ? "" : mesh::to_string(op) + " changes other valences than section 4 says";
}

// Whether one split at an end of a flip's edge, and one collapse, make the mesh that the flip made.
bool is_split_and_collapse(const Region& region, const std::vector<BasicOperation>& operations,
                           const BasicOperation& flip, const QuadMesh& flipped) {
  const QuadMesh& m = region.mesh;
  const VertexId root = m.origin(region.root);
  const std::string target = mesh::signature(flipped, flipped.out(root));
  bool found = false;
  for (const BasicOperation& first : operations) {
    if (found || first.kind != Kind::split ||
        (m.origin(first.h) != m.origin(flip.h) && m.origin(first.h) != m.target(flip.h)))
      continue;
    QuadMesh halfway = m;
    const HalfEdgeId made = mesh::apply(halfway, first).made;
    for (const VertexId v : halfway.corners(QuadMesh::face(made))) {
      halfway.for_each_out(v, [&](HalfEdgeId h) {
        for (const HalfEdgeId corner : {h, QuadMesh::next(h)}) {
          QuadMesh result = halfway;
          if (found || mesh::collapse(result, corner) != Refusal::none) continue;
          found = mesh::signature(result, result.out(root)) == target;
        }
      });
    }
  }
  return found;
}

// What is wrong with an operation's inverse, and with what a flip is made of, or "".
std::string check_inverse(const Region& region, const std::vector<BasicOperation>& operations,
                          const BasicOperation& op) {
  const QuadMesh& m = region.mesh;
  QuadMesh after = m;
  const mesh::Applied done = mesh::apply(after, op);
  // A flip keeps the number of faces, a split adds one, and a collapse removes one. So no sequence of flips and splits
  // makes a collapse, and no sequence of flips and collapses makes a split.
  const int faces = op.kind == Kind::split ? 1 : op.kind == Kind::collapse ? -1 : 0;
  if (after.face_count() - m.face_count() != faces) return mesh::to_string(op) + " makes a wrong number of faces";
  const Kind inverse = op.kind == Kind::split      ? Kind::collapse
                       : op.kind == Kind::collapse ? Kind::split
                       : op.kind == Kind::flip_cw  ? Kind::flip_ccw
                                                   : Kind::flip_cw;
  QuadMesh back = after;
  if (done.inverse.kind != inverse || mesh::apply(back, done.inverse).refusal != Refusal::none || !(back == m))
    return mesh::to_string(op) + " has no inverse of the other kind";
  if (is_flip(op.kind) && !is_split_and_collapse(region, operations, op, after))
    return mesh::to_string(op) + " is no split and collapse";
  return "";
}

}  // namespace

Judgement judge_single_vertex_operations(const VertexStudy& s) {
  const Region* region = neighbourhood(s);
  if (region == nullptr || s.valence() == 4) return not_applicable();
  const VertexId v = mesh::irregular_vertices(region->mesh)[0];
  std::vector<BasicOperation> at_vertex = all_operations(region->mesh);
  std::erase_if(at_vertex, [&](const BasicOperation& op) {
    const auto changed = mesh::changed_vertices(region->mesh, op);
    return std::find(changed.begin(), changed.end(), v) == changed.end();
  });
  return for_each_of(
      at_vertex, "operation", "more than one irregular vertex afterwards",
      [&](const BasicOperation& op) {
        return performed(region->mesh, op).irregular.size() > 1
                   ? ""
                   : mesh::to_string(op) + " does not increase the number of irregular vertices";
      },
      placed_in(*region));
}

Judgement judge_valence_changes(const Study& s) {
  const Region* region = sample(s);
  if (region == nullptr) return not_applicable();
  return for_each_of(
      all_operations(region->mesh), "operation", "the valences that section 4 gives",
      [&](const BasicOperation& op) { return check_valences(region->mesh, op); }, placed_in(*region));
}

Judgement judge_inverses(const Study& s) {
  const Region* region = sample(s);
  if (region == nullptr || region->mesh.face_count() > kLargestNeighbourhood / 2) return not_applicable();
  const std::vector<BasicOperation> operations = all_operations(region->mesh);
  return for_each_of(
      operations, "operation", "an inverse; for a flip a split and a collapse",
      [&](const BasicOperation& op) { return check_inverse(*region, operations, op); }, placed_in(*region));
}

// Counts, by kind of operation, the meshes in which one adjacent 3-5 pair is left and nothing else is irregular.
Judgement judge_adjacent_pair(const PairStudy& s) {
  std::vector<std::size_t> adjacent;
  for (std::size_t i = 0; i < s.found.nodes.size(); ++i) {
    const theory::Configuration& c = s.found.nodes[i].reading.configuration;
    if (c.d1() + c.d2() == 1 && c.parameters.e.minCoeff() >= 2) adjacent.push_back(i);
  }
  const auto problem = [&s](std::size_t i) -> std::string {
    const Region& region = s.found.nodes[i].region;
    std::map<Kind, std::set<std::string>> results;
    for (const BasicOperation& op : all_operations(region.mesh)) {
      const Result r = performed(region.mesh, op);
      if (r.valences != std::multiset<int>{3, 5} || !r.mesh.adjacent(r.irregular[0], r.irregular[1])) continue;
      results[is_flip(op.kind) ? Kind::flip_ccw : op.kind].insert(mesh::signature(r.mesh, region.root));
    }
    const auto number = [&results](Kind kind) { return results[kind].size(); };
    if (number(Kind::collapse) == 2 && number(Kind::split) == 2 && number(Kind::flip_ccw) == 2) return "";
    return std::to_string(number(Kind::collapse)) + " collapses, " + std::to_string(number(Kind::split)) +
           " splits and " + std::to_string(number(Kind::flip_ccw)) + " flips move the adjacent pair, not two of each";
  };
  return for_each_of(adjacent, "adjacent pair", "moved by 2 collapses, 2 splits and 2 flips", problem,
                     [&s](std::size_t i, std::string what) { return at_node(s, i, std::move(what)); });
}

Judgement judge_vertex_steps(const VertexStudy& s) {
  const Region* region = neighbourhood(s);
  const int valence = s.valence();
  if (region == nullptr || (valence != 3 && valence != 5)) return not_applicable();
  const QuadMesh& m = region->mesh;
  const VertexId v = mesh::irregular_vertices(m)[0];
  const Kind other_kind = valence == 3 ? Kind::collapse : Kind::split;
  // For each neighbour n of v: the operations after which n has v's valence and everything else that is irregular is
  // one adjacent 3-5 pair.
  std::map<VertexId, std::map<bool, int>> ways;
  for (const BasicOperation& op : all_operations(m)) {
    const Result r = performed(m, op);
    std::multiset<int> expected{3, 5, valence};
    if (r.valences != expected || (!is_flip(op.kind) && op.kind != other_kind)) continue;
    for (const VertexId n : m.neighbours(v)) {
      if (!r.mesh.is_live(n) || r.mesh.valence(n) != valence) continue;
      std::vector<VertexId> rest;
      for (const VertexId w : r.irregular) {
        if (w != n) rest.push_back(w);
      }
      if (rest.size() == 2 && r.mesh.valence(rest[0]) + r.mesh.valence(rest[1]) == 8 &&
          r.mesh.adjacent(rest[0], rest[1]))
        ++ways[n][is_flip(op.kind)];
    }
  }
  const std::string others = valence == 3 ? " collapses" : " splits";
  return for_each_of(
      m.neighbours(v), "neighbour", "reached by 2" + others + " and 2 flips",
      [&](VertexId n) {
        return ways[n][true] == 2 && ways[n][false] == 2
                   ? ""
                   : "towards one neighbour " + std::to_string(ways[n][false]) + others + " and " +
                         std::to_string(ways[n][true]) + " flips, not two and two";
      },
      placed_in(*region));
}

Judgement judge_quadruple(const VertexStudy& s) {
  const Region* region = neighbourhood(s);
  if (region == nullptr || s.valence() != 4) return not_applicable();
  std::vector<BasicOperation> flips = all_operations(region->mesh);
  std::erase_if(flips, [](const BasicOperation& op) { return !is_flip(op.kind); });
  // The smallest grids have no flip that spares the boundary.
  return for_each_of(
      flips, "flip", "makes 3-3-5-5, and the other flip removes them",
      [region](const BasicOperation& op) -> std::string {
        QuadMesh after = region->mesh;
        const mesh::Applied done = mesh::apply(after, op);
        std::multiset<int> valences;
        for (const VertexId v : mesh::irregular_vertices(after)) valences.insert(after.valence(v));
        if (valences != std::multiset<int>{3, 3, 5, 5}) return mesh::to_string(op) + " does not make 3-3-5-5";
        if (mesh::apply(after, done.inverse).refusal != Refusal::none || !mesh::irregular_vertices(after).empty())
          return "the other flip does not remove 3-3-5-5";
        return "";
      },
      placed_in(*region));
}

Judgement judge_type_changes(const VertexStudy& s) {
  const Region* region = neighbourhood(s);
  const int valence = s.valence();
  if (region == nullptr || valence == 3 || valence == 4 || valence == 5) return not_applicable();
  const bool parts = valence == 2 || valence == 6;
  const auto problem = [&](int) -> std::string {
    if (!parts)
      return reducible_by_splits(region->mesh, excess({valence})) ? "" : "no splits lead to v3s and v5s alone";
    const Kind kind = valence == 2 ? Kind::collapse : Kind::split;
    const std::multiset<int> goal = valence == 2 ? std::multiset<int>{3, 3} : std::multiset<int>{5, 5};
    const auto operations = all_operations(region->mesh);
    const bool found = std::any_of(operations.begin(), operations.end(), [&](const BasicOperation& op) {
      return op.kind == kind && performed(region->mesh, op).valences == goal;
    });
    return found ? "" : "no single operation parts the vertex in two";
  };
  return for_each_of(std::array{valence}, "vertex of valence " + std::to_string(valence),
                     valence == 2   ? "one collapse makes 3-3"
                     : valence == 6 ? "one split makes 5-5"
                                    : "splits make v3s and v5s alone",
                     problem, placed_in(*region));
}

}  // namespace requad::verify
