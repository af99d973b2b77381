#include "figures/pictures/catalogue.hpp"

#include "figures/pictures/examples.hpp"
#include "figures/pictures/grid_picture.hpp"
#include "figures/pictures/paper_pictures.hpp"
#include "theory/joined.hpp"

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
std::function<Picture(const Choices&, int)> drawn(Maker maker) {
  return [maker](const Choices&, int) { return Picture{maker(), {}}; };
}

constexpr std::array<int, 4> kPairRegion{2, 1, 4, 3};
const std::vector<theory::Integer> kHexagonSides{4, 5, 4, 4, 5, 4};

}  // namespace

std::string CatalogueEntry::file(const Choices& choices) const {
  std::string name = (*paper == '\0' ? "" : "figure-") + std::string(id);
  const std::string takes = choice;
  if (takes == "side" && choices.side.value_or(usual_side) != usual_side)
    name += "-side-" + std::to_string(*choices.side);
  if (takes == "pair-region" && choices.pair_region.value_or(kPairRegion) != kPairRegion)
    name += "-region-" + theory::joined(*choices.pair_region, "-");
  if (takes == "sides" && choices.sides.value_or(kHexagonSides) != kHexagonSides)
    name += "-sides-" + theory::joined(*choices.sides, "-");
  if (takes == "mesh" && choices.mesh) name += "-" + choices.mesh->name;
  return name;
}

std::string CatalogueEntry::file(const Grid& grid) const {
  return file() + "-side-" + std::to_string(grid.shape.longest());
}

const std::vector<CatalogueEntry>& catalogue() {
  static const std::vector<CatalogueEntry> entries{
      {"1", "1", "A roof with fewer irregular vertices",
       "The glass roof of a courtyard, seen from above; below, the same with its panels in two colours. (a) As it "
       "was designed. (b) Its irregular vertices have cancelled, the cheapest pairs first, and the surface is the "
       "same. Four v5s must stay.",
       false, false, "", 0, drawn(paint_roof)},
      {"2", "2", "The three basic operations",
       "A quad collapse merges two opposite corners of a quad. An edge split opens a path of two edges into a quad. "
       "An edge flip turns an edge by one corner of the hexagon around it. Below: a flip is a split and a collapse.",
       false, false, "", 0, drawn(paint_basic_operations)},
      {"3", "3", "The six moves of an adjacent 3-5 pair",
       "The pair can make a collapse, a flip or a split on either side. Afterwards it is the same pair, one step "
       "further, and no other vertex is irregular. The middle shows the two quads that can be collapsed; after a flip, "
       "the turned edge is bold. Shaded: the quads at the pair.",
       false, false, "", 0, drawn(paint_adjacent_pair_moves)},
      {"4", "4", "Moving a single v3 or v5",
       "Each move leaves an adjacent 3-5 pair where the vertex was. Above: a v3 moves up by two collapses and two "
       "flips. Below: a v5 moves up by two flips and two splits. What the operation takes is marked before, what it "
       "makes afterwards.",
       false, false, "", 0, drawn(paint_vertex_moves)},
      {"5", "5", "Parting a v2 and a v6",
       "One collapse parts a v2 into two v3s, and one even split parts a v6 into two v5s.", false, false, "", 0,
       drawn(paint_type_changes)},
      {"6", "6", "The four moves of a 3-5 pair",
       "Above, one separatrix joins the pair; below, the pair spans a 2 x 1 grid. Each column shows one move, before "
       "and after. The bold path keeps its shape. A split along it makes a quad, a collapse deletes one. Shaded: the "
       "strips around the change, which stay.",
       false, false, "", 0, drawn(paint_pair_moves)},
      {"7", "7", "A move that goes around a feature",
       "The direct move would change edges of the feature (black), so it is refused. Instead an adjacent 3-5 pair "
       "goes from the v5 around the end of the feature to the v3. The result is the configuration that the direct move "
       "would have made.",
       false, false, "", 0, drawn(paint_detour)},
      {"8", "8", "Two moves of a 3-3 pair",
       "From (3,1) by (-1,+1) to (2,2), then by (+1,+1) to (3,3). The next move deletes the quads with a cross; the "
       "last "
       "move made those with a plus.",
       false, false, "", 0, drawn(paint_equal_pair_moves)},
      {"9", "9", "The four moves of a pair, as arrows on the mesh",
       "Each move is a pair of arrows with the same number: from the two vertices of the pair to where the move "
       "brings them. A 3-5 pair moves as one. The v3s of a 3-3 pair and the v5s of a 5-5 pair move to different "
       "sides.",
       false, true, "", 0, drawn(paint_pair_on_mesh)},
      {"10", "10", "All configurations of a 3-3 pair in a regular digon",
       "The grid of the even side is solid, that of the odd side dashed. (m,n) are the extents of R_alpha, the grid "
       "between the two v3s; the shaded quads are the smallest digon that holds it. The faint meshes on the left are "
       "those on the right once more: (0,x) is (x,0). At (0,0) the pair has merged into a v2.",
       true, true, "side", 6, [](const Choices&, int side) { return grid_picture(figure_10(side)); }},
      {"11", "11", "All configurations of a 5-5 pair in a regular hexagon",
       "The grid of the even side is solid, that of the odd side dashed: half cubes in projection, the smaller one "
       "upside down. The segment of (x,0,p) points along the axis on which it lies. At (0,0) the pair has merged into "
       "a "
       "v6.",
       true, true, "side", 6, [](const Choices&, int side) { return grid_picture(figure_11(side)); }},
      {"12", "12", "All configurations of a 3-5 pair in a quadrilateral",
       "A move carries the pair one step towards a side and changes nothing else. m and n are the distances of the "
       "stars "
       "below and on the left from the corner between them.",
       true, true, "pair-region", 0,
       [](const Choices& c, int) {
         const auto [d1, d2, m, n] = c.pair_region.value_or(kPairRegion);
         return grid_picture(figure_12(d1, d2, m, n));
       }},
      {"13", "13", "Turns of paths, and the smallest regions",
       "(a) A turn with one quad on the left (a disc) is convex for the region on the left; a turn with three (a ring) "
       "is concave. (b) The smallest convex region around R_alpha is the ring of quads around it.",
       false, false, "", 0, drawn(paint_turns_and_smallest)},
      {"14", "14", "Separatrices, strips and sides",
       "Separatrix i (dashed) crosses side i at the star, after e_i strips. The sides obey E_i = e_(i-1) + e_(i+1), "
       "plus d_1 or d_2 where the neighbouring side belongs to the other vertex.",
       false, true, "", 0, drawn(paint_separatrices)},
      {"15", "15", "A dome made regular",
       "All panels of a dome run to its top. (1) The v12 is parted into v5s. (2) Each of them cancels with a v3. (3) "
       "The four v3s that must stay are moved until separatrices join them in pairs.",
       false, false, "", 0, drawn(paint_dome)},
      {"16", "16", "The corner of a block, repaired",
       "A v3 is an edge away from the corner where it belongs, and a v3 and a v5 are beside it. (1) A quad collapse "
       "moves the v3, which leaves a 3-5 pair behind. (2) The pair is transported to the other two, and all four "
       "cancel.",
       false, false, "", 0, drawn(paint_rounded_block)},
      {"17", "17", "The cap of a cylinder, repaired",
       "One of the four v3s on the cap is not aligned with the others, and a v3 and a v5 are beside it. (1) An edge "
       "flip moves the v3, which leaves a 3-5 pair behind. (2) The pair is transported to the other two, and all four "
       "cancel. The four v3s are the corners of a square. The rims (black) are features, which stay.",
       false, false, "", 0, drawn(paint_cylinder)},
      {"18", "18", "A v3 on a feature, pulled off",
       "A v3 lies on an edge of the block (black), with a single quad on one side, which is flattened to a triangle. "
       "(1) A 3-5 pair movement pulls it off the edge; the edge stays as it is. (2) Now the irregular vertices of "
       "that side can be cancelled.",
       false, false, "", 0, drawn(paint_sharp_block)},
      {"19", "19", "Four stages of a reduction",
       "Pairs of a v3 and a v5 cancel, the cheapest first. Below, the same stages with a checkerboard by greedy "
       "colouring: at a v3 or a v5, two neighbours must have the same colour. At genus 0, eight v3s must stay.",
       false, false, "mesh", 0,
       [](const Choices& c, int) {
         return Picture{paint_reduction(c.mesh ? c.mesh->surface.get() : nullptr), {}};
       }},
      {"dual-10", "", "Figure 10's two grids are dual",
       "Both cones are opened to disks, and level m + n is the circle of that radius. Every edge of one grid that lies "
       "within the last circle of the other crosses one edge of it. The self-loop of (1,0) goes "
       "round (0,0) and crosses its only edge.",
       true, true, "side", 6, [](const Choices&, int side) { return dual_picture(theory::kDigon, side); }},
      {"dual-11", "", "Figure 11's two grids are dual", "The same for the hexagons of two sides, one even and one odd.",
       true, true, "side", 6, [](const Choices&, int side) { return dual_picture(theory::kHexagon, side); }},
      {"unfolded-11", "", "The half cube laid flat",
       "A regular hexagon: three quadrants of a square grid around one corner, cut open along an axis. The faint "
       "meshes "
       "are the other bank of the cut.",
       true, true, "side", 5, [](const Choices&, int side) { return grid_picture(unfolded_figure(side)); }},
      {"hexagon", "", "A hexagon that is not regular",
       "The configurations are a part of a half cube, and moves still join all of them.", true, true, "sides", 0,
       [](const Choices& c, int) { return grid_picture(hexagon_figure(c.sides.value_or(kHexagonSides))); }},
      {"deviation", "", "Irregular vertices against deviation",
       "How many irregular vertices a reduction of three real meshes leaves, and how far the mesh is from the input "
       "then, with bounds that rise from 0.3 to 2 percent of the diagonal. `bench/shape --curve` measured it.",
       false, true, "curve", 0,
       [](const Choices& c, int) {
         return Picture{paint_deviation(parse_curves(c.curve.value_or(examples::shape))), {}};
       }},
      {"octagon", "", "The configurations of a single v8",
       "Theorem 7.1 says that a region with a single irregular vertex has one configuration unless 4 divides the "
       "valence. This is sharp: a v8 has (L-1)^2 configurations in a regular octagon of side L.",
       false, false, "side", 4,
       [](const Choices&, int side) {
         return Picture{paint_lone_v8(side), {}};
       }},
  };
  return entries;
}

std::string gallery_page(bool with_screenshots) {
  std::string page = R"(# Gallery

Figures of the paper, and some of our own. The library's operations or generators made every mesh, and every drawing is
computed. `requad-figures -o DIR` makes all of them. Use `--format pdf`, `png` or `tikz` for other formats, `--side L` for
other sizes, and `--width 240pt --palette print` for the column of a paper.

An irregular vertex is drawn as a polygon with as many corners as its valence: v3 blue, v5 orange, v6 red, v2 (a rhombus)
purple, and from v7 on a star with as many points. A quad that was made is yellow and has a plus. A quad that is deleted
is red and has a cross. Both signs stand upright on the page. So the figures can be read without colours. On meshes in
space, features are bold and black, boundaries bold and green.
)";
  for (const CatalogueEntry& entry : catalogue()) {
    page += "\n## " + std::string(*entry.paper == '\0' ? "" : "Figure " + std::string(entry.paper) + ": ") +
            entry.title + "\n\n";
    page += std::string("![") + entry.title + "](" + entry.file() + ".svg)\n\n" + entry.caption + "\n\n";
    page += "    requad-figures --figure " + std::string(entry.id) + " --format svg\n";
  }
  if (!with_screenshots) return page;
  page += R"(
## Pages to explore

Two pages for a browser, each one file that needs no other.

![The explorer: the configurations of a region as a graph, and the mesh of one of them](explorer.png)

The explorer shows all configurations of a region. Moves lead from one to the next, and a film shows the operations of a
move.

    requad-figures --explorer --sides 6,6 --pair 3-3 -o explorer.html

![The editor: a 3-5 pair, its four moves as pairs of arrows, and what each of them does](editor.png)

The editor is the paper's system on meshes of one's own (Figure 9). `tests/run` makes `build/requad-editor.html`; the
project's README says how else it is built.
)";
  return page;
}

}  // namespace requad::figures
