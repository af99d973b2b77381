#include "verify/studies/study.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "enumerate/generators.hpp"
#include "enumerate/search/search.hpp"
#include "mesh/topology/signature.hpp"
#include "theory/joined.hpp"

namespace requad::verify {

const char* name(Family family) {
  switch (family) {
    case Family::regular_digon: return "regular digons";
    case Family::regular_hexagon: return "regular hexagons";
    case Family::quad: return "3-5 regions";
    case Family::other_digon: return "non-regular digons";
    case Family::other_hexagon: return "non-regular hexagons";
    case Family::single_vertex: return "regions with one irregular vertex";
    case Family::three_vertices: return "regions with three irregular vertices";
  }
  return "";
}

const char* name(Method method) {
  switch (method) {
    case Method::moves: return "moves";
    case Method::search: return "search";
    case Method::walk: return "walk";
  }
  return "";
}

std::string describe(const RegionCase& region) {
  const std::string holds = region.family == Family::single_vertex    ? "v" + std::to_string(region.type.side_count())
                            : region.family == Family::three_vertices ? theory::joined(region.irregular, "-")
                                                                      : region.type.name();
  return holds + " region with sides " + theory::joined(region.sides, " ");
}

int Study::pairs_predicted() const {
  if (map.nodes.empty() && walked) return static_cast<int>(walked->predicted);
  return static_cast<int>(std::count_if(map.nodes.begin(), map.nodes.end(),
                                        [](const theory::MapNode& node) { return !node.configuration.merged(); }));
}

int Study::pairs_found() const {
  int count = 0;
  for (std::size_t i = 0; i < found.nodes.size(); ++i) count += found.holds_pair(static_cast<int>(i)) ? 1 : 0;
  return count;
}

namespace {

// All fillings of the region with these irregular valences, sorted by signature.
std::map<std::string, mesh::Region> filled(const RegionCase& region, std::vector<int> irregular) {
  const std::vector<int> sides(region.sides.begin(), region.sides.end());
  enumerate::SearchLimits limits;
  limits.threads = 1;  // regions are what runs in parallel
  std::map<std::string, mesh::Region> found;
  enumerate::search(enumerate::search_problem(sides, std::move(irregular)), limits,
                    [&found](const enumerate::Filling& f) {
                      mesh::Region r = enumerate::region_of(f);
                      std::string signature = mesh::signature(r);
                      if (!found.emplace(std::move(signature), std::move(r)).second)
                        throw std::logic_error("the search made one filling twice");
                    });
  return found;
}

std::vector<std::string> fillings(const RegionCase& region, std::vector<int> irregular) {
  std::vector<std::string> signatures;
  for (auto& [signature, filling] : filled(region, std::move(irregular))) signatures.push_back(signature);
  return signatures;
}

// Three vertices, and what they can become.
void study_three(Study& s) {
  const std::vector<int>& valences = s.region.irregular;
  for (auto& [signature, filling] : filled(s.region, valences)) s.fillings.push_back(std::move(filling));
  s.searched.emplace();
  s.searched_merged.emplace();
  const int one = s.region.type.side_count();
  if (valences.front() == 3 && valences.back() == 5) s.searched = fillings(s.region, {one});
  // Two of the three are equal, the middle one among them.
  const bool low = valences[0] == valences[1];
  s.searched_merged = fillings(s.region, {2 * valences[1] - 4, low ? valences[2] : valences[0]});
}

std::string step_text(const theory::Configuration& from, const theory::Configuration& to) {
  const auto text = [](const theory::Configuration& c) {
    std::string t =
        "d1=" + std::to_string(c.d1()) + " d2=" + std::to_string(c.d2()) + " p=" + std::to_string(c.p) + " e=";
    for (const auto e : c.parameters.e) t += std::to_string(e) + ",";
    return t;
  };
  return "the step from " + text(from) + " to " + text(to) + " is none of the theorem's four";
}

}  // namespace

Study study(const RegionCase& region, const std::set<Method>& methods, const enumerate::WalkProgress& progress) {
  Study s;
  s.region = region;
  const bool search = methods.count(Method::search) > 0;
  if (region.family == Family::three_vertices) {
    if (search) study_three(s);
    return s;
  }
  if (region.family == Family::single_vertex) {
    const int valence = region.type.side_count();
    for (theory::IntegerVector& e : theory::solve_circulant(region.sides)) {
      s.single.push_back(enumerate::glue_region(region.type, {{0, 0, std::move(e)}, 1}));
    }
    // A grid has no irregular vertex; the largest neighbourhoods are for operations only.
    if (search && region.sides.sum() <= 40)
      s.searched = fillings(region, valence == 4 ? std::vector<int>{} : std::vector<int>{valence});
    return s;
  }
  const theory::RegionShape shape(region.type, region.sides);
  s.exact_count = theory::exact_count(shape);
  if (methods.count(Method::walk) > 0) s.walked = enumerate::walk(shape, progress);
  if (!search && methods.count(Method::moves) == 0) return s;
  s.map = theory::configuration_map(shape, theory::Apex::with);
  if (search) {
    s.searched = fillings(region, {region.type.l1, region.type.l2});
    if (region.type.symmetric()) s.searched_merged = fillings(region, {region.type.side_count()});
  }
  // The pair's first configuration; where there is none there is nothing to explore.
  const auto start = std::find_if(s.map.nodes.begin(), s.map.nodes.end(),
                                  [](const theory::MapNode& node) { return !node.configuration.merged(); });
  if (methods.count(Method::moves) == 0 || start == s.map.nodes.end()) return s;
  s.found = enumerate::explore(shape, {enumerate::glue_region(region.type, start->configuration)});
  for (const auto& node : s.found.nodes) {
    s.predicted_of.push_back(node.reading.problem.empty() ? s.map.find(node.reading.configuration) : -1);
  }
  return s;
}

theory::ConfigurationMap found_map(const Study& s) {
  theory::ConfigurationMap map = s.map;
  for (theory::MapNode& node : map.nodes) std::fill(node.moves.begin(), node.moves.end(), theory::Dart{});
  // Which of a node's moves makes the step from one labelling to another.
  const auto slot_of = [&](int node, const theory::Configuration& from, const theory::Configuration& to) {
    const theory::MapNode& n = map.nodes[static_cast<std::size_t>(node)];
    for (std::size_t slot = 0; slot < n.steps.size(); ++slot) {
      // The merged configuration reads the same whatever p: the step out of it goes to (1,1,p).
      const bool from_here = from.merged() ? n.labellings[slot].p == to.p : n.labellings[slot] == from;
      const theory::Configuration expected = theory::stepped(map.type, n.labellings[slot], n.steps[slot]);
      const bool to_there = expected.merged() ? to.merged() : expected == to;
      if (from_here && to_there) return static_cast<int>(slot);
    }
    throw std::logic_error(step_text(from, to));
  };
  for (const enumerate::FoundMove& move : s.found.moves) {
    if (move.to < 0) continue;
    const int from = s.predicted_of[static_cast<std::size_t>(move.from)];
    const int to = s.predicted_of[static_cast<std::size_t>(move.to)];
    if (from < 0 || to < 0) throw std::logic_error("a move joins configurations that are not predicted");
    if (!move.before || !move.after) throw std::logic_error("a move's frame has no labelling");
    // Both labellings of a 3-5 segment describe the same four translations: the map has them for one.
    const auto labelled = [&](const theory::Configuration& c) {
      return map.type.symmetric() ? c : theory::canonical(map.type, c);
    };
    const theory::Configuration before = labelled(*move.before), after = labelled(*move.after);
    const int slot = slot_of(from, before, after);
    theory::Dart& dart = map.nodes[static_cast<std::size_t>(from)].moves[static_cast<std::size_t>(slot)];
    if (dart.target >= 0) throw std::logic_error("two moves make one step");
    dart = {to, slot_of(to, after, before)};
  }
  return map;
}

}  // namespace requad::verify
