// Claims about convex regions inside a mesh: the smallest one (Lemma 7.8), the next larger ones (Lemma 7.10), and sharp
// convex turns (Definition 7.5). They are found by exhaustion (convex_subregions.hpp).
#include <algorithm>
#include <map>
#include <set>

#include "enumerate/generators.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "verify/claims/convex_subregions.hpp"
#include "verify/claims/judging.hpp"

namespace requad::verify {

using enumerate::FoundNode;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Region;
using mesh::VertexId;
using theory::Configuration;
using theory::PairType;

namespace {

constexpr int kLargestExhaustion = 20;  // faces

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

// A found region without gaps in its ids, as its signature gives it, and what it holds.
struct Compact {
  Region region;
  enumerate::Reading reading;
};
Compact compact(PairType type, const FoundNode& node) {
  Region region = mesh::from_signature(node.signature);
  enumerate::Reading reading = enumerate::read(region, type);
  return {std::move(region), std::move(reading)};
}

FaceSet set_of(const QuadMesh& m, const std::vector<mesh::FaceId>& faces) {
  FaceSet set(static_cast<std::size_t>(m.face_count()));
  for (const mesh::FaceId f : faces) set.set(static_cast<std::size_t>(f.index()));
  return set;
}

// By exhaustion: the 1-ring of R_alpha is a convex region with the pair inside, and part of each other one.
std::string check_smallest(PairType type, const FoundNode& node) {
  const Compact c = compact(type, node);
  const QuadMesh& m = c.region.mesh;
  if (c.reading.frames.empty()) return c.reading.problem;
  const FaceSet ring = set_of(m, mesh::ring(m, c.reading.frames[0].frame));
  bool is_one = false;
  for (const ConvexSubregion& around : convex_subregions(m, BoundaryIrregular::none)) {
    if (around.inside.size() != c.reading.irregular.size()) continue;
    is_one = is_one || around.faces == ring;
    if (!ring.is_subset_of(around.faces)) return "a convex region with the pair inside does not contain the 1-ring";
  }
  return is_one ? "" : "the 1-ring is none of the convex regions with the pair inside";
}

// Whether the faces of `larger` beyond `smaller` are one strip: one face at each edge of one side.
bool is_strip(const QuadMesh& m, const FaceSet& smaller, const FaceSet& larger) {
  const FaceSet strip = larger - smaller;
  const auto sides = sides_of(m, smaller);
  return std::any_of(sides.begin(), sides.end(), [&](const std::vector<HalfEdgeId>& side) {
    if (side.size() != strip.count()) return false;
    FaceSet along(strip.size());
    for (const HalfEdgeId h : side) {
      if (m.twin(h).valid()) along.set(static_cast<std::size_t>(QuadMesh::face(m.twin(h)).index()));
    }
    return along == strip;
  });
}

// By exhaustion: between a convex region and a larger one with the same irregular vertices lies a third one, unless they
// differ by one strip. So there is no smaller expansion, and the regions that hold the pair are as many as there are
// choices of 1 to e_i strips towards each side.
std::string check_expansions(PairType type, const FoundNode& node, std::int64_t& expansions) {
  const Compact c = compact(type, node);
  const QuadMesh& m = c.region.mesh;
  if (!c.reading.problem.empty()) return c.reading.problem;
  std::map<std::vector<VertexId>, std::vector<FaceSet>> by_inside;
  for (ConvexSubregion& region : convex_subregions(m, BoundaryIrregular::none))
    by_inside[region.inside].push_back(std::move(region.faces));
  for (auto& [inside, regions] : by_inside) {
    std::sort(regions.begin(), regions.end(), [](const FaceSet& a, const FaceSet& b) { return a.count() < b.count(); });
    for (std::size_t i = 0; i < regions.size(); ++i) {
      std::vector<const FaceSet*> next;  // the least larger ones
      for (std::size_t k = i + 1; k < regions.size(); ++k) {
        if (regions[k] == regions[i] || !regions[i].is_subset_of(regions[k])) continue;
        const FaceSet& larger = regions[k];
        const bool least = std::none_of(next.begin(), next.end(),
                                        [&larger](const FaceSet* between) { return between->is_subset_of(larger); });
        if (!least) continue;
        next.push_back(&regions[k]);
        ++expansions;
        if (!is_strip(m, regions[i], regions[k])) return "a convex region grows by something else than a strip";
      }
    }
  }
  if (c.reading.configuration.merged()) return "";
  std::size_t choices = 1;
  for (const theory::Integer e : c.reading.configuration.parameters.e) choices *= static_cast<std::size_t>(e);
  const std::size_t number = by_inside[c.reading.irregular].size();
  return number == choices
             ? ""
             : std::to_string(number) + " convex regions hold the pair, the strips give " + std::to_string(choices);
}

// R_alpha as a region: a v5 is a sharp convex turn point of it. Counted as two corners with a side of length zero
// between, its sides are those of the equations with all e_i = 0. By exhaustion: every convex region, irregular vertices
// on its boundary included, has 4 - G sides.
std::string check_sharp_turns(PairType type, const FoundNode& node) {
  const Compact c = compact(type, node);
  const QuadMesh& m = c.region.mesh;
  if (c.reading.frames.empty()) return c.reading.problem;
  const mesh::PairFrame& frame = c.reading.frames[0].frame;
  if (const auto grid = frame.degenerate() ? std::nullopt : mesh::grid(m, frame); grid) {
    std::vector<theory::Integer> lengths;
    for (const auto& side : sides_of(m, set_of(m, *grid))) lengths.push_back(static_cast<theory::Integer>(side.size()));
    const theory::IntegerVector expected =
        theory::PairSystem(type).side_lengths({frame.d1, frame.d2, theory::IntegerVector::Zero(type.side_count())});
    if (!equal_up_to_rotation(lengths, std::vector<theory::Integer>(expected.begin(), expected.end())))
      return "R_alpha has other sides than the equations give without strips";
  }
  if (m.face_count() > kLargestExhaustion) return "";
  for (const ConvexSubregion& region : convex_subregions(m, BoundaryIrregular::convex)) {
    int sides = 4;
    for (const auto* list : {&region.inside, &region.on_boundary}) {
      for (const VertexId v : *list) sides -= 4 - m.valence(v);
    }
    const std::size_t found = sides_of(m, region.faces).size();
    if (static_cast<int>(found) != sides)
      return "a convex region has " + std::to_string(found) + " sides, not 4 - G = " + std::to_string(sides);
  }
  return "";
}

}  // namespace

Judgement judge_lemma_8(const PairStudy& s) {
  return for_each_node(s, "R_alpha is a d1 x d2 grid, and its 1-ring the smallest convex region",
                       [&s](const FoundNode& node) -> std::string {
                         std::string problem = check_lemma_8(s.shape.type(), node);
                         const bool exhausted = node.region.mesh.face_count() <= kLargestExhaustion;
                         return problem.empty() && exhausted ? check_smallest(s.shape.type(), node) : problem;
                       });
}

Judgement judge_expansions(const PairStudy& s) {
  std::int64_t expansions = 0;
  Judgement j = for_each_node(
      s, [](const FoundNode& node) { return node.region.mesh.face_count() <= kLargestExhaustion; },
      "convex regions grow by whole strips",
      [&](const FoundNode& node) { return check_expansions(s.shape.type(), node, expansions); });
  j.found += ", " + counted(expansions, "expansion");
  j.checks += expansions;
  return j;
}

Judgement judge_sharp_turns(const PairStudy& s) {
  return for_each_node(s, "4 - G sides, a sharp turn counted as two corners",
                       [&s](const FoundNode& node) { return check_sharp_turns(s.shape.type(), node); });
}

}  // namespace requad::verify
