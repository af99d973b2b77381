// What a pair move must be on any mesh, closed or not: the laws of mesh/irregular/pair_moves.hpp, checked for every move
// of a pair by other means than those that made the move.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mesh/irregular/pair_moves.hpp"

namespace requad::tests {

struct PairMoveTally {
  std::int64_t pairs = 0;
  std::int64_t listed = 0;                      // of v1, v2; as many are listed for v2, v1
  std::int64_t made = 0;                        // of these
  std::int64_t irreversible = 0;                // inverses that are refused: none where there is room
  std::int64_t with_room = 0;                   // listed for a frame that has room (law irregular-13)
  std::int64_t overlapping = 0;                 // listed for a frame that overlaps itself
  std::int64_t isomorphic = 0;                  // inverses that restore the mesh up to isomorphism
  std::int64_t elsewhere = 0;                   // inverses that lead to another mesh: none where there is room
  std::map<std::string, std::int64_t> refused;  // by reason

  PairMoveTally& operator+=(const PairMoveTally& other);
};
std::string to_string(const PairMoveTally& tally);

// Lists the moves of the pair, and of the pair in the other order, makes each of them on a copy, undoes it, and makes its
// inverse. Returns the first law that does not hold, with the pair and the move; "" if all hold. Two meshes of at most
// `largest` faces are compared up to isomorphism where the law says that; of larger ones the sizes are compared.
std::string check_pair(const mesh::QuadMesh& mesh, mesh::VertexId v1, mesh::VertexId v2, PairMoveTally& tally,
                       int largest = 1000);

// The pairs of irregular vertices of valence 3 and 5, each once: all of them, or `most` that the seed chooses.
std::vector<std::pair<mesh::VertexId, mesh::VertexId>> irregular_pairs(const mesh::QuadMesh& mesh, std::size_t most,
                                                                       unsigned seed);

// check_pair() for these pairs. Stops at the first violation.
std::string check_pairs(const mesh::QuadMesh& mesh, std::size_t most, unsigned seed, PairMoveTally& tally,
                        int largest = 1000);

}  // namespace requad::tests
