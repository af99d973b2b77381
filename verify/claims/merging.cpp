// Claims about what a pair can become: a 3-5 pair cannot be cancelled (N1); an equal pair merges or is aligned (N2); two
// pairs can cancel at once (N5).
#include <algorithm>
#include <set>

#include "enumerate/search/search.hpp"
#include "mesh/irregular/complementary_operations.hpp"
#include "mesh/topology/distances.hpp"
#include "verify/claims/judging.hpp"
#include "verify/claims/sites.hpp"

namespace requad::verify {

using enumerate::FoundMove;
using enumerate::FoundNode;
using theory::Configuration;

// Cancelling would leave a filling of the same boundary without irregular vertices. The search finds no such filling,
// and the sides of the meshes that moves made are never those of a regular grid.
Judgement judge_no_cancelling(const PairStudy& s) {
  Judgement j = for_each_node(s, "sides that fit no regular grid", [](const FoundNode& node) -> std::string {
    if (node.reading.irregular.size() != 2) return "a move lost the pair";
    const std::vector<int> e = mesh::side_lengths(node.region);
    return e[0] == e[2] && e[1] == e[3] ? "opposite sides are equal: a regular grid fits" : "";
  });
  if (s.searched && !s.searched->empty()) {
    enumerate::SearchLimits limits;
    limits.threads = 1;
    const auto regular =
        enumerate::search(enumerate::search_problem({s.shape.sides().begin(), s.shape.sides().end()}, {}), limits, {});
    Requirements(j).that(regular.count == 0, at_region(s, "search finds a filling without irregular vertices"));
    j.found += ", and " + counted(regular.count, "filling") + " without irregular vertices by search";
    j.applies = true;
  }
  return j;
}

// Moves reach the merged vertex iff the region has room for one. In a regular region, and in every digon, this is the
// case iff the graph distance of the pair is even. In a regular region slides alone align the pair.
Judgement judge_merging(const PairStudy& s) {
  if (s.found.nodes.empty()) return not_applicable();
  Judgement j;
  Requirements required(j);
  const std::size_t n = s.found.nodes.size();
  std::vector<std::vector<int>> by_any(n), by_slides(n);
  for (const FoundMove& move : s.found.moves) {
    if (move.to < 0) continue;
    // Searches from the goal backwards, against the moves. So the check does not rely on the moves having inverses.
    by_any[static_cast<std::size_t>(move.to)].push_back(move.from);
    const bool slide = move.move.step == mesh::PairStep::slide_first || move.move.step == mesh::PairStep::slide_second;
    if (slide) by_slides[static_cast<std::size_t>(move.to)].push_back(move.from);
  }
  const auto reaching = [n](const std::vector<std::vector<int>>& backwards, std::vector<int> stack) {
    std::vector<bool> can(n, false);
    while (!stack.empty()) {
      const auto node = static_cast<std::size_t>(stack.back());
      stack.pop_back();
      if (can[node]) continue;
      can[node] = true;
      for (const int from : backwards[node]) stack.push_back(from);
    }
    return can;
  };
  std::vector<int> merged, aligned;
  for (std::size_t i = 0; i < n; ++i) {
    const Configuration& c = s.found.nodes[i].reading.configuration;
    if (c.merged()) merged.push_back(static_cast<int>(i));
    if (c.degenerate() && !c.merged()) aligned.push_back(static_cast<int>(i));
  }
  const std::vector<bool> can_merge = reaching(by_any, merged);
  const std::vector<bool> can_align = reaching(by_slides, aligned);
  const bool room = std::any_of(s.map.nodes.begin(), s.map.nodes.end(),
                                [](const theory::MapNode& node) { return node.configuration.merged(); });
  const bool by_distance = is_digon(s) || is_regular(s);  // the distance alone decides
  int pairs = 0, merge = 0, align = 0;
  std::set<int> parities;
  for (std::size_t i = 0; i < n; ++i) {
    const FoundNode& node = s.found.nodes[i];
    if (node.reading.configuration.merged()) continue;
    ++pairs;
    merge += can_merge[i] ? 1 : 0;
    align += can_align[i] ? 1 : 0;
    const int distance = mesh::graph_distance(node.region.mesh, node.reading.irregular[0], node.reading.irregular[1]);
    parities.insert(distance % 2);
    required.that(distance == node.reading.configuration.d1() + node.reading.configuration.d2(),
                  at_node(s, i, "the graph distance " + std::to_string(distance) + " is not d1 + d2"));
    required.that(
        can_merge[i] == room,
        at_node(s, i, can_merge[i] ? "merges where there is no room" : "does not merge though there is room"));
    if (by_distance) {
      required.that(can_merge[i] == (distance % 2 == 0),
                    at_node(s, i,
                            std::string(can_merge[i] ? "merges" : "does not merge") + " at distance " +
                                std::to_string(distance)));
    }
    if (is_regular(s)) required.that(can_align[i], at_node(s, i, "cannot be aligned by slides"));
  }
  const std::string vertex = "v" + std::to_string(s.shape.type().side_count());
  j.predicted = std::string(by_distance ? room ? "even distances, " : "odd distances, " : "") +
                (room ? "room to merge into a " : "no room to merge into a ") + vertex;
  j.found = std::string(parities.size() > 1       ? "distances of both parities, "
                        : parities == std::set{0} ? "even distances, "
                                                  : "odd distances, ") +
            std::to_string(merge) + " of " + counted(pairs, "configuration") + " merge, slides align " +
            std::to_string(align);
  return j;
}

namespace {

// Cancels a v3 and a v5 of a mesh with 3-3-5-5. Whether the last operation is the flip that removes all four.
bool ends_in_a_double_removal(const mesh::QuadMesh& before, mesh::VertexId three, mesh::VertexId five) {
  std::vector<mesh::VertexId> others = mesh::irregular_vertices(before);
  std::erase_if(others, [&](mesh::VertexId v) { return v == three || v == five; });
  mesh::QuadMesh m = before;
  mesh::Editor editor(m);
  mesh::PairTransport transport(editor);
  if (mesh::cancel_pair(editor, transport, three, five, others).refusal != mesh::Refusal::none) return false;
  if (!mesh::irregular_vertices(m).empty() || editor.edits().size() < 2) return false;
  const mesh::Edit& last = editor.edits().back();
  mesh::take_back(m, last.inverse);
  return is_flip(last.operation.kind) && mesh::sorted_irregular_valences(m) == std::multiset<int>{3, 3, 5, 5};
}

}  // namespace

// In a regular grid: a flip makes 3-3-5-5, one operation brings these apart, and each v3 is cancelled with each v5. In
// some of these cancellations the last operation removes both pairs.
Judgement judge_double_removal(const VertexStudy& s) {
  const mesh::Region* region = neighbourhood(s);
  if (region == nullptr || s.valence() != 4 || !deep_vertex(*region).valid()) return not_applicable();
  const mesh::HalfEdgeId edge = region->mesh.out(deep_vertex(*region));
  std::int64_t tried = 0, ended = 0;
  Judgement j;
  const mesh::QuadMesh four = performed(region->mesh, {mesh::BasicOperation::Kind::flip_ccw, edge, {}, 0}).mesh;
  for (const mesh::BasicOperation& op : mesh::operations_inside(four)) {
    const Performed apart = performed(four, op);
    if (apart.valences != std::multiset<int>{3, 3, 5, 5}) continue;
    for (const mesh::VertexId three : apart.irregular) {
      for (const mesh::VertexId five : apart.irregular) {
        if (apart.mesh.valence(three) != 3 || apart.mesh.valence(five) != 5) continue;
        ++tried;
        ended += ends_in_a_double_removal(apart.mesh, three, five) ? 1 : 0;
      }
    }
  }
  j.checks = tried;
  j.predicted = "a cancellation whose last operation removes 3-3-5-5";
  j.found = std::to_string(ended) + " of " + counted(tried, "cancellation");
  Requirements(j).that(ended > 0, {"no cancellation ends in a 3-3-5-5 removal", "", "", *region});
  return j;
}

}  // namespace requad::verify
