// The parts of the certificates' checker, each by itself.
#include <algorithm>
#include <set>
#include <sstream>

#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/verify/check/proof.hpp"
#include "verify/check/certificate.hpp"

using namespace requad;
using check::FillingCounter;
using check::Region;
using check::region_of;

TEST_CASE("the recurrence counts what a search lists", "[checker]") {
  // Theorem 7.1: one vertex of valence 2 or 6 has one place, if there is one.
  FillingCounter counter;
  CHECK(counter.with_merged_vertex(region_of("3-3", {2, 2})) == 1);
  CHECK(counter.with_merged_vertex(region_of("3-3", {3, 3})) == 0);
  CHECK(counter.with_merged_vertex(region_of("5-5", {2, 2, 2, 2, 2, 2})) == 1);
  CHECK(counter.with_merged_vertex(region_of("5-5", {2, 4, 4, 2, 4, 4})) == 1);
  CHECK(counter.with_merged_vertex(region_of("5-5", {3, 3, 3, 3, 3, 3})) == 0);
  CHECK(counter.with_merged_vertex(region_of("3-5", {3, 3, 4, 4})) == 0);
  // Theorems 7.2 and 7.3: 1, 2, 4, 6, 9, 12, ..., and three times that.
  const std::vector<std::uint64_t> tau{0, 0, 1, 2, 4, 6, 9, 12, 16, 20};
  for (int length = 1; length <= 10; ++length) {
    INFO(length);
    CHECK(counter.with_pair(region_of("3-3", {length, length})) == tau[static_cast<std::size_t>(length - 1)]);
    if (length <= 8)
      CHECK(counter.with_pair(region_of("5-5", std::vector<int>(6, length))) ==
            3 * tau[static_cast<std::size_t>(length - 1)]);
  }
  // By requad-enumerate search, which lists: sides and irregular vertices as here.
  struct Searched {
    std::string pair;
    std::vector<int> sides;
    std::uint64_t fillings;
  };
  const std::vector<Searched> searched{
      {"3-5", {3, 3, 4, 4}, 4},
      {"3-5", {3, 4, 5, 4}, 4},
      {"3-5", {2, 10, 3, 9}, 8},
      {"3-5", {3, 3, 3, 3}, 0},
      {"3-3", {4, 6}, 2},
      {"3-3", {6, 14}, 6},
      {"3-3", {4, 5}, 0},
      {"5-5", {3, 3, 4, 3, 3, 4}, 3},
      {"5-5", {2, 4, 4, 2, 4, 4}, 2},
      {"5-5", {2, 2, 2, 2, 2, 2}, 0},
      {"5-5", {1, 1, 1, 1, 1, 15}, 0},
      {"5-5", {2, 3, 4, 2, 3, 4}, 2},
  };
  for (const Searched& s : searched) {
    INFO(region_of(s.pair, s.sides).name());
    CHECK(counter.with_pair(region_of(s.pair, s.sides)) == s.fillings);
    std::string sides, valences = s.pair;
    for (const int side : s.sides) sides += (sides.empty() ? "" : ",") + std::to_string(side);
    valences[1] = ',';
    const auto listed = tests::call("enumerate", "search --sides " + sides + " --irregular " + valences + " --json -");
    CHECK(listed.out.find("\"count\":" + std::to_string(s.fillings) + ",") != std::string::npos);
  }
}

TEST_CASE("the closed forms agree with the count in every region", "[checker]") {
  FillingCounter counter;
  const std::vector<int> last{14, 7, 18, 18, 18};
  std::size_t regions = 0, filled = 0;
  for (std::size_t f = 0; f < check::families().size(); ++f) {
    check::for_each_region(check::families()[f], 1, last[f], [&](const Region& region) {
      INFO(region.name());
      const auto fillings = static_cast<long long>(counter.with_pair(region));
      REQUIRE(fillings == check::closed_form(region));
      ++regions;
      filled += fillings > 0 ? 1 : 0;
    });
  }
  CHECK(regions > 2000);
  CHECK(filled > 100);
}

TEST_CASE("regions come once up to rotation", "[checker]") {
  for (const check::Family& family : check::families()) {
    std::set<std::vector<int>> met;
    check::for_each_region(family, 1, family.with_others ? 14 : 5, [&](const Region& region) {
      std::vector<int> sides = region.sides;
      CHECK((family.with_others ? family.with_regular || !region.regular() : region.regular()));
      for (std::size_t i = 0; i < sides.size(); ++i) {
        CHECK(sides >= region.sides);
        if (sides != region.sides) CHECK(met.count(sides) == 0);
        std::rotate(sides.begin(), sides.begin() + 1, sides.end());
      }
      CHECK(met.insert(sides).second);
    });
  }
}

namespace {

// Why the checker refuses a certificate; "" if it holds.
std::string reason(const std::string& text) {
  std::istringstream in(text);
  check::Lines lines(in);
  FillingCounter counter;
  try {
    check::check_certificate(lines, nullptr, counter);
  } catch (const check::Rejected& rejected) {
    return rejected.what();
  } catch (const check::Undecided& undecided) {
    return undecided.what();
  }
  return "";
}

}  // namespace

TEST_CASE("each digit of a certificate matters, and each line", "[checker]") {
  for (const std::string name : {"3-3-4-4.txt", "3-3-5-5.txt", "5-5-4-4-4-4-4-4.txt", "3-5-3-3-4-4.txt"}) {
    INFO(name);
    REQUIRE(
        tests::call("verify",
                    "--claim T2 --claim T3 --claim T4 --digon 4..5 --hexagon 4 --quad-perimeter 14 --other-perimeter 4 "
                    "--method moves --certificate proof --quiet")
            .code == 0);
    const std::string good = tests::slurp(tests::scratch() / "proof" / name);
    REQUIRE(reason(good) == "");
    int changes = 0;
    const auto refuse = [&](const std::string& text) {
      ++changes;
      if (reason(text) == "") FAIL_CHECK("accepted: " << text);
    };
    for (std::size_t i = 0; i < good.size(); ++i) {
      if (good[i] < '0' || good[i] > '9') continue;
      std::string text = good;
      text[i] = good[i] == '9' ? '8' : static_cast<char>(good[i] + 1);
      refuse(text);
    }
    for (std::size_t start = 0; start < good.size();) {
      const std::size_t end = good.find('\n', start) + 1;
      refuse(good.substr(0, start) + good.substr(end));
      refuse(good.substr(0, end) + good.substr(start));
      start = end;
    }
    CHECK(changes > 200);
  }
}

TEST_CASE("what is hostile ends soon, in one line", "[checker]") {
  const std::string head = "requad certificate 2\npair 3-3\nsides ";
  CHECK(reason("") == "the file ends too early");
  CHECK(reason("requad certificate 1\n") == "not a certificate of version 2");
  CHECK(reason(head + "9999999 9999999\n") == "the sides add up to more than 400, which is not checked");
  CHECK(reason(head + "99999999 1\n") == "'99999999' is no number");
  CHECK(reason(head + "04 4\n") == "'04' is no number");
  CHECK(reason(head + "4  4\n") == "words are not parted by one space");
  CHECK(reason(head + "4 4 4\n") == "the pair needs another number of sides");
  CHECK(reason(std::string(100000, 'x')) == "a line is too long");
  CHECK(reason(head + "4 4\nconfigurations 9999999\nmerged 9999999\nedges 9999999\n") ==
        "9999999 configurations, but the closed form gives 2");
  CHECK(reason(head +
               "4 4\nconfigurations 2\nmerged 9999999\nedges 9999999\nmesh 0 pair (1,1) d1 1 d2 1 p 1 strips 1 1 "
               "vertices 9999999 faces 9999999\n0 1 2 3\n") == "a mesh has too many faces");
  CHECK(reason(head + "4 4\nconfigurations 2\nmerged 0\nedges 0\nmesh 0 pair (1,1) d1 1 d2 1 p 1 strips 1 1 "
                      "vertices 9999999 faces 1\n0 1 2 3\n") ==
        "the numbers of vertices and faces are not those of a disk");
}

TEST_CASE("a hostile MANIFEST ends soon, in one line", "[checker]") {
  struct Hostile {
    std::string manifest;  // after its title
    int code;
    std::string message;
  };
  const std::string family = "family regular-digons sides ";
  const std::vector<Hostile> all{
      {"", 1, "MANIFEST:2: the file ends too early"},
      {family + "3..4\ncertificates 9999999\n", 1, "MANIFEST:4: the file ends too early"},
      {family + "3..101\n", 3, "MANIFEST: regular-digons beyond 100 are not checked"},
      {family + "0..4\n", 1, "MANIFEST:2: a range starts with 0"},
      {family + "3-4\n", 1, "MANIFEST:2: a range is not of the form A..B"},
      {family + "3..4..5\n", 1, "MANIFEST:2: '4..5' is no number"},
      {"family regular-digons perimeters 3..4\n", 1, "MANIFEST:2: the sizes of this family are others"},
      {"family octagons sides 3..4\n", 1, "MANIFEST:2: there is no such family"},
      {family + "5..4\ncertificates 0\nend\n", 3, "folder/MANIFEST lists no certificate"},
      {family + "1..2\ncertificates 0\nend\n", 3, "folder/MANIFEST lists no certificate"},
      {family + "3..4\ncertificates 0\nend\n", 1, "MANIFEST:4: 3-3-3-3.txt is missing"},
      {family + "3..3\ncertificates 1\n../../etc/passwd 0\nend\n", 1,
       "MANIFEST:5: ../../etc/passwd is no region of the families"},
      {family + "3..3\ncertificates 1\n3-3-3-3.txt 0\nend\n", 2, "folder/3-3-3-3.txt cannot be read"},
      {family + "3..3\ncertificates 1\n3-3-3-3.txt 0\nend\n\n", 1, "MANIFEST:6: the file goes on after 'end'"},
      // The most regions that a MANIFEST can ask for: it lists none of them.
      {"family 3-5-regions perimeters 1..100\nfamily other-hexagons perimeters 1..40\ncertificates 0\nend\n", 1,
       "MANIFEST:5: 3-5-2-2-3-3.txt is missing"},
  };
  for (const Hostile& hostile : all) {
    INFO(hostile.manifest);
    std::filesystem::create_directory(tests::scratch() / "folder");
    tests::spill(tests::scratch() / "folder/MANIFEST", "requad manifest 2\n" + hostile.manifest);
    const auto outcome = tests::call("verify", "check folder");
    CHECK(outcome.code == hostile.code);
    CHECK(outcome.err == "requad-verify-check: " + hostile.message + "\n");
  }
}
