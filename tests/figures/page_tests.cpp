// Pages: what a style, a width and a format change, and how words stand on what is behind them.
#include <cmath>
#include <cstdlib>
#include <regex>
#include <set>
#include <sstream>

#include "figures/pictures/catalogue.hpp"
#include "mesh/pictures/page.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::figures;

namespace {

Drawing drawing_of(const Paint& paint, const Style& style = {}, double scale = 1) {
  Canvas canvas(style, scale);
  paint(canvas);
  return canvas.drawing();
}

std::vector<Words> words_of(const Drawing& drawing) {
  std::vector<Words> words;
  for (const Item& item : drawing.items) {
    if (const auto* w = std::get_if<Words>(&item)) words.push_back(*w);
  }
  return words;
}

Paint figure(const std::string& id) {
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.id == id) return entry.make({}).paint;
  }
  throw std::logic_error("no figure " + id);
}

bool inside(const Point& p, const Polyline& polygon) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point &a = polygon[i], &b = polygon[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      in = !in;
  }
  return in;
}

// The least contrast of the words of a drawing with what is behind them: the halo if there is one, else the areas that
// were filled before, at nine points of what the words take up.
double least_contrast(const Drawing& drawing, const Palette& palette) {
  double least = 21;
  for (std::size_t i = 0; i < drawing.items.size(); ++i) {
    const auto* words = std::get_if<Words>(&drawing.items[i]);
    if (words == nullptr) continue;
    const auto [low, high] = words->box();
    for (int k = 0; k < 9; ++k) {
      const Point p = low + Point((k % 3 + 0.5) / 3 * (high - low).x(), (k / 3 + 0.5) / 3 * (high - low).y());
      Colour ground = palette.paper;
      for (std::size_t j = 0; j < i; ++j) {
        const auto* shape = std::get_if<Shape>(&drawing.items[j]);
        const auto* arc = std::get_if<Arc>(&drawing.items[j]);
        if (shape != nullptr && shape->fill) {
          for (const Polyline& polygon : shape->lines) ground = inside(p, polygon) ? *shape->fill : ground;
        }
        if (arc != nullptr && arc->fill && (p - arc->centre).norm() < arc->radius) ground = *arc->fill;
      }
      least = std::min(least, contrast(words->colour, words->halo.value_or(ground)));
    }
  }
  return least;
}

bool overlap(const Words& a, const Words& b) {
  const auto [a_low, a_high] = a.box();
  const auto [b_low, b_high] = b.box();
  return (a_low.array() < b_high.array()).all() && (b_low.array() < a_high.array()).all();
}

// Whether a segment runs through a box.
bool crosses(const Point& a, const Point& b, const std::pair<Point, Point>& box) {
  double from = 0, to = 1;
  for (int k = 0; k < 2; ++k) {
    const double d = b[k] - a[k];
    if (std::abs(d) < 1e-9) {
      if (a[k] < box.first[k] || a[k] > box.second[k]) return false;
      continue;
    }
    const double s = (box.first[k] - a[k]) / d, t = (box.second[k] - a[k]) / d;
    from = std::max(from, std::min(s, t));
    to = std::min(to, std::max(s, t));
  }
  return from < to;
}

std::size_t count(const std::string& text, const std::string& words) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(words, at)) != std::string::npos; at += words.size()) ++n;
  return n;
}

std::set<double> stroke_widths(const std::string& svg) {
  std::set<double> widths;
  const std::regex width("stroke-width:([0-9.]+)");
  for (std::sregex_iterator it(svg.begin(), svg.end(), width), end; it != end; ++it)
    widths.insert(std::stod((*it)[1].str()));
  return widths;
}

int big_endian(const std::string& bytes, std::size_t at) {
  int x = 0;
  for (std::size_t i = 0; i < 4; ++i) x = x * 256 + static_cast<unsigned char>(bytes[at + i]);
  return x;
}

}  // namespace

TEST_CASE("contrast as the Web Content Accessibility Guidelines define it", "[figures]") {
  CHECK(contrast(rgb(0x000000), rgb(0xffffff)) == Approx(21));
  CHECK(contrast(rgb(0xffffff), rgb(0x767676)) == Approx(4.54).margin(0.005));  // their limit for grey on white
}

TEST_CASE("words have a contrast of 4.5 with their ground in every figure and palette", "[figures]") {
  for (const std::string& name : palette_names()) {
    for (const CatalogueEntry& entry : catalogue()) {
      INFO(entry.id << ", " << name);
      const Style style{.palette = palette(name)};
      CHECK(least_contrast(drawing_of(entry.make({}).paint, style), style.palette) >= 4.5);
    }
  }
  // Okabe and Ito's green on white: 3.4.
  Style pale;
  pale.palette.path = rgb(0x009e73);
  CHECK(least_contrast(drawing_of(figure("14"), pale), pale.palette) < 4.5);
}

TEST_CASE("what colours tell apart, greys tell apart in the palettes for paper", "[figures]") {
  for (const std::string name : {"grey", "print"}) {
    const Palette p = palette(name);
    for (const auto& [a, b] : {std::pair{p.even, p.odd},
                               {p.path, p.side},
                               {p.v3, p.v5},
                               {p.v5, p.v6},
                               {p.pair, p.ring},
                               {p.made, p.deleted}})
      CHECK(contrast(a, b) >= 1.25);
  }
  const std::string svg = render(figure("6"), "svg", {.style = {.palette = palette("grey")}});
  const std::regex colour("rgb\\(([0-9.]+)%,([0-9.]+)%,([0-9.]+)%\\)");
  for (std::sregex_iterator it(svg.begin(), svg.end(), colour), end; it != end; ++it) {
    CHECK((*it)[1] == (*it)[2]);
    CHECK((*it)[1] == (*it)[3]);
  }
}

TEST_CASE("no words of a figure overlap, and no label of a grid lies on an edge", "[figures]") {
  for (const CatalogueEntry& entry : catalogue()) {
    const Paint paint = entry.make({}).paint;
    for (const double scale : {1.0, 0.5, 0.35}) {
      // So small, figure 14 has no room for the names round R_alpha, nor figure 9 for the numbers of arrows between a pair.
      if (scale < 0.5 && (std::string(entry.id) == "14" || std::string(entry.id) == "9")) continue;
      INFO(entry.id << ", scale " << scale);
      const Style style;
      const Drawing drawing = drawing_of(paint, style, scale);
      const std::vector<Words> words = words_of(drawing);
      for (std::size_t i = 0; i < words.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          INFO(words[i].text << " and " << words[j].text);
          CHECK(!overlap(words[i], words[j]));
        }
      }
      if (!entry.is_grid || std::string(entry.id).starts_with("dual")) continue;
      for (const Item& item : drawing.items) {
        const auto* edge = std::get_if<Shape>(&item);
        if (edge == nullptr || !edge->stroke || edge->closed || edge->lines.size() != 1) continue;
        for (const Words& w : words) {
          INFO(w.text);
          CHECK(!crosses(edge->lines[0].front(), edge->lines[0].back(), w.box()));
        }
      }
    }
  }
}

TEST_CASE("a page is as wide as asked, and letters keep their size", "[figures]") {
  for (const std::string id : {"2", "6", "10", "14", "dual-10"}) {
    INFO(id);
    const Page page{.style = {.text = 8}, .width = 420, .real_text = true};
    const std::string svg = render(figure(id), "svg", page);
    CHECK(svg.find("<svg ") < svg.find(" width=\"420pt\" "));
    CHECK(count(svg, "<text ") == count(svg, "font-size=\"8\" fill"));
    const std::string pdf = render(figure(id), "pdf", page);
    CHECK(pdf.find("/MediaBox [ 0 0 420 ") != std::string::npos);
    const std::string png = render(figure(id), "png", {.style = {.text = 8}, .width = 420, .resolution = 72});
    CHECK(big_endian(png, 16) == 420);
  }
  CHECK_THROWS_AS(render(figure("10"), "svg", {.width = 60}), std::invalid_argument);
}

TEST_CASE("a style changes fonts, lines, labels and captions", "[figures]") {
  const Paint paint = figure("14");
  const std::string usual = render(paint, "svg");
  CHECK(render(paint, "svg", {.style = {.font = "monospace"}}) != usual);
  const std::set<double> thin = stroke_widths(render(paint, "svg", {.style = {.line = 0.25, .captions = false}})),
                         thick = stroke_widths(render(paint, "svg", {.style = {.line = 1, .captions = false}}));
  REQUIRE(!thin.empty());
  CHECK(thin.count(0.25) == 1);
  CHECK(thick.count(1) == 1);
  const auto texts = [&](const Style& style) { return words_of(drawing_of(paint, style)).size(); };
  CHECK(texts({.labels = false}) == 3);                          // (a), (b), (c)
  CHECK(texts({.captions = false}) == 2 * (2 + 6 + 4) + 3 * 4);  // E_i and e_i of each side; v_1, v_2, d_1, d_2
  CHECK(texts({.labels = false, .captions = false}) == 0);
}

TEST_CASE("an SVG has a title, a description, no raster, and real text only on request", "[figures]") {
  for (const CatalogueEntry& entry : catalogue()) {
    INFO(entry.id);
    const Paint paint = entry.make({}).paint;
    const std::string svg = render(paint, "svg", {.title = "A < B", .description = "C & D"});
    CHECK(count(svg, "<title>A &lt; B</title>") == 1);
    CHECK(count(svg, "<desc>C &amp; D</desc>") == 1);
    CHECK(count(svg, "<image") == 0);
    CHECK(count(svg, "<text") == 0);
    CHECK(count(svg, "<symbol") > 0);  // letters as outlines
    const std::string real = render(paint, "svg", {.style = {.font = "serif"}, .real_text = true});
    CHECK(count(real, "<text ") == words_of(drawing_of(paint, {.font = "serif"})).size());
    CHECK(count(real, "<symbol") == 0);
    CHECK(count(real, "<g font-family=\"serif\">") == 1);
  }
}

TEST_CASE("a PDF has a title, a PNG its resolution", "[figures]") {
  const std::string pdf = render(figure("8"), "pdf", {.title = "Two moves"});
  CHECK(pdf.find("/Title (Two moves)") != std::string::npos);
  const std::string usual = render(figure("8"), "png"), fine = render(figure("8"), "png", {.resolution = 288});
  CHECK(big_endian(fine, 16) == 2 * big_endian(usual, 16));
  const std::size_t at = fine.find("pHYs");
  REQUIRE(at != std::string::npos);
  CHECK(big_endian(fine, at + 4) == 11339);  // 288 dots per inch, in dots per metre
}

TEST_CASE("TikZ: balanced, with every colour defined, a node for all words, and accepted by LaTeX", "[figures]") {
  for (const CatalogueEntry& entry : catalogue()) {
    INFO(entry.id);
    const Paint paint = entry.make({}).paint;
    const std::string tex = render(paint, "tikz", {.title = "Title"});
    CHECK(tex.starts_with("% Title\n"));
    CHECK(count(tex, "\\begin{tikzpicture}") == 1);
    CHECK(count(tex, "\\end{tikzpicture}") == 1);
    CHECK(count(tex, "{") == count(tex, "}"));
    CHECK(count(tex, "\\node[") == words_of(drawing_of(paint)).size());
    CHECK(count(tex, "\\path[") + count(tex, "\\node[") == drawing_of(paint).items.size());
    CHECK(count(tex, "nan") == 0);
    const std::regex colour("(?:fill|draw|text)=(requad[0-9A-F]{6})");
    for (std::sregex_iterator it(tex.begin(), tex.end(), colour), end; it != end; ++it)
      CHECK(count(tex, "\\definecolor{" + (*it)[1].str() + "}") == 1);
    std::istringstream lines(tex);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("\\path") || line.starts_with("\\node")) CHECK(line.back() == ';');
      for (const char c : line) REQUIRE(static_cast<unsigned char>(c) < 128);
    }
  }
  if (std::system("pdflatex --version >/dev/null 2>&1") != 0) {
    WARN("skipped in part: there is no pdflatex");
    return;
  }
  tests::spill(tests::scratch() / "figure.tex", render(figure("14"), "tikz"));
  tests::spill(tests::scratch() / "paper.tex",
               "\\documentclass{article}\\usepackage{tikz}\\begin{document}\\input{figure}\\end{document}\n");
  CHECK(tests::shell("pdflatex -interaction=nonstopmode -halt-on-error paper.tex >/dev/null").code == 0);
}

TEST_CASE("options of pages: what they refuse, and file names that tell sizes", "[figures][programs]") {
  const auto refused = [](const std::string& arguments, const std::string& words) {
    const tests::Outcome outcome = tests::call("figures", arguments);
    INFO(arguments << ": " << outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find(words) != std::string::npos);
  };
  refused("--figure 10 --format dot --width 240", "--width has no effect unless the format is svg, pdf, png or tikz");
  refused("--figure 2 --format tikz --font serif", "--font has no effect unless the format is svg, pdf or png");
  refused("--figure 2 --format pdf --real-text", "--real-text has no effect unless the format is svg");
  refused("--figure 2 --resolution 300 -o x.svg", "--resolution has no effect unless the format is png");
  refused("--figure 2 --no-labels", "have no labels");
  refused("--figure 2 --width 240in", "--width");
  refused("--figure 2 --width 3pt", "is not a width");
  refused("--figure 10 --width 100", "too narrow");
  refused("--figure 2 --palette blue", "--palette: 'blue' is not one of colour, grey, print");
  refused("--figure 2 --font-size 0", "--font-size");

  const auto made = [](const std::string& arguments) {
    const tests::Outcome outcome = tests::call("figures", arguments + " -o named");
    INFO(outcome.err);
    CHECK(outcome.code == 0);
    return outcome.out;
  };
  CHECK(made("--figure 10 --side 7 --format svg --format graphml").find("figure-10-side-7.svg") != std::string::npos);
  CHECK(std::filesystem::exists(tests::scratch() / "named" / "figure-10-side-6.graphml"));
  CHECK(made("--figure 10 --side 6 --format svg").find("figure-10.svg") != std::string::npos);
  CHECK(made("--figure 12 --pair-region 1,0,2,2 --format tikz").find("figure-12-region-1-0-2-2.tex") !=
        std::string::npos);
  CHECK(made("--figure hexagon --sides 3,4,5,4,3,5 --format pdf").find("hexagon-sides-3-4-5-4-3-5.pdf") !=
        std::string::npos);
  // 85 mm are 240.9 points.
  CHECK(made("--figure 8 --width 85mm --format svg").find("figure-8.svg") != std::string::npos);
  CHECK(tests::slurp(tests::scratch() / "named" / "figure-8.svg").find(" width=\"240.94") != std::string::npos);
}
