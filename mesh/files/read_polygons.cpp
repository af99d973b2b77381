#include "mesh/files/read_polygons.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "mesh/files/text_scanner.hpp"

namespace requad::mesh {

namespace {

constexpr std::int64_t kMostVertices = std::numeric_limits<int>::max();

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

// Checks what can be checked only when the whole file is read.
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

// The rest of a vertex's line.
Eigen::Vector3d read_vertex(TextScanner& scanner) {
  const Eigen::Vector3d p = scanner.position();
  while (!scanner.at_end_of_line()) scanner.number("a number");
  return p;
}

void check_corner_count(const TextScanner& scanner, std::int64_t corners) {
  if (corners < 3) scanner.fail("a face has " + std::to_string(corners) + " corners; expected 3 or more");
}

// OFF, or with what Geomview puts before it: [ST][C][N][4][n]OFF.
bool is_off_keyword(std::string_view word) {
  return word.ends_with("OFF") && word.substr(0, word.size() - 3).find_first_not_of("STCN4n") == std::string_view::npos;
}

// --- OBJ -------------------------------------------------------------------------------------------------------------

// The vertex, 0-based, of one corner of a face. What follows after slashes is not used, but must be well-formed.
int obj_corner(const TextScanner& scanner, std::string_view word, std::int64_t vertices_so_far) {
  std::string_view rest;
  const std::int64_t index = scanner.integer(word, rest);
  if (index == 0) scanner.fail("vertex 0 does not exist; OBJ counts from 1");
  if (index < -vertices_so_far || index > kMostVertices) {
    scanner.fail("vertex " + std::to_string(index) + " does not exist; there are " + std::to_string(vertices_so_far) +
                 " before this line");
  }
  const auto malformed = [&] {
    scanner.fail(TextScanner::quoted(word) + " is not a corner v, v/vt, v//vn or v/vt/vn");
  };
  for (int slash = 0; !rest.empty(); ++slash) {
    if (rest.front() != '/' || slash == 2) malformed();
    rest.remove_prefix(1);
    if (!rest.empty() && rest.front() != '/') scanner.integer(rest, rest);
  }
  return static_cast<int>(index > 0 ? index - 1 : vertices_so_far + index);
}

bool is_obj_keyword(std::string_view word) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return letter(word.front()) && std::all_of(word.begin(), word.end(), [&](char c) {
           return letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
         });
}

// --- OFF -------------------------------------------------------------------------------------------------------------

struct OffSizes {
  std::int64_t vertices, faces;
};

// The keyword and the numbers of vertices, faces and edges.
OffSizes read_off_header(TextScanner& scanner) {
  if (scanner.at_end_of_line()) scanner.next_line();
  const std::string_view keyword = scanner.word();
  if (!is_off_keyword(keyword))
    scanner.fail((keyword.empty() ? "nothing" : TextScanner::quoted(keyword)) + " where OFF is expected");
  if (keyword.find_first_of("4n") != std::string_view::npos) {
    scanner.fail(TextScanner::quoted(keyword) + " is not a surface in three dimensions");
  }
  if (scanner.at_end_of_line() && !scanner.next_line())
    scanner.fail("the file ends where the numbers of vertices and faces are expected");
  const std::int64_t vertices = scanner.integer("the number of vertices");
  const std::int64_t faces = scanner.integer("the number of faces");
  if (!scanner.at_end_of_line()) scanner.integer("the number of edges");  // ignored: many files have a wrong one
  if (!scanner.at_end_of_line())
    scanner.fail(TextScanner::quoted(scanner.word()) + " after the numbers of vertices, faces and edges");
  // A vertex takes at least six characters, "0 0 0" and a line's end; a face takes eight.
  const auto most = static_cast<std::int64_t>(scanner.bytes_left() + 1);
  if (vertices < 0 || faces < 0 || vertices > most / 6 || faces > most / 8) {
    scanner.fail(std::to_string(vertices) + " vertices and " + std::to_string(faces) + " faces are promised; " +
                 std::to_string(most - 1) + " characters follow");
  }
  return {vertices, faces};
}

// The corners of one face, from its line.
void read_off_face(TextScanner& scanner, std::int64_t vertices, std::vector<int>& face) {
  const std::int64_t size = scanner.integer("a face's number of corners");
  check_corner_count(scanner, size);
  face.clear();
  for (std::int64_t k = 0; k < size; ++k) {
    const std::int64_t v = scanner.integer("a face's vertex");
    if (v < 0 || v >= vertices) {
      scanner.fail("vertex " + std::to_string(v) + " does not exist; there are " + std::to_string(vertices) +
                   ", counted from 0");
    }
    face.push_back(static_cast<int>(v));
  }
  while (!scanner.at_end_of_line()) scanner.number("a colour");
}

// Whether the text ends in `ending`, which is in lower case; the text's case does not matter.
bool ends_in(std::string_view text, std::string_view ending) {
  const std::string_view tail = text.substr(text.size() - std::min(text.size(), ending.size()));
  return std::equal(tail.begin(), tail.end(), ending.begin(), ending.end(),
                    [](char c, char lower) { return c == lower || (c >= 'A' && c <= 'Z' && c - 'A' + 'a' == lower); });
}

}  // namespace

PolygonMesh parse_obj(std::string_view text, const std::string& name) {
  TextScanner scanner(name, text);
  PolygonMesh m;
  m.name = name;
  std::vector<int> face;
  for (bool more = !scanner.at_end_of_line() || scanner.next_line(), first = true; more;
       more = scanner.next_line(), first = false) {
    const int line = scanner.line();
    const std::string_view keyword = scanner.word();
    if (keyword == "v") {
      m.positions.push_back(read_vertex(scanner));
    } else if (keyword == "f") {
      face.clear();
      for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
        face.push_back(obj_corner(scanner, word, static_cast<std::int64_t>(m.positions.size())));
      }
      check_corner_count(scanner, static_cast<std::int64_t>(face.size()));
      m.add_face(face, line);
    } else if (first && is_off_keyword(keyword)) {
      scanner.fail("this is OFF, not OBJ");
    } else if (!is_obj_keyword(keyword)) {
      scanner.fail(TextScanner::quoted(keyword) + " does not start a line of OBJ");
    }
  }
  return finished(std::move(m), scanner);
}

PolygonMesh parse_off(std::string_view text, const std::string& name) {
  TextScanner scanner(name, text);
  PolygonMesh m;
  m.name = name;
  m.first_index = 0;
  const auto [vertices, faces] = read_off_header(scanner);
  const auto next_of = [&scanner](std::int64_t i, std::int64_t all, const char* what) {
    if (!scanner.next_line())
      scanner.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(all) + " " + what);
  };
  m.positions.reserve(static_cast<std::size_t>(vertices));
  for (std::int64_t v = 0; v < vertices; ++v) {
    next_of(v, vertices, "vertices");
    m.positions.push_back(read_vertex(scanner));
  }
  std::vector<int> face;
  for (std::int64_t f = 0; f < faces; ++f) {
    next_of(f, faces, "faces");
    const int line = scanner.line();
    read_off_face(scanner, vertices, face);
    m.add_face(face, line);
  }
  if (scanner.next_line()) scanner.fail("more text after the last of " + std::to_string(faces) + " faces");
  return finished(std::move(m), scanner);
}

PolygonMesh read_polygon_mesh(const std::string& path) {
  const bool off = ends_in(path, ".off");
  if (!off && !ends_in(path, ".obj")) throw FileError(path + ": expected a name that ends in .obj or .off");
  const std::string text = read_text(path);
  return off ? parse_off(text, path) : parse_obj(text, path);
}

}  // namespace requad::mesh
