// Hostile input and interruption of the programs. A program ends with one clear line and exit code 2, leaves nothing
// half written, and keeps to a limit of memory. The operating system enforces the limit (ulimit -v), except under
// AddressSanitizer, which reserves terabytes of addresses.
#include <algorithm>
#include <chrono>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/sanitizers.hpp"

using namespace requad;
using tests::call;
using tests::Outcome;
using tests::scratch;
using tests::shell;
using tests::slurp;
using tests::spill;
namespace fs = std::filesystem;

namespace {

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string memory(int kibibytes) { return tests::kSanitized ? "" : "ulimit -v " + std::to_string(kibibytes) + "; "; }

std::string path_of(const std::string& program) { return "'" REQUAD_PROGRAM_DIR "/requad-" + program + "'"; }

std::set<std::string> files() {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(scratch())) names.insert(entry.path().filename());
  return names;
}

// Checks a refusal: one line from the program that contains all of `parts`, exit code 2, no output and no new file.
void refused(const Outcome& outcome, const std::set<std::string>& before, const std::vector<std::string>& parts = {}) {
  INFO("code " << outcome.code << ", standard error: " << outcome.err);
  CHECK(outcome.code == 2);
  CHECK(outcome.out.empty());
  CHECK(tests::line_count(outcome.err) == 1);
  CHECK(outcome.err.starts_with("requad-"));
  for (const std::string& part : parts) CHECK(outcome.err.find(part) != std::string::npos);
  auto after = files();
  for (const char* ours : {"script", "stderr"}) after.erase(ours);
  auto left = before;
  for (const char* ours : {"script", "stderr"}) left.erase(ours);
  CHECK(after == left);
}

// A grid of n x n quads as OBJ.
std::string grid_text(int n) {
  std::string text;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) text += "v " + std::to_string(x) + ' ' + std::to_string(y) + " 0\n";
  }
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const int a = y * (n + 1) + x + 1;
      text += "f";
      for (const int v : {a, a + 1, a + n + 2, a + n + 1}) text += ' ' + std::to_string(v);
      text += '\n';
    }
  }
  return text;
}

}  // namespace

TEST_CASE("files that are no mesh are refused in one line", "[hostile]") {
  struct Input {
    const char* file;
    std::string text;
    std::string line;
    std::string reason;
  };
  std::string moebius = "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 2 0 0\nv 2 1 0\nv 3 0 0\nv 3 1 0\nv 4 0 0\nv 4 1 0\n";
  for (const char* face : {"1 3 4 2", "3 5 6 4", "5 7 8 6", "7 9 10 8", "9 2 1 10"})
    moebius += "f " + std::string(face) + "\n";
  const std::vector<Input> inputs{
      {"empty.obj", "", ":1:", "without a vertex or face"},
      {"empty.off", "", ":1:", "OFF is expected"},
      {"blank.obj", "\n\r\n  \n# nothing\n", ":", "without a vertex or face"},
      {"points.obj", kSquare, ":", "without a face"},
      {"billion.off", "OFF\n1000000000 1000000000 0\n0 0 0\n", ":2:", "1000000000 vertices"},
      {"billion-faces.off", "OFF\n1 1000000000 0\n0 0 0\n", ":2:", "1000000000 faces"},
      {"overflow.off", "OFF\n99999999999999999999 1 0\n0 0 0\n", ":2:", "too large"},
      {"negative.off", "OFF\n-4 1 0\n0 0 0\n", ":2:", "-4"},
      {"huge-index.obj", kSquare + "f 1 2 3 2000000000\n", ":5:", "vertex 2000000000 does not exist"},
      {"huger-index.obj", kSquare + "f 1 2 3 99999999999999999999\n", ":5:", "too large"},
      {"before-first.obj", kSquare + "f 1 2 3 -5\n", ":5:", "does not exist"},
      {"least-index.obj", kSquare + "f 1 2 3 -9223372036854775808\n", ":5:", "does not exist"},
      {"huge-polygon.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2000000000 0 1 2 3\n", ":7:", ""},
      {"repeated.obj", kSquare + "f 1 2 2 4\n", ":5:", "twice"},
      {"comma.obj", "v 0,5 0 0\n" + kSquare + "f 1 2 3 4\n", ":1:", "'0,5' is not a number"},
      {"not-a-number.obj", "v nan 0 0\n" + kSquare + "f 1 2 3 4\n", ":1:", "nan"},
      {"infinite.obj", "v 1e999 0 0\n" + kSquare + "f 1 2 3 4\n", ":1:", "1e999"},
      {"moebius.obj", moebius, ":", "Moebius"},
      {"book.obj", kSquare + "v 0 0 1\nv 1 0 1\nv 0 0 2\nv 1 0 2\nf 1 2 3 4\nf 2 1 5 6\nf 1 2 8 7\n",
       ":11:", "3 faces"},
      {"bow-tie.obj", kSquare + "v -1 0 0\nv -1 -1 0\nv 0 -1 0\nf 1 2 3 4\nf 1 5 6 7\n", ":9:", "not manifold"},
      {"turned.obj", kSquare + "v 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 3 6 5\n", ":8:", ""},
      {"zeros.obj", std::string(1000, '\0'), ":", "zero byte"},
      {"name with blanks.obj", "v\n", "name with blanks.obj:1:", "expected"},
  };
  for (const Input& input : inputs) {
    INFO(input.file);
    spill(scratch() / input.file, input.text);
    const auto before = files();
    const std::string name = "'" + std::string(input.file) + "'";
    for (const std::string& command :
         {"info " + name, "subdivide " + name + " -o out.obj", "reduce " + name + " -o out.obj --json out.json"}) {
      refused(shell(memory(400000) + path_of("edit") + " " + command), before,
              {std::string(input.file) + ":", input.line, input.reason});
    }
    refused(shell(memory(400000) + path_of("enumerate") + " signature " + name), before, {input.reason});
  }
}

TEST_CASE("strange or long arguments are refused in one line", "[hostile]") {
  const auto before = files();
  // An end of line in an argument, in a file's name, and in the name of an option.
  refused(shell(path_of("enumerate") + " search --irregular 3,3 --sides $'6,\\n6'"), before,
          {"'?6' is not an integer"});
  refused(shell(path_of("edit") + " info $'no\\nfile.obj'"), before, {"no?file.obj: cannot be read"});
  refused(shell(path_of("edit") + " info $'--no\\noption'"), before, {"--no?option"});
  // A boundary of 200 million edges in 14 kB.
  std::string sides = "100000";
  for (int i = 1; i < 2000; ++i) sides += ",100000";
  refused(shell(memory(400000) + path_of("enumerate") + " search --irregular '' --sides " + sides), before,
          {"more than 10000 edges"});
}

TEST_CASE("a mesh is read, however it is written", "[hostile]") {
  const auto text_of = [](const std::string& name) { return call("edit", "info '" + name + "' --json -").out; };
  spill(scratch() / "unix.obj", kSquare + "f 1 2 3 4\n");
  std::string crlf;
  for (const char c : kSquare + "f 1 2 3 4\n") crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  spill(scratch() / "crlf.obj", crlf);
  spill(scratch() / "two words.obj", kSquare + "f 1 2 3 4\n");
  const std::string expected = text_of("unix.obj");
  CHECK(expected.find("\"faces\":1") != std::string::npos);
  CHECK(text_of("crlf.obj") == expected);
  CHECK(text_of("two words.obj") == expected);
  CHECK(call("edit", "subdivide 'two words.obj' -o 'three more words.obj'").code == 0);
  CHECK(fs::exists(scratch() / "three more words.obj"));
  // Thousands of components.
  std::string many;
  for (int i = 0; i < 5000; ++i) {
    const std::string x = std::to_string(2 * i), y = std::to_string(2 * i + 1);
    many += "v " + x + " 0 0\nv " + y + " 0 0\nv " + y + " 1 0\nv " + x + " 1 0\nf -4 -3 -2 -1\n";
  }
  spill(scratch() / "many.obj", many);
  CHECK(text_of("many.obj").find("\"faces\":5000") != std::string::npos);
  const auto before = files();
  refused(call("enumerate", "signature many.obj"), before, {"5000 components"});
}

TEST_CASE("garbage without end on a pipe is refused at once, in bounded memory", "[hostile]") {
  REQUIRE(mkfifo((scratch() / "pipe.obj").c_str(), 0600) == 0);
  REQUIRE(mkfifo((scratch() / "pipe.off").c_str(), 0600) == 0);
  const auto before = files();
  // The writer ends by SIGPIPE when the program has had enough.
  for (const char* name : {"pipe.obj", "pipe.off"}) {
    refused(shell("(timeout 60 cat /dev/zero >" + std::string(name) + ") 2>/dev/null & " + memory(200000) +
                  path_of("edit") + " info " + name),
            before, {"zero byte"});
    refused(shell("(timeout 60 head -c 10G /dev/urandom >" + std::string(name) + ") 2>/dev/null & " + memory(200000) +
                  path_of("edit") + " info " + name),
            before, {"zero byte"});
  }
  if (tests::kSanitized) return;
  refused(
      shell("(timeout 60 yes garbage >pipe.obj) 2>/dev/null & " + memory(200000) + path_of("edit") + " info pipe.obj"),
      before, {"does not fit into memory"});
}

TEST_CASE("numbers near the largest integer are refused", "[hostile]") {
  const std::string limits = memory(2000000);
  const auto before = files();
  for (const char* n : {"2147483647", "2147483648", "4294967297", "9223372036854775807", "9223372036854775808",
                        "-9223372036854775808", "99999999999999999999999"}) {
    const std::string number = n;
    INFO(number);
    const std::string enumerate = limits + path_of("enumerate") + " ";
    refused(shell(enumerate + "region digon " + number + " 1 1,1"), before);
    refused(shell(enumerate + "region hexagon 1 1 1,1,1,1,1," + number), before);
    refused(shell(enumerate + "graph --pair 3-3 --sides " + number + "," + number), before);
    refused(shell(enumerate + "path --pair 3-3 --from 1,1 --to 3,1 --sides " + number + "," + number), before);
    refused(shell(enumerate + "path --pair 3-3 --sides 8,8 --to 5,1 --from 1," + number), before);
    refused(shell(enumerate + "search --irregular 3,3 --sides " + number + "," + number), before);
    refused(shell(enumerate + "search --sides 6,6 --irregular 3," + number), before);
    refused(shell(enumerate + "sphere --irregular 3,3,3,3,3,3,3,3 --vertices 8.." + number), before);
    refused(shell(limits + path_of("verify") + " --claim T2 --digon=" + number), before);
    refused(shell(limits + path_of("verify") + " --claim T4 --quad-perimeter=" + number), before);
    refused(shell(limits + path_of("figures") + " --figure 10 --side=" + number), before);
    refused(shell(limits + path_of("enumerate") + " graph --pair 3-3 --sides 4,4 --threads=" + number), before);
  }
}

TEST_CASE("if an output cannot be written, the old file stays", "[hostile]") {
  spill(scratch() / "in.obj", grid_text(40));
  spill(scratch() / "old.obj", "the old text");
  const auto before = files();
  const std::string edit = path_of("edit") + " subdivide in.obj -o ";
  // The folder does not exist, the file is a folder, or the folder is a file.
  refused(shell(edit + "nowhere/out.obj"), before, {"nowhere/out.obj", "No such file"});
  refused(shell(edit + "."), before, {"folder"});
  refused(shell(edit + "in.obj/out.obj"), before, {"Not a directory"});
  refused(shell(edit + std::string(300, 'x')), before, {"too long"});
  // A full device stays a device.
  refused(shell(edit + "/dev/full"), before, {"/dev/full"});
  refused(shell(path_of("edit") + " info in.obj >/dev/full"), before, {"standard output"});
  CHECK(fs::is_character_file("/dev/full"));
  // Two outputs cannot go to one file, even by two names of it. They can go to a device.
  refused(shell(edit + "out --json out"), before, {"two outputs cannot both go to out"});
  refused(shell(edit + "out --json ./out"), before, {"two outputs cannot both go to out"});
  refused(shell(edit + "''"), before, {"a file's name is expected"});
  CHECK(shell(edit + "/dev/null --json /dev/null").code == 0);
  CHECK(shell(edit + "nowhere/out.obj --help").code == 0);
  // The refusal comes before the work, which would take hours.
  refused(shell("timeout 20 " + path_of("verify") + " --digon 3..100 --hexagon 3..40 --json nowhere/report.json"),
          before, {"nowhere/report.json", "No such file"});
  refused(shell("timeout 20 " + path_of("enumerate") + " sphere --irregular 3,3,3,3,3,3,3,3 --vertices 8..60 --json ."),
          before, {"folder"});
  refused(shell("timeout 20 " + path_of("verify") + " --hexagon 3..40 --certificate in.obj/proof"), before,
          {"in.obj/proof", "in.obj is not a folder"});
  refused(shell("timeout 20 " + path_of("figures") + " --side 40 -o in.obj/pictures"), before,
          {"in.obj/pictures", "in.obj is not a folder"});
  refused(shell("timeout 20 " + path_of("figures") + " --figure 2 -o in.obj"), before, {"in.obj is not a folder"});
  refused(shell("timeout 20 " + path_of("verify") + " --failures " + std::string(300, 'x')), before,
          {"is not a folder"});
  // A limit of 1 KiB on the size of files stands for a disk that becomes full.
  for (const char* name : {"out.obj", "old.obj"}) {
    refused(shell("ulimit -f 1; " + edit + name), before, {name, "too large"});
    CHECK(slurp(scratch() / "old.obj") == "the old text");
  }
  refused(shell("ulimit -f 1; " + path_of("figures") + " --figure 10 --side 12 --format svg -o ."), before,
          {"figure-10-side-12.svg", "too large"});
  // If one output has no room, the others are not written either, even if they are small: a script, or a small figure.
  spill(scratch() / "old.txt", "the old script");
  const auto with_script = files();
  refused(shell("ulimit -f 8; " + path_of("edit") +
                " move '" REQUAD_SOURCE_DIR "/mesh/examples/figure-17.obj' 153 163 --step slide_first" +
                " --script old.txt -o out.obj"),
          with_script, {"out.obj", "too large"});
  CHECK(slurp(scratch() / "old.txt") == "the old script");
  CHECK(shell(path_of("edit") + " move '" REQUAD_SOURCE_DIR "/mesh/examples/figure-17.obj' 153 163 --step slide_first" +
              " --script short.txt -o - >long.obj")
            .code == 0);
  CHECK(fs::file_size(scratch() / "short.txt") < 8192);
  refused(shell("ulimit -f 30; " + path_of("figures") + " --figure 10 --side 12 --format dot --format svg -o ."),
          files(), {"figure-10-side-12.", "too large"});
  // The output is a pipe with the name of a file.
  CHECK((shell(edit + "/dev/stdout --quiet | cat").out == shell(edit + "-").out));
  // A folder without the permission to write. Root may write anywhere, unless this right is taken away.
  fs::create_directory(scratch() / "locked");
  spill(scratch() / "locked/kept.obj", "kept");
  fs::permissions(scratch() / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  const std::string as_user = geteuid() == 0 ? "setpriv --bounding-set=-dac_override " : "";
  refused(shell(as_user + edit + "locked/kept.obj"), files(), {"Permission denied"});
  CHECK(slurp(scratch() / "locked/kept.obj") == "kept");
  fs::permissions(scratch() / "locked", fs::perms::owner_all);
}

namespace {

// What a run wrote, without the seconds that it took.
std::string timeless(const std::string& text) {
  static const std::regex seconds("\"seconds\":[-+.e0-9]+");
  return std::regex_replace(text, seconds, "");
}

// Kills a command at many moments of its run. Checks that the file is as it was before, or as the whole run writes it.
// If the signal can be caught, no other file may be left. Returns the number of runs that were cut short.
int interrupt(const std::string& command, const std::string& output, const char* signal) {
  const fs::path target = scratch() / output;
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  REQUIRE(shell(command).code == 0);
  const std::chrono::duration<double> whole = Clock::now() - start;
  const std::string fresh = timeless(slurp(target));
  REQUIRE(!fresh.empty());
  const auto before = files();
  int cut = 0;
  constexpr int kMoments = tests::kSanitized ? 6 : 12;
  for (int i = 1; i <= kMoments; ++i) {
    spill(target, "old");
    const double seconds = whole.count() * 1.1 * i / kMoments;
    const Outcome outcome = shell("timeout -s " + std::string(signal) + " " + std::to_string(seconds) + " " + command);
    const std::string now = timeless(slurp(target));
    INFO(signal << " after " << seconds << " s: code " << outcome.code << ", " << now.size() << " bytes");
    CHECK((now == "old" || now == fresh));
    cut += now == "old" ? 1 : 0;
    if (std::string(signal) != "KILL") CHECK(files() == before);
  }
  return cut;
}

}  // namespace

TEST_CASE("an interrupted run leaves the old file or the new one", "[hostile]") {
  spill(scratch() / "in.obj", grid_text(60));
  for (const char* signal : {"KILL", "INT", "TERM"}) {
    CHECK(interrupt(path_of("edit") + " subdivide in.obj -o out.obj", "out.obj", signal) > 0);
  }
  CHECK(interrupt(path_of("edit") + " reduce '" REQUAD_SOURCE_DIR
                                    "/mesh/examples/figure-17.obj' --feature-angle 40 -o out.obj",
                  "out.obj", "INT") > 0);
  CHECK(interrupt(path_of("enumerate") + " search --sides 6,6,6 --irregular 3,3,5 --json search.json", "search.json",
                  "KILL") > 0);
  CHECK(interrupt(path_of("verify") + " --claim T2 --digon 3..6 --json report.json >/dev/null", "report.json", "INT") >
        0);
  CHECK(interrupt(path_of("figures") + " --figure 10 --side 10 --format svg -o .", "figure-10-side-10.svg", "KILL") >
        0);
}

TEST_CASE("the list of figures may go into their new folder, and figures may be named twice", "[hostile]") {
  CHECK(shell(path_of("figures") +
              " --figure 2 --figure 2 --format svg --format svg -o new/pictures --json new/pictures/list.json")
            .code == 0);
  CHECK(fs::exists(scratch() / "new/pictures/figure-2.svg"));
  CHECK(slurp(scratch() / "new/pictures/list.json").find("figure-2.svg") != std::string::npos);
  refused(shell(path_of("figures") + " --figure 2 -o newer --json nowhere/list.json"), files(), {"nowhere/list.json"});
}

TEST_CASE("a run that is out of memory reports no failed claim", "[hostile]") {
  if (tests::kSanitized) return;
  const Outcome outcome = shell("ulimit -v 120000; " + path_of("verify") +
                                " --claim T2 --method moves --digon 95..100 --threads 1 --quiet --journal run.journal");
  CHECK(outcome.code == 3);
  CHECK(outcome.err == "requad-verify: out of memory\n");
  CHECK(outcome.out.empty());
  CHECK(slurp(scratch() / "run.journal").find("digon 95..100") != std::string::npos);
  CHECK(slurp(scratch() / "run.journal").find("violation") == std::string::npos);
}

TEST_CASE("a signal ends the certificates' checker, and its errors have one line", "[hostile]") {
  // This checker waits for its manifest forever.
  fs::create_directory(scratch() / "waiting");
  REQUIRE(mkfifo((scratch() / "waiting/MANIFEST").c_str(), 0600) == 0);
  for (const char* signal : {"INT", "TERM", "HUP"})
    CHECK(shell("timeout -k 5 -s " + std::string(signal) + " 1 " + path_of("verify") + " check waiting").code == 124);
  const auto before = files();
  refused(shell(path_of("verify") + " check $'no\nsuch'"), before, {"no?such/MANIFEST"});
  REQUIRE(call("verify", "--claim T2 --digon 3..4 --certificate proof --quiet").code == 0);
  refused(shell(path_of("verify") + " check proof >/dev/full"), files(), {"standard output"});
}
