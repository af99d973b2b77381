// What there is to say about a mesh before one edits it: its topology, its irregular vertices, how good its quads are.
#pragma once

#include <map>

#include "mesh/geometry/measures.hpp"
#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

struct Diagnosis {
  int vertices = 0;
  int edges = 0;
  int faces = 0;
  int components = 0;
  int boundary_loops = 0;
  int euler_characteristic = 0;
  // The sum over the components of the genus of each, its boundary loops closed by disks: a handlebody of genus g and a
  // sphere beside it have genus g together. 2 components - 2 genus - boundary loops is the Euler characteristic.
  int genus = 0;

  std::map<int, int> valences;  // of interior vertices, 4 included: how many have each
  int interior_irregular = 0;   // interior vertices of a valence that is not 4
  int doublets = 0;             // interior vertices of valence 2: two faces that share two edges
  std::map<int, int> turns;     // of boundary vertices (region.hpp): 1 a corner, 0 straight, negative concave
  int boundary_irregular = 0;   // boundary vertices whose turn is not 0

  // Of scaled_jacobian(), aspect_ratio() and edge_length(); all 0 for an empty mesh.
  struct Statistics {
    double least = 0;
    double mean = 0;
    double greatest = 0;
  };
  Statistics scaled_jacobian;
  Statistics aspect_ratio;
  Statistics edge_length;
  int degenerate = 0;  // faces without area
  int inverted = 0;    // faces of scaled Jacobian <= 0, those without area too
  double bounding_box_diagonal = 0;
};

// O(V + F).
Diagnosis diagnose(const QuadMesh& mesh, const Positions& positions);

}  // namespace requad::mesh
