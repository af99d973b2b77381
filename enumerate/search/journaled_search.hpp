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

// Functions that write the results of a search to its journal and read them back.
struct JournaledResults {
  std::function<nlohmann::ordered_json()> take_new;                // those since the last call
  std::function<void(const nlohmann::ordered_json&)> add_earlier;  // those that take_new() gave in an earlier run
};

// Searches what remains until it is done or out of time. Returns the number of states, those of earlier runs included.
// With a journal it starts from the journal's last record, and pauses from time to time to append to the journal.
// Throws program::UsageError if it cannot continue from the journal.
std::int64_t run_with_journal(SharedSearch& search, SearchControl& control, int threads,
                              const BacktrackingSearch::Visit& visit, const std::optional<SearchJournal>& journal,
                              const JournaledResults& results);

// Both read a part of a journal's record and throw if it is malformed.
// Requires an array, and nothing else that can be iterated over.
const nlohmann::ordered_json::array_t& array_in(const nlohmann::ordered_json& json);
// Adds an integer, which must not be negative and must fit.
void add_from(std::int64_t& sum, const nlohmann::ordered_json& json);

}  // namespace requad::enumerate
