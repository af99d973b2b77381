// Describes a mesh in numbers: its topology, its irregular vertices, and the quality of its quads.
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
  // The sum of the genera of the components, with their boundary loops closed by disks. (A surface of genus g and a
  // sphere beside it have genus g together.) The Euler characteristic is 2 components - 2 genus - boundary loops.
  int genus = 0;

  std::map<int, int> valences;  // the number of interior vertices of each valence, 4 included
  int interior_irregular = 0;   // the number of irregular vertices
  int doublets = 0;             // interior vertices of valence 2: two faces share both edges
  std::map<int, int> turns;     // the number of boundary vertices of each turn (region.hpp): 1 corner, 0 straight
  int boundary_irregular = 0;   // boundary vertices whose turn is not 0

  // Statistics of scaled_jacobian(), aspect_ratio() and edge_length(); all 0 for an empty mesh.
  struct Statistics {
    double least = 0;
    double mean = 0;
    double greatest = 0;
  };
  Statistics scaled_jacobian;
  Statistics aspect_ratio;
  Statistics edge_length;
  int degenerate = 0;  // faces without area
  int inverted = 0;    // inverted faces (measures.hpp); those without area are among them
  double bounding_box_diagonal = 0;
};

// O(V + F).
Diagnosis diagnose(const QuadMesh& mesh, const Positions& positions);

}  // namespace requad::mesh
