#include "verify/studies/study.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <stdexcept>
#include <utility>

#include "enumerate/generators.hpp"
#include "enumerate/search/search.hpp"
#include "mesh/topology/signature.hpp"

namespace requad::verify {

const char* name(Method method) {
  switch (method) {
    case Method::moves: return "moves";
    case Method::search: return "search";
    case Method::walk: return "walk";
  }
  return "";
}

Family family_of(const Study& study) {
  if (const auto* pair = std::get_if<PairStudy>(&study)) return family_of(PairCase{pair->shape});
  return std::holds_alternative<VertexStudy>(study) ? Family::single_vertex : Family::three_vertices;
}

const MethodSeconds& seconds_of(const Study& study) {
  return std::visit([](const auto& s) -> const MethodSeconds& { return s.seconds; }, study);
}

std::optional<std::int64_t> fillings_searched(const Study& study) {
  if (const auto* triple = std::get_if<TripleStudy>(&study))
    return triple->searched ? std::optional(std::ssize(triple->fillings)) : std::nullopt;
  const auto* const pair = std::get_if<PairStudy>(&study);
  const std::optional<Signatures>& found = pair != nullptr ? pair->searched : std::get<VertexStudy>(study).searched;
  return found ? std::optional(std::ssize(*found)) : std::nullopt;
}

int PairStudy::pairs_predicted() const {
  if (map.nodes.empty() && walked) return static_cast<int>(walked->predicted);
  return static_cast<int>(std::count_if(map.nodes.begin(), map.nodes.end(),
                                        [](const theory::MapNode& node) { return !node.configuration.merged(); }));
}

int PairStudy::pairs_found() const {
  int count = 0;
  for (std::size_t i = 0; i < found.nodes.size(); ++i) count += found.holds_pair(static_cast<int>(i)) ? 1 : 0;
  return count;
}

std::vector<int> TripleStudy::after_merging() const {
  // Two of the three are equal, the middle one among them.
  const std::vector<int>& three = region.valences;
  std::vector<int> two{2 * three[1] - 4, three[0] == three[1] ? three[2] : three[0]};
  std::sort(two.begin(), two.end());
  return two;
}

std::optional<std::vector<int>> TripleStudy::after_cancelling() const {
  const std::vector<int>& three = region.valences;
  return three.front() == 3 && three.back() == 5 ? std::optional(std::vector{three[1]}) : std::nullopt;
}

const Signatures& TripleStudy::fewer_with(const std::vector<int>& valences) const {
  static const Signatures kNone;
  const auto found = fewer.find(valences);
  return found == fewer.end() ? kNone : found->second;
}

namespace {

// Does a part of a study, and adds the time that this takes to its method.
template <class Part>
void timed(MethodSeconds& seconds, Method method, Part&& part) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  part();
  seconds[method] += std::chrono::duration<double>(Clock::now() - start).count();
}

// All fillings of a boundary with these irregular valences, by signature.
std::map<std::string, mesh::Region> fillings(const theory::IntegerVector& sides, std::vector<int> irregular) {
  enumerate::SearchLimits limits;
  limits.threads = 1;  // the campaign runs regions in parallel
  std::map<std::string, mesh::Region> found;
  enumerate::search(enumerate::search_problem({sides.begin(), sides.end()}, std::move(irregular)), limits,
                    [&found](const enumerate::Filling& f) {
                      mesh::Region r = enumerate::region_of(f);
                      std::string signature = mesh::signature(r);
                      if (!found.emplace(std::move(signature), std::move(r)).second)
                        throw std::logic_error("the search made one filling twice");
                    });
  return found;
}

Signatures signatures(const theory::IntegerVector& sides, std::vector<int> irregular) {
  Signatures result;
  for (auto& [signature, filling] : fillings(sides, std::move(irregular))) result.push_back(signature);
  return result;
}

constexpr int kLongestVertexSearch = 40;  // perimeter; larger regions serve the checks of operations only

VertexStudy study_vertex(const VertexCase& region, const std::set<Method>& methods) {
  VertexStudy s{region.sides, {}, std::nullopt};
  for (const theory::IntegerVector& e : theory::solve_circulant(s.sides)) s.glued.push_back(enumerate::glue_vertex(e));
  if (methods.count(Method::search) > 0 && s.sides.sum() <= kLongestVertexSearch) {
    const std::vector<int> irregular = s.valence() == 4 ? std::vector<int>{} : std::vector<int>{s.valence()};
    timed(s.seconds, Method::search, [&] { s.searched = signatures(s.sides, irregular); });
  }
  return s;
}

// Every multiset of one or two irregular valences with the index of three vertices of these.
std::vector<std::vector<int>> fewer_valences(const std::vector<int>& three) {
  const int index = 12 - three[0] - three[1] - three[2];
  std::vector<std::vector<int>> result;
  if (4 - index >= 2) result.push_back({4 - index});
  for (int least = 2; 2 * least <= 8 - index; ++least) {
    const int other = 8 - index - least;
    if (least != 4 && other != 4) result.push_back({least, other});
  }
  return result;
}

TripleStudy study_triple(const TripleCase& region, const std::set<Method>& methods) {
  if (methods.count(Method::search) == 0) return {region, false, {}, {}, {}, {}};
  MethodSeconds searching;
  TripleStudy s;
  timed(searching, Method::search, [&] { s = search_triple(region); });
  s.seconds = searching;
  timed(s.seconds, Method::moves, [&] {
    for (const mesh::Region& filling : s.fillings) s.edits.push_back(enumerate::edit_results(filling));
  });
  return s;
}

void add_exploration(PairStudy& s, enumerate::Exploration found) {
  s.found = std::move(found);
  for (const enumerate::FoundNode& node : s.found.nodes) {
    s.predicted_of.push_back(node.reading.problem.empty() ? s.map.find(node.reading.configuration) : -1);
  }
}

}  // namespace

PairStudy study_moves(enumerate::Exploration found) {
  const theory::RegionShape shape = found.shape;
  PairStudy s{shape,
              theory::exact_count(shape),
              theory::configuration_map(shape, theory::Apex::with),
              {shape, {}, {}},
              {},
              {},
              {},
              {}};
  add_exploration(s, std::move(found));
  return s;
}

PairStudy study_pair(const theory::RegionShape& shape, const std::set<Method>& methods,
                     const enumerate::WalkProgress& progress) {
  const theory::PairType type = shape.type();
  PairStudy s{shape, theory::exact_count(shape), {}, {shape, {}, {}}, {}, {}, {}, {}};
  const bool search = methods.count(Method::search) > 0;
  const bool moves = methods.count(Method::moves) > 0;
  if (methods.count(Method::walk) > 0)
    timed(s.seconds, Method::walk, [&] { s.walked = enumerate::walk(shape, progress); });
  s.search_asked = search;
  if (!search && !moves) return s;
  s.map = theory::configuration_map(shape, theory::Apex::with);
  if (search) {
    timed(s.seconds, Method::search, [&] {
      s.searched = signatures(shape.sides(), {type.l1, type.l2});
      if (type.symmetric()) s.searched_merged = signatures(shape.sides(), {type.side_count()});
    });
  }
  // The pair's first configuration. Without one there is nothing to explore.
  const auto start = std::find_if(s.map.nodes.begin(), s.map.nodes.end(),
                                  [](const theory::MapNode& node) { return !node.configuration.merged(); });
  if (!moves || start == s.map.nodes.end()) return s;
  timed(s.seconds, Method::moves,
        [&] { add_exploration(s, enumerate::explore(shape, {enumerate::glue_region(type, start->configuration)})); });
  return s;
}

TripleStudy search_triple(const TripleCase& region) {
  TripleStudy s{region, true, {}, {}, {}, {}};
  for (auto& [signature, filling] : fillings(region.sides, region.valences)) {
    s.signatures.push_back(signature);
    s.fillings.push_back(std::move(filling));
  }
  if (s.fillings.empty()) return s;  // there is nothing to edit
  for (const std::vector<int>& valences : fewer_valences(region.valences)) {
    Signatures found = signatures(region.sides, valences);
    if (!found.empty()) s.fewer.emplace(valences, std::move(found));
  }
  return s;
}

Study study(const RegionCase& region, const std::set<Method>& methods, const enumerate::WalkProgress& progress) {
  if (const auto* vertex = std::get_if<VertexCase>(&region)) return study_vertex(*vertex, methods);
  if (const auto* triple = std::get_if<TripleCase>(&region)) return study_triple(*triple, methods);
  return study_pair(std::get<PairCase>(region).shape, methods, progress);
}

}  // namespace requad::verify
