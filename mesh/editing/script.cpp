#include "mesh/editing/script.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/files/number_text.hpp"
#include "mesh/files/text_scanner.hpp"

namespace requad::mesh {

namespace {

using Eigen::Vector3d;
using Kind = BasicOperation::Kind;

constexpr int kVersion = 1;
constexpr std::size_t kHexDigits = 16;

// FNV-1a (G. Fowler, L. C. Noll, K.-P. Vo), the bytes of a word least first.
class Fnv {
 public:
  void add(std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte, word >>= 8U) value_ = (value_ ^ (word & 0xffU)) * 0x100000001b3U;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

BasicOperation inverse_of_flip(const BasicOperation& flip) {
  return flip.kind == Kind::flip_ccw ? BasicOperation{Kind::flip_cw, QuadMesh::next(flip.h), {}, 0}
                                     : BasicOperation{Kind::flip_ccw, QuadMesh::previous(flip.h), {}, 0};
}

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

Script record_script(const QuadMesh& before, const Positions& positions, const Editor& editor) {
  Script script;
  script.before = digest(before, positions);
  script.after = digest(editor.mesh(), *editor.positions());
  // Where each vertex is after the edits so far: a slot's last position, which an editor sees, may be a removed
  // vertex's.
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

// --- text ------------------------------------------------------------------------------------------------------------

namespace {

void append_position(std::string& text, const Vector3d& p) {
  for (const double coordinate : p) {
    text += ' ';
    append_number(text, coordinate);
  }
}

void append_vertex(std::string& text, const char* what, VertexId v, const Vector3d& p) {
  text += what;
  append_number(text, v.index());
  append_position(text, p);
}

void append_digest(std::string& text, const char* what, const MeshDigest& d) {
  text += what + std::to_string(d.vertices) + ' ' + std::to_string(d.faces) + ' ';
  std::array<char, kHexDigits> hex;
  const auto used =
      static_cast<std::size_t>(std::to_chars(hex.data(), hex.data() + hex.size(), d.fingerprint, 16).ptr - hex.data());
  text.append(kHexDigits - used, '0').append(hex.data(), used);
  text += '\n';
}

// The numbers that exist at a line of a script, and those that are next.
class Numbers {
 public:
  explicit Numbers(const MeshDigest& start) : vertices_(start.vertices), faces_(start.faces) {}

  std::int64_t vertices() const { return vertices_; }
  std::int64_t faces() const { return faces_; }
  VertexId next_vertex() const { return next(free_vertices_, vertices_); }
  FaceId next_face() const { return next(free_faces_, faces_); }
  std::int64_t live_vertices() const { return vertices_ - static_cast<std::int64_t>(free_vertices_.size()); }
  std::int64_t live_faces() const { return faces_ - static_cast<std::int64_t>(free_faces_.size()); }

  void follow(const Change& change) {
    if (!change.operation) return;
    if (change.operation->kind == Kind::collapse) {
      free_vertices_.push_back(change.vertex);
      free_faces_.push_back(QuadMesh::face(change.operation->h));
    } else if (change.operation->kind == Kind::split) {
      take(free_vertices_, vertices_);
      take(free_faces_, faces_);
    }
  }
  std::vector<VertexId>& free_vertices() { return free_vertices_; }
  std::vector<FaceId>& free_faces() { return free_faces_; }

 private:
  template <class Id>
  static Id next(const std::vector<Id>& free_ids, std::int64_t count) {
    return free_ids.empty() ? Id(static_cast<std::int32_t>(count)) : free_ids.back();
  }
  template <class Id>
  static void take(std::vector<Id>& free_ids, std::int64_t& count) {
    if (free_ids.empty()) {
      ++count;
    } else {
      free_ids.pop_back();
    }
  }

  std::int64_t vertices_;
  std::int64_t faces_;
  std::vector<VertexId> free_vertices_;
  std::vector<FaceId> free_faces_;
};

class ScriptReader {
 public:
  ScriptReader(std::string_view text, const std::string& name) : scanner_(name, text) { script_.name = name; }

  Script read() {
    if (scanner_.at_end_of_line() && !scanner_.next_line()) scanner_.fail("nothing where requad-script is expected");
    expect("requad-script");
    if (const std::int64_t version = scanner_.integer("the version"); version != kVersion)
      scanner_.fail("version " + std::to_string(version) + "; expected " + std::to_string(kVersion));
    finish_line();
    next_line("mesh");
    expect("mesh");
    script_.before = read_digest();
    Numbers numbers(script_.before);
    while (true) {
      next_line("end");
      const std::string_view keyword = scanner_.word();
      if (keyword == "end") break;
      Change change = read_change(keyword, numbers);
      change.line = scanner_.line();
      finish_line();
      numbers.follow(change);
      script_.changes.push_back(std::move(change));
    }
    script_.after = read_digest();
    if (numbers.live_vertices() != script_.after.vertices || numbers.live_faces() != script_.after.faces) {
      scanner_.fail("the lines before lead to " + std::to_string(numbers.live_vertices()) + " vertices and " +
                    std::to_string(numbers.live_faces()) + " faces; expected what they lead to");
    }
    if (scanner_.next_line()) scanner_.fail("more text after the end");
    return std::move(script_);
  }

 private:
  void next_line(const char* expected) {
    if (!scanner_.next_line()) scanner_.fail(std::string("the script ends where '") + expected + "' is expected");
  }
  void expect(const char* word) {
    const std::string_view found = scanner_.word();
    if (found != word) {
      scanner_.fail((found.empty() ? "the line ends" : TextScanner::quoted(found)) + std::string(" where '") + word +
                    "' is expected");
    }
  }
  void finish_line() {
    if (!scanner_.at_end_of_line()) scanner_.fail(TextScanner::quoted(scanner_.word()) + " where the line must end");
  }
  // In 0..count-1.
  std::int32_t index(const char* what, std::int64_t count) {
    const std::int64_t value = scanner_.integer(what);
    if (value < 0 || value >= count) {
      scanner_.fail(std::string(what) + ": " + std::to_string(value) + " is not in 0.." + std::to_string(count - 1));
    }
    return static_cast<std::int32_t>(value);
  }
  HalfEdgeId half_edge(const Numbers& numbers) { return HalfEdgeId(index("a half-edge", 4 * numbers.faces())); }
  VertexId vertex(const Numbers& numbers) { return VertexId(index("a vertex", numbers.vertices())); }

  Vector3d position() {
    Vector3d p;
    for (double& coordinate : p) {
      coordinate = scanner_.number("a coordinate");
      if (std::abs(coordinate) > kLargestCoordinate) scanner_.fail("a coordinate is larger than 1e70");
    }
    return p;
  }

  MeshDigest read_digest() {
    // So that four half-edges for each face, and as many vertices and faces more as a text can make, are integers.
    constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max() / 8;
    MeshDigest d;
    d.vertices = index("the number of vertices", kMost);
    d.faces = index("the number of faces", kMost);
    const std::string_view hex = scanner_.word();
    const char* const last = hex.data() + hex.size();
    if (hex.size() != kHexDigits || std::from_chars(hex.data(), last, d.fingerprint, 16).ptr != last)
      scanner_.fail(TextScanner::quoted(hex) + " is not a fingerprint of 16 hexadecimal digits");
    finish_line();
    return d;
  }

  // What is no choice.
  void given(const char* what, std::int64_t expected) {
    const std::int64_t value = scanner_.integer(what);
    if (value != expected)
      scanner_.fail(std::string(what) + " is " + std::to_string(expected) + " here, not " + std::to_string(value));
  }

  Change read_change(std::string_view keyword, const Numbers& numbers) {
    Change change;
    if (keyword == "flip_ccw" || keyword == "flip_cw") {
      change.operation = {keyword == "flip_ccw" ? Kind::flip_ccw : Kind::flip_cw, half_edge(numbers), {}, 0};
      change.inverse = inverse_of_flip(*change.operation);
    } else if (keyword == "collapse") {
      change.operation = {Kind::collapse, half_edge(numbers), {}, 0};
      expect("removes");
      change.vertex = vertex(numbers);
      change.from = position();
      expect("undo");
      expect("split");
      change.inverse = {Kind::split, half_edge(numbers), half_edge(numbers), change.operation->h.index() & 3};
      given("the corner", change.inverse.corner);
    } else if (keyword == "split") {
      change.operation = {Kind::split, half_edge(numbers), half_edge(numbers), index("a corner", 4)};
      expect("makes");
      change.vertex = numbers.next_vertex();
      given("the new vertex", change.vertex.index());
      change.to = position();
      expect("undo");
      expect("collapse");
      change.inverse = {Kind::collapse, QuadMesh::half_edge(numbers.next_face(), change.operation->corner), {}, 0};
      given("the new half-edge", change.inverse.h.index());
    } else if (keyword == "place") {
      change.vertex = vertex(numbers);
      change.to = position();
      expect("from");
      change.from = position();
    } else {
      scanner_.fail(TextScanner::quoted(keyword) + " does not start a line of a script");
    }
    return change;
  }

  TextScanner scanner_;
  Script script_;
};

// Throws FileError unless the mesh is the expected end of the script.
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

std::string to_string(const Script& script) {
  std::string text = "requad-script " + std::to_string(kVersion) + '\n';
  append_digest(text, "mesh ", script.before);
  for (const Change& change : script.changes) {
    if (!change.operation) {
      append_vertex(text, "place ", change.vertex, change.to);
      text += " from";
      append_position(text, change.from);
    } else {
      text += to_string(*change.operation);
      const bool made = change.operation->kind == Kind::split;
      if (change.vertex.valid()) {
        append_vertex(text, made ? " makes " : " removes ", change.vertex, made ? change.to : change.from);
        text += " undo " + to_string(change.inverse);
      }
    }
    text += '\n';
  }
  append_digest(text, "end ", script.after);
  return text;
}

Script parse_script(std::string_view text, const std::string& name) { return ScriptReader(text, name).read(); }

// --- replaying -------------------------------------------------------------------------------------------------------

void restore_ids(const Script& script, Surface& surface) {
  check_mesh(script, script.after, script.before, digest(surface.mesh, surface.positions));
  Numbers numbers(script.before);
  for (const Change& change : script.changes) numbers.follow(change);
  try {
    surface.mesh = surface.mesh.with_free_ids(std::move(numbers.free_faces()), std::move(numbers.free_vertices()));
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
        const Refusal refusal = change.operation ? operate(change) : place(change);
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
  // The vertex that changes must be where the script says.
  void check_place(const Change& change) const {
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
      check_place(change);
    }
    const Applied done = editor_.replay(*change.operation, change.to);
    if (done.inverse != change.inverse) fail(change, "the operation is undone by " + to_string(done.inverse));
    if (change.operation->kind == Kind::split && editor_.edits().back().made_vertex() != change.vertex)
      fail(change, "the split does not make vertex " + std::to_string(change.vertex.index()));
    return Refusal::none;
  }

  Refusal place(const Change& change) {
    const VertexId v = change.vertex;
    if (!m_.is_live(v)) fail(change, "there is no vertex " + std::to_string(v.index()) + " any more");
    if (m_.is_boundary(v)) fail(change, "vertex " + std::to_string(v.index()) + " lies on the boundary");
    if (editor_.sectors().is_feature(v)) return FeatureRefusal::moves_feature;
    check_place(change);
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
