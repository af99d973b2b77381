// Properties of random meshes (properties.hpp). A case that fails prints its start, and its operations in the words of
// an edit script.
//
// A random operation is three numbers, each taken modulo the number of choices. So any numbers that remain after
// shrinking still give an operation on the mesh.
#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "enumerate/exploration.hpp"
#include "enumerate/generators.hpp"
#include "enumerate/realisation.hpp"
#include "enumerate/search/spheres.hpp"
#include "mesh/editing/features.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/irregular/pair_moves.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/enumerate/census.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/properties.hpp"
#include "theory/joined.hpp"

using namespace requad;
using namespace requad::mesh;
using tests::holds;

namespace {

using Kind = BasicOperation::Kind;
using Draw = std::tuple<unsigned, unsigned, unsigned>;

rc::Gen<std::vector<Draw>> draws() {
  const auto number = rc::gen::inRange(0U, 1U << 20);
  return rc::gen::container<std::vector<Draw>>(rc::gen::tuple(number, number, number));
}

BasicOperation operation_at(const QuadMesh& m, const Draw& draw) {
  const auto [kind, site, sector] = draw;
  const auto half_edges = m.half_edges();
  BasicOperation op{static_cast<Kind>(kind % 4), half_edges[site % half_edges.size()], {}, 0};
  if (op.kind == Kind::split) {
    std::vector<HalfEdgeId> in;
    m.for_each_out(m.origin(op.h), [&](HalfEdgeId g) { in.push_back(QuadMesh::previous(g)); });
    op.last = in[sector % in.size()];
    op.corner = static_cast<int>(sector / in.size() % 4);
  }
  return op;
}

// The mesh from which a case starts: a region of the census, a torus, a sphere, a grid, or a mesh from a file.
struct Start {
  std::string name;
  QuadMesh mesh;
};
const std::vector<Start>& starts() {
  static const std::vector<Start> all = [] {
    std::vector<Start> list{{"cube", tests::cube()},
                            {"torus 3 3", tests::torus(3, 3)},
                            {"torus 5 4", tests::torus(5, 4)},
                            {"grid 1 1", tests::grid(1, 1).mesh},
                            {"grid 4 3", tests::grid(4, 3).mesh}};
    for (const std::string name : {"figure-16", "figure-17", "figure-18"}) {
      list.push_back({name, read_surface(tests::example_mesh(name), false).mesh});
    }
    for (const std::vector<int>& irregular : {std::vector<int>(8, 3), {3, 3, 3, 3, 3, 3, 3, 3, 3, 5}}) {
      for (const std::string& text : enumerate::search_spheres(irregular, 14, {}).signatures)
        list.push_back({"sphere " + text, from_signature(text).mesh});
    }
    int n = 0;
    for (const auto& entry : tests::census(12, true)) {
      if (++n % 7 == 0) list.push_back({"region " + signature(entry.region), entry.region.mesh});
    }
    return list;
  }();
  return all;
}
const Start& some_start() { return starts()[*rc::gen::inRange(std::size_t{0}, starts().size())]; }

// The boundary edges as pairs of vertices. By Law topology-6 they stay in every loop.
std::vector<std::array<int, 2>> boundary_edges(const QuadMesh& m) {
  std::vector<std::array<int, 2>> edges;
  for (const HalfEdgeId h : m.half_edges()) {
    if (m.is_boundary(h)) edges.push_back({m.origin(h).index(), m.target(h).index()});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

bool keeps(const QuadMesh& m, const FeatureSet& features) {
  const auto edges = features.edges();
  return std::all_of(edges.begin(), edges.end(),
                     [&m](const auto& e) { return m.is_live(e[0]) && m.is_live(e[1]) && m.adjacent(e[0], e[1]); });
}

// Whether there is a map of half-edges from `a` to `b` that takes root to root and keeps next and twin. This constructs
// the map. Precondition: the meshes are connected.
bool same_from(const QuadMesh& a, HalfEdgeId root_a, const QuadMesh& b, HalfEdgeId root_b) {
  std::vector<HalfEdgeId> image(static_cast<std::size_t>(a.half_edge_capacity()));
  std::vector<HalfEdgeId> back(static_cast<std::size_t>(b.half_edge_capacity()));
  image[root_a.slot()] = root_b;
  back[root_b.slot()] = root_a;
  std::vector<HalfEdgeId> open{root_a};
  while (!open.empty()) {
    const HalfEdgeId h = open.back();
    open.pop_back();
    const HalfEdgeId g = image[h.slot()];
    if (a.is_boundary(h) != b.is_boundary(g)) return false;
    std::vector<std::pair<HalfEdgeId, HalfEdgeId>> neighbours{{a.next(h), b.next(g)}};
    if (!a.is_boundary(h)) neighbours.emplace_back(a.twin(h), b.twin(g));
    for (const auto& [to, image_of_to] : neighbours) {
      if (image[to.slot()] == image_of_to && back[image_of_to.slot()] == to) continue;
      if (image[to.slot()].valid() || back[image_of_to.slot()].valid()) return false;
      image[to.slot()] = image_of_to;
      back[image_of_to.slot()] = to;
      open.push_back(to);
    }
  }
  return true;
}
bool isomorphic(const QuadMesh& a, const QuadMesh& b) {
  if (a.face_count() != b.face_count()) return false;
  const HalfEdgeId first = a.half_edges().front();
  const auto roots = b.half_edges();
  return std::any_of(roots.begin(), roots.end(), [&](HalfEdgeId g) { return same_from(a, first, b, g); });
}

// Performs the random operations one after the other, and tests a property for each of them.
template <class Visit>
QuadMesh run(const Start& start, const std::vector<Draw>& drawn, std::vector<BasicOperation>& inverses,
             const Visit& visit) {
  QuadMesh m = start.mesh;
  RC_LOG() << "start: " << start.name << "\n";
  for (const Draw& draw : drawn) {
    const BasicOperation op = operation_at(m, draw);
    RC_LOG() << to_string(op) << "\n";
    const QuadMesh before = m;
    const Refusal predicted = why_not(m, op);
    const Applied done = apply(m, op);
    RC_ASSERT(done.refusal == predicted);
    if (done.refusal != Refusal::none) {
      RC_ASSERT(m == before);
      continue;
    }
    visit(before, op, m);
    inverses.push_back(done.inverse);
  }
  return m;
}

}  // namespace

TEST_CASE("random operations keep the laws, and their inverses give the mesh back", "[properties]") {
  holds("operations keep validity, Euler characteristic and boundary; undone, the mesh is equal", [] {
    const Start& start = some_start();
    std::vector<BasicOperation> inverses;
    const int euler = euler_characteristic(start.mesh);
    const int loops = boundary_loop_count(start.mesh), components = component_count(start.mesh);
    const auto boundary = boundary_edges(start.mesh);
    QuadMesh m =
        run(start, *draws(), inverses, [&](const QuadMesh& before, const BasicOperation& op, const QuadMesh& after) {
          const auto defects = validate(after);
          if (!defects.empty()) RC_LOG() << defects.front().message << "\n";
          RC_ASSERT(defects.empty());
          RC_ASSERT(euler_characteristic(after) == euler);
          RC_ASSERT(boundary_loop_count(after) == loops);
          RC_ASSERT(component_count(after) == components);
          RC_ASSERT(boundary_edges(after) == boundary);
          QuadMesh again = before;
          const Applied done = apply(again, op);
          RC_ASSERT(apply(again, done.inverse).refusal == Refusal::none);
          RC_ASSERT(again == before);
        });
    for (auto inverse = inverses.rbegin(); inverse != inverses.rend(); ++inverse) {
      RC_ASSERT(apply(m, *inverse).refusal == Refusal::none);
    }
    RC_ASSERT(m == start.mesh);
  });
}

TEST_CASE("an operation is refused for a feature exactly if it would break one", "[properties]") {
  // Law editing-5 says "if and only if". So refused operations are performed here, too, and must break an edge.
  holds("features", [] {
    const Start& start = some_start();
    FeatureSet features;
    for (const unsigned n : *rc::gen::container<std::vector<unsigned>>(rc::gen::inRange(0U, 1U << 20))) {
      const auto all = start.mesh.half_edges();
      const HalfEdgeId h = all[n % all.size()];
      features.insert(start.mesh.origin(h), start.mesh.target(h));
    }
    for (const Draw& draw : *draws()) {
      const BasicOperation op = operation_at(start.mesh, draw);
      if (why_not(start.mesh, op) != Refusal::none) continue;
      QuadMesh after = start.mesh;
      apply(after, op);
      RC_LOG() << "start: " << start.name << "\n" << to_string(op) << "\n";
      RC_ASSERT((features.why_not(start.mesh, op) == Refusal::none) == keeps(after, features));
    }
  });
}

TEST_CASE("signatures are equal exactly for isomorphic meshes", "[properties]") {
  holds("renaming changes no signature, and a signature gives its mesh back", [] {
    const Start& start = some_start();
    std::vector<BasicOperation> inverses;
    const QuadMesh m = run(start, *draws(), inverses, [](const QuadMesh&, const BasicOperation&, const QuadMesh&) {});
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const std::string name = canonical_signature(m);
    RC_ASSERT(canonical_signature(tests::relabel(m, random).mesh) == name);
    const Region rebuilt = from_signature(name);
    RC_ASSERT(validate(rebuilt.mesh).empty());
    RC_ASSERT(signature(rebuilt) == name);
    RC_ASSERT(isomorphic(m, rebuilt.mesh));
  });
  holds("two meshes a few operations apart", [] {
    const Start& start = some_start();
    std::vector<BasicOperation> inverses;
    const auto few = rc::gen::resize(4, draws());
    const auto nothing = [](const QuadMesh&, const BasicOperation&, const QuadMesh&) {};
    const QuadMesh a = run(start, *few, inverses, nothing);
    const QuadMesh b = run(start, *few, inverses, nothing);
    const bool same = isomorphic(a, b);
    RC_CLASSIFY(same, "isomorphic");
    RC_ASSERT((canonical_signature(a) == canonical_signature(b)) == same);
  });
}

namespace {

struct Drawn {
  theory::PairType type;
  theory::Configuration configuration;
};
// A random configuration with strip counts of at most 5. It may be a merged one.
Drawn some_configuration() {
  const theory::PairType type = *rc::gen::element(theory::kDigon, theory::kHexagon, theory::kQuad);
  theory::Configuration c;
  c.parameters.d1 = *rc::gen::inRange(0, 6);
  c.parameters.d2 = *rc::gen::inRange(0, 6);
  c.parameters.e.resize(type.side_count());
  for (theory::Integer& e : c.parameters.e) e = *rc::gen::inRange(1, 6);
  c.p = *rc::gen::inRange(1, type.side_count() + 1);
  RC_PRE(theory::parameters_problem(type, c.parameters).empty());
  RC_LOG() << type.name() << " " << theory::label(type, c) << ", sides "
           << theory::joined(theory::region_sides(type, c), ",") << "\n";
  return {type, c};
}

}  // namespace

TEST_CASE("random pair moves do what the query says, and their inverses and undo give the mesh back", "[properties]") {
  holds("a walk in one region", [] {
    const auto [type, c] = some_configuration();
    Region region = enumerate::glue_region(type, c);
    const std::vector<int> sides = side_lengths(region);
    for (const auto& [choice, unused, also_unused] : *draws()) {
      const auto moves = enumerate::moves_of(region, enumerate::read(region, type));
      if (moves.empty()) break;
      const PairMove& move = moves[choice % moves.size()];
      const Region before = region;
      RC_LOG() << name(move.step) << "\n";
      const Refusal predicted = why_not_move_pair(region.mesh, move);
      RC_ASSERT(region.mesh == before.mesh);
      const MoveReport report = move_pair(region.mesh, move);
      RC_ASSERT(report.refusal == predicted);
      if (predicted != Refusal::none) {
        RC_ASSERT(region.mesh == before.mesh);
        continue;
      }
      RC_ASSERT(validate(region.mesh).empty());
      RC_ASSERT(side_lengths(region) == sides);
      Region back = region;
      RC_ASSERT(move_pair(back.mesh, report.inverse).refusal == Refusal::none);
      RC_ASSERT(signature(back) == signature(before));
      QuadMesh undone = region.mesh;
      RC_ASSERT(apply_all(undone, report.undo) == Refusal::none);
      RC_ASSERT(undone == before.mesh);
    }
  });
}

TEST_CASE("the generators agree on random parameters", "[properties]") {
  holds("realised and glued regions", [] {
    const auto [type, c] = some_configuration();
    const theory::IntegerVector sides = theory::region_sides(type, c);
    const enumerate::Realisation made =
        enumerate::realise({type, sides}, enumerate::simplest_configuration({type, sides}), c);
    RC_ASSERT(signature(made.region) == signature(enumerate::glue_region(type, c)));
  });
  holds("grown and glued regions", [] {
    const auto [type, c] = some_configuration();
    const Region grown = enumerate::grow_region(type, c);
    const Region glued = enumerate::glue_region(type, c);
    RC_ASSERT(validate(grown.mesh).empty());
    RC_ASSERT(region_problem(grown).empty());
    RC_ASSERT(signature(grown) == signature(glued));
    RC_ASSERT(grown.mesh.face_count() == glued.mesh.face_count());
  });
}
