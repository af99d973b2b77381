// Exhaustive search for closed spheres.
//
// Law enumerate-5   search_spheres() produces every simple quadrangulation of the sphere whose irregular vertices have
//                   exactly the given valences, up to a given number of vertices, precisely once up to isomorphism.
// The number of vertices is V = faces + 2. A sphere is represented by its canonical signature. The smallest one is two
// quads with a common boundary (four v2s, V = 4).
//
// Method. Each sphere is cut open at one quad of a vertex with the rarest irregular valence. The rest is a hole, which
// the method of search.hpp fills. A sphere is found once for each such quad, up to its symmetries. Signatures tell
// spheres apart, so memory grows with the number of spheres.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "enumerate/search/search.hpp"

namespace requad::enumerate {

struct SphereOutcome {
  std::map<int, std::int64_t> counts;           // by V; mirror images count as one sphere
  std::map<int, std::int64_t> oriented_counts;  // by V; they count as two
  std::vector<std::string> signatures;          // one for both mirror images, the lesser; sorted
  std::int64_t states = 0;                      // quads placed, over all branches
  bool complete = true;                         // false: out of time
};
// `vertices` is the largest V. limits.faces has no effect. Throws std::invalid_argument for a valence below 2, above
// 100, or 4, and for indices 4 - l that do not sum to 8, since no sphere has these. Throws program::UsageError if it
// cannot continue from the journal.
SphereOutcome search_spheres(const std::vector<int>& irregular, int vertices, const SearchLimits& limits,
                             const std::optional<SearchJournal>& journal = {});

}  // namespace requad::enumerate
