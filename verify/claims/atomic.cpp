// Claims about atomic operations (section 5): every operation at a vertex or at an adjacent pair, by what it makes of the
// irregular vertices.
#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "verify/claims/judging.hpp"
#include "verify/claims/sites.hpp"

namespace requad::verify {

using mesh::BasicOperation;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Refusal;
using mesh::Region;
using mesh::VertexId;
using Kind = mesh::BasicOperation::Kind;

namespace {

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
  for (const BasicOperation& op : mesh::operations_inside(m)) {
    if (op.kind != Kind::split) continue;
    const int then = excess(performed(m, op).valences);
    if (then < now) better.emplace(then, op);
  }
  return std::any_of(better.begin(), better.end(), [&m](const auto& step) {
    return reducible_by_splits(performed(m, step.second).mesh, step.first);
  });
}

}  // namespace

namespace {

// The neighbour that an adjacent pair has moved to: the one that is a v3 now, or, if none is, the one that is a v5.
VertexId direction(const std::set<VertexId>& neighbours, const QuadMesh& after) {
  for (const int valence : {3, 5}) {
    for (const VertexId w : neighbours) {
      if (after.is_live(w) && after.valence(w) == valence) return w;
    }
  }
  return {};
}

// Where the operations move an adjacent pair to. A neighbour of the v3 must be reached by a collapse, a neighbour of the
// v5 on a face of the edge between the two by a flip, and each other one by a split; each in one way.
std::string check_directions(const Region& region) {
  const QuadMesh& m = region.mesh;
  const std::vector<VertexId> pair = mesh::irregular_vertices(m);
  const VertexId three = m.valence(pair[0]) == 3 ? pair[0] : pair[1];
  const VertexId five = three == pair[0] ? pair[1] : pair[0];
  std::map<VertexId, Kind> expected;
  std::set<VertexId> neighbours;
  for (const VertexId w : m.neighbours(five)) expected[w] = Kind::split;
  const HalfEdgeId edge = m.find_half_edge(three, five);
  if (!edge.valid()) return "the pair is not adjacent";
  for (const HalfEdgeId h : {edge, m.twin(edge)}) {
    for (const VertexId w : m.corners(QuadMesh::face(h))) expected[w] = Kind::flip_ccw;
  }
  for (const VertexId w : m.neighbours(three)) expected[w] = Kind::collapse;
  for (const VertexId w : pair) expected.erase(w);
  for (const auto& [w, kind] : expected) neighbours.insert(w);
  if (neighbours.size() != 6) return "the pair has " + std::to_string(neighbours.size()) + " adjacent vertices";
  std::map<VertexId, std::set<std::pair<Kind, std::string>>> ways;
  for (const BasicOperation& op : mesh::operations_inside(m)) {
    const Performed r = performed(m, op);
    if (r.valences != std::multiset<int>{3, 5} || !r.mesh.adjacent(r.irregular[0], r.irregular[1])) continue;
    const VertexId to = direction(neighbours, r.mesh);
    if (!to.valid()) return mesh::to_string(op) + " moves the pair to none of its six adjacent vertices";
    ways[to].insert({is_flip(op.kind) ? Kind::flip_ccw : op.kind, mesh::signature(r.mesh, region.root)});
  }
  for (const auto& [w, kind] : expected) {
    if (ways[w].size() != 1) return std::to_string(ways[w].size()) + " operations move the pair to one adjacent vertex";
    if (ways[w].begin()->first != kind) return "an operation of another kind moves the pair to an adjacent vertex";
  }
  const auto number = [&ways](Kind kind) {
    return std::count_if(ways.begin(), ways.end(),
                         [kind](const auto& way) { return way.second.begin()->first == kind; });
  };
  return number(Kind::collapse) == 2 && number(Kind::split) == 2 && number(Kind::flip_ccw) == 2
             ? ""
             : "the six directions are not two by collapse, two by split and two by flip";
}

}  // namespace

Judgement judge_adjacent_pair(const PairStudy& s) {
  std::vector<std::size_t> adjacent;
  for (std::size_t i = 0; i < s.found.nodes.size(); ++i) {
    const theory::Configuration& c = s.found.nodes[i].reading.configuration;
    if (c.d1() + c.d2() == 1 && c.parameters.e.minCoeff() >= 2) adjacent.push_back(i);
  }
  return for_each_of(
      adjacent, "adjacent pair", "moved to two adjacent vertices by collapse, to two by split and to two by flip",
      [&s](std::size_t i) { return check_directions(s.found.nodes[i].region); },
      [&s](std::size_t i, std::string what) { return at_node(s, i, std::move(what)); });
}

namespace {

// An operation after which a neighbour of the vertex has its valence and the other irregular vertices are one adjacent
// 3-5 pair.
struct VertexStep {
  VertexId to;  // the neighbour
  Performed done;
};

// All steps of a single vertex, of a v3 or a v5.
std::vector<VertexStep> vertex_steps(const QuadMesh& m, int valence) {
  const VertexId v = mesh::irregular_vertices(m)[0];
  std::vector<VertexStep> steps;
  for (const BasicOperation& op : mesh::operations_inside(m)) {
    const Performed r = performed(m, op);
    if (r.valences != std::multiset<int>{3, 5, valence}) continue;
    for (const VertexId n : m.neighbours(v)) {
      if (!r.mesh.is_live(n) || r.mesh.valence(n) != valence) continue;
      std::vector<VertexId> rest;
      for (const VertexId w : r.irregular) {
        if (w != n) rest.push_back(w);
      }
      if (rest.size() == 2 && r.mesh.valence(rest[0]) + r.mesh.valence(rest[1]) == 8 &&
          r.mesh.adjacent(rest[0], rest[1]))
        steps.push_back({n, r});
    }
  }
  return steps;
}

// The neighbourhood of a v3 or v5; null if the study is about another valence.
const Region* neighbourhood_of_3_or_5(const VertexStudy& s) {
  return s.valence() == 3 || s.valence() == 5 ? neighbourhood(s) : nullptr;
}

}  // namespace

Judgement judge_vertex_steps(const VertexStudy& s) {
  const Region* region = neighbourhood_of_3_or_5(s);
  if (region == nullptr) return not_applicable();
  const QuadMesh& m = region->mesh;
  struct Ways {
    int collapses = 0, splits = 0, flips = 0;
    bool operator==(const Ways&) const = default;
  };
  const auto text = [](const Ways& w) {
    return std::to_string(w.collapses) + " collapses, " + std::to_string(w.splits) + " splits and " +
           std::to_string(w.flips) + " flips";
  };
  std::map<VertexId, Ways> ways;
  for (const VertexStep& step : vertex_steps(m, s.valence())) {
    Ways& w = ways[step.to];
    const Kind kind = step.done.operation.kind;
    ++(kind == Kind::collapse ? w.collapses : kind == Kind::split ? w.splits : w.flips);
  }
  const Ways expected = s.valence() == 3 ? Ways{2, 1, 2} : Ways{0, 2, 2};
  return for_each_of(
      m.neighbours(mesh::irregular_vertices(m)[0]), "neighbour", "reached by " + text(expected),
      [&](VertexId n) {
        return ways[n] == expected ? "" : "towards one neighbour " + text(ways[n]) + ", not " + text(expected);
      },
      placed_in(*region));
}

// From each mesh that a vertex's step makes: all operations that leave one irregular vertex. They lead back to the mesh
// before the step, and one of them is of the inverse kind.
Judgement judge_pair_removal(const VertexStudy& s) {
  const Region* region = neighbourhood_of_3_or_5(s);
  if (region == nullptr) return not_applicable();
  const std::string before = mesh::signature(*region);
  return for_each_of(
      vertex_steps(region->mesh, s.valence()), "pair", "removed by the inverse kind, with the vertex back where it was",
      [&](const VertexStep& step) -> std::string {
        const Kind kind = step.done.operation.kind;
        const Kind inverse = kind == Kind::collapse   ? Kind::split
                             : kind == Kind::split    ? Kind::collapse
                             : kind == Kind::flip_ccw ? Kind::flip_cw
                                                      : Kind::flip_ccw;
        bool removed = false;
        for (const BasicOperation& op : mesh::operations_inside(step.done.mesh)) {
          const Performed r = performed(step.done.mesh, op);
          if (r.irregular.size() != 1) continue;
          if (mesh::signature(r.mesh, region->root) != before)
            return mesh::to_string(op) + " removes the pair and makes another mesh than the one before";
          removed = removed || op.kind == inverse;
        }
        return removed ? "" : "no operation of the inverse kind removes the adjacent pair";
      },
      placed_in(*region));
}

Judgement judge_quadruple(const VertexStudy& s) {
  const Region* region = neighbourhood(s);
  if (region == nullptr || s.valence() != 4) return not_applicable();
  std::vector<BasicOperation> flips = mesh::operations_inside(region->mesh);
  std::erase_if(flips, [](const BasicOperation& op) { return !is_flip(op.kind); });
  // The smallest grids have no flip that spares the boundary.
  return for_each_of(
      flips, "flip", "makes 3-3-5-5, and the other flip removes them",
      [region](const BasicOperation& op) -> std::string {
        QuadMesh after = region->mesh;
        const mesh::Applied done = mesh::apply(after, op);
        if (mesh::sorted_irregular_valences(after) != std::multiset<int>{3, 3, 5, 5})
          return mesh::to_string(op) + " does not make 3-3-5-5";
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
    const auto operations = mesh::operations_inside(region->mesh);
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

namespace {

// The valences of a list that are not 4.
std::multiset<int> irregular_of(std::initializer_list<int> valences) {
  std::multiset<int> result;
  for (const int l : valences) {
    if (l != 4) result.insert(l);
  }
  return result;
}

}  // namespace

// A collapse of each face raises the vertex; a split along any two of its edges with others on both sides lowers it.
// The check has all operations at the vertex, and compares their number and all irregular valences.
Judgement judge_any_valence(const VertexStudy& s) {
  const Region* region = neighbourhood(s);
  if (region == nullptr) return not_applicable();
  const QuadMesh& m = region->mesh;
  const int l = s.valence();
  const VertexId v = l == 4 ? deep_vertex(*region) : mesh::irregular_vertices(m)[0];
  if (!v.valid()) return not_applicable();
  std::vector<BasicOperation> raise, lower;
  for (const BasicOperation& op : mesh::operations_inside(m)) {
    if (op.kind == Kind::collapse && (m.origin(op.h) == v || m.target(QuadMesh::next(op.h)) == v)) raise.push_back(op);
    if (op.kind == Kind::split && m.origin(op.h) == v && m.cw(m.twin(op.last)) != op.h &&
        m.ccw(m.twin(op.last)) != op.h)
      lower.push_back(op);
  }
  Judgement j = for_each_of(
      raise, "collapse", "raised to l + 2 by each of l collapses, lowered by each of l (l - 3) / 2 splits",
      [&](const BasicOperation& op) {
        return performed(m, op).valences == irregular_of({l + 2, 3, 3})
                   ? ""
                   : mesh::to_string(op) + " does not raise the valence by 2 beside two v3s";
      },
      placed_in(*region));
  const Judgement splits = for_each_of(
      lower, "split", "",
      [&](const BasicOperation& op) {
        int between = 0;
        for (HalfEdgeId h = m.ccw(op.h); h != m.twin(op.last); h = m.ccw(h)) ++between;
        return performed(m, op).valences == irregular_of({between + 2, l - between, 5, 5})
                   ? ""
                   : mesh::to_string(op) + " does not part the vertex beside two v5s";
      },
      placed_in(*region));
  j.checks += splits.checks;
  j.found += ", " + splits.found;
  if (!j.violation) j.violation = splits.violation;
  const auto expected_splits = static_cast<std::size_t>(std::max(l * (l - 3) / 2, 0));
  Requirements required(j);
  required.that(
      static_cast<int>(raise.size()) == l,
      {std::to_string(raise.size()) + " collapses raise a vertex of valence " + std::to_string(l), "", "", *region});
  required.that(
      lower.size() == expected_splits,
      {std::to_string(lower.size()) + " splits lower a vertex of valence " + std::to_string(l), "", "", *region});
  return j;
}

}  // namespace requad::verify
