#include "mesh/pictures/style.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace requad::pictures {

namespace {

Palette grey() {
  Palette p;
  p.path = rgb(0x000000);
  p.side = rgb(0x5c5c5c);
  p.even = rgb(0x000000);
  p.odd = rgb(0x5c5c5c);
  p.single = rgb(0x333333);
  p.v2 = rgb(0xffffff);
  p.v3 = rgb(0x303030);
  p.v5 = rgb(0xb4b4b4);
  p.v6 = rgb(0x707070);
  p.pair = rgb(0xb0b0b0);
  p.ring = rgb(0xe2e2e2);
  p.stay = rgb(0xe8e8e8);
  p.made = rgb(0xf6f6f6);
  p.made_sign = rgb(0x000000);
  p.deleted = rgb(0xbcbcbc);
  p.deleted_sign = rgb(0x000000);
  p.quad = rgb(0xf4f4f4);
  p.dark_quad = rgb(0xa8a8a8);
  p.back = rgb(0x8c8c8c);
  p.inverted = rgb(0x505050);
  p.first_star = rgb(0xffffff);
  p.second_star = rgb(0x303030);
  p.convex = rgb(0x303030);
  p.concave = rgb(0x303030);
  return p;
}

Palette print() {
  Palette p;
  p.line = rgb(0x303030);
  p.path = rgb(0x004d38);
  p.side = rgb(0xa84600);
  p.even = rgb(0xa84600);
  p.odd = rgb(0x003f6b);
  p.single = rgb(0x004d38);
  p.v2 = rgb(0xe8b4d0);
  p.v3 = rgb(0x00456e);
  p.v5 = rgb(0xf2b233);
  p.v6 = rgb(0xc24f00);
  p.pair = rgb(0x9ac4de);
  p.ring = rgb(0xe6e6e6);
  p.stay = rgb(0xe6f1f8);
  p.made = rgb(0xfbf3a4);
  p.deleted = rgb(0xe39373);
  p.quad = rgb(0xf8f5ec);
  p.dark_quad = rgb(0x7aa3bf);
  p.convex = rgb(0x00456e);
  p.concave = rgb(0xc24f00);
  p.second_star = rgb(0xa84600);
  return p;
}

}  // namespace

std::string to_hex(Colour colour) {
  std::array<char, 8> buffer{};
  const auto byte = [](double x) { return static_cast<unsigned>(std::lround(x * 255)) & 255U; };
  std::snprintf(buffer.data(), buffer.size(), "#%02x%02x%02x", byte(colour.red), byte(colour.green), byte(colour.blue));
  return buffer.data();
}

double luminance(Colour colour) {
  const auto linear = [](double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

double contrast(Colour a, Colour b) {
  const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
  return (lighter + 0.05) / (darker + 0.05);
}

const std::vector<std::string>& palette_names() {
  static const std::vector<std::string> names{"colour", "grey", "print"};
  return names;
}

Palette palette(const std::string& name) {
  if (name == "colour") return {};
  if (name == "grey") return grey();
  if (name == "print") return print();
  throw std::invalid_argument("no such palette: " + name);
}

}  // namespace requad::pictures
