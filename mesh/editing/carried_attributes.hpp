// Carries the attributes of a file over to the mesh that edits made of it.
//
// Terms
//   ancestor    of a face or vertex that edits made: the one from which it descends (element_map.hpp).
//   unchanged   A corner is, if its face and vertex were there before, and the vertex neither moved nor left the face. A
//               face is, if its corners are.
//   seam        an interior edge on whose sides a vertex has different texture coordinates (texture_seams()).
//   sector      the faces at a vertex from one seam or boundary edge to the next.
//
// What each element gets
//   face         the state of its ancestor, or its own.
//   vertex       the words (a colour) of its ancestor, or its own.
//   corner, vt   If it is unchanged, its own. At a vertex that did not move: that of the same sector before. Elsewhere the
//                texture coordinates at the nearest point of the surface before, interpolated in its triangle. If the edits
//                broke a seam, or moved a vertex on one, the nearest point is sought from within the face, so that it lies
//                on the right side. If each face has a texture for itself: that of its ancestor, corner by corner.
//   corner, vn   If all faces at the vertex are unchanged, its own. Elsewhere the normal of the surface after, averaged
//                over the faces at the vertex that are joined to this one by edges of less than 45 degrees; that of the
//                face alone if its smoothing is off.
//   element      It is kept if its vertices are still there, and a tag of an edge if the edge is.
// Law editing-15. If the edits changed nothing, the result is the attributes of the file, without what belongs to
//                 vertices that no face has.
// Costs: O(V + F + edits), and a query of a SurfaceIndex for each new corner that needs one.
#pragma once

#include "mesh/editing/editor.hpp"
#include "mesh/files/surface.hpp"

namespace requad::mesh {

// The attributes for a file of the editor's mesh. `not_kept` counts what is gone too. Precondition: the editor has
// positions, started from the surface's mesh and positions, and has not forgotten any edit.
Attributes carried_attributes(const Surface& before, const Editor& editor);

}  // namespace requad::mesh
