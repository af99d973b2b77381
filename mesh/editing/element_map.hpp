// Where the vertices and faces of a mesh are after edits, so that what belongs to them can follow.
#pragma once

#include <vector>

#include "mesh/editing/editor.hpp"

namespace requad::mesh {

// Of one kind of elements. Places are those among the live elements in the order of their ids, from 0: what files
// count.
struct PlaceMap {
  std::vector<int> now;   // by id before: the element's place after; -1 if it was removed, or was not there
  std::vector<int> made;  // places after of the elements that were not there before, increasing
  // Of each of these, the id before of what it comes from, whether that is still there or not: of a vertex, the one
  // that it was split off, or what that came from; of a face, the first one of the sector that the split opened beside.
  std::vector<int> made_from;
};

struct ElementMap {
  PlaceMap vertices;
  PlaceMap faces;
};

// What an editor has done since the mesh was `before`. An element that was removed is gone: one that was made later
// with its id is another. Precondition: the editor has not forgotten anything. O(V + F + edits).
ElementMap element_map(const QuadMesh& before, const Editor& editor);

}  // namespace requad::mesh
