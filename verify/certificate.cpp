#include "verify/certificate.hpp"

#include <array>
#include <filesystem>
#include <map>

#include "mesh/program/run/checksum.hpp"
#include "mesh/program/run/errors.hpp"
#include "mesh/program/run/outputs.hpp"
#include "mesh/program/run/progress.hpp"
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

// "mesh 0 pair (1,1) d1 1 d2 1 p 1 strips 2 2 vertices 20 faces 13"
std::string head_of_mesh(theory::PairType type, std::size_t i, const enumerate::FoundNode& node) {
  const theory::Configuration& c = node.reading.configuration;
  return "mesh " + std::to_string(i) + (c.merged() ? " merged " : " pair ") + theory::label(type, c) + " d1 " +
         std::to_string(c.d1()) + " d2 " + std::to_string(c.d2()) + " p " + std::to_string(c.p) + " strips " +
         theory::joined(c.parameters.e, " ") + " vertices " + std::to_string(node.region.mesh.vertex_count()) +
         " faces " + std::to_string(node.region.mesh.face_count()) + "\n";
}

// d1, d2 and p of a labelling at one end of a move. The merged vertex has the p of the other end.
std::string end_of_move(const theory::Configuration& labelling, const theory::Configuration& other) {
  const int p = labelling.merged() ? other.p : labelling.p;
  return std::to_string(labelling.d1()) + " " + std::to_string(labelling.d2()) + " " + std::to_string(p);
}

// "edge 0 1 step open from 1 1 1 to 2 2 1 operations 2". Precondition: the move was made, and its labellings were read.
std::string head_of_edge(const enumerate::FoundMove& move) {
  return "edge " + std::to_string(move.from) + " " + std::to_string(move.to) + " step " + mesh::name(move.move.step) +
         " from " + end_of_move(*move.before, *move.after) + " to " + end_of_move(*move.after, *move.before) +
         " operations " + std::to_string(move.script.size()) + "\n";
}

}  // namespace

std::string certificate_text(const PairStudy& s) {
  std::string meshes, edges;
  int pairs = 0, merged = 0, edge_count = 0;
  for (std::size_t i = 0; i < s.found.nodes.size(); ++i) {
    const auto& node = s.found.nodes[i];
    const bool holds_pair = s.found.holds_pair(static_cast<int>(i));
    ++(holds_pair ? pairs : merged);
    meshes += head_of_mesh(s.shape.type(), i, node) + mesh_text(node.region);
  }
  // Writes one direction of each edge. A self-loop is met in both directions; every other one is written.
  std::map<int, bool> second_half;
  for (const enumerate::FoundMove& move : s.found.moves) {
    if (move.to < move.from || !move.before || !move.after) continue;  // refused, or the other direction
    if (move.to == move.from) {
      bool& second = second_half[move.from];
      second = !second;
      if (!second) continue;
    }
    ++edge_count;
    edges += head_of_edge(move) + script_text(s.found.nodes[static_cast<std::size_t>(move.from)].region, move.script);
  }
  return "requad certificate 2\npair " + s.shape.type().name() + "\nsides " + theory::joined(s.shape.sides(), " ") +
         "\nconfigurations " + std::to_string(pairs) + "\nmerged " + std::to_string(merged) + "\nedges " +
         std::to_string(edge_count) + "\n" + meshes + edges + "end\n";
}

namespace {

// A family that is certified, by its name in the MANIFEST.
struct CertifiedFamily {
  Family family;
  const char* name;  // and what its range is of
  program::Range Ranges::*range;
};
constexpr std::array<CertifiedFamily, 5> kCertifiedFamilies{{
    {Family::regular_digon, "regular-digons sides", &Ranges::digon},
    {Family::regular_hexagon, "regular-hexagons sides", &Ranges::hexagon},
    {Family::quad, "3-5-regions perimeters", &Ranges::quad_perimeter},
    {Family::other_digon, "other-digons perimeters", &Ranges::other_perimeter},
    {Family::other_hexagon, "other-hexagons perimeters", &Ranges::other_perimeter},
}};

}  // namespace

std::set<Family> certified_families() {
  std::set<Family> families;
  for (const CertifiedFamily& certified : kCertifiedFamilies) families.insert(certified.family);
  return families;
}

int write_certificates(const std::string& folder, const Ranges& ranges, const std::set<Family>& families, bool quiet) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw program::UsageError(folder + ": " + error.message());
  std::string manifest = "requad manifest 2\n";
  std::set<Family> certified;
  for (const CertifiedFamily& f : kCertifiedFamilies) {
    if (families.count(f.family) == 0) continue;
    certified.insert(f.family);
    const program::Range& range = ranges.*f.range;
    manifest +=
        "family " + std::string(f.name) + " " + std::to_string(range.first) + ".." + std::to_string(range.last) + "\n";
  }
  const std::vector<RegionCase> cases = list_cases(ranges, certified);
  program::Progress progress("certificates", static_cast<std::int64_t>(cases.size()), quiet);
  program::Outputs outputs;
  std::string entries;
  int written = 0;
  const double all = cost_estimate(cases);
  for (const RegionCase& c : cases) {
    progress.advance(1, cost_estimate(c) / all);
    const PairStudy s = study_pair(std::get<PairCase>(c).shape, {Method::moves});
    if (s.pairs_found() == 0) continue;
    const std::string file = s.shape.type().name() + "-" + theory::joined(s.shape.sides(), "-") + ".txt";
    const std::string text = certificate_text(s);
    program::Checksum checksum;
    checksum.add(text);
    entries += file + " " + checksum.text() + "\n";
    outputs.add((std::filesystem::path(folder) / file).string(), text);
    ++written;
  }
  manifest += "certificates " + std::to_string(written) + "\n" + entries + "end\n";
  outputs.add((std::filesystem::path(folder) / "MANIFEST").string(), manifest);
  outputs.commit();
  return written;
}

}  // namespace requad::verify
