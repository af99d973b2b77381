// The walk: every configuration of a region visited on one mesh, by pair moves and their inverses.
//
// explore() (exploration.hpp) keeps a mesh for each configuration and tells them apart by signatures: O(L^2) for each of
// O(L^2) configurations. The walk keeps one mesh and tells where it is by Theorem 7.11: it traces the separatrices of the
// pair to the boundary, O(L), and theory::locate() says which configuration has that vector. So a region of side L takes
// O(L^3): O(L^2) configurations, each with at most four moves of O(L) operations.
//
// Depth first. At each configuration the steps that theory names are tried in turn, unless the edge was walked from its
// other end. Each must be refused or lead where the table says. A step into a new configuration is taken back when
// everything beyond it was seen, any other at once: so every edge is walked both ways, and after every move, and after
// every refusal, the mesh is identified afresh. What the walk remembers is two bytes for each configuration,
// beside theory's table of them.
//
// The walk trusts nothing that it did before: not the pair's legs, nor their lengths, nor that a refused move changed
// nothing. It takes from the moves only which vertices the pair now is. What it can not see is a fault that leaves all
// separatrices as they should be; signatures, in small regions, do (verify/).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "mesh/topology/region.hpp"
#include "theory/configuration_table.hpp"

namespace requad::enumerate {

struct WalkResult {
  std::string problem;               // "": all is as predicted; else the first thing that is not, which ended the walk
  std::string configuration;         // where that was, as a label; "" if it can not be told
  std::optional<mesh::Region> mesh;  // and on which mesh

  std::int64_t predicted = 0;       // configurations of the table that hold the pair
  std::int64_t configurations = 0;  // of those, visited
  std::int64_t merged = 0;          // the same for the merged one: 0 or 1
  std::int64_t edges = 0;           // walked, both ways; with those of the merged configuration
  std::int64_t predicted_edges = 0;
  std::int64_t refusals = 0;  // steps that theory excludes, refused by the mesh

  // Costs.
  std::int64_t moves = 0;       // made
  std::int64_t operations = 0;  // basic operations of those moves
  std::int64_t identifications = 0;
  std::int64_t traced = 0;       // edges of separatrices walked by them
  std::int64_t mesh_bytes = 0;   // the arrays of the one mesh, at its largest
  std::int64_t other_bytes = 0;  // all else that grows with the region

  bool complete() const { return problem.empty() && configurations == predicted && edges == predicted_edges; }
};

// Told now and then how many configurations were visited since.
using WalkProgress = std::function<void(std::int64_t)>;

// Walks from a mesh of one of the table's configurations. The claim "each exactly once" is then complete() and
// configurations == predicted. No allocation after the start.
WalkResult walk(const theory::ConfigurationTable& table, mesh::Region start, const WalkProgress& progress = {});
// From the configuration with the fewest quads, glued. Throws like ConfigurationTable(); a region without a configuration
// has an empty walk.
WalkResult walk(const theory::RegionShape& shape, const WalkProgress& progress = {});

}  // namespace requad::enumerate
