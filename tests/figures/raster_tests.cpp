// SVG files as others see them: librsvg, which did not write them, rasterises each figure, and the result is compared
// with the PNG that Cairo makes of the same drawing.
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <vector>

#include <cairo.h>

#include "figures/pictures/catalogue.hpp"
#include "mesh/pictures/page.hpp"
#include "mesh/pictures/space_picture.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/sanitizers.hpp"

using namespace requad;
using namespace requad::figures;

namespace {

// Grey values, 0 (black) to 255, on white.
struct Raster {
  int width = 0;
  int height = 0;
  std::vector<int> grey;

  int at(int x, int y) const { return grey[static_cast<std::size_t>(y * width + x)]; }
};

Raster read_png(const std::filesystem::path& path) {
  const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> image(
      cairo_image_surface_create_from_png(path.c_str()), cairo_surface_destroy);
  REQUIRE(cairo_surface_status(image.get()) == CAIRO_STATUS_SUCCESS);
  Raster raster{cairo_image_surface_get_width(image.get()), cairo_image_surface_get_height(image.get()), {}};
  const bool has_alpha = cairo_image_surface_get_format(image.get()) == CAIRO_FORMAT_ARGB32;
  const unsigned char* data = cairo_image_surface_get_data(image.get());
  const int stride = cairo_image_surface_get_stride(image.get());
  for (int y = 0; y < raster.height; ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
    for (int x = 0; x < raster.width; ++x) {
      const std::uint32_t pixel = row[x];  // the colours are multiplied by alpha
      const auto white = static_cast<int>(has_alpha ? 255 - (pixel >> 24) : 0);
      const auto sum = static_cast<int>((pixel >> 16 & 255U) + (pixel >> 8 & 255U) + (pixel & 255U));
      raster.grey.push_back(sum / 3 + white);
    }
  }
  return raster;
}

// How many pixels of `a` differ clearly from each pixel of `b` within one pixel of the same place: a shifted or softened
// edge does not count.
int differing(const Raster& a, const Raster& b) {
  constexpr int kClearly = 80;
  int count = 0;
  for (int y = 1; y + 1 < a.height; ++y) {
    for (int x = 1; x + 1 < a.width; ++x) {
      int least = 255, greatest = 0;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          least = std::min(least, b.at(x + dx, y + dy));
          greatest = std::max(greatest, b.at(x + dx, y + dy));
        }
      }
      if (a.at(x, y) < least - kClearly || a.at(x, y) > greatest + kClearly) ++count;
    }
  }
  return count;
}

// The SVG, rasterised by librsvg in the size of the PNG; the number of pixels that differ.
int difference(const std::string& svg, const Raster& expected) {
  const std::filesystem::path folder = tests::scratch();
  tests::spill(folder / "figure.svg", svg);
  const std::string command = "rsvg-convert -w " + std::to_string(expected.width) + " -h " +
                              std::to_string(expected.height) + " '" + (folder / "figure.svg").string() + "' -o '" +
                              (folder / "rsvg.png").string() + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  const Raster seen = read_png(folder / "rsvg.png");
  REQUIRE(seen.width == expected.width);
  REQUIRE(seen.height == expected.height);
  return differing(seen, expected) + differing(expected, seen);
}

bool has_renderer() {
  if (tests::kSanitized) {
    WARN("skipped under sanitizers: the other build compares the same bytes");
    return false;
  }
  if (std::system("rsvg-convert --version >/dev/null 2>&1") == 0) return true;
  if (std::getenv("REQUAD_REQUIRE_RSVG") != nullptr) FAIL("rsvg-convert is missing, and REQUAD_REQUIRE_RSVG is set");
  WARN("skipped: there is no rsvg-convert (package librsvg2-bin)");
  return false;
}

Raster raster_by_cairo(const Picture& picture) {
  tests::spill(tests::scratch() / "cairo.png", render(picture.paint, "png"));
  return read_png(tests::scratch() / "cairo.png");
}

constexpr int kFewPixels = 20;  // a mangled letter differs in more

}  // namespace

TEST_CASE("another renderer sees each figure's SVG as Cairo draws it", "[figures][raster]") {
  if (!has_renderer()) return;
  for (const CatalogueEntry& entry : catalogue()) {
    INFO(entry.id);
    const Picture picture = entry.make({});
    CHECK(difference(render(picture.paint, "svg"), raster_by_cairo(picture)) < kFewPixels);
  }
}

TEST_CASE("another renderer sees a mesh in space as Cairo draws it", "[figures][raster]") {
  if (!has_renderer()) return;
  const mesh::QuadMesh m = tests::cube();
  const mesh::Positions at{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {0, 1, 1}};
  REQUIRE(m.vertex_count() == 8);
  const Paint paint = side_by_side({{m, at}, {m, at, {}, {"words"}}}, {}, true, 200);
  const Picture picture{paint, {}};
  CHECK(difference(render(paint, "svg"), raster_by_cairo(picture)) < kFewPixels);
}

TEST_CASE("a PNG is white up to its rim", "[figures][raster]") {
  const Paint paint = [](Canvas& canvas) { canvas.circle({0, 0}, 10.3, rgb(0x000000), {}); };
  tests::spill(tests::scratch() / "circle.png", render(paint, "png", {.resolution = 100}));
  const Raster raster = read_png(tests::scratch() / "circle.png");
  for (int x = 0; x < raster.width; ++x) CHECK(raster.at(x, raster.height - 1) == 255);
  for (int y = 0; y < raster.height; ++y) CHECK(raster.at(raster.width - 1, y) == 255);
}

TEST_CASE("the comparison of renderers sees letters whose paths lack their line commands", "[figures][raster]") {
  if (!has_renderer()) return;
  constexpr std::size_t kStep = 6;  // some figures suffice: all have letters
  for (std::size_t i = 0; i < catalogue().size(); i += kStep) {
    const CatalogueEntry& entry = catalogue()[i];
    INFO(entry.id);
    const Picture picture = entry.make({});
    std::string svg = render(picture.paint, "svg");
    const Raster expected = raster_by_cairo(picture);
    for (std::size_t at = 0; (at = svg.find("L ", at)) != std::string::npos;) svg.erase(at, 2);
    CHECK(difference(svg, expected) >= kFewPixels);
  }
}
