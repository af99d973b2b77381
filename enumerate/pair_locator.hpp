// Locating a mesh: which configuration it is, found from where its pair's separatrices meet the boundary (Theorem
// 7.11).
//
// read() of labels.hpp looks at the whole mesh and needs no table. The locator traces only the separatrices. That takes
// O(L) time in a region of side L and allocates nothing. The walk uses it after every move (walk.hpp).
//
// Internal: not installed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/irregular/pair_frame.hpp"
#include "mesh/topology/region.hpp"
#include "mesh/topology/separatrix.hpp"
#include "theory/configuration_table.hpp"
#include "theory/separatrix_vector.hpp"

namespace requad::enumerate {

struct Location {
  int number = -1;              // of the configuration in the table; -1 if none has these separatrices
  theory::Place place;          // canonical
  mesh::PairFrame frame;        // of the labelling that `place` stands for, or of the merged vertex
  mesh::PairFrame other_frame;  // of a segment's other labelling (theory-3)

  bool known() const { return number >= 0; }
};

class PairLocator {
 public:
  // The pair, with the vertex of larger valence first. A merged pair is the same vertex twice.
  using Pair = std::array<mesh::VertexId, 2>;

  // The table and the region must outlive the locator. The region's boundary must not change.
  PairLocator(const theory::ConfigurationTable& table, const mesh::Region& region);

  // Traces all separatrices of the pair. The location is known only if each ends at the boundary or at the pair's other
  // vertex and a configuration of the table has all of them, lengths included. Takes time in proportion to their
  // lengths and allocates nothing.
  Location locate(const Pair& pair);

  std::int64_t calls() const { return calls_; }    // of locate()
  std::int64_t traced() const { return traced_; }  // edges, by all calls
  std::size_t bytes() const { return positions_.capacity() * sizeof(positions_[0]); }

 private:
  template <class T>
  using ForEachSeparatrix = std::array<T, 2 * theory::kMostSeparatrices>;

  static bool merged(const Pair& pair) { return pair[0] == pair[1]; }
  bool trace(const Pair& pair);
  bool collect(mesh::VertexId v, std::size_t which);
  bool set_crossing(std::size_t i, mesh::VertexId other);
  Location locate_merged(mesh::VertexId v) const;
  Location locate_parted(const Pair& pair) const;

  // The values of the separatrices of pair[which].
  template <class T>
  std::span<const T> of_vertex(const ForEachSeparatrix<T>& values, std::size_t which) const {
    return std::span<const T>(values).subspan(which == 0 ? 0 : count_[0], count_[which]);
  }

  const theory::ConfigurationTable& table_;
  theory::PairType type_;
  const mesh::QuadMesh& m_;
  std::vector<mesh::BoundaryPosition> positions_;
  // The separatrices that were traced last: those of the first vertex, then of the second one, each counter-clockwise
  // from mesh.out() on.
  std::array<std::size_t, 2> count_{};
  ForEachSeparatrix<mesh::HalfEdgeId> starts_;
  ForEachSeparatrix<mesh::SeparatrixEnd> arrivals_;
  ForEachSeparatrix<theory::Crossing> crossings_;
  std::int64_t calls_ = 0;
  std::int64_t traced_ = 0;
};

}  // namespace requad::enumerate
