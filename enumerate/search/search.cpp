#include "enumerate/search/search.hpp"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "enumerate/search/journaled_search.hpp"
#include "mesh/program/run/journal_file.hpp"
#include "mesh/topology/signature.hpp"

namespace requad::enumerate {

using nlohmann::ordered_json;
using program::integer_from;

namespace {

constexpr std::size_t kMostBoundary = 10000;

}  // namespace

// --- problems --------------------------------------------------------------------------------------------------------

SearchProblem search_problem(const std::vector<int>& sides, std::vector<int> irregular) {
  SearchProblem problem{{}, std::move(irregular)};
  for (const int side : sides) {
    if (problem.interior_quads.size() > kMostBoundary) break;  // problem_with() refuses it, however it goes on
    problem.interior_quads.push_back(1);
    const auto rest = static_cast<std::size_t>(std::max(side - 1, 0));
    problem.interior_quads.insert(problem.interior_quads.end(), std::min(rest, kMostBoundary), 2);
  }
  return problem;
}

std::string irregular_problem(const std::vector<int>& irregular) {
  for (const int l : irregular) {
    if (l < 2 || l == 4 || l > 100) return "irregular valence " + std::to_string(l) + " is not in 2, 3, 5..100";
  }
  return "";
}

std::string problem_with(const SearchProblem& problem) {
  const std::size_t edges = problem.interior_quads.size();
  if (edges < 3) return "a boundary of " + std::to_string(edges) + " edges encloses no simple mesh";
  if (edges > kMostBoundary) return "a boundary of more than " + std::to_string(kMostBoundary) + " edges";
  for (const int quads : problem.interior_quads) {
    if (quads < 1 || quads > 100)
      return "a boundary vertex with " + std::to_string(quads) + " interior quads; expected 1..100";
  }
  return irregular_problem(problem.irregular);
}

namespace {

// 4 minus the sum of all indices: 2 - q at the boundary, 4 - l inside. Discrete Gauss-Bonnet: it is 0 in a disk.
int missing_index(const SearchProblem& problem) {
  int index = 4;
  for (const int quads : problem.interior_quads) index -= 2 - quads;
  for (const int l : problem.irregular) index -= 4 - l;
  return index;
}

}  // namespace

std::string impossibility(const SearchProblem& problem) {
  std::string why;
  if (const std::size_t edges = problem.interior_quads.size(); edges % 2 != 0)
    why = "the sides have the odd sum " + std::to_string(edges) + ", and the boundary of a quadrangulated disk is even";
  const int missing = missing_index(problem);
  if (missing == 0) return why;
  int inside = 0;
  for (const int l : problem.irregular) inside += 4 - l;
  return why + (why.empty() ? "" : "; ") + "the indices 4 - l of the irregular vertices sum to " +
         std::to_string(inside) + ", and with this boundary they must sum to " + std::to_string(inside + missing) +
         " (discrete Gauss-Bonnet)";
}

bool may_be_infinite(const SearchProblem& problem) {
  int positive_index = 0;
  for (const int l : problem.irregular) positive_index += std::max(4 - l, 0);
  return positive_index >= 4;
}

// --- fillings --------------------------------------------------------------------------------------------------------

mesh::Region region_of(const Filling& filling) {
  mesh::Region region{mesh::QuadMesh::from_faces(filling.vertices, filling.faces), {}};
  region.root = region.mesh.find_half_edge(mesh::VertexId(0), mesh::VertexId(1));
  return region;
}

namespace {

// The boundary around one hole; nothing if no filling can have these valences, all of them.
std::vector<BacktrackingSearch> starts_of(const SearchProblem& problem, SearchControl& control) {
  if (const std::string what = problem_with(problem); !what.empty()) throw std::invalid_argument(what);
  // may_be_filled() asks whether some part of the budget fits; here the whole has to.
  if (missing_index(problem) != 0) return {};
  PartialMesh start(problem.irregular);
  std::vector<PartialMesh::BoundaryVertex> ring;
  for (const int quads : problem.interior_quads) ring.push_back({start.add_vertex(), quads});
  const int length = static_cast<int>(ring.size());
  for (int i = 0; i < length; ++i) start.add_edge(i, (i + 1) % length);
  start.open_hole(ring);
  if (!may_be_filled(start, control.pruning)) return {};
  return {BacktrackingSearch(std::move(start), control)};
}

}  // namespace

SearchOutcome search(const SearchProblem& problem, const SearchLimits& limits,
                     const std::function<void(const Filling&)>& visit) {
  SearchControl control(limits);
  SharedSearch search(starts_of(problem, control), control);
  SearchOutcome outcome;
  std::mutex mutex;
  search.run(limits.threads, [&](const Filling& filling) {
    {
      const std::scoped_lock lock(mutex);
      ++outcome.count;
      ++outcome.by_faces[static_cast<int>(filling.faces.size())];
    }
    if (visit) visit(filling);
  });
  outcome.states = search.states();
  outcome.face_limit_cut = control.face_limit_cut;
  outcome.out_of_time = !search.done();
  return outcome;
}

// --- fillings counted ------------------------------------------------------------------------------------------------

namespace {

// Sums over fillings of one boundary.
struct Tally {
  std::int64_t count = 0;
  std::map<int, std::int64_t> by_faces;
  // Rotations first, then rotations and reflections.
  std::array<std::int64_t, 2> symmetries{1, 1};  // of the boundary
  std::array<std::int64_t, 2> fixing{};          // those that fix a filling, summed over the fillings
  std::vector<std::string> signatures;           // empty unless they are kept

  Tally() = default;
  Tally(const Filling& filling, bool keep_signature) : count(1), by_faces{{static_cast<int>(filling.faces.size()), 1}} {
    const mesh::Region region = region_of(filling);
    const auto rotated = mesh::rotated_signatures(region);
    const auto reflected = mesh::reflected_signatures(region);
    std::string own = mesh::signature(region);
    const auto fixed = std::count(rotated.begin(), rotated.end(), own);
    symmetries = {std::ssize(rotated), std::ssize(rotated) + std::ssize(reflected)};
    fixing = {fixed, fixed + std::count(reflected.begin(), reflected.end(), own)};
    if (keep_signature) signatures.push_back(std::move(own));
  }

  void add(Tally other) {
    if (other.count > 0) symmetries = other.symmetries;
    count += other.count;
    for (const auto& [faces, number] : other.by_faces) by_faces[faces] += number;
    for (std::size_t i = 0; i < fixing.size(); ++i) fixing[i] += other.fixing[i];
    std::move(other.signatures.begin(), other.signatures.end(), std::back_inserter(signatures));
  }

  ordered_json to_json() const {
    return {{"count", count},
            {"by_faces", by_faces},
            {"symmetries", symmetries},
            {"fixing", fixing},
            {"signatures", signatures}};
  }
  void add_from_json(const ordered_json& json) {
    const std::int64_t before = count;
    add_from(count, json.at("count"));
    for (const ordered_json& entry : array_in(json.at("by_faces")))
      add_from(by_faces[static_cast<int>(integer_from(entry.at(0), 1, kMostFaces))], entry.at(1));
    for (std::size_t i = 0; i < fixing.size(); ++i) {
      const std::int64_t of_boundary = integer_from(json.at("symmetries").at(i), 1, 2 * kMostBoundary);
      if (count > before) symmetries[i] = of_boundary;  // they are unknown until there is a filling
      add_from(fixing[i], json.at("fixing").at(i));
    }
    for (const ordered_json& signature : array_in(json.at("signatures")))
      signatures.push_back(signature.get<std::string>());
  }
};

}  // namespace

CountedSearch count_fillings(const SearchProblem& problem, const SearchLimits& limits, bool keep_signatures,
                             const std::optional<SearchJournal>& journal) {
  SearchControl control(limits);
  SharedSearch search(starts_of(problem, control), control);
  std::mutex mutex;
  Tally earlier, latest;  // what the journal has, and what was found since that was written
  const auto visit = [&](const Filling& filling) {
    Tally one(filling, keep_signatures);
    const std::scoped_lock lock(mutex);
    latest.add(std::move(one));
  };
  const auto take_new = [&] {
    ordered_json json = latest.to_json();
    earlier.add(std::exchange(latest, {}));
    return json;
  };
  const auto add_earlier = [&](const ordered_json& json) { earlier.add_from_json(json); };
  CountedSearch counted;
  counted.outcome.states = run_with_journal(search, control, limits.threads, visit, journal, {take_new, add_earlier});
  Tally all = std::move(earlier);
  all.add(std::move(latest));
  counted.outcome.count = all.count;
  counted.outcome.by_faces = std::move(all.by_faces);
  counted.outcome.face_limit_cut = control.face_limit_cut;
  counted.outcome.out_of_time = !search.done();
  // The sum of 1 / (length of the orbit) = (symmetries that fix the filling) / (symmetries of the boundary).
  counted.orbits = {all.fixing[0] / all.symmetries[0], all.fixing[1] / all.symmetries[1]};
  counted.signatures = std::move(all.signatures);
  std::sort(counted.signatures.begin(), counted.signatures.end());
  return counted;
}

}  // namespace requad::enumerate
