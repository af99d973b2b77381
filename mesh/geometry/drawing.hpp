// Drawings of regions in the plane, with evenly spaced vertices on the boundary and quads that are as square as that
// allows.
//
// Terms
//   outline   The curve on which the boundary is drawn. It depends on the number of sides.
//               three or more   a polygon inscribed in a circle, whose sides are as long as the region's, in edges
//               two             a lens: two arcs that meet at equal angles, as long as the sides if convex arcs can be
//               one             a drop with a right angle at the corner
//               none            a circle
//             Boundary vertices are evenly spaced on each side. The first side is the lowest and starts at the left.
//   corner    A vertex of a quad with the vertices before and after it: a triangle.
//
// Units. The outline is as long as the boundary has edges, so that an edge has about length 1. The origin is the centre
// of the outline's bounding box.
//
// Laws
//   geometry-6  drawing_problem() is "" iff the boundary and all quads are simple polygons, counter-clockwise. Then no
//               two quads overlap: the map is one to one on the boundary and locally one to one inside, so its degree
//               is 1.
//   geometry-7  In a drawing by draw(), all corners are counter-clockwise, and so quads are convex, except at an
//               interior vertex of valence 2, whose two quads share 360 degrees. (Checked, not proven, for other meshes
//               than regions with a pair.)
//
// Method. A Tutte embedding (sparse Cholesky), then Newton's method on the sum of the symmetric Dirichlet energies of
// all corners. The energy of a corner is |J|^2 + |J^-1|^2, where the columns of J are its two edges, in units of the
// side of a square of the mean area. It is least for squares of that size, and grows without bound as a corner
// flattens: so no step can turn a corner over. The Hessian is made positive semidefinite corner by corner. Of its four
// eigenvalues only that of the rotation by 90 degrees can be negative (B. Smith, F. de Goes, T. Kim, Analytic
// Eigensystems for Isotropic Distortion Energies, 2019).
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "mesh/topology/region.hpp"

namespace requad::mesh {

// The positions of the boundary vertices, counter-clockwise from the start of the first side, for these side lengths.
// `{n}` is a drop if there are corners, else a circle. Preconditions: each side is at least 1; there are at least two
// edges. O(edges).
std::vector<Eigen::Vector2d> outline(const std::vector<int>& sides, bool corners = true);

// Larger meshes keep the Tutte embedding, since each of Newton's steps would take seconds: it is a drawing by law
// geometry-6, but its quads can be very flat.
inline constexpr int kMostFacesImproved = 20'000;
// The Tutte embedding of a mesh of so many faces takes some seconds. A mesh of four times as many does not fit into
// memory.
inline constexpr int kMostFacesDrawn = 300'000;

// Positions by vertex slot, zero for deleted vertices. The same region gives the same bits. Precondition:
// region_problem() is "". About 10 sparse solves of about O(V^1.5) each, one beyond kMostFacesImproved.
std::vector<Eigen::Vector2d> draw(const Region& region);

// The same for a given outline: `at` has positions by vertex slot, and those of interior vertices are replaced. The
// outline should be a convex polygon. If it is not, law geometry-7 may fail; drawing_problem() shows whether it does.
void draw_inside(const QuadMesh& mesh, std::vector<Eigen::Vector2d>& at);

// Why the positions are not a drawing, as one line that names a quad or a defect of the boundary; "" if they are (law
// geometry-6). `smallest` receives the least sine of the angle at a corner, other than those at interior vertices of
// valence 2; it is negative if a quad is not convex. Precondition: the mesh is a disk, and `root` is on its boundary.
// O(F + boundary^2).
std::string drawing_problem(const Region& region, const std::vector<Eigen::Vector2d>& at, double* smallest = nullptr);

}  // namespace requad::mesh
