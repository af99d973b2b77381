// Exhaustive search: every way to fill a hole with quads, without any theorem about pairs.
//
// A problem is a boundary and a budget: the number of interior quads at each boundary vertex, counter-clockwise, and
// the multiset of interior valences other than 4.
//
// Contract. search() produces every simple quadrangulated disk with this boundary whose interior irregular vertices
// have exactly these valences, precisely once up to isomorphism that fixes every boundary vertex. Simple: no two edges
// join the same two vertices. Degenerate cases are answered, not refused: an odd boundary, or one whose turns do not
// fit the budget, has no filling. A limit that was reached makes the outcome incomplete: its count is then a lower
// bound.
//
// How. The hole is filled from its boundary inward. A rule that looks at the partial mesh only chooses an edge of a
// hole; the quad on it has two more corners, each a new vertex (whose valence is chosen from what the budget still has)
// or a vertex of the hole's boundary, which cuts the hole in two or three. A mesh determines these choices one by one,
// so no mesh is met twice and none is compared with another. A branch ends when a hole is odd, when discrete
// Gauss-Bonnet asks for an index that no part of the remaining budget has, when an edge would be doubled, or when the
// face limit can not be kept (a hole of n edges takes at least n/2 - 1 quads).
//
// A budget whose positive indices (4 - l) sum to 4 or more can close a tube: the number of fillings may be infinite,
// and a face limit is then the only end.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mesh/topology/region.hpp"

namespace requad::enumerate {

struct SearchProblem {
  std::vector<int> interior_quads;  // per boundary vertex, at most 10000 of them, each 1..100
  std::vector<int> irregular;       // each 2..100 and not 4
};

// The boundary with these sides: one quad at the corner that starts each side, two elsewhere. Sides >= 1.
SearchProblem search_problem(const std::vector<int>& sides, std::vector<int> irregular);
// One line on what is wrong with a problem, or "".
std::string problem_with(const SearchProblem& problem);
// True if the number of fillings can be infinite, so that a search without a face limit may not end.
bool may_be_infinite(const SearchProblem& problem);

// No search looks for fillings of more faces than this: it is what bounds the memory of a search that follows a tube
// without end (some 300 bytes a face and thread). Any other search ends by itself long before.
inline constexpr int kMostFaces = 100000;

// Rules that end branches without a filling early. None changes what is found; but with a rule off, branches may go on
// without end unless there is a face limit.
struct SearchPruning {
  bool gauss_bonnet = true;  // the index that a hole asks for is the sum of some part of the budget
  bool parity = true;        // every hole has an even number of edges
  bool face_bound = true;    // the face limit has to leave each hole of n edges n/2 - 1 quads
};

struct SearchLimits {
  std::optional<int> faces;  // fillings with more faces are not looked for; at most kMostFaces
  std::optional<double> seconds;
  int threads = 0;                             // 0: all cores
  std::function<void(std::int64_t)> progress;  // told now and then how many states were visited since; from any thread
  SearchPruning pruning;
};

// A filling: vertices 0..boundary-1 are the boundary, counter-clockwise.
struct Filling {
  int vertices = 0;
  std::vector<std::array<int, 4>> faces;
};
// As a region, rooted at the boundary edge from vertex 0 to vertex 1.
mesh::Region region_of(const Filling& filling);

struct SearchOutcome {
  std::int64_t count = 0;
  std::map<int, std::int64_t> by_faces;
  std::int64_t states = 0;      // quads placed, over all branches, whether a filling came of them or not
  bool face_limit_cut = false;  // a branch ended at the face limit: there may be larger fillings
  bool out_of_time = false;
  // Every filling was found (up to the face limit, if that cut a branch).
  bool complete() const { return !face_limit_cut && !out_of_time; }
};

// Calls visit for every filling; from several threads at once unless limits.threads is 1, and then in no fixed order.
// `visit` may be empty. Throws std::invalid_argument if problem_with() has something to say.
SearchOutcome search(const SearchProblem& problem, const SearchLimits& limits,
                     const std::function<void(const Filling&)>& visit);

// A file that keeps what was found and what is left, so that a search that was killed, or out of time, goes on when it is
// called again, and ends with the same result (journal_file.hpp has the format). A search writes it each time another
// hundredth of its time has passed, a tenth of a second at least, and that is what a kill can lose.
struct SearchJournal {
  std::string path;
  // A line that tells runs apart: whatever changes the search or its result, but not its threads or seconds.
  std::string run;
  double least_seconds = 0.1;
};

// The number of orbits of fillings under the rotations that keep the boundary, and under its rotations and reflections,
// found in passing: each filling counts 1 / (length of its orbit).
struct OrbitCount {
  std::int64_t rotations = 0;
  std::int64_t reflections = 0;
};
struct CountedSearch {
  SearchOutcome outcome;
  OrbitCount orbits;
  std::vector<std::string> signatures;  // of all fillings, sorted; empty unless asked for
};
// Throws as search() does, and program::UsageError for a journal that can not be gone on with.
CountedSearch count_fillings(const SearchProblem& problem, const SearchLimits& limits, bool keep_signatures,
                             const std::optional<SearchJournal>& journal = {});

// --- closed spheres --------------------------------------------------------------------------------------------------

// Every simple quadrangulation of the sphere whose irregular valences are exactly these, by number of vertices V =
// faces + 2, precisely once up to isomorphism. `counts` takes mirror images as one, `oriented_counts` as two. The
// search starts from one quad at a vertex of the rarest irregular valence; what it finds more than once, from other
// roots, is told apart by canonical signatures.
struct SphereOutcome {
  std::map<int, std::int64_t> counts;  // by vertices
  std::map<int, std::int64_t> oriented_counts;
  std::vector<std::string> signatures;  // canonical, mirror images as one; sorted
  std::int64_t states = 0;
  bool complete = true;  // false: out of time
};
// vertices: the largest V. Throws std::invalid_argument for valences < 2 or = 4, or an index sum other than 8 (then
// there is no sphere at all and the message says so), and program::UsageError for a journal that can not be gone on with.
SphereOutcome search_spheres(std::vector<int> irregular, int vertices, const SearchLimits& limits,
                             const std::optional<SearchJournal>& journal = {});

}  // namespace requad::enumerate
