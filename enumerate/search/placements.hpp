// The branching of the backtracking search: which quads may be placed next on a partial mesh.
//
// A rule chooses an edge of the first hole. The choice depends on the partial mesh alone. Each placement on that edge
// starts one branch. Every filling has exactly one quad on that edge, so every filling belongs to exactly one branch.
// Therefore the search finds each filling once, whichever edge the rule chooses.
//
// A placement is left out if it doubles an edge, if the face limit cannot be kept, or if it leaves a hole that cannot
// be filled. Such a hole has an odd number of edges, or it requires an index that no part of the budget has.
//
// Costs. Usually an end of the edge is a hole corner. A listing then takes constant time and two passes along the ring.
// One pass goes to the nearest hole corner. The other one goes over the candidates for the quad's fourth corner, and
// ends when no concave node is left. In a hole without corners, one pass goes once round the ring.
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

// Chooses an edge v -> w of the first hole, appends the placements on it to the list, and returns the node v. The
// placements and their order depend only on the mesh, the pruning rules and the face limit. Sets control.face_limit_cut
// if the face limit excludes a placement. The mesh is the same afterwards. Precondition: mesh.has_hole().
int list_placements(PartialMesh& mesh, SearchControl& control, std::vector<Placement>& placements);

}  // namespace requad::enumerate
