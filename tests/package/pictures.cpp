// A user of requad::pictures: a circle as SVG.
#include <requad/mesh/pictures/page.hpp>

int main() {
  using namespace requad::pictures;
  const std::string svg = render([](Canvas& canvas) { canvas.circle({0, 0}, 5, rgb(0xd55e00), {}); }, "svg");
  return svg.find("<svg") != std::string::npos ? 0 : 1;
}
