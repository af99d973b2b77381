#include "figures/pictures/catalogue.hpp"

#include "figures/pictures/basic_operation_pictures.hpp"
#include "figures/pictures/grid_picture.hpp"
#include "figures/pictures/pair_move_pictures.hpp"
#include "figures/pictures/region_pictures.hpp"
#include "figures/pictures/vertex_pictures.hpp"

namespace requad::figures {

namespace {

Picture grid_picture(GridFigure figure) {
  Paint paint = paint_grid(figure);
  return {std::move(paint), std::move(figure)};
}
Picture dual_picture(theory::PairType type, int length) {
  GridFigure figure = dual_figure(type, length);
  Paint paint = paint_dual(figure);
  return {std::move(paint), std::move(figure)};
}
template <class Maker>
std::function<Picture(const Choices&)> drawn(Maker maker) {
  return [maker](const Choices&) { return Picture{maker(), {}}; };
}

}  // namespace

std::string CatalogueEntry::file() const { return (*paper == '\0' ? "" : "figure-") + std::string(id); }

const std::vector<CatalogueEntry>& catalogue() {
  static const std::vector<CatalogueEntry> entries{
      {"2", "2", "The three basic operations",
       "A quad collapse merges two opposite corners of a quad. An edge split opens a path of two edges into a quad. "
       "An edge flip turns an edge by one corner of the hexagon around it. Below: a flip is a split and a collapse.",
       false, "", drawn(paint_basic_operations)},
      {"3", "3", "The six moves of an adjacent 3-5 pair",
       "Seen from the v3 down to the v5, the pair can make a collapse, a flip or a split on either hand. Afterwards "
       "it is the same pair, one step further, and no other vertex is irregular. Grey: the quads at the pair.",
       false, "", drawn(paint_adjacent_pair_moves)},
      {"4", "4", "Moving a single v3 or v5",
       "Each move leaves an adjacent 3-5 pair where the vertex was. Above: a v3 moves up by two collapses and two "
       "flips. Below: a v5 moves up by two flips and two splits.",
       false, "", drawn(paint_vertex_moves)},
      {"5", "5", "Parting a v2 and a v6",
       "One collapse parts a v2 into two v3s, and one even split parts a v6 into two v5s.", false, "",
       drawn(paint_type_changes)},
      {"6", "6", "The four moves of a 3-5 pair",
       "Above, one separatrix joins the pair; below, the pair spans a 2 x 1 grid. Each column shows one move, before "
       "and after. The green path keeps its shape, and its length says how many quads are made or deleted. Blue: the "
       "strips around the change, which stay.",
       false, "", drawn(paint_pair_moves)},
      {"7", "7", "A move that goes round a feature",
       "The direct move would flip an edge of the feature (black), so it is refused. Instead an adjacent 3-5 pair "
       "goes from the v5 round the end of the feature to the v3. The result is the configuration that the direct move "
       "would have made.",
       false, "", drawn(paint_detour)},
      {"8", "8", "Two moves of a 3-3 pair",
       "From (3,1) by (-1,+1) to (2,2), then by (+1,+1) to (3,3). The next move deletes the red quads; the last move "
       "made the yellow ones.",
       false, "", drawn(paint_equal_pair_moves)},
      {"10", "10", "All configurations of a 3-3 pair in a regular digon",
       "The even side 6 is red and solid, the odd side 5 blue and dashed. (m,n) are the extents of the blue grid "
       "between the two v3s, and grey is the smallest digon that holds them. The faint meshes on the left are those "
       "on the right once more: (0,x) is (x,0). At (0,0) the pair has merged into a v2.",
       true, "side", [](const Choices& c) { return grid_picture(figure_10(c.side.value_or(6))); }},
      {"11", "11", "All configurations of a 5-5 pair in a regular hexagon",
       "Sides 6 (red, solid) and 5 (blue, dashed): half cubes in projection. The segment of (x,0,p) points along the "
       "axis on which it lies. At (0,0) the pair has merged into a v6.",
       true, "side", [](const Choices& c) { return grid_picture(figure_11(c.side.value_or(6))); }},
      {"12", "12", "All configurations of a 3-5 pair in a quadrilateral",
       "A move carries the pair one step towards a side and changes nothing else. (m,n) are the distances of the red "
       "and the yellow star from the corner between them.",
       true, "pair-region",
       [](const Choices& c) {
         return grid_picture(figure_12(c.pair_region[0], c.pair_region[1], c.pair_region[2], c.pair_region[3]));
       }},
      {"13", "13", "Turns of paths, and the smallest regions",
       "(a) A turn with one quad on the left (blue) is convex for the region on the left; a turn with three (red, "
       "upside down) is concave. (b) The smallest convex region around R_alpha (blue) is its ring of quads (grey).",
       false, "", drawn(paint_turns_and_smallest)},
      {"14", "14", "Separatrices, strips and sides",
       "Separatrix i (green) crosses side i at the star, after e_i strips. The sides obey E_i = e_(i-1) + e_(i+1), "
       "plus d_1 or d_2 where the neighbouring side belongs to the other vertex.",
       false, "", drawn(paint_separatrices)},
      {"dual-10", "", "Figure 10's two grids are dual",
       "Both cones are opened to disks, and level m + n is the circle of that radius. Every blue edge crosses one red "
       "edge, and every red edge inside the last blue circle crosses one blue edge. The self-loop of (1,0) goes round "
       "(0,0) and crosses its only edge.",
       true, "side", [](const Choices& c) { return dual_picture(theory::kDigon, c.side.value_or(6)); }},
      {"dual-11", "", "Figure 11's two grids are dual", "The same for the hexagons of side 6 and 5.", true, "side",
       [](const Choices& c) { return dual_picture(theory::kHexagon, c.side.value_or(6)); }},
      {"unfolded-11", "", "The half cube laid flat",
       "The regular hexagon of side 5: three quadrants of a square grid around one corner, cut open along an axis. "
       "The faint meshes are the other bank of the cut.",
       true, "side", [](const Choices& c) { return grid_picture(unfolded_figure(c.side.value_or(5))); }},
      {"hexagon", "", "A hexagon that is not regular",
       "Sides 4 5 4 4 5 4. The configurations are a part of a half cube, and moves still join all of them.", true,
       "sides", [](const Choices& c) { return grid_picture(hexagon_figure(c.sides)); }},
      {"octagon", "", "Nine configurations of a single v8",
       "Theorem 7.1 says that a region with a single irregular vertex has one configuration unless 4 divides the "
       "valence. This is sharp: a v8 has (L-1)^2 configurations in a regular octagon of side L. Here L = 4.",
       false, "side",
       [](const Choices& c) {
         return Picture{paint_lone_v8(c.side.value_or(4)), {}};
       }},
  };
  return entries;
}

std::string gallery_page() {
  std::string page =
      "# Gallery\n\n"
      "Figures of the paper, and some of our own. The library's operations or generators made every mesh, and every "
      "drawing is computed. `requad-figures -o DIR` makes all of them. Use `--format pdf` or `png` for other formats "
      "and `--side L` for other sizes.\n\n"
      "An irregular vertex is drawn as a polygon with as many corners as its valence: v3 blue, v5 orange, v6 and more "
      "red, v2 (a rhombus) purple. A quad that was made is yellow and has a plus along its strips. A quad that is "
      "deleted is red and has a cross from corner to corner. So the figures can be read without colours.\n";
  for (const CatalogueEntry& entry : catalogue()) {
    page += "\n## " + std::string(*entry.paper == '\0' ? "" : "Figure " + std::string(entry.paper) + ": ") +
            entry.title + "\n\n";
    page += std::string("![") + entry.title + "](" + entry.file() + ".svg)\n\n" + entry.caption + "\n\n";
    page += "    requad-figures --figure " + std::string(entry.id) + " --format svg\n";
  }
  return page;
}

}  // namespace requad::figures
