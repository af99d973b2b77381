// Grid figures through Graphviz: DOT by libcgraph, pictures by libgvc.
#pragma once

#include <string>

#include "figures/grid_figure.hpp"

namespace requad::figures {

// DOT with positions in points, so that `neato -n2` draws the grid as it is. Nodes carry d1, d2, p, faces and the
// signature of their mesh (copies also same_as), edges the step, its basic operations and the faces it makes. The same
// figure gives the same bytes.
std::string to_dot(const GridFigure& figure);

// The picture in a format that Graphviz knows: svg, png, pdf. Throws std::runtime_error if Graphviz refuses.
std::string render(const GridFigure& figure, const std::string& format);

}  // namespace requad::figures
