// Journals of searches: what was found, and what is left, as guiding paths.
#include <nlohmann/json.hpp>

#include "enumerate/search/search.hpp"
#include "enumerate/search/spheres.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/journal_in_memory.hpp"

using namespace requad;
using enumerate::CountedSearch;
using enumerate::SphereOutcome;

// Found fillings are counted, and found spheres are kept as signatures. Each subtree that is left needs a partial mesh.
const fuzz::Memory fuzz::kMemory{256 << 10, 4000};

void fuzz::try_input(std::string_view text) {
  enumerate::SearchLimits limits;
  limits.threads = 1;
  const auto problem = enumerate::search_problem({4, 4, 4}, {3, 3, 5});
  {
    const JournalInMemory file(text);
    const enumerate::SearchJournal journal{file.path(), "a run"};
    CountedSearch found, again;
    if (accepts([&] { found = count_fillings(problem, limits, true, journal); })) {
      require(found.outcome.complete() || found.outcome.face_limit_cut, "there was time for all");
      // The journal of a complete search gives the same result again.
      require(accepts([&] { again = count_fillings(problem, limits, true, journal); }),
              "a search cannot be continued from its journal");
      require(again.outcome.count == found.outcome.count && again.outcome.by_faces == found.outcome.by_faces &&
                  again.outcome.states == found.outcome.states && again.signatures == found.signatures &&
                  again.orbits.rotations == found.orbits.rotations &&
                  again.orbits.reflections == found.orbits.reflections,
              "a journal does not say again what was found");
    }
  }
  const JournalInMemory file(text);
  const enumerate::SearchJournal journal{file.path(), "a run"};
  const std::vector<int> octahedrite(8, 3);
  SphereOutcome found, again;
  if (!accepts([&] { found = search_spheres(octahedrite, 10, limits, journal); })) return;
  require(accepts([&] { again = search_spheres(octahedrite, 10, limits, journal); }),
          "a search cannot be continued from its journal");
  require(again.signatures == found.signatures && again.states == found.states,
          "a journal does not say again what was found");
}
