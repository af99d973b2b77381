#include "mesh/web/session.hpp"

#include <algorithm>

#include <Eigen/Geometry>

#include "mesh/editing/carried_attributes.hpp"
#include "mesh/editing/script.hpp"
#include "mesh/files/feature_edges.hpp"
#include "mesh/files/read_polygons.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/geometry/diagnosis.hpp"
#include "mesh/irregular/pair_frame.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/web/id_lists.hpp"

namespace requad::web {

using mesh::Edit;
using mesh::HalfEdgeId;
using mesh::QuadMesh;

// --- the mesh --------------------------------------------------------------------------------------------------------

mesh::Surface Session::read(std::string_view text, const std::string& name, bool subdivided) {
  return mesh::to_surface(mesh::parse_polygon_mesh(text, name), subdivided);
}

Session::Session(mesh::Surface input)
    : input_(std::move(input)),
      mesh_(input_.mesh),
      positions_(input_.positions),
      editor_(mesh_, &features_, &positions_, &plan_),
      shape_(editor_) {
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

// --- steps -----------------------------------------------------------------------------------------------------------

Session::Touched Session::touched_by(const Step& step) const {
  Touched touched;
  for (std::size_t i = step.begin; i < step.end; ++i) {
    const Edit& edit = editor_.edits()[i];
    for (const VertexId v : edit.changed) {
      if (v.valid()) touched.vertices.push_back(v);
    }
    for (const mesh::Placement& p : edit.placements) touched.vertices.push_back(p.vertex);
    for (const FaceId f : {edit.made_face(), edit.removed_face()}) {
      if (f.valid()) touched.quads.push_back(f);
    }
  }
  sort_once(touched.vertices);
  return touched;
}

void Session::note_changes(const Touched& touched) {
  const auto& [vertices, quads] = touched;
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
  const Touched touched = touched_by(step);
  const auto first = editor_.edits().begin() + static_cast<std::ptrdiff_t>(step.begin);
  undone_edits_.emplace_back(first, editor_.edits().end());
  editor_.roll_back(step.begin);
  undone_steps_.push_back(step);
  steps_.pop_back();
  note_changes(touched);
  return true;
}

bool Session::redo() {
  if (undone_steps_.empty()) return false;
  const Step step = undone_steps_.back();
  for (const Edit& edit : undone_edits_.back()) editor_.redo(edit);
  undone_steps_.pop_back();
  undone_edits_.pop_back();
  steps_.push_back(step);
  note_changes(touched_by(step));
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
