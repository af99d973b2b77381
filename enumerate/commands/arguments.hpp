// What several commands of requad-enumerate take from their arguments, and how they end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "enumerate/search/search.hpp"
#include "mesh/program/program.hpp"
#include "mesh/program/progress.hpp"
#include "mesh/topology/region.hpp"
#include "theory/region_shape.hpp"

namespace requad::enumerate {

// --- regions with a pair ---------------------------------------------------------------------------------------------

// --sides and --pair.
std::vector<program::Option> pair_region_options();
// Their values: the pair alone, or the shape of the region. Throw UsageError if one is missing or wrong, and if exploring
// the region would keep more in memory than is reasonable.
theory::PairType required_pair(const program::Options& options);
theory::RegionShape required_shape(const program::Options& options);

// --- searches --------------------------------------------------------------------------------------------------------

// --irregular, --list, --limit-seconds and --journal.
std::vector<program::Option> search_options();
// The values of --irregular; none for ''. Throws UsageError.
std::vector<int> irregular_valences(const program::Options& options);
// --limit-seconds, --max-faces and --threads. `progress` must outlive the search.
SearchLimits search_limits(const program::Options& options, program::Progress& progress);
// The journal of --journal, if it is given, for the run of this build that `run` describes. The result must depend on
// nothing else.
std::optional<SearchJournal> search_journal(const program::Options& options, const std::string& run);

// --- values and results ----------------------------------------------------------------------------------------------

std::vector<int> as_ints(const theory::IntegerVector& values);
// The integers of an option, each in 0..100000. Throws UsageError.
std::vector<int> required_ints(const program::Options& options, const std::string& name);
// Each text on a line.
std::string lines_of(const std::vector<std::string>& texts);

// Ends a command as program::finish() does, and writes the region to -o if that is given.
void finish(const program::Options& options, const nlohmann::ordered_json& summary, const std::string& text,
            const mesh::Region* region = nullptr, const std::string& comment = "");

}  // namespace requad::enumerate
