#include "mesh/web/session.hpp"

#include <algorithm>
#include <cstdlib>

#include <Eigen/Geometry>

#include "mesh/editing/affected_region.hpp"
#include "mesh/editing/carried_attributes.hpp"
#include "mesh/editing/script.hpp"
#include "mesh/files/feature_edges.hpp"
#include "mesh/files/read_polygons.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/geometry/diagnosis.hpp"
#include "mesh/irregular/atomic_operations.hpp"
#include "mesh/irregular/complementary_operations.hpp"
#include "mesh/irregular/possible_moves.hpp"
#include "mesh/topology/separatrix.hpp"

namespace requad::web {

using mesh::BasicOperation;
using mesh::Edit;
using mesh::EditRefusal;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Refusal;

namespace {

template <class Id>
void sort_once(std::vector<Id>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

// A refusal in words; "" if there is none.
std::string words(Refusal refusal, const mesh::Obstacles& obstacles = {}) {
  if (refusal == Refusal::none) return "";
  const std::string met = refusal == EditRefusal::no_path ? to_string(obstacles) : "";
  return std::string(refusal.clause()) + (met.empty() ? "" : "; in the way: " + met);
}

// The faces at the vertices.
std::vector<FaceId> faces_round(const QuadMesh& m, const std::vector<VertexId>& vertices) {
  std::vector<FaceId> faces;
  for (const VertexId v : vertices) {
    if (m.is_live(v)) m.for_each_out(v, [&](HalfEdgeId h) { faces.push_back(QuadMesh::face(h)); });
  }
  sort_once(faces);
  return faces;
}

}  // namespace

// --- the mesh --------------------------------------------------------------------------------------------------------

mesh::Surface Session::read(std::string_view text, const std::string& name, bool subdivided) {
  return mesh::to_surface(mesh::parse_polygon_mesh(text, name), subdivided);
}

Session::Session(mesh::Surface input)
    : input_(std::move(input)),
      mesh_(input_.mesh),
      positions_(input_.positions),
      editor_(mesh_, &features_, &positions_, &plan_),
      surface_(input_.mesh, input_.positions) {
  editor_.restore_fans(true);
  const mesh::FeatureEdges seams = mesh::texture_seams(input_);
  if (!mesh::has_texture_by_faces(input_, seams)) {
    for (const auto& [a, b] : seams) features_.insert(a, b);
  }
  plan_ = mesh::plan_by_angles(mesh_, features_, positions_);
  const mesh::Diagnosis diagnosis = mesh::diagnose(mesh_, positions_);
  boundary_loops_ = diagnosis.boundary_loops;
  genus_ = diagnosis.genus;
  for (const VertexId v : mesh::irregular_vertices(mesh_)) irregular_.insert(v);
  changes_.everything = true;
}

Description Session::describe() const {
  Description d;
  d.vertices = mesh_.vertex_count();
  d.quads = mesh_.face_count();
  d.boundary_loops = boundary_loops_;
  d.genus = genus_;
  for (const VertexId v : irregular_) {
    const int valence = mesh_.valence(v);
    ++d.irregular[valence];
    d.index_sum += 4 - valence;
  }
  return d;
}

int Session::number(VertexId v) const {
  if (numbers_.empty()) {
    numbers_.assign(static_cast<std::size_t>(mesh_.vertex_capacity()), 0);
    int number = 0;
    for (const VertexId w : mesh_.vertices()) numbers_[w.slot()] = ++number;
  }
  return numbers_[v.slot()];
}

VertexId Session::numbered(int number) const {
  if (number < 1 || number > mesh_.vertex_count()) return {};
  return mesh_.vertices()[static_cast<std::size_t>(number) - 1];
}

std::string Session::name_of(VertexId v) const {
  return std::to_string(number(v)) + " (v" + std::to_string(mesh_.valence(v)) + ")";
}

std::vector<VertexId> Session::nearest_irregular(VertexId v, int most) {
  std::vector<VertexId> found;
  const auto always = [](VertexId) { return true; };
  distances_.measure(mesh_, std::array{v}, always, always, [&](VertexId w, int) {
    if (w != v && irregular_.count(w) != 0) found.push_back(w);
    return static_cast<int>(found.size()) >= most;
  });
  return found;
}

std::vector<std::vector<VertexId>> Session::separatrices(VertexId v) const {
  std::vector<std::vector<VertexId>> paths;
  mesh_.for_each_out(v, [&](HalfEdgeId h) {
    std::vector<VertexId>& path = paths.emplace_back();
    path.push_back(v);
    for (const HalfEdgeId g : mesh::trace(mesh_, h).path) path.push_back(mesh_.target(g));
  });
  return paths;
}

Session::Rectangle Session::rectangle(VertexId a, VertexId b) const {
  Rectangle result;
  if (a == b || irregular_.count(a) == 0 || irregular_.count(b) == 0) return result;
  const std::vector<mesh::PairFrame> frames = mesh::find_frames(mesh_, a, b);
  if (frames.empty()) return result;
  result.quads = mesh::grid(mesh_, frames.front()).value_or(std::vector<FaceId>{});
  for (const HalfEdgeId h : mesh::rim(mesh_, frames.front())) result.rim.push_back(mesh_.origin(h));
  if (!result.rim.empty()) result.rim.push_back(result.rim.front());
  return result;
}

Selection Session::pointed_at(FaceId quad, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
  constexpr double kCorner = 0.3;  // of the quad's shortest edge: nearer to a corner or an edge than that means it
  constexpr double kEdge = 0.15;
  // Where the ray meets the quad, or its plane.
  Eigen::Vector3d hit = mesh::face_centre(mesh_, positions_, quad);
  double nearest = -1;
  for (const mesh::Triangle& t : mesh::triangles(mesh_, positions_, quad)) {
    const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double slope = normal.dot(direction);
    if (slope == 0) continue;
    const Eigen::Vector3d p = origin + normal.dot(t[0] - origin) / slope * direction;
    const double off = (mesh::nearest_on_triangle(t, p) - p).norm();
    if (nearest >= 0 && off >= nearest) continue;
    nearest = off;
    hit = mesh::nearest_on_triangle(t, p);
  }
  double shortest = -1;
  for (int k = 0; k < 4; ++k) {
    const double length = mesh::edge_length(mesh_, positions_, QuadMesh::half_edge(quad, k));
    if (shortest < 0 || length < shortest) shortest = length;
  }
  Selection selection{Selection::Kind::quad, {}, {}, quad};
  double best = kCorner * shortest;
  for (const VertexId v : mesh_.corners(quad)) {
    const double distance = (positions_[v.slot()] - hit).norm();
    if (distance > best) continue;
    best = distance;
    selection = {Selection::Kind::vertex, v, {}, {}};
  }
  if (selection.kind == Selection::Kind::vertex) return selection;
  best = kEdge * shortest;
  for (int k = 0; k < 4; ++k) {
    const HalfEdgeId h = QuadMesh::half_edge(quad, k);
    const VertexId a = mesh_.origin(h), b = mesh_.target(h);
    const Eigen::Vector3d p = positions_[a.slot()];
    const Eigen::Vector3d along = positions_[b.slot()] - p;
    const double length = along.squaredNorm();
    const double t = length > 0 ? std::clamp((hit - p).dot(along) / length, 0.0, 1.0) : 0;
    const double distance = (p + t * along - hit).norm();
    if (distance > best) continue;
    best = distance;
    selection = {Selection::Kind::edge, a, b, {}};
  }
  return selection;
}

bool Session::is_live(const Selection& s) const {
  switch (s.kind) {
    case Selection::Kind::vertex: return mesh_.is_live(s.a);
    case Selection::Kind::pair: return mesh_.is_live(s.a) && mesh_.is_live(s.b) && s.a != s.b;
    case Selection::Kind::edge: return mesh_.is_live(s.a) && mesh_.is_live(s.b) && mesh_.adjacent(s.a, s.b);
    case Selection::Kind::quad: return mesh_.is_live(s.quad);
  }
  return false;
}

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
  sort_once(outcome.vertices);
  for (const VertexId v : outcome.vertices) outcome.valences.push_back(mesh_.is_live(v) ? mesh_.valence(v) : 0);
  for (const FaceId f : faces_round(mesh_, outcome.vertices)) outcome.quads.emplace(f, mesh_.corners(f));
  return outcome;
}

// Lists what the outcome differs in from the present mesh.
void Session::compare(const Outcome& outcome, Offer& offer) const {
  for (std::size_t i = 0; i < outcome.vertices.size(); ++i) {
    const VertexId v = outcome.vertices[i];
    if (mesh_.is_live(v) && mesh_.valence(v) != outcome.valences[i]) offer.vertices.push_back(v);
  }
  for (const FaceId f : faces_round(mesh_, outcome.vertices)) {
    const auto after = outcome.quads.find(f);
    if (after == outcome.quads.end() || after->second != mesh_.corners(f)) offer.quads.push_back(f);
  }
}

void Session::add_offer(std::size_t mark, Offer offer) {
  const std::vector<Edit>& edits = editor_.edits();
  const auto first = edits.begin() + static_cast<std::ptrdiff_t>(mark);
  for (auto edit = first; edit != edits.end(); ++edit) {
    offer.operations += edit->operates ? 1 : 0;
    offer.quads_made += edit->made_face().valid() ? 1 : 0;
    offer.quads_deleted += edit->removed_face().valid() ? 1 : 0;
  }
  const Outcome outcome = outcome_since(mark);
  offered_edits_.emplace_back(first, edits.end());
  editor_.roll_back(mark);
  compare(outcome, offer);
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
    offer.effect = move.effect;
    offer.after = move.after;
    for (std::size_t i = 0; i < 2 && offer.is_legal(); ++i) {
      const VertexId v = move.after[i];
      offer.arrows.push_back({before[i], v.valid() ? positions_[v.slot()] : before[i]});
    }
    add_offer(mark, std::move(offer));
    return false;
  });
}

// Merging and aligning of two of a kind, and cancelling of two of opposite kinds.
void Session::offer_complementary(VertexId a, VertexId b) {
  if (editor_.is_fixed(a) || editor_.is_fixed(b)) return;
  const std::size_t mark = editor_.mark();
  const int sign_a = mesh_.valence(a) - 4, sign_b = mesh_.valence(b) - 4;
  if (sign_a * sign_b < 0) {
    const auto [three, five] = sign_a < 0 ? std::pair(a, b) : std::pair(b, a);
    mesh::PairTransport transport(editor_);
    const auto helpers = mesh::usual_helpers(editor_, distances_, three, five);
    const mesh::Cancellation result = mesh::cancel_pair(editor_, transport, three, five, helpers);
    Offer offer;
    offer.name = "cancel";
    offer.why = words(result.refusal, result.obstacles);
    offer.effect = "both become regular; third vertices move by " + std::to_string(result.transports) +
                   (result.transports == 1 ? " edge" : " edges");
    add_offer(mark, std::move(offer));
    return;
  }
  for (const auto& [name, operation] : {std::pair("align", &mesh::align_pair), std::pair("merge", &mesh::merge_pair)}) {
    const mesh::PairResult result = operation(editor_, a, b);
    Offer offer;
    offer.name = name;
    offer.why = words(result.refusal);
    if (offer.is_legal() && result.moves == 0) offer.why = "a separatrix joins them already";
    if (offer.is_legal()) offer.after = {result.frame.v1, result.frame.v2};
    if (offer.is_legal())
      offer.effect = result.frame.merged() ? "both become one v" + std::to_string(mesh_.valence(result.frame.v1))
                                           : "a separatrix joins them: " + mesh::extents_text(result.frame);
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
    if (offer.is_legal()) {
      const mesh::AtomicReport report = mesh::perform(editor_, choice.operation);
      for (const mesh::ValenceChange& c : report.changes) {
        offer.effect += (offer.effect.empty() ? "" : ", ") +
                        (c.before > 0 ? std::to_string(number(c.vertex)) + ": v" + std::to_string(c.before) + " to "
                                      : std::string("new: ")) +
                        (c.after > 0 ? "v" + std::to_string(c.after) : "gone");
      }
    }
    add_offer(mark, std::move(offer));
  }
}

void Session::offer_basic(const BasicOperation& operation, const std::string& name) {
  const std::size_t mark = editor_.mark();
  Offer offer;
  offer.name = name;
  offer.why = words(editor_.run(operation).refusal);
  add_offer(mark, std::move(offer));
}

Refusal Session::offer_all(const Selection& selection) {
  using Kind = BasicOperation::Kind;
  if (!is_live(selection)) return Refusal::dead_element;
  switch (selection.kind) {
    case Selection::Kind::vertex:
      if (mesh_.is_boundary(selection.a)) return EditRefusal::touches_boundary;
      offer_atomic(selection);
      break;
    case Selection::Kind::pair: {
      const Refusal refusal = offer_moves(selection.a, selection.b);
      if (refusal != Refusal::none) return refusal;
      offer_complementary(selection.a, selection.b);
      break;
    }
    case Selection::Kind::edge: {
      HalfEdgeId h = mesh_.find_half_edge(selection.a, selection.b);
      if (!h.valid()) h = mesh_.find_half_edge(selection.b, selection.a);
      offer_basic({Kind::flip_ccw, h, {}, 0}, "flip counter-clockwise");
      offer_basic({Kind::flip_cw, h, {}, 0}, "flip clockwise");
      if (!mesh_.is_boundary(h)) offer_atomic(selection);
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

const Offers& Session::offers(const Selection& selection) {
  if (offered_to_ == selection) return offered_;
  offered_ = {};
  offered_edits_.clear();
  const Refusal refusal = offer_all(selection);
  offered_to_ = selection;
  offered_.why = words(refusal);
  if (refusal == EditRefusal::wrong_valences) offered_.hint = "Choose two irregular vertices, each a v3 or a v5.";
  if (refusal == EditRefusal::touches_boundary) offered_.hint = "Choose a vertex inside the mesh.";
  if (selection.kind == Selection::Kind::vertex && irregular_.count(selection.a) != 0)
    offered_.hint = "A second irregular vertex makes a pair, which can move. A single one cannot (Theorem 7.1).";
  const bool any = std::any_of(offered_.list.begin(), offered_.list.end(), [](const Offer& o) { return o.is_legal(); });
  if (selection.kind == Selection::Kind::pair && refusal == Refusal::none && !any)
    offered_.hint = "A third irregular vertex can help: move one of the two with it first, and come back.";
  return offered_;
}

std::string Session::words_for(const Selection& s, const std::string& name) const {
  switch (s.kind) {
    case Selection::Kind::pair: return name + ", " + name_of(s.a) + " and " + name_of(s.b);
    case Selection::Kind::edge: return name + ", edge " + name_of(s.a) + " to " + name_of(s.b);
    default: return name;
  }
}

std::string Session::perform(const Selection& selection, const std::string& name) {
  const Offers& all = offers(selection);
  const auto offer = std::find_if(all.list.begin(), all.list.end(), [&name](const Offer& o) { return o.name == name; });
  if (offer == all.list.end())
    return all.list.empty() && !all.why.empty() ? all.why : "this is not among the edits of the selection";
  if (!offer->is_legal()) return offer->why;
  const std::string done = words_for(selection, name);
  const std::size_t begin = editor_.mark();
  for (const Edit& edit : offered_edits_[static_cast<std::size_t>(offer - all.list.begin())]) editor_.redo(edit);
  mesh::smooth_since(editor_, distances_, begin, mesh::kUsualSmoothing, surface_);
  steps_.push_back({done, begin, editor_.mark()});
  undone_steps_.clear();
  undone_edits_.clear();
  std::vector<VertexId> vertices;
  std::vector<FaceId> quads;
  note_edits(begin, editor_.mark(), vertices, quads);
  note_changes(vertices, quads);
  return "";
}

// --- steps -----------------------------------------------------------------------------------------------------------

void Session::note_edits(std::size_t begin, std::size_t end, std::vector<VertexId>& vertices,
                         std::vector<FaceId>& quads) const {
  for (std::size_t i = begin; i < end; ++i) {
    const Edit& edit = editor_.edits()[i];
    for (const VertexId v : edit.changed) {
      if (v.valid()) vertices.push_back(v);
    }
    for (const mesh::Placement& p : edit.placements) vertices.push_back(p.vertex);
    for (const FaceId f : {edit.made_face(), edit.removed_face()}) {
      if (f.valid()) quads.push_back(f);
    }
  }
  sort_once(vertices);
}

void Session::note_changes(const std::vector<VertexId>& vertices, const std::vector<FaceId>& quads) {
  for (const VertexId v : vertices) {
    if (mesh_.is_live(v) && mesh::is_irregular(mesh_, v)) {
      irregular_.insert(v);
    } else {
      irregular_.erase(v);
    }
  }
  numbers_.clear();
  offered_to_.reset();
  if (changes_.everything) return;
  changes_.vertices.insert(changes_.vertices.end(), vertices.begin(), vertices.end());
  changes_.quads.insert(changes_.quads.end(), quads.begin(), quads.end());
  const std::vector<FaceId> round = faces_round(mesh_, vertices);
  changes_.quads.insert(changes_.quads.end(), round.begin(), round.end());
  sort_once(changes_.vertices);
  sort_once(changes_.quads);
}

bool Session::undo() {
  if (steps_.empty()) return false;
  const Step step = steps_.back();
  std::vector<VertexId> vertices;
  std::vector<FaceId> quads;
  note_edits(step.begin, step.end, vertices, quads);
  const auto first = editor_.edits().begin() + static_cast<std::ptrdiff_t>(step.begin);
  undone_edits_.emplace_back(first, editor_.edits().end());
  editor_.roll_back(step.begin);
  undone_steps_.push_back(step);
  steps_.pop_back();
  note_changes(vertices, quads);
  return true;
}

bool Session::redo() {
  if (undone_steps_.empty()) return false;
  const Step step = undone_steps_.back();
  for (const Edit& edit : undone_edits_.back()) editor_.redo(edit);
  undone_steps_.pop_back();
  undone_edits_.pop_back();
  steps_.push_back(step);
  std::vector<VertexId> vertices;
  std::vector<FaceId> quads;
  note_edits(step.begin, step.end, vertices, quads);
  note_changes(vertices, quads);
  return true;
}

std::vector<std::string> Session::lines(const Step& step) const {
  std::vector<std::string> lines;
  for (std::size_t i = step.begin; i < step.end; ++i) {
    const Edit& edit = editor_.edits()[i];
    if (edit.operates) lines.push_back(to_string(edit.operation));
  }
  return lines;
}

std::string Session::script() const {
  return mesh::to_string(mesh::record_script(input_.mesh, input_.positions, editor_));
}

std::string Session::export_obj() const {
  return mesh::obj_text(mesh_, positions_, mesh::carried_attributes(input_, editor_));
}

}  // namespace requad::web
