#include "enumerate/search/search.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <limits>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "enumerate/search/backtracking.hpp"
#include "enumerate/search/shared_search.hpp"
#include "mesh/program/journal_file.hpp"
#include "mesh/topology/signature.hpp"

namespace requad::enumerate {

using program::integer_from;
using program::JournalFile;

using nlohmann::ordered_json;

namespace {

constexpr std::size_t kMostBoundary = 10000;
constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

// The partial mesh that a search starts from, or none if the boundary has no filling at first sight.
std::vector<BacktrackingSearch> starts_of(const SearchProblem& problem, SharedLimits& shared) {
  if (const std::string what = problem_with(problem); !what.empty()) throw std::invalid_argument(what);
  // The whole budget has to fit, not only a part of it.
  int index = 4;
  for (const int quads : problem.interior_quads) index -= 2 - quads;
  for (const int l : problem.irregular) index -= 4 - l;
  if (index != 0) return {};
  BacktrackingSearch filler(problem.irregular, shared);
  std::vector<BacktrackingSearch::BoundaryVertex> boundary;
  for (const int quads : problem.interior_quads) boundary.push_back({filler.add_vertex(), quads});
  const int length = static_cast<int>(boundary.size());
  for (int i = 0; i < length; ++i) filler.add_edge(i, (i + 1) % length);
  if (!filler.open_hole(boundary)) return {};
  return {filler};
}

// From a journal: an array, and nothing else that could be iterated; a number to be added.
const ordered_json::array_t& array_in(const ordered_json& json) { return json.get_ref<const ordered_json::array_t&>(); }
void add_from(std::int64_t& sum, const ordered_json& json) { sum += integer_from(json, 0, kMost - sum); }

// What was found, as a journal keeps it.
struct Findings {
  std::function<ordered_json()> news;             // since it was last called
  std::function<void(const ordered_json&)> take;  // what news() gave to an earlier run
};

// Follows all that is left, to the end or out of time, and returns the states. With a journal, first goes to where that
// stands, and stops now and then to write on.
std::int64_t follow(SharedSearch& frontier, SharedLimits& shared, int threads, const BacktrackingSearch::Visit& visit,
                    const std::optional<SearchJournal>& journal, const Findings& findings) {
  if (!journal) {
    frontier.follow(threads, visit);
    return frontier.states();
  }
  std::int64_t states = 0;
  std::optional<std::vector<std::vector<int>>> left;
  JournalFile file(journal->path, "requad-enumerate", journal->run, [&](const ordered_json& record) {
    findings.take(record.at("found"));
    add_from(states, record.at("states"));
    if (record.at("face_limit_cut").get<bool>()) shared.face_limit_cut = true;
    left.emplace();
    for (const ordered_json& part : array_in(record.at("left"))) {
      std::vector<int>& numbers = left->emplace_back();
      for (const ordered_json& number : array_in(part))
        numbers.push_back(static_cast<int>(integer_from(number, 0, std::numeric_limits<int>::max())));
    }
  });
  if (left) {
    try {
      frontier.set_left(*left);
    } catch (const std::invalid_argument& error) {
      file.refuse(std::string("what is left in the last line is nothing of this search: ") + error.what());
    }
  }
  if (shared.progress) shared.progress(states);
  using Clock = SharedLimits::Clock;
  using Seconds = std::chrono::duration<double>;
  const auto start = Clock::now();
  // However little time there is, each run gets on.
  for (bool late = false; !frontier.empty() && !late; late = shared.deadline && Clock::now() > *shared.deadline) {
    const Seconds wait = std::max(Seconds(Clock::now() - start) / 100, Seconds(journal->least_seconds));
    shared.pause = Clock::now() + std::chrono::duration_cast<Clock::duration>(wait);
    frontier.follow(threads, visit);
    states += frontier.states();
    file.append({{"found", findings.news()},
                 {"states", frontier.states()},
                 {"face_limit_cut", shared.face_limit_cut.load()},
                 {"left", frontier.left()}});
  }
  return states;
}

// The fillings of a boundary, counted.
struct Tally {
  std::int64_t count = 0;
  std::map<int, std::int64_t> by_faces;
  // The symmetries of the boundary, and how many of them fix a filling, over all fillings: rotations, then all.
  std::array<std::int64_t, 2> symmetries{1, 1};
  std::array<std::int64_t, 2> fixing{};
  std::vector<std::string> signatures;  // if they are kept

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
      if (count > before) symmetries[i] = of_boundary;  // without a filling nobody has looked
      add_from(fixing[i], json.at("fixing").at(i));
    }
    for (const ordered_json& signature : array_in(json.at("signatures")))
      signatures.push_back(signature.get<std::string>());
  }
};

int positive_index(const std::vector<int>& irregular) {
  int sum = 0;
  for (const int l : irregular) sum += std::max(4 - l, 0);
  return sum;
}

}  // namespace

SearchProblem search_problem(const std::vector<int>& sides, std::vector<int> irregular) {
  SearchProblem problem{{}, std::move(irregular)};
  for (const int side : sides) {
    if (problem.interior_quads.size() > kMostBoundary) break;  // what problem_with() refuses need not be written out
    problem.interior_quads.push_back(1);
    const auto rest = static_cast<std::size_t>(std::max(side - 1, 0));
    problem.interior_quads.insert(problem.interior_quads.end(), std::min(rest, kMostBoundary), 2);
  }
  return problem;
}

std::string problem_with(const SearchProblem& problem) {
  const std::size_t edges = problem.interior_quads.size();
  if (edges < 3) return "a boundary of " + std::to_string(edges) + " edges encloses no simple mesh";
  if (edges > kMostBoundary) return "a boundary of more than " + std::to_string(kMostBoundary) + " edges";
  for (const int quads : problem.interior_quads) {
    if (quads < 1 || quads > 100)
      return "a boundary vertex with " + std::to_string(quads) + " interior quads; expected 1..100";
  }
  for (const int l : problem.irregular) {
    if (l < 2 || l == 4 || l > 100) return "irregular valence " + std::to_string(l) + " is not in 2, 3, 5..100";
  }
  return "";
}

bool may_be_infinite(const SearchProblem& problem) { return positive_index(problem.irregular) >= 4; }

mesh::Region region_of(const Filling& filling) {
  mesh::Region region{mesh::QuadMesh::from_faces(filling.vertices, filling.faces), {}};
  region.root = region.mesh.find_half_edge(mesh::VertexId(0), mesh::VertexId(1));
  return region;
}

SearchOutcome search(const SearchProblem& problem, const SearchLimits& limits,
                     const std::function<void(const Filling&)>& visit) {
  SharedLimits shared(limits);
  SharedSearch frontier(starts_of(problem, shared), shared);
  SearchOutcome outcome;
  std::mutex mutex;
  frontier.follow(limits.threads, [&](const Filling& filling) {
    {
      const std::scoped_lock lock(mutex);
      ++outcome.count;
      ++outcome.by_faces[static_cast<int>(filling.faces.size())];
    }
    if (visit) visit(filling);
  });
  outcome.states = frontier.states();
  outcome.face_limit_cut = shared.face_limit_cut;
  outcome.out_of_time = !frontier.empty();
  return outcome;
}

CountedSearch count_fillings(const SearchProblem& problem, const SearchLimits& limits, bool keep_signatures,
                             const std::optional<SearchJournal>& journal) {
  SharedLimits shared(limits);
  SharedSearch frontier(starts_of(problem, shared), shared);
  std::mutex mutex;
  Tally noted, since;  // in the journal, and since that was written
  const auto visit = [&](const Filling& filling) {
    Tally one(filling, keep_signatures);
    const std::scoped_lock lock(mutex);
    since.add(std::move(one));
  };
  const auto news = [&] {
    ordered_json json = since.to_json();
    noted.add(std::exchange(since, {}));
    return json;
  };
  const auto take = [&](const ordered_json& json) { noted.add_from_json(json); };
  CountedSearch counted;
  counted.outcome.states = follow(frontier, shared, limits.threads, visit, journal, {news, take});
  noted.add(std::move(since));
  counted.outcome.count = noted.count;
  counted.outcome.by_faces = std::move(noted.by_faces);
  counted.outcome.face_limit_cut = shared.face_limit_cut;
  counted.outcome.out_of_time = !frontier.empty();
  // The sum of 1 / (length of the orbit) = (symmetries that fix the filling) / (symmetries of the boundary).
  counted.orbits = {noted.fixing[0] / noted.symmetries[0], noted.fixing[1] / noted.symmetries[1]};
  counted.signatures = std::move(noted.signatures);
  std::sort(counted.signatures.begin(), counted.signatures.end());
  return counted;
}

namespace {

// The partial meshes that a search for spheres starts from: one quad 0 1 2 3 with the rarest valence at 0; the hole is
// the outside, so its boundary runs 0 3 2 1. All valences of the other corners are tried.
std::vector<BacktrackingSearch> sphere_starts(const std::vector<int>& irregular, SharedLimits& shared) {
  std::map<int, int> count;
  for (const int l : irregular) ++count[l];
  const int rarest = std::min_element(count.begin(), count.end(), [](const auto& a, const auto& b) {
                       return a.second < b.second;
                     })->first;
  std::vector<int> choices{4};
  for (const auto& [valence, number] : count) choices.push_back(valence);
  std::vector<BacktrackingSearch> starts;
  for (const int l1 : choices) {
    for (const int l2 : choices) {
      for (const int l3 : choices) {
        std::vector<int> rest = irregular;
        bool affordable = true;
        for (const int l : {rarest, l1, l2, l3}) {
          if (l == 4) continue;
          const auto it = std::find(rest.begin(), rest.end(), l);
          affordable = affordable && it != rest.end();
          if (it != rest.end()) rest.erase(it);
        }
        if (!affordable) continue;
        BacktrackingSearch filler(rest, shared);
        std::array<int, 4> corner{};
        for (int& v : corner) v = filler.add_vertex();
        for (std::size_t i = 0; i < 4; ++i) filler.add_edge(corner[i], corner[(i + 1) % 4]);
        filler.add_face(corner);
        if (filler.open_hole(
                {{corner[0], rarest - 1}, {corner[3], l3 - 1}, {corner[2], l2 - 1}, {corner[1], l1 - 1}})) {
          starts.push_back(std::move(filler));
        }
      }
    }
  }
  return starts;
}

}  // namespace

SphereOutcome search_spheres(std::vector<int> irregular, int vertices, const SearchLimits& limits,
                             const std::optional<SearchJournal>& journal) {
  std::sort(irregular.begin(), irregular.end());
  int index = 0;
  for (const int l : irregular) {
    if (l < 2 || l == 4 || l > 100)
      throw std::invalid_argument("irregular valence " + std::to_string(l) + " is not in 2, 3, 5..100");
    index += 4 - l;
  }
  if (index != 8) {
    throw std::invalid_argument("the indices 4 - l of the irregular valences sum to " + std::to_string(index) +
                                ", but a sphere needs 8");
  }

  SphereOutcome outcome;
  std::mutex mutex;
  std::set<std::string> oriented, unoriented;
  std::vector<std::string> since;  // oriented signatures that are not yet in the journal
  const auto add = [&](const mesh::QuadMesh& m) {
    const int v = m.vertex_count();
    std::string own = mesh::canonical_signature(m, mesh::Orientation::kept);
    std::string either = std::min(own, mesh::canonical_signature(m, mesh::Orientation::mirrored));
    const std::scoped_lock lock(mutex);
    if (unoriented.insert(std::move(either)).second) ++outcome.counts[v];
    if (!oriented.insert(own).second) return;
    ++outcome.oriented_counts[v];
    if (journal) since.push_back(std::move(own));
  };
  const auto visit = [&](const Filling& filling) { add(mesh::QuadMesh::from_faces(filling.vertices, filling.faces)); };
  const auto news = [&] { return ordered_json(std::exchange(since, {})); };
  const auto take = [&](const ordered_json& json) {
    for (const ordered_json& signature : array_in(json)) add(mesh::from_signature(signature.get<std::string>()).mesh);
    since.clear();
  };

  SharedLimits shared(limits);
  shared.faces = std::min(vertices - 2, kMostFaces);
  SharedSearch frontier(sphere_starts(irregular, shared), shared);
  outcome.states = follow(frontier, shared, limits.threads, visit, journal, {news, take});
  outcome.signatures.assign(unoriented.begin(), unoriented.end());
  outcome.complete = frontier.empty();
  return outcome;
}

}  // namespace requad::enumerate
