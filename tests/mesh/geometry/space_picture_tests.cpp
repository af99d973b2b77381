// Pictures in space. What a picture shows at a point is what was painted last there; it must be what a ray meets first.
// The ray is followed here through the triangles of all facets, one by one, with no order and no overlaps.
#include <cmath>
#include <limits>
#include <random>
#include <regex>

#include <Eigen/Core>
#include <Eigen/LU>
#include <nlohmann/json.hpp>

#include "mesh/pictures/hidden_surface.hpp"
#include "mesh/pictures/space_picture.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::pictures;
using namespace requad::tests;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kFar = -std::numeric_limits<double>::infinity();

// What a ray meets at a point of the page.
struct Hit {
  int facet = -1;
  double depth = kFar;
  double next = kFar;   // the depth of what it meets after it
  double margin = 1e9;  // least distance, about, from the side of a triangle
};

double twice_area(const Vector3d& a, const Vector3d& b, double x, double y) {
  return (a.x() - x) * (b.y() - y) - (a.y() - y) * (b.x() - x);
}

Hit first_hit(const std::vector<Facet>& facets, const Vector2d& p) {
  Hit hit;
  const double x = p.x(), y = p.y();
  for (int f = 0; f < static_cast<int>(facets.size()); ++f) {
    const Facet& facet = facets[static_cast<std::size_t>(f)];
    for (const int second : {1, 2}) {
      const auto corner = [&](int k) -> const Vector3d& {
        return facet.corners[static_cast<std::size_t>((facet.diagonal + k) % 4)];
      };
      const Vector3d &a = corner(0), &b = corner(second), &c = corner(second + 1);
      const double of_a = twice_area(b, c, x, y), of_b = twice_area(c, a, x, y), of_c = twice_area(a, b, x, y);
      const double all = of_a + of_b + of_c, sign = all < 0 ? -1 : 1;
      if (std::abs(all) < 1e-3) continue;
      const double longest = std::sqrt(std::max(
          {(a - b).head<2>().squaredNorm(), (b - c).head<2>().squaredNorm(), (c - a).head<2>().squaredNorm()}));
      const double distance = std::min({sign * of_a, sign * of_b, sign * of_c}) / longest;
      hit.margin = std::min(hit.margin, std::abs(distance));
      if (distance <= 0) continue;
      const double depth = (of_a * a.z() + of_b * b.z() + of_c * c.z()) / all;
      if (depth > hit.depth) {
        hit.next = hit.depth;
        hit.depth = depth;
        hit.facet = f;
      } else {
        hit.next = std::max(hit.next, depth);
      }
    }
  }
  return hit;
}

bool outline_contains(const std::vector<Piece::Corner>& outline, const Vector2d& p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d &a = outline[i].at, &b = outline[(i + 1) % outline.size()].at;
    if ((a.y() <= p.y()) == (b.y() <= p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

// Compares at points of a page of this size. Returns how many were compared: those that are clearly inside what they show.
int check_picture(const std::vector<Facet>& facets, const HiddenSurface& picture, double size, int points) {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> place(0, size);
  int compared = 0, wrong = 0;
  for (int i = 0; i < points; ++i) {
    const Vector2d p(place(random), place(random));
    const Hit hit = first_hit(facets, p);
    if (hit.margin < 0.15 || (hit.facet >= 0 && hit.depth - hit.next < 0.15)) continue;
    int painted = -1;
    for (const Piece& piece : picture.pieces()) {
      if (outline_contains(piece.outline, p)) painted = piece.facet;
    }
    ++compared;
    if (painted != hit.facet) {
      ++wrong;
      UNSCOPED_INFO("at " << p.transpose() << " facet " << painted << " in place of " << hit.facet << ", depths "
                          << hit.depth << " " << hit.next << ", margin " << hit.margin);
    }
    if (hit.facet < 0) continue;
    if (!picture.covers({p.x(), p.y(), hit.depth - 0.1}) || picture.covers({p.x(), p.y(), hit.depth + 0.1})) {
      ++wrong;
      UNSCOPED_INFO("at " << p.transpose() << " what covers is wrong");
    }
  }
  CHECK(wrong == 0);
  return compared;
}

Facet plane_facet(const std::array<Vector3d, 4>& corners) { return {corners, 0}; }

// The cyclic order of three planks, each over the next one; a plank over two others in the wrong order of middles.
std::vector<Facet> planks() {
  std::vector<Facet> facets;
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * 3.14159265358979 * i / 3;
    const auto turned = [&](double x, double y, double z) {
      return Vector3d(50 + std::cos(angle) * x - std::sin(angle) * y, 50 + std::sin(angle) * x + std::cos(angle) * y,
                      z);
    };
    facets.push_back(plane_facet({turned(-40, 8, -10), turned(40, 8, 10), turned(40, 20, 10), turned(-40, 20, -10)}));
  }
  return facets;
}

// A torus in the page 0..100, tilted.
std::vector<Facet> torus_facets(const mesh::QuadMesh& m, const mesh::Positions& at) {
  std::vector<Facet> facets;
  const Eigen::Matrix3d frame = View{.azimuth = 25, .elevation = 30}.frame();
  for (const mesh::FaceId f : m.faces()) {
    Facet facet;
    for (std::size_t k = 0; k < 4; ++k) {
      facet.corners[k] = 10 * (frame * at[m.corners(f)[k].slot()]);
      facet.corners[k].head<2>().array() += 50;
    }
    facets.push_back(facet);
  }
  return facets;
}

mesh::Positions torus_positions(int columns, int rows) {
  mesh::Positions at;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double u = 2 * 3.14159265358979 * i / columns, v = 2 * 3.14159265358979 * j / rows;
      at.emplace_back((3 + 1.5 * std::cos(v)) * std::cos(u), 1.5 * std::sin(v), -(3 + 1.5 * std::cos(v)) * std::sin(u));
    }
  }
  return at;
}

int occurrences(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++n;
  return n;
}

const std::string kDrawnCube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

}  // namespace

TEST_CASE("facets that pass through each other are painted as a ray meets them", "[pictures][space]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 100), shift(-25, 25);
  for (int scene = 0; scene < 5; ++scene) {
    std::vector<Facet> facets;
    for (int i = 0; i < 40; ++i) {
      const Vector3d at(place(random), place(random), place(random));
      const auto near = [&] { return Vector3d(at + Vector3d(shift(random), shift(random), shift(random))); };
      facets.push_back({{near(), near(), near(), near()}, i % 2});
    }
    INFO("scene " << scene);
    CHECK(check_picture(facets, HiddenSurface(facets), 100, 500) > 250);
  }
}

TEST_CASE("planks that overlap in a circle are painted as a ray meets them", "[pictures][space]") {
  const std::vector<Facet> facets = planks();
  const HiddenSurface picture(facets);
  CHECK(picture.pieces().size() > 3);
  CHECK(picture.pieces().size() < 40);
  CHECK(check_picture(facets, picture, 100, 1000) > 800);
}

TEST_CASE("a torus is painted quad by quad, without what it hides", "[pictures][space]") {
  const mesh::QuadMesh m = torus(24, 12);
  const std::vector<Facet> facets = torus_facets(m, torus_positions(24, 12));
  const HiddenSurface picture(facets);
  CHECK(check_picture(facets, picture, 100, 600) > 300);
  // Nothing is cut, and about half of the quads face away.
  CHECK(picture.pieces().size() > 120);
  CHECK(picture.pieces().size() < 170);
  int whole = 0;
  for (const Piece& piece : picture.pieces()) whole += piece.front && piece.outline.size() == 4 ? 1 : 0;
  CHECK(whole == static_cast<int>(picture.pieces().size()));
}

TEST_CASE("a point behind the edge or the corner of facets is covered, one at their rim is not", "[pictures][space]") {
  std::vector<Facet> facets;
  for (const double x : {0.0, 10.0}) {
    for (const double y : {0.0, 10.0})
      facets.push_back({{Vector3d(x, y, 5), {x + 10, y, 5}, {x + 10, y + 10, 5}, {x, y + 10, 5}}, 0});
  }
  const HiddenSurface surface(facets);
  for (const auto& [x, y] : {std::pair{10.0, 10.0}, {10.0, 4.0}, {4.0, 10.0}, {4.0, 4.0}}) {
    CHECK(surface.covers({x, y, 0}));
    CHECK(!surface.covers({x, y, 5}));
    CHECK(!surface.covers({x, y, 6}));
  }
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.0, 10.0}, {20.0, 4.0}, {20.1, 4.0}})
    CHECK(!surface.covers({x, y, 0}));
}

TEST_CASE("a picture of nothing, and of facets seen edge-on, is empty", "[pictures][space]") {
  CHECK(HiddenSurface({}).pieces().empty());
  const HiddenSurface edge_on({plane_facet({Vector3d(0, 0, 0), {10, 0, 0}, {10, 0, 5}, {0, 0, 5}})});
  CHECK(edge_on.pieces().empty());
  CHECK_FALSE(edge_on.covers({5, 0, -1}));
}

TEST_CASE("the frame of a view is orthogonal and right-handed", "[pictures][space]") {
  for (const bool z_up : {false, true}) {
    for (const double azimuth : {-200.0, 0.0, 30.0, 90.0}) {
      for (const double elevation : {-90.0, 0.0, 45.0}) {
        const Eigen::Matrix3d frame = View{azimuth, elevation, z_up}.frame();
        CHECK((frame * frame.transpose()).isIdentity(1e-12));
        CHECK(frame.determinant() == Approx(1));
      }
    }
  }
  CHECK(View{.azimuth = 0, .elevation = 0}.frame().isIdentity(1e-12));
  // From the right, x points to the viewer; from above, the upward axis does.
  CHECK((View{.azimuth = 90, .elevation = 0}.frame() * Vector3d::UnitX()).isApprox(Vector3d::UnitZ(), 1e-12));
  CHECK((View{.azimuth = 10, .elevation = 90}.frame() * Vector3d::UnitY()).isApprox(Vector3d::UnitZ(), 1e-12));
  CHECK((View{10, 90, true}.frame() * Vector3d::UnitZ()).isApprox(Vector3d::UnitZ(), 1e-12));
  CHECK((View{0, 0, true}.frame() * Vector3d::UnitZ()).isApprox(Vector3d::UnitY(), 1e-12));
}

TEST_CASE("requad-edit draw writes SVG, PDF, PNG and TikZ", "[pictures][space][programs]") {
  spill(scratch() / "cube.obj", kDrawnCube);
  spill(scratch() / "flat.obj", "v 0 0 1\nv 2 0 1\nv 2 1 1\nv 0 1 1\nf 1 2 3 4\n");
  const auto drawn = [](const std::string& arguments, const std::string& file) {
    const Outcome outcome = call("edit", "draw " + arguments + " -o " + file);
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
    return slurp(scratch() / file);
  };
  CHECK(drawn("cube.obj", "cube.png").substr(1, 3) == "PNG");
  CHECK(drawn("cube.obj", "cube.pdf").substr(0, 5) == "%PDF-");
  const std::string svg = drawn("cube.obj", "cube.svg");
  CHECK(svg.substr(0, 5) == "<?xml");
  CHECK(drawn("cube.obj", "again.svg") == svg);
  CHECK(call("edit", "draw cube.obj -o -").out == svg);
  // Seven of the eight v3s are seen; their blue is that of Palette.
  const std::string blue = "fill:rgb(0%,44.705882%,69.803922%)";
  CHECK(occurrences(svg, blue) == 7);
  CHECK(occurrences(drawn("cube.obj --view 0,0", "front.svg"), blue) >= 4);
  const std::string black = "stroke-width:1.6", pink = "fill:rgb(94";
  CHECK(occurrences(svg, black) == 0);
  CHECK(occurrences(drawn("cube.obj --feature-angle 60", "sharp.svg"), black) == 12);  // each side of three quads
  CHECK(occurrences(drawn("flat.obj", "flat.svg"), black) == 4);                       // the boundary
  // Side by side with itself: everything stands twice.
  const std::string twice = drawn("cube.obj --before cube.obj --checkerboard", "twice.svg");
  CHECK(occurrences(twice, blue) == 14);
  CHECK(twice.find("viewBox") != std::string::npos);

  // The options of a page, which requad-figures has, too.
  const std::string narrow = drawn("cube.obj --width 85mm --real-text --font serif --font-size 7", "narrow.svg");
  CHECK(narrow.find(" width=\"240.94") != std::string::npos);
  CHECK(narrow.find("<title>cube.obj</title>") != std::string::npos);
  CHECK(narrow.find("<g font-family=\"serif\">") != std::string::npos);
  CHECK(occurrences(narrow, "font-size=\"7\"") == 1);
  CHECK(occurrences(drawn("cube.obj --real-text --no-captions", "bare.svg"), "<text") == 0);
  const std::string grey = drawn("cube.obj --before cube.obj --checkerboard --palette grey", "grey.svg");
  const std::regex colour("rgb\\(([0-9.]+)%,([0-9.]+)%,([0-9.]+)%\\)");
  for (std::sregex_iterator it(grey.begin(), grey.end(), colour), end; it != end; ++it) {
    CHECK((*it)[1] == (*it)[2]);
    CHECK((*it)[1] == (*it)[3]);
  }
  CHECK(drawn("cube.obj --width 300", "cube.tex").find("\\begin{tikzpicture}") != std::string::npos);
  CHECK(drawn("cube.obj --resolution 72", "coarse.png").size() < drawn("cube.obj", "fine.png").size());

  const auto refused = [](const std::string& arguments) {
    const Outcome outcome = call("edit", "draw " + arguments);
    CHECK(outcome.code == 2);
    CHECK(line_count(outcome.err) == 1);
    return outcome.err;
  };
  CHECK(refused("cube.obj -o cube.gif").find(".svg") != std::string::npos);
  CHECK(refused("cube.obj").find("output") != std::string::npos);
  CHECK(refused("cube.obj -o x.svg --view 30").find("two angles") != std::string::npos);
  CHECK(refused("cube.obj -o x.svg --up x").find("up") != std::string::npos);
  CHECK(refused("cube.obj -o x.svg --width 200 --size 100").find("size") != std::string::npos);
  CHECK(refused("cube.obj -o x.svg --resolution 300").find("unless the format is png") != std::string::npos);
  CHECK(refused("cube.obj -o x.svg --width 3").find("is not a width") != std::string::npos);
  CHECK(refused("cube.obj -o x.svg --before none.obj").find("none.obj") != std::string::npos);
}

TEST_CASE("a large real mesh is drawn, with the parts that pass through others cut", "[pictures][space][real]") {
  const auto path = real_mesh("mh_base");
  if (!path) return;
  const Outcome outcome = call("edit", "draw '" + *path + "' -o mh.svg --json -");
  CHECK(outcome.code == 0);
  CHECK(nlohmann::json::parse(outcome.out)["mesh"]["faces"] == 18486);
  CHECK(slurp(scratch() / "mh.svg").size() < 4'000'000);
}
