// What the editor in the browser asks of the library: open a mesh, say what can be done, show what it would do, do it,
// undo it, and write the result. The page draws and listens; everything that knows quads is here.
//
// Terms (and those of offer.hpp)
//   step        an entry of the history: an edit with the fit of the vertices round it, a smoothing, a script that was
//               replayed, or a change of the features. undo() undoes one step.
//   number      of a vertex: the one that it has in the file of the present mesh, counted from 1, as requad-edit counts.
//
// Laws
//   web-1  What an offer shows is exact: perform() of this offer changes the valences of just the `vertices`, and the
//          corners of just the `quads`, that it lists.
//   web-2  undo() restores mesh, ids and positions to the last bit, and redo() what undo() undid. offers() changes
//          nothing.
//   web-3  The steps are edits of requad-edit. `requad-edit apply` makes the exported mesh of the input and the exported
//          script, byte by byte. (Of transports that are equally short, cancel may take another one than requad-edit.)
// At the start the features are the seams of texture coordinates, as for requad-edit without options.
//
// Costs: an offer and a step cost what their operations cost, whatever the size of the mesh; but the numbers of vertices
// are counted once after each step, and inverted quads in its fit, O(V). Opening, features, script() and export_obj() are
// linear in the mesh.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mesh/editing/editor.hpp"
#include "mesh/editing/shape_keeper.hpp"
#include "mesh/files/feature_edges.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/irregular/complementary_operations.hpp"
#include "mesh/irregular/reduce.hpp"
#include "mesh/topology/distances.hpp"
#include "mesh/web/offer.hpp"

namespace requad::web {

struct Description {
  int vertices = 0;
  int quads = 0;
  int boundary_loops = 0;
  int genus = 0;
  std::map<int, int> irregular;  // the number of irregular vertices of each valence
  int index_sum = 0;             // of 4 - l(v) over the irregular vertices, which no edit inside the mesh changes
  int inverted = 0;
  int features = 0;  // edges
  // If all irregular vertices are v3s and v5s, there are at least so many: |index_sum|.
  int least_irregular() const { return index_sum < 0 ? -index_sum : index_sum; }
};

// What changed since take_changes() was called last, for the screen. A quad that is listed may be gone.
struct Changes {
  bool everything = false;  // a mesh was opened; the lists are empty
  bool features = false;    // the features changed
  std::vector<VertexId> vertices;
  std::vector<FaceId> quads;
};

// The feature edges, and the number of quads planned for each sector between them.
struct Features {
  mesh::FeatureSet edges;
  mesh::SectorPlan plan;
};

struct Step {
  std::string words;      // what was done, for the history
  std::size_t begin = 0;  // its first edit, as Editor::mark() counts
  std::size_t end = 0;    // one past its last edit
  // If it changes the features: those before it and after it.
  std::shared_ptr<const Features> before = nullptr;
  std::shared_ptr<const Features> after = nullptr;
};

class Session {
 public:
  // The text of an OBJ or OFF file of this name; `subdivided` cuts polygons into quads. Throws FileError, one line with
  // name, line and reason.
  static mesh::Surface read(std::string_view text, const std::string& name, bool subdivided);
  // Starts from a surface that was read.
  explicit Session(mesh::Surface input);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const mesh::QuadMesh& mesh() const { return mesh_; }
  const mesh::Positions& positions() const { return positions_; }
  Description describe() const;
  const std::set<VertexId>& irregular() const { return irregular_; }
  int number(VertexId v) const;
  // The vertex with this number, or none.
  VertexId numbered(int number) const;
  // "12 (v3)".
  std::string name_of(VertexId v) const;
  // The irregular vertices nearest to v, nearest first.
  std::vector<VertexId> nearest_irregular(VertexId v, int most);
  // The separatrices of v, each as its vertices; the straight paths along its edges if v is regular.
  std::vector<std::vector<VertexId>> separatrices(VertexId v) const;
  // The boundary, loop by loop; the first vertex comes last again. No edit changes it.
  std::vector<std::vector<VertexId>> boundary() const;
  // The quads of R_alpha and the vertices round it; empty if a and b span no rectangle.
  struct Rectangle {
    std::vector<FaceId> quads;
    std::vector<VertexId> rim;
  };
  Rectangle rectangle(VertexId a, VertexId b) const;
  // What a ray that hits the quad points at: a corner, an edge, or the quad itself; if `corner`, its nearest corner.
  Selection pointed_at(FaceId quad, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                       bool corner = false) const;
  // Whether the elements of the selection are there.
  bool is_live(const Selection& selection) const;

  // The edits of a selection:
  //   vertex  the atomic operations of section 5 at it
  //   pair    the moves of section 6, or transports if the pair spans no rectangle; merging, aligning, cancelling
  //   edge    the two flips, the atomic operations along it, making it a feature edge or an ordinary one
  //   quad    the two collapses
  // The offers stay valid until the next step, undo or redo, or until others are asked for.
  const Offers& offers(const Selection& selection);
  // Those of them that are quickly found: all but merging, aligning and cancelling, for which distant pairs take long.
  // `more` says whether these are still to come.
  const Offers& quick_offers(const Selection& selection);
  // Makes the edit of this name and fits what lies around it. Returns "", or why it was refused: nothing changes then.
  // `watch` is told after each operation of it: the quads that it changed, made or removed.
  using Watch = std::function<void(std::span<const FaceId>)>;
  std::string perform(const Selection& selection, const std::string& name, const Watch& watch = {});

  // Steps that need no offer. Each returns "", or why it was refused.
  //
  // Smooths the vertices within so many rings of these and keeps the shape; all vertices if there are none. It is
  // refused if more quads would be inverted, or if nothing moves. About 0.1 ms for each vertex.
  std::string smooth(std::span<const VertexId> centres, int rings);
  // Makes these edges the features, in place of those that there are; the quads between features are planned anew.
  std::string set_features(const mesh::FeatureEdges& edges);
  // Replays a script on the mesh that was opened. Refused unless all steps are undone. Throws
  // FileError if the script has a mistake or belongs to another mesh.
  std::string apply(std::string_view script, const std::string& name);

  mesh::FeatureEdges features() const { return features_.edges.edges(); }
  // The edges that bend by so many degrees or more.
  mesh::FeatureEdges sharp(double degrees) const { return mesh::sharp_edges(mesh_, positions_, degrees); }

  // Cancels pairs step by step, the cheapest first (irregular/reduce.hpp), until so many irregular vertices are left or
  // none can be cancelled; each cancellation is a step. The mesh stays within the deviation (of its diagonal; negative:
  // as ReduceOptions has it) from what it is now. Any other step, and undo(), end the reduction.
  void start_reduction(int until, double deviation);
  // Works for some milliseconds. Precondition: a reduction runs.
  using Slice = mesh::Reduction::Slice;
  Slice reduce();
  // Fits what was touched, as a last step, and ends the reduction. Steps that went too far are undone. Precondition: a
  // reduction runs.
  void finish_reduction();
  bool reduces() const { return reduction_ != nullptr; }

  const std::vector<Step>& steps() const { return steps_; }          // done, the first one first
  const std::vector<Step>& undone() const { return undone_steps_; }  // the one to redo next comes last
  bool undo();
  bool redo();
  // The operations of a step that is done, as lines of a script.
  std::vector<std::string> lines(const Step& step) const;

  // The texts of the edit script and of the OBJ file with its attributes, as requad-edit --script and -o write them.
  std::string script() const;
  std::string export_obj() const;

  Changes take_changes() { return std::exchange(changes_, {}); }

 private:
  struct Outcome;
  struct Reduction;
  // What the edits of a step changed.
  struct Touched {
    std::vector<VertexId> vertices;
    std::vector<FaceId> quads;  // made, removed, or at these vertices
  };
  // Each makes edits of the selection in turn, adds an offer for each, and rolls it back.
  mesh::Refusal offer_quick(const Selection& selection);
  mesh::Refusal offer_moves(VertexId a, VertexId b);
  void offer_complementary(const Selection& selection);
  void offer_cancellation(const Selection& selection);
  mesh::Cancellation cancel(const Selection& selection, const std::vector<VertexId>& helpers,
                            const std::function<void(std::size_t)>& after_transport);
  void offer_atomic(const Selection& selection);
  void offer_basic(const mesh::BasicOperation& operation, const std::string& name);
  void offer_feature(VertexId a, VertexId b);
  void advise(const Selection& selection, mesh::Refusal refusal);
  void add_offer(std::size_t mark, Offer offer);
  std::vector<mesh::Edit> edits_of(std::size_t offer);
  Outcome outcome_since(std::size_t mark) const;
  void compare(const Outcome& outcome, Offer& offer) const;
  std::string words_for(const Outcome& outcome) const;
  Touched touched_by(const Step& step) const;
  void add_round(Touched& touched) const;  // the quads at its vertices as the mesh is now
  void note_changes(const Touched& touched);
  void finish_step(Step step);
  void take_features(const std::shared_ptr<const Features>& features);
  std::string change_features(mesh::FeatureSet edges, std::string words);
  void take_over(const Reduction& reduction, std::string words);
  bool is_inverted(FaceId f) const;
  std::string words_for(const Selection& selection, const std::string& name) const;

  mesh::Surface input_;
  mesh::QuadMesh mesh_;
  mesh::Positions positions_;
  Features features_;
  mesh::Editor editor_;
  mesh::ShapeKeeper shape_;
  mesh::BreadthFirstDistances distances_;
  int boundary_loops_ = 0;
  int genus_ = 0;
  std::set<VertexId> irregular_;
  std::set<FaceId> inverted_;
  mutable std::vector<int> numbers_;  // by vertex slot; empty if they are to be counted anew
  std::optional<Selection> offered_to_;
  Offers offered_;
  std::vector<std::vector<mesh::Edit>> offered_edits_;  // by offer
  std::vector<Step> steps_;
  std::vector<Step> undone_steps_;
  std::vector<std::vector<mesh::Edit>> undone_edits_;  // of the undone steps
  std::shared_ptr<Reduction> reduction_;
  Changes changes_;
};

}  // namespace requad::web
