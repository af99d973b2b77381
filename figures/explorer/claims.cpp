// The predictions of theory/ for a region, compared with what moves found there.
#include <algorithm>
#include <map>
#include <set>

#include <boost/graph/connected_components.hpp>

#include "figures/explorer/explorer.hpp"
#include "theory/counts.hpp"

namespace requad::figures {

namespace {

using enumerate::Exploration;
using enumerate::FoundMove;
using enumerate::FoundNode;
using theory::Apex;
using theory::Configuration;
using theory::Integer;
using theory::IntegerVector;
using theory::PairType;

std::string text(Integer value) { return std::to_string(value); }

std::string text(const IntegerVector& values) {
  std::string result;
  for (const Integer x : values) result += (result.empty() ? "" : ", ") + text(x);
  return result;
}

std::string counted(std::size_t number, const std::string& one) {
  return std::to_string(number) + " " + one + (number == 1 ? "" : "s");
}

std::vector<Configuration> pairs_of(const Exploration& found) {
  std::vector<Configuration> result;
  for (const FoundNode& node : found.nodes) {
    if (!node.reading.configuration.merged()) result.push_back(node.reading.configuration);
  }
  return result;
}

// Theorems 7.2, 7.3 and 7.4: the number of configurations.
RegionClaim count_claim(const Exploration& found) {
  const PairType type = found.shape.type();
  const std::vector<Configuration> pairs = pairs_of(found);
  const auto number = static_cast<Integer>(pairs.size());
  const Integer exact = theory::exact_count(found.shape);
  RegionClaim claim;
  claim.found = counted(pairs.size(), "configuration") + " reached by moves";
  claim.holds = number == exact;
  if (type == theory::kQuad) {
    const theory::QuadCount count = theory::quad_count(found.shape);
    claim.id = "T4";
    claim.where = "Theorem 7.4";
    claim.statement = "A convex region with a 3-5 pair has exactly K = M N configurations.";
    claim.predicted = "K = " + text(count.m) + " x " + text(count.n) + " = " + text(count.k());
    return claim;
  }
  const bool digon = type == theory::kDigon;
  const auto tau = [digon](Integer length) { return digon ? theory::tau_digon(length) : theory::tau_hexagon(length); };
  const std::string shape = digon ? "digon" : "hexagon";
  claim.id = digon ? "T2" : "T3";
  claim.where = digon ? "Theorem 7.2" : "Theorem 7.3";
  if (found.shape.is_regular()) {
    const Integer n = found.shape.longest() / 2;
    const std::string formula = (digon ? "" : "3 ") + std::string(found.shape.longest() % 2 == 0 ? "N (N - 1)" : "N^2");
    claim.statement = "A regular " + shape + " of side L has tau(L) configurations of a " + type.name() +
                      " pair, one for each (m,n" + (digon ? "" : ",p") + ") of the parameter set.";
    claim.predicted = "tau(" + text(found.shape.longest()) + ") = " + formula + " = " +
                      text(tau(found.shape.longest())) + " with N = " + text(n);
    claim.holds = claim.holds && number == tau(found.shape.longest());
  } else {
    const Integer length = theory::smallest_regular(found.shape);
    claim.statement =
        "A " + shape +
        " that is not regular has at most tau(L) configurations, L being the side of the smallest regular " + shape +
        " that holds it.";
    claim.predicted = "exactly " + text(exact) + ", at most tau(" + text(length) + ") = " + text(tau(length));
    claim.holds = claim.holds && number <= tau(length);
  }
  return claim;
}

RegionClaim set_claim(const Exploration& found) {
  std::vector<Configuration> pairs = pairs_of(found);
  const std::vector<Configuration> predicted = theory::parameter_set(found.shape);
  std::sort(pairs.begin(), pairs.end());
  const auto common =
      static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [&predicted](const Configuration& c) {
        return std::binary_search(predicted.begin(), predicted.end(), c);
      }));
  return {
      "T11",
      "Theorem 7.11",
      "Where the separatrices meet the sides determines the configuration: the positive solutions of the side-length "
      "equations are the configurations, and no two of these are alike.",
      counted(predicted.size(), "solution"),
      counted(common, "solution") + " read off " + std::to_string(pairs.size()) + " meshes",
      pairs == predicted};
}

// The edges of a graph by the labels of their ends.
std::multiset<std::pair<std::string, std::string>> labelled_edges(PairType type,
                                                                  const theory::ConfigurationGraph& graph) {
  std::multiset<std::pair<std::string, std::string>> result;
  for (const auto e : boost::make_iterator_range(edges(graph))) {
    std::string a = theory::label(type, graph[source(e, graph)].configuration);
    std::string b = theory::label(type, graph[target(e, graph)].configuration);
    result.insert(std::minmax(std::move(a), std::move(b)));
  }
  return result;
}

RegionClaim graph_claim(const Exploration& found) {
  const auto predicted = labelled_edges(
      found.shape.type(), theory::configuration_graph(theory::configuration_map(found.shape, Apex::with)));
  const auto made = labelled_edges(found.shape.type(), enumerate::found_graph(found, Apex::with));
  std::vector<std::pair<std::string, std::string>> common;
  std::set_intersection(made.begin(), made.end(), predicted.begin(), predicted.end(), std::back_inserter(common));
  const char* where = found.shape.type() == theory::kQuad    ? "Figure 12"
                      : found.shape.type() == theory::kDigon ? "Figure 10"
                                                             : "Figure 11";
  return {found.shape.type() == theory::kQuad    ? "T4"
          : found.shape.type() == theory::kDigon ? "T2"
                                                 : "T3",
          where,
          "The configurations and the moves between them form the grid of the figure.",
          counted(predicted.size(), "edge"),
          std::to_string(common.size()) + " of them among " + counted(made.size(), "edge"),
          made == predicted};
}

RegionClaim connected_claim(const Exploration& found) {
  const theory::ConfigurationGraph graph = enumerate::found_graph(found, Apex::without);
  std::vector<int> component(num_vertices(graph));
  const int components = component.empty() ? 0 : boost::connected_components(graph, component.data());
  return {"M1",
          "section 1",
          "The moves perform all possible edits of the pair: each configuration can be reached from each other one.",
          "1 component",
          counted(static_cast<std::size_t>(components), "component"),
          components == 1};
}

// P1 and P2: the change of (d1,d2) by a move.
RegionClaim distance_claim(const Exploration& found) {
  std::size_t made = 0;
  std::size_t as_claimed = 0;
  for (const FoundMove& move : found.moves) {
    if (move.to < 0) continue;
    ++made;
    if (!move.before || !move.after) continue;
    const Integer x = move.after->d1() - move.before->d1();
    const Integer y = move.after->d2() - move.before->d2();
    if (found.shape.type().symmetric() ? x * x == 1 && y * y == 1 : x == 0 && y == 0) ++as_claimed;
  }
  const bool holds = made == as_claimed;
  if (found.shape.type().symmetric()) {
    return {
        "P2",
        "section 6",
        "A move of a " + found.shape.type().name() + " pair changes (d1,d2) by (+1,+1), (+1,-1), (-1,+1) or (-1,-1).",
        counted(made, "move"),
        counted(as_claimed, "move"),
        holds};
  }
  return {"P1", "section 6", "A move of a 3-5 pair keeps (d1,d2).", counted(made, "move"), counted(as_claimed, "move"),
          holds};
}

// P3: the quads made minus the quads deleted follow the formula of section 6. The strip counts of a mesh give its
// number of quads.
RegionClaim faces_claim(const Exploration& found) {
  const theory::PairSystem system(found.shape.type());
  const auto quads = [&system](const Configuration& c) { return system.face_count(c.parameters); };
  std::size_t moves = 0;
  std::size_t as_claimed = 0;
  for (const FoundMove& move : found.moves) {
    if (move.to < 0) continue;
    ++moves;
    const FoundNode& from = found.nodes[static_cast<std::size_t>(move.from)];
    const FoundNode& to = found.nodes[static_cast<std::size_t>(move.to)];
    const Integer predicted = quads(to.reading.configuration) - quads(from.reading.configuration);
    const bool meshes = to.region.mesh.face_count() == quads(to.reading.configuration) &&
                        from.region.mesh.face_count() == quads(from.reading.configuration);
    if (meshes && move.faces_made - move.faces_deleted == predicted) ++as_claimed;
  }
  return {"P3",
          "section 6",
          "The length of the path between the pair determines how many quads a move creates or deletes.",
          counted(moves, "move"),
          counted(as_claimed, "move"),
          moves == as_claimed};
}

RegionClaim inverse_claim(const Exploration& found) {
  std::size_t moves = 0;
  std::size_t as_claimed = 0;
  for (const FoundMove& move : found.moves) {
    if (move.to < 0) continue;
    ++moves;
    if (move.restored && move.inverse_returns) ++as_claimed;
  }
  return {"B3",
          "section 4",
          "The basic operations have inverses: each move can be taken back, and the move the other way undoes it.",
          counted(moves, "move"),
          counted(as_claimed, "move"),
          moves == as_claimed};
}

// N2: d1 + d2 has the same parity everywhere. If it is even and there is room, there is a merged vertex.
RegionClaim parity_claim(const Exploration& found) {
  const bool even = theory::smallest_regular(found.shape) % 2 == 0;
  const std::size_t merged = theory::merged_configurations(found.shape).size();
  std::set<Integer> parities;
  std::size_t reached = 0;
  for (const FoundNode& node : found.nodes) {
    const Configuration& c = node.reading.configuration;
    parities.insert((c.d1() + c.d2()) % 2);
    if (c.merged()) ++reached;
  }
  const std::string vertex = "v" + std::to_string(found.shape.type().side_count());
  const auto outcome = [&vertex](const std::string& parity, std::size_t number) {
    return "d1 + d2 " + parity + ", " + (number == 0 ? "no " + vertex : "a " + vertex);
  };
  const std::string seen = parities.size() > 1 ? "of both parities" : *parities.begin() == 0 ? "even" : "odd";
  return {"N2",
          "sections 1, 8",
          "The pair merges into one " + vertex +
              " only if its distance d1 + d2 is even, and the moves never change the parity.",
          outcome(even ? "even" : "odd", merged),
          outcome(seen, reached),
          parities == std::set<Integer>{even ? 0 : 1} && merged == reached && (even || merged == 0)};
}

RegionClaim rectangle_claim(const Exploration& found) {
  std::size_t pairs = 0;
  std::size_t grids = 0;
  for (const FoundNode& node : found.nodes) {
    const Configuration& c = node.reading.configuration;
    if (c.merged()) continue;
    ++pairs;
    const auto faces = mesh::grid(node.region.mesh, node.reading.frames.front().frame);
    if (faces && static_cast<Integer>(faces->size()) == c.d1() * c.d2()) ++grids;
  }
  return {"L8",
          "Lemma 7.8",
          "The smallest region between the two vertices, R_alpha, is a d1 x d2 grid, or a segment.",
          counted(pairs, "grid"),
          counted(grids, "grid"),
          pairs == grids};
}

RegionClaim sides_claim(const Exploration& found) {
  std::set<int> curvature;
  bool kept = true;
  for (const FoundNode& node : found.nodes) {
    curvature.insert(mesh::total_index(node.region.mesh));
    const std::vector<int> now = mesh::side_lengths(node.region);
    kept = kept && std::equal(now.begin(), now.end(), found.shape.sides().begin(), found.shape.sides().end());
  }
  const int k = found.shape.type().side_count();
  const bool holds = kept && curvature == std::set<int>{4 - k};
  return {"L9",
          "Lemma 7.9",
          "The region has 4 - G sides, G being the sum of 4 - valence over the vertices inside; no move touches the "
          "boundary.",
          "G = " + std::to_string(4 - k) + ", sides " + text(found.shape.sides()),
          holds ? "the same in all meshes" : "something else",
          holds};
}

}  // namespace

std::vector<RegionClaim> region_claims(const Exploration& found) {
  std::vector<RegionClaim> claims{count_claim(found), set_claim(found), graph_claim(found), connected_claim(found),
                                  distance_claim(found)};
  if (found.shape.type().symmetric()) claims.push_back(parity_claim(found));
  claims.push_back(faces_claim(found));
  claims.push_back(inverse_claim(found));
  claims.push_back(rectangle_claim(found));
  claims.push_back(sides_claim(found));
  return claims;
}

}  // namespace requad::figures
