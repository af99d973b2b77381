// The walk: every configuration of a region visited on one mesh, by pair moves and their inverses.
//
// explore() (exploration.hpp) keeps a mesh for each configuration and tells them apart by signatures. That takes O(L^2)
// time for each of the O(L^2) configurations of a region of side L. The walk keeps one mesh. It recognises the mesh's
// configuration by Theorem 7.11: it traces the pair's separatrices to the boundary in O(L) time, and theory says which
// configuration has them (pair_locator.hpp). So a region takes O(L^3) time: O(L^2) configurations, each with at most
// four moves of O(L) operations.
//
// Law enumerate-3   a complete walk has visited every configuration of the table exactly once. It has made every move
//                   of the predicted graph on the mesh, in both directions.
//
// Method. The walk is depth first. At each configuration it tries the steps of the theorem in turn, except those whose
// edge it has already walked from the other end. The mesh must refuse the step or reach the configuration that the
// table names. A step into a new configuration is undone when everything beyond it has been visited; any other step is
// undone at once. After every move and every refusal the walk locates the mesh again. Besides the table it keeps two
// bytes for each configuration.
//
// Trust. The walk uses only one thing that a move reports: which two vertices form the pair afterwards. It relies
// neither on the pair's legs and their lengths nor on a refused move leaving the mesh unchanged. It cannot detect a fault
// that leaves all separatrices as predicted; in small regions the signatures detect it (verify/).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "mesh/topology/region.hpp"
#include "theory/configuration_table.hpp"

namespace requad::enumerate {

struct WalkResult {
  std::string problem;               // the first difference from the prediction, which ended the walk; "" if none
  std::string configuration;         // the label where that was; "" if it is not known
  std::optional<mesh::Region> mesh;  // the mesh on which that was

  std::int64_t predicted = 0;        // number of the table's configurations that hold the pair
  std::int64_t configurations = 0;   // how many of these were visited
  std::int64_t merged = 0;           // 1 if the merged configuration was visited, else 0
  std::int64_t predicted_edges = 0;  // edges of the table's graph, those of the merged configuration included
  std::int64_t edges = 0;            // how many of these were walked in both directions
  std::int64_t refusals = 0;         // steps that theory excludes and the mesh refused

  // Costs.
  std::int64_t moves = 0;            // moves that were made
  std::int64_t operations = 0;       // basic operations of these moves
  std::int64_t identifications = 0;  // how often the configuration was located
  std::int64_t traced = 0;           // edges of separatrices that were followed to locate it
  std::int64_t mesh_bytes = 0;       // memory of the mesh at its largest
  std::int64_t other_bytes = 0;      // all other memory that grows with the region

  bool complete() const { return problem.empty() && configurations == predicted && edges == predicted_edges; }
};

// Called from time to time with the number of configurations that were visited since the last call.
using WalkProgress = std::function<void(std::int64_t)>;

// Walks from `start`, a mesh of one of the table's configurations. Allocates memory only at the start.
WalkResult walk(const theory::ConfigurationTable& table, mesh::Region start, const WalkProgress& progress = {});
// Walks from the configuration with the fewest quads, glued (generators.hpp). A region without a configuration has an
// empty walk, which is complete. Throws as ConfigurationTable().
WalkResult walk(const theory::RegionShape& shape, const WalkProgress& progress = {});

}  // namespace requad::enumerate
