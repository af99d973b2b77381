// Edits keep the shape, as somebody sees it who has the files alone: distances are measured by brute force on the files,
// with nothing of the library's own measures.
#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <sstream>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "tests/mesh/geometry/shape_of_files.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/sanitizers.hpp"

using namespace requad;
using Eigen::Vector3d;
using nlohmann::json;
using tests::call;
using tests::Quads;
using tests::read_quads;
using tests::shape_lost;

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

// A cube of n x n quads.
std::string cube_text(int n) {
  std::map<std::array<int, 3>, int> numbers;
  std::ostringstream vertices, faces;
  const auto number = [&](std::array<int, 3> p) {
    const auto [at, is_new] = numbers.emplace(p, static_cast<int>(numbers.size()) + 1);
    if (is_new) vertices << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    return at->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          faces << 'f';
          for (const auto& [x, y] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            std::array<int, 3> p{};
            p[axis] = side;
            p[(axis + 1) % 3] = side > 0 ? i + x : i + y;
            p[(axis + 2) % 3] = side > 0 ? j + y : j + x;
            faces << ' ' << number(p);
          }
          faces << '\n';
        }
      }
    }
  }
  return vertices.str() + faces.str();
}

}  // namespace

TEST_CASE("the measure of these tests sees what is lost on either side", "[shape]") {
  const fs::path folder = tests::scratch();
  write(folder / "cube.obj", cube_text(4));
  CHECK(shape_lost(folder / "cube.obj", folder / "cube.obj") < 1e-12);
  std::string bent = cube_text(4);
  bent.replace(bent.find("v 4 4 4"), 7, "v 4 4 6");
  write(folder / "bent.obj", bent);
  const double lost = shape_lost(folder / "cube.obj", folder / "bent.obj"),
               gained = shape_lost(folder / "bent.obj", folder / "cube.obj");
  CHECK(lost > 1.5 / std::sqrt(48.0));
  CHECK(gained > 1.5 / std::sqrt(68.0));
}

TEST_CASE("where nothing can be cancelled, reduce gives back its input", "[shape]") {
  const fs::path folder = tests::scratch();
  write(folder / "cube.obj", cube_text(3));
  REQUIRE(call("edit", "subdivide cube.obj -o start.obj").code == 0);  // as this program writes a file
  for (const std::string options :
       {"", " --max-deviation 0.001", " --max-deviation 0", " --until 3", " --cost curvature"}) {
    INFO(options);
    REQUIRE(call("edit", "reduce start.obj -o same.obj --force" + options).code == 0);
    CHECK(text_of(folder / "same.obj") == text_of(folder / "start.obj"));
  }
}

TEST_CASE("smooth --project keeps to the bound that its help states", "[shape]") {
  const fs::path folder = tests::scratch();
  write(folder / "cube.obj", cube_text(1));
  write(folder / "fine.obj", cube_text(5));
  CHECK(call("edit", "smooth --help").out.find("default with --project: 0.01") != std::string::npos);
  for (const std::string name : {"cube", "fine"}) {
    INFO(name);
    REQUIRE(call("edit", "smooth " + name + ".obj --project --iterations 50 -o smooth.obj --force").code == 0);
    CHECK(shape_lost(folder / (name + ".obj"), folder / "smooth.obj") <= 0.01);
  }
}

TEST_CASE("reduce keeps to --max-deviation, and inverts nothing", "[shape][real]") {
  struct Row {
    const char* name;
    std::string options;
    double bound;
    int most;  // irregular vertices left
  };
  const auto row =
      GENERATE(Row{"fandisk_bommes", "--max-deviation 0.01 --until 24", 0.01, 24},
               Row{"bunny_qex", "--max-deviation 0.01 --until 40", 0.01, 40}, Row{"bigguy", "--until 140", 0.02, 140});
  if (tests::kSanitized && std::string(row.name) != "fandisk_bommes") return;
  const auto path = tests::real_mesh(row.name);
  if (!path) return;
  INFO(row.name << " " << row.options);
  const auto done = call("edit", "reduce " + *path + " -o reduced.obj --force --json - " + row.options);
  REQUIRE(done.code == 0);
  const json report = json::parse(done.out);
  CHECK(report["irregular"]["after"] <= row.most);
  CHECK(report["cancelled"] > 0);
  CHECK(report["after"]["inverted"] <= report["before"]["inverted"]);
  CHECK(report["after"]["scaled_jacobian"]["mean"] > report["before"]["scaled_jacobian"]["mean"].get<double>() - 0.05);
  const double lost = shape_lost(*path, tests::scratch() / "reduced.obj");
  CHECK(lost <= row.bound);
  CHECK(lost <= report["hausdorff"].get<double>() + 1e-3);  // what the program prints is no less
}

TEST_CASE("cancel keeps the shape, and what lies far from it to the last bit", "[shape][real]") {
  const auto path = tests::real_mesh("spot");
  if (!path) return;
  const auto done = call("edit", "cancel " + *path + " 12 40 -o cancelled.obj --force --json -");
  REQUIRE(done.code == 0);
  CHECK(json::parse(done.out)["after"]["inverted"] == 0);
  CHECK(shape_lost(*path, tests::scratch() / "cancelled.obj") < 0.01);
  const Quads before = read_quads(*path), after = read_quads(tests::scratch() / "cancelled.obj");
  std::size_t same = 0;
  for (const Vector3d& p : before.points) same += std::count(after.points.begin(), after.points.end(), p) > 0 ? 1 : 0;
  CHECK(same > before.points.size() / 2);
}

TEST_CASE("a jagged boundary does not make a regular mesh worse", "[shape]") {
  // A strip of squares with steps on both sides: every inner vertex is regular.
  std::ostringstream vertices, faces;
  std::map<std::array<int, 2>, int> numbers;
  const auto number = [&](int x, int y) {
    const auto [at, is_new] = numbers.emplace(std::array{x, y}, static_cast<int>(numbers.size()) + 1);
    if (is_new) vertices << "v " << x << ' ' << y << " 0\n";
    return at->second;
  };
  for (int x = 0; x < 11; ++x) {
    for (int y = x % 3; y < 4 + (x * x) % 3; ++y)
      faces << "f " << number(x, y) << ' ' << number(x + 1, y) << ' ' << number(x + 1, y + 1) << ' ' << number(x, y + 1)
            << '\n';
  }
  write(tests::scratch() / "jagged.obj", vertices.str() + faces.str());
  const auto done = call("edit", "reduce jagged.obj -o reduced.obj --force --json -");
  REQUIRE(done.code == 0);
  const json report = json::parse(done.out);
  CHECK(report["after"]["inverted"] == 0);
  CHECK(report["irregular"]["after"] <= report["irregular"]["before"]);
  CHECK(report["after"]["interior_irregular"] <= report["before"]["interior_irregular"]);
  CHECK(shape_lost(tests::scratch() / "jagged.obj", tests::scratch() / "reduced.obj") < 0.02);
}

TEST_CASE("what is irregular at a boundary does not move inside", "[shape]") {
  // A grid of squares whose upper boundary has teeth of about 90 degrees: each tip and each gap has two quads.
  constexpr int kColumns = 12, kRows = 5;
  std::ostringstream text;
  for (int y = 0; y <= kRows; ++y) {
    for (int x = 0; x <= kColumns; ++x)
      text << "v " << x << ' ' << (y == kRows ? y + (x % 2 == 0 ? 0.5 : -0.5) : y) << " 0\n";
  }
  const auto number = [](int x, int y) { return std::to_string(y * (kColumns + 1) + x + 1); };
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kColumns; ++x)
      text << "f " << number(x, y) << ' ' << number(x + 1, y) << ' ' << number(x + 1, y + 1) << ' ' << number(x, y + 1)
           << '\n';
  }
  write(tests::scratch() / "teeth.obj", text.str());
  for (const char* boundary : {"angle", "fixed", "free"}) {
    INFO(boundary);
    const auto done =
        call("edit", std::string("reduce teeth.obj -o reduced.obj --force --json - --boundary ") + boundary);
    REQUIRE(done.code == 0);
    const json report = json::parse(done.out);
    CHECK(report["after"]["inverted"] == 0);
    CHECK(report["after"]["interior_irregular"] == 0);
    const bool counts = std::string(boundary) == "angle";
    CHECK((report["irregular"]["before"] > 8) == counts);
    CHECK((report["inward"] > 0) == counts);
    if (!counts) CHECK(text_of(tests::scratch() / "reduced.obj") == text_of(tests::scratch() / "teeth.obj"));
  }
}

TEST_CASE("eight v3s are left, and the shape stays", "[.long][keeps shape]") {
  for (const char* name : {"spot", "bunny_qex", "blub", "fandisk_bommes"}) {
    const auto path = tests::real_mesh(name);
    if (!path) continue;
    INFO(name);
    const auto done = call("edit", "reduce " + *path + " -o reduced.obj --force --json -");
    REQUIRE(done.code == 0);
    CHECK(json::parse(done.out)["irregular"]["after"] == 8);
    CHECK(shape_lost(*path, tests::scratch() / "reduced.obj") <= 0.02);
  }
}
