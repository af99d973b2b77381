#include "verify/claims.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "enumerate/generators.hpp"
#include "enumerate/realisation.hpp"
#include "mesh/separatrix.hpp"
#include "mesh/signature.hpp"
#include "mesh/validate.hpp"

namespace requad::verify {

namespace {

using enumerate::FoundMove;
using enumerate::FoundNode;
using mesh::Region;
using nlohmann::ordered_json;
using theory::Configuration;
using theory::PairType;

// --- helpers ---------------------------------------------------------------------------------------------------------

bool is_regular_family(Family f) { return f == Family::regular_digon || f == Family::regular_hexagon; }
bool is_digon(const Study& s) { return s.region.type == theory::kDigon; }
bool is_hexagon(const Study& s) { return s.region.type == theory::kHexagon; }
bool is_quad(const Study& s) { return s.region.type == theory::kQuad; }

Judgement not_applicable() {
  Judgement j;
  j.applies = false;
  return j;
}

Violation at_node(const Study& s, std::size_t node, std::string what) {
  const FoundNode& n = s.found.nodes[node];
  return {std::move(what), n.reading.problem.empty() ? theory::label(s.region.type, n.reading.configuration) : "", "", n.region};
}

Violation at_move(const Study& s, const FoundMove& move, std::string what) {
  Violation v = at_node(s, static_cast<std::size_t>(move.from), std::move(what));
  v.move = mesh::name(move.move.step);
  return v;
}

Violation at_region(std::string what) { return {std::move(what), "", "", std::nullopt}; }

// Judges every found configuration; `problem` gives "" or what is wrong.
template <class Problem>
Judgement for_each_node(const Study& s, Problem&& problem) {
  Judgement j;
  for (std::size_t i = 0; i < s.found.nodes.size() && !j.violation; ++i) {
    ++j.checks;
    if (std::string what = problem(s.found.nodes[i]); !what.empty()) j.violation = at_node(s, i, std::move(what));
  }
  return j;
}

// Judges every move that was made.
template <class Problem>
Judgement for_each_move(const Study& s, Problem&& problem) {
  Judgement j;
  for (const FoundMove& move : s.found.moves) {
    if (move.to < 0) continue;
    ++j.checks;
    if (std::string what = problem(move); !what.empty()) {
      j.violation = at_move(s, move, std::move(what));
      break;
    }
  }
  return j;
}

std::string text(const Configuration& c) {
  return "d1=" + std::to_string(c.d1()) + " d2=" + std::to_string(c.d2()) + " p=" + std::to_string(c.p);
}

// The predicted step that a found move made, by labels: nothing if it is none of the theorem's four.
std::optional<int> theorem_step(PairType type, const FoundMove& move) {
  for (int step = 0; step < theory::kStepCount; ++step) {
    if (move.before.merged()) {
      // The merged configuration has one label (0,0) for all p: the step out of it goes to (1,1,p).
      if (move.after.d1() == 1 && move.after.d2() == 1) return 0;
      continue;
    }
    const Configuration to = theory::stepped(type, move.before, step);
    const bool same = to.merged() ? move.after.merged() && theory::canonical(type, to) == theory::canonical(type, move.after)
                                  : to == move.after;
    if (same) return step;
  }
  return std::nullopt;
}

// Multisets of edges by predicted node, for the found and the predicted graph.
std::map<std::pair<int, int>, int> edges_of(const theory::ConfigurationGraph& graph, const std::vector<int>& names) {
  std::map<std::pair<int, int>, int> result;
  for (const auto e : boost::make_iterator_range(boost::edges(graph))) {
    const int a = names[boost::source(e, graph)];
    const int b = names[boost::target(e, graph)];
    ++result[{std::min(a, b), std::max(a, b)}];
  }
  return result;
}

// The map restricted to the nodes that hold the pair, as a graph; names are indices into map.nodes.
theory::ConfigurationGraph predicted_graph(const Study& s, theory::Apex apex, std::vector<int>& names) {
  const theory::ConfigurationGraph all = theory::configuration_graph(s.map);
  std::vector<std::size_t> keep(num_vertices(all), 0);
  names.clear();
  for (std::size_t v = 0; v < num_vertices(all); ++v) {
    if (apex == theory::Apex::without && all[v].configuration.merged()) continue;
    keep[v] = names.size() + 1;
    names.push_back(static_cast<int>(v));
  }
  theory::ConfigurationGraph graph(names.size());
  for (const auto e : boost::make_iterator_range(boost::edges(all))) {
    const std::size_t a = keep[source(e, all)];
    const std::size_t b = keep[target(e, all)];
    if (a > 0 && b > 0) add_edge(a - 1, b - 1, graph);
  }
  return graph;
}

struct GraphComparison {
  bool isomorphic = false;  // with labels
  std::size_t edges = 0;    // found
  std::string difference;
};

GraphComparison compare_graphs(const Study& s, theory::Apex apex) {
  GraphComparison result;
  std::vector<int> predicted_names, node_of, found_names;
  const auto predicted = predicted_graph(s, apex, predicted_names);
  // The merged vertex of a digon parts one way, though each of its two faces would do; moves into it are what counts.
  theory::ConfigurationGraph found;
  try {
    found = enumerate::found_graph(s.found, apex, &node_of);
  } catch (const std::logic_error& error) {
    result.difference = error.what();
    return result;
  }
  for (const int node : node_of) found_names.push_back(s.predicted_of[static_cast<std::size_t>(node)]);
  result.edges = num_edges(found);
  std::vector<int> sorted = found_names;
  std::sort(sorted.begin(), sorted.end());
  if (sorted != predicted_names) {
    result.difference = std::to_string(sorted.size()) + " found configurations are not the " +
                        std::to_string(predicted_names.size()) + " predicted ones";
    return result;
  }
  const auto found_edges = edges_of(found, found_names);
  const auto predicted_edges = edges_of(predicted, predicted_names);
  result.isomorphic = found_edges == predicted_edges;
  if (!result.isomorphic) {
    const auto [f, p] = std::mismatch(found_edges.begin(), found_edges.end(), predicted_edges.begin(), predicted_edges.end());
    const auto& edge = f != found_edges.end() ? *f : *p;
    result.difference = "edges between " + theory::label(s.region.type, s.map.nodes[static_cast<std::size_t>(edge.first.first)].configuration) +
                        " and " + theory::label(s.region.type, s.map.nodes[static_cast<std::size_t>(edge.first.second)].configuration) +
                        " differ";
  }
  return result;
}

// --- T2, T3, T4 ------------------------------------------------------------------------------------------------------

theory::Integer tau(const Study& s, theory::Integer length) {
  return is_digon(s) ? theory::tau_digon(length) : theory::tau_hexagon(length);
}

// Counts against the closed form, configurations against the parameter set, the graph against the predicted one, every
// move against the theorem's list, every refusal against a missing neighbour.
Judgement judge_theorem(const Study& s) {
  Judgement j;
  const auto fail = [&j](Violation v) {
    if (!j.violation) j.violation = std::move(v);
  };
  const int predicted = s.pairs_predicted();
  const int found = s.pairs_found();
  const GraphComparison pair_graph = compare_graphs(s, theory::Apex::without);
  const GraphComparison full_graph = compare_graphs(s, theory::Apex::with);

  j.row = {{"sides", std::vector<theory::Integer>(s.region.sides.begin(), s.region.sides.end())},
           {"predicted", s.exact_count}, {"parameters", predicted}, {"moves", found}, {"edges", pair_graph.edges},
           {"isomorphic", pair_graph.isomorphic && full_graph.isomorphic}};
  if (s.region.family == Family::regular_digon || s.region.family == Family::regular_hexagon) {
    j.row["tau"] = tau(s, s.region.sides(0));
    if (tau(s, s.region.sides(0)) != found) fail(at_region("tau is " + j.row["tau"].dump() + ", moves find " + std::to_string(found)));
  } else if (!is_quad(s)) {
    const theory::Integer bound = tau(s, theory::smallest_regular(s.region.type, s.region.sides));
    j.row["bound"] = bound;
    if (found > bound) fail(at_region(std::to_string(found) + " configurations exceed the bound " + std::to_string(bound)));
  } else {
    const theory::QuadCount quad = theory::quad_count(s.region.sides);
    j.row["M"] = quad.m;
    j.row["N"] = quad.n;
  }
  if (s.exact_count != predicted) {
    fail(at_region("the closed form gives " + std::to_string(s.exact_count) + ", the parameter set has " + std::to_string(predicted)));
  }
  if (predicted != found) {
    fail(at_region("the parameter set has " + std::to_string(predicted) + " configurations, moves find " + std::to_string(found)));
  }
  for (std::size_t i = 0; i < s.found.nodes.size(); ++i) {
    if (s.predicted_of[i] < 0) {
      const std::string& problem = s.found.nodes[i].reading.problem;
      fail(at_node(s, i, problem.empty() ? "this configuration is not in the parameter set" : problem));
    }
  }
  if (!pair_graph.isomorphic) fail(at_region("the graph differs from the predicted one: " + pair_graph.difference));
  if (!full_graph.isomorphic) fail(at_region("the graph with apex differs from the predicted one: " + full_graph.difference));

  for (const FoundMove& move : s.found.moves) {
    if (j.violation) break;
    ++j.checks;
    if (move.to >= 0) {
      if (!theorem_step(s.region.type, move)) {
        fail(at_move(s, move, "the step from " + text(move.before) + " to " + text(move.after) + " is none of the theorem's four"));
      } else if (!move.restored) {
        fail(at_move(s, move, "undoing the move's operations does not restore the mesh"));
      } else if (!move.inverse_returns) {
        fail(at_move(s, move, "the reported inverse move does not lead back"));
      }
    } else if (!move.refused_unchanged) {
      fail(at_move(s, move, "the refused move changed the mesh"));
    }
  }
  // Per node: as many moves made as the map has, so every step that theory allows in this region was realised here and
  // every other one refused.
  std::vector<int> made(s.found.nodes.size(), 0);
  for (const FoundMove& move : s.found.moves) made[static_cast<std::size_t>(move.from)] += move.to >= 0 ? 1 : 0;
  for (std::size_t i = 0; i < made.size() && !j.violation; ++i) {
    const auto& moves = s.map.nodes[static_cast<std::size_t>(s.predicted_of[i])].moves;
    const auto expected = std::count_if(moves.begin(), moves.end(), [](const theory::Dart& d) { return d.target >= 0; });
    if (made[i] != expected) {
      fail(at_node(s, i, std::to_string(made[i]) + " moves are possible here, theory says " + std::to_string(expected)));
    }
  }
  return j;
}

// --- the lemmas ------------------------------------------------------------------------------------------------------

std::string check_gauss_bonnet(const FoundNode& node) {
  const auto& m = node.region.mesh;
  const int left = mesh::total_turn(m) + mesh::total_index(m);
  const int right = 4 * mesh::euler_characteristic(m);
  return left == right ? "" : "turns and indices sum to " + std::to_string(left) + ", not " + std::to_string(right);
}

// The faces that touch R_alpha (whose own faces are given), as a region of their own; the root at any corner.
Region ring_of(const Region& region, const mesh::PairFrame& frame, const std::vector<mesh::FaceId>& r_alpha) {
  const auto& m = region.mesh;
  std::set<mesh::VertexId> core{frame.v1, frame.v2};
  for (const mesh::FaceId f : r_alpha) {
    for (const mesh::VertexId v : m.corners(f)) core.insert(v);
  }
  if (frame.degenerate()) {
    mesh::HalfEdgeId h = frame.a == 0 ? frame.second_leg : frame.first_leg;
    for (int i = 0; i < frame.a + frame.b; ++i, h = m.straight(h)) {
      core.insert(m.target(h));
      if (m.target(h) == frame.v2) break;
    }
  }
  std::set<mesh::FaceId> faces;
  for (const mesh::VertexId v : core) {
    m.for_each_out(v, [&](mesh::HalfEdgeId h) { faces.insert(mesh::QuadMesh::face(h)); });
  }
  std::map<mesh::VertexId, int> number;
  std::vector<std::array<int, 4>> corners;
  for (const mesh::FaceId f : faces) {
    std::array<int, 4> c{};
    for (std::size_t k = 0; k < 4; ++k) c[k] = number.emplace(m.corners(f)[k], static_cast<int>(number.size())).first->second;
    corners.push_back(c);
  }
  Region ring{mesh::QuadMesh::from_faces(static_cast<int>(number.size()), corners), {}};
  for (const mesh::VertexId v : ring.mesh.vertices()) {
    if (ring.mesh.is_boundary(v) && mesh::turn(ring.mesh, v) == 1) ring.root = ring.mesh.out(v);
  }
  return ring;
}

// Whether two cyclic sequences agree up to rotation.
template <class A, class B>
bool equal_up_to_rotation(const A& a, const B& b) {
  const std::size_t n = a.size();
  if (b.size() != n) return false;
  for (std::size_t shift = 0; shift < n; ++shift) {
    bool same = true;
    for (std::size_t i = 0; i < n && same; ++i) same = a[i] == b[(i + shift) % n];
    if (same) return true;
  }
  return false;
}

std::string check_lemma_8(PairType type, const FoundNode& node) {
  const Configuration& c = node.reading.configuration;
  if (c.merged()) return "";
  const std::size_t expected = c.degenerate() ? 2 : 1;
  if (node.reading.frames.size() != expected) {
    return std::to_string(node.reading.frames.size()) + " rectangles lie between the pair, not " + std::to_string(expected);
  }
  const mesh::PairFrame& frame = node.reading.frames[0].frame;
  const auto faces = mesh::region_between(node.region.mesh, frame);
  if (!faces || faces->size() != static_cast<std::size_t>(frame.a) * static_cast<std::size_t>(frame.b)) {
    return "R_alpha is not a regular grid of its size";
  }
  const Region ring = ring_of(node.region, frame, *faces);
  if (const std::string problem = mesh::region_problem(ring); !problem.empty()) return "the 1-ring of R_alpha: " + problem;
  Configuration smallest = c;
  smallest.parameters.e.setOnes();
  const theory::IntegerVector sides = theory::PairSystem(type).side_lengths(smallest.parameters);
  if (!equal_up_to_rotation(mesh::side_lengths(ring), std::vector<theory::Integer>(sides.begin(), sides.end()))) {
    return "the 1-ring of R_alpha has other sides than all e_i = 1 give";
  }
  return "";
}

std::string check_lemma_9(const FoundNode& node) {
  const int corners = static_cast<int>(mesh::side_lengths(node.region).size());
  const int expected = 4 - mesh::total_index(node.region.mesh);
  return corners == expected ? "" : std::to_string(corners) + " sides, not 4 - G = " + std::to_string(expected);
}

// Growing by strips: after each strip the sides obey Law 1; once every side has one the region is convex; in the end it
// is the glued one, which moves found too.
std::string check_growth(PairType type, const FoundNode& node) {
  const Configuration& c = node.reading.configuration;
  const theory::PairSystem system(type);
  enumerate::StripGrowth growth(type, c.d1(), c.d2());
  theory::StripParameters partial{c.d1(), c.d2(), theory::IntegerVector::Zero(type.side_count())};
  while (partial.e != c.parameters.e) {
    for (int label = 1; label <= type.side_count(); ++label) {
      if (partial.e(label - 1) == c.parameters.e(label - 1)) continue;
      growth.add_strip(label);
      ++partial.e(label - 1);
      const theory::IntegerVector expected = system.side_lengths(partial);
      const std::vector<int> sides = growth.side_lengths();
      if (!std::equal(sides.begin(), sides.end(), expected.begin(), expected.end())) return "a strip gave other sides than Law 1";
    }
    if (growth.complete()) {
      const Region stage = growth.region(1);
      if (const std::string problem = mesh::region_problem(stage); !problem.empty()) return "while growing: " + problem;
    }
  }
  if (mesh::signature(enumerate::grow_region(type, c)) != node.signature) return "grown by strips it is another mesh";
  if (mesh::signature(enumerate::glue_region(type, c)) != node.signature) return "glued from rectangles it is another mesh";
  return "";
}

// Distinct configurations have distinct separatrix vectors. The vector is taken up to renaming: the least over the
// frames and the order of the two vertices.
Judgement judge_theorem_11(const Study& s) {
  std::map<std::vector<std::pair<int, int>>, std::size_t> seen;
  Judgement j;
  for (std::size_t i = 0; i < s.found.nodes.size() && !j.violation; ++i) {
    const FoundNode& node = s.found.nodes[i];
    if (!s.found.holds_pair(static_cast<int>(i))) continue;
    std::vector<std::pair<int, int>> least;
    for (const auto& labelled : node.reading.frames) {
      for (const auto& frame : {labelled.frame, mesh::seen_from_other_end(node.region.mesh, labelled.frame)}) {
        std::vector<std::pair<int, int>> vector;
        for (const auto& at : enumerate::separatrix_vector(node.region, frame)) vector.emplace_back(at.side, at.distance);
        if (least.empty() || vector < least) least = std::move(vector);
      }
    }
    ++j.checks;
    const auto [other, is_new] = seen.emplace(std::move(least), i);
    if (!is_new) {
      j.violation = at_node(s, i, "has the separatrix vector of " +
                                      theory::label(s.region.type, s.found.nodes[other->second].reading.configuration));
    }
  }
  return j;
}

// --- the moves -------------------------------------------------------------------------------------------------------

Judgement judge_connected(const Study& s) {
  Judgement j;
  j.checks = s.pairs_found();
  std::set<int> reached(s.predicted_of.begin(), s.predicted_of.end());
  for (std::size_t i = 0; i < s.map.nodes.size(); ++i) {
    const Configuration& c = s.map.nodes[i].configuration;
    if (!c.merged() && reached.count(static_cast<int>(i)) == 0 && !j.violation) {
      j.violation = Violation{"moves do not reach this configuration from " + theory::label(s.region.type, s.map.nodes[0].configuration),
                              theory::label(s.region.type, c), "", enumerate::glue_region(s.region.type, c)};
    }
  }
  return j;
}

Judgement judge_realisation(const Study& s) {
  const Configuration start = enumerate::simplest_configuration(s.region.type, s.region.sides);
  return for_each_node(s, [&](const FoundNode& node) -> std::string {
    const enumerate::Realisation made = enumerate::realise(s.region.type, s.region.sides, start, node.reading.configuration);
    return mesh::signature(made.region) == node.signature ? "" : "the path of moves from " + theory::label(s.region.type, start) + " makes another mesh";
  });
}

// The four directions of a pair are four different moves: two made from one node never share frame and step, and each
// has its own target, except where theory glues (Law 3).
std::string check_four_directions(const Study& s) {
  std::vector<int> tried(s.found.nodes.size(), 0);
  for (const FoundMove& move : s.found.moves) ++tried[static_cast<std::size_t>(move.from)];
  for (std::size_t i = 0; i < tried.size(); ++i) {
    if (s.found.holds_pair(static_cast<int>(i)) && tried[i] != 4) return std::to_string(tried[i]) + " directions at one configuration, not four";
  }
  return "";
}

Judgement judge_moves(const Study& s, const std::function<std::string(const FoundMove&)>& problem) {
  Judgement j = for_each_move(s, problem);
  if (const std::string what = check_four_directions(s); !what.empty() && !j.violation) j.violation = at_region(what);
  return j;
}

std::string check_distance_kept(const FoundMove& move) {
  const bool kept = move.before.d1() == move.after.d1() && move.before.d2() == move.after.d2();
  return kept ? "" : "(d1,d2) changes from " + text(move.before) + " to " + text(move.after);
}

std::string check_distance_changed(const FoundMove& move) {
  const auto by_one = [](theory::Integer a, theory::Integer b) { return a - b == 1 || b - a == 1; };
  const bool right = by_one(move.before.d1(), move.after.d1()) && by_one(move.before.d2(), move.after.d2());
  return right ? "" : "(d1,d2) changes from " + text(move.before) + " to " + text(move.after);
}

// Law P3, in the paper's terms: along a connecting path of length d1 + d2 quads are all created or all deleted; along
// one where the two legs work against each other, |d1 - d2| remain.
std::string check_faces(const Study& s, const FoundMove& move) {
  const theory::PairSystem system(s.region.type);
  const theory::Integer change = move.faces_made - move.faces_deleted;
  const theory::Integer closed_form = system.face_count(move.after.parameters) - system.face_count(move.before.parameters);
  if (change != closed_form) {
    return "the move makes " + std::to_string(change) + " faces, the closed form says " + std::to_string(closed_form);
  }
  const theory::Integer c = is_quad(s) ? 0 : is_digon(s) ? -1 : 1;
  const theory::Integer a = move.move.frame.a;
  const theory::Integer b = move.move.frame.b;
  theory::Integer law = 0;
  switch (move.move.step) {
    case mesh::PairStep::slide_first: law = a - b + c; break;
    case mesh::PairStep::slide_second: law = b - a + c; break;
    case mesh::PairStep::open: law = a + b + c; break;
    case mesh::PairStep::close: law = -(a + b - c); break;
  }
  if (change != law) return "the move makes " + std::to_string(change) + " faces, the connecting path says " + std::to_string(law);
  if (move.faces_made > 0 && move.faces_deleted > 0) return "the move both makes and deletes faces";
  return "";
}

// --- grids, cancelling, merging --------------------------------------------------------------------------------------

// The found grid is the predicted one (compared with labels), its nodes all have the parity of L, and its dual is the
// grid of the next smaller region.
Judgement judge_dual(const Study& s) {
  if (!is_regular_family(s.region.family) || s.region.sides(0) < 3) return not_applicable();
  Judgement j;
  const theory::Integer length = s.region.sides(0);
  if (const auto graph = compare_graphs(s, theory::Apex::with); !graph.isomorphic) {
    j.violation = at_region(graph.difference);
    return j;
  }
  for (std::size_t i = 0; i < s.found.nodes.size() && !j.violation; ++i) {
    const Configuration& c = s.found.nodes[i].reading.configuration;
    ++j.checks;
    if ((c.d1() + c.d2() - length) % 2 != 0) j.violation = at_node(s, i, "its parity is not that of L");
  }
  const theory::DualGrid dual = theory::dual_grid(s.map);
  const theory::IntegerVector smaller_sides = theory::IntegerVector::Constant(s.region.sides.size(), length - 1);
  const theory::ConfigurationMap smaller = theory::configuration_map(s.region.type, smaller_sides, theory::Apex::with);
  // Name the faces by the nodes of the smaller grid at their centres.
  std::map<std::tuple<theory::Integer, theory::Integer, int>, int> node_at;
  for (std::size_t i = 0; i < smaller.nodes.size(); ++i) {
    const Configuration& c = smaller.nodes[i].configuration;
    node_at[{c.d1(), c.d2(), c.p}] = static_cast<int>(i);
  }
  std::vector<int> names;
  std::set<int> distinct;
  for (const Configuration& face : dual.faces) {
    const auto it = node_at.find({face.d1(), face.d2(), face.p});
    names.push_back(it == node_at.end() ? -1 : it->second);
    distinct.insert(names.back());
  }
  std::map<std::pair<int, int>, int> dual_edges;
  for (const auto& [a, b] : dual.edges) {
    const int x = names[static_cast<std::size_t>(a)];
    const int y = names[static_cast<std::size_t>(b)];
    ++dual_edges[{std::min(x, y), std::max(x, y)}];
  }
  std::vector<int> all(smaller.nodes.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  const bool nodes_match = names.size() == all.size() && distinct == std::set<int>(all.begin(), all.end());
  const bool same = nodes_match && dual_edges == edges_of(theory::configuration_graph(smaller), all);
  j.row = {{"sides", std::vector<theory::Integer>(s.region.sides.begin(), s.region.sides.end())},
           {"faces_of_grid", dual.faces.size()}, {"nodes_of_smaller_grid", smaller.nodes.size()},
           {"dual_edges", dual.edges.size()}, {"isomorphic", same}};
  if (!same && !j.violation) j.violation = at_region("the dual is not the grid of side " + std::to_string(length - 1));
  return j;
}

// Cancelling would leave a regular quadrilateral, whose opposite sides are equal; a 3-5 pair's are not. And no move loses
// the pair.
Judgement judge_no_cancelling(const Study& s) {
  if (!is_quad(s)) return not_applicable();
  Judgement j = for_each_node(s, [](const FoundNode& node) -> std::string {
    return node.reading.irregular.size() == 2 ? "" : "a move lost the pair";
  });
  const auto& e = s.region.sides;
  if (e(0) == e(2) && e(1) == e(3) && !j.violation) j.violation = at_region("opposite sides are equal: a regular grid fits");
  return j;
}

// The merged vertex is reached iff the graph distance of the pair is even; slides alone align it.
Judgement judge_merging(const Study& s) {
  if (!is_regular_family(s.region.family)) return not_applicable();
  Judgement j;
  const std::size_t n = s.found.nodes.size();
  std::vector<std::vector<int>> by_any(n), by_slides(n);
  for (const FoundMove& move : s.found.moves) {
    if (move.to < 0) continue;
    // Against the direction of the moves: from the goal back. Moves have inverses, but that is not taken for granted.
    by_any[static_cast<std::size_t>(move.to)].push_back(move.from);
    const bool slide = move.move.step == mesh::PairStep::slide_first || move.move.step == mesh::PairStep::slide_second;
    if (slide) by_slides[static_cast<std::size_t>(move.to)].push_back(move.from);
  }
  const auto reaching = [n](const std::vector<std::vector<int>>& backwards, const std::vector<int>& goals) {
    std::vector<bool> can(n, false);
    std::vector<int> stack = goals;
    while (!stack.empty()) {
      const int node = stack.back();
      stack.pop_back();
      if (can[static_cast<std::size_t>(node)]) continue;
      can[static_cast<std::size_t>(node)] = true;
      for (const int from : backwards[static_cast<std::size_t>(node)]) stack.push_back(from);
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
  for (std::size_t i = 0; i < n && !j.violation; ++i) {
    const FoundNode& node = s.found.nodes[i];
    if (node.reading.configuration.merged()) continue;
    ++j.checks;
    const int distance = mesh::graph_distance(node.region.mesh, node.reading.irregular[0], node.reading.irregular[1]);
    if (distance != node.reading.configuration.d1() + node.reading.configuration.d2()) {
      j.violation = at_node(s, i, "the graph distance " + std::to_string(distance) + " is not d1 + d2");
    } else if (can_merge[i] != (distance % 2 == 0)) {
      j.violation = at_node(s, i, std::string(can_merge[i] ? "merges" : "does not merge") + " at distance " + std::to_string(distance));
    } else if (!can_align[i]) {
      j.violation = at_node(s, i, "can not be aligned by slides");
    }
  }
  return j;
}

std::vector<Claim> make_claims() {
  const auto when = [](auto applies, auto judge) {
    return [=](const Study& s) { return applies(s) ? judge(s) : not_applicable(); };
  };
  const auto every_node = [](auto problem) {
    return [=](const Study& s) { return for_each_node(s, [&](const FoundNode& node) { return problem(s.region.type, node); }); };
  };
  const auto symmetric = [](const Study& s) { return s.region.type.symmetric(); };
  return {
      {"P1", "section 6", "A 3-5 move keeps (d1,d2), in four directions.", "labels read off the mesh before and after each move",
       when(is_quad, [](const Study& s) { return judge_moves(s, check_distance_kept); })},
      {"P2", "section 6", "A 3-3 or 5-5 move changes (d1,d2) by one of (+-1,+-1), four directions.",
       "labels read off the mesh before and after each move",
       when(symmetric, [](const Study& s) { return judge_moves(s, check_distance_changed); })},
      {"P3", "section 6", "The length of the connecting path determines the faces created or deleted.",
       "faces counted during each move, the closed form of the face count, the length of the path",
       [](const Study& s) { return for_each_move(s, [&](const FoundMove& move) { return check_faces(s, move); }); }},
      {"T2", "Theorem 7.2", "A regular digon of side L with a 3-3 pair has tau(L) configurations, parametrised by (m,n), four steps; a "
       "non-regular one has at most tau of the smallest regular digon around it.",
       "closed form, parameter set, configurations and graph found by moves, with labels", when(is_digon, judge_theorem)},
      {"T3", "Theorem 7.3", "A regular hexagon of side L with a 5-5 pair has tau(L) configurations, parametrised by (m,n,p), four steps; a "
       "non-regular one has at most tau of the smallest regular hexagon around it.",
       "closed form, parameter set, configurations and graph found by moves, with labels", when(is_hexagon, judge_theorem)},
      {"T4", "Theorem 7.4", "A convex region with a 3-5 pair has K = M N configurations, parametrised by (m,n), four steps.",
       "closed form, parameter set, configurations and graph found by moves, with labels", when(is_quad, judge_theorem)},
      {"G1", "Equation 1", "Discrete Gauss-Bonnet.", "turns and indices of every configuration, 4 chi", every_node([](PairType, const FoundNode& n) { return check_gauss_bonnet(n); })},
      {"L8", "Lemma 7.8", "R_alpha is unique and a d1 x d2 grid; the smallest convex region is its 1-ring.",
       "rectangles spanned by separatrices, sides of the 1-ring, Law 1 with all e_i = 1", every_node(check_lemma_8)},
      {"L9", "Lemma 7.9", "A convex region has 4 - G sides.", "corners counted on the boundary, indices counted inside",
       every_node([](PairType, const FoundNode& n) { return check_lemma_9(n); })},
      {"L10", "Lemmas 7.10, 7.12-7.14", "Every convex region grows from R_alpha by strips, with the side lengths of the paper's equations.",
       "sides after every strip, the grown, the glued and the moved mesh", every_node(check_growth)},
      {"T11", "Theorem 7.11", "The vector (S_ij, u_ij) determines the configuration.", "separatrix vectors of all configurations of a region", judge_theorem_11},
      {"M1", "section 1", "The three moves perform all possible edits: the configuration graph of every convex region with two irregular vertices is connected.",
       "configurations reached from one, parameter set", judge_connected},
      {"R1", "proof of 7.2", "Every configuration is realised from (0,0) or (0,1) by a shortest path of moves.",
       "the mesh at the end of the path, the mesh found by exploration", judge_realisation},
      {"F1", "Figures 10, 11", "Odd and even grids are disconnected from each other, and dual.",
       "faces of the found grid, nodes and edges of the next smaller one", judge_dual},
      {"N1", "section 7", "A 3-5 pair can not be cancelled inside a convex region.", "sides of the region, sides of a regular grid; pairs kept by all moves", judge_no_cancelling},
      {"N2", "sections 1, 8", "A 3-3 or 5-5 pair merges iff its graph distance is even; it can always be aligned.",
       "graph distance on the mesh, what moves reach", judge_merging},
  };
}

}  // namespace

const std::vector<Claim>& claims() {
  static const std::vector<Claim> kClaims = make_claims();
  return kClaims;
}

}  // namespace requad::verify
