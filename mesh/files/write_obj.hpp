// Wavefront OBJ output.
#pragma once

#include <string>
#include <vector>

#include "mesh/geometry/measures.hpp"
#include "mesh/topology/region.hpp"

namespace requad::mesh {

// The live elements with these positions (by vertex slot): comment lines first, then vertices and faces in the order of
// their ids, each face from its first corner, so that a mesh that was read (polygon_mesh.hpp) and not changed is written
// as it was. Coordinates have the fewest digits that read back as the same bits. O(V + F).
std::string obj_text(const QuadMesh& mesh, const Positions& positions, const std::vector<std::string>& comments = {});

// A region as draw() draws it, in the plane z = 0.
std::string obj_text(const Region& region, const std::vector<std::string>& comments = {});

}  // namespace requad::mesh
