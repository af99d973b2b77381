#include "mesh/editing/script.hpp"

#include <algorithm>
#include <utility>

#include "mesh/editing/script_ids.hpp"
#include "mesh/text/number_text.hpp"
#include "mesh/text/text_scanner.hpp"

namespace requad::mesh {

using Eigen::Vector3d;
using Kind = BasicOperation::Kind;

namespace {

// The hash FNV-1a (G. Fowler, L. C. Noll, K.-P. Vo), of words whose lowest byte comes first.
class Fnv {
 public:
  void add(std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte, word >>= 8U) value_ = (value_ ^ (word & 0xffU)) * 0x100000001b3U;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

}  // namespace

MeshDigest digest(const QuadMesh& m, const Positions& positions) {
  Fnv fnv, faces;
  for (const VertexId v : m.vertices()) {
    for (const double coordinate : positions[v.slot()]) fnv.add(bits_of(coordinate));
  }
  for (const auto& face : m.compact_faces()) {
    for (const int corner : face) {
      fnv.add(static_cast<std::uint64_t>(corner));
      faces.add(static_cast<std::uint64_t>(corner));
    }
  }
  return {m.vertex_count(), m.face_count(), fnv.value(), faces.value()};
}

// --- recording -------------------------------------------------------------------------------------------------------

Script record_script(const QuadMesh& before, const Positions& positions, const Editor& editor) {
  Script script;
  script.before = digest(before, positions);
  script.after = digest(editor.mesh(), *editor.positions());
  // By slot, the position of the vertex after the edits so far. (The editor has the positions after all edits, when the
  // slot may belong to another vertex.)
  Positions now = positions;
  now.resize(editor.positions()->size(), Vector3d::Zero());
  for (const Edit& edit : editor.edits()) {
    const VertexId removed = edit.removed_vertex();
    const VertexId made = edit.made_vertex();
    const std::size_t operation = script.changes.size();
    if (edit.operates) {
      Change& change = script.changes.emplace_back();
      change.operation = edit.operation;
      change.inverse = edit.inverse;
      change.vertex = made.valid() ? made : removed;
      if (removed.valid()) change.from = now[removed.slot()];
    }
    for (const Placement& p : edit.placements) {
      Vector3d& at = now[p.vertex.slot()];
      if (p.vertex == made) {
        script.changes[operation].to = p.to;
      } else if (!same_bits(at, p.to)) {
        script.changes.push_back({0, {}, {}, p.vertex, at, p.to});
      }
      at = p.to;
    }
  }
  return script;
}

Script inverse(const Script& script) {
  Script result{script.name, script.after, script.before, {}, script.rounded};
  result.changes.reserve(script.changes.size());
  for (auto change = script.changes.rbegin(); change != script.changes.rend(); ++change) {
    Change& undo = result.changes.emplace_back(*change);
    if (undo.operation) std::swap(*undo.operation, undo.inverse);
    std::swap(undo.from, undo.to);
  }
  return result;
}

// --- replaying -------------------------------------------------------------------------------------------------------

namespace {

// Throws FileError unless the mesh that was found is the expected one of the two that a script leads between.
void check_mesh(const Script& script, const MeshDigest& expected, const MeshDigest& other, const MeshDigest& found) {
  if (found == expected) return;
  if (found == other)
    throw FileError(script.name + ": this mesh is the other end of the script, done or undone already");
  const auto sizes = [](const MeshDigest& d) {
    return std::to_string(d.vertices) + " vertices and " + std::to_string(d.faces) + " faces";
  };
  const bool alike = found.vertices == expected.vertices && found.faces == expected.faces;
  throw FileError(script.name + ": the script belongs to another mesh, " +
                  (alike ? "with as many vertices and faces as this one"
                         : "of " + sizes(expected) + "; this one has " + sizes(found)));
}

}  // namespace

void restore_ids(const Script& script, Surface& surface) {
  const MeshDigest found = digest(surface.mesh, surface.positions);
  if (!found.same_faces(script.after)) check_mesh(script, script.after, script.before, found);
  ScriptIds ids(script.before);
  for (const Change& change : script.changes) ids.advance(change);
  try {
    surface.mesh = surface.mesh.with_free_ids(std::move(ids.free_faces()), std::move(ids.free_vertices()));
  } catch (const MeshError& error) {
    throw FileError(script.name + ": " + error.what());
  }
  Positions positions(static_cast<std::size_t>(surface.mesh.vertex_capacity()), Vector3d::Zero());
  std::vector<int> file_vertex(positions.size(), -1);
  const std::vector<VertexId> vertices = surface.mesh.vertices();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    positions[vertices[i].slot()] = surface.positions[i];
    file_vertex[vertices[i].slot()] = surface.file_vertex[i];
  }
  for (int& slot : surface.from_file) slot = slot < 0 ? -1 : vertices[static_cast<std::size_t>(slot)].index();
  surface.positions = std::move(positions);
  surface.file_vertex = std::move(file_vertex);
  // Attributes of faces and corners go with the faces.
  const std::vector<FaceId> faces = surface.mesh.faces();
  const auto spread = [&faces](std::vector<int>& values, std::size_t each) {
    if (values.empty()) return;
    std::vector<int> now(each * (faces.empty() ? 0 : faces.back().slot() + 1), -1);
    for (std::size_t i = 0; i < std::min(values.size(), each * faces.size()); ++i)
      now[each * faces[i / each].slot() + i % each] = values[i];
    values = std::move(now);
  };
  spread(surface.attributes.state_of_face, 1);
  spread(surface.attributes.uvs.at_corner, 4);
  spread(surface.attributes.normals.at_corner, 4);
}

double accept_rounded(Script& script, Surface& surface) {
  const MeshDigest found = digest(surface.mesh, surface.positions);
  if (found == script.before || !found.same_faces(script.before)) return 0;
  // The first line that names a vertex says where it is.
  std::vector<bool> known(surface.positions.size(), false);
  const double most = kRoundingTolerance * bounding_box_diagonal(surface.mesh, surface.positions);
  double largest = 0;
  VertexId farthest;
  Positions exact = surface.positions;
  for (const Change& change : script.changes) {
    const VertexId v = change.vertex;
    if (!v.valid() || v.slot() >= known.size() || known[v.slot()]) continue;
    known[v.slot()] = true;
    if (change.operation && change.operation->kind == Kind::split) continue;  // the vertex is made here
    exact[v.slot()] = change.from;
    const double distance = (change.from - surface.positions[v.slot()]).norm();
    if (distance <= largest) continue;
    largest = distance;
    farthest = v;
  }
  if (!(largest <= most)) {
    const auto number = [](double x) {
      std::string text;
      append_number(text, static_cast<float>(x));
      return text;
    };
    throw FileError(script.name + ": vertex " + std::to_string(surface.file_vertex[farthest.slot()] + 1) +
                    " of the mesh is " + number(largest) + " from where the script has it; at most " + number(most) +
                    " is taken for rounding");
  }
  surface.positions = std::move(exact);
  script.rounded = true;
  return largest;
}

namespace {

class Replayer {
 public:
  Replayer(Editor& editor, const Script& script) : editor_(editor), m_(editor.mesh()), script_(script) {}

  Replay run() {
    if (!is_mesh(script_.before)) check_mesh(script_, script_.before, script_.after, digest(m_, *editor_.positions()));
    const std::size_t mark = editor_.mark();
    try {
      for (const Change& change : script_.changes) {
        const Refusal refusal = change.operation ? operate(change) : move(change);
        if (refusal == Refusal::none) continue;
        editor_.roll_back(mark);
        return {refusal, change.line};
      }
      if (!is_mesh(script_.after))
        throw FileError(script_.name + ": the script does not lead to the mesh that it says");
    } catch (...) {
      editor_.roll_back(mark);
      throw;
    }
    return {};
  }

 private:
  bool is_mesh(const MeshDigest& expected) const {
    const MeshDigest found = digest(m_, *editor_.positions());
    return script_.rounded ? found.same_faces(expected) : found == expected;
  }
  [[noreturn]] void fail(const Change& change, const std::string& reason) const {
    TextScanner::fail(script_.name, change.line, reason);
  }
  // Fails unless the vertex is where the script says that it was.
  void check_position(const Change& change) const {
    if (!same_bits((*editor_.positions())[change.vertex.slot()], change.from))
      fail(change, "vertex " + std::to_string(change.vertex.index()) + " is not where the script says");
  }

  Refusal operate(const Change& change) {
    const Refusal refusal = editor_.why_not(*change.operation);
    if (refusal == FeatureRefusal::breaks_feature) return refusal;
    if (refusal != Refusal::none) fail(change, std::string(refusal.clause()));
    if (change.operation->kind == Kind::collapse) {
      if (m_.origin(QuadMesh::opposite(change.operation->h)) != change.vertex)
        fail(change, "the collapse does not remove vertex " + std::to_string(change.vertex.index()));
      check_position(change);
    }
    const Applied done = editor_.replay(*change.operation, change.to);
    if (done.inverse != change.inverse) fail(change, "the operation is undone by " + to_string(done.inverse));
    if (change.operation->kind == Kind::split && editor_.edits().back().made_vertex() != change.vertex)
      fail(change, "the split does not make vertex " + std::to_string(change.vertex.index()));
    return Refusal::none;
  }

  Refusal move(const Change& change) {
    const VertexId v = change.vertex;
    if (!m_.is_live(v)) fail(change, "there is no vertex " + std::to_string(v.index()) + " any more");
    if (m_.is_boundary(v)) fail(change, "vertex " + std::to_string(v.index()) + " lies on the boundary");
    if (editor_.sectors().is_feature(v)) return FeatureRefusal::moves_feature;
    check_position(change);
    editor_.place(v, change.to);
    return Refusal::none;
  }

  Editor& editor_;
  const QuadMesh& m_;
  const Script& script_;
};

}  // namespace

Replay replay(Editor& editor, const Script& script) { return Replayer(editor, script).run(); }

}  // namespace requad::mesh
