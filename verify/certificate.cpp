#include "verify/certificate.hpp"

#include <filesystem>
#include <map>

#include "mesh/program/errors.hpp"
#include "mesh/program/outputs.hpp"
#include "mesh/program/progress.hpp"
#include "theory/joined.hpp"

namespace requad::verify {

namespace {

using mesh::QuadMesh;
using mesh::VertexId;

// Names of a mesh's vertices in the certificate. The boundary comes first, from the root. A vertex keeps its name.
class Names {
 public:
  explicit Names(const mesh::Region& region) {
    for (const mesh::HalfEdgeId h : mesh::boundary_loop(region.mesh, region.root)) add(region.mesh.origin(h));
    for (const VertexId v : region.mesh.vertices()) {
      if (!region.mesh.is_boundary(v)) add(v);
    }
  }
  void add(VertexId v) { name_[v] = next_++; }  // a reused id stands for a new vertex
  std::string operator[](VertexId v) const { return std::to_string(name_.at(v)); }

 private:
  std::map<VertexId, int> name_;
  int next_ = 0;
};

std::string mesh_text(const mesh::Region& region) {
  const Names names(region);
  std::string text;
  for (const mesh::FaceId f : region.mesh.faces()) {
    const auto c = region.mesh.corners(f);
    text += names[c[0]] + " " + names[c[1]] + " " + names[c[2]] + " " + names[c[3]] + "\n";
  }
  return text;
}

// The script of a move in vertex names. The script is applied to a copy of the mesh it starts from.
std::string script_text(const mesh::Region& region, const std::vector<mesh::BasicOperation>& script) {
  using Kind = mesh::BasicOperation::Kind;
  QuadMesh m = region.mesh;
  Names names(region);
  std::string text;
  for (const mesh::BasicOperation& op : script) {
    const auto changed = mesh::changed_vertices(m, op);
    std::string line;
    if (op.kind == Kind::collapse) {
      const mesh::HalfEdgeId h = op.h;
      line = "collapse " + names[m.origin(h)] + " " + names[m.target(h)] + " " + names[m.target(m.next(h))] + " " +
             names[m.origin(m.previous(h))];
    } else if (op.kind == Kind::split) {
      line = "split " + names[changed[0]] + " " + names[changed[1]] + " " + names[changed[2]];
    } else {
      line = "flip " + names[changed[0]] + " " + names[changed[1]] + " " + names[changed[2]] + " " + names[changed[3]];
    }
    const mesh::Applied done = mesh::apply(m, op);
    if (op.kind == Kind::split) {
      const VertexId made = m.origin(QuadMesh::opposite(done.made));
      names.add(made);
      line += " " + names[made];
    }
    text += line + "\n";
  }
  return text;
}

}  // namespace

std::string certificate_text(const PairStudy& s) {
  std::string meshes, edges;
  int pairs = 0, merged = 0, edge_count = 0;
  for (std::size_t i = 0; i < s.found.nodes.size(); ++i) {
    const auto& node = s.found.nodes[i];
    const bool holds_pair = s.found.holds_pair(static_cast<int>(i));
    ++(holds_pair ? pairs : merged);
    meshes += "mesh " + std::to_string(i) + (holds_pair ? " pair " : " merged ") +
              theory::label(s.shape.type(), node.reading.configuration) + " vertices " +
              std::to_string(node.region.mesh.vertex_count()) + " faces " +
              std::to_string(node.region.mesh.face_count()) + "\n" + mesh_text(node.region);
  }
  // Writes one direction of each edge. A self-loop is met in both directions; every other one is written.
  std::map<int, bool> second_half;
  for (const enumerate::FoundMove& move : s.found.moves) {
    if (move.to < move.from) continue;  // refused, or the other direction
    if (move.to == move.from) {
      bool& second = second_half[move.from];
      second = !second;
      if (!second) continue;
    }
    ++edge_count;
    edges += "edge " + std::to_string(move.from) + " " + std::to_string(move.to) + " step " +
             mesh::name(move.move.step) + " operations " + std::to_string(move.script.size()) + "\n" +
             script_text(s.found.nodes[static_cast<std::size_t>(move.from)].region, move.script);
  }
  return "requad certificate 1\npair " + s.shape.type().name() + "\nsides " + theory::joined(s.shape.sides(), " ") +
         "\nconfigurations " + std::to_string(pairs) + "\nmerged " + std::to_string(merged) + "\nedges " +
         std::to_string(edge_count) + "\n" + meshes + edges + "end\n";
}

int write_certificates(const std::string& folder, const std::vector<RegionCase>& cases, bool quiet) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw program::UsageError(folder + ": " + error.message());
  program::Progress progress("certificates", static_cast<std::int64_t>(cases.size()), quiet);
  program::Outputs outputs;
  std::string manifest;
  int written = 0;
  for (const RegionCase& c : cases) {
    progress.advance();
    const auto* const pair = std::get_if<PairCase>(&c);
    if (pair == nullptr) continue;
    const PairStudy s = study_pair(pair->shape, {Method::moves});
    if (s.found.nodes.empty()) continue;
    const std::string file = s.shape.type().name() + "-" + theory::joined(s.shape.sides(), "-") + ".txt";
    outputs.add((std::filesystem::path(folder) / file).string(), certificate_text(s));
    manifest += file + "\n";
    ++written;
  }
  outputs.add((std::filesystem::path(folder) / "MANIFEST").string(), manifest);
  outputs.commit();
  return written;
}

}  // namespace requad::verify
