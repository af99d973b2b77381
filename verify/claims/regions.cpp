// Claims about one region: Equation 1, Lemmas 7.9, 7.10 and 7.12-7.14.
#include <algorithm>
#include <set>

#include "enumerate/generators.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "verify/claims/judging.hpp"
#include "verify/claims/surfaces.hpp"

namespace requad::verify {

using enumerate::FoundNode;
using mesh::Region;
using theory::Configuration;
using theory::PairType;

namespace {

constexpr int kLargestSurface =
    60;  // faces of a region that other surfaces are made of; larger ones repeat the smaller

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
