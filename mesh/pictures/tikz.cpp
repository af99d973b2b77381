#include <cmath>
#include <map>
#include <set>

#include "mesh/pictures/layout_on_page.hpp"
#include "mesh/text/fixed_decimals.hpp"

namespace requad::pictures {

namespace {

std::string tex_number(double x) { return mesh::short_decimals(x, 3); }
// "0072B2": xcolor wants capitals.
std::string hex(Colour colour) {
  std::string digits = to_hex(colour).substr(1);
  for (char& c : digits) {
    if (c >= 'a') c = static_cast<char>(c - 'a' + 'A');
  }
  return digits;
}
std::string name(Colour colour) { return "requad" + hex(colour); }

// Text in which no character has a meaning to TeX.
std::string in_tex(const std::string& text) {
  static const std::map<std::string, std::string> special{
      {"\\", "\\textbackslash{}"},
      {"~", "\\textasciitilde{}"},
      {"^", "\\textasciicircum{}"},
      {"&", "\\&"},
      {"%", "\\%"},
      {"$", "\\$"},
      {"#", "\\#"},
      {"_", "\\_"},
      {"{", "\\{"},
      {"}", "\\}"},
      {"α", "\\ensuremath{\\alpha}"},
  };
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t length = 1;  // of a character in UTF-8
    while (i + length < text.size() && (static_cast<unsigned char>(text[i + length]) & 0xC0U) == 0x80) ++length;
    const std::string character = text.substr(i, length);
    const auto found = special.find(character);
    result += found == special.end() ? character : found->second;
    i += length;
  }
  return result;
}

class Writer {
 public:
  explicit Writer(const PlacedDrawing& placed) : placed_(placed) {}

  void operator()(const Shape& shape) {
    begin_path(shape.fill, shape.stroke);
    for (const Polyline& line : shape.lines) {
      bool first = true;
      for (const Point& p : placed_.at(line)) {
        text_ += (first ? " " : "--") + at(p);
        first = false;
      }
      if (shape.closed) text_ += "--cycle";
    }
    text_ += ";\n";
  }

  void operator()(const Arc& arc) {
    begin_path(arc.fill, arc.stroke);
    const double radius = placed_.scale * arc.radius;
    const Point centre = placed_.at(arc.centre);
    if (arc.whole()) {
      text_ += " " + at(centre) + " circle[radius=" + tex_number(radius) + "];\n";
      return;
    }
    const auto degrees = [](double angle) { return tex_number(angle * 180 / std::numbers::pi); };
    text_ += " " + at(centre + radius * Point(std::cos(arc.from), std::sin(arc.from))) +
             " arc[start angle=" + degrees(arc.from) + ",end angle=" + degrees(arc.to) +
             ",radius=" + tex_number(radius) + "];\n";
  }

  void operator()(const Words& words) {
    const double size = placed_.scale * words.size;
    const char* const anchor = words.anchor == Anchor::left     ? "base west"
                               : words.anchor == Anchor::centre ? "base"
                                                                : "base east";
    text_ += std::string("\\node[anchor=") + anchor + ",text=" + used(words.colour);
    if (words.halo) text_ += ",fill=" + used(*words.halo) + ",inner sep=" + tex_number(kHalo * size / 2) + "bp";
    text_ += ",font=\\fontsize{" + tex_number(size) + "bp}{" + tex_number(1.25 * size) + "bp}\\selectfont] at " +
             at(placed_.at(words.at)) + " {";
    for (const WordPart& part : parts_of(words.text)) {
      if (part.text.empty()) continue;
      text_ += part.lowered ? "\\textsubscript{" + in_tex(part.text) + "}" : in_tex(part.text);
    }
    text_ += "};\n";
  }

  std::string colours() const {
    std::string text;
    for (const std::string& hex : colours_) text += "\\definecolor{requad" + hex + "}{HTML}{" + hex + "}\n";
    return text;
  }
  const std::string& text() const { return text_; }

 private:
  std::string at(const Point& p) const {
    return "(" + tex_number(p.x() - placed_.low.x()) + "," + tex_number(p.y() - placed_.low.y()) + ")";
  }
  std::string used(Colour colour) {
    colours_.insert(hex(colour));
    return name(colour);
  }
  void begin_path(const std::optional<Colour>& fill, const std::optional<Stroke>& stroke) {
    std::string options;
    const auto add = [&options](const std::string& option) { options += (options.empty() ? "" : ",") + option; };
    if (fill) add("fill=" + used(*fill));
    if (stroke) {
      add("draw=" + used(stroke->colour));
      add("line width=" + tex_number(placed_.scale * stroke->width) + "bp");
      if (!stroke->dashes.empty()) {
        std::string pattern = "dash pattern=";
        for (std::size_t i = 0; i < stroke->dashes.size(); ++i)
          pattern += (i % 2 == 0 ? "on " : "off ") + tex_number(placed_.scale * stroke->dashes[i]) + "bp ";
        add(pattern.substr(0, pattern.size() - 1));
      }
    }
    text_ += "\\path[" + options + "]";
  }

  const PlacedDrawing& placed_;
  std::set<std::string> colours_;
  std::string text_;
};

// A comment of one line.
std::string comment(const std::string& text) {
  std::string line = "% " + text;
  for (char& c : line) {
    if (c == '\n') c = ' ';
  }
  return line + "\n";
}

}  // namespace

std::string tikz(const PlacedDrawing& placed, const Page& page) {
  Writer writer(placed);
  for (const Item& item : placed.drawing.items) std::visit(writer, item);
  return (page.title.empty() ? "" : comment(page.title)) +
         comment(
             "Usage: \\usepackage{tikz} in the preamble, and \\input of this file. Words have the document's font.") +
         "\\begin{tikzpicture}[x=1bp,y=1bp,line join=round,line cap=round,inner sep=0pt]\n" + writer.colours() +
         "\\useasboundingbox (0,0) rectangle (" + tex_number(placed.size.x()) + "," + tex_number(placed.size.y()) +
         ");\n" + writer.text() + "\\end{tikzpicture}\n";
}

}  // namespace requad::pictures
