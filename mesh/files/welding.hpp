// Vertices at one place: files that describe a seam often give each side its own vertices.
#pragma once

#include <vector>

#include "mesh/files/polygon_mesh.hpp"

namespace requad::mesh {

// By position: the first one that has the same coordinates, itself if none before it has. (0 and -0 are the same.)
// O(n log n).
std::vector<int> first_at_same_place(const Positions& positions);

// How many positions an earlier one equals. O(n log n).
int coincident_vertices(const Positions& positions);

// Joins vertices at the same place: faces and elements then name the first of them, and `same_as` says so; the others
// have no face. Throws FileError for a face with two corners at one place. O(V log V + F).
void weld(PolygonMesh& mesh);

}  // namespace requad::mesh
