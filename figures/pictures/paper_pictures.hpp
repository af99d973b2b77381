// Figures of the paper that show operations and regions: meshes before and after operations, which the library performs
// on the mesh that is drawn, and regions with their boundaries and separatrices. The figures of meshes in space perform
// their edits once in a process.
#pragma once

#include <string>
#include <vector>

#include "mesh/files/surface.hpp"
#include "mesh/pictures/canvas.hpp"

namespace requad::figures {

using namespace pictures;

// basic_operation_pictures.cpp
Paint paint_basic_operations();  // Figure 2

// vertex_pictures.cpp
Paint paint_adjacent_pair_moves();  // Figure 3
Paint paint_vertex_moves();         // Figure 4
Paint paint_type_changes();         // Figure 5

// pair_move_pictures.cpp
Paint paint_pair_moves();        // Figure 6
Paint paint_detour();            // Figure 7
Paint paint_equal_pair_moves();  // Figure 8

// deviation_picture.cpp
struct Curve {
  std::string name;
  std::vector<Point> points;  // a distance from the input, over its diagonal; a number of irregular vertices
};
// The curves in the JSON of bench/shape. Throws nlohmann::json::exception for another text.
std::vector<Curve> parse_curves(const std::string& json);
Paint paint_deviation(const std::vector<Curve>& curves);

// pair_on_mesh_pictures.cpp
Paint paint_pair_on_mesh();  // Figure 9

// reduction_pictures.cpp
Paint paint_roof();  // Figure 1
Paint paint_dome();  // Figure 15
// Figure 19: stages of the reduction of a mesh; of our own if none is given. The mesh has a face. It takes as long as
// `requad-edit reduce`.
Paint paint_reduction(const mesh::Surface* surface);

// repair_pictures.cpp
Paint paint_rounded_block();  // Figure 16
Paint paint_cylinder();       // Figure 17
Paint paint_sharp_block();    // Figure 18

// region_pictures.cpp
// Figure 13: the turns of an open path and of a loop, and the smallest regions.
Paint paint_turns_and_smallest();
// Figure 14: a region of each kind with separatrices, strips and side lengths.
Paint paint_separatrices();
// The (L-1)^2 configurations of a single v8 in the regular octagon of side L, which show that Theorem 7.1 is sharp.
// Precondition: length >= 2.
Paint paint_lone_v8(int length);

}  // namespace requad::figures
