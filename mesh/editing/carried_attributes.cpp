#include "mesh/editing/carried_attributes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "mesh/editing/element_map.hpp"
#include "mesh/files/feature_edges.hpp"
#include "mesh/geometry/nearest_points.hpp"
#include "mesh/text/number_text.hpp"

namespace requad::mesh {

namespace {

using Eigen::Vector3d;

constexpr double kHard = std::numbers::pi / 4;  // an edge with a larger angle separates normals

std::string words_of(const Vector3d& v, int count) {
  std::string text;
  for (int k = 0; k < count; ++k) {
    if (k > 0) text += ' ';
    append_number(text, v[k]);
  }
  return text;
}

class Carrier {
 public:
  Carrier(const Surface& before, const Editor& editor)
      : before_(before),
        was_(before.attributes),
        old_(before.mesh),
        new_(editor.mesh()),
        at_(*editor.positions()),
        map_(element_map(before.mesh, editor)),
        vertices_(new_.vertices()),
        faces_(new_.faces()) {
    ancestors(map_.vertices, vertices_, vertex_from_, vertex_is_old_);
    ancestors(map_.faces, faces_, face_from_, face_is_old_);
  }

  Attributes carry() {
    after_.libraries = was_.libraries;
    after_.keywords = was_.keywords;
    after_.states = was_.states;
    after_.not_kept = was_.not_kept;
    for (std::size_t f = 0; f < faces_.size() && !was_.state_of_face.empty(); ++f)
      after_.state_of_face.push_back(was_.state(static_cast<std::size_t>(face_from_[f])));
    for (std::size_t v = 0; v < vertices_.size() && !was_.vertex_words.empty(); ++v) {
      const auto from = static_cast<std::size_t>(before_.file_vertex[static_cast<std::size_t>(vertex_from_[v])]);
      after_.vertex_words.push_back(from < was_.vertex_words.size() ? was_.vertex_words[from] : "");
    }
    find_unchanged();
    after_.uvs = {was_.uvs.words, was_.uvs.numbers, {}};
    after_.normals = {was_.normals.words, was_.normals.numbers, {}};
    if (!was_.uvs.at_corner.empty()) carry_uvs();
    if (!was_.normals.at_corner.empty()) carry_normals();
    carry_elements();
    return std::move(after_);
  }

 private:
  template <class Id>
  static void ancestors(const FileIndexMap& map, const std::vector<Id>& live, std::vector<int>& from,
                        std::vector<bool>& is_old) {
    from.assign(live.size(), -1);
    is_old.assign(live.size(), true);
    for (std::size_t i = 0; i < live.size(); ++i) from[i] = live[i].index();
    for (std::size_t i = 0; i < map.made.size(); ++i) {
      from[static_cast<std::size_t>(map.made[i])] = map.made_from[i];
      is_old[static_cast<std::size_t>(map.made[i])] = false;
    }
  }

  // By ids of the mesh after: whether a vertex stands where it stood, and whether a corner (a half-edge) is unchanged.
  void find_unchanged() {
    stands_.assign(static_cast<std::size_t>(new_.vertex_capacity()), false);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const VertexId v = vertices_[i];
      stands_[v.slot()] = vertex_is_old_[i] && same_bits(at_[v.slot()], before_.positions[v.slot()]);
    }
    corner_unchanged_.assign(static_cast<std::size_t>(new_.half_edge_capacity()), false);
    face_unchanged_.assign(static_cast<std::size_t>(new_.face_capacity()), false);
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      bool all = face_is_old_[i];
      for (int k = 0; k < 4; ++k) {
        const HalfEdgeId h = QuadMesh::half_edge(faces_[i], k);
        const bool same = face_is_old_[i] && stands_[new_.origin(h).slot()] && old_.origin(h) == new_.origin(h);
        corner_unchanged_[h.slot()] = same;
        all = all && same;
      }
      face_unchanged_[faces_[i].slot()] = all;
    }
  }

  // --- texture coordinates ---

  void carry_uvs() {
    const FeatureEdges seams = texture_seams(before_);
    const bool by_faces = has_texture_by_faces(before_, seams);
    for (const auto& [a, b] : seams) {
      seams_.insert(a, b);
      const bool kept = new_.is_live(a) && new_.is_live(b) && new_.adjacent(a, b);
      seams_kept_ = seams_kept_ && kept;
    }
    std::vector<int> of_vertex(static_cast<std::size_t>(new_.vertex_capacity()), -2);  // -2: not computed yet
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      for (int k = 0; k < 4; ++k) {
        const HalfEdgeId h = QuadMesh::half_edge(faces_[i], k);
        int& known = of_vertex[new_.origin(h).slot()];
        const std::size_t ancestor = static_cast<std::size_t>(4 * face_from_[i] + k);
        after_.uvs.at_corner.push_back(corner_unchanged_[h.slot()] || by_faces ? was_.uvs.at(ancestor) : uv(h, known));
      }
    }
  }

  // For a corner that is not unchanged. `known` is the value of its vertex, which all its other corners share; or -2.
  int uv(HalfEdgeId h, int& known) {
    const VertexId v = new_.origin(h);
    const Vector3d& p = at_[v.slot()];
    if (stands_[v.slot()] && seams_kept_) {
      const HalfEdgeId first = start_of_sector(h);
      const HalfEdgeId same = old_.find_half_edge(v, new_.target(first));
      // Without any seam or boundary at v, all corners at v were alike.
      return was_.uvs.at((same.valid() ? same : old_.out(v)).slot());
    }
    if (seams_.empty() || (seams_kept_ && !seams_.is_vertex(v))) {
      if (known == -2) {
        const SurfaceIndex::Nearest nearest = surface().nearest(p);
        known = add_uv(nearest.face, nearest.point);
      }
      return known;
    }
    const Vector3d inside = p + 0.25 * (face_centre(new_, at_, QuadMesh::face(h)) - p);
    return add_uv(surface().nearest(inside).face, p);
  }

  HalfEdgeId start_of_sector(HalfEdgeId h) const {
    HalfEdgeId g = h;
    while (!seams_.is_edge(new_.origin(g), new_.target(g))) {
      const HalfEdgeId next = new_.cw(g);
      if (!next.valid() || next == h) break;
      g = next;
    }
    return g;
  }

  // The texture coordinates of a face before at a point on it or near it; -1 if it has none.
  int add_uv(FaceId f, const Vector3d& p) {
    std::array<int, 4> index;
    for (std::size_t k = 0; k < 4; ++k) {
      index[k] = was_.uvs.at(QuadMesh::half_edge(f, static_cast<int>(k)).slot());
      if (index[k] < 0) return -1;
    }
    const std::array<Triangle, 2> halves = triangles(old_, before_.positions, f);
    const bool second =
        (nearest_on_triangle(halves[1], p) - p).squaredNorm() < (nearest_on_triangle(halves[0], p) - p).squaredNorm();
    const Triangle& t = halves[second ? 1 : 0];
    const std::size_t first = same_bits(halves[0][0], before_.positions[old_.corners(f)[0].slot()]) ? 0 : 1;
    const std::array<std::size_t, 3> corners{first, (first + (second ? 2 : 1)) % 4, (first + (second ? 3 : 2)) % 4};
    const Vector3d q = nearest_on_triangle(t, p);
    const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double all = normal.squaredNorm();
    Vector3d value = Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const double part = normal.dot((t[(k + 1) % 3] - q).cross(t[(k + 2) % 3] - q));
      value += (all > 0 ? part / all : 1.0 / 3) * was_.uvs.numbers[static_cast<std::size_t>(index[corners[k]])];
    }
    const std::string& like = was_.uvs.words[static_cast<std::size_t>(index[0])];
    const auto blanks = static_cast<int>(std::count(like.begin(), like.end(), ' '));
    return after_.uvs.add(words_of(value, std::clamp(blanks + 1, 1, 3)), value);
  }

  const SurfaceIndex& surface() {
    if (!surface_) surface_.emplace(old_, before_.positions);
    return *surface_;
  }

  // --- normals ---

  void carry_normals() {
    for (const FaceId f : faces_) {
      for (int k = 0; k < 4; ++k) {
        const HalfEdgeId h = QuadMesh::half_edge(f, k);
        bool same = corner_unchanged_[h.slot()];
        new_.for_each_out(new_.origin(h),
                          [&](HalfEdgeId g) { same = same && face_unchanged_[QuadMesh::face(g).slot()]; });
        const int was = face_is_old(f) ? was_.normals.at(h.slot()) : -1;
        if (same) {
          after_.normals.at_corner.push_back(was);
          continue;
        }
        const Vector3d n = normal(h);
        after_.normals.at_corner.push_back(after_.normals.add(words_of(n, 3), n));
      }
    }
  }

  bool face_is_old(FaceId f) const { return map_.faces.now.size() > f.slot() && map_.faces.now[f.slot()] >= 0; }

  bool is_flat(FaceId f) const {
    const auto at = std::lower_bound(faces_.begin(), faces_.end(), f);
    const int state = after_.state(static_cast<std::size_t>(at - faces_.begin()));
    if (state < 0) return false;
    const Attributes::State& lines = was_.states[static_cast<std::size_t>(state)];
    return std::any_of(lines.begin(), lines.end(),
                       [](const std::string& line) { return line == "s off" || line == "s 0"; });
  }

  Vector3d normal(HalfEdgeId h) const {
    const FaceId f = QuadMesh::face(h);
    Vector3d sum = area_vector(new_, at_, f);
    if (!is_flat(f)) {
      const auto hard = [this](HalfEdgeId g) { return std::abs(dihedral_angle(new_, at_, g)) > kHard; };
      HalfEdgeId g = h;
      bool round = false;
      for (HalfEdgeId next = new_.ccw(g); next.valid() && !round && !hard(next); next = new_.ccw(g)) {
        round = next == h;
        if (!round) sum += area_vector(new_, at_, QuadMesh::face(next));
        g = next;
      }
      g = h;
      for (HalfEdgeId next = new_.cw(g); !round && next.valid() && next != h && !hard(g); next = new_.cw(g)) {
        sum += area_vector(new_, at_, QuadMesh::face(next));
        g = next;
      }
    }
    return unit_or_zero(sum);
  }

  // --- elements ---

  void carry_elements() {
    for (const Attributes::Element& element : was_.elements) {
      Attributes::Element now = element;
      bool kept = true;
      std::vector<VertexId> named;
      for (Attributes::Element::Word& word : now.words) {
        if (word.vertex < 0) continue;
        const int slot = before_.from_file[static_cast<std::size_t>(word.vertex)];
        const int index = slot < 0 ? -1 : map_.vertices.now[static_cast<std::size_t>(slot)];
        kept = kept && index >= 0;
        word.vertex = std::max(index, 0);
        named.emplace_back(slot);
      }
      if (kept && element.keyword == "t" && named.size() == 2) kept = new_.adjacent(named[0], named[1]);
      if (kept) {
        after_.elements.push_back(std::move(now));
      } else {
        const std::string kind = element.keyword == "t" ? "'t " + element.words[0].text + "' tags" : "";
        ++after_.not_kept[kind.empty() ? "'" + element.keyword + "' lines" : kind];
      }
    }
  }

  const Surface& before_;
  const Attributes& was_;
  const QuadMesh &old_, &new_;
  const Positions& at_;
  ElementMap map_;
  std::vector<VertexId> vertices_;
  std::vector<FaceId> faces_;
  std::vector<int> vertex_from_, face_from_;       // by file index after: the id of the ancestor, or the own one
  std::vector<bool> vertex_is_old_, face_is_old_;  // by file index after
  std::vector<bool> stands_, corner_unchanged_, face_unchanged_;
  FeatureSet seams_;
  bool seams_kept_ = true;
  std::optional<SurfaceIndex> surface_;
  Attributes after_;
};

}  // namespace

Attributes carried_attributes(const Surface& before, const Editor& editor) {
  if (before.attributes.empty()) return {};
  return Carrier(before, editor).carry();
}

}  // namespace requad::mesh
