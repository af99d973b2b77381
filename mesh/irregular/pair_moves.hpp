// The three pair-wise movement operations of section 6 (3-3, 5-5, 3-5), as one mechanism.
//
// How a move works. A move starts at one vertex p of the pair and ends at the other, q. Its first basic operation moves
// p by one edge and leaves an adjacent 3-5 pair behind. Each further operation transports this adjacent pair by one
// face or edge. The last one lets it collide with q, which moves by one edge. An adjacent pair has six steps (Figure
// 3): a split, a collapse and a flip on either hand, seen from its v3 to its v5. The first operation is such a step,
// too: p stands for the adjacent pair's v3 or v5. In the last operation q stands for the vertex that the pair moves to.
//
// The four steps. Two slides transport the adjacent pair along R_alpha on one hand: forward by splits, sideways by
// collapses, and diagonally by flips, each of which saves a split and a collapse. Two more, open and close, use only
// splits or only collapses, on both hands, along any monotone path of R_alpha's boundary from p to q.
//
//   step           changes (d1, d2) of a 3-3 pair   of a 5-5 pair   moves a 3-5 pair (frame.v1 is the v5) towards
//   slide_first           (+1, -1)                    (-1, +1)      the side of v1's first outward separatrix
//   slide_second          (-1, +1)                    (+1, -1)      the side of v1's last outward separatrix
//   open                  (-1, -1)                    (+1, +1)      the side of v1's middle outward separatrix
//   close                 (+1, +1)                    (-1, -1)      the side of v2's outward separatrix
//
// Law irregular-11 (faces, claim P3). Let c be -1, +1, 0 for a 3-3, 5-5, 3-5 pair. The mesh gains d2 - d1 + c faces by
// slide_first, d1 - d2 + c by slide_second and d1 + d2 + c by open; it loses d1 + d2 - c by close. So open and close
// change as many faces as the connecting path is long, up to c, and slides as many as its two extents differ by.
//
// Law irregular-12 (locality, claim N4). A move changes no valence outside the smallest convex region that holds the
// pair before and after. It changes no valence on the boundary of the mesh, not even on its way.
//
// Legality. A move is legal if all its operations are, if it meets no boundary and no other irregular vertex, and if the
// pair then spans the rectangle that the table says. Nothing predicts this: move_pair() tries, from v1 and then from v2,
// and rolls back what is refused. pair_moves() lists candidates only.
//
// Law irregular-13 (room). All candidates are legal if R_alpha has room (has_room() in pair_frame.hpp): it is embedded
// with the faces round it, and regular. In a convex region it has room exactly if all strips e_i are 2 or more.
// On closed surfaces separatrices wind round, and R_alpha can overlap itself or contain other irregular vertices. Many
// moves are legal there nevertheless, and the laws hold for those. The others are refused.
//
// Law irregular-14 (inverse). If R_alpha has room, the inverse of a legal move is legal and restores the mesh up to
// isomorphism. Without room it can be refused or lead to another mesh, where the adjacent pair passes an irregular vertex
// in R_alpha or its own path on the other side. MoveReport::undo is exact always.
//
// Law irregular-15 (order). The pairs v1, v2 and v2, v1 have the same moves.
//
// Costs: max(d1, d2) + O(1) basic operations for a slide, d1 + d2 + O(1) for open and close, whatever the size of the
// mesh. The frame in the report takes walks of d1 + d2 edges and no operation.
#pragma once

#include <array>
#include <vector>

#include "mesh/editing/operation_log.hpp"
#include "mesh/irregular/edit_refusal.hpp"
#include "mesh/irregular/pair_frame.hpp"

namespace requad::mesh {

enum class PairStep { slide_first, slide_second, open, close };
inline constexpr std::array<PairStep, 4> kPairSteps{PairStep::slide_first, PairStep::slide_second, PairStep::open,
                                                    PairStep::close};
PairStep inverse(PairStep step);
const char* name(PairStep step);  // "slide_first", ...

// A step seen from a frame. For a 3-5 pair frame.v1 is the v5. A merged pair has d1 = d2 = 0 and v1 = v2, and only one
// step. If its valence is 6, it opens along first_leg and the edge opposite it. If its valence is 2, it closes the face
// on the left of first_leg.
struct PairMove {
  PairFrame frame;
  PairStep step = PairStep::slide_first;
  // The end of the pair at which the move starts; if it is refused, it starts at the other. The adjacent pair goes round
  // the other corner of R_alpha then. Where R_alpha is a grid this makes no difference to the mesh, up to isomorphism.
  bool from_v2 = false;
};

// The four moves that the pair could make if the mesh had room. Empty if v1 and v2 are no 3-3, 5-5 or 3-5 pair, or if
// they span no rectangle. A segment has two frames (find_frames()). The moves of a 3-5 pair are seen from that with
// d2 = 0. Those of equal vertices are seen from both, since each frame has steps that the other one lacks.
std::vector<PairMove> pair_moves(const QuadMesh& mesh, VertexId v1, VertexId v2);
// The moves that part a merged pair: one for a v2, three for a v6, none for any other valence.
std::vector<PairMove> parting_moves(const QuadMesh& mesh, VertexId merged);

struct MoveReport {
  Refusal refusal = Refusal::none;
  std::vector<BasicOperation> operations;  // in the order in which they were applied
  std::vector<BasicOperation> undo;        // the inverses, last first: they restore every array of the mesh
  std::array<VertexId, 2> after;  // v1 and v2 of the move's frame as they are now; one vertex twice if they merged
  PairMove inverse;               // inverse.frame is the pair's frame after the move

  int faces_made() const;     // one for each split
  int faces_deleted() const;  // one for each collapse
};

// Makes the move, by checked basic operations only. If one is refused, the log is rolled back: the mesh is as before,
// arrays and free lists included, and the report holds the reason and nothing else.
MoveReport move_pair(OperationLog& log, const PairMove& move);
MoveReport move_pair(QuadMesh& mesh, const PairMove& move);
// The reason that move_pair() would give. Makes the move and rolls it back, which leaves an equal mesh. O(d1 + d2).
Refusal why_not_move_pair(QuadMesh& mesh, const PairMove& move);

// Makes one move after another on one mesh, for long walks. It performs the checked operations of move_pair(), but
// writes no report and does not look for R_alpha afterwards. After its longest move it allocates nothing more if the
// mesh has room (QuadMesh::reserve).
class PairMover {
 public:
  // The mesh must outlive it.
  explicit PairMover(QuadMesh& mesh) : log_(mesh) {}

  struct Moved {
    Refusal refusal = Refusal::none;  // the mesh is then as before
    VertexId v1;                      // the pair, in the order that frames have; one vertex twice if it merged
    VertexId v2;
    int operations = 0;
  };
  Moved move(const PairMove& move);

 private:
  OperationLog log_;  // of the last move
};

}  // namespace requad::mesh
