#include <array>
#include <charconv>
#include <limits>
#include <utility>

#include "mesh/editing/script.hpp"
#include "mesh/editing/script_ids.hpp"
#include "mesh/text/number_text.hpp"
#include "mesh/text/text_scanner.hpp"

namespace requad::mesh {

namespace {

using Kind = BasicOperation::Kind;

constexpr int kVersion = 1;
constexpr std::size_t kHexDigits = 16;

void append_vertex(std::string& text, const char* what, VertexId v, const Eigen::Vector3d& p) {
  text += what;
  append_number(text, v.index());
  append_position(text, p);
}

void append_hex(std::string& text, std::uint64_t number) {
  std::array<char, kHexDigits> hex;
  const auto used =
      static_cast<std::size_t>(std::to_chars(hex.data(), hex.data() + hex.size(), number, 16).ptr - hex.data());
  text.append(kHexDigits - used, '0').append(hex.data(), used);
}

void append_digest(std::string& text, const char* what, const MeshDigest& d) {
  text += what + std::to_string(d.vertices) + ' ' + std::to_string(d.faces) + ' ';
  append_hex(text, d.fingerprint);
}

BasicOperation inverse_of_flip(const BasicOperation& flip) {
  return flip.kind == Kind::flip_ccw ? BasicOperation{Kind::flip_cw, QuadMesh::next(flip.h), {}, 0}
                                     : BasicOperation{Kind::flip_ccw, QuadMesh::previous(flip.h), {}, 0};
}

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
    if (!scanner_.at_end_of_line()) {
      script_.before.connectivity = read_fingerprint();
      script_.after.connectivity = read_fingerprint();
    }
    finish_line();
    ScriptIds ids(script_.before);
    while (true) {
      next_line("end");
      const std::string_view keyword = scanner_.word();
      if (keyword == "end") break;
      Change change = read_change(keyword, ids);
      change.line = scanner_.line();
      finish_line();
      ids.advance(change);
      script_.changes.push_back(std::move(change));
    }
    const std::optional<std::uint64_t> connectivity = script_.after.connectivity;
    script_.after = read_digest();
    script_.after.connectivity = connectivity;
    finish_line();
    if (ids.live_vertices() != script_.after.vertices || ids.live_faces() != script_.after.faces) {
      scanner_.fail("the lines before lead to " + std::to_string(ids.live_vertices()) + " vertices and " +
                    std::to_string(ids.live_faces()) + " faces; expected what they lead to");
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
  // The next word as an integer in 0..count-1.
  std::int32_t index(const char* what, std::int64_t count) {
    const std::int64_t value = scanner_.integer(what);
    if (value < 0 || value >= count) {
      scanner_.fail(std::string(what) + ": " + std::to_string(value) + " is not in 0.." + std::to_string(count - 1));
    }
    return static_cast<std::int32_t>(value);
  }
  HalfEdgeId half_edge(const ScriptIds& ids) { return HalfEdgeId(index("a half-edge", 4 * ids.faces())); }
  VertexId vertex(const ScriptIds& ids) { return VertexId(index("a vertex", ids.vertices())); }

  MeshDigest read_digest() {
    // With this bound, four half-edges for each face fit into an integer, after all the splits that a text can hold.
    constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max() / 8;
    MeshDigest d;
    d.vertices = index("the number of vertices", kMost);
    d.faces = index("the number of faces", kMost);
    d.fingerprint = read_fingerprint();
    return d;
  }

  std::uint64_t read_fingerprint() {
    const std::string_view hex = scanner_.word();
    const char* const last = hex.data() + hex.size();
    std::uint64_t number = 0;
    if (hex.size() != kHexDigits || std::from_chars(hex.data(), last, number, 16).ptr != last)
      scanner_.fail(TextScanner::quoted(hex) + " is not a fingerprint of 16 hexadecimal digits");
    return number;
  }

  // Reads a number that must be the expected one.
  void expect_number(const char* what, std::int64_t expected) {
    const std::int64_t value = scanner_.integer(what);
    if (value != expected)
      scanner_.fail(std::string(what) + " is " + std::to_string(expected) + " here, not " + std::to_string(value));
  }

  Change read_change(std::string_view keyword, const ScriptIds& ids) {
    Change change;
    if (keyword == "flip_ccw" || keyword == "flip_cw") {
      change.operation = {keyword == "flip_ccw" ? Kind::flip_ccw : Kind::flip_cw, half_edge(ids), {}, 0};
      change.inverse = inverse_of_flip(*change.operation);
    } else if (keyword == "collapse") {
      change.operation = {Kind::collapse, half_edge(ids), {}, 0};
      expect("removes");
      change.vertex = vertex(ids);
      change.from = scanner_.position();
      expect("undo");
      expect("split");
      change.inverse = {Kind::split, half_edge(ids), half_edge(ids), change.operation->h.index() & 3};
      expect_number("the corner", change.inverse.corner);
    } else if (keyword == "split") {
      change.operation = {Kind::split, half_edge(ids), half_edge(ids), index("a corner", 4)};
      expect("makes");
      change.vertex = ids.next_vertex();
      expect_number("the new vertex", change.vertex.index());
      change.to = scanner_.position();
      expect("undo");
      expect("collapse");
      change.inverse = {Kind::collapse, QuadMesh::half_edge(ids.next_face(), change.operation->corner), {}, 0};
      expect_number("the new half-edge", change.inverse.h.index());
    } else if (keyword == "place") {
      change.vertex = vertex(ids);
      change.to = scanner_.position();
      expect("from");
      change.from = scanner_.position();
    } else {
      scanner_.fail(TextScanner::quoted(keyword) + " does not start a line of a script");
    }
    return change;
  }

  TextScanner scanner_;
  Script script_;
};

}  // namespace

std::string to_string(const Script& script) {
  std::string text = "requad-script " + std::to_string(kVersion) + '\n';
  append_digest(text, "mesh ", script.before);
  if (script.before.connectivity && script.after.connectivity) {
    for (const MeshDigest* d : {&script.before, &script.after}) {
      text += ' ';
      append_hex(text, *d->connectivity);
    }
  }
  text += '\n';
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
  text += '\n';
  return text;
}

Script parse_script(std::string_view text, const std::string& name) { return ScriptReader(text, name).read(); }

}  // namespace requad::mesh
