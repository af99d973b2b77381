// The quad mesh with boundary.
//
// Terms, for everything in mesh/
//   half-edge   One side of an edge, directed so that its face is on its left. So faces are counter-clockwise. Its twin
//               is the other side of the edge, in the other face.
//   fan         The half-edges out of a vertex, counter-clockwise: a cycle at an interior vertex, a path at a boundary
//               vertex.
//   valence     The number of edges at a vertex, l(v) in the paper.
//   boundary    The edges with only one face, and their vertices. All other edges and vertices are interior.
//   regular     An interior vertex of valence 4. Other interior vertices are irregular. (At boundary vertices the paper
//               measures turns instead: region.hpp.)
//   live        An element that is not deleted. The ids of deleted elements are free, and the last one is reused first.
//
// Representation. Every face is a quad, so half-edge h = 4 * face + k needs no pointer to the next one: next(h) is in
// the same group of four. What remains is two integers for each half-edge (twin and origin), one half-edge for each
// vertex, and the lists of free faces and vertices. Twin and origin lie side by side, so that a face fills half a cache
// line: at a random site of a large mesh, an operation spends nearly all its time waiting for memory.
//
//              d <--- c           h: a -> b, face f on the left
//              |  f   |           next(h): b -> c,  previous(h): d -> a
//              |      |           twin(h): b -> a in the face below, or none on the boundary
//              a -h-> b
//
// Invariants, which validate() checks
//   topology-1  twin(twin(h)) = h, twin(h) differs from h, and origin(twin(h)) = origin(next(h)), for each h that has a
//               twin. In words: twins are paired and run in opposite directions along one edge.
//   topology-2  The half-edges out of a vertex form one fan.
//   topology-3  out(v) of a boundary vertex is the first half-edge of the fan, which has no twin. For an interior
//               vertex it is any half-edge of the fan.
//   topology-4  The mesh is simple: no edge joins a vertex to itself, and no two edges join the same two vertices.
//               Hence the four vertices of a face differ. An interior vertex of valence 2 is allowed.
// Not required: connectedness, a boundary, a certain genus.
//
// Costs: the way from one element to the next takes O(1), a valence O(valence). No operation changes the handle of an
// element that it keeps.
#pragma once

#include <array>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh/topology/handles.hpp"

namespace requad::mesh {

// Thrown for faces that do not form a quad mesh. The message is one line and names the face or vertex, 0-based.
class MeshError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

class QuadMesh {
 public:
  QuadMesh() = default;

  // Builds a mesh from counter-clockwise faces with vertices in 0..vertex_count-1. Face i becomes FaceId(i), and its
  // corner k the origin of half-edge 4 i + k. Throws MeshError if the faces break an invariant. O(F) for bounded genus.
  static QuadMesh from_faces(int vertex_count, std::span<const std::array<int, 4>> faces);
  // Takes the arrays as they are, broken or not. For tests of the validator. A handle of -1 means none, or deleted.
  // Precondition: there are as many twins as origins.
  static QuadMesh from_arrays_unchecked(const std::vector<HalfEdgeId>& twin, const std::vector<VertexId>& origin,
                                        std::vector<HalfEdgeId> out);

  // How many elements are live; and the sizes of the arrays, which all indices are below. edge_count() is O(F).
  int vertex_count() const { return static_cast<int>(out_.size() - free_vertices_.size()); }
  int face_count() const { return static_cast<int>(sides_.size() / 4 - free_faces_.size()); }
  int edge_count() const;
  int vertex_capacity() const { return static_cast<int>(out_.size()); }
  int face_capacity() const { return static_cast<int>(sides_.size() / 4); }
  int half_edge_capacity() const { return static_cast<int>(sides_.size()); }

  bool is_live(VertexId v) const { return v.index() >= 0 && v.index() < vertex_capacity() && out_[v.slot()].valid(); }
  bool is_live(HalfEdgeId h) const { return h.index() >= 0 && h.index() < half_edge_capacity() && origin(h).valid(); }
  bool is_live(FaceId f) const { return f.valid() && is_live(HalfEdgeId(4 * f.index())); }

  // Makes room: as long as no more elements than these are live, no operation allocates memory.
  void reserve(int faces, int vertices);
  // Memory of the arrays, with the room that is not in use.
  std::size_t bytes() const;

  // The live elements in the order of their indices. O(capacity).
  std::vector<VertexId> vertices() const;
  std::vector<FaceId> faces() const;
  std::vector<HalfEdgeId> half_edges() const;

  // Connectivity. O(1). Preconditions: the element is live, and a corner is in 0..3.
  static HalfEdgeId next(HalfEdgeId h) { return HalfEdgeId((h.index() & ~3) | ((h.index() + 1) & 3)); }
  static HalfEdgeId previous(HalfEdgeId h) { return HalfEdgeId((h.index() & ~3) | ((h.index() + 3) & 3)); }
  static HalfEdgeId opposite(HalfEdgeId h) { return HalfEdgeId(h.index() ^ 2); }  // across the face
  static FaceId face(HalfEdgeId h) { return FaceId(h.index() >> 2); }
  static HalfEdgeId half_edge(FaceId f, int corner = 0) { return HalfEdgeId(4 * f.index() + corner); }
  HalfEdgeId twin(HalfEdgeId h) const { return sides_[h.slot()].twin; }
  VertexId origin(HalfEdgeId h) const { return sides_[h.slot()].origin; }
  VertexId target(HalfEdgeId h) const { return origin(next(h)); }
  HalfEdgeId out(VertexId v) const { return out_[v.slot()]; }
  bool is_boundary(HalfEdgeId h) const { return !twin(h).valid(); }
  bool is_boundary(VertexId v) const { return is_boundary(out(v)); }
  std::array<VertexId, 4> corners(FaceId f) const;

  // The next half-edge out of the same vertex, counter-clockwise or clockwise; none beyond the ends of a boundary fan.
  HalfEdgeId ccw(HalfEdgeId h) const { return twin(previous(h)); }
  HalfEdgeId cw(HalfEdgeId h) const {
    const HalfEdgeId t = twin(h);
    return t.valid() ? next(t) : t;
  }
  // The half-edge that continues h straight: it leaves target(h) opposite h. Precondition: target(h) is regular.
  HalfEdgeId straight(HalfEdgeId h) const { return next(twin(next(h))); }
  // The next half-edge on the same boundary loop, which has the mesh on its left. Precondition: is_boundary(h).
  HalfEdgeId next_on_boundary(HalfEdgeId h) const { return out(target(h)); }

  // Calls visit(h) for each half-edge out of v, counter-clockwise from out(v). The last edge of a boundary vertex has
  // no half-edge out of it; its half-edge into v is previous() of the last one visited. Precondition: v is live.
  template <class Visit>
  void for_each_out(VertexId v, Visit&& visit) const {
    const HalfEdgeId first = out(v);
    HalfEdgeId h = first;
    do {
      visit(h);
      h = ccw(h);
    } while (h.valid() && h != first);
  }
  // The vertices that edges join to v, counter-clockwise from target(out(v)).
  std::vector<VertexId> neighbours(VertexId v) const;
  // The number of edges at v, and of faces at v, which is one less on the boundary. O(valence).
  int valence(VertexId v) const { return face_valence(v) + (is_boundary(v) ? 1 : 0); }
  int face_valence(VertexId v) const {
    int count = 0;
    for_each_out(v, [&count](HalfEdgeId) { ++count; });
    return count;
  }
  // Whether an edge joins a and b. O(valence of a).
  bool adjacent(VertexId a, VertexId b) const;
  // Whether an edge joins origin(h) and v; the fastest where h is at hand. O(valence).
  bool joined(HalfEdgeId h, VertexId v) const {
    // Goes both ways round until the two meet or reach the boundary, so that neither waits for the other's loads.
    HalfEdgeId left = h;
    HalfEdgeId right = h;
    do {
      if (target(right) == v || origin(previous(left)) == v) return true;
      left = ccw(left);
      if (left == right) return false;
      right = cw(right);
      if (left == right) return false;
    } while (left.valid() && right.valid());
    for (; left.valid(); left = ccw(left)) {
      if (origin(previous(left)) == v) return true;
    }
    for (; right.valid(); right = cw(right)) {
      if (target(right) == v) return true;
    }
    return false;
  }
  // The half-edge a -> b, or none. O(valence of a).
  HalfEdgeId find_half_edge(VertexId a, VertexId b) const;

  // The live faces, in order, as vertex numbers: the live vertices are numbered from 0 in order. For files and tests.
  std::vector<std::array<int, 4>> compact_faces() const;

  // This mesh with other ids, of which the listed ones are free. The vertices and faces take the ids that are not
  // listed, in order; the corners of faces stay as they are. The listed ids are handed out from the back. So a mesh
  // that was written and read again gets back the ids that it had. Precondition: this mesh has no free ids. Throws
  // MeshError if a list names an id twice, or one that is not below the number of live and free ones together.
  // O(V + F).
  QuadMesh with_free_ids(std::vector<FaceId> free_faces, std::vector<VertexId> free_vertices) const;

  // Whether the meshes have the same elements with the same ids, and will hand out the same ids next. (Isomorphism:
  // signature.hpp.) The choice of out(v) for interior v does not matter, nor does room at the end of the arrays.
  friend bool operator==(const QuadMesh& a, const QuadMesh& b);

 private:
  friend class MeshSurgery;

  struct Side {
    HalfEdgeId twin;
    VertexId origin;  // none marks a deleted face

    friend bool operator==(const Side&, const Side&) = default;
  };

  // Pairs the half-edges of faces that are filled in. Returns false if an edge has more than two faces, or two that are
  // not oriented alike. `degree`: the number of faces at each vertex.
  bool pair_twins(const std::vector<int>& degree);

  std::vector<Side> sides_;         // by half-edge
  std::vector<HalfEdgeId> out_;     // by vertex; none marks a deleted vertex
  std::vector<FaceId> free_faces_;  // last in, first out: so an operation and its inverse restore every id
  std::vector<VertexId> free_vertices_;
};

// Whether v is interior and its valence is not 4. O(valence).
inline bool is_irregular(const QuadMesh& mesh, VertexId v) { return !mesh.is_boundary(v) && mesh.face_valence(v) != 4; }
std::vector<VertexId> irregular_vertices(const QuadMesh& mesh);
std::multiset<int> sorted_irregular_valences(const QuadMesh& mesh);
// Whether origin(h) is interior and of valence 4. Follows at most four half-edges, whatever the valence.
// Precondition: h is live.
inline bool leaves_regular_vertex(const QuadMesh& mesh, HalfEdgeId h) {
  const HalfEdgeId second = mesh.ccw(h);
  if (!second.valid()) return false;
  const HalfEdgeId third = mesh.ccw(second);
  if (!third.valid() || third == h) return false;
  const HalfEdgeId fourth = mesh.ccw(third);
  return fourth.valid() && fourth != h && mesh.ccw(fourth) == h;
}

}  // namespace requad::mesh
