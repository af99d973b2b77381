// The branching of the backtracking search: which quads may be placed next on a partial mesh.
//
// A rule that looks at the partial mesh only chooses an edge of its first hole. Every filling has exactly one quad on that
// edge, so the branches, one for each placement there, have no filling in common, and together have all of them. That
// makes the search exact, whatever edge the rule chooses.
//
// A placement is left out if one of the holes that it leaves cannot be filled: it has an odd number of edges, or asks for
// an index that no part of the budget has, or an edge would be doubled, or the face limit cannot be kept.
//
// Costs. A quad at a hole corner, the usual case, takes constant time besides two walks along the ring: to the nearest
// hole corner, and over the candidates for the quad's fourth corner, which ends when no concave node is left. A hole
// without corners takes a round of its ring.
//
// Internal: not installed.
#pragma once

#include <vector>

#include "enumerate/search/partial_mesh.hpp"
#include "enumerate/search/search_control.hpp"

namespace requad::enumerate {

// Whether the first hole passes the tests of its parity and its index. For the start of a search: the holes that listed
// placements leave have passed them. Precondition: mesh.has_hole().
bool may_be_filled(const PartialMesh& mesh, const SearchPruning& pruning);

// Chooses an edge v -> w of the first hole, appends the placements on it to the list, and returns the node v. What it
// appends, and in which order, depends on the mesh, the pruning rules and the face limit alone. Sets
// control.face_limit_cut if the face limit excludes a placement. The mesh is the same afterwards. Precondition:
// mesh.has_hole().
int list_placements(PartialMesh& mesh, SearchControl& control, std::vector<Placement>& placements);

}  // namespace requad::enumerate
