// The basic operations by CGAL (-DREQUAD_BENCH_PEERS=ON).
//
// "euler" uses CGAL's Euler operations. "setters" changes next, face, target and the half-edges of vertices and faces
// one by one, as a program must where no such operation fits. Neither tests whether the result is a simple mesh.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include "bench/operation_bench.hpp"
#include "bench/peer_subject.hpp"

namespace requad::bench {
namespace {

struct Cgal {
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  using Site = Mesh::Halfedge_index;
  using Vertex = Mesh::Vertex_index;
  using Face = Mesh::Face_index;

  void reserve() {}
  static Vertex vertex(int i) { return Vertex(static_cast<Mesh::size_type>(i)); }
  void add_vertex() { mesh.add_vertex({}); }
  void add_face(Vertex a, Vertex b, Vertex c, Vertex d) { mesh.add_face(a, b, c, d); }
  Site between(Vertex a, Vertex b) const { return mesh.halfedge(a, b); }
  Site next(Site h) const { return mesh.next(h); }
  Site previous(Site h) const { return mesh.prev(h); }
  Site opposite(Site h) const { return mesh.opposite(h); }
  Face face(Site h) const { return mesh.face(h); }
  Vertex source(Site h) const { return mesh.source(h); }
  Vertex target(Site h) const { return mesh.target(h); }
  Site first(Face f) const { return mesh.halfedge(f); }
  template <class Visit>
  void for_each_face(Visit&& visit) const {
    for (const Face f : mesh.faces()) visit(f);
  }
  void link(Site a, Site b) { mesh.set_next(a, b); }
  void set_face(Site h, Face f) { mesh.set_face(h, f); }
  void set_target(Site h, Vertex v) { mesh.set_target(h, v); }
  void set_first(Face f, Site h) { mesh.set_halfedge(f, h); }
  // For each vertex CGAL keeps a half-edge into it, where our interface has one out of it.
  void replace_out(Vertex v, Site out, Site other) {
    if (mesh.halfedge(v) == opposite(out)) mesh.set_halfedge(v, opposite(other));
  }

  Mesh mesh;
};

struct CgalEuler : PeerSubject<Cgal> {
  static constexpr const char* kName = "cgal_euler";
  using PeerSubject::PeerSubject;
  // Two half-edges into the vertex that a split parts. Clockwise, they are the last one that the old vertex keeps and
  // the last one that the new vertex takes.
  struct Undo {
    Site kept, taken;
  };

  Site flip(Site h) {
    const Site v_p = next(h), u_r = next(opposite(h));
    CGAL::Euler::join_face(h, mesh);
    return CGAL::Euler::split_face(u_r, v_p, mesh);
  }
  Site flip_back(Site h) {
    const Site q_u = previous(previous(h)), s_v = previous(previous(opposite(h)));
    CGAL::Euler::join_face(h, mesh);
    return CGAL::Euler::split_face(q_u, s_v, mesh);
  }
  // A diagonal cuts the face a b c d into two triangles, which vanish when the diagonal collapses.
  Undo collapse(Site h) {
    const Site into_c = previous(opposite(next(h))), out_of_c = next(opposite(next(next(h))));
    const Site a_c = CGAL::Euler::split_face(previous(h), next(h), mesh);
    CGAL::Euler::collapse_edge(mesh.edge(a_c), mesh);
    return {previous(out_of_c), into_c};
  }
  // An edge opens between the two parts. A triangle is cut off on either side of it, and the triangles are joined.
  Site split(const Undo& undo) {
    const Site c_a = CGAL::Euler::split_vertex(undo.kept, undo.taken, mesh), a_b = next(c_a);
    CGAL::Euler::split_face(previous(undo.kept), opposite(c_a), mesh);
    CGAL::Euler::split_face(undo.taken, a_b, mesh);
    CGAL::Euler::join_face(c_a, mesh);
    return a_b;
  }
};

struct CgalSetters : SetterSubject<Cgal> {
  static constexpr const char* kName = "cgal_setters";
  using SetterSubject::SetterSubject;
};

const int registered_cgal = [] {
  register_operations<CgalEuler>();
  register_operations<CgalSetters>();
  return 0;
}();

}  // namespace
}  // namespace requad::bench
