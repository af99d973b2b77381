// Exhaustive search: every way to fill a boundary with quads. It knows no theorem about pairs.
//
// Terms
//   problem   a boundary and a budget. The boundary states for each of its vertices, counter-clockwise, how many quads
//             the vertex gets inside. The budget is the multiset of interior valences other than 4.
//   filling   a simple quadrangulated disk with this boundary whose interior irregular vertices have exactly these
//             valences. Simple: no two edges join the same two vertices.
//   hole      a part of the inside that has no quads yet. The search starts with one hole and fills it quad by quad.
//
// Law enumerate-4   search() produces every filling precisely once up to isomorphism that fixes every boundary vertex.
//
// Degenerate problems are not errors: an odd boundary, or one whose turns do not fit the budget, has no filling. If a
// limit was reached, the outcome is incomplete, and its count is a lower bound.
//
// Method. A rule, which depends on the partial mesh alone, chooses an edge of a hole. The quad on this edge has two
// more corners. Each is either a new vertex, whose valence is chosen from the remaining budget, or a vertex of the
// hole's boundary. A corner on the boundary cuts the hole: two or three holes remain. A filling determines each of
// these choices. So the search finds no filling twice and need not compare fillings. A branch ends in one of four
// cases:
//   - A hole has an odd number of edges.
//   - Discrete Gauss-Bonnet requires an index that no part of the remaining budget has.
//   - An edge would be doubled.
//   - The face limit cannot be kept. A hole of n edges takes at least n/2 - 1 quads.
//
// If the positive indices 4 - l of the budget sum to 4 or more, these vertices can cap a tube, and the tube can have
// any length. The number of fillings may then be infinite, and a search without a face limit does not end.
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
  std::vector<int> interior_quads;  // for each boundary vertex, at most 10000 of them: 1..100
  std::vector<int> irregular;       // valences in 2..100, none of them 4
};

// The boundary with these sides: one quad at the corner that starts each side, two quads elsewhere. Sides are >= 1.
SearchProblem search_problem(const std::vector<int>& sides, std::vector<int> irregular);
// One line on what is wrong with a problem; "" if nothing is.
std::string problem_with(const SearchProblem& problem);
// Why there can be no filling, in words: the boundary has an odd number of edges, or the indices do not sum to what
// discrete Gauss-Bonnet asks for. "" if neither is so; then the search has to find out.
std::string impossibility(const SearchProblem& problem);
// What problem_with() says of the irregular valences alone.
std::string irregular_problem(const std::vector<int>& irregular);
// Whether the number of fillings can be infinite. If so, a search without a face limit may not end.
bool may_be_infinite(const SearchProblem& problem);

// The largest face limit. Only a search that lengthens a tube without end reaches it. Such a search then needs about
// 300 bytes of memory for each face and thread.
inline constexpr int kMostFaces = 100000;

// Rules that end a branch early if it contains no filling. No rule changes what is found. If a rule is off, a branch
// may have no end unless there is a face limit.
struct SearchPruning {
  bool gauss_bonnet = true;  // the index that a hole requires is the sum of some part of the budget
  bool parity = true;        // every hole has an even number of edges
  bool face_bound = true;    // the face limit leaves n/2 - 1 quads for each hole of n edges
};

// Told how many more states were met, and an estimate of their share of all the work; or, once, how many the journal
// has from before. From any thread.
using SearchProgress = std::function<void(std::int64_t states, double share, bool before)>;

struct SearchLimits {
  std::optional<int> faces;  // the largest number of faces of a filling; at most kMostFaces
  std::optional<double> seconds;
  int threads = 0;  // 0: as many as there are cores
  SearchProgress progress;
  SearchPruning pruning;
};

struct Filling {
  int vertices = 0;  // the boundary vertices come first, in the order of the problem
  std::vector<std::array<int, 4>> faces;
};
// The filling as a region, rooted at the boundary edge from vertex 0 to vertex 1. O(F log F).
mesh::Region region_of(const Filling& filling);

struct SearchOutcome {
  std::int64_t count = 0;
  std::map<int, std::int64_t> by_faces;
  std::int64_t states = 0;      // quads placed, over all branches, with a filling or without
  bool face_limit_cut = false;  // a branch ended at the face limit: there may be larger fillings
  bool out_of_time = false;
  // Whether every filling was found.
  bool complete() const { return !face_limit_cut && !out_of_time; }
};

// Calls visit for every filling, from several threads at once and in no fixed order unless limits.threads is 1. `visit`
// may be empty. Throws std::invalid_argument if problem_with() finds something wrong.
SearchOutcome search(const SearchProblem& problem, const SearchLimits& limits,
                     const std::function<void(const Filling&)>& visit);

// A file that keeps what was found and what remains (mesh/program/run/journal_file.hpp has the format). If a search was
// killed or ran out of time, another call with its journal continues it, and the final result is the same. A search
// appends to its journal whenever its running time has grown by one hundredth. A kill loses only what came after the
// last record.
struct SearchJournal {
  std::string path;
  // A line that tells runs apart. It must name everything that changes the search or its result, so neither the number
  // of threads nor the seconds.
  std::string run;
  double least_seconds = 0.1;  // between two appends
};

// The number of orbits of the fillings under the symmetries of the boundary: the sum of 1 / (length of the orbit) over
// all fillings.
struct OrbitCount {
  std::int64_t rotations = 0;    // under the rotations that keep the boundary
  std::int64_t reflections = 0;  // under those and the reflections that keep it
};
struct CountedSearch {
  SearchOutcome outcome;
  OrbitCount orbits;                    // of the fillings that were found; meaningful if all were
  std::vector<std::string> signatures;  // of all fillings, sorted; empty unless they were asked for
};
// Counts the fillings. Throws as search() does, and program::UsageError if it cannot continue from the journal.
CountedSearch count_fillings(const SearchProblem& problem, const SearchLimits& limits, bool keep_signatures,
                             const std::optional<SearchJournal>& journal = {});

}  // namespace requad::enumerate
