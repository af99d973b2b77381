#include "verify/journal.hpp"

#include <limits>
#include <utility>

#include "mesh/program/run/errors.hpp"

namespace requad::verify {

Journal::Journal(std::string path, const std::string& run, std::size_t cases, std::size_t claims)
    : file_(std::move(path), "requad-verify", run, [&](const program::JournalFile::Record& record) {
        const auto index = static_cast<std::size_t>(
            program::integer_from(record.at("case"), 0, std::numeric_limits<std::int64_t>::max()));
        if (index >= cases) throw program::UsageError("there is no case " + std::to_string(index));
        if (!results_.emplace(index, case_result(record.at("result"), claims)).second)
          throw program::UsageError("case " + std::to_string(index) + " stands here twice");
      }) {}

void Journal::append(std::size_t index, const CaseResult& result) {
  file_.append({{"case", index}, {"result", to_json(result)}});
}

}  // namespace requad::verify
