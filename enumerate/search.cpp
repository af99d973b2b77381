#include "enumerate/search.hpp"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>

#include "enumerate/filler.hpp"
#include "enumerate/threads.hpp"
#include "mesh/signature.hpp"

namespace requad::enumerate {

namespace {

// Runs a prepared filler on several threads. The first one starts alone; whoever has nothing to do waits for what the
// others hand over of theirs. Their parts differ by orders of magnitude, so none could be cut to size beforehand.
class ParallelRun {
 public:
  ParallelRun(const Filler& start, const Filler::Visit& visit) : visit_(visit) {
    waiting_.push_back(start);
    sharing_.take = [this](const Filler& part) {
      const std::scoped_lock lock(mutex_);
      waiting_.push_back(part);
      sharing_.wanted = false;
      changed_.notify_one();
    };
  }

  std::int64_t run(int threads) {
    const auto workers = static_cast<std::size_t>(thread_count(threads));
    run_on_threads(workers, threads, [this](std::size_t) { work(); });
    return states_;
  }

 private:
  void work() {
    std::unique_lock lock(mutex_);
    for (;;) {
      if (!waiting_.empty()) {
        // The one that came last is the nearest to the root. A copy of this thread's own: what two threads write lies apart.
        Filler part = waiting_.back();
        waiting_.pop_back();
        ++running_;
        lock.unlock();
        std::int64_t states = 0;
        try {
          states = part.run(visit_, &sharing_);
        } catch (...) {  // out of a visit: the others must not wait for this one
          end_part(lock, 0);
          throw;
        }
        end_part(lock, states);
      } else if (running_ == 0) {
        return;
      } else {
        sharing_.wanted = true;
        changed_.wait(lock);
      }
    }
  }

  void end_part(std::unique_lock<std::mutex>& lock, std::int64_t states) {
    lock.lock();
    states_ += states;
    if (--running_ == 0) changed_.notify_all();
  }

  const Filler::Visit& visit_;
  Filler::Sharing sharing_;
  std::mutex mutex_;  // of all below
  std::condition_variable changed_;
  std::vector<Filler> waiting_;
  int running_ = 0;
  std::int64_t states_ = 0;
};

std::int64_t run_parallel(const Filler& start, int threads, const Filler::Visit& visit) {
  if (thread_count(threads) == 1) return Filler(start).run(visit);
  return ParallelRun(start, visit).run(threads);
}

constexpr std::size_t kMostBoundary = 10000;

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
  if (const std::string what = problem_with(problem); !what.empty()) throw std::invalid_argument(what);
  SharedLimits shared(limits);
  Filler filler(problem.irregular, shared);
  std::vector<Filler::BoundaryVertex> boundary;
  for (const int quads : problem.interior_quads) boundary.push_back({filler.add_vertex(), quads});
  const int length = static_cast<int>(boundary.size());
  for (int i = 0; i < length; ++i) filler.add_edge(i, (i + 1) % length);

  SearchOutcome outcome;
  std::mutex mutex;
  const Filler::Visit record = [&](const Filling& filling) {
    {
      const std::scoped_lock lock(mutex);
      ++outcome.count;
      ++outcome.by_faces[static_cast<int>(filling.faces.size())];
    }
    if (visit) visit(filling);
  };
  // The whole budget has to fit, not only a part of it.
  int index = 4;
  for (const int quads : problem.interior_quads) index -= 2 - quads;
  for (const int l : problem.irregular) index -= 4 - l;
  if (index == 0 && filler.open_hole(boundary)) outcome.states = run_parallel(filler, limits.threads, record);
  outcome.face_limit_cut = shared.face_limit_cut;
  outcome.out_of_time = shared.stop;
  return outcome;
}

CountedSearch count_fillings(const SearchProblem& problem, const SearchLimits& limits, bool keep_signatures) {
  CountedSearch counted;
  std::mutex mutex;
  // Sums of 1 / (orbit length) = (symmetries that fix the filling) / (symmetries of the boundary).
  std::int64_t fixed_by_rotations = 0, rotations = 1, fixed_by_all = 0, all = 1;
  counted.outcome = search(problem, limits, [&](const Filling& filling) {
    const mesh::Region region = region_of(filling);
    std::string own = mesh::signature(region);
    const auto rotated = mesh::rotated_signatures(region);
    const auto reflected = mesh::reflected_signatures(region);
    const auto fixing = std::count(rotated.begin(), rotated.end(), own);
    const auto fixing_reflections = std::count(reflected.begin(), reflected.end(), own);
    const std::scoped_lock lock(mutex);
    rotations = static_cast<std::int64_t>(rotated.size());
    all = static_cast<std::int64_t>(rotated.size() + reflected.size());
    fixed_by_rotations += fixing;
    fixed_by_all += fixing + fixing_reflections;
    if (keep_signatures) counted.signatures.push_back(std::move(own));
  });
  counted.orbits = {fixed_by_rotations / rotations, fixed_by_all / all};
  std::sort(counted.signatures.begin(), counted.signatures.end());
  return counted;
}

SphereOutcome search_spheres(std::vector<int> irregular, int vertices, const SearchLimits& limits) {
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
  std::map<int, int> count;
  for (const int l : irregular) ++count[l];
  const int rarest = std::min_element(count.begin(), count.end(), [](const auto& a, const auto& b) {
                       return a.second < b.second;
                     })->first;

  SphereOutcome outcome;
  std::mutex mutex;
  std::set<std::string> oriented, unoriented;
  std::map<int, std::int64_t> oriented_counts, counts;
  const Filler::Visit record = [&](const Filling& filling) {
    const mesh::QuadMesh m = mesh::QuadMesh::from_faces(filling.vertices, filling.faces);
    std::string own = mesh::canonical_signature(m, mesh::Orientation::kept);
    std::string either = std::min(own, mesh::canonical_signature(m, mesh::Orientation::mirrored));
    const std::scoped_lock lock(mutex);
    if (oriented.insert(std::move(own)).second) ++oriented_counts[filling.vertices];
    if (unoriented.insert(std::move(either)).second) ++counts[filling.vertices];
  };

  SharedLimits shared(limits);
  shared.faces = std::min(vertices - 2, kMostFaces);
  // One quad 0 1 2 3 with the rarest valence at 0; the hole is the outside, so its boundary runs 0 3 2 1. All valences
  // of the other corners are tried.
  std::vector<int> choices{4};
  for (const auto& [valence, number] : count) choices.push_back(valence);
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
        Filler filler(rest, shared);
        std::array<int, 4> corner{};
        for (int& v : corner) v = filler.add_vertex();
        for (std::size_t i = 0; i < 4; ++i) filler.add_edge(corner[i], corner[(i + 1) % 4]);
        filler.add_face(corner);
        if (filler.open_hole(
                {{corner[0], rarest - 1}, {corner[3], l3 - 1}, {corner[2], l2 - 1}, {corner[1], l1 - 1}})) {
          outcome.states += run_parallel(filler, limits.threads, record);
        }
      }
    }
  }
  outcome.counts = std::move(counts);
  outcome.oriented_counts = std::move(oriented_counts);
  outcome.signatures.assign(unoriented.begin(), unoriented.end());
  outcome.complete = !shared.stop;
  return outcome;
}

}  // namespace requad::enumerate
