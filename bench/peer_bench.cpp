// The same operations and the same file through CGAL and OpenMesh (-DREQUAD_BENCH_PEERS=ON).
//
// "euler", "edges" are what the libraries offer for it: CGAL's Euler::join_face and split_face, OpenMesh's remove_edge
// and insert_edge. "setters" change next, face, target and the half-edges of vertices and faces one by one, as one has
// to where no such operation fits. None of them tests whether the result is a simple mesh.
//
// Debian's OpenMesh library is built with assertions; its headers are compiled here, with this program's flags.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include "bench/file_bench.hpp"
#include "bench/operation_bench.hpp"

namespace requad::bench {
namespace {

struct CgalSubject {
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  using Site = Mesh::Halfedge_index;

  explicit CgalSubject(int n) {
    for (int v = 0; v < n * n; ++v) mesh.add_vertex({});
    for (const auto& [a, b, c, d] : torus_faces(n)) mesh.add_face(vertex(a), vertex(b), vertex(c), vertex(d));
  }
  static Mesh::Vertex_index vertex(int v) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(v)); }
  Site site(int a, int b) const { return mesh.halfedge(vertex(a), vertex(b)); }
  FaceList faces() const {
    FaceList list;
    for (const auto f : mesh.faces()) {
      auto& face = list.emplace_back();
      Site h = mesh.halfedge(f);
      for (int& v : face) v = static_cast<int>(mesh.source(h)), h = mesh.next(h);
    }
    return list;
  }

  Mesh mesh;
};

struct CgalEuler : CgalSubject {
  static constexpr const char* kName = "cgal_euler";
  using CgalSubject::CgalSubject;
  Site flip(Site h) {
    const Site v_p = mesh.next(h), u_r = mesh.next(mesh.opposite(h));
    CGAL::Euler::join_face(h, mesh);
    return CGAL::Euler::split_face(u_r, v_p, mesh);
  }
  Site flip_back(Site h) {
    const Site q_u = mesh.prev(mesh.prev(h)), s_v = mesh.prev(mesh.prev(mesh.opposite(h)));
    CGAL::Euler::join_face(h, mesh);
    return CGAL::Euler::split_face(q_u, s_v, mesh);
  }
};

struct CgalSetters : CgalSubject {
  static constexpr const char* kName = "cgal_setters";
  using CgalSubject::CgalSubject;
  Site flip(Site h) {
    const Site t = mesh.opposite(h), h1 = mesh.next(h), h2 = mesh.next(h1), h3 = mesh.next(h2);
    const Site t1 = mesh.next(t), t2 = mesh.next(t1), t3 = mesh.next(t2);
    const auto f = mesh.face(h), g = mesh.face(t);
    const auto u = mesh.target(t), v = mesh.target(h);
    mesh.set_next(t1, h), mesh.set_next(h, h2), mesh.set_next(h3, t1);
    mesh.set_next(h1, t), mesh.set_next(t, t2), mesh.set_next(t3, h1);
    mesh.set_face(t1, f), mesh.set_face(h1, g);
    mesh.set_target(h, mesh.target(h1)), mesh.set_target(t, mesh.target(t1));
    mesh.set_halfedge(f, h), mesh.set_halfedge(g, t);
    if (mesh.halfedge(v) == h) mesh.set_halfedge(v, t3);
    if (mesh.halfedge(u) == t) mesh.set_halfedge(u, h3);
    return h;
  }
  Site flip_back(Site h) {
    const Site t = mesh.opposite(h), t1 = mesh.prev(h), h1 = mesh.prev(t), h2 = mesh.next(h), t2 = mesh.next(t);
    const Site h3 = mesh.prev(t1), t3 = mesh.prev(h1);
    const auto f = mesh.face(h), g = mesh.face(t);
    const auto p = mesh.target(h), r = mesh.target(t);
    mesh.set_next(h3, h), mesh.set_next(h, h1), mesh.set_next(h1, h2);
    mesh.set_next(t3, t), mesh.set_next(t, t1), mesh.set_next(t1, t2);
    mesh.set_face(t1, g), mesh.set_face(h1, f);
    mesh.set_target(h, mesh.target(t3)), mesh.set_target(t, mesh.target(h3));
    mesh.set_halfedge(f, h), mesh.set_halfedge(g, t);
    if (mesh.halfedge(p) == h) mesh.set_halfedge(p, h1);
    if (mesh.halfedge(r) == t) mesh.set_halfedge(r, t1);
    return h;
  }
};

struct OpenMeshSubject {
  using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;
  using Site = OpenMesh::HalfedgeHandle;

  explicit OpenMeshSubject(int n) {
    mesh.request_vertex_status(), mesh.request_edge_status(), mesh.request_halfedge_status();
    mesh.request_face_status();
    for (int v = 0; v < n * n; ++v) mesh.add_vertex(Mesh::Point(0, 0, 0));
    for (const auto& [a, b, c, d] : torus_faces(n)) mesh.add_face(vertex(a), vertex(b), vertex(c), vertex(d));
  }
  static OpenMesh::VertexHandle vertex(int v) { return OpenMesh::VertexHandle(v); }
  Site site(int a, int b) { return mesh.find_halfedge(vertex(a), vertex(b)); }
  Site next(Site h) const { return mesh.next_halfedge_handle(h); }
  Site prev(Site h) const { return mesh.prev_halfedge_handle(h); }
  Site opposite(Site h) const { return mesh.opposite_halfedge_handle(h); }
  FaceList faces() const {
    FaceList list;
    for (int f = 0; f < static_cast<int>(mesh.n_faces()); ++f) {
      const OpenMesh::FaceHandle handle(f);
      if (mesh.status(handle).deleted()) continue;
      auto& face = list.emplace_back();
      Site h = mesh.halfedge_handle(handle);
      for (int& v : face) v = mesh.from_vertex_handle(h).idx(), h = next(h);
    }
    return list;
  }

  Mesh mesh;
};

struct OpenMeshEdges : OpenMeshSubject {
  static constexpr const char* kName = "openmesh_edges";
  using OpenMeshSubject::OpenMeshSubject;
  Site flip(Site h) {
    const Site u_r = next(opposite(h)), p_q = next(next(h));
    mesh.remove_edge(mesh.edge_handle(h));
    return mesh.insert_edge(u_r, p_q);
  }
  Site flip_back(Site h) {
    const Site q_u = prev(prev(h)), v_p = prev(opposite(h));
    mesh.remove_edge(mesh.edge_handle(h));
    return mesh.insert_edge(q_u, v_p);
  }
};

struct OpenMeshSetters : OpenMeshSubject {
  static constexpr const char* kName = "openmesh_setters";
  using OpenMeshSubject::OpenMeshSubject;
  // What a collapse took out, to be put back: the face's half-edges, the twins that went, the vertex.
  struct Undo {
    Site h, bc, cd;
    OpenMesh::VertexHandle c;
  };
  void link(Site a, Site b) { mesh.set_next_halfedge_handle(a, b); }

  Site flip(Site h) {
    const Site t = opposite(h), h1 = next(h), h2 = next(h1), h3 = next(h2), t1 = next(t), t2 = next(t1), t3 = next(t2);
    const auto f = mesh.face_handle(h), g = mesh.face_handle(t);
    const auto u = mesh.to_vertex_handle(t), v = mesh.to_vertex_handle(h);
    link(t1, h), link(h, h2), link(h3, t1), link(h1, t), link(t, t2), link(t3, h1);
    mesh.set_face_handle(t1, f), mesh.set_face_handle(h1, g);
    mesh.set_vertex_handle(h, mesh.to_vertex_handle(h1)), mesh.set_vertex_handle(t, mesh.to_vertex_handle(t1));
    mesh.set_halfedge_handle(f, h), mesh.set_halfedge_handle(g, t);
    if (mesh.halfedge_handle(u) == h) mesh.set_halfedge_handle(u, t1);
    if (mesh.halfedge_handle(v) == t) mesh.set_halfedge_handle(v, h1);
    return h;
  }
  Site flip_back(Site h) {
    const Site t = opposite(h), t1 = prev(h), h1 = prev(t), h2 = next(h), t2 = next(t), h3 = prev(t1), t3 = prev(h1);
    const auto f = mesh.face_handle(h), g = mesh.face_handle(t);
    const auto p = mesh.to_vertex_handle(h), r = mesh.to_vertex_handle(t);
    link(h3, h), link(h, h1), link(h1, h2), link(t3, t), link(t, t1), link(t1, t2);
    mesh.set_face_handle(t1, g), mesh.set_face_handle(h1, f);
    mesh.set_vertex_handle(h, mesh.to_vertex_handle(t3)), mesh.set_vertex_handle(t, mesh.to_vertex_handle(h3));
    mesh.set_halfedge_handle(f, h), mesh.set_halfedge_handle(g, t);
    if (mesh.halfedge_handle(r) == h) mesh.set_halfedge_handle(r, t2);
    if (mesh.halfedge_handle(p) == t) mesh.set_halfedge_handle(p, h2);
    return h;
  }
  Undo collapse(Site h) {
    const Site h1 = next(h), h2 = next(h1), h3 = next(h2), bc = opposite(h1), cd = opposite(h2);
    const auto a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
    const auto c = mesh.to_vertex_handle(h1), d = mesh.to_vertex_handle(h2);
    for (Site x = bc; x != h2; x = opposite(prev(x))) mesh.set_vertex_handle(prev(x), a);
    const auto beside_bc = mesh.face_handle(bc), beside_cd = mesh.face_handle(cd);
    const Site before_bc = prev(bc), after_bc = next(bc), before_cd = prev(cd), after_cd = next(cd);
    link(before_bc, h), link(h, after_bc), link(before_cd, h3), link(h3, after_cd);
    mesh.set_face_handle(h, beside_bc), mesh.set_face_handle(h3, beside_cd);
    mesh.set_halfedge_handle(beside_bc, h), mesh.set_halfedge_handle(beside_cd, h3);
    if (mesh.halfedge_handle(b) == h1) mesh.set_halfedge_handle(b, opposite(h));
    if (mesh.halfedge_handle(d) == cd) mesh.set_halfedge_handle(d, h3);
    set_deleted(h1, h2, c, true);
    return {h, bc, cd, c};
  }
  Site split(const Undo& undo) {
    const auto [h, bc, cd, c] = undo;
    const Site h1 = opposite(bc), h2 = opposite(cd), h3 = next(h2);
    const auto beside_bc = mesh.face_handle(h), beside_cd = mesh.face_handle(h3), f = mesh.face_handle(h1);
    const Site before_bc = prev(h), after_bc = next(h), before_cd = prev(h3), after_cd = next(h3);
    link(before_bc, bc), link(bc, after_bc), link(before_cd, cd), link(cd, after_cd);
    mesh.set_face_handle(bc, beside_bc), mesh.set_face_handle(cd, beside_cd);
    mesh.set_halfedge_handle(beside_bc, bc), mesh.set_halfedge_handle(beside_cd, cd);
    link(h, h1), link(h2, h3), link(h3, h);
    mesh.set_face_handle(h, f), mesh.set_face_handle(h3, f);
    for (Site x = bc; x != h2; x = opposite(prev(x))) mesh.set_vertex_handle(prev(x), c);
    const auto a = mesh.to_vertex_handle(h3);
    mesh.set_halfedge_handle(a, h), mesh.set_halfedge_handle(c, bc), mesh.set_halfedge_handle(f, h);
    set_deleted(h1, h2, c, false);
    return h;
  }

 private:
  // The face keeps its name in h1, where split() finds it.
  void set_deleted(Site h1, Site h2, OpenMesh::VertexHandle c, bool deleted) {
    mesh.status(mesh.edge_handle(h1)).set_deleted(deleted), mesh.status(mesh.edge_handle(h2)).set_deleted(deleted);
    mesh.status(mesh.face_handle(h1)).set_deleted(deleted), mesh.status(c).set_deleted(deleted);
  }
};

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};

// How long does OpenMesh take to read an OBJ, which tests edges and vertices as it adds faces, and to write it again
// with as many digits as give back the same bits?
void openmesh_read_and_write(benchmark::State& state) {
  const ObjFile file(static_cast<int>(state.range(0)));
  std::size_t faces = 0;
  for (auto _ : state) {
    OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits> mesh;
    if (!OpenMesh::IO::read_mesh(mesh, file.path())) state.SkipWithError("not read");
    if (!OpenMesh::IO::write_mesh(mesh, file.copy(), OpenMesh::IO::Options::Default, 17))
      state.SkipWithError("not written");
    faces = mesh.n_faces();
  }
  if (faces != static_cast<std::size_t>(state.range(0) * state.range(0))) state.SkipWithError("faces are missing");
  count_quads(state);
}
BENCHMARK(openmesh_read_and_write)->Name("obj_read_and_write/openmesh")->Apply(sides);

const int registered = [] {
  register_operations<CgalEuler>();
  register_operations<CgalSetters>();
  register_operations<OpenMeshEdges>();
  register_operations<OpenMeshSetters>();
  return 0;
}();

}  // namespace
}  // namespace requad::bench
