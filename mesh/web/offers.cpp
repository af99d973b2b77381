// The offers of a session: each edit of a selection is made, looked at, and rolled back; perform() makes one again.
#include <algorithm>
#include <span>

#include "mesh/irregular/atomic_operations.hpp"
#include "mesh/irregular/complementary_operations.hpp"
#include "mesh/irregular/possible_moves.hpp"
#include "mesh/topology/id_lists.hpp"
#include "mesh/web/session.hpp"

namespace requad::web {

using mesh::BasicOperation;
using mesh::Edit;
using mesh::EditRefusal;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Refusal;

namespace {

constexpr const char* kCancel = "cancel";

// A refusal in words; "" if there is none.
std::string words(Refusal refusal, const mesh::Obstacles& obstacles = {}) {
  if (refusal == Refusal::none) return "";
  const std::string met = refusal == EditRefusal::no_path ? to_string(obstacles) : "";
  return std::string(refusal.clause()) + (met.empty() ? "" : "; in the way: " + met);
}

// What would help after this refusal; "" if nothing is known to.
std::string what_helps(Refusal refusal, const mesh::Obstacles& obstacles) {
  if (refusal == EditRefusal::odd_distance)
    return "a third irregular vertex changes the parity: move one of the two with it by an odd number of edges";
  if (refusal == EditRefusal::lone_pair) return "make a third irregular vertex first, by an operation at a vertex";
  if (refusal == EditRefusal::touches_boundary)
    return "other moves lead away from the boundary, or split quads between it and the pair";
  if (refusal == mesh::FeatureRefusal::breaks_feature) return "choose the edge and make it no feature";
  if (refusal == EditRefusal::irregular_in_the_way) return "move that vertex away first, with another one";
  if (refusal == EditRefusal::no_rectangle || refusal == EditRefusal::overlaps_itself)
    return "transports need no rectangle: move one of the two with a nearer irregular vertex first";
  if (refusal == EditRefusal::index) return "choose a v3 and a v5, which have opposite indices";
  if (refusal == EditRefusal::no_path) {
    if (obstacles.features)
      return "make the features in the way ordinary edges, or go by a third vertex on their other side";
    return obstacles.irregular ? "move what is in the way first, or choose nearer vertices" : "choose nearer vertices";
  }
  return "";
}

}  // namespace

// --- what an edit does -----------------------------------------------------------------------------------------------

// Where the edits of an offer led: what the vertices whose valence changed on the way have now, and the quads at them.
// A quad that an operation changed has a corner whose valence the operation changed, before it and after it.
struct Session::Outcome {
  std::vector<VertexId> vertices;
  std::vector<int> valences;  // of these; 0 if it is gone
  std::map<FaceId, std::array<VertexId, 4>> quads;
};

Session::Outcome Session::outcome_since(std::size_t mark) const {
  Outcome outcome;
  const std::vector<Edit>& edits = editor_.edits();
  for (std::size_t i = mark; i < edits.size(); ++i) {
    for (const VertexId v : edits[i].changed) {
      if (v.valid()) outcome.vertices.push_back(v);
    }
  }
  mesh::sort_once(outcome.vertices);
  for (const VertexId v : outcome.vertices) outcome.valences.push_back(mesh_.is_live(v) ? mesh_.valence(v) : 0);
  for (const FaceId f : mesh::faces_round(mesh_, outcome.vertices)) outcome.quads.emplace(f, mesh_.corners(f));
  return outcome;
}

// Lists what the outcome differs in from the present mesh.
void Session::compare(const Outcome& outcome, Offer& offer) const {
  for (std::size_t i = 0; i < outcome.vertices.size(); ++i) {
    const VertexId v = outcome.vertices[i];
    if (mesh_.is_live(v) && mesh_.valence(v) != outcome.valences[i]) offer.vertices.push_back(v);
  }
  for (const FaceId f : mesh::faces_round(mesh_, outcome.vertices)) {
    const auto after = outcome.quads.find(f);
    if (after == outcome.quads.end() || after->second != mesh_.corners(f)) offer.quads.push_back(f);
  }
}

// What becomes of the valences, such as "12: v4 to v3, new: v5".
std::string Session::words_for(const Outcome& outcome) const {
  std::string words;
  for (std::size_t i = 0; i < outcome.vertices.size(); ++i) {
    const VertexId v = outcome.vertices[i];
    const int before = mesh_.is_live(v) ? mesh_.valence(v) : 0, after = outcome.valences[i];
    if (before == after) continue;
    words += (words.empty() ? "" : ", ") +
             (before > 0 ? std::to_string(number(v)) + ": v" + std::to_string(before) + " to " : std::string("new: ")) +
             (after > 0 ? "v" + std::to_string(after) : "gone");
  }
  return words;
}

void Session::add_offer(std::size_t mark, Offer offer) {
  const auto edits = std::span(editor_.edits()).subspan(mark);
  offer.counts = mesh::count(edits);
  const Outcome outcome = outcome_since(mark);
  offered_edits_.emplace_back(edits.begin(), edits.end());
  editor_.roll_back(mark);
  compare(outcome, offer);
  if (offer.is_legal() && offer.effect.empty()) offer.effect = words_for(outcome);
  offered_.list.push_back(std::move(offer));
}

// --- the edits of a selection ----------------------------------------------------------------------------------------

Refusal Session::offer_moves(VertexId a, VertexId b) {
  const std::array<Eigen::Vector3d, 2> before{positions_[a.slot()], positions_[b.slot()]};
  const std::size_t mark = editor_.mark();
  return mesh::for_each_move(editor_, a, b, [&](const mesh::PossibleMove& move) {
    Offer offer;
    offer.name = move.name;
    offer.why = words(move.refusal, move.obstacles);
    offer.help = what_helps(move.refusal, move.obstacles);
    // A 3-5 pair keeps its rectangle: what changes is where it is.
    const bool translated = move.from && move.to && move.from->d1 == move.to->d1 && move.from->d2 == move.to->d2;
    offer.effect = translated ? "both vertices move by an edge, " + extents_text(*move.to) + " stays" : move.effect;
    offer.after = move.after;
    for (std::size_t i = 0; i < 2 && offer.is_legal(); ++i) {
      const VertexId v = move.after[i];
      offer.arrows.push_back({before[i], v.valid() ? positions_[v.slot()] : before[i]});
    }
    add_offer(mark, std::move(offer));
    return false;
  });
}

mesh::Cancellation Session::cancel(const Selection& selection, const std::vector<VertexId>& helpers,
                                   const std::function<void(std::size_t)>& after_transport) {
  const bool a_lacks = mesh_.valence(selection.a) < 4;
  mesh::PairTransport transport(editor_);
  return mesh::cancel_pair(editor_, transport, a_lacks ? selection.a : selection.b, a_lacks ? selection.b : selection.a,
                           helpers, after_transport);
}

// The offer shows what a cancellation changes. So it is found without fits, which take several times as long.
void Session::offer_cancellation(const Selection& selection) {
  const std::size_t mark = editor_.mark();
  Offer offer;
  offer.name = kCancel;
  offer.helpers = selection.helpers;
  if (offer.helpers.empty()) {
    const bool a_lacks = mesh_.valence(selection.a) < 4;
    offer.helpers = mesh::usual_helpers(editor_, distances_, a_lacks ? selection.a : selection.b,
                                        a_lacks ? selection.b : selection.a);
  }
  const mesh::Cancellation result = cancel(selection, offer.helpers, {});
  offer.why = words(result.refusal, result.obstacles);
  offer.help = what_helps(result.refusal, result.obstacles);
  offer.effect = "both become regular; third vertices move by " + std::to_string(result.transports) +
                 (result.transports == 1 ? " edge" : " edges");
  add_offer(mark, std::move(offer));
}

// Cancelling of two of opposite kinds, or merging and aligning of two of a kind.
void Session::offer_complementary(const Selection& selection) {
  const VertexId a = selection.a, b = selection.b;
  if ((mesh_.valence(a) - 4) * (mesh_.valence(b) - 4) < 0) return offer_cancellation(selection);
  const std::size_t mark = editor_.mark();
  for (const auto& [name, operation] : {std::pair("align", &mesh::align_pair), std::pair("merge", &mesh::merge_pair)}) {
    const mesh::PairResult result = operation(editor_, a, b);
    Offer offer;
    offer.name = name;
    offer.why = words(result.refusal);
    offer.help = what_helps(result.refusal, {});
    if (offer.is_legal() && result.moves == 0) offer.why = "a separatrix joins them already";
    if (offer.is_legal()) {
      offer.after = {result.frame.v1, result.frame.v2};
      offer.effect = result.frame.merged() ? "both become one v" + std::to_string(mesh_.valence(result.frame.v1))
                                           : "a separatrix joins them: " + mesh::extents_text(result.frame);
    }
    add_offer(mark, std::move(offer));
  }
}

void Session::offer_atomic(const Selection& selection) {
  const bool edge = selection.kind == Selection::Kind::edge;
  const std::size_t mark = editor_.mark();
  if (mesh_.is_boundary(selection.a)) return;
  const std::vector<mesh::AtomicChoice> choices =
      edge ? mesh::atomic_operations(editor_, mesh_.find_half_edge(selection.a, selection.b))
           : mesh::atomic_operations(editor_, selection.a);
  for (const mesh::AtomicChoice& choice : choices) {
    Offer offer;
    const HalfEdgeId along = choice.operation.along;
    offer.name = to_string(choice.operation.name) + " from " + std::to_string(number(mesh_.origin(along))) + " to " +
                 std::to_string(number(mesh_.target(along)));
    offer.why = words(choice.refusal);
    offer.help = what_helps(choice.refusal, {});
    if (offer.is_legal()) mesh::perform(editor_, choice.operation);
    add_offer(mark, std::move(offer));
  }
}

void Session::offer_basic(const BasicOperation& operation, const std::string& name) {
  const std::size_t mark = editor_.mark();
  Offer offer;
  offer.name = name;
  const Refusal refusal = editor_.run(operation).refusal;
  offer.why = words(refusal);
  offer.help = what_helps(refusal, {});
  add_offer(mark, std::move(offer));
}

void Session::offer_feature(VertexId a, VertexId b) {
  Offer offer;
  offer.feature = !features_.edges.is_edge(a, b);
  offer.name = *offer.feature ? "make it a feature" : "make it no feature";
  offer.effect = *offer.feature ? "edits keep the edge" : "edits may change the edge";
  add_offer(editor_.mark(), std::move(offer));
}

Refusal Session::offer_quick(const Selection& selection) {
  using Kind = BasicOperation::Kind;
  if (!is_live(selection)) return Refusal::dead_element;
  switch (selection.kind) {
    case Selection::Kind::vertex:
      if (mesh_.is_boundary(selection.a)) return EditRefusal::touches_boundary;
      offer_atomic(selection);
      break;
    case Selection::Kind::pair: {
      const Refusal refusal = offer_moves(selection.a, selection.b);
      offered_.more = refusal == Refusal::none && !editor_.is_fixed(selection.a) && !editor_.is_fixed(selection.b);
      return refusal;
    }
    case Selection::Kind::edge: {
      HalfEdgeId h = mesh_.find_half_edge(selection.a, selection.b);
      if (!h.valid()) h = mesh_.find_half_edge(selection.b, selection.a);
      offer_basic({Kind::flip_ccw, h, {}, 0}, "flip counter-clockwise");
      offer_basic({Kind::flip_cw, h, {}, 0}, "flip clockwise");
      if (mesh_.is_boundary(h)) break;
      offer_atomic(selection);
      offer_feature(selection.a, selection.b);
      break;
    }
    case Selection::Kind::quad:
      for (const int corner : {0, 1}) {
        // Either corner of a diagonal may be the one that goes. The meshes differ by names only.
        HalfEdgeId h = QuadMesh::half_edge(selection.quad, corner);
        if (editor_.why_not({Kind::collapse, h, {}, 0}) != Refusal::none &&
            editor_.why_not({Kind::collapse, QuadMesh::opposite(h), {}, 0}) == Refusal::none)
          h = QuadMesh::opposite(h);
        const auto end = [this](HalfEdgeId g) { return std::to_string(number(mesh_.origin(g))); };
        offer_basic({Kind::collapse, h, {}, 0}, "collapse " + end(QuadMesh::opposite(h)) + " onto " + end(h));
      }
      break;
  }
  return Refusal::none;
}

void Session::advise(const Selection& selection, Refusal refusal) {
  if (refusal == EditRefusal::wrong_valences) offered_.hint = "Choose two irregular vertices, each a v3 or a v5.";
  if (refusal == EditRefusal::touches_boundary) offered_.hint = "Choose a vertex inside the mesh.";
  if (selection.kind == Selection::Kind::vertex && irregular_.count(selection.a) != 0)
    offered_.hint =
        "A second irregular vertex makes a pair, which can move. A single one can only move by making others (Theorem "
        "7.1).";
  const bool any = std::any_of(offered_.list.begin(), offered_.list.end(), [](const Offer& o) { return o.is_legal(); });
  if (selection.kind != Selection::Kind::pair || refusal != Refusal::none || any) return;
  for (const VertexId v : nearest_irregular(selection.a, 2)) {
    if (v != selection.b && !offered_.third.valid()) offered_.third = v;
  }
  offered_.hint = offered_.third.valid() ? "A third irregular vertex can help, " + name_of(offered_.third) +
                                               " is the nearest: move one of the two with it first, and come back."
                                         : "There is no third irregular vertex, which could help.";
}

const Offers& Session::quick_offers(const Selection& selection) {
  if (offered_to_ == selection) return offered_;
  offered_ = {};
  offered_edits_.clear();
  const Refusal refusal = offer_quick(selection);
  offered_to_ = selection;
  offered_.why = words(refusal);
  if (!offered_.more) advise(selection, refusal);
  return offered_;
}

const Offers& Session::offers(const Selection& selection) {
  quick_offers(selection);
  if (std::exchange(offered_.more, false)) {
    offer_complementary(selection);
    advise(selection, Refusal::none);
  }
  return offered_;
}

// What makes an offer. Precondition: it is legal.
std::vector<Edit> Session::edits_of(std::size_t offer) {
  if (offered_.list[offer].name != kCancel) return offered_edits_[offer];
  const std::size_t mark = editor_.mark();
  cancel(*offered_to_, offered_.list[offer].helpers, [this](std::size_t made) { shape_.fit_transport(made); });
  const auto edits = std::span(editor_.edits()).subspan(mark);
  const std::vector<Edit> result(edits.begin(), edits.end());
  editor_.roll_back(mark);
  return result;
}

std::string Session::words_for(const Selection& s, const std::string& name) const {
  switch (s.kind) {
    case Selection::Kind::pair: return name + ", " + name_of(s.a) + " and " + name_of(s.b);
    case Selection::Kind::edge: return name + ", edge " + name_of(s.a) + " to " + name_of(s.b);
    default: return name;
  }
}

std::string Session::perform(const Selection& selection, const std::string& name, const Watch& watch) {
  const std::vector<Offer>& list = offered_.list;
  const auto called = [&] {
    return std::find_if(list.begin(), list.end(), [&name](const Offer& o) { return o.name == name; });
  };
  quick_offers(selection);
  if (called() == list.end()) offers(selection);
  const auto offer = called();
  if (offer == list.end())
    return list.empty() && !offered_.why.empty() ? offered_.why : "this is not among the edits of the selection";
  if (!offer->is_legal()) return offer->why;
  std::string done = words_for(selection, name);
  if (offer->feature) {
    mesh::FeatureSet edges;
    for (const auto& [a, b] : features()) {
      if (*offer->feature || std::set{a, b} != std::set{selection.a, selection.b}) edges.insert(a, b);
    }
    if (*offer->feature) edges.insert(selection.a, selection.b);
    return change_features(std::move(edges), std::move(done));
  }
  Step step{std::move(done), editor_.mark(), 0};
  for (const Edit& edit : edits_of(static_cast<std::size_t>(offer - list.begin()))) {
    editor_.redo(edit);
    if (watch && edit.operates) watch(touched_by({"", editor_.mark() - 1, editor_.mark()}).quads);
  }
  shape_.fit_since(step.begin);
  reduction_.reset();
  finish_step(std::move(step));
  return "";
}

}  // namespace requad::web
