#include "mesh/editing/script.hpp"

#include <bit>
#include <utility>

#include "mesh/editing/script_ids.hpp"
#include "mesh/files/text_scanner.hpp"

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
  Fnv fnv;
  for (const VertexId v : m.vertices()) {
    for (const double coordinate : positions[v.slot()]) fnv.add(std::bit_cast<std::uint64_t>(coordinate));
  }
  for (const auto& face : m.compact_faces()) {
    for (const int corner : face) fnv.add(static_cast<std::uint64_t>(corner));
  }
  return {m.vertex_count(), m.face_count(), fnv.value()};
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
  Script result{script.name, script.after, script.before, {}};
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
  check_mesh(script, script.after, script.before, digest(surface.mesh, surface.positions));
  ScriptIds ids(script.before);
  for (const Change& change : script.changes) ids.advance(change);
  try {
    surface.mesh = surface.mesh.with_free_ids(std::move(ids.free_faces()), std::move(ids.free_vertices()));
  } catch (const MeshError& error) {
    throw FileError(script.name + ": " + error.what());
  }
  Positions positions(static_cast<std::size_t>(surface.mesh.vertex_capacity()), Vector3d::Zero());
  std::vector<int> file_vertex(positions.size(), -1);
  std::vector<int> from_file(surface.from_file.size(), -1);
  std::size_t next = 0;
  for (const VertexId v : surface.mesh.vertices()) {
    positions[v.slot()] = surface.positions[next];
    file_vertex[v.slot()] = surface.file_vertex[next];
    from_file[static_cast<std::size_t>(file_vertex[v.slot()])] = v.index();
    ++next;
  }
  surface.positions = std::move(positions);
  surface.file_vertex = std::move(file_vertex);
  surface.from_file = std::move(from_file);
}

namespace {

class Replayer {
 public:
  Replayer(Editor& editor, const Script& script) : editor_(editor), m_(editor.mesh()), script_(script) {}

  Replay run() {
    check_mesh(script_, script_.before, script_.after, digest(m_, *editor_.positions()));
    const std::size_t mark = editor_.mark();
    try {
      for (const Change& change : script_.changes) {
        const Refusal refusal = change.operation ? operate(change) : move(change);
        if (refusal == Refusal::none) continue;
        editor_.roll_back(mark);
        return {refusal, change.line};
      }
      if (digest(m_, *editor_.positions()) != script_.after)
        throw FileError(script_.name + ": the script does not lead to the mesh that it says");
    } catch (...) {
      editor_.roll_back(mark);
      throw;
    }
    return {};
  }

 private:
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
