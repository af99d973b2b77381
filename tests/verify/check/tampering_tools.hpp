// What tamperings are made of: changes of a region's text, of its meshes and of the scripts of its edges.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/verify/check/tamperings.hpp"

namespace requad::tests {

inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

// A tampering with the text of one region.
std::function<bool(Proof&, Proof::File&)> in_region(const std::function<bool(ListedRegion&)>& change);

// One with each mesh, or each edge.
std::function<bool(Proof&, Proof::File&)> in_meshes(
    const std::function<void(const ListedRegion&, ListedMesh&)>& change);

std::function<bool(Proof&, Proof::File&)> in_edges(const std::function<void(ListedEdge&)>& change);

std::size_t first_pair(const ListedRegion& r);

// The first edge with a script of some operations, or none.
ListedEdge* edge_with(ListedRegion& r, std::size_t at_least, const std::string& step = "");

// Renames the vertices of a mesh and of the scripts that start from it.
void rename(ListedRegion& r, std::size_t mesh, const std::function<int(int)>& name);

// Turns each face over; the operations of scripts follow.
void mirror(ListedRegion& r);

// Names that a script gives in the mesh that another one left, for those that it has in the mesh that it was made for.
Script translated(Script script, const std::map<int, int>& name);

// The script, its inverse and the script again: three moves, of which the last two undo each other.
Script there_and_back_and_there(const Script& script, int next_vertex);

std::vector<ListedOperation> all_flips(const std::vector<Quad>& faces);

// The irregular vertices inside.
std::set<int> irregular(const std::vector<Quad>& faces, int boundary);

// An inner edge all whose vertices round about are regular or on the boundary, flipped.
bool flip_far_away(const ListedRegion& r, const ListedMesh& m, ListedOperation& flip);

}  // namespace requad::tests
