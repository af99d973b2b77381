// Journals: JSON in lines with checksums.
//
// No fuzzer guesses a checksum: a line that starts with { gets its own. Others stay as they are.
#include "verify/journal.hpp"

#include <array>
#include <cstdio>
#include <memory>

#include <boost/crc.hpp>
#include <sys/mman.h>
#include <unistd.h>

#include "mesh/validate.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace requad;

const fuzz::Memory fuzz::kMemory{32 << 10, 400};

namespace {

constexpr std::size_t kCases = 4;
constexpr std::size_t kClaims = 2;

std::string with_checksums(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (line.starts_with('{')) {
      boost::crc_32_type crc;
      crc.process_bytes(line.data(), line.size());
      std::array<char, 10> digits{};
      std::snprintf(digits.data(), digits.size(), "%08x ", crc.checksum());
      result += digits.data();
    }
    result += line;
    text.remove_prefix(line.size());
    if (text.empty()) break;
    result += '\n';
    text.remove_prefix(1);
  }
  return result;
}

// A file in memory, which a journal opens by its path.
class File {
 public:
  explicit File(const std::string& text) : descriptor_(memfd_create("journal", 0)) {
    fuzz::require(descriptor_ >= 0 && write(descriptor_, text.data(), text.size()) == static_cast<ssize_t>(text.size()),
                  "no file in memory");
  }
  ~File() { close(descriptor_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

}  // namespace

void fuzz::try_input(std::string_view text) {
  const File file(with_checksums(text));
  std::unique_ptr<verify::Journal> journal;
  const auto open = [&] { journal = std::make_unique<verify::Journal>(file.path(), "a run", kCases, kClaims); };
  if (!accepts(open)) return;
  auto results = std::move(journal->results());
  for (const auto& [index, result] : results) {
    require(index < kCases && result.judgements.size() == kClaims, "a result of nothing");
    for (const verify::Judgement& j : result.judgements) {
      if (!j.violation || !j.violation->mesh) continue;
      const mesh::Region& region = *j.violation->mesh;
      require(mesh::validate(region.mesh).empty() && region.mesh.is_live(region.root), "the mesh is not valid");
    }
  }
  // It is there to be written on: under the numbers that are free, what it holds already, or a result that says
  // nothing.
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
  require(accepts(open), "a journal can not be opened again");
  require(journal->results().size() == expected.size(), "results are lost");
  for (const auto& [index, result] : journal->results())
    require(to_json(result).dump() == expected.at(index), "a result reads differently");
}
