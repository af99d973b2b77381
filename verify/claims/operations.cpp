// Claims about basic operations (sections 2, 4). The checks try every operation that keeps the boundary, at every site of
// generated neighbourhoods.
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "verify/claims/judging.hpp"
#include "verify/claims/sites.hpp"

namespace requad::verify {

using mesh::BasicOperation;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Refusal;
using mesh::Region;
using mesh::VertexId;
using Kind = mesh::BasicOperation::Kind;

namespace {

constexpr int kLargestNeighbourhood = 60;  // faces; checks that try all pairs of operations use smaller regions only

// Meshes to try single operations on: the neighbourhood, or the first configuration of a small region.
const Region* sample(const Study& study) {
  const Region* region = nullptr;
  if (const auto* vertex = std::get_if<VertexStudy>(&study)) region = neighbourhood(*vertex);
  if (const auto* pair = std::get_if<PairStudy>(&study); pair != nullptr && !pair->found.nodes.empty())
    region = &pair->found.nodes[0].region;
  return region != nullptr && region->mesh.face_count() <= kLargestNeighbourhood ? region : nullptr;
}

// What is wrong with the valences after an operation, compared with those that section 4 gives, or "".
std::string check_valences(const QuadMesh& m, const BasicOperation& op) {
  QuadMesh after = m;
  const mesh::Applied done = mesh::apply(after, op);
  std::map<VertexId, int> expected;  // valence of every vertex afterwards
  for (const VertexId v : m.vertices()) expected[v] = m.valence(v);
  if (is_flip(op.kind)) {
    // The ends of the edge before, and those after.
    --expected[m.origin(op.h)], --expected[m.target(op.h)];
    ++expected[after.origin(done.made)], ++expected[after.target(done.made)];
  } else if (op.kind == Kind::collapse) {
    const VertexId keep = m.origin(op.h), gone = m.target(m.next(op.h));
    expected[keep] += expected[gone] - 2;
    expected.erase(gone);
    --expected[m.target(op.h)], --expected[m.origin(m.previous(op.h))];
  } else {
    // The edges strictly between the two edges of the path, counted on the mesh before the split.
    int group = 0;
    for (HalfEdgeId h = m.ccw(op.h); h != m.twin(op.last); h = m.ccw(h)) ++group;
    const VertexId made = after.origin(QuadMesh::opposite(done.made));
    expected[made] = group + 2;
    const VertexId v = m.origin(op.h);
    expected[v] = m.valence(v) - 2 - group + 2;
    ++expected[m.target(op.h)], ++expected[m.origin(op.last)];
  }
  bool same = static_cast<int>(expected.size()) == after.vertex_count();
  for (const auto& [v, valence] : expected) same = same && after.is_live(v) && after.valence(v) == valence;
  return same ? "" : mesh::to_string(op) + " changes other valences than section 4 says";
}

// Whether one split at an end of a flip's edge, and one collapse, make the mesh that the flip made.
bool is_split_and_collapse(const Region& region, const std::vector<BasicOperation>& operations,
                           const BasicOperation& flip, const QuadMesh& flipped) {
  const QuadMesh& m = region.mesh;
  const VertexId root = m.origin(region.root);
  const std::string target = mesh::signature(flipped, flipped.out(root));
  bool found = false;
  for (const BasicOperation& first : operations) {
    if (found || first.kind != Kind::split ||
        (m.origin(first.h) != m.origin(flip.h) && m.origin(first.h) != m.target(flip.h)))
      continue;
    QuadMesh halfway = m;
    const HalfEdgeId made = mesh::apply(halfway, first).made;
    for (const VertexId v : halfway.corners(QuadMesh::face(made))) {
      halfway.for_each_out(v, [&](HalfEdgeId h) {
        for (const HalfEdgeId corner : {h, QuadMesh::next(h)}) {
          QuadMesh result = halfway;
          if (found || mesh::collapse(result, corner) != Refusal::none) continue;
          found = mesh::signature(result, result.out(root)) == target;
        }
      });
    }
  }
  return found;
}

// What is wrong with an operation's inverse, and with what a flip is made of, or "".
std::string check_inverse(const Region& region, const std::vector<BasicOperation>& operations,
                          const BasicOperation& op) {
  const QuadMesh& m = region.mesh;
  QuadMesh after = m;
  const mesh::Applied done = mesh::apply(after, op);
  // A flip keeps the number of faces, a split adds one, and a collapse removes one. So no sequence of flips and splits
  // makes a collapse, and no sequence of flips and collapses makes a split.
  const int faces = op.kind == Kind::split ? 1 : op.kind == Kind::collapse ? -1 : 0;
  if (after.face_count() - m.face_count() != faces) return mesh::to_string(op) + " makes a wrong number of faces";
  const Kind inverse = op.kind == Kind::split      ? Kind::collapse
                       : op.kind == Kind::collapse ? Kind::split
                       : op.kind == Kind::flip_cw  ? Kind::flip_ccw
                                                   : Kind::flip_cw;
  QuadMesh back = after;
  if (done.inverse.kind != inverse || mesh::apply(back, done.inverse).refusal != Refusal::none || !(back == m))
    return mesh::to_string(op) + " has no inverse of the other kind";
  if (is_flip(op.kind) && !is_split_and_collapse(region, operations, op, after))
    return mesh::to_string(op) + " is no split and collapse";
  return "";
}

}  // namespace

Judgement judge_single_vertex_operations(const VertexStudy& s) {
  const Region* region = neighbourhood(s);
  if (region == nullptr || s.valence() == 4) return not_applicable();
  const VertexId v = mesh::irregular_vertices(region->mesh)[0];
  std::vector<BasicOperation> at_vertex = mesh::operations_inside(region->mesh);
  std::erase_if(at_vertex, [&](const BasicOperation& op) {
    const auto changed = mesh::changed_vertices(region->mesh, op);
    return std::find(changed.begin(), changed.end(), v) == changed.end();
  });
  Judgement j = for_each_of(
      at_vertex, "operation", "more than one irregular vertex afterwards",
      [&](const BasicOperation& op) {
        return performed(region->mesh, op).irregular.size() > 1
                   ? ""
                   : mesh::to_string(op) + " does not increase the number of irregular vertices";
      },
      placed_in(*region));
  // Every operation at the vertex was tried: 2 flips of each of its edges and of two more at each of its faces, 2
  // collapses of each face, a split along each two of its edges, and 3 along each edge to a neighbour.
  // (A v2 may not lose an edge, and its two faces share two edges.)
  const int l = s.valence();
  if (l == 2) return j;
  const int number = 4 * l + 2 * l + l * (l - 1) / 2 + 3 * l;
  Requirements(j).that(
      static_cast<int>(at_vertex.size()) == number,
      {std::to_string(at_vertex.size()) + " operations at the vertex, not " + std::to_string(number), "", "", *region});
  return j;
}

namespace {

// The mesh after the rotation of an interior vertex: its edges go to the opposite corners of its faces. Nothing if that
// is no mesh.
std::optional<QuadMesh> rotated(const QuadMesh& m, VertexId v) {
  std::vector<std::array<int, 4>> faces = m.compact_faces();
  std::vector<mesh::FaceId> ids = m.faces();
  m.for_each_out(v, [&](HalfEdgeId h) {
    // Faces v a b c and, counter-clockwise next, v c d e: v b c d takes the place of the first.
    const HalfEdgeId beyond = m.ccw(h);
    const auto at = static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), QuadMesh::face(h)) - ids.begin());
    const VertexId b = m.target(QuadMesh::next(h)), c = m.target(beyond), d = m.target(QuadMesh::next(beyond));
    faces[at] = {v.index(), b.index(), c.index(), d.index()};
  });
  try {
    return QuadMesh::from_faces(m.vertex_count(), faces);
  } catch (const mesh::MeshError&) {
    return std::nullopt;
  }
}

}  // namespace

// The rotations that change the vertex's valence or that of a vertex on one of its faces: those of the vertex itself and
// of all vertices on its faces.
Judgement judge_rotations(const VertexStudy& s) {
  const Region* region = neighbourhood(s);
  if (region == nullptr || s.valence() == 4) return not_applicable();
  const QuadMesh& m = region->mesh;
  const VertexId v = mesh::irregular_vertices(m)[0];
  std::set<VertexId> near;
  m.for_each_out(v, [&](HalfEdgeId h) {
    for (const VertexId w : m.corners(QuadMesh::face(h))) near.insert(w);
  });
  return for_each_of(
      near, "rotation", "more than one irregular vertex afterwards",
      [&](VertexId w) -> std::string {
        const auto after = rotated(m, w);
        // A neighbour of a v2 would take one of its two edges.
        if (!after) return w == v || m.valence(v) > 2 ? "the rotation makes no mesh" : "";
        return mesh::irregular_vertices(*after).size() > 1
                   ? ""
                   : "the rotation does not increase the number of irregular vertices";
      },
      placed_in(*region));
}

Judgement judge_valence_changes(const Study& s) {
  const Region* region = sample(s);
  if (region == nullptr) return not_applicable();
  return for_each_of(
      mesh::operations_inside(region->mesh), "operation", "the valences that section 4 gives",
      [&](const BasicOperation& op) { return check_valences(region->mesh, op); }, placed_in(*region));
}

Judgement judge_inverses(const Study& s) {
  const Region* region = sample(s);
  if (region == nullptr || region->mesh.face_count() > kLargestNeighbourhood / 2) return not_applicable();
  const std::vector<BasicOperation> operations = mesh::operations_inside(region->mesh);
  return for_each_of(
      operations, "operation", "an inverse; for a flip a split and a collapse",
      [&](const BasicOperation& op) { return check_inverse(*region, operations, op); }, placed_in(*region));
}

}  // namespace requad::verify
