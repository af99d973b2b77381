#include "mesh/files/read_polygons.hpp"

#include <algorithm>
#include <set>

#include "mesh/files/reading.hpp"

namespace requad::mesh {

namespace {

bool has_repetition(std::span<const int> face) {
  if (face.size() <= 8) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (face[i] == face[j]) return true;
      }
    }
    return false;
  }
  const std::set<int> different(face.begin(), face.end());
  return different.size() != face.size();
}

// Whether the text ends in `ending`, which is in lower case; the text's case does not matter.
bool ends_in(std::string_view text, std::string_view ending) {
  const std::string_view tail = text.substr(text.size() - std::min(text.size(), ending.size()));
  return std::equal(tail.begin(), tail.end(), ending.begin(), ending.end(),
                    [](char c, char lower) { return c == lower || (c >= 'A' && c <= 'Z' && c - 'A' + 'a' == lower); });
}

// Whether the text starts as OFF does: with its keyword, or with a number. Lines of OBJ start with letters.
bool starts_as_off(std::string_view text) {
  TextScanner scanner("", text);
  if (scanner.at_end_of_line() && !scanner.next_line()) return false;
  const std::string_view word = scanner.word();
  return is_off_keyword(word) || (word.front() >= '0' && word.front() <= '9');
}

}  // namespace

PolygonMesh finished(PolygonMesh m, const TextScanner& scanner) {
  if (m.face_count() == 0)
    scanner.fail(m.positions.empty() ? "the file ends without a vertex or face" : "the file ends without a face");
  const auto vertices = static_cast<std::int64_t>(m.positions.size());
  if (vertices > kMostVertices) scanner.fail("more than " + std::to_string(kMostVertices) + " vertices");
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    for (const int v : m.face(f)) {
      if (v >= vertices) {
        TextScanner::fail(m.name, m.lines[f],
                          "vertex " + m.vertex_name(v) + " does not exist; there are " + std::to_string(vertices) +
                              ", counted from " + std::to_string(m.first_index));
      }
    }
    if (has_repetition(m.face(f))) TextScanner::fail(m.name, m.lines[f], "a vertex occurs twice in this face");
  }
  return m;
}

void require_known_end(const std::string& path) {
  const bool has_end = path.find('.', path.find_last_of('/') + 1) != std::string::npos;
  if (!ends_in(path, ".off") && !ends_in(path, ".obj") && (has_end || path.empty()))
    throw FileError(path + ": expected a name that ends in .obj or .off");
}

PolygonMesh parse_polygon_mesh(std::string_view text, const std::string& path, const std::string& name) {
  const bool off = ends_in(path, ".off") || (!ends_in(path, ".obj") && starts_as_off(text));
  return off ? parse_off(text, name) : parse_obj(text, name);
}

PolygonMesh parse_polygon_mesh(std::string_view text, const std::string& name) {
  require_known_end(name);
  require_text(text, name);
  require_no_zero_byte(text, name);
  return parse_polygon_mesh(text, name, name);
}

}  // namespace requad::mesh
