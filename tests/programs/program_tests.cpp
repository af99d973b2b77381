// The programs from outside: exit codes, one clear line for bad input, and no file that is half written.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"

using namespace requad::tests;
namespace fs = std::filesystem;

TEST_CASE("help and version", "[programs]") {
  for (const std::string program : {"enumerate", "verify", "figures", "edit"}) {
    const Outcome help = call(program, "--help");
    CHECK(help.code == 0);
    CHECK(help.out.find("Examples:") != std::string::npos);
    CHECK(help.err.empty());
    const Outcome version = call(program, "--version");
    CHECK(version.code == 0);
    CHECK(version.out.rfind("requad-" + program + " ", 0) == 0);
  }
}

TEST_CASE("bad arguments give one line on stderr, nothing on stdout, and exit code 2", "[programs]") {
  const std::vector<std::pair<std::string, std::string>> calls{
      {"enumerate", ""},
      {"enumerate", "dance"},
      {"enumerate", "--no-such-option"},
      {"enumerate", "region"},
      {"enumerate", "region triangle 1 1 1,1"},
      {"enumerate", "region digon 1 1 0,1"},  // zero strips
      {"enumerate", "region digon 0 0 1,1"},
      {"enumerate", "region digon -- -1 1 1,1"},
      {"enumerate", "region digon 1 x 1,1"},
      {"enumerate", "region digon 1 1 1,1,1"},
      {"enumerate", "region digon 1 1 1,"},
      {"enumerate", "region digon 99999999999999999999 1 1,1"},  // overflow
      {"enumerate", "region digon 9000000000000000000 1 1,1"},
      {"enumerate", "region digon 900000 900000 1,1"},
      {"enumerate", "region digon 1 1 1,1 --generator magic"},
      {"enumerate", "region digon 1 1 1,1 -o /no/such/folder/x.obj"},
      {"enumerate", "graph --pair 3-3"},
      {"enumerate", "graph --sides 6,6"},
      {"enumerate", "graph --sides 6,6 --pair 4-4"},
      {"enumerate", "graph --sides 6,6,6 --pair 3-3"},
      {"enumerate", "graph --sides 0,6 --pair 3-3"},
      {"enumerate", "graph --sides 6,6 --pair 3-3 --format poem"},
      {"enumerate", "graph --sides 6,6 --pair 3-3 extra"},
      {"enumerate", "path --sides 8,8 --pair 3-3 --from 1,1"},
      {"enumerate", "path --sides 8,8 --pair 3-3 --from 1,1 --to 2,1"},
      {"enumerate", "path --sides 8,8 --pair 3-3 --from 1,1 --to 7,1"},
      {"enumerate", "path --sides 5,5,5,5,5,5 --pair 5-5 --from 1,0 --to 0,1,1"},
      {"enumerate", "graph --sides 1000000,1000000 --pair 3-3"},  // more than memory holds
      {"enumerate", "path --sides 1000000,1000000 --pair 3-3 --from 1,1 --to 2,2"},
      {"enumerate", "graph --sides 6,6 --pair 3-3 --from 1,1"},  // an option of another command
      {"enumerate", "graph --sides 6,6 --pair 3-3 --threads foo"},
      {"enumerate", "graph --sides 6,6 --pair 3-3 --json - -o -"},
      {"enumerate", "search --sides 6,6"},
      {"enumerate", "search --irregular 3,3"},
      {"enumerate", "search --sides 6,6 --irregular 3,4"},
      {"enumerate", "search --sides 6,6 --irregular 1"},
      {"enumerate", "search --sides 0,6 --irregular 3,3"},
      {"enumerate", "search --interior-quads 2,2,2,2,2,2 --irregular 3,3,3,3"},  // no end without a limit
      {"enumerate", "sphere --irregular 3,3,3 --vertices 8..9"},                 // indices do not sum to 8
      {"enumerate", "sphere --irregular 3,3,3,3,3,3,3,3"},
      {"enumerate", "signature --from-signature zzz"},
      {"verify", "--failures /no/such/folder"},
      {"verify", "--claim T99"},
      {"verify", "--digon 2..5"},  // L < 3
      {"verify", "--digon 9..5"},
      {"verify", "--digon 3..x"},
      {"verify", "--digon 3..99999999999999999999"},
      {"verify", "--threads 0"},
      {"verify", "--method guess"},
      {"verify", "T2"},
      {"figures", "--figure 99"},
      {"figures", "--format bmp"},
      {"figures", "--side 2"},
      {"figures", "--pair-region 1,2,3"},
      {"figures", "--pair-region 0,0,3,3"},
      {"figures", "--figure 2 --format dot"},
      {"figures", "--figure hexagon --sides 4,4,4"},
      {"figures", "--figure hexagon --sides 1,1,1,1,1,9"},
      {"figures", "--figure hexagon --sides 4,4,4,4,4,99"},
      {"figures", "-o /dev/null/x"}};
  for (const auto& [program, arguments] : calls) {
    INFO("requad-" << program << " " << arguments);
    const Outcome outcome = call(program, arguments);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(line_count(outcome.err) == 1);
    CHECK(outcome.err.rfind("requad-" + program + ": ", 0) == 0);
  }
}

TEST_CASE("a boundary of odd length has no filling: each command says so and why, and ends well", "[programs]") {
  for (const std::string command :
       {"graph --sides 6,7 --pair 3-3", "graph --sides 6,7 --pair 3-3 --format dot",
        "graph --sides 3,3,3,3,3,4 --pair 5-5 --format graphml", "search --sides 6,7 --irregular 3,3",
        "path --sides 6,7 --pair 3-3 --from 1,1 --to 2,2"}) {
    INFO(command);
    const Outcome outcome = call("enumerate", command);
    CHECK(outcome.code == 0);
    CHECK(outcome.err.find("odd sum") != std::string::npos);
    CHECK(line_count(outcome.err) == 1);
    CHECK(outcome.out.find("signature") == std::string::npos);
  }
  CHECK(call("enumerate", "graph --sides 6,7 --pair 3-3").out.find(R"("nodes":[],"edges":[])") != std::string::npos);
}

TEST_CASE("a region that is too large to be drawn is refused at -o, and described without it", "[programs]") {
  const Outcome drawn = call("enumerate", "region digon 600 600 1,1 -o large.obj");
  CHECK(drawn.code == 2);
  CHECK(drawn.err.find("can be drawn") != std::string::npos);
  CHECK(call("enumerate", "region digon 600 600 1,1").code == 0);
}

TEST_CASE("what a result lacks is said in one line", "[programs]") {
  CHECK(call("enumerate", "graph --sides 6,6 --pair 3-3").err ==
        "requad-enumerate: left out: 1 configuration in which the pair is merged, and 1 edge to it; --with-apex adds "
        "them\n");
  CHECK(call("enumerate", "graph --sides 6,6 --pair 3-3 --with-apex").err.empty());
  CHECK(call("enumerate", "graph --sides 5,5 --pair 3-3").err.empty());
  spill(scratch() / "unused.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 2 3 4 5\n");
  CHECK(call("edit", "smooth unused.obj -o smooth.obj").err ==
        "requad-edit: unused.obj: 1 vertex in no face, left out\n");
  CHECK(call("edit", "subdivide unused.obj -o fine.obj").err.empty());  // all vertices keep their numbers
  CHECK(slurp(scratch() / "fine.obj").starts_with("v 9 9 9\n"));
  CHECK(call("enumerate", "signature unused.obj").err ==
        "requad-enumerate: unused.obj: vertices in no face, left out: 1\n");
  CHECK(call("verify", "--claim T1 --claim T2 --digon 3 --other-perimeter 4..5 --certificate none --quiet")
            .err.find("regions with one or three irregular vertices have none\n") != std::string::npos);
}

TEST_CASE("requad-enumerate graph: the counts of the theorems", "[programs]") {
  const auto nodes = [](const std::string& arguments) {
    const Outcome outcome = call("enumerate", "graph " + arguments);
    REQUIRE(outcome.code == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    CHECK(json["components"] == (json["nodes"].empty() ? 0 : 1));
    return json["nodes"].size();
  };
  CHECK(nodes("--sides 9,9 --pair 3-3 --format json") == 16);  // tau(9) = 4^2
  CHECK(nodes("--sides 6,6 --pair 3-3") == 6);                 // tau(6) = 3 * 2
  CHECK(nodes("--sides 6,6 --pair 3-3 --with-apex") == 7);
  CHECK(nodes("--sides 5,5,5,5,5,5 --pair 5-5") == 12);  // 3 * 2^2
  CHECK(nodes("--sides 5,4,4,7 --pair 3-5") == 6);       // M N = 3 * 2
  CHECK(nodes("--sides 5,9 --pair 3-3") == 4);           // tau(min)
  CHECK(nodes("--sides 5,4,5,4 --pair 3-5") == 0);       // a rectangle
}

TEST_CASE("requad-enumerate region and path write whole files", "[programs]") {
  const Outcome made = call("enumerate", "region hexagon 1 2 1,1,2,1,1,1 -o region.obj --json region.json");
  CHECK(made.code == 0);
  const auto json = nlohmann::json::parse(slurp(scratch() / "region.json"));
  CHECK(json["faces"] == 18);
  const std::string obj = slurp(scratch() / "region.obj");
  CHECK(std::count(obj.begin(), obj.end(), 'f') >= 18);
  CHECK(!fs::exists(scratch() / "region.obj.part"));
  const std::string signature = json["signature"];
  for (const std::string generator : {"grow", "moves"}) {
    const Outcome other = call("enumerate", "region hexagon 1 2 1,1,2,1,1,1 --json - --generator " + generator);
    CHECK(nlohmann::json::parse(other.out)["signature"] == signature);
  }
  const Outcome path = call("enumerate", "path --sides 8,8 --pair 3-3 --from 1,1 --to 5,1 --json -");
  CHECK(path.code == 0);
  CHECK(nlohmann::json::parse(path.out)["path"].size() == 5);
}

TEST_CASE("requad-enumerate search, sphere and signature", "[programs]") {
  const auto json_of = [](const std::string& arguments, int code) {
    const Outcome outcome = call("enumerate", arguments + " --json -");
    INFO(arguments << outcome.err);
    REQUIRE(outcome.code == code);
    return nlohmann::json::parse(outcome.out);
  };
  const auto seven = json_of("search --sides 7,7 --irregular 3,3", 0);  // Theorem 7.2: N^2 with N = 3
  CHECK(seven["count"] == 9);
  CHECK(seven["complete"] == true);
  const auto mixed = json_of("search --sides 6,6,6 --irregular 3,3,5 --list", 0);
  CHECK(mixed["count"] == 75);
  CHECK(mixed["fillings"].size() == 75);
  CHECK(mixed["orbits"]["rotations"] == 25);  // none has a threefold symmetry
  // If it is proven that there is no filling, the result is not undecided.
  CHECK(json_of("search --sides 7,6 --irregular 3,3", 0)["count"] == 0);
  CHECK(json_of("search --sides 5,4,5,4 --irregular 3,5", 0)["count"] == 0);
  CHECK(json_of("search --sides 5,4,5,4 --irregular ''", 0)["count"] == 1);
  const auto capped = json_of("search --interior-quads 2,2,2,2,2,2 --irregular 3,3,3,3 --max-faces 12", 3);
  CHECK(capped["count"].is_null());
  CHECK(capped["complete"] == false);
  // OEIS A111361 and plantri's counts.
  const auto spheres = json_of("sphere --irregular 3,3,3,3,3,3,3,3 --vertices 8..20", 0);
  const std::vector<int> expected{1, 0, 1, 1, 2, 1, 5, 2, 8, 5, 12, 8, 25};
  for (int v = 8; v <= 20; ++v)
    CHECK(spheres["counts"][std::to_string(v)] == expected[static_cast<std::size_t>(v - 8)]);
  const auto cube = json_of("sphere --irregular 3,3,3,3,3,3,3,3 --vertices 8 --list", 0);
  const std::string text = cube["spheres"][0];
  const auto rebuilt = json_of("signature --from-signature " + text, 0);
  CHECK(rebuilt["vertices"] == 8);
  CHECK(rebuilt["closed"] == true);
  CHECK(rebuilt["canonical"] == text);
}

TEST_CASE("output follows links, and does not replace pipes and devices", "[programs]") {
  fs::create_symlink("linked.json", scratch() / "link.json");
  CHECK(call("enumerate", "graph --sides 6,6 --pair 3-3 -o link.json").code == 0);
  CHECK(fs::is_symlink(scratch() / "link.json") == true);
  const std::string pipe = (scratch() / "pipe").string();
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  const std::string copy = (scratch() / "copy").string();
  // First comes a reader. It gives up by itself if nobody writes.
  REQUIRE(std::system(("timeout 20 cat '" + pipe + "' >'" + copy + "' &").c_str()) == 0);
  CHECK(call("enumerate", "graph --sides 6,6 --pair 3-3 -o pipe").code == 0);
  CHECK(fs::is_fifo(pipe));
  for (int i = 0; i < 100 && slurp(copy).find("components") == std::string::npos; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  CHECK(slurp(scratch() / "copy").rfind("{\"nodes\"", 0) == 0);
}

TEST_CASE("requad-verify reports, and exit code 3 means that there was no instance", "[programs]") {
  const Outcome all =
      call("verify", "--digon 3..6 --hexagon 3..4 --quad-perimeter 8..20 --other-perimeter 4..14 --json -");
  CHECK(all.code == 0);
  const auto json = nlohmann::json::parse(all.out);
  CHECK(json["passed"] == true);
  CHECK(json["claims"].size() == 37);  // the whole ledger
  // No region of perimeter 4..8 has a 3-5 pair. So P1, on the moves of such pairs, is undecided there, and does not hold.
  const Outcome none = call("verify", "--claim P1 --quad-perimeter 4..8 --json -");
  CHECK(none.code == 3);
  CHECK(nlohmann::json::parse(none.out)["claims"][0]["verdict"] == "undecided");
}

TEST_CASE("certificates are checked again", "[programs]") {
  const Outcome made = call("verify",
                            "--claim T2 --claim T3 --claim T4 --digon 3..6 --hexagon 3..4 --quad-perimeter 10..14 "
                            "--other-perimeter 4..12 --certificate proof --quiet");
  REQUIRE(made.code == 0);
  const Outcome held = call("verify", "check proof");
  CHECK(held.code == 0);
  CHECK(held.out.find("certificates hold") != std::string::npos);
  // What else is wrong with certificates: tests/verify/check/.
  spill(scratch() / "proof" / "3-3-4-4.txt", "requad certificate 2\n");
  const Outcome cut = call("verify", "check proof");
  CHECK(cut.code == 1);
  CHECK(cut.err == "requad-verify-check: 3-3-4-4.txt:2: the file ends too early\n");
  fs::remove(scratch() / "proof" / "3-3-4-4.txt");
  const Outcome missing = call("verify", "check proof");
  CHECK(missing.code == 2);
  CHECK(missing.err == "requad-verify-check: proof/3-3-4-4.txt cannot be read\n");
  CHECK(call("verify", "check no-such-folder").code == 2);
  CHECK(call("verify", "check").code == 2);
}

TEST_CASE("requad-figures writes the files that it lists", "[programs]") {
  const Outcome made = call("figures", "-o pictures --page");
  CHECK(made.code == 0);
  std::istringstream lines(made.out);
  int files = 0;
  for (std::string line; std::getline(lines, line);) files += line.starts_with("pictures/") ? 1 : 0;
  CHECK(files == 25 + 7 + 1);  // an SVG of each, a DOT of each grid, the page
  for (const std::string number : {"10", "11", "12"}) {
    CHECK(slurp(scratch() / "pictures" / ("figure-" + number + ".dot")).rfind("graph grid {", 0) == 0);
    CHECK(slurp(scratch() / "pictures" / ("figure-" + number + ".svg")).find("</svg>") != std::string::npos);
  }
}

TEST_CASE("requad-verify prints its proofs", "[programs]") {
  const Outcome one = call("verify", "--proofs --claim T2");
  CHECK(one.code == 0);
  CHECK(one.out.find("T2, for all L >= 1, is proved") == 0);
  CHECK(one.out.find("  given      ") != std::string::npos);
  CHECK(one.out.find("  computed   ") != std::string::npos);
  CHECK(call("verify", "--proofs").out.find("\nN2, for all L >= 1, is proved") != std::string::npos);
  CHECK(call("verify", "--proofs --claim B1").code == 3);  // nothing to prove for all sizes
}
