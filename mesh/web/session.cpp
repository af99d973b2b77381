#include "mesh/web/session.hpp"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

#include "mesh/editing/carried_attributes.hpp"
#include "mesh/editing/script.hpp"
#include "mesh/files/read_polygons.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/geometry/diagnosis.hpp"
#include "mesh/irregular/pair_frame.hpp"
#include "mesh/topology/separatrix.hpp"

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
      editor_(mesh_, &features_.edges, &positions_, &features_.plan),
      shape_(editor_) {
  const mesh::FeatureEdges seams = mesh::texture_seams(input_);
  if (!mesh::has_texture_by_faces(input_, seams)) {
    for (const auto& [a, b] : seams) features_.edges.insert(a, b);
  }
  features_.plan = mesh::plan_by_angles(mesh_, features_.edges, positions_);
  const mesh::Diagnosis diagnosis = mesh::diagnose(mesh_, positions_);
  boundary_loops_ = diagnosis.boundary_loops;
  genus_ = diagnosis.genus;
  for (const VertexId v : mesh::irregular_vertices(mesh_)) irregular_.insert(v);
  for (const FaceId f : mesh_.faces()) {
    if (is_inverted(f)) inverted_.insert(f);
  }
  changes_.everything = changes_.features = true;
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
  d.inverted = static_cast<int>(inverted_.size());
  d.features = static_cast<int>(features_.edges.size());
  return d;
}

bool Session::is_inverted(FaceId f) const { return mesh::is_inverted(mesh_, positions_, f); }

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

std::vector<std::vector<VertexId>> Session::boundary() const {
  std::vector<std::vector<VertexId>> loops;
  std::vector<bool> met(static_cast<std::size_t>(mesh_.vertex_capacity()), false);
  for (const VertexId start : mesh_.vertices()) {
    if (!mesh_.is_boundary(start) || met[start.slot()]) continue;
    std::vector<VertexId>& loop = loops.emplace_back();
    for (HalfEdgeId h = mesh_.out(start); !met[mesh_.origin(h).slot()]; h = mesh_.next_on_boundary(h)) {
      met[mesh_.origin(h).slot()] = true;
      loop.push_back(mesh_.origin(h));
    }
    loop.push_back(start);
  }
  return loops;
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

Selection Session::pointed_at(FaceId quad, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                              bool corner) const {
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
  double best = corner ? std::numeric_limits<double>::infinity() : kCorner * shortest;
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

// --- results ---------------------------------------------------------------------------------------------------------

std::string Session::script() const {
  return mesh::to_string(mesh::record_script(input_.mesh, input_.positions, editor_));
}

std::string Session::export_obj() const {
  return mesh::obj_text(mesh_, positions_, mesh::carried_attributes(input_, editor_));
}

}  // namespace requad::web
