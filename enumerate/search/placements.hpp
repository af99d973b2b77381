// The branching of the backtracking search: which quads may be placed next on a partial mesh.
//
// A rule, which depends on the partial mesh alone, chooses an edge of the first hole. There is one branch for each
// placement on that edge. Every filling has exactly one quad there, so each filling belongs to exactly one branch. That
// makes the search exact, whichever edge the rule chooses.
//
// A placement is left out if it doubles an edge, if the face limit cannot be kept, or if it leaves a hole that cannot
// be filled: one with an odd number of edges, or one that requires an index which no part of the budget has.
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

// Whether the first hole passes the tests of its parity and its index. Only the start of a search needs this: holes
// that listed placements leave have passed the tests. Precondition: mesh.has_hole().
bool may_be_filled(const PartialMesh& mesh, const SearchPruning& pruning);

// Chooses an edge v -> w of the first hole, appends the placements on it to the list, and returns the node v. What it
// appends, and in which order, depends on the mesh, the pruning rules and the face limit alone. Sets
// control.face_limit_cut if the face limit excludes a placement. The mesh is the same afterwards. Precondition:
// mesh.has_hole().
int list_placements(PartialMesh& mesh, SearchControl& control, std::vector<Placement>& placements);

}  // namespace requad::enumerate
