// Pair moves: what each step does to a labelling, which steps a region has, and whether a script is one move.
//
// check-6  (Theorems 7.2, 7.3, 7.4 and section 6) The four steps change a labelling so, and leave p as it is:
//
//            step           (d1, d2) of 3-3   of 5-5     (e_1, e_2) of 3-5   towards
//            slide_first       (+1, -1)      (-1, +1)       (-1,  0)         the side of label 1
//            slide_second      (-1, +1)      (+1, -1)       (+1,  0)         label 3
//            open              (-1, -1)      (+1, +1)       ( 0, -1)         label 2
//            close             (+1, +1)      (-1, -1)       ( 0, +1)         label 4
//
//          slide_first and slide_second undo each other, and so do open and close.
//
// check-7  A configuration has the moves that lead from one of its labellings to a labelling of a configuration of the
//          region. It has no others: a move leads to a filling of the region, and all fillings are listed. In a 3-5
//          region the two labellings of a segment name the same moves, towards the same sides.
//
// check-8  (section 6) A move takes one vertex of the pair one edge further, from p to p'. This leaves an adjacent 3-5
//          pair, which is transported until it is absorbed and a pair is there again. So each mesh on the way holds
//          p', the other vertex q, and two vertices at the ends of an edge, with the indices of p and q, +1 and -1.
//          Where some of the four are one vertex, their indices add up. p' and q keep their names on the way. The first
//          operation changes the index of p. The last one leaves p' as it is, so that q absorbs the pair: one that goes
//          round q and back to p' is no move, though it can make the same mesh. A mesh on the way that holds a pair or a
//          merged vertex shows that the script is made of two moves. An open move only splits, and a close move only
//          collapses.
#pragma once

#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/check/disk.hpp"
#include "verify/check/labels.hpp"

namespace check {

enum class Step { slide_first, slide_second, open, close };
// Throws Rejected if the word is none of the four.
Step step_of(std::string_view word);
const char* name(Step step);
Step inverse(Step step);

// The moves of all configurations of a region, each of which has two ends.
class Moves {
 public:
  Moves(const Region& region, std::vector<std::vector<Labelling>> labellings);

  // An end as a certificate writes it: a labelling of a configuration by d1, d2 and p.
  struct End {
    int node;
    int d1;
    int d2;
    int p;
  };
  // Takes note of a move. Throws Rejected if the labellings are not those of the configurations, if the step does not
  // lead from one to the other, or if the move is noted already, be it from its other end.
  void add(const End& from, Step step, const End& to);
  // Throws Rejected, and names a configuration and a step, unless all moves are noted (check-7). O(configurations).
  void require_all() const;

 private:
  // What an end of a move looks like from its configuration: (d1, d2, p, step), or the side that a 3-5 pair moves to.
  using Slot = std::array<int, 4>;

  // The labelling after a step. Its e is not used for equal valences, and empty.
  std::vector<int> stepped(const Labelling& labelling, Step step) const;
  std::vector<int> key(const Labelling& labelling) const;
  Slot slot(const Labelling& labelling, Step step) const;
  const Labelling& labelling(const End& end) const;
  std::string describe(const Labelling& from, Step step) const;

  const Region region_;
  std::vector<std::vector<Labelling>> labellings_;  // of each configuration
  std::map<std::vector<int>, int> node_;            // by key()
  std::set<std::pair<int, Slot>> noted_;            // both ends of each move
};

// Watches a script from before its first operation.
class Transport {
 public:
  Transport(const Region& region, const Disk& before);
  // Looks at the mesh after an operation that is not the last one. Throws Rejected unless it is as check-8 says.
  void pass(const Disk& disk);
  // Looks at the mesh after the last operation, which holds the pair or the merged vertex. The same.
  void arrive(const Disk& disk) const;

 private:
  // What may be true: q, and p' once it is known.
  struct Guess {
    Irregular q;
    Irregular moved;
  };
  bool fits(const Disk& disk, const Guess& guess) const;

  const Region region_;
  const std::vector<Irregular> before_;
  std::vector<Irregular> pair_;  // before_; the merged vertex is two vertices in one place
  std::vector<Guess> guesses_;
  bool started_ = false;
};

}  // namespace check
