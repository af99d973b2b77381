// Feature edges: interior edges that edits should keep. They are found where the surface bends sharply, or read from a
// file. Boundary edges are always kept and are not listed.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/files/surface.hpp"
#include "mesh/geometry/measures.hpp"
#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

// Each edge once, by its two vertices, of which the lesser comes first; sorted.
using FeatureEdges = std::vector<std::array<VertexId, 2>>;

// The edges at which the normals of the two faces differ by `degrees` or more. O(E log E).
FeatureEdges sharp_edges(const QuadMesh& mesh, const Positions& positions, double degrees);

// The interior edges that a text file lists. A line holds either the two vertices of an edge, `12 40`, or, like a line
// of OBJ, `l` and a chain of vertices, `l 12 40 41`. Vertices are counted from 1 in the order of the file that the
// surface was read from, whatever its format; negative numbers count back from the last. Other lines of OBJ are
// skipped, so that one file can hold a mesh and its features. If the surface was subdivided, an edge of the file stands
// for its two halves. Boundary edges may be listed, and are left out.
//
// Throws FileError "file:line: reason" for a vertex that does not exist, or two vertices that no edge joins; and
// FileError for a file that cannot be read. O(size * valence).
FeatureEdges read_feature_edges(const std::string& path, const Surface& surface);
FeatureEdges parse_feature_edges(std::string_view text, const std::string& name, const Surface& surface);

// The interior edges on whose two sides a vertex has different texture coordinates, or has them on one side only. O(E).
FeatureEdges texture_seams(const Surface& surface);
// Whether so many edges are seams, three tenths or more, that each face has a texture for itself (or each block of 2 x 2,
// after a subdivision), rather than the surface a texture that is cut open. O(1).
bool has_texture_by_faces(const Surface& surface, const FeatureEdges& seams);

// The vertices at which features end, meet or leave the boundary, sorted: there the number of feature and boundary
// edges is neither 0 nor 2. O(V + number of features).
std::vector<VertexId> feature_corners(const QuadMesh& mesh, const FeatureEdges& edges);

}  // namespace requad::mesh
