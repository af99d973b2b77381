// Writes meshes as Wavefront OBJ.
#pragma once

#include <string>
#include <vector>

#include "mesh/files/surface.hpp"
#include "mesh/geometry/measures.hpp"
#include "mesh/topology/region.hpp"

namespace requad::mesh {

// The live elements with these positions (by vertex slot). Comment lines come first, then vertices and faces in the
// order of their ids. Coordinates have the fewest digits that read back as the same bits. O(V + F).
//
// Law files-5. Reading the text (read_polygons.hpp, surface.hpp) gives the same positions and an equal mesh, if the
//              mesh has no free ids.
std::string obj_text(const QuadMesh& mesh, const Positions& positions, const std::vector<std::string>& comments = {});

// The same with attributes (attributes.hpp), whose vertices, faces and corners are counted in order. The values keep
// their indices.
//
// Law files-6. Reading the text gives these attributes, if all of their states are in use; except that states can have
//              other indices, and that the kinds that are not kept are not told.
std::string obj_text(const QuadMesh& mesh, const Positions& positions, const Attributes& attributes);

// The same for a region as draw() draws it, in the plane z = 0.
std::string obj_text(const Region& region, const std::vector<std::string>& comments = {});

// The surface with all vertices of the file from which it was read, used or not, so that they keep their numbers.
std::string whole_obj_text(const Surface& surface);

}  // namespace requad::mesh
