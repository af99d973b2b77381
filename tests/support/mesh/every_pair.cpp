#include "tests/support/mesh/every_pair.hpp"

#include <algorithm>
#include <random>
#include <set>

#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"

namespace requad::tests {

using namespace mesh;

namespace {

// The table of pair_moves.hpp, and law irregular-11.
struct Expected {
  int d1;
  int d2;
  int faces;  // gained
};
Expected expected(int l1, int l2, const PairFrame& f, PairStep step) {
  const int c = l1 != l2 ? 0 : l1 == 3 ? -1 : 1;
  switch (step) {
    case PairStep::slide_first: return {f.d1 - c, f.d2 + c, f.d2 - f.d1 + c};
    case PairStep::slide_second: return {f.d1 + c, f.d2 - c, f.d1 - f.d2 + c};
    case PairStep::open: return {f.d1 + c, f.d2 + c, f.d1 + f.d2 + c};
    case PairStep::close: return {f.d1 - c, f.d2 - c, -(f.d1 + f.d2 - c)};
  }
  return {};
}

// Whether a search from v1 finds a frame of the pair with these extents.
bool spans(const QuadMesh& m, VertexId v1, VertexId v2, int d1, int d2) {
  const std::vector<PairFrame> frames = find_frames(m, v1, v2);
  return std::any_of(frames.begin(), frames.end(), [&](const PairFrame& f) { return f.d1 == d1 && f.d2 == d2; });
}

// Looks at one mesh and its moves.
class Checker {
 public:
  Checker(const QuadMesh& mesh, PairMoveTally& tally, int largest)
      : mesh_(mesh), tally_(tally), valences_(sorted_irregular_valences(mesh)), largest_(largest) {}

  std::string check(VertexId v1, VertexId v2) {
    ++tally_.pairs;
    const std::vector<PairMove> moves = pair_moves(mesh_, v1, v2);
    const std::vector<PairMove> other_order = pair_moves(mesh_, v2, v1);
    if (moves.size() != other_order.size()) return "v2, v1 has other moves than v1, v2";
    for (std::size_t i = 0; i < moves.size(); ++i) {
      Refusal refusal;
      std::string problem = check(moves[i], refusal);
      if (problem.empty()) problem = in_order(moves[i], other_order[i], refusal);
      if (!problem.empty()) return describe(moves[i]) + ": " + problem;
      ++tally_.listed;
      ++(refusal == Refusal::none ? tally_.made : tally_.refused[std::string(refusal.clause())]);
    }
    return "";
  }

 private:
  static std::string describe(const PairMove& move) {
    return std::string(name(move.step)) + " of " + std::to_string(move.frame.v1.index()) + " and " +
           std::to_string(move.frame.v2.index()) + " at (" + std::to_string(move.frame.d1) + "," +
           std::to_string(move.frame.d2) + ")";
  }

  // Law irregular-15.
  std::string in_order(const PairMove& move, const PairMove& other, Refusal refusal) const {
    if (move.step != other.step || move.frame.d1 != other.frame.d1 || move.frame.d2 != other.frame.d2)
      return "v2, v1 has other moves than v1, v2";
    QuadMesh tried = mesh_;
    if (why_not_move_pair(tried, other) != refusal) return "v2, v1 has another answer than v1, v2";
    return tried == mesh_ ? "" : "a question changed the mesh";
  }

  std::string check(const PairMove& move, Refusal& refusal) {
    QuadMesh after = mesh_;
    const MoveReport report = move_pair(after, move);
    refusal = report.refusal;
    const bool room = has_room(mesh_, move.frame);
    tally_.with_room += room ? 1 : 0;
    tally_.overlapping += overlaps_itself(mesh_, move.frame) ? 1 : 0;
    if (refusal == Refusal::none) return check_made(move, report, after, room);
    if (room) return "refused though there is room: " + std::string(refusal.clause());
    if (!(after == mesh_)) return "a refused move changed the mesh";
    return report.operations.empty() && report.undo.empty() ? "" : "a refused move reports operations";
  }

  std::string check_made(const PairMove& move, const MoveReport& report, const QuadMesh& after, bool room) {
    const int l1 = mesh_.valence(move.frame.v1), l2 = mesh_.valence(move.frame.v2);
    if (!validate(after).empty()) return "the mesh is not valid";
    const Expected expect = expected(l1, l2, move.frame, move.step);
    if (after.face_count() - mesh_.face_count() != expect.faces)
      return "another number of faces than by law irregular-11";
    const auto bound = static_cast<std::size_t>(move.frame.distance()) + 3;
    if (report.operations.size() > bound) return "more operations than the extents say";
    const auto [v1, v2] = report.after;
    if (!after.is_live(v1) || !after.is_live(v2)) return "the pair is not there any more";
    std::multiset<int> valences = valences_;
    const bool merges = expect.d1 == 0 && expect.d2 == 0;
    if (merges) {
      valences.erase(valences.find(l1));
      valences.erase(valences.find(l2));
      valences.insert(l1 + l2 - 4);
      if (v1 != v2 || after.valence(v1) != l1 + l2 - 4) return "the pair did not merge";
    } else {
      if (v1 == v2 || after.valence(v1) != l1 || after.valence(v2) != l2) return "the pair has other valences";
      if (!spans(after, v1, v2, expect.d1, expect.d2)) return "the pair does not span the rectangle of the table";
    }
    if (sorted_irregular_valences(after) != valences) return "other irregular vertices than before";
    QuadMesh undone = after;
    if (apply_all(undone, report.undo) != Refusal::none || !(undone == mesh_)) return "undone, the mesh is another one";
    return check_inverse(report, after, room);
  }

  std::string check_inverse(const MoveReport& report, const QuadMesh& after, bool room) {
    QuadMesh back = after;
    const Refusal refusal = move_pair(back, report.inverse).refusal;
    if (refusal != Refusal::none) {
      ++tally_.irreversible;
      return room ? "the inverse is refused: " + std::string(refusal.clause()) : "";
    }
    if (sorted_irregular_valences(back) != valences_) return "the inverse leads to other irregular vertices";
    if (mesh_.face_count() > largest_) return "";
    if (signature_.empty()) signature_ = canonical_signature(mesh_);
    const bool returns = canonical_signature(back) == signature_;
    ++(returns ? tally_.isomorphic : tally_.elsewhere);
    return returns || !room ? "" : "the inverse leads to another mesh";
  }

  const QuadMesh& mesh_;
  PairMoveTally& tally_;
  std::multiset<int> valences_;
  int largest_;
  std::string signature_;  // of mesh_, once it was needed
};

}  // namespace

PairMoveTally& PairMoveTally::operator+=(const PairMoveTally& other) {
  pairs += other.pairs;
  listed += other.listed;
  made += other.made;
  with_room += other.with_room;
  overlapping += other.overlapping;
  isomorphic += other.isomorphic;
  elsewhere += other.elsewhere;
  irreversible += other.irreversible;
  for (const auto& [reason, number] : other.refused) refused[reason] += number;
  return *this;
}

std::string to_string(const PairMoveTally& tally) {
  std::string text = std::to_string(tally.pairs) + " pairs, " + std::to_string(tally.listed) + " moves listed, " +
                     std::to_string(tally.made) + " made, " + std::to_string(tally.isomorphic) +
                     " inverses lead back, " + std::to_string(tally.elsewhere) + " to another mesh, " +
                     std::to_string(tally.irreversible) + " are refused; listed with room " +
                     std::to_string(tally.with_room) + ", for overlapping rectangles " +
                     std::to_string(tally.overlapping) + "; refused";
  for (const auto& [reason, number] : tally.refused) text += " " + std::to_string(number) + " (" + reason + ")";
  return text;
}

std::string check_pair(const QuadMesh& mesh, VertexId v1, VertexId v2, PairMoveTally& tally, int largest) {
  return Checker(mesh, tally, largest).check(v1, v2);
}

std::vector<std::pair<VertexId, VertexId>> irregular_pairs(const QuadMesh& mesh, std::size_t most, unsigned seed) {
  std::vector<VertexId> ends;
  for (const VertexId v : irregular_vertices(mesh)) {
    if (mesh.valence(v) == 3 || mesh.valence(v) == 5) ends.push_back(v);
  }
  std::vector<std::pair<VertexId, VertexId>> pairs;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i + 1; j < ends.size(); ++j) pairs.emplace_back(ends[i], ends[j]);
  }
  if (pairs.size() > most) {
    std::mt19937 random(seed);
    for (std::size_t i = 0; i < most; ++i) std::swap(pairs[i], pairs[i + random() % (pairs.size() - i)]);
    pairs.resize(most);
  }
  return pairs;
}

std::string check_pairs(const QuadMesh& mesh, std::size_t most, unsigned seed, PairMoveTally& tally, int largest) {
  Checker checker(mesh, tally, largest);
  for (const auto& [v1, v2] : irregular_pairs(mesh, most, seed)) {
    if (const std::string problem = checker.check(v1, v2); !problem.empty()) return problem;
  }
  return "";
}

}  // namespace requad::tests
