// Drawings of regions in the plane: straight sides or arcs, and quads as even as the outline lets them be.
//
// Terms
//   outline   the place of the boundary. Three sides and more: the polygon inscribed in a circle whose sides are as
//   long
//             as the region's, in edges. Two: a lens of two arcs that meet at equal angles and are as long as the sides
//             (as far as they stay convex). One: a drop with a right angle. None: a circle. Boundary vertices are
//             evenly spaced on each side. The first side starts at the lower left and is the lowest.
//   corner    of a quad: the triangle of one of its vertices with the two before and after.
//
// Units: the whole outline is as long as the boundary has edges, so an edge has about length 1, whatever the region;
// the origin is the centre of the outline's bounding box.
//
// Law D1. drawing_problem() is "" iff the boundary is a simple polygon, counter-clockwise, and each quad is, too. Then
// no
//         two quads overlap: the map is locally one to one inside and one to one on the boundary, so its degree is 1.
// Law D2. In what draw() returns, every corner is counter-clockwise, so quads are convex, except at interior vertices
// of
//         valence 2, whose two quads share 360 degrees. (Checked, not proven, for a mesh that is no region with a
//         pair.)
//
// How. A Tutte embedding (sparse Cholesky), then Newton's method on the symmetric Dirichlet energy of all corners: with
// J the matrix of a corner's two edges, in units of the side of a square of the mean area, |J|^2 + |J^-1|^2. It is
// least for squares of that size and grows without bound as a corner flattens, so no step can turn one over. The
// Hessian is made positive semidefinite corner by corner: of its four eigenvalues only that of the rotation by 90
// degrees can be negative (Smith, de Goes and Kim, Analytic Eigensystems for Isotropic Distortion Energies, 2019).
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "mesh/topology/region.hpp"

namespace requad::mesh {

// Positions of the boundary vertices, counter-clockwise from the start of the first side; one for each edge.
// Precondition: every side >= 1, at least two edges in all, with three sides or more at least three. `{n}` is a drop;
// a circle is asked for with `corners` false. O(edges).
std::vector<Eigen::Vector2d> outline(const std::vector<int>& sides, bool corners = true);

// Positions by vertex slot (zero for deleted ones). Precondition: region_problem() is "". About 10 sparse solves, each
// some O(V^1.5). The same region gives the same bits.
std::vector<Eigen::Vector2d> draw(const Region& region);

// The same inside a boundary that is given: `at` holds positions by vertex slot, of which only those of boundary
// vertices are read. The boundary should be a convex polygon; otherwise the result may have to be judged by
// drawing_problem().
void draw_inside(const QuadMesh& mesh, std::vector<Eigen::Vector2d>& at);

// Why positions are no drawing, as one line that names a quad, or ""; see Law D1. `smallest` receives the least sine of
// an angle over all corners but those at interior vertices of valence 2: negative if a quad is not convex.
// Precondition: the mesh is a disk with a boundary half-edge `root`. O(F + boundary^2).
std::string drawing_problem(const Region& region, const std::vector<Eigen::Vector2d>& at, double* smallest = nullptr);

}  // namespace requad::mesh
