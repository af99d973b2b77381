// Journals of campaigns: JSON in lines with checksums.
#include "verify/journal.hpp"

#include <memory>

#include "mesh/topology/validate.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/journal_in_memory.hpp"

using namespace requad;

const fuzz::Memory fuzz::kMemory{32 << 10, 400};

namespace {

constexpr std::size_t kCases = 4;
constexpr std::size_t kClaims = 2;

}  // namespace

void fuzz::try_input(std::string_view text) {
  const JournalInMemory file(text);
  std::unique_ptr<verify::Journal> journal;
  const auto open = [&] { journal = std::make_unique<verify::Journal>(file.path(), "a run", kCases, kClaims); };
  if (!accepts(open)) return;
  auto results = std::move(journal->results());
  for (const auto& [index, result] : results) {
    require(index < kCases && result.judgements.size() <= kClaims, "a result of nothing");
    for (const verify::ClaimJudgement& judged : result.judgements) {
      const verify::Judgement& j = judged.judgement;
      require(judged.claim < kClaims, "a claim of nothing");
      if (!j.violation || !j.violation->mesh) continue;
      const mesh::Region& region = *j.violation->mesh;
      require(mesh::validate(region.mesh).empty() && region.mesh.is_live(region.root), "the mesh is not valid");
    }
  }
  // The journal must accept more results. Free numbers get a result that it already has, or an empty one.
  const verify::CaseResult more =
      results.empty()
          ? verify::case_result({{"study_seconds", 0.5}, {"claims", nlohmann::ordered_json::array()}}, kClaims)
          : results.begin()->second;
  std::map<std::size_t, std::string> expected;
  for (const auto& [index, result] : results) expected[index] = to_json(result).dump();
  for (std::size_t i = 0; i < kCases; ++i) {
    if (expected.count(i) > 0) continue;
    journal->append(i, more);
    expected[i] = to_json(more).dump();
  }
  journal.reset();
  require(accepts(open), "a journal cannot be opened again");
  require(journal->results().size() == expected.size(), "results are lost");
  for (const auto& [index, result] : journal->results())
    require(to_json(result).dump() == expected.at(index), "a result reads differently");
}
