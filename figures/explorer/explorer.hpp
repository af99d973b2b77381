// The explorer: one HTML file in which a reader walks through a region's configurations, their meshes and their moves.
//
// The file needs no server, no network and no library. Its program is our own (figures/explorer/, embedded by CMake).
// Its data are the meshes that an exploration by pair moves found, and the operations of these moves. To make a move,
// the page applies its operations to the mesh on the screen. Then it checks that the result is isomorphic, relative to
// the boundary, to the mesh that was found.
//
// The address of the page follows the moves: explorer.html#2,1 shows the configuration (2,1). The page saves the mesh that
// it shows as SVG and as OBJ. In the OBJ file side 1 starts at the first edge of the first face.
//
// Terms
//   spot       the position of a configuration in the drawing of the graph. A configuration has one spot. The exception
//              is a digon, where (x,0) and (0,x) are one configuration with two spots, at both ends of a level
//              (Figure 10).
//   key        the arrow key that makes a move. For equal valences up is (+1,+1), down (-1,-1), left (-1,+1) and right
//              (+1,-1), as in the grid of Figure 10. A segment has two moves (+1,+1). The move of its second labelling
//              has the key down, which a segment does not need otherwise. For a 3-5 pair the keys are the steps of
//              (m,n). A v6 parts to the left, to the right and down.
//   patch      what a basic operation does to the list of faces: the new corners of each face that it makes or changes,
//              and the ids of those that it deletes.
//
// The JSON of explorer_data(), with the ids of the mesh:
//   pair, sides, regular, grid ("flat" or "cube")
//   nodes   label, names (of all its labellings), d1, d2, m, n, quads, signature, spots [[x,y,z]...]. The mesh:
//           vertices [[x,y]...] and faces [[a,b,c,d]...], null where an id is free; root [v,w], the edge where side 1
//           starts; irregular; alpha, the faces of R_alpha; rim, the vertices round it; outward, the paths of the
//           outward separatrices by side, whose lengths are the strip counts e_i
//   moves   from, to, spots and names (at either end), key, change, step, made, deleted; arrows [[v,w],[v,w]] as in
//           Figure 9, from each irregular vertex towards vertex w; operations {kind, patch, and the vertices that
//           describe it}
//   claims  what verify/ says of the region: id, where, statement, predicted, found, holds, violation ("" if it holds)
// The same region gives the same bytes.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "enumerate/exploration.hpp"

namespace requad::figures {

// Bounds that keep the page small and quick. Its size grows with the number of configurations and of all their quads.
inline constexpr theory::Integer kMostConfigurations = 150;
inline constexpr theory::Integer kMostQuads = 30'000;
inline constexpr theory::Integer kLongestSide = 60;

// One line that says why there is no explorer for this region, or "". There is none if no configuration holds the pair,
// or if a bound above is exceeded.
std::string explorer_problem(const theory::RegionShape& shape);

// The data of the page. Preconditions: explorer_problem() is "", and `found` comes from explore_all() with the merged
// configuration.
nlohmann::ordered_json explorer_data(const enumerate::Exploration& found);
// Its claims alone: every claim of verify/ that says something about the region, in the order of the ledger.
nlohmann::ordered_json explorer_claims(const enumerate::Exploration& found);

// The page with these data.
std::string explorer_page(const nlohmann::ordered_json& data);

}  // namespace requad::figures
