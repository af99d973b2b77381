// A search that keeps a journal, so that it can be stopped and resumed.
//
// Internal: not installed.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include <nlohmann/json.hpp>

#include "enumerate/search/search.hpp"
#include "enumerate/search/shared_search.hpp"

namespace requad::enumerate {

// How the results of a search get into its journal and out of it.
struct JournaledResults {
  std::function<nlohmann::ordered_json()> take_new;                // those since the last call
  std::function<void(const nlohmann::ordered_json&)> add_earlier;  // those that take_new() gave in an earlier run
};

// Searches all that remains, until it is done or out of time, and returns the number of states. With a journal it first
// goes to where the journal stands (the states of earlier runs count, too), and then stops now and then to append to it.
// Throws program::UsageError for a journal that cannot be gone on with.
std::int64_t run_with_journal(SharedSearch& search, SearchControl& control, int threads,
                              const BacktrackingSearch::Visit& visit, const std::optional<SearchJournal>& journal,
                              const JournaledResults& results);

// Reading a journal's record; both throw if it is not as it should be.
// An array, and nothing else that can be iterated over.
const nlohmann::ordered_json::array_t& array_in(const nlohmann::ordered_json& json);
// Adds an integer that is not negative and fits.
void add_from(std::int64_t& sum, const nlohmann::ordered_json& json);

}  // namespace requad::enumerate
