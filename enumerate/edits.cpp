#include "enumerate/edits.hpp"

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <set>
#include <utility>

#include "mesh/irregular/pair_moves.hpp"
#include "mesh/irregular/transport.hpp"
#include "mesh/topology/signature.hpp"

namespace requad::enumerate {

using mesh::BasicOperation;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Refusal;
using mesh::Region;
using mesh::VertexId;

namespace {

// Calls visit(operation) for every operation inside that changes the valence of an irregular vertex. (Any other one
// leaves all irregular vertices and makes more.)
template <class Visit>
void for_each_operation(const QuadMesh& m, Visit&& visit) {
  for (const BasicOperation& op : mesh::operations_inside(m)) {
    const auto changed = mesh::changed_vertices(m, op);
    if (std::any_of(changed.begin(), changed.end(), [&m](VertexId v) { return v.valid() && m.valence(v) != 4; }))
      visit(op);
  }
}

// How far the valences are from 4, summed.
int irregularity(const std::multiset<int>& valences) {
  int sum = 0;
  for (const int l : valences) sum += std::abs(4 - l);
  return sum;
}

EditResult result_of(const std::multiset<int>& valences, std::string signature) {
  return {{valences.begin(), valences.end()}, std::move(signature)};
}

// Every set of these vertices but the empty one.
std::vector<std::vector<VertexId>> choices(const std::vector<VertexId>& vertices) {
  std::vector<std::vector<VertexId>> sets{{}};
  for (const VertexId v : vertices) {
    for (std::size_t i = 0, n = sets.size(); i < n; ++i) {
      sets.push_back(sets[i]);
      sets.back().push_back(v);
    }
  }
  sets.erase(sets.begin());
  return sets;
}

// Collects what edits make of one region.
class Results {
 public:
  Results(const Region& region, std::size_t most) : corner_(region.mesh.origin(region.root)), most_(most) {}

  void add(const QuadMesh& m) {
    const std::multiset<int> valences = mesh::sorted_irregular_valences(m);
    if (valences.size() <= most_) found_.insert(result_of(valences, mesh::signature(m, m.out(corner_))));
  }
  std::vector<EditResult> sorted() const { return {found_.begin(), found_.end()}; }

 private:
  VertexId corner_;
  std::size_t most_;
  std::set<EditResult> found_;
};

void add_operations(const Region& region, Results& results) {
  for_each_operation(region.mesh, [&](const BasicOperation& op) {
    QuadMesh m = region.mesh;
    mesh::apply(m, op);
    results.add(m);
  });
}

}  // namespace

std::vector<EditResult> operation_results(const Region& region, std::size_t most) {
  Results results(region, most);
  add_operations(region, results);
  return results.sorted();
}

std::vector<EditResult> edit_results(const Region& region) {
  const std::vector<VertexId> irregular = mesh::irregular_vertices(region.mesh);
  Results results(region, irregular.size());
  add_operations(region, results);
  QuadMesh m = region.mesh;
  mesh::Editor editor(m);
  mesh::PairTransport transport(editor);
  for (const VertexId from : irregular) {
    std::vector<VertexId> others = irregular;
    std::erase(others, from);
    for (const VertexId to : others) {
      if (to < from) continue;
      for (const mesh::PairMove& move : mesh::pair_moves(m, from, to)) {
        if (mesh::move_pair(editor, move).refusal != Refusal::none) continue;
        results.add(m);
        editor.roll_back();
      }
    }
    for (const HalfEdgeId start : mesh::departures(m, from)) {
      for (const std::vector<VertexId>& targets : choices(others)) {
        for (const bool may_cross : {false, true}) {
          if (transport.carry({start}, targets, may_cross).refusal != Refusal::none) continue;
          results.add(m);
          editor.roll_back();
        }
      }
    }
  }
  return results.sorted();
}

std::optional<EditResult> fewer_by_operations(const Region& region, int most_irregularity) {
  const VertexId corner = region.mesh.origin(region.root);
  const std::size_t had = mesh::irregular_vertices(region.mesh).size();
  std::set<std::string> seen{mesh::signature(region)};
  std::deque<QuadMesh> queue{region.mesh};
  std::optional<EditResult> fewer;
  while (!queue.empty() && !fewer) {
    const QuadMesh m = std::move(queue.front());
    queue.pop_front();
    for_each_operation(m, [&](const BasicOperation& op) {
      if (fewer) return;
      QuadMesh next = m;
      mesh::apply(next, op);
      const std::multiset<int> valences = mesh::sorted_irregular_valences(next);
      if (irregularity(valences) > most_irregularity) return;
      std::string signature = mesh::signature(next, next.out(corner));
      if (!seen.insert(signature).second) return;
      if (valences.size() < had) {
        fewer = result_of(valences, std::move(signature));
      } else {
        queue.push_back(std::move(next));
      }
    });
  }
  return fewer;
}

namespace {

// Whether the mesh has some v3 or v2 beside a vertex of valence 5 or more.
bool has_adjacent_pair(const QuadMesh& m) {
  const std::vector<VertexId> irregular = mesh::irregular_vertices(m);
  return std::any_of(irregular.begin(), irregular.end(), [&](VertexId u) {
    return m.valence(u) < 4 && std::any_of(irregular.begin(), irregular.end(),
                                           [&](VertexId v) { return m.valence(v) > 4 && m.adjacent(u, v); });
  });
}

// The mesh up to isomorphism rel boundary, with the half-edges that are marked: two meshes with one text are the same.
template <class IsMarked>
std::string text_with_marks(const QuadMesh& m, HalfEdgeId root, IsMarked&& is_marked) {
  std::string text = mesh::signature(m, root);
  std::vector<bool> met(static_cast<std::size_t>(m.face_capacity()), false);
  std::deque<HalfEdgeId> queue{root};  // one half-edge of each face, by which the face is entered
  met[QuadMesh::face(root).slot()] = true;
  for (int number = 0; !queue.empty();) {
    HalfEdgeId h = queue.front();
    queue.pop_front();
    for (int k = 0; k < 4; ++k, ++number, h = QuadMesh::next(h)) {
      if (is_marked(h)) text += ' ' + std::to_string(number);
      const HalfEdgeId beyond = m.twin(h);
      if (!beyond.valid() || met[QuadMesh::face(beyond).slot()]) continue;
      met[QuadMesh::face(beyond).slot()] = true;
      queue.push_back(beyond);
    }
  }
  return text;
}

// Where in a transport an operation may be made.
enum class Use { never, on_the_way, at_the_end, anywhere };

// Makes operations in every order, as long as the region has its irregular vertices and one adjacent pair besides, until
// the pair is gone. Returns the signatures of the meshes at the end. use(mesh, operation, is_first) says where an
// operation may be made; is_marked(mesh, half-edge) tells meshes on the way apart that have one signature.
template <class UseOf, class IsMarked>
std::vector<std::string> exhaust_transports(const Region& region, UseOf&& use, IsMarked&& is_marked) {
  const VertexId corner = region.mesh.origin(region.root);
  const std::multiset<int> before = mesh::sorted_irregular_valences(region.mesh);
  const int least = irregularity(before);
  std::set<std::string> seen;
  std::set<std::string> ends;
  std::deque<QuadMesh> queue{region.mesh};
  for (bool is_first = true; !queue.empty(); is_first = false) {
    const QuadMesh m = std::move(queue.front());
    queue.pop_front();
    for_each_operation(m, [&](const BasicOperation& op) {
      const Use allowed = use(m, op, is_first);
      if (allowed == Use::never) return;
      QuadMesh next = m;
      mesh::apply(next, op);
      const std::multiset<int> valences = mesh::sorted_irregular_valences(next);
      const bool arrived = irregularity(valences) == least && valences.size() == before.size();
      if (allowed == (arrived ? Use::on_the_way : Use::at_the_end)) return;
      const HalfEdgeId root = next.out(corner);
      if (arrived) {
        ends.insert(mesh::signature(next, root));
        return;
      }
      if (irregularity(valences) > least + 2 || !has_adjacent_pair(next)) return;
      if (seen.insert(text_with_marks(next, root, [&](HalfEdgeId h) { return is_marked(next, h); })).second)
        queue.push_back(std::move(next));
    });
  }
  return {ends.begin(), ends.end()};
}

bool changes(const QuadMesh& m, const BasicOperation& op, VertexId v) {
  const auto changed = mesh::changed_vertices(m, op);
  return std::find(changed.begin(), changed.end(), v) != changed.end();
}

}  // namespace

std::vector<std::string> transports_round(const Region& region, const mesh::FeatureSet& features) {
  return exhaust_transports(
      region,
      [&features](const QuadMesh& m, const BasicOperation& op, bool) {
        if (features.why_not(m, op) != Refusal::none) return Use::never;
        const auto changed = mesh::changed_vertices(m, op);
        const bool touches = std::any_of(changed.begin(), changed.end(),
                                         [&features](VertexId v) { return v.valid() && features.is_vertex(v); });
        return touches ? Use::never : Use::anywhere;
      },
      [&features](const QuadMesh& m, HalfEdgeId h) { return features.is_edge(m.origin(h), m.target(h)); });
}

std::vector<std::string> pipelines(const Region& region, VertexId first, VertexId last, Passing passing) {
  const bool keeps_last = passing == Passing::not_allowed;
  return exhaust_transports(
      region,
      [=](const QuadMesh& m, const BasicOperation& op, bool is_first) {
        if (is_first) return changes(m, op, first) && !changes(m, op, last) ? Use::on_the_way : Use::never;
        if (!keeps_last) return Use::anywhere;
        return changes(m, op, last) ? Use::at_the_end : Use::on_the_way;
      },
      [=](const QuadMesh& m, HalfEdgeId h) { return keeps_last && m.origin(h) == last; });
}

}  // namespace requad::enumerate
