// Claims about where the separatrices of a pair meet the boundary: Theorem 7.11, and what the proofs of Theorems 7.2 and
// 7.3 say of it.
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "theory/separatrix_vector.hpp"
#include "verify/claims/judging.hpp"

namespace requad::verify {

using enumerate::FoundNode;
using mesh::Region;
using theory::Configuration;
using theory::PairType;

namespace {

// Whether the vector read off the mesh is that of theory-5. The labelling may have the two vertices in the other order.
bool has_predicted_vector(const PairStudy& s, const FoundNode& node, const enumerate::LabelledFrame& labelled) {
  const PairType type = s.shape.type();
  const auto vector = theory::separatrix_vector(s.shape, theory::to_labelling(labelled.labelling));
  std::vector<std::pair<theory::Integer, theory::Integer>> predicted;
  for (int i = 0; i < type.l1 + type.l2; ++i) {
    const bool first = i < type.l1;
    const auto at = static_cast<std::size_t>(first ? i : i - type.l1);
    const theory::Crossing& crossing = first ? vector.at_v1[at] : vector.at_v2[at];
    predicted.emplace_back(crossing.side, crossing.distance);
  }
  const auto ends = mesh::both_ends(node.region.mesh, labelled.frame);
  return std::any_of(ends.begin(), ends.end(), [&](const mesh::PairFrame& frame) {
    std::vector<std::pair<theory::Integer, theory::Integer>> found;
    for (const auto& at : enumerate::separatrix_vector(node.region, frame)) found.emplace_back(at.side, at.distance);
    return found == predicted;
  });
}

}  // namespace

// The vector of each configuration is the one that its parameters give (theory-5), which is the premise of the proof for
// all sizes. Distinct configurations have distinct vectors. These are compared up to renaming: each stands for the
// least one over the frames and both orders of the vertices.
Judgement judge_theorem_11(const PairStudy& s) {
  std::map<std::vector<std::pair<int, int>>, const FoundNode*> seen;
  const auto problem = [&](const FoundNode& node) -> std::string {
    std::vector<std::pair<int, int>> least;
    for (const auto& labelled : node.reading.frames) {
      if (!has_predicted_vector(s, node, labelled)) return "has another separatrix vector than its parameters give";
      for (const auto& frame : mesh::both_ends(node.region.mesh, labelled.frame)) {
        std::vector<std::pair<int, int>> vector;
        for (const auto& at : enumerate::separatrix_vector(node.region, frame))
          vector.emplace_back(at.side, at.distance);
        if (least.empty() || vector < least) least = std::move(vector);
      }
    }
    const auto [other, is_new] = seen.emplace(std::move(least), &node);
    if (is_new) return "";
    return "has the separatrix vector of " + theory::label(s.shape.type(), other->second->reading.configuration);
  };
  return for_each_node(s, holds_pair, "a separatrix vector of its own", problem);
}

namespace {

// Where a separatrix meets a side.
struct Meeting {
  int distance = 0;  // from the start of the side
  int vertex = 0;    // 0: a separatrix of v1, 1: of v2
  friend auto operator<=>(const Meeting&, const Meeting&) = default;
};

// The meetings on each side, counter-clockwise.
std::vector<std::vector<Meeting>> meetings(const FoundNode& node, int sides) {
  const Region& region = node.region;
  const mesh::PairFrame& frame = node.reading.frames[0].frame;
  std::vector<std::vector<Meeting>> result(static_cast<std::size_t>(sides));
  int i = 0;
  const int first = region.mesh.valence(frame.v1);
  for (const mesh::BoundaryPosition& at : enumerate::separatrix_vector(region, frame)) {
    if (at.side >= 0) result[static_cast<std::size_t>(at.side)].push_back({at.distance, i < first ? 0 : 1});
    ++i;
  }
  for (auto& side : result) std::sort(side.begin(), side.end());
  return result;
}

std::string check_digon(const FoundNode& node) {
  const Configuration& c = node.reading.frames[0].labelling;
  std::set<int> in_the_middle;
  for (const auto& side : meetings(node, 2)) {
    if (c.degenerate()) {
      if (side.size() != 2 || side[0].vertex == side[1].vertex)
        return "a side does not meet one separatrix of each vertex";
      if (side[1].distance - side[0].distance != c.d1() + c.d2()) return "the meetings on a side are not d apart";
      continue;
    }
    if (side.size() != 3 || side[0].vertex != side[2].vertex || side[1].vertex == side[0].vertex)
      return "a side does not meet a separatrix of one vertex between two of the other";
    in_the_middle.insert(side[1].vertex);
    if (side[1].distance - side[0].distance != c.d1() || side[2].distance - side[1].distance != c.d2())
      return "the meetings on a side are not d1 and d2 apart";
  }
  return c.degenerate() || in_the_middle.size() == 2 ? "" : "the same vertex is in the middle on both sides";
}

std::string check_hexagon(const FoundNode& node) {
  const Configuration& c = node.reading.frames[0].labelling;
  std::vector<theory::Integer> apart;  // by side: the distance between two meetings, or -1 if there is one
  for (const auto& side : meetings(node, 6)) {
    if (side.empty() || side.size() > 2) return "a side meets no separatrix, or more than two";
    if (side.size() == 2 && side[0].vertex == side[1].vertex) return "a side meets two separatrices of one vertex";
    apart.push_back(side.size() == 2 ? side[1].distance - side[0].distance : -1);
  }
  // Counter-clockwise from some side on: sides 6, 1, 2, 3, 4, 5 of Equation 2.
  const theory::Integer d = c.d1() + c.d2();
  const std::vector<theory::Integer> expected =
      c.degenerate() ? std::vector<theory::Integer>{d, -1, -1, d, -1, -1}
                     : std::vector<theory::Integer>{c.d2(), c.d1(), -1, c.d2(), c.d1(), -1};
  for (int shift = 0; shift < 3; ++shift) {
    if (apart == expected) return "";
    std::rotate(apart.begin(), apart.begin() + 1, apart.end());
  }
  return "the sides that meet two separatrices are others than those of the proof, or the meetings are not d1 and d2 "
         "apart";
}

Judgement judge_meetings(const PairStudy& s, std::string predicted, std::string (*check)(const FoundNode&)) {
  return for_each_node(
      s, [](const FoundNode& node) { return holds_pair(node) && !node.reading.frames.empty(); }, std::move(predicted),
      check);
}

}  // namespace

Judgement judge_digon_meetings(const PairStudy& s) {
  return judge_meetings(s, "each side meets three separatrices, d1 and d2 apart, or two", check_digon);
}

Judgement judge_hexagon_meetings(const PairStudy& s) {
  return judge_meetings(s, "four sides meet two separatrices, d1 or d2 apart, or two sides do", check_hexagon);
}

}  // namespace requad::verify
