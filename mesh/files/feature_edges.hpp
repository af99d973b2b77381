// Feature edges: edges of the surface that edits should keep, found where it bends sharply or read from a file.
//
// Boundary edges are features always and are not listed.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh/files/polygon_mesh.hpp"
#include "mesh/geometry/measures.hpp"
#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

// Interior edges by their ends, the lesser vertex first; sorted, each once.
using FeatureEdges = std::vector<std::array<VertexId, 2>>;

// The edges whose normals on either side differ by `degrees` or more. O(E).
FeatureEdges sharp_edges(const QuadMesh& mesh, const Positions& positions, double degrees);

// The edges that a text file lists: two vertices in a line, `12 40`, or the `l` lines of OBJ, `l 12 40 41`, for a chain
// of edges. Vertices are counted from 1 in the order of the file that the surface was read from, whatever its format,
// and negative ones back from its last; other lines of an OBJ file are skipped, so that one file can hold mesh and
// features. An edge of the file that was subdivided stands for its two halves. Edges of the boundary may be listed.
// Throws FileError "file:line: reason" for a vertex that does not exist and two vertices that no edge joins,
// FileError for a file that can not be read. O(size * valence).
FeatureEdges read_feature_edges(const std::string& path, const Surface& surface);
FeatureEdges parse_feature_edges(std::string_view text, const std::string& name, const Surface& surface);

// Where features end, meet or leave the boundary: the vertices at which the number of feature and boundary edges is
// neither 0 nor 2. Sorted. O(V + number of features).
std::vector<VertexId> feature_corners(const QuadMesh& mesh, const FeatureEdges& edges);

}  // namespace requad::mesh
