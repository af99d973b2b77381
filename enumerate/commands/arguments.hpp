// Arguments and results that several commands of requad-enumerate have in common.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "enumerate/search/search.hpp"
#include "mesh/program/program.hpp"
#include "mesh/program/run/progress.hpp"
#include "mesh/topology/region.hpp"
#include "theory/region_shape.hpp"

namespace requad::enumerate {

// --- regions with a pair ---------------------------------------------------------------------------------------------

// Says on standard error why there is no filling, whatever --quiet says: an empty result needs its reason.
void report_impossible(const std::string& why);
// Whether the sides of --sides have an odd sum, so that no mesh has this boundary. Reports that.
bool reports_odd_boundary(const program::Options& options);

// The options --sides and --pair.
std::vector<program::Option> pair_region_options();
// Their values: the pair alone, or the shape of the region. Throw UsageError if a value is missing or wrong, or if an
// exploration of the region would need more memory than is reasonable.
theory::PairType required_pair(const program::Options& options);
// Throws UsageError if the pair is none of the three that have moves.
void require_moves(theory::PairType type);
theory::RegionShape required_shape(const program::Options& options);

// The option -o, which names an OBJ file for the region that finish() writes.
program::Option mesh_output();

// --- searches --------------------------------------------------------------------------------------------------------

// The options --irregular, --list, --limit-seconds and --journal.
std::vector<program::Option> search_options();
// The values of --irregular; '' means none. Throws UsageError.
std::vector<int> irregular_valences(const program::Options& options);
// The limits that --limit-seconds, --max-faces and --threads give. `progress` must outlive the search.
SearchLimits search_limits(const program::Options& options, program::Progress& progress);
// The journal that --journal names, or nothing without --journal. `run` describes the run. The result of the run must
// depend on nothing but `run` and this build.
std::optional<SearchJournal> search_journal(const program::Options& options, const std::string& run);

// --- values and results ----------------------------------------------------------------------------------------------

std::vector<int> as_ints(const theory::IntegerVector& values);
// The integers of an option, each in 0..100000. Throws UsageError.
std::vector<int> required_ints(const program::Options& options, const std::string& name);
// Prints each text on a line of its own.
std::string lines_of(const std::vector<std::string>& texts);

// Ends a command as program::finish() does. Writes the region to the file of -o if that is given.
void finish(const program::Options& options, const nlohmann::ordered_json& summary, const std::string& text,
            const mesh::Region* region = nullptr, const std::string& comment = "");

}  // namespace requad::enumerate
