#include "enumerate/search/journaled_search.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh/program/run/journal_file.hpp"

namespace requad::enumerate {

using nlohmann::ordered_json;
using program::integer_from;
using program::JournalFile;

namespace {

using Clock = SearchControl::Clock;
using Seconds = std::chrono::duration<double>;

// SharedSearch::remaining() as it stands in a record.
std::vector<std::vector<int>> remaining_in(const ordered_json& json) {
  std::vector<std::vector<int>> remaining;
  for (const ordered_json& subtree : array_in(json)) {
    std::vector<int>& numbers = remaining.emplace_back();
    for (const ordered_json& number : array_in(subtree))
      numbers.push_back(static_cast<int>(integer_from(number, 0, std::numeric_limits<int>::max())));
  }
  return remaining;
}

}  // namespace

const ordered_json::array_t& array_in(const ordered_json& json) { return json.get_ref<const ordered_json::array_t&>(); }

void add_from(std::int64_t& sum, const ordered_json& json) {
  sum += integer_from(json, 0, std::numeric_limits<std::int64_t>::max() - sum);
}

std::int64_t run_with_journal(SharedSearch& search, SearchControl& control, int threads,
                              const BacktrackingSearch::Visit& visit, const std::optional<SearchJournal>& journal,
                              const JournaledResults& results) {
  if (!journal) {
    search.run(threads, visit);
    return search.states();
  }
  std::int64_t states = 0;
  std::optional<std::vector<std::vector<int>>> remaining;
  JournalFile file(journal->path, "requad-enumerate", journal->run, [&](const ordered_json& record) {
    results.add_earlier(record.at("found"));
    add_from(states, record.at("states"));
    if (record.at("face_limit_cut").get<bool>()) control.face_limit_cut = true;
    remaining = remaining_in(record.at("left"));
  });
  if (remaining) {
    try {
      search.set_remaining(*remaining);
    } catch (const std::invalid_argument& error) {
      file.refuse(std::string("what is left in the last line is nothing of this search: ") + error.what());
    }
  }
  if (control.progress) control.progress(states, 1 - search.remaining_share(), /*before=*/true);
  const auto start = Clock::now();
  // Each run makes some progress, however little time it has.
  for (bool late = false; !search.done() && !late; late = control.deadline && Clock::now() > *control.deadline) {
    const Seconds wait = std::max(Seconds(Clock::now() - start) / 100, Seconds(journal->least_seconds));
    control.pause = Clock::now() + std::chrono::duration_cast<Clock::duration>(wait);
    search.run(threads, visit);
    states += search.states();
    file.append({{"found", results.take_new()},
                 {"states", search.states()},
                 {"face_limit_cut", control.face_limit_cut.load()},
                 {"left", search.remaining()}});
  }
  return states;
}

}  // namespace requad::enumerate
