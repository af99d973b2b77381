#include "mesh/pictures/page_options.hpp"

#include <algorithm>
#include <utility>

#include "mesh/text/fixed_decimals.hpp"

namespace requad::pictures {

namespace {

using program::Option;
using program::Options;
using program::UsageError;
using FormatsOf = std::function<std::vector<std::string>(const Options&)>;

constexpr double kPointsPerMillimetre = 72 / 25.4;
constexpr double kColumnText = 8;  // size of letters on a page whose width is asked for
constexpr double kNarrowest = 20, kWidest = 10'000;
constexpr double kLargestRaster = 30'000;  // pixels in a row, which Cairo's images may have

// "240", "240pt" or "85mm", in points.
double length(const std::string& text, const std::string& what) {
  const auto ends_with = [&](const std::string& unit) {
    return text.size() > unit.size() && text.compare(text.size() - unit.size(), unit.size(), unit) == 0;
  };
  const bool millimetres = ends_with("mm");
  const std::string digits = text.substr(0, text.size() - (millimetres || ends_with("pt") ? 2 : 0));
  const double points = program::parse_number(digits, what) * (millimetres ? kPointsPerMillimetre : 1);
  if (points < kNarrowest || points > kWidest)
    throw UsageError(what + ": '" + text + "' is not a width of 20 to 10000 points, as 240pt or 85mm");
  return points;
}

// The option, which changes these formats only.
Option for_formats(Option option, const FormatsOf& formats_of, std::vector<std::string> formats) {
  const std::string name = option.long_name();
  return program::only_if(std::move(option), [=](const Options& options) -> std::string {
    const std::vector<std::string> written = formats_of(options);
    const bool has_one = std::any_of(written.begin(), written.end(), [&](const std::string& format) {
      return std::find(formats.begin(), formats.end(), format) != formats.end();
    });
    if (has_one) return "";
    std::string needed;
    for (std::size_t i = 0; i < formats.size(); ++i)
      needed += (i == 0 ? "" : i + 1 < formats.size() ? ", " : " or ") + formats[i];
    return "--" + name + " has no effect unless the format is " + needed;
  });
}

}  // namespace

std::vector<Option> page_options(const FormatsOf& formats_of, const std::function<bool(const Options&)>& has_labels) {
  const std::vector<std::string> drawn{"svg", "pdf", "png", "tikz"};
  const auto all = [&](Option option) { return for_formats(std::move(option), formats_of, drawn); };
  std::vector<Option> options{
      all(program::value("width", "W",
                         "the width of the page, as 240pt or 85mm (points if there is no unit); meshes are scaled to "
                         "it, letters are not (default: as the figure needs)")),
      for_formats(program::value("font", "FAMILY", "the letters' family (default sans-serif)"), formats_of,
                  {"svg", "pdf", "png"}),
      all(program::value("font-size", "POINTS", "the letters' size on the page (default 10; 8 with --width)")),
      all(program::value("line-width", "POINTS",
                         "the width of a mesh's edges on the page; other lines keep their ratio to it (default 0.5, "
                         "less where --width makes meshes smaller)")),
      all(program::value("palette", "colour|grey|print",
                         "colours; greys; or colours whose greys differ as well, for paper (default colour)")),
      all(program::flag("no-captions", "leave out the words below panels, and legends")),
      for_formats(program::flag("real-text",
                                "write letters as text that can be searched and edited; the reader needs the font "
                                "(default: outlines)"),
                  formats_of, {"svg"}),
      for_formats(program::value("resolution", "DPI", "dots per inch of a PNG, 10..2400 (default 144)"), formats_of,
                  {"png"}),
  };
  if (has_labels) {
    options.push_back(
        program::only_if(all(program::flag("no-labels", "leave out the names of vertices, sides and configurations")),
                         [has_labels](const Options& given) {
                           return has_labels(given) ? "" : "--no-labels has no effect: these figures have no labels";
                         }));
  }
  return options;
}

Page page_of(const Options& options) {
  Page page;
  if (options.has("width")) page.width = length(options.text("width"), "--width");
  page.style.font = options.text("font", page.style.font);
  if (page.style.font.empty()) throw UsageError("--font: expected the name of a family, as serif");
  page.style.text = options.number("font-size", page.width ? kColumnText : page.style.text, 1, 100);
  page.style.line = options.number("line-width", 0, 0.01, 20);
  page.style.palette = palette(options.choice("palette", palette_names(), "colour"));
  page.style.labels = !options.has("no-labels");
  page.style.captions = !options.has("no-captions");
  page.real_text = options.has("real-text");
  page.resolution = options.number("resolution", page.resolution, 10, 2400);
  if (page.width && *page.width / 72 * page.resolution > kLargestRaster) {
    throw UsageError("--resolution: a page " + mesh::short_decimals(*page.width, 1) +
                     " points wide would be wider than 30000 pixels");
  }
  return page;
}

}  // namespace requad::pictures
