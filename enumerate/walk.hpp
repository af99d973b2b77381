// The walk: every configuration of a region visited on one mesh, by pair moves and their inverses.
//
// explore() (exploration.hpp) keeps a mesh for each configuration and tells them apart by signatures: O(L^2) time for each
// of O(L^2) configurations of a region of side L. The walk keeps one mesh. It tells where that is by Theorem 7.11: it
// traces the pair's separatrices to the boundary, O(L), and theory says which configuration has these (pair_locator.hpp).
// So a region takes O(L^3) time: O(L^2) configurations, each with at most four moves of O(L) operations.
//
// Law enumerate-3   a complete walk has visited every configuration of the table exactly once, and made every move of the
//                   predicted graph both ways, on the mesh.
//
// How. Depth first. At each configuration the walk tries the steps of the theorem in turn, but for those whose edge it has
// walked from the other end. The mesh must refuse the step, or lead where the table says. A step into a new configuration
// is taken back when everything beyond it was seen; any other step is taken back at once. After every move and after every
// refusal the walk locates the mesh afresh. It remembers two bytes for each configuration, besides the table.
//
// What the walk trusts. It takes from the moves only which vertices the pair now is: not the pair's legs, nor their
// lengths, nor that a refused move changed nothing. It cannot see a fault that leaves all separatrices as they should be;
// signatures, in small regions, can (verify/).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "mesh/topology/region.hpp"
#include "theory/configuration_table.hpp"

namespace requad::enumerate {

struct WalkResult {
  std::string problem;               // the first thing that is not as predicted, which ended the walk; "" if all is
  std::string configuration;         // where that was, as a label; "" if that is not known
  std::optional<mesh::Region> mesh;  // and on which mesh

  std::int64_t predicted = 0;        // configurations of the table that hold the pair
  std::int64_t configurations = 0;   // of those: visited
  std::int64_t merged = 0;           // 1 if the merged configuration was visited, else 0
  std::int64_t predicted_edges = 0;  // of the table's graph, those of the merged configuration included
  std::int64_t edges = 0;            // of those: walked, both ways
  std::int64_t refusals = 0;         // steps that theory excludes and the mesh refused

  // Costs.
  std::int64_t moves = 0;            // made
  std::int64_t operations = 0;       // basic operations of those moves
  std::int64_t identifications = 0;  // of the mesh's configuration
  std::int64_t traced = 0;           // edges of separatrices that they followed
  std::int64_t mesh_bytes = 0;       // the arrays of the one mesh, at its largest
  std::int64_t other_bytes = 0;      // all else that grows with the region

  bool complete() const { return problem.empty() && configurations == predicted && edges == predicted_edges; }
};

// Called now and then with the number of configurations that were visited since.
using WalkProgress = std::function<void(std::int64_t)>;

// Walks from `start`, a mesh of one of the table's configurations. Allocates nothing after the start.
WalkResult walk(const theory::ConfigurationTable& table, mesh::Region start, const WalkProgress& progress = {});
// Walks from the configuration with the fewest quads, glued (generators.hpp). A region without a configuration has an
// empty walk, which is complete. Throws as ConfigurationTable().
WalkResult walk(const theory::RegionShape& shape, const WalkProgress& progress = {});

}  // namespace requad::enumerate
