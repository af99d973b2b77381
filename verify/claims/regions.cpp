// Claims about one region: Equation 1, Lemmas 7.8-7.10 and 7.12-7.14, Theorem 7.11.
#include <algorithm>
#include <map>
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

std::string check_gauss_bonnet(const FoundNode& node) {
  const auto& m = node.region.mesh;
  const int left = mesh::total_turn(m) + mesh::total_index(m);
  const int right = 4 * mesh::euler_characteristic(m);
  return left == right ? "" : "turns and indices sum to " + std::to_string(left) + ", not " + std::to_string(right);
}

// The faces that touch R_alpha, as a region that is rooted at any of its corners.
Region ring_of(const Region& region, const mesh::PairFrame& frame) {
  const auto& m = region.mesh;
  std::map<mesh::VertexId, int> number;
  std::vector<std::array<int, 4>> corners;
  for (const mesh::FaceId f : mesh::ring(m, frame)) {
    std::array<int, 4> c{};
    for (std::size_t k = 0; k < 4; ++k)
      c[k] = number.emplace(m.corners(f)[k], static_cast<int>(number.size())).first->second;
    corners.push_back(c);
  }
  Region ring{mesh::QuadMesh::from_faces(static_cast<int>(number.size()), corners), {}};
  for (const mesh::VertexId v : ring.mesh.vertices()) {
    if (ring.mesh.is_boundary(v) && mesh::turn(ring.mesh, v) == 1) ring.root = ring.mesh.out(v);
  }
  return ring;
}

// Whether two cyclic sequences agree up to rotation.
template <class A, class B>
bool equal_up_to_rotation(const A& a, const B& b) {
  const std::size_t n = a.size();
  if (b.size() != n) return false;
  for (std::size_t shift = 0; shift < n; ++shift) {
    bool same = true;
    for (std::size_t i = 0; i < n && same; ++i) same = a[i] == b[(i + shift) % n];
    if (same) return true;
  }
  return false;
}

std::string check_lemma_8(PairType type, const FoundNode& node) {
  const Configuration& c = node.reading.configuration;
  if (c.merged()) return "";
  const std::size_t expected = c.degenerate() ? 2 : 1;
  if (node.reading.frames.size() != expected) {
    return std::to_string(node.reading.frames.size()) + " rectangles lie between the pair, not " +
           std::to_string(expected);
  }
  const mesh::PairFrame& frame = node.reading.frames[0].frame;
  const auto faces = mesh::grid(node.region.mesh, frame);
  if (!faces || faces->size() != static_cast<std::size_t>(frame.d1) * static_cast<std::size_t>(frame.d2)) {
    return "R_alpha is not a regular grid of its size";
  }
  const Region ring = ring_of(node.region, frame);
  if (const std::string problem = mesh::region_problem(ring); !problem.empty())
    return "the 1-ring of R_alpha: " + problem;
  Configuration smallest = c;
  smallest.parameters.e.setOnes();
  const theory::IntegerVector sides = theory::PairSystem(type).side_lengths(smallest.parameters);
  if (!equal_up_to_rotation(mesh::side_lengths(ring), std::vector<theory::Integer>(sides.begin(), sides.end()))) {
    return "the 1-ring of R_alpha has other sides than all e_i = 1 give";
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
  return for_each_node(s, "turns and indices sum to 4 chi", check_gauss_bonnet);
}

Judgement judge_lemma_8(const PairStudy& s) {
  return for_each_node(s, "R_alpha is a d1 x d2 grid, and its 1-ring is convex",
                       [&s](const FoundNode& node) { return check_lemma_8(s.shape.type(), node); });
}

Judgement judge_lemma_9(const PairStudy& s) {
  const int sides = s.shape.type().side_count();
  return for_each_node(s, std::to_string(sides) + " sides, as G = " + std::to_string(4 - sides), check_lemma_9);
}

Judgement judge_growth(const PairStudy& s) {
  return for_each_node(s, "grown by strips it is the same mesh",
                       [&s](const FoundNode& node) { return check_growth(s.shape.type(), node); });
}

// Distinct configurations have distinct separatrix vectors. Vectors are compared up to renaming: each stands for the
// least one over the frames and both orders of the vertices.
Judgement judge_theorem_11(const PairStudy& s) {
  std::map<std::vector<std::pair<int, int>>, std::size_t> seen;
  std::vector<std::size_t> pairs;
  for (std::size_t i = 0; i < s.found.nodes.size(); ++i) {
    if (s.found.holds_pair(static_cast<int>(i))) pairs.push_back(i);
  }
  const auto problem = [&](std::size_t i) -> std::string {
    const FoundNode& node = s.found.nodes[i];
    std::vector<std::pair<int, int>> least;
    for (const auto& labelled : node.reading.frames) {
      for (const auto& frame : mesh::both_ends(node.region.mesh, labelled.frame)) {
        std::vector<std::pair<int, int>> vector;
        for (const auto& at : enumerate::separatrix_vector(node.region, frame))
          vector.emplace_back(at.side, at.distance);
        if (least.empty() || vector < least) least = std::move(vector);
      }
    }
    const auto [other, is_new] = seen.emplace(std::move(least), i);
    if (is_new) return "";
    return "has the separatrix vector of " +
           theory::label(s.shape.type(), s.found.nodes[other->second].reading.configuration);
  };
  return for_each_of(pairs, "configuration", "a separatrix vector of its own", problem,
                     [&s](std::size_t i, std::string what) { return at_node(s, i, std::move(what)); });
}

}  // namespace requad::verify
