// Follows the vertices and faces of a mesh through edits, so that data that belongs to them can be carried over.
//
// Terms
//   file index   of an element: its index among the live elements in the order of their ids, from 0. Files count in
//                this way, so it is the element's index in the file of the mesh.
#pragma once

#include <vector>

#include "mesh/editing/editor.hpp"

namespace requad::mesh {

// The number that the file of the mesh has for the vertex, counted from 1: its file index + 1. O(V).
int file_number(const QuadMesh& mesh, VertexId v);

// For the vertices, or for the faces.
struct FileIndexMap {
  std::vector<int> now;   // by id before the edits: the file index after them; -1 if there is no such element any more
  std::vector<int> made;  // file indices after the edits of the elements that were made, increasing
  // For each of these, the id before the edits of the element that it descends from, which may be gone. A vertex
  // descends from the one that it was split from; a face from the first face of the sector beside which it was opened.
  std::vector<int> made_from;
};

struct ElementMap {
  FileIndexMap vertices;
  FileIndexMap faces;
};

// What an editor has done since the mesh was `before`. An element that was removed is gone, even if a later one has its
// id. Precondition: the editor has not forgotten any edit. O(V + F + edits).
ElementMap element_map(const QuadMesh& before, const Editor& editor);

}  // namespace requad::mesh
