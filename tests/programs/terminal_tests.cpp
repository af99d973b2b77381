// What a user of the terminal meets: standard input and output in place of files, formats that follow the ends of names,
// inputs that are kept, options without effect, suggestions, the width of lines, and progress.
#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "mesh/program/layout.hpp"
#include "mesh/program/options.hpp"
#include "mesh/program/run/progress.hpp"
#include "mesh/program/suggestion.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/sanitizers.hpp"

using namespace requad;
using namespace requad::tests;
namespace fs = std::filesystem;

namespace {

const std::string kExample = "'" REQUAD_SOURCE_DIR "/mesh/examples/figure-17.obj'";

void refused(const std::string& command, const std::string& part) {
  const Outcome outcome = shell(command);
  INFO(command << "\ncode " << outcome.code << ": " << outcome.err << outcome.out);
  CHECK(outcome.code == 2);
  CHECK(outcome.out.empty());
  CHECK(line_count(outcome.err) == 1);
  CHECK(outcome.err.find(part) != std::string::npos);
}

std::size_t widest_line(const std::string& text) {
  std::size_t widest = 0;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) widest = std::max(widest, line.size());
  return widest;
}

}  // namespace

TEST_CASE("standard input and standard output are called -, also through pipes", "[programs][terminal]") {
  fs::copy_file(REQUAD_SOURCE_DIR "/mesh/examples/figure-17.obj", scratch() / "piped.obj",
                fs::copy_options::overwrite_existing);
  const std::string by_name = shell("requad-edit info piped.obj").out;
  CHECK(shell("cat piped.obj | requad-edit info -").out == by_name);
  CHECK(shell("requad-edit info <(cat piped.obj)").out == by_name);
  CHECK(shell("requad-edit info /dev/stdin <piped.obj").out == by_name);
  CHECK(shell("requad-enumerate region hexagon 1 1 1,1,1,1,1,1 -o - | requad-edit merge - 1 4 -o - | requad-edit part "
              "- -o - | "
              "requad-edit info - --json -")
            .code == 0);
  // OFF is known by its first word.
  const std::string tetrahedron = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  spill(scratch() / "t.off", tetrahedron);
  CHECK(shell("requad-edit subdivide - -o - <t.off").out == shell("requad-edit subdivide t.off -o -").out);
  // A script, and features.
  REQUIRE(shell("requad-edit reduce piped.obj -o less.obj --script - >edits").code == 0);
  CHECK(shell("requad-edit apply piped.obj - -o - <edits").out == slurp(scratch() / "less.obj"));
  CHECK(shell("echo 1 300 | requad-edit info piped.obj --features -").err.find("standard input:1:") !=
        std::string::npos);
  // Signatures, both ways.
  const std::string signature = shell("requad-enumerate signature - <piped.obj").out;
  CHECK(signature == shell("requad-enumerate signature piped.obj").out);
  CHECK(shell("requad-enumerate signature --from-signature - -o - <<<'" + signature.substr(0, signature.size() - 1) +
              "' | requad-enumerate signature -")
            .out == signature);
  CHECK(shell("requad-figures --figure 2 -o - | head -c 5").out == "<?xml");
  CHECK(shell("requad-enumerate tau -o - | head -n 1").out == "side,3-3,5-5\n");
  refused("requad-edit apply - - -o x.obj <piped.obj", "cannot both be standard input");
  refused("requad-edit info - </dev/null", "standard input:1: ");
  refused("requad-enumerate search --sides 4,4 --irregular 3,3 --journal -", "a file is expected");
}

TEST_CASE("formats follow the ends of names", "[programs][terminal]") {
  const std::string graph = "requad-enumerate graph --sides 6,6 --pair 3-3 ";
  for (const auto& [file, start] :
       std::vector<std::pair<std::string, std::string>>{{"g.dot", "graph G {"},
                                                        {"g.GV", "graph G {"},
                                                        {"g.graphml", "<?xml"},
                                                        {"g.json", "{\"nodes\""},
                                                        {"g.csv", "d1,d2,p,m,n,e1,e2,faces,signature\n"},
                                                        {"g", "{\"nodes\""}}) {
    INFO(file);
    CHECK(shell(graph + "-o " + file).code == 0);
    CHECK(slurp(scratch() / file).starts_with(start));
  }
  CHECK(shell(graph + "--format node_link -o n.json").code == 0);
  CHECK(slurp(scratch() / "n.json").starts_with("{\"directed\""));
  refused(graph + "-o g.poem", "'.poem' here; expected a name that ends in .json, .dot, .gv, .graphml, .xml or .csv");
  refused(graph + "--format dot -o g.json", "--format dot asks for a name that ends in .dot or .gv");
  refused(graph + "--json g.txt", "expected a name that ends in .json");
  refused("requad-edit reduce " + kExample + " -o c.ply", "expected a name that ends in .obj");
  refused("requad-enumerate region digon 2 1 3,2 -o r.off", "expected a name that ends in .obj");
  refused("requad-verify --claim T2 --html report.pdf", "expected a name that ends in .html or .htm");
  refused("requad-figures --explorer --sides 4,4 --pair 3-3 -o page.svg", "expected a name that ends in .html or .htm");
  CHECK(shell("requad-figures --figure 12 -o one.pdf").code == 0);
  CHECK(slurp(scratch() / "one.pdf").starts_with("%PDF"));
  refused("requad-figures -o all.pdf", "expected one --figure");
  refused("requad-figures --figure 12 --format svg -o one.pdf", "--format svg asks for a name that ends in .svg");
  refused("requad-figures --figure 2 -o two.dot", "is no graph");
  refused("requad-figures --figure 10 -o ten.graphml", "this figure has 2 graphs");
}

TEST_CASE("an input is replaced only with --force", "[programs][terminal]") {
  fs::copy_file(REQUAD_SOURCE_DIR "/mesh/examples/figure-17.obj", scratch() / "kept.obj",
                fs::copy_options::overwrite_existing);
  const std::string before = slurp(scratch() / "kept.obj");
  fs::create_symlink("kept.obj", scratch() / "soft.obj");
  fs::create_hard_link(scratch() / "kept.obj", scratch() / "hard.obj");
  for (const char* output : {"kept.obj", "./kept.obj", "soft.obj", "hard.obj"})
    refused(std::string("requad-edit reduce kept.obj -o ") + output, "it is read, and would be replaced");
  spill(scratch() / "edges.json", "1 59\n");
  refused("requad-edit info kept.obj --features edges.json --json edges.json", "edges.json: it is read");
  refused("requad-edit draw kept.obj --before soft.obj -o x.svg --json kept.obj", "kept.obj");
  spill(scratch() / "edits.txt", "");
  refused("requad-edit apply kept.obj edits.txt -o edits.txt", "edits.txt");
  REQUIRE(shell("requad-enumerate search --sides 4,4 --irregular 3,3 --journal j.json").code == 0);
  refused("requad-enumerate search --sides 4,4 --irregular 3,3 --journal j.json --json j.json", "j.json: it is read");
  CHECK(slurp(scratch() / "kept.obj") == before);
  CHECK(shell("requad-edit subdivide kept.obj -o kept.obj --force").code == 0);
  CHECK(slurp(scratch() / "kept.obj") != before);
}

TEST_CASE("options without effect are refused, by what the tables say of them", "[programs][terminal]") {
  refused("requad-edit atomic " + kExample + " 366 --smooth 3", "atomic: --smooth has no effect without --make");
  refused("requad-edit atomic " + kExample + " 366 -o x.obj", "atomic: --output has no effect without --make");
  refused("requad-edit info " + kExample + " --feature-angle 30 --features f", "--feature-angle has no effect beside");
  refused("requad-enumerate signature --from-signature 1111f13e3934 --subdivide", "--subdivide has no effect");
  refused("requad-enumerate signature " + kExample + " -o x.obj", "--output has no effect without --from-signature");
  refused("requad-enumerate search --sides 4,4 --interior-quads 2,2,2 --irregular 3,3",
          "--interior-quads has no effect");
  refused("requad-enumerate graph --sides 6,6 --pair 3-3 --json - --format dot", "--format has no effect");
  refused("requad-verify --claim T2 --hexagon 3..5", "--hexagon has no effect");
  refused("requad-verify --claim T2 --quad-perimeter 8", "--quad-perimeter has no effect");
  refused("requad-verify --claim T4 --other-perimeter 8", "--other-perimeter has no effect");
  refused("requad-verify --claim B1 --method walk", "--claim B1 has no effect");
  refused("requad-verify --claim B1 --method moves --method walk", "--method walk has no effect");
  refused("requad-figures --figure 12 --side 8", "--side has no effect on these figures");
  refused("requad-figures --figure 10 --sides 4,5,4,4,5,4", "--sides has no effect");
  refused("requad-figures --figure 10 --pair-region 1,1,2,2", "--pair-region has no effect");
  refused("requad-figures --figure 10 --page -o x.svg", "--page has no effect");
}

TEST_CASE("what is written almost right works, or gets a suggestion", "[programs][terminal]") {
  const std::string claim = shell("requad-verify --claim T2 --digon 3..5 --other-perimeter 4..6").out;
  CHECK(shell("requad-verify --claim t2 --digon 3-5 --other-perimeter 4-6").out == claim);
  CHECK(shell("requad-verify --claim T2 --digon 4 --other-perimeter 4").out.starts_with("digons L=4: 1 region, "));
  refused("requad-verify --claim TT2", "did you mean 'T2'?");
  refused("requad-verify --claims T2", "did you mean --claim?");
  refused("requad-edit smoth " + kExample + " -o x.obj", "'smoth' is no command; did you mean 'smooth'?");
  refused("requad-enumerate graph --sides 6,6 --pair 3-3 --format graphm", "did you mean 'graphml'?");
  refused("requad-edit atomic " + kExample + " 0",
          "there is no vertex 0; expected 1..366, for vertices are counted from 1");
  CHECK(program::suggestion("T2", {"T1", "t2"}) == "t2");
  CHECK(program::suggestion("ingo", {"info", "apply"}) == "info");
  CHECK(program::suggestion("ifno", {"info", "apply"}) == "info");
  CHECK(program::suggestion("a", {"b", "c"}).empty());
  CHECK(program::suggestion("dance", {"info", "apply"}).empty());
  const program::Range range = program::parse_range("3-24", "x");
  CHECK((range.first == 3 && range.last == 24));
  CHECK((program::parse_range("-3..-1", "x").first == -3 && program::parse_range("-3", "x").last == -3));
  CHECK_THROWS_AS(program::parse_range("3-", "x"), program::UsageError);
  CHECK_THROWS_AS(program::parse_range("5-3", "x"), program::UsageError);
}

TEST_CASE("search says why there can be no filling", "[programs][terminal]") {
  const auto why = [](const std::string& arguments) {
    const Outcome outcome = shell("requad-enumerate search --json - " + arguments);
    CHECK(outcome.code == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    CHECK(json["count"] == 0);
    const std::string reason = json.value("why", "");
    CHECK(outcome.err == (reason.empty() ? "" : "requad-enumerate: there is no filling: " + reason + "\n"));
    return reason;
  };
  CHECK(why("--sides 6,6,5 --irregular 3,3,5").find("odd sum 17") != std::string::npos);
  CHECK(why("--sides 6,6,6 --irregular 3,3") ==
        "the indices 4 - l of the irregular vertices sum to 2, and with this boundary they must sum to 1 (discrete "
        "Gauss-Bonnet)");
  CHECK(why("--sides 6,6,5 --irregular 3,3").find("; the indices") != std::string::npos);
  CHECK(why("--sides 5,4,5,4 --irregular 3,5").empty());
  CHECK(why("--sides 5,5,5 --irregular 2,2,2,2,2").find("odd sum 15") != std::string::npos);  // needs no limit
}

TEST_CASE("lines fit the width of the terminal", "[programs][terminal]") {
  const std::string claims = "requad-verify --claim T2 --claim N4 --digon 3..4 --other-perimeter 4..6";
  CHECK(widest_line(shell(claims).out) <= 80);
  if (tests::kSanitized) return;  // slow there, and the text is the same
  CHECK(widest_line(shell("COLUMNS=60 " + claims).out) <= 60);
  CHECK(widest_line(shell("COLUMNS=1000 " + claims).out) > 100);
  for (const char* command :
       {"requad-verify --list", "requad-verify --proofs", "requad-verify --errata", "requad-verify --sentences"})
    CHECK(widest_line(shell(command).out) <= 80);
  CHECK(widest_line(shell("requad-edit reduce " + kExample + " -o x.obj").out) <= 80);
  CHECK(widest_line(shell("requad-edit atomic " + kExample + " 366").out) <= 80);
  // On a terminal, its own width counts.
  const Outcome tty =
      shell("script -qec 'stty cols 50; " + claims + "' /dev/null </dev/null | tr '\\r' '\\n' | sed 's/\\x1b.K//g'");
  CHECK(widest_line(tty.out) <= 50);
  CHECK(widest_line(tty.out) > 40);
  CHECK(program::wrapped("one two three", 2, 9) == std::vector<std::string>{"  one two", "  three"});
  CHECK(program::wrapped("  name  a meaning", 0, 16) == std::vector<std::string>{"  name  a", "        meaning"});
  CHECK(program::wrapped("unbreakable words", 0, 5) == std::vector<std::string>{"unbreakable", "words"});
  CHECK(program::wrapped("an unbreakable word", 0, 5) == std::vector<std::string>{"an unbreakable", "word"});
}

TEST_CASE("progress comes with an estimate", "[programs][terminal]") {
  CHECK(program::duration_text(0.2) == "1 s");
  CHECK(program::duration_text(99) == "99 s");
  CHECK(program::duration_text(120) == "2 min");
  CHECK(program::duration_text(7300) == "2 h");
  CHECK(program::duration_text(3 * 86400) == "3 days");
  CHECK(program::duration_text(1e12) == "years");
  if (tests::kSanitized) return;
  // Some seconds of work each, for nothing is shown in the first.
  for (const auto& [command, what] : std::vector<std::pair<std::string, std::string>>{
           {"requad-verify --claim T2 --method walk --digon 340 --other-perimeter 4", "configurations: "},
           {"requad-enumerate search --sides 30,30,30 --irregular 3,3,5 --limit-seconds 2", "states: "}}) {
    const std::string shown = shell("script -qec '" + command + "' /dev/null </dev/null").out;
    INFO(command << "\n" << shown);
    CHECK(shown.find(what) != std::string::npos);
    CHECK(shown.find(" left") != std::string::npos);
  }
}

TEST_CASE("manual pages and completions are made from the tables", "[programs][terminal]") {
  for (const std::string program : {"requad-edit", "requad-enumerate", "requad-verify", "requad-figures"}) {
    INFO(program);
    const std::string page = shell(program + " --documentation man").out;
    CHECK(page.starts_with(".TH REQUAD\\-"));
    // Each long option of the help is in the page, and in the completions of each shell.
    const std::string bash = shell(program + " --documentation bash").out;
    const std::string zsh = shell(program + " --documentation zsh").out;
    const std::string fish = shell(program + " --documentation fish").out;
    std::istringstream words(shell(program + " --help | grep -oE -- '^  (-., )?--[a-z-]+' | grep -oE -- '--.*'").out);
    int options = 0;
    for (std::string word; words >> word; ++options) {
      INFO(word);
      std::string in_roff;
      for (const char c : word) in_roff += c == '-' ? "\\-" : std::string(1, c);
      CHECK(page.find(in_roff + "\\fR") != std::string::npos);
      CHECK(bash.find(word) != std::string::npos);
      CHECK(zsh.find(word) != std::string::npos);
      CHECK(fish.find(" -l " + word.substr(2) + " ") != std::string::npos);
    }
    CHECK(options >= 6);
    CHECK(shell(program + " --documentation bash | bash -n").code == 0);
    for (const char* checker : {"zsh -n", "fish --no-execute"}) {
      const std::string name(checker, std::string(checker).find(' '));
      const std::string format = name + " >shown; ! command -v " + name + " >/dev/null || " + checker + " shown";
      CHECK(shell(program + " --documentation " + format).code == 0);
    }
    CHECK(shell("! command -v groff >/dev/null || { " + program +
                " --documentation man | groff -man -Tutf8 -ww -z 2>&1; }")
              .out.empty());
  }
  const auto completed = [](const std::string& line) {
    return shell(
               "source <(requad-edit --documentation bash); source <(requad-enumerate --documentation bash); "
               "COMP_WORDS=(" +
               line + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _${COMP_WORDS[0]//-/_}; echo ${COMPREPLY[*]}")
        .out;
  };
  CHECK(completed("requad-edit sm") == "smooth\n");
  CHECK(completed("requad-edit smooth --it") == "--iterations\n");
  CHECK(completed("requad-edit smooth --weights ''") == "uniform chord\n");
  CHECK(completed("requad-edit --json out.json re") == "reduce\n");
  CHECK(completed("requad-edit info --iter") == "\n");
  CHECK(completed("requad-enumerate region digon 1 1 1,1 --gen") == "--generator\n");
  refused("requad-edit --documentation poem", "is not one of man, bash, zsh, fish");
}
