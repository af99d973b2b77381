// Writes meshes as Wavefront OBJ.
#pragma once

#include <string>
#include <vector>

#include "mesh/geometry/measures.hpp"
#include "mesh/topology/region.hpp"

namespace requad::mesh {

// The live elements with these positions (by vertex slot). Comment lines come first, then vertices and faces in the
// order of their ids. Coordinates have the fewest digits that read back as the same bits. O(V + F).
//
// Law files-5. Reading the text (read_polygons.hpp, surface.hpp) gives the same positions and an equal mesh, if the
//              mesh has no free ids.
std::string obj_text(const QuadMesh& mesh, const Positions& positions, const std::vector<std::string>& comments = {});

// The same for a region as draw() draws it, in the plane z = 0.
std::string obj_text(const Region& region, const std::vector<std::string>& comments = {});

}  // namespace requad::mesh
