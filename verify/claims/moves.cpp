// Claims about single moves: what they do to the pair, to the faces, and how much of the mesh they touch.
#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "enumerate/generators.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "verify/claims/judging.hpp"
#include "verify/claims/surfaces.hpp"

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

// The faces that a step adds (Law irregular-11); c is -1, +1, 0 for a 3-3, 5-5, 3-5 pair.
Integer faces_law(mesh::PairStep step, Integer d1, Integer d2, Integer c) {
  switch (step) {
    case mesh::PairStep::slide_first: return d2 - d1 + c;
    case mesh::PairStep::slide_second: return d1 - d2 + c;
    case mesh::PairStep::open: return d1 + d2 + c;
    case mesh::PairStep::close: return -(d1 + d2 - c);
  }
  return 0;
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
    const Integer law = faces_law(move.move.step, d1, d2, c);
    return change == law ? ""
                         : "the mesh grows by " + std::to_string(change) + " faces, the connecting path says " +
                               std::to_string(law);
  });
}

namespace {

// Distances of all vertices from the boundary edges of a side, by vertex slot.
std::vector<int> distances_from_side(const mesh::Region& region, int side) {
  const mesh::QuadMesh& m = region.mesh;
  std::vector<int> distance(static_cast<std::size_t>(m.vertex_capacity()), -1);
  std::vector<mesh::VertexId> queue;
  const auto reach = [&](mesh::VertexId v, int d) {
    if (distance[v.slot()] >= 0) return;
    distance[v.slot()] = d;
    queue.push_back(v);
  };
  const auto positions = mesh::boundary_positions(region);
  for (const mesh::HalfEdgeId h : mesh::boundary_loop(m, region.root)) {
    if (positions[m.origin(h).slot()].side != side) continue;
    reach(m.origin(h), 0);
    reach(m.target(h), 0);
  }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const mesh::VertexId v = queue[i];
    for (const mesh::VertexId w : m.neighbours(v)) reach(w, distance[v.slot()] + 1);
  }
  return distance;
}

// Whether the operations of a move change no valence in the outermost strips, of which there are spare[i] towards side
// i, nor on the innermost line of them.
bool spares_strips(const mesh::Region& region, const FoundMove& move, const std::vector<Integer>& spare) {
  std::vector<std::vector<int>> distances;
  for (std::size_t side = 0; side < spare.size(); ++side)
    distances.push_back(distances_from_side(region, static_cast<int>(side)));
  mesh::QuadMesh m = region.mesh;
  for (const mesh::BasicOperation& op : move.script) {
    for (const mesh::VertexId v : mesh::changed_vertices(m, op)) {
      if (!v.valid() || !region.mesh.is_live(v)) continue;
      for (std::size_t side = 0; side < spare.size(); ++side) {
        if (distances[side][v.slot()] <= spare[side]) return false;
      }
    }
    mesh::apply(m, op);
  }
  return true;
}

}  // namespace

// A move stays within the smallest convex region that holds both its ends. It changes no valence in the strips that
// neither end needs. Without these strips, the same move is made by the same number of operations.
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
        const Eigen::Index k = from.parameters.e.size();
        std::vector<Integer> spare(static_cast<std::size_t>(k));  // by side of the region
        for (Eigen::Index i = 0; i < k; ++i) {
          const Integer fewer = std::min(from.parameters.e(i), to.parameters.e(i)) - 1;
          from.parameters.e(i) -= fewer;
          to.parameters.e(i) -= fewer;
          spare[static_cast<std::size_t>((i + pair.p - 1) % k)] = fewer;
        }
        if (!spares_strips(source(s, move).region, move, spare))
          return "the move changes a valence outside the smallest region that holds both ends";
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

namespace {

constexpr int kLargestDoubled = 20;      // faces
constexpr std::size_t kPairsTried = 12;  // of one surface

// By how much a step changes d1; d2 changes as much, to the other side if the step is a slide.
Integer change_of_d1(mesh::PairStep step, int l1, int l2) {
  if (l1 != l2) return 0;
  const bool grows = step == mesh::PairStep::slide_first || step == mesh::PairStep::close;
  return grows == (l1 == 3) ? 1 : -1;
}

}  // namespace

std::string surface_move_problem(const mesh::QuadMesh& m, const mesh::PairMove& move, const mesh::QuadMesh& after,
                                 const mesh::MoveReport& report) {
  const mesh::PairFrame& frame = move.frame;
  const int l1 = m.valence(frame.v1), l2 = m.valence(frame.v2);
  if (report.refusal != mesh::Refusal::none) {
    if (!(after == m)) return "a refused move changed the surface";
    return mesh::has_room(m, frame) ? "a move is refused though there is room" : "";
  }
  if (!mesh::validate(after).empty()) return "a move leaves no valid mesh";
  const Integer c = l1 != l2 ? 0 : l1 == 3 ? -1 : 1;
  if (after.face_count() - m.face_count() != faces_law(move.step, frame.d1, frame.d2, c))
    return "the quads grow by another number than the connecting path says";
  const bool slide = move.step == mesh::PairStep::slide_first || move.step == mesh::PairStep::slide_second;
  const Integer change = change_of_d1(move.step, l1, l2);
  const Integer d1 = frame.d1 + change, d2 = frame.d2 + (slide ? -change : change);
  const auto [a, b] = report.after;
  std::multiset<int> expected = mesh::sorted_irregular_valences(m);
  if (d1 == 0 && d2 == 0) {
    for (const int l : {l1, l2}) expected.erase(expected.find(l));
    expected.insert(l1 + l2 - 4);
  }
  if (mesh::sorted_irregular_valences(after) != expected) return "another vertex has become irregular, or regular";
  if (d1 == 0 && d2 == 0) {
    if (a != b || after.valence(a) != l1 + l2 - 4) return "a pair with d1 = d2 = 0 is not merged";
  } else {
    if (after.valence(a) != l1 || after.valence(b) != l2) return "the pair has other valences after the move";
    const auto frames = mesh::find_frames(after, a, b);
    const bool spans =
        std::any_of(frames.begin(), frames.end(), [&](const mesh::PairFrame& f) { return f.d1 == d1 && f.d2 == d2; });
    if (!spans) return "the pair does not span the rectangle that the step says";
  }
  mesh::QuadMesh undone = after;
  if (mesh::apply_all(undone, report.undo) != mesh::Refusal::none || !(undone == m))
    return "undoing does not restore the surface";
  mesh::QuadMesh back = after;
  if (mesh::move_pair(back, report.inverse).refusal != mesh::Refusal::none) {
    // Where the rectangle overlaps itself, the way back can be closed.
    if (!(back == after)) return "a refused inverse changed the surface";
    return mesh::has_room(after, report.inverse.frame) ? "the inverse move is refused though there is room" : "";
  }
  if (mesh::has_room(m, frame) && mesh::canonical_signature(back) != mesh::canonical_signature(m))
    return "the inverse move makes another surface";
  return "";
}

namespace {

// What the moves of a pair make: the step, d1, d2, and the surface afterwards, "" if the move is refused.
using Made = std::multiset<std::tuple<mesh::PairStep, int, int, std::string>>;
Made made_by(const mesh::QuadMesh& m, mesh::VertexId v1, mesh::VertexId v2) {
  Made made;
  for (const mesh::PairMove& move : mesh::pair_moves(m, v1, v2)) {
    mesh::QuadMesh after = m;
    const bool done = mesh::move_pair(after, move).refusal == mesh::Refusal::none;
    made.insert({move.step, move.frame.d1, move.frame.d2, done ? mesh::canonical_signature(after) : ""});
  }
  return made;
}

// All moves of some pairs of a closed surface, the first and then every n-th.
std::string check_surface(const mesh::QuadMesh& m, std::int64_t& tried, std::int64_t& made) {
  std::vector<std::array<mesh::VertexId, 2>> pairs;
  const std::vector<mesh::VertexId> irregular = mesh::irregular_vertices(m);
  for (std::size_t i = 0; i < irregular.size(); ++i) {
    for (std::size_t k = i + 1; k < irregular.size(); ++k) pairs.push_back({irregular[i], irregular[k]});
  }
  const std::size_t stride = pairs.size() / kPairsTried + 1;
  for (std::size_t i = 0; i < pairs.size(); i += stride) {
    for (const mesh::PairMove& move : mesh::pair_moves(m, pairs[i][0], pairs[i][1])) {
      ++tried;
      mesh::QuadMesh after = m;
      const mesh::MoveReport report = mesh::move_pair(after, move);
      if (report.refusal == mesh::Refusal::none) ++made;
      if (std::string problem = surface_move_problem(m, move, after, report); !problem.empty()) return problem;
    }
    if (made_by(m, pairs[i][0], pairs[i][1]) != made_by(m, pairs[i][1], pairs[i][0]))
      return "a pair has other moves in the other order";
  }
  return "";
}

}  // namespace

// What is wrong with has_room() on a configuration, or "". The faces round R_alpha touch no boundary iff all e_i >= 2, and
// in a convex region nothing else is in their way.
std::string room_problem(const FoundNode& node) {
  for (const auto& [frame, labelling] : node.reading.frames) {
    const auto& e = labelling.parameters.e;
    const bool free = std::all_of(e.begin(), e.end(), [](Integer x) { return x >= 2; });
    if (mesh::has_room(node.region.mesh, frame) != free)
      return "R_alpha is said to have room where it has none, or not";
  }
  return "";
}

// Spheres, tori and surfaces of genus two: the doubles of the first configuration.
Judgement judge_closed_surfaces(const PairStudy& s) {
  if (s.found.nodes.empty() || s.found.nodes[0].region.mesh.face_count() > kLargestDoubled) return not_applicable();
  std::vector<MadeSurface> surfaces = surfaces_from(s.found.nodes[0].region);
  std::erase_if(surfaces, [](const MadeSurface& surface) {
    const auto halves = surface.mesh.half_edges();
    return std::any_of(halves.begin(), halves.end(), [&](mesh::HalfEdgeId h) { return surface.mesh.is_boundary(h); });
  });
  std::int64_t tried = 0, made = 0;
  Judgement j = for_each_of(
      surfaces, "closed surface", "each move does what its step says, or is refused",
      [&](const MadeSurface& surface) { return check_surface(surface.mesh, tried, made); },
      [&s](const MadeSurface& surface, std::string what) {
        return at_region(s, "its double of Euler characteristic " + std::to_string(surface.euler) + ": " + what);
      });
  j.checks += tried;
  for (const FoundNode& node : s.found.nodes) {
    ++j.checks;
    std::string problem = room_problem(node);
    if (!problem.empty() && !j.violation)
      j.violation = at_node(s, static_cast<std::size_t>(&node - s.found.nodes.data()), std::move(problem));
  }
  j.found += ", " + std::to_string(made) + " of " + counted(tried, "move") + " made";
  j.row = {{"sides", side_list(s.shape.sides())}, {"pair", s.shape.type().name()}, {"moves", tried}, {"made", made}};
  return j;
}

}  // namespace requad::verify
