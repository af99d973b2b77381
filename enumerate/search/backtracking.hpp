// The engine of the exhaustive search: backtracking, depth first, on one partial mesh that is changed in place.
//
// Search tree. Its root is the partial mesh to start from. The children of a partial mesh are the placements of a quad
// on one edge of its first hole (placements.hpp says why each filling is then found once). A leaf has no hole or no
// placement. Untried placements are on an explicit stack, so there is no recursion, and no allocation once the stacks
// have grown.
//
// Guiding paths. The mesh alone determines the order in which its placements are listed, and they are tried from the
// last to the first. So two numbers for each level describe what the search has done and what remains: which placement
// was chosen and how many are untried. These paths are used to stop and resume searches, and to share work between
// threads.
//
// Internal: not installed.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "enumerate/search/partial_mesh.hpp"
#include "enumerate/search/placements.hpp"
#include "enumerate/search/search_control.hpp"

namespace requad::enumerate {

// A copy continues from where the original stands.
class BacktrackingSearch {
 public:
  using Visit = std::function<void(const Filling&)>;
  // How a running search gives work away.
  struct WorkSharing {
    const std::atomic<bool>& wanted;                        // whether somebody waits for work
    std::function<void(const BacktrackingSearch&)> donate;  // takes the search that is given away
  };
  // Chosen and untried for each level but the last, then untried for the last.
  using GuidingPath = std::vector<int>;

  // Preconditions: start.has_hole(), may_be_filled(start). `control` must outlive the search.
  BacktrackingSearch(PartialMesh start, SearchControl& control);

  // Calls visit for each filling that is still to be found. Returns true when all are found, and false if the search
  // was told to stop; the next run() then continues from there. About every thousand states it asks SearchControl
  // whether to stop, and it gives work away if some is wanted: all untried placements on the level nearest to the root,
  // provided that some work remains here.
  bool run(const Visit& visit, const WorkSharing& sharing);
  // The number of quads that the last run() placed.
  std::int64_t states() const { return states_; }

  // An estimate of the work, to show progress: all children of a partial mesh count as equal shares of it. The whole
  // tree is the share 1 unless this says otherwise. Precondition: the search stands where it started.
  void set_share(double share);
  // The share of what is still to be searched.
  double remaining_share() const;

  GuidingPath guiding_path() const;
  // Moves to where a search with the same start had this path. Places and removes as many quads as both paths have
  // levels. Throws std::invalid_argument if the numbers are not a path of this search; its position is then undefined.
  void go_to(const GuidingPath& path);

 private:
  // A partial mesh on the path from the root to where the search stands.
  struct Level {
    int first;     // its untried placements are those from here on, up to the next level's
    int v;         // all its placements are on the edge from this node
    int chosen;    // the number of the placement that leads to the next level
    double share;  // of all the work, in each of its children; of itself if it has none
  };

  int untried(std::size_t level) const;
  void list_children();
  void descend(int chosen, int untried);
  void ascend();
  void donate_work(const WorkSharing& sharing);

  PartialMesh mesh_;
  SearchControl* control_;
  std::vector<Placement> placements_;  // untried, level by level
  std::vector<Level> levels_;          // never empty
  double share_ = 1;                   // of the whole tree
  std::int64_t states_ = 0;
  double finished_ = 0;  // the share of the leaves met since the last report
};

}  // namespace requad::enumerate
