#include "enumerate/search/spheres.hpp"

#include <algorithm>
#include <array>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "enumerate/search/journaled_search.hpp"
#include "mesh/topology/signature.hpp"

namespace requad::enumerate {

using nlohmann::ordered_json;

namespace {

void require_sphere(const std::vector<int>& irregular) {
  if (const std::string problem = irregular_problem(irregular); !problem.empty()) throw std::invalid_argument(problem);
  int index = 0;
  for (const int l : irregular) index += 4 - l;
  if (index != 8) {
    throw std::invalid_argument("the indices 4 - l of the irregular valences sum to " + std::to_string(index) +
                                ", but a sphere needs 8");
  }
}

int rarest_valence(const std::vector<int>& irregular) {
  std::map<int, int> count;
  for (const int l : irregular) ++count[l];
  return std::min_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

// The irregular valences without those of the first quad's corners. Nothing if the former do not contain the latter.
std::optional<std::vector<int>> without(std::vector<int> irregular, const std::array<int, 4>& corners) {
  for (const int l : corners) {
    if (l == 4) continue;
    const auto it = std::find(irregular.begin(), irregular.end(), l);
    if (it == irregular.end()) return std::nullopt;
    irregular.erase(it);
  }
  return irregular;
}

// One quad 0 1 2 3 whose corners have these valences, and the hole outside it, whose boundary runs 0 3 2 1.
PartialMesh one_quad(const std::array<int, 4>& valences, const std::vector<int>& rest) {
  PartialMesh mesh(rest);
  std::array<int, 4> corners{};
  for (int& v : corners) v = mesh.add_vertex();
  for (std::size_t i = 0; i < 4; ++i) mesh.add_edge(corners[i], corners[(i + 1) % 4]);
  mesh.add_face(corners);
  std::vector<PartialMesh::BoundaryVertex> ring;
  for (const std::size_t i : {0U, 3U, 2U, 1U}) ring.push_back({corners[i], valences[i] - 1});
  mesh.open_hole(ring);
  return mesh;
}

// The searches to start with. Vertex 0 of the first quad has the rarest valence. All valences of its other corners are
// tried.
std::vector<BacktrackingSearch> starts_of(const std::vector<int>& irregular, SearchControl& control) {
  std::vector<int> choices{4};
  for (const int l : std::set<int>(irregular.begin(), irregular.end())) choices.push_back(l);
  const int rarest = rarest_valence(irregular);
  std::vector<BacktrackingSearch> starts;
  for (const int l1 : choices) {
    for (const int l2 : choices) {
      for (const int l3 : choices) {
        const std::array<int, 4> corners{rarest, l1, l2, l3};
        const auto rest = without(irregular, corners);
        if (!rest) continue;
        PartialMesh start = one_quad(corners, *rest);
        if (may_be_filled(start, control.pruning)) starts.emplace_back(std::move(start), control);
      }
    }
  }
  return starts;
}

// The spheres that were found and, with a journal, those of them that the journal does not have yet.
class FoundSpheres {
 public:
  explicit FoundSpheres(bool with_journal) : with_journal_(with_journal) {}

  // Safe from any thread.
  void add(const mesh::QuadMesh& sphere) {
    std::string own = mesh::canonical_signature(sphere, mesh::Orientation::kept);
    std::string either = std::min(own, mesh::canonical_signature(sphere, mesh::Orientation::mirrored));
    const int v = sphere.vertex_count();
    const std::scoped_lock lock(mutex_);
    if (unoriented_.insert(std::move(either)).second) ++outcome_.counts[v];
    if (!oriented_.insert(own).second) return;
    ++outcome_.oriented_counts[v];
    if (with_journal_) new_.push_back(std::move(own));
  }

  ordered_json take_new() { return ordered_json(std::exchange(new_, {})); }
  void add_earlier(const ordered_json& json) {
    for (const ordered_json& signature : array_in(json)) add(mesh::from_signature(signature.get<std::string>()).mesh);
    new_.clear();
  }

  SphereOutcome outcome() && {
    outcome_.signatures.assign(unoriented_.begin(), unoriented_.end());
    return std::move(outcome_);
  }

 private:
  const bool with_journal_;
  std::mutex mutex_;
  SphereOutcome outcome_;
  std::set<std::string> oriented_, unoriented_;
  std::vector<std::string> new_;  // of oriented_
};

}  // namespace

SphereOutcome search_spheres(const std::vector<int>& irregular, int vertices, const SearchLimits& limits,
                             const std::optional<SearchJournal>& journal) {
  require_sphere(irregular);
  SearchControl control(limits);
  control.most_faces = std::min(vertices - 2, kMostFaces);
  SharedSearch search(starts_of(irregular, control), control);
  FoundSpheres found(journal.has_value());
  const auto visit = [&](const Filling& filling) {
    found.add(mesh::QuadMesh::from_faces(filling.vertices, filling.faces));
  };
  const std::int64_t states =
      run_with_journal(search, control, limits.threads, visit, journal,
                       {[&] { return found.take_new(); }, [&](const ordered_json& json) { found.add_earlier(json); }});
  SphereOutcome outcome = std::move(found).outcome();
  outcome.states = states;
  outcome.complete = search.done();
  return outcome;
}

}  // namespace requad::enumerate
