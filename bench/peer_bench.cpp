// The same operations and the same file through CGAL and OpenMesh (-DREQUAD_BENCH_PEERS=ON).
//
// "euler", "edges" are what the libraries offer for it: CGAL's Euler operations, OpenMesh's remove_edge and
// insert_edge. OpenMesh has collapses, but a split of a vertex for triangles only. "setters" change next, face, target
// and the half-edges of vertices and faces one by one, as one has to where no such operation fits. None of them tests
// whether the result is a simple mesh.
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
  Site next(Site h) const { return mesh.next(h); }
  Site prev(Site h) const { return mesh.prev(h); }
  Site opposite(Site h) const { return mesh.opposite(h); }
  auto face(Site h) const { return mesh.face(h); }
  auto target(Site h) const { return mesh.target(h); }
  void link(Site a, Site b) { mesh.set_next(a, b); }
  void set_face(Site h, Mesh::Face_index f) { mesh.set_face(h, f); }
  void set_target(Site h, Mesh::Vertex_index v) { mesh.set_target(h, v); }
  void set_halfedge(Mesh::Face_index f, Site h) { mesh.set_halfedge(f, h); }
  // Should the vertex keep this half-edge out of it, it keeps another. CGAL keeps the one into the vertex.
  void replace_out(Mesh::Vertex_index v, Site out, Site other) {
    if (mesh.halfedge(v) == opposite(out)) mesh.set_halfedge(v, opposite(other));
  }
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
  // Into the two vertices that part: the last half-edge that the old one keeps, the last that the new one takes,
  // clockwise.
  struct Undo {
    Site kept, taken;
  };

  Site flip(Site h) {
    const Site v_p = next(h), u_r = next(opposite(h));
    CGAL::Euler::join_face(h, mesh);
    return CGAL::Euler::split_face(u_r, v_p, mesh);
  }
  Site flip_back(Site h) {
    const Site q_u = prev(prev(h)), s_v = prev(prev(opposite(h)));
    CGAL::Euler::join_face(h, mesh);
    return CGAL::Euler::split_face(q_u, s_v, mesh);
  }
  // A diagonal cuts the face a b c d into two triangles, which go when it collapses.
  Undo collapse(Site h) {
    const Site into_c = prev(opposite(next(h))), out_of_c = next(opposite(next(next(h))));
    const Site a_c = CGAL::Euler::split_face(prev(h), next(h), mesh);
    CGAL::Euler::collapse_edge(mesh.edge(a_c), mesh);
    return {prev(out_of_c), into_c};
  }
  // An edge opens between the parts; two triangles are cut off on either side of it, and joined.
  Site split(const Undo& undo) {
    const Site c_a = CGAL::Euler::split_vertex(undo.kept, undo.taken, mesh), a_b = next(c_a);
    CGAL::Euler::split_face(prev(undo.kept), opposite(c_a), mesh);
    CGAL::Euler::split_face(undo.taken, a_b, mesh);
    CGAL::Euler::join_face(c_a, mesh);
    return a_b;
  }
};

// Flips by setters, the same for both libraries.
template <class Library>
struct Setters : Library {
  using Library::Library;
  using typename Library::Site;

  Site flip(Site h) {
    Library& m = *this;
    const Site t = m.opposite(h), h1 = m.next(h), h2 = m.next(h1), h3 = m.next(h2);
    const Site t1 = m.next(t), t2 = m.next(t1), t3 = m.next(t2);
    const auto f = m.face(h), g = m.face(t);
    const auto u = m.target(t), v = m.target(h);
    m.link(t1, h), m.link(h, h2), m.link(h3, t1), m.link(h1, t), m.link(t, t2), m.link(t3, h1);
    m.set_face(t1, f), m.set_face(h1, g);
    m.set_target(h, m.target(h1)), m.set_target(t, m.target(t1));
    m.set_halfedge(f, h), m.set_halfedge(g, t);
    m.replace_out(u, h, t1), m.replace_out(v, t, h1);
    return h;
  }
  Site flip_back(Site h) {
    Library& m = *this;
    const Site t = m.opposite(h), t1 = m.prev(h), h1 = m.prev(t), h2 = m.next(h), t2 = m.next(t);
    const Site h3 = m.prev(t1), t3 = m.prev(h1);
    const auto f = m.face(h), g = m.face(t);
    const auto p = m.target(h), r = m.target(t);
    m.link(h3, h), m.link(h, h1), m.link(h1, h2), m.link(t3, t), m.link(t, t1), m.link(t1, t2);
    m.set_face(t1, g), m.set_face(h1, f);
    m.set_target(h, m.target(t3)), m.set_target(t, m.target(h3));
    m.set_halfedge(f, h), m.set_halfedge(g, t);
    m.replace_out(r, h, t2), m.replace_out(p, t, h2);
    return h;
  }
};

struct CgalSetters : Setters<CgalSubject> {
  static constexpr const char* kName = "cgal_setters";
  using Setters::Setters;
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
  auto face(Site h) const { return mesh.face_handle(h); }
  auto target(Site h) const { return mesh.to_vertex_handle(h); }
  void link(Site a, Site b) { mesh.set_next_halfedge_handle(a, b); }
  void set_face(Site h, OpenMesh::FaceHandle f) { mesh.set_face_handle(h, f); }
  void set_target(Site h, OpenMesh::VertexHandle v) { mesh.set_vertex_handle(h, v); }
  void set_halfedge(OpenMesh::FaceHandle f, Site h) { mesh.set_halfedge_handle(f, h); }
  void replace_out(OpenMesh::VertexHandle v, Site out, Site other) {
    if (mesh.halfedge_handle(v) == out) mesh.set_halfedge_handle(v, other);
  }
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

struct OpenMeshSetters : Setters<OpenMeshSubject> {
  static constexpr const char* kName = "openmesh_setters";
  using Setters::Setters;
  // What a collapse took out, to be put back: the face's half-edges, the twins that went, the vertex.
  struct Undo {
    Site h, bc, cd;
    OpenMesh::VertexHandle c;
  };

  Undo collapse(Site h) {
    const Site h1 = next(h), h2 = next(h1), h3 = next(h2), bc = opposite(h1), cd = opposite(h2);
    const auto a = target(h3), b = target(h), c = target(h1), d = target(h2);
    for (Site x = bc; x != h2; x = opposite(prev(x))) set_target(prev(x), a);
    const auto beside_bc = face(bc), beside_cd = face(cd);
    const Site before_bc = prev(bc), after_bc = next(bc), before_cd = prev(cd), after_cd = next(cd);
    link(before_bc, h), link(h, after_bc), link(before_cd, h3), link(h3, after_cd);
    set_face(h, beside_bc), set_face(h3, beside_cd);
    set_halfedge(beside_bc, h), set_halfedge(beside_cd, h3);
    replace_out(b, h1, opposite(h)), replace_out(d, cd, h3);
    set_deleted(h1, h2, c, true);
    return {h, bc, cd, c};
  }
  Site split(const Undo& undo) {
    const auto [h, bc, cd, c] = undo;
    const Site h1 = opposite(bc), h2 = opposite(cd), h3 = next(h2);
    const auto beside_bc = face(h), beside_cd = face(h3), f = face(h1);
    const Site before_bc = prev(h), after_bc = next(h), before_cd = prev(h3), after_cd = next(h3);
    link(before_bc, bc), link(bc, after_bc), link(before_cd, cd), link(cd, after_cd);
    set_face(bc, beside_bc), set_face(cd, beside_cd);
    set_halfedge(beside_bc, bc), set_halfedge(beside_cd, cd);
    link(h, h1), link(h2, h3), link(h3, h);
    set_face(h, f), set_face(h3, f);
    for (Site x = bc; x != h2; x = opposite(prev(x))) set_target(prev(x), c);
    mesh.set_halfedge_handle(target(h3), h), mesh.set_halfedge_handle(c, bc), set_halfedge(f, h);
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
    require(OpenMesh::IO::read_mesh(mesh, file.path()), "OpenMesh does not read the file");
    require(OpenMesh::IO::write_mesh(mesh, file.copy(), OpenMesh::IO::Options::Default, 17),
            "OpenMesh does not write it");
    faces = mesh.n_faces();
  }
  require(faces == static_cast<std::size_t>(state.range(0) * state.range(0)), "OpenMesh lacks faces");
  count_quads(state);
}
BENCHMARK(openmesh_read_and_write)->Name("obj_read_and_write/openmesh")->Apply(sides);

const int registered_peers = [] {
  register_operations<CgalEuler>();
  register_operations<CgalSetters>();
  register_operations<OpenMeshEdges>();
  register_operations<OpenMeshSetters>();
  return 0;
}();

}  // namespace
}  // namespace requad::bench
