// The quad mesh with boundary.
//
// Representation. Every face is a quad, so half-edge h = 4 * face + k needs no next pointer: next(h) stays in the same
// group of four. What is left is two integers for each half-edge (twin, origin), one half-edge per vertex, and free lists
// of faces and vertices. Twin and origin lie side by side, so that a face is half a cache line: an operation at a random
// place of a large mesh waits for memory and for little else. A half-edge has its face on its left; faces are
// counter-clockwise.
//
//              d <--- c           h: a -> b, face f on the left
//              |  f   |           next(h): b -> c,  previous(h): d -> a
//              |      |           twin(h): b -> a in the face below, or none on the boundary
//              a -h-> b
//
// Invariants (validate.hpp checks each)
//   I1  twin is an involution without fixed points between live half-edges; origin(twin(h)) = origin(next(h)).
//   I2  the half-edges out of a vertex form one fan: a cycle if the vertex is interior, a path if it is on the boundary.
//   I3  out(v) of a boundary vertex is the fan's first half-edge, the one without twin; of an interior vertex, any.
//   I4  the mesh is simple: no edge joins a vertex to itself, no two edges join the same two vertices; so the four
//       vertices of a face differ. Interior valence 2 is allowed.
//
// Not required: a mesh need not be connected, nor have a boundary; any genus is welcome.
//
// Costs: traversal steps O(1); valence O(valence). Handles of untouched elements stay as they are under every operation.
#pragma once

#include <array>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh/topology/handles.hpp"

namespace requad::mesh {

// Input that is no quad mesh: the message is one line and names the face or vertex (0-based).
class MeshError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

class QuadMesh {
 public:
  QuadMesh() = default;

  // Builds a mesh from counter-clockwise faces, vertex indices in 0..vertex_count-1. Face i becomes FaceId(i), its
  // corner k half-edge 4 i + k. Throws MeshError if the faces break an invariant. O(F) for bounded genus.
  static QuadMesh from_faces(int vertex_count, std::span<const std::array<int, 4>> faces);
  // Takes the arrays as they are, broken or not: for tests of the validator. Entries of -1 mean none or deleted.
  // Precondition: as many twins as origins.
  static QuadMesh from_arrays_unchecked(const std::vector<HalfEdgeId>& twin, const std::vector<VertexId>& origin,
                                        std::vector<HalfEdgeId> out);

  // Live elements, and the sizes of the arrays (ids are below these).
  int vertex_count() const { return static_cast<int>(out_.size() - free_vertices_.size()); }
  int face_count() const { return static_cast<int>(sides_.size() / 4 - free_faces_.size()); }
  int edge_count() const;
  int vertex_capacity() const { return static_cast<int>(out_.size()); }
  int face_capacity() const { return static_cast<int>(sides_.size() / 4); }
  int half_edge_capacity() const { return static_cast<int>(sides_.size()); }

  bool is_live(VertexId v) const { return v.index() >= 0 && v.index() < vertex_capacity() && out_[v.slot()].valid(); }
  bool is_live(HalfEdgeId h) const { return h.index() >= 0 && h.index() < half_edge_capacity() && origin(h).valid(); }
  bool is_live(FaceId f) const { return f.valid() && is_live(HalfEdgeId(4 * f.index())); }

  // Room for so many live elements, so that operations which make no more of them allocate nothing.
  void reserve(int faces, int vertices);
  // Memory of the arrays, room included.
  std::size_t bytes() const;

  // Live elements in the order of their ids. O(capacity).
  std::vector<VertexId> vertices() const;
  std::vector<FaceId> faces() const;
  std::vector<HalfEdgeId> half_edges() const;

  // Connectivity of live elements; O(1).
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

  // The next half-edge out of the same vertex; none beyond the ends of a boundary fan.
  HalfEdgeId ccw(HalfEdgeId h) const { return twin(previous(h)); }
  HalfEdgeId cw(HalfEdgeId h) const {
    const HalfEdgeId t = twin(h);
    return t.valid() ? next(t) : t;
  }
  // Straight on: the half-edge that leaves target(h) opposite h. Precondition: target(h) is interior and of valence 4.
  HalfEdgeId straight(HalfEdgeId h) const { return next(twin(next(h))); }
  // On the boundary, the next boundary half-edge counter-clockwise round the mesh. Precondition: is_boundary(h).
  HalfEdgeId next_on_boundary(HalfEdgeId h) const { return out(target(h)); }

  // Calls visit(h) for the half-edges out of v, counter-clockwise from out(v). On the boundary the last edge of the fan
  // has no half-edge out of v; its half-edge into v is previous() of the last one visited. Precondition: v is live.
  template <class Visit>
  void for_each_out(VertexId v, Visit&& visit) const {
    const HalfEdgeId first = out(v);
    HalfEdgeId h = first;
    do {
      visit(h);
      h = ccw(h);
    } while (h.valid() && h != first);
  }
  // Neighbours of v, counter-clockwise, the last boundary neighbour included.
  std::vector<VertexId> neighbours(VertexId v) const;
  // Number of edges at v (l(v) in the paper), and of faces at v; they differ by one on the boundary.
  int valence(VertexId v) const { return face_valence(v) + (is_boundary(v) ? 1 : 0); }
  int face_valence(VertexId v) const;
  bool adjacent(VertexId a, VertexId b) const;
  // Whether an edge joins origin(h) and v.
  bool joined(HalfEdgeId h, VertexId v) const {
    // Both ways round at once, so that neither walk waits for the other's loads, until they meet or the boundary comes.
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
  // The half-edge a -> b, or none.
  HalfEdgeId find_half_edge(VertexId a, VertexId b) const;

  // The faces as vertex indices, for tests, files and rebuilding; ids of dead elements leave gaps in neither.
  std::vector<std::array<int, 4>> compact_faces() const;

  // This mesh, which must have no free ids, with some: its vertices and faces take in their order the ids that are not
  // listed, corners stay as they are, and the listed ids are handed out from the back. So a mesh that was written and
  // read again gets back the ids that it had. Throws MeshError if the lists name an id twice or one that is not below
  // the number of live and free ones. O(V + F).
  QuadMesh with_free_ids(std::vector<FaceId> free_faces, std::vector<VertexId> free_vertices) const;

  // The same mesh with the same ids, handing out the same ids next (see signature.hpp for isomorphism). Neither the
  // choice of out(v) for interior v nor room at the end of the arrays counts.
  friend bool operator==(const QuadMesh& a, const QuadMesh& b);

 private:
  friend class MeshSurgery;

  struct Side {
    HalfEdgeId twin;
    VertexId origin;  // none marks a deleted face

    friend bool operator==(const Side&, const Side&) = default;
  };

  std::vector<Side> sides_;         // per half-edge
  std::vector<HalfEdgeId> out_;     // per vertex; none marks a deleted vertex
  std::vector<FaceId> free_faces_;  // last in, first out, so that an operation and its inverse restore every id
  std::vector<VertexId> free_vertices_;
};

}  // namespace requad::mesh
