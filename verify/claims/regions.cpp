// Claims about one region: Equation 1, Lemmas 7.9, 7.10 and 7.12-7.14.
#include <algorithm>
#include <array>
#include <set>

#include "enumerate/generators.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "verify/claims/judging.hpp"

namespace requad::verify {

using enumerate::FoundNode;
using mesh::Region;
using theory::Configuration;
using theory::PairType;

namespace {

constexpr int kLargestSurface =
    60;  // faces of a region that other surfaces are made of; larger ones repeat the smaller

// A surface that is made of a region, with the Euler characteristic that it has by its making.
struct MadeSurface {
  mesh::QuadMesh mesh;
  int euler = 1;
};

// The faces of a mesh without these ones. Vertices keep their numbers.
std::vector<std::array<int, 4>> without(const mesh::QuadMesh& m, const std::vector<std::size_t>& holes) {
  std::vector<std::array<int, 4>> faces = m.compact_faces();
  for (auto it = holes.rbegin(); it != holes.rend(); ++it)
    faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(*it));
  return faces;
}

// Two copies of a mesh, the second one mirrored, joined by a strip of quads along each boundary: a closed surface.
mesh::QuadMesh doubled(const mesh::QuadMesh& m) {
  const int n = m.vertex_count();
  std::vector<std::array<int, 4>> faces = m.compact_faces();
  const std::size_t copied = faces.size();
  for (std::size_t f = 0; f < copied; ++f) {
    const auto [a, b, c, d] = faces[f];
    faces.push_back({d + n, c + n, b + n, a + n});
  }
  for (const mesh::HalfEdgeId h : m.half_edges()) {
    if (!m.is_boundary(h)) continue;
    const int a = m.origin(h).index(), b = m.target(h).index();
    faces.push_back({b, a, a + n, b + n});
  }
  return mesh::QuadMesh::from_faces(2 * n, faces);
}

// Disks with up to two holes, and their doubles: an annulus, a sphere, a torus, a surface of genus two. A hole is a face
// whose corners lie inside; two holes have no corner in common.
std::vector<MadeSurface> surfaces_from(const Region& region) {
  const mesh::QuadMesh disk = mesh::QuadMesh::from_faces(region.mesh.vertex_count(), region.mesh.compact_faces());
  std::vector<std::size_t> holes;
  std::set<mesh::VertexId> used;
  for (const mesh::FaceId f : disk.faces()) {
    const auto corners = disk.corners(f);
    const bool free = std::none_of(corners.begin(), corners.end(),
                                   [&](mesh::VertexId v) { return disk.is_boundary(v) || used.count(v) > 0; });
    if (!free || holes.size() == 2) continue;
    holes.push_back(static_cast<std::size_t>(f.index()));
    used.insert(corners.begin(), corners.end());
  }
  std::vector<MadeSurface> surfaces;
  for (std::size_t number = 0; number <= holes.size(); ++number) {
    const std::vector<std::size_t> made(holes.begin(), holes.begin() + static_cast<std::ptrdiff_t>(number));
    const int euler = 1 - static_cast<int>(number);
    mesh::QuadMesh open = mesh::QuadMesh::from_faces(disk.vertex_count(), without(disk, made));
    surfaces.push_back({doubled(open), 2 * euler});
    surfaces.push_back({std::move(open), euler});
  }
  return surfaces;
}

// The turns and indices of the region itself, which is a disk, and of the surfaces made of it.
std::string check_gauss_bonnet(const FoundNode& node) {
  const auto check = [](const mesh::QuadMesh& m, int euler) -> std::string {
    const int left = mesh::total_turn(m) + mesh::total_index(m);
    const std::string surface = "on a surface of Euler characteristic " + std::to_string(euler);
    if (left != 4 * euler)
      return surface + " turns and indices sum to " + std::to_string(left) + ", not " + std::to_string(4 * euler);
    return mesh::euler_characteristic(m) == euler ? "" : surface + " vertices, edges and faces give another one";
  };
  std::string problem = check(node.region.mesh, 1);
  if (!problem.empty() || node.region.mesh.face_count() > kLargestSurface) return problem;
  for (const MadeSurface& surface : surfaces_from(node.region)) {
    problem = check(surface.mesh, surface.euler);
    if (!problem.empty()) return problem;
  }
  return "";
}

std::string check_lemma_9(const FoundNode& node) {
  const int corners = static_cast<int>(mesh::side_lengths(node.region).size());
  const int expected = 4 - mesh::total_index(node.region.mesh);
  return corners == expected ? "" : std::to_string(corners) + " sides, not 4 - G = " + std::to_string(expected);
}

// Grows a region by strips. After each strip the sides obey theory-1. Once every side has a strip the region is convex.
// In the end it is isomorphic to the glued region, which moves found as well.
std::string check_growth(PairType type, const FoundNode& node) {
  const Configuration& c = node.reading.configuration;
  const theory::PairSystem system(type);
  enumerate::StripGrowth growth(type, c.d1(), c.d2());
  theory::StripParameters partial{c.d1(), c.d2(), theory::IntegerVector::Zero(type.side_count())};
  while (partial.e != c.parameters.e) {
    for (int label = 1; label <= type.side_count(); ++label) {
      if (partial.e(label - 1) == c.parameters.e(label - 1)) continue;
      growth.add_strip(label);
      ++partial.e(label - 1);
      const theory::IntegerVector expected = system.side_lengths(partial);
      const std::vector<int> sides = growth.side_lengths();
      if (!std::equal(sides.begin(), sides.end(), expected.begin(), expected.end()))
        return "a strip gave other sides than theory-1";
    }
    if (growth.complete()) {
      const Region stage = growth.region(1);
      if (const std::string problem = mesh::region_problem(stage); !problem.empty()) return "while growing: " + problem;
    }
  }
  if (mesh::signature(enumerate::grow_region(type, c)) != node.signature) return "grown by strips it is another mesh";
  if (mesh::signature(enumerate::glue_region(type, c)) != node.signature)
    return "glued from rectangles it is another mesh";
  return "";
}

}  // namespace

Judgement judge_gauss_bonnet(const PairStudy& s) {
  return for_each_node(s, "turns and indices sum to 4 chi, on disks and on surfaces made of them", check_gauss_bonnet);
}

Judgement judge_lemma_9(const PairStudy& s) {
  const int sides = s.shape.type().side_count();
  return for_each_node(s, std::to_string(sides) + " sides, as G = " + std::to_string(4 - sides), check_lemma_9);
}

Judgement judge_growth(const PairStudy& s) {
  return for_each_node(s, "grown by strips it is the same mesh",
                       [&s](const FoundNode& node) { return check_growth(s.shape.type(), node); });
}

}  // namespace requad::verify
