// The basic operations by OpenMesh, and the same file read and written (-DREQUAD_BENCH_PEERS=ON).
//
// "edges" uses remove_edge and insert_edge. OpenMesh has collapses, but it splits vertices of triangle meshes only.
// "setters" changes next, face, target and the half-edges of vertices and faces one by one. Neither tests whether the
// result is a simple mesh.
//
// Debian's OpenMesh library is built with assertions. Its headers are compiled here, with this program's flags.

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include "bench/file_bench.hpp"
#include "bench/operation_bench.hpp"
#include "bench/peer_subject.hpp"

namespace requad::bench {
namespace {

struct OpenMeshLibrary {
  using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;
  using Site = OpenMesh::HalfedgeHandle;
  using Vertex = OpenMesh::VertexHandle;
  using Face = OpenMesh::FaceHandle;

  void reserve() {
    mesh.request_vertex_status();
    mesh.request_edge_status();
    mesh.request_halfedge_status();
    mesh.request_face_status();
  }
  static Vertex vertex(int i) { return Vertex(i); }
  void add_vertex() { mesh.add_vertex(Mesh::Point(0, 0, 0)); }
  void add_face(Vertex a, Vertex b, Vertex c, Vertex d) { mesh.add_face(a, b, c, d); }
  Site between(Vertex a, Vertex b) { return mesh.find_halfedge(a, b); }
  Site next(Site h) const { return mesh.next_halfedge_handle(h); }
  Site previous(Site h) const { return mesh.prev_halfedge_handle(h); }
  Site opposite(Site h) const { return mesh.opposite_halfedge_handle(h); }
  Face face(Site h) const { return mesh.face_handle(h); }
  Vertex source(Site h) const { return mesh.from_vertex_handle(h); }
  Vertex target(Site h) const { return mesh.to_vertex_handle(h); }
  Site first(Face f) const { return mesh.halfedge_handle(f); }
  template <class Visit>
  void for_each_face(Visit&& visit) const {
    for (int f = 0; f < static_cast<int>(mesh.n_faces()); ++f) {
      if (!mesh.status(Face(f)).deleted()) visit(Face(f));
    }
  }
  void link(Site a, Site b) { mesh.set_next_halfedge_handle(a, b); }
  void set_face(Site h, Face f) { mesh.set_face_handle(h, f); }
  void set_target(Site h, Vertex v) { mesh.set_vertex_handle(h, v); }
  void set_first(Face f, Site h) { mesh.set_halfedge_handle(f, h); }
  void replace_out(Vertex v, Site out, Site other) {
    if (mesh.halfedge_handle(v) == out) mesh.set_halfedge_handle(v, other);
  }

  Mesh mesh;
};

struct OpenMeshEdges : PeerSubject<OpenMeshLibrary> {
  static constexpr const char* kName = "openmesh_edges";
  using PeerSubject::PeerSubject;

  Site flip(Site h) {
    const Site u_r = next(opposite(h)), p_q = next(next(h));
    mesh.remove_edge(mesh.edge_handle(h));
    return mesh.insert_edge(u_r, p_q);
  }
  Site flip_back(Site h) {
    const Site q_u = previous(previous(h)), v_p = previous(opposite(h));
    mesh.remove_edge(mesh.edge_handle(h));
    return mesh.insert_edge(q_u, v_p);
  }
};

struct OpenMeshSetters : SetterSubject<OpenMeshLibrary> {
  static constexpr const char* kName = "openmesh_setters";
  using SetterSubject::SetterSubject;
  // What the split needs to restore a collapse: a half-edge of the face, the twins of two others, and the vertex.
  struct Undo {
    Site h, bc, cd;
    Vertex c;
  };

  Undo collapse(Site h) {
    const Site h1 = next(h), h2 = next(h1), h3 = next(h2), bc = opposite(h1), cd = opposite(h2);
    const auto a = target(h3), b = target(h), c = target(h1), d = target(h2);
    for (Site x = bc; x != h2; x = opposite(previous(x))) set_target(previous(x), a);
    const auto beside_bc = face(bc), beside_cd = face(cd);
    const Site before_bc = previous(bc), after_bc = next(bc), before_cd = previous(cd), after_cd = next(cd);
    link(before_bc, h), link(h, after_bc), link(before_cd, h3), link(h3, after_cd);
    set_face(h, beside_bc), set_face(h3, beside_cd);
    set_first(beside_bc, h), set_first(beside_cd, h3);
    replace_out(b, h1, opposite(h)), replace_out(d, cd, h3);
    set_deleted(h1, h2, c, true);
    return {h, bc, cd, c};
  }
  Site split(const Undo& undo) {
    const auto [h, bc, cd, c] = undo;
    const Site h1 = opposite(bc), h2 = opposite(cd), h3 = next(h2);
    const auto beside_bc = face(h), beside_cd = face(h3), f = face(h1);
    const Site before_bc = previous(h), after_bc = next(h), before_cd = previous(h3), after_cd = next(h3);
    link(before_bc, bc), link(bc, after_bc), link(before_cd, cd), link(cd, after_cd);
    set_face(bc, beside_bc), set_face(cd, beside_cd);
    set_first(beside_bc, bc), set_first(beside_cd, cd);
    link(h, h1), link(h2, h3), link(h3, h);
    set_face(h, f), set_face(h3, f);
    for (Site x = bc; x != h2; x = opposite(previous(x))) set_target(previous(x), c);
    mesh.set_halfedge_handle(target(h3), h), mesh.set_halfedge_handle(c, bc), set_first(f, h);
    set_deleted(h1, h2, c, false);
    return h;
  }

 private:
  // h1 keeps the handle of its face, which split() reads there.
  void set_deleted(Site h1, Site h2, Vertex c, bool deleted) {
    mesh.status(mesh.edge_handle(h1)).set_deleted(deleted), mesh.status(mesh.edge_handle(h2)).set_deleted(deleted);
    mesh.status(mesh.face_handle(h1)).set_deleted(deleted), mesh.status(c).set_deleted(deleted);
  }
};

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};

// How long does OpenMesh take to read an OBJ and to write it again? It tests edges and vertices as it adds faces, and
// writes as many digits as it takes to read the same numbers again.
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
  count_file_quads(state);
}
BENCHMARK(openmesh_read_and_write)->Name("obj_read_and_write/openmesh")->Apply(sides);

const int registered_openmesh = [] {
  register_operations<OpenMeshEdges>();
  register_operations<OpenMeshSetters>();
  return 0;
}();

}  // namespace
}  // namespace requad::bench
