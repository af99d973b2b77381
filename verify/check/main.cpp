// requad-verify-check: checks certificates again. `requad-verify check DIR` starts it.
//
// This program shares no code with the programs that make certificates, and uses the C++ standard library alone. It has
// a reader of its own (reading.hpp), the regions and the closed forms (region.hpp), a mesh that is a list of faces
// (disk.hpp), labels traced on it (labels.hpp), what a move is (moves.hpp), and a count of all fillings (fillings.hpp).
// certificate.hpp says what the certificate of one region shows, manifest.hpp what a folder of them shows.
//
// Exit code: 0 all certificates hold, 1 one does not hold, 2 one cannot be read, 3 undecided: a limit was reached.

#include <iostream>
#include <new>

#include "verify/check/manifest.hpp"

namespace {

constexpr int kHolds = 0, kDoesNotHold = 1, kBadInput = 2, kUndecided = 3;

// Prints exactly one line on standard error, even if names of files contain line breaks.
void report(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = '?';
  }
  std::cerr << "requad-verify-check: " << text << "\n";
}

void print(const std::vector<check::FamilyCounts>& families) {
  long long certificates = 0;
  for (const auto& f : families) certificates += f.counts.regions;
  std::cout << certificates << " certificates hold\n";
  for (const auto& f : families) {
    std::cout << f.family->name << ", " << f.family->size << " " << f.first << ".." << f.last << ": "
              << f.counts.regions << " regions with " << f.counts.configurations << " configurations, "
              << f.counts.merged << " merged vertices and " << f.counts.edges << " moves; " << f.empty
              << " regions without\n";
  }
}

int check_and_print(const std::string& folder) {
  try {
    print(check::check_folder(folder));
    return kHolds;
  } catch (const check::Rejected& rejected) {
    report(rejected.what());
    return kDoesNotHold;
  } catch (const check::Unreadable& unreadable) {
    report(unreadable.what());
    return kBadInput;
  } catch (const check::Undecided& undecided) {
    report(undecided.what());
  } catch (const std::bad_alloc&) {
    report("out of memory");
  }
  return kUndecided;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    report("expected one folder; see --help");
    return kBadInput;
  }
  const std::string first = argv[1];
  int code = kHolds;
  if (first == "--help") {
    std::cout << R"(requad-verify-check: checks certificates again

Usage:
  requad-verify-check DIR

DIR is a folder that `requad-verify --certificate DIR` wrote. This program has no
code in common with requad-verify. `requad-verify check DIR` starts it.

Exit code: 0 all certificates hold, 1 one does not hold, 2 one cannot be read,
3 undecided: a limit was reached

Examples:
  requad-verify --claim T2 --digon 3..8 --certificate proof && requad-verify-check proof
)";
  } else {
    code = check_and_print(first);
  }
  std::cout.flush();
  if (std::cout) return code;
  report("standard output cannot be written");
  return kBadInput;
}
