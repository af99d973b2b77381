// Claims about single moves: what they do to the pair, to the faces, and how much of the mesh they touch.
#include <set>

#include "enumerate/generators.hpp"
#include "mesh/topology/signature.hpp"
#include "verify/claims/judging.hpp"

namespace requad::verify {

using enumerate::FoundMove;
using enumerate::FoundNode;
using theory::Configuration;
using theory::Integer;

namespace {

const FoundNode& source(const PairStudy& s, const FoundMove& move) {
  return s.found.nodes[static_cast<std::size_t>(move.from)];
}
const FoundNode& destination(const PairStudy& s, const FoundMove& move) {
  return s.found.nodes[static_cast<std::size_t>(move.to)];
}

// The labellings of a node, read off its whole mesh.
std::vector<Configuration> labellings(const FoundNode& node) {
  std::vector<Configuration> result;
  for (const auto& frame : node.reading.frames) result.push_back(frame.labelling);
  return result;
}

std::string text(const Configuration& c) { return "(" + std::to_string(c.d1()) + "," + std::to_string(c.d2()) + ")"; }

// Four moves were tried at each pair, and no two of those that were made are the same step.
std::string check_four_directions(const PairStudy& s) {
  std::vector<int> tried(s.found.nodes.size(), 0);
  std::set<std::vector<Integer>> steps;
  for (const FoundMove& move : s.found.moves) {
    ++tried[static_cast<std::size_t>(move.from)];
    if (move.to < 0) continue;
    if (!move.before || !move.after) return "a move's frame has no labelling";
    std::vector<Integer> step{move.from,     move.before->p,   move.before->d1(), move.before->d2(),
                              move.after->p, move.after->d1(), move.after->d2()};
    step.insert(step.end(), move.after->parameters.e.begin(), move.after->parameters.e.end());
    if (!steps.insert(std::move(step)).second) return "two of the four directions are one step";
  }
  for (std::size_t i = 0; i < tried.size(); ++i) {
    if (s.found.holds_pair(static_cast<int>(i)) && tried[i] != 4)
      return std::to_string(tried[i]) + " directions at one configuration, not four";
  }
  return "";
}

template <class Problem>
Judgement judge_with_directions(const PairStudy& s, std::string predicted, Problem&& problem) {
  Judgement j = for_each_move(s, std::move(predicted), problem);
  if (!j.applies) return j;
  if (const std::string what = check_four_directions(s); !what.empty() && !j.violation)
    j.violation = at_region(s, what);
  return j;
}

}  // namespace

Judgement judge_distance_kept(const PairStudy& s) {
  return judge_with_directions(s, "(d1,d2) stays", [&s](const FoundMove& move) -> std::string {
    const Configuration& from = source(s, move).reading.configuration;
    const Configuration& to = destination(s, move).reading.configuration;
    return from.d1() == to.d1() && from.d2() == to.d2() ? "" : "(d1,d2) changes from " + text(from) + " to " + text(to);
  });
}

Judgement judge_distance_changed(const PairStudy& s) {
  return judge_with_directions(s, "(d1,d2) changes by (+-1,+-1)", [&s](const FoundMove& move) -> std::string {
    const auto by_one = [](Integer a, Integer b) { return a - b == 1 || b - a == 1; };
    for (const Configuration& from : labellings(source(s, move))) {
      for (const Configuration& to : labellings(destination(s, move))) {
        // The merged configuration has the same labels in every quadrant p.
        if ((from.p == to.p || from.merged() || to.merged()) && by_one(from.d1(), to.d1()) &&
            by_one(from.d2(), to.d2()))
          return "";
      }
    }
    return "(d1,d2) changes from " + text(source(s, move).reading.configuration) + " to " +
           text(destination(s, move).reading.configuration);
  });
}

// Along a connecting path of length d1 + d2 the quads are all created or all deleted. Where the two legs of the path
// work against each other, |d1 - d2| remain (Law irregular-11 of mesh/irregular/pair_moves.hpp).
Judgement judge_faces(const PairStudy& s) {
  const theory::PairSystem& system = s.shape.system();
  const Integer c = is_quad(s) ? 0 : is_digon(s) ? -1 : 1;
  const auto plus = [](Integer x) { return x == 0 ? "" : x > 0 ? " + 1" : " - 1"; };
  const std::string predicted = std::string("the quads grow by d2 - d1") + plus(c) + " or d1 - d2" + plus(c) +
                                " (slides), d1 + d2" + plus(c) + " (open), -(d1 + d2" + plus(-c) + ") (close)";
  return for_each_move(s, predicted, [&](const FoundMove& move) -> std::string {
    const FoundNode& from = source(s, move);
    const FoundNode& to = destination(s, move);
    for (const FoundNode* node : {&from, &to}) {
      if (node->region.mesh.face_count() != system.face_count(node->reading.configuration.parameters))
        return "the closed form of the face count is wrong";
    }
    const Integer change = to.region.mesh.face_count() - from.region.mesh.face_count();
    if (move.faces_made - move.faces_deleted != change)
      return "the reported faces are not those by which the mesh grew";
    if (move.faces_made > 0 && move.faces_deleted > 0) return "the move both makes and deletes faces";
    const Integer d1 = move.move.frame.d1;
    const Integer d2 = move.move.frame.d2;
    Integer law = 0;
    switch (move.move.step) {
      case mesh::PairStep::slide_first: law = d2 - d1 + c; break;
      case mesh::PairStep::slide_second: law = d1 - d2 + c; break;
      case mesh::PairStep::open: law = d1 + d2 + c; break;
      case mesh::PairStep::close: law = -(d1 + d2 - c); break;
    }
    return change == law ? ""
                         : "the mesh grows by " + std::to_string(change) + " faces, the connecting path says " +
                               std::to_string(law);
  });
}

// A move stays within the smallest convex region that holds both its ends. Removes every strip that neither end needs,
// and makes the same move there by the same number of operations. (Moves never touch the boundary of their region.)
Judgement judge_locality(const PairStudy& s) {
  return for_each_move(
      s, "made in the smallest region that holds both ends", [&s](const FoundMove& move) -> std::string {
        if (!move.before || !move.after) return "the move's frame has no labelling";
        // The merged configuration is labelled in quadrant 1, whichever quadrant a move reaches it from or leads to.
        Configuration from = *move.before;
        Configuration to = *move.after;
        const Configuration& pair = from.merged() ? to : from;
        for (Configuration* c : {&from, &to}) {
          if (!c->merged()) continue;
          const theory::IntegerVector e = c->parameters.e;
          for (Eigen::Index i = 0; i < e.size(); ++i) c->parameters.e(i) = e((i + pair.p - c->p + e.size()) % e.size());
          c->p = pair.p;
        }
        for (Eigen::Index i = 0; i < from.parameters.e.size(); ++i) {
          const Integer spare = std::min(from.parameters.e(i), to.parameters.e(i)) - 1;
          from.parameters.e(i) -= spare;
          to.parameters.e(i) -= spare;
        }
        const mesh::Region smallest = enumerate::glue_region(s.shape.type(), from);
        const std::string target = mesh::signature(enumerate::glue_region(s.shape.type(), to));
        for (const mesh::PairMove& candidate :
             enumerate::moves_of(smallest, enumerate::read(smallest, s.shape.type()))) {
          mesh::Region work = smallest;
          const mesh::MoveReport report = mesh::move_pair(work.mesh, candidate);
          if (report.refusal == mesh::Refusal::none && candidate.step == move.move.step &&
              mesh::signature(work) == target && static_cast<int>(report.operations.size()) == move.operations) {
            return "";
          }
        }
        return "the move is not made in the smallest region that holds both ends";
      });
}

}  // namespace requad::verify
