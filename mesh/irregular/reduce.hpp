// Progressive cancellation: a mesh with fewer irregular vertices (section 10, Figure 19).
//
// Again and again the cheapest cancellation of a v3 and a v5 (complementary_operations.hpp) is made, and its
// neighbourhood is fitted to the input (geometry/fitting.hpp), on the way, after some of its transports, and in the end.
// A candidate is a pair of near vertices of opposite index, with the nearest irregular vertices as helpers. It waits in a
// priority queue, with a cost that is guessed from its distance. When its turn comes, its cost is measured by making it,
// without a fit, and rolling it back. After each cancellation, only the candidates round the vertices that it changed are
// added anew. A candidate is measured again when its turn comes, if something has changed since where its helpers were
// looked for.
//
// Candidates are looked for quickly at first. When no more than some tens of pairs are left, which were refused or
// inverted quads, these are looked for thoroughly: with longer searches and more fits. With a bound, fits take more time
// from the start.
//
// A correspondence (geometry/correspondence.hpp) is kept from the first edit on. So the mesh stretches over the ears
// and legs of the input however few quads are left of them.
//
// Law irregular-31. After every cancellation the mesh is valid, and every cut edge (sectors.hpp) is in its place.
// Law irregular-32. Each cancellation lowers the sum of |excess| over all sectors by two or more. So the reduction
//         ends, at the latest when the excesses of each patch have one sign. Discrete Gauss-Bonnet leaves nothing to
//         cancel there: without features eight v3s on a sphere, 8 (g - 1) v5s at genus g > 1.
// Law irregular-33. The result depends on nothing but the mesh and the options, and not on `run`.
// Law irregular-34. If nothing is cancelled, nothing changes, unless a fit of all vertices was asked for. Whatever was
//         not within some rings of an edit keeps its positions to the last bit.
// Law irregular-35. The number of inverted faces does not grow, unless that is allowed. The hausdorff_distance() from
//         the input is at most max_deviation. No cancellation lets the number of free irregular vertices grow, so what
//         is irregular at a boundary does not move inside. A cancellation that would break one of these is not made.
//
// Costs: for each candidate, the length of its transports and the area that is fitted. Only the start and the end
// depend on the size of the mesh.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mesh/editing/mirror.hpp"
#include "mesh/irregular/complementary_operations.hpp"

namespace requad::mesh {

// What a candidate costs.
enum class ReduceCost {
  curvature,  // how much the sum of |discrete mean curvature| over the vertices grows: the paper's
  fit         // the samples of the input whose face is removed, a quarter each, and 0.3 for each operation
};

struct ReduceOptions {
  int until = 0;  // stop at so many irregular vertices
  ReduceCost cost = ReduceCost::fit;
  // The largest hausdorff_distance() from the input that is allowed in the end, in units of length. Fits take more time if
  // it is given. Negative: 0.02 of the diagonal, or no bound if there are no fits.
  double max_deviation = -1;
  // How far the mean scaled Jacobian may fall below that of the input. Negative: no bound.
  double max_quality_loss = -1;
  int patience = 64;  // ends after so many cancellations in a row that were not acceptable; 0: tries all, thoroughly
  int sweeps = 3;     // in each round of a fit (FitOptions); 0: vertices stay where the operations leave them
  int final_rounds = 20;  // of the fit in the end, of all that was touched
  bool fit_all = false;   // the fit in the end moves all vertices, even if nothing was cancelled
  bool allow_inverted = false;
  // The mesh's images. If there are any, each cancellation is made on both sides of the plane, and the result is
  // symmetric (Law editing-22). Pairs whose cancellation meets its own image stay, and so do vertices of a valence beyond
  // 3 and 5.
  std::optional<Mirror> symmetry;
  std::function<void(int irregular)> progress;  // told after each cancellation
  RunTasks run;                                 // of fits; empty: one thread
};

struct ReduceReport {
  int before = 0;  // irregular vertices (Sectors::is_irregular)
  int after = 0;
  int parted = 0;     // operations that parted vertices of valence 2 or more than 5
  int cancelled = 0;  // cancellations
  int transports = 0;
  int operations = 0;
  int measured = 0;                 // cancellations made to measure their cost
  bool lost_patience = false;       // ReduceOptions::patience
  bool minimal = false;             // no patch has vertices of opposite index (Sectors::is_minimal)
  std::map<Refusal, int> refusals;  // of the last attempt on each pair that is left
  int inward = 0;                   // cancellations refused because more vertices off features and boundary would be
                                    // irregular than before
  int worn = 0;                     // cancellations refused because of max_quality_loss
  int folded = 0;                   // cancellations refused because a quad would be inverted
  int too_far = 0;                  // cancellations refused, or taken back, because of max_deviation
  int unsymmetric = 0;              // cancellations refused because they cannot be made on both sides
};

// A reduction that can be watched and stopped. Editor and options must outlive it. Precondition: the editor has
// positions, and nothing was done with it yet, or was forgotten. It keeps a correspondence as long as the reduction lives.
class Reduction {
 public:
  Reduction(Editor& editor, const ReduceOptions& options);
  ~Reduction();
  Reduction(const Reduction&) = delete;
  Reduction& operator=(const Reduction&) = delete;

  // Works a little: measures some candidates, or tries a cancellation. Ended: nothing is left to try, or `until` is reached.
  enum class Slice { working, cancelled, ended };
  Slice advance();
  // The number of irregular vertices now.
  int irregular() const;
  // Fits what was touched. If it is too far from the input then, takes back the last cancellations, and as many as it must;
  // the first of these are not made again. Returns whether it did, so that advance() may find others. Precondition: advance()
  // has ended.
  bool retreat();
  // Fits what was touched. Takes back the last cancellations if max_deviation asks for that; those before them, and
  // their edits, stay. Nothing follows.
  ReduceReport finish();

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

// The whole reduction. Preconditions as above.
ReduceReport reduce(Editor& editor, const ReduceOptions& options);

}  // namespace requad::mesh
