// The claim about three irregular vertices (N3).
//
// The fillings of a region with three vertices are the nodes of a graph, and the edits of enumerate/edits.hpp its edges.
// An edit can also make a filling with fewer irregular vertices. The question is from which nodes a path leads to one.
#include <algorithm>
#include <cstdint>
#include <numeric>

#include "mesh/irregular/complementary_operations.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "verify/claims/judging.hpp"

namespace requad::verify {

using mesh::QuadMesh;
using mesh::Refusal;
using mesh::Region;
using mesh::VertexId;

namespace {

// How far basic operations may leave 3 + 4: the three vertices and two adjacent 3-5 pairs.
constexpr int kMostIrregularity = 7;

bool is_in(const Signatures& list, const std::string& signature) {
  return std::binary_search(list.begin(), list.end(), signature);
}

// What cancel_pair() and merge_pair() make of every two of the three vertices, at once.
struct Direct {
  std::int64_t pairs = 0;  // tried, in all fillings
  int cancelled = 0;       // fillings in which a pair was cancelled
  int merged = 0;          // fillings in which a pair was merged
  int transports = 0;
};

// Cancels or merges every two of the three vertices. Returns what is wrong, or "". Sets `fewer` if one of that is done.
std::string edit_directly(const TripleStudy& s, const Region& region, Direct& direct, bool& fewer) {
  const std::vector<VertexId> irregular = mesh::irregular_vertices(region.mesh);
  bool cancels = false, merges = false;
  for (const VertexId a : irregular) {
    for (const VertexId b : irregular) {
      const int la = region.mesh.valence(a), lb = region.mesh.valence(b);
      if (a == b || la > lb || (la == lb && b < a)) continue;
      ++direct.pairs;
      QuadMesh m = region.mesh;
      mesh::Editor editor(m);
      mesh::PairTransport transport(editor);
      bool done = false;
      if (la == lb) {
        done = mesh::merge_pair(editor, a, b).refusal == Refusal::none;
        merges = merges || done;
      } else {
        std::vector<VertexId> third = irregular;
        std::erase_if(third, [&](VertexId v) { return v == a || v == b; });
        const mesh::Cancellation c = mesh::cancel_pair(editor, transport, a, b, third);
        done = c.refusal == Refusal::none;
        direct.transports += c.transports;
        cancels = cancels || done;
      }
      if (done) {
        if (!mesh::validate(m).empty()) return "the operation leaves an invalid mesh";
        if (!is_in(s.fewer_with(la == lb ? s.after_merging() : s.after_cancelling().value()),
                   mesh::signature(m, m.out(region.mesh.origin(region.root)))))
          return "the operation makes a filling that the search does not know";
      }
      editor.roll_back();
      if (!(m == region.mesh)) return "the operation was not rolled back";
    }
  }
  direct.cancelled += cancels ? 1 : 0;
  direct.merged += merges ? 1 : 0;
  fewer = cancels || merges;
  const bool can_cancel = s.after_cancelling() && !s.fewer_with(*s.after_cancelling()).empty();
  if (cancels == can_cancel) return "";
  return cancels ? "a pair was cancelled, but the search finds no filling with one vertex"
                 : "the search finds a filling with one vertex, but no pair was cancelled";
}

struct Graph {
  std::vector<std::vector<std::size_t>> from;  // for each filling, those that an edit turns into it
  std::vector<bool> fewer;                     // whether a path of edits leads to fewer irregular vertices
  std::set<std::string> reached;               // signatures of the fillings with fewer
  int components = 0;                          // with the directions of the edges left out
};

// Builds the graph. Where an edit makes a mesh that the search does not know, `problem` gets the number of the filling.
Graph graph_of(const TripleStudy& s, std::vector<bool> fewer, std::optional<std::size_t>& problem) {
  const std::size_t n = s.fillings.size();
  Graph graph{std::vector<std::vector<std::size_t>>(n), std::move(fewer), {}, 0};
  std::vector<std::size_t> root(n);
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&root](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (const enumerate::EditResult& result : s.edits[i]) {
      if (result.valences == s.region.valences) {
        const auto to = std::lower_bound(s.signatures.begin(), s.signatures.end(), result.signature);
        if (to == s.signatures.end() || *to != result.signature) {
          problem = i;
          continue;
        }
        const auto j = static_cast<std::size_t>(to - s.signatures.begin());
        graph.from[j].push_back(i);
        root[find(i)] = find(j);
      } else if (result.valences.size() < 3) {
        if (!is_in(s.fewer_with(result.valences), result.signature)) problem = i;
        graph.fewer[i] = true;
        graph.reached.insert(result.signature);
      }
    }
  }
  std::vector<std::size_t> stack;
  for (std::size_t i = 0; i < n; ++i) {
    graph.components += find(i) == i ? 1 : 0;
    if (graph.fewer[i]) stack.push_back(i);
  }
  while (!stack.empty()) {
    const std::size_t i = stack.back();
    stack.pop_back();
    for (const std::size_t j : graph.from[i]) {
      if (graph.fewer[j]) continue;
      graph.fewer[j] = true;
      stack.push_back(j);
    }
  }
  return graph;
}

// Of the fillings with fewer irregular vertices that no edit reaches: whether a basic operation parts one of them into
// the three. If so, its inverse is an edit that should have reached it.
bool parts(const TripleStudy& s, const std::string& signature) {
  // The root of the region that is built again is the root of the boundary.
  for (const enumerate::EditResult& result : enumerate::operation_results(mesh::from_signature(signature), 3)) {
    if (result.valences == s.region.valences) return true;
  }
  return false;
}

}  // namespace

// Every filling with three irregular vertices. First every two of the three are cancelled or merged at once. Then the
// graph of all edits shows from which fillings a filling with fewer irregular vertices is reached.
Judgement judge_three_vertices(const TripleStudy& s) {
  if (s.fillings.empty()) return not_applicable();
  Judgement j;
  Requirements required(j);
  const auto at = [&s](std::size_t i, std::string what) { return Violation{std::move(what), "", "", s.fillings[i]}; };
  const std::size_t n = s.fillings.size();
  Direct direct;
  std::vector<bool> at_once(n);
  for (std::size_t i = 0; i < n; ++i) {
    bool fewer = false;
    const std::string problem = edit_directly(s, s.fillings[i], direct, fewer);
    at_once[i] = fewer;
    required.that(problem.empty(), at(i, problem));
  }
  std::optional<std::size_t> unknown;
  const Graph graph = graph_of(s, at_once, unknown);
  required.that(!unknown, at(unknown.value_or(0), "an edit makes a filling that the search does not know"));

  const bool two_v3 = s.region.valences[1] == 3;
  required.that(!two_v3 || graph.components == 1, at(0, "edits do not join the fillings of the region"));
  // With a v3 among them, three vertices always become fewer. Three v5s need room: basic operations decide whether there
  // is any.
  Signatures stuck;
  for (std::size_t i = 0; i < n; ++i) {
    if (graph.fewer[i]) {
      ++j.checks;
      continue;
    }
    stuck.push_back(s.signatures[i]);
    required.that(s.region.valences.front() == 5, at(i, "no path of edits leads to fewer irregular vertices"));
    const bool by_operations = enumerate::fewer_by_operations(s.fillings[i], kMostIrregularity).has_value();
    required.that(by_operations == !s.fewer.empty(),
                  at(i, by_operations ? "basic operations reach fewer irregular vertices, the search finds no filling "
                                        "with fewer"
                                      : "the search finds a filling with fewer irregular vertices, and no basic "
                                        "operations lead to one"));
  }
  std::size_t fewer = 0, reached = 0;
  for (const auto& [valences, signatures] : s.fewer) {
    fewer += signatures.size();
    for (const std::string& signature : signatures) {
      const bool is_reached = graph.reached.count(signature) > 0;
      reached += is_reached ? 1 : 0;
      ++j.checks;
      if (is_reached || j.violation || !parts(s, signature)) continue;
      j.violation =
          Violation{"no edit makes a filling with fewer irregular vertices that an operation parts into three", "", "",
                    mesh::from_signature(signature)};
    }
  }
  j.checks += direct.pairs - static_cast<std::int64_t>(n);
  j.predicted = s.region.valences.front() == 3 ? "every filling comes to fewer irregular vertices"
                : s.fewer.empty()              ? "no filling has fewer irregular vertices"
                                               : "operations lead to fewer irregular vertices";
  j.found = counted(static_cast<std::int64_t>(n), "filling") + ": cancelled at once in " +
            std::to_string(direct.cancelled) + ", merged at once in " + std::to_string(direct.merged) +
            ", by paths of edits in all but " + std::to_string(stuck.size());
  const std::optional<std::vector<int>> one = s.after_cancelling();
  j.row = {{"sides", side_list(s.region.sides)},
           {"irregular", s.region.valences},
           {"fillings", n},
           {"with_one_vertex", one ? s.fewer_with(*one).size() : 0},
           {"cancelled", direct.cancelled},
           {"couriers", direct.transports},
           {"with_two_vertices", s.fewer_with(s.after_merging()).size()},
           {"merged", direct.merged},
           {"with_fewer_vertices", fewer},
           {"with_fewer_reached", reached},
           {"components", graph.components},
           {"not_edited", stuck}};
  return j;
}

}  // namespace requad::verify
