// How a drawing looks: colours by what they mean, letters, widths of lines.
//
// Every figure takes its colours from a palette and its letters from a style, both of which the canvas holds. A shape or
// a dash says what a colour says, for print without colours and for readers who do not see them.
//
// Palettes
//   colour  Okabe and Ito's colours, with darker ones for what is also written
//   grey    black, greys and white
//   print   colours for paper: their greys differ too, so that a photocopy tells them apart
// In each palette, a colour in which words are written has a contrast of at least 4.5 with every ground (the Web Content
// Accessibility Guidelines' bound for text).
#pragma once

#include <string>
#include <vector>

namespace requad::pictures {

struct Colour {
  double red = 0, green = 0, blue = 0;  // 0..1, sRGB

  friend bool operator==(const Colour&, const Colour&) = default;
};
// The colour 0xRRGGBB.
constexpr Colour rgb(unsigned value) {
  return {(value >> 16 & 255U) / 255.0, (value >> 8 & 255U) / 255.0, (value & 255U) / 255.0};
}
std::string to_hex(Colour colour);  // "#rrggbb"
// Relative luminance, 0 (black) to 1 (white), and the contrast of two colours, 1 to 21, as those guidelines define them.
double luminance(Colour colour);
double contrast(Colour a, Colour b);

struct Palette {
  // Lines and words. Words are written in `ink`, `faint_ink`, `path`, `side` and the three colours of grids.
  Colour paper = rgb(0xffffff);
  Colour ink = rgb(0x000000);        // words, arrows between panels, outlines of marks
  Colour line = rgb(0x404040);       // edges of meshes
  Colour faint = rgb(0xc4c4c4);      // edges of what is drawn once more
  Colour faint_ink = rgb(0x6b6b6b);  // words about it
  Colour path = rgb(0x007a59);       // paths and separatrices
  Colour side = rgb(0xb34a00);       // boundaries of regions, directions of moves
  Colour even = rgb(0xb34a00);       // grids, by the parity of d1 + d2
  Colour odd = rgb(0x0068a6);
  Colour single = rgb(0x007a59);  // a grid that has no parity
  // Irregular vertices.
  Colour v2 = rgb(0xcc79a7);
  Colour v3 = rgb(0x0072b2);
  Colour v5 = rgb(0xe69f00);
  Colour v6 = rgb(0xd55e00);  // and all other valences
  // Faces.
  Colour pair = rgb(0x8fc3e3);  // R_alpha
  Colour ring = rgb(0xdedede);  // around it
  Colour stay = rgb(0xdcecf6);
  Colour made = rgb(0xf6ec7a);
  Colour made_sign = rgb(0x5c5400);
  Colour deleted = rgb(0xf0a080);
  Colour deleted_sign = rgb(0x6e1d00);
  // Meshes in space, before the light falls on them.
  Colour quad = rgb(0xf1ede2);
  Colour dark_quad = rgb(0x8fb0c6);  // of a checkerboard
  Colour back = rgb(0xb59f86);
  Colour inverted = rgb(0xf08fb4);
  // Points.
  Colour first_star = rgb(0xf0e442);
  Colour second_star = rgb(0xd55e00);
  Colour convex = rgb(0x0072b2);
  Colour concave = rgb(0xd55e00);

  Colour valence(int valence) const { return valence == 2 ? v2 : valence == 3 ? v3 : valence == 5 ? v5 : v6; }
};
const std::vector<std::string>& palette_names();
// Throws std::invalid_argument for another name.
Palette palette(const std::string& name);

struct Style {
  Palette palette = {};
  std::string font = "sans-serif";  // a family, as fontconfig knows it
  double text = 10;                 // size of letters, in points on the page
  // Width of a mesh's edges, in points on the page; other lines keep their ratio to it. 0: half a point, or less if the
  // drawing is scaled down.
  double line = 0;
  bool labels = true;    // words that name vertices, paths, sides and configurations
  bool captions = true;  // words below panels, and legends
};

}  // namespace requad::pictures
