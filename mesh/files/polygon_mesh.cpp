#include "mesh/files/polygon_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "mesh/files/text_scanner.hpp"

namespace requad::mesh {

namespace {

// --- reading ---------------------------------------------------------------------------------------------------------

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
  std::vector<int> sorted(face.begin(), face.end());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

std::string vertex_name(const PolygonMesh& m, int v) { return std::to_string(v + m.first_index); }

// What can be said of a face only when all vertices are known, and of the whole.
PolygonMesh finished(PolygonMesh m, const TextScanner& scanner) {
  if (m.face_count() == 0)
    scanner.fail(m.positions.empty() ? "the file ends without a vertex or face" : "the file ends without a face");
  const auto vertices = static_cast<std::int64_t>(m.positions.size());
  if (vertices > kMostVertices) scanner.fail("more than " + std::to_string(kMostVertices) + " vertices");
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    for (const int v : m.face(f)) {
      if (v >= vertices) {
        TextScanner::fail(m.name, m.lines[f],
                          "vertex " + vertex_name(m, v) + " does not exist; there are " + std::to_string(vertices) +
                              ", counted from " + std::to_string(m.first_index));
      }
    }
    if (has_repetition(m.face(f))) TextScanner::fail(m.name, m.lines[f], "a vertex occurs twice in this face");
  }
  return m;
}

Eigen::Vector3d read_position(TextScanner& scanner) {
  Eigen::Vector3d p;
  for (double& coordinate : p) {
    coordinate = scanner.number("a coordinate");
    if (std::abs(coordinate) > kLargestCoordinate) scanner.fail("a coordinate is larger than 1e70");
  }
  while (!scanner.at_end_of_line()) scanner.number("a number");
  return p;
}

// One corner of an OBJ face, 0-based: its vertex, and after slashes what we have no use for but must be well-formed.
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

// OFF, or with what Geomview puts before it: [ST][C][N][4][n]OFF.
bool is_off_keyword(std::string_view word) {
  return word.ends_with("OFF") && word.substr(0, word.size() - 3).find_first_not_of("STCN4n") == std::string_view::npos;
}

bool is_keyword(std::string_view word) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return letter(word.front()) && std::all_of(word.begin(), word.end(), [&](char c) {
           return letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
         });
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
      m.positions.push_back(read_position(scanner));
    } else if (keyword == "f") {
      face.clear();
      for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
        face.push_back(obj_corner(scanner, word, static_cast<std::int64_t>(m.positions.size())));
      }
      if (face.size() < 3) scanner.fail("a face has " + std::to_string(face.size()) + " corners; expected 3 or more");
      m.add_face(face, line);
    } else if (first && is_off_keyword(keyword)) {
      scanner.fail("this is OFF, not OBJ");
    } else if (!is_keyword(keyword)) {
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
  if (!scanner.at_end_of_line()) scanner.integer("the number of edges");  // which nobody keeps true
  if (!scanner.at_end_of_line())
    scanner.fail(TextScanner::quoted(scanner.word()) + " after the numbers of vertices, faces and edges");
  // A vertex takes at least six characters, "0 0 0" and a line's end; a face eight.
  const auto most = static_cast<std::int64_t>(scanner.bytes_left() + 1);
  if (vertices < 0 || faces < 0 || vertices > most / 6 || faces > most / 8) {
    scanner.fail(std::to_string(vertices) + " vertices and " + std::to_string(faces) + " faces are promised; " +
                 std::to_string(most - 1) + " characters follow");
  }
  const auto next_of = [&scanner](std::int64_t i, std::int64_t all, const char* what) {
    if (!scanner.next_line())
      scanner.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(all) + " " + what);
  };
  m.positions.reserve(static_cast<std::size_t>(vertices));
  for (std::int64_t v = 0; v < vertices; ++v) {
    next_of(v, vertices, "vertices");
    m.positions.push_back(read_position(scanner));
  }
  std::vector<int> face;
  for (std::int64_t f = 0; f < faces; ++f) {
    next_of(f, faces, "faces");
    const int line = scanner.line();
    const std::int64_t size = scanner.integer("a face's number of corners");
    if (size < 3) scanner.fail("a face has " + std::to_string(size) + " corners; expected 3 or more");
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
    m.add_face(face, line);
  }
  if (scanner.next_line()) scanner.fail("more text after the last of " + std::to_string(faces) + " faces");
  return finished(std::move(m), scanner);
}

PolygonMesh read_polygon_mesh(const std::string& path) {
  const auto named = [&path](std::string_view ending) {
    const std::string_view tail = std::string_view(path).substr(path.size() - std::min(path.size(), ending.size()));
    return std::equal(tail.begin(), tail.end(), ending.begin(), ending.end(), [](char c, char lower) {
      return c == lower || (c >= 'A' && c <= 'Z' && c - 'A' + 'a' == lower);
    });
  };
  const bool off = named(".off");
  if (!off && !named(".obj")) throw FileError(path + ": expected a name that ends in .obj or .off");
  const std::string text = read_text(path);
  return off ? parse_off(text, path) : parse_obj(text, path);
}

// --- edges -----------------------------------------------------------------------------------------------------------

namespace {

// A face's edge from one corner to the next; `corner` is the position of the first in PolygonMesh::corners.
struct Side {
  int low, high;
  std::size_t corner, face;
  bool forward;  // from low to high
};

// Sorted by ends, then by corner.
std::vector<Side> sorted_sides(const PolygonMesh& m) {
  std::vector<Side> sides;
  sides.reserve(m.corners.size());
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const std::span<const int> face = m.face(f);
    const std::size_t first = m.ends[f] - face.size();
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k], b = face[(k + 1) % face.size()];
      sides.push_back({std::min(a, b), std::max(a, b), first + k, f, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    return std::tie(x.low, x.high, x.corner) < std::tie(y.low, y.high, y.corner);
  });
  return sides;
}

// Calls visit(range of sides) for each edge.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, Visit&& visit) {
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high;) ++end;
    visit(std::span<const Side>(sides).subspan(i, end - i));
  }
}

// Disjoint sets with a parity: whether an element is turned round with respect to its set's first.
class ParitySets {
 public:
  explicit ParitySets(std::size_t size) : parent_(size), odd_(size, false) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::size_t find(std::size_t x) const { return root(x).first; }
  bool odd(std::size_t x) const { return root(x).second; }
  // Joins the sets of a and b, b's parity being a's, or the other one; false if that contradicts what is known.
  bool join(std::size_t a, std::size_t b, bool other) {
    const auto [root_a, odd_a] = root(a);
    const auto [root_b, odd_b] = root(b);
    if (root_a == root_b) return (odd_a != odd_b) == other;
    parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
    odd_[std::max(root_a, root_b)] = (odd_a != odd_b) != other;
    return true;
  }

 private:
  std::pair<std::size_t, bool> root(std::size_t x) const {
    bool odd = false;
    std::size_t at = x;
    for (; parent_[at] != at; at = parent_[at]) odd = odd != odd_[at];
    // Path compression, each with its parity to the root.
    for (bool rest = odd; x != at;) {
      const std::size_t next = parent_[x];
      const bool step = odd_[x];
      parent_[x] = at;
      odd_[x] = rest;
      rest = rest != step;
      x = next;
    }
    return {at, odd};
  }

  mutable std::vector<std::size_t> parent_;
  mutable std::vector<bool> odd_;
};

}  // namespace

std::string manifold_problem(const PolygonMesh& m) {
  const std::vector<Side> sides = sorted_sides(m);
  const auto edge_name = [&m](const Side& s) { return "edge " + vertex_name(m, s.low) + "-" + vertex_name(m, s.high); };
  const auto at = [&m](std::size_t face) { return m.name + ":" + std::to_string(m.lines[face]) + ": "; };
  const auto line = [&m](std::size_t face) { return "line " + std::to_string(m.lines[face]); };

  std::string problem;
  for_each_edge(sides, [&](std::span<const Side> edge) {
    if (!problem.empty() || edge.size() <= 2) return;
    problem = at(edge[2].face) + edge_name(edge[0]) + " has " + std::to_string(edge.size()) + " faces, the first in " +
              line(edge[0].face) + "; expected at most 2";
  });
  if (!problem.empty()) return problem;

  // Two neighbours agree if they run along their edge in opposite directions. Turning faces round may make all agree.
  ParitySets turned(m.face_count());
  std::optional<Side> unlike, twisted;
  std::size_t other = 0;
  for_each_edge(sides, [&](std::span<const Side> edge) {
    if (edge.size() != 2) return;
    const bool agree = edge[0].forward != edge[1].forward;
    if (!turned.join(edge[0].face, edge[1].face, !agree) && !twisted) twisted = edge[1];
    if (!agree && !unlike) {
      unlike = edge[1];
      other = edge[0].face;
    }
  });
  if (twisted)
    return at(twisted->face) + "the surface is one-sided, like a Moebius band, and has no orientation; seen at " +
           edge_name(*twisted);
  if (unlike) {
    std::size_t all = 0, odd = 0;
    for (std::size_t f = 0; f < m.face_count(); ++f) {
      if (turned.find(f) != turned.find(other)) continue;
      ++all;
      odd += turned.odd(f) ? 1 : 0;
    }
    return at(unlike->face) + "this face and that of " + line(other) + " are not oriented alike at " +
           edge_name(*unlike) + "; turning " + std::to_string(std::min(odd, all - odd)) + " of the " +
           std::to_string(all) + " faces round would do";
  }

  // Corners of a vertex that edges join form a fan.
  ParitySets fans(m.corners.size());
  const auto following = [&m](const Side& s) {
    return s.corner + 1 == m.ends[s.face] ? s.corner + 1 - m.face(s.face).size() : s.corner + 1;
  };
  for_each_edge(sides, [&](std::span<const Side> edge) {
    if (edge.size() != 2) return;
    fans.join(edge[0].corner, following(edge[1]), false);
    fans.join(edge[1].corner, following(edge[0]), false);
  });
  std::vector<std::size_t> fan(m.positions.size(), m.corners.size());
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const std::span<const int> face = m.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::size_t here = fans.find(m.ends[f] - face.size() + k);
      std::size_t& known = fan[static_cast<std::size_t>(face[k])];
      if (known == m.corners.size()) known = here;
      if (known != here)
        return at(f) + "vertex " + vertex_name(m, face[k]) + " is not manifold: its faces form more than one fan";
    }
  }
  return "";
}

PolygonMesh subdivide(const PolygonMesh& m) {
  // Each corner's edge to the next is named by the least corner that has it, then numbered in that order.
  std::vector<std::size_t> midpoint(m.corners.size());
  for_each_edge(sorted_sides(m), [&](std::span<const Side> edge) {
    for (const Side& side : edge) midpoint[side.corner] = edge[0].corner;
  });
  PolygonMesh result;
  result.name = m.name;
  result.first_index = m.first_index;
  result.positions = m.positions;
  result.corners.reserve(4 * m.corners.size());
  const auto position = [&m](int v) -> const Eigen::Vector3d& { return m.positions[static_cast<std::size_t>(v)]; };
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const std::span<const int> face = m.face(f);
    const std::size_t first = m.ends[f] - face.size();
    for (std::size_t k = 0; k < face.size(); ++k) {
      std::size_t& number = midpoint[first + k];
      if (number != first + k) {
        number = midpoint[number];
        continue;
      }
      number = result.positions.size();
      result.positions.emplace_back((position(face[k]) + position(face[(k + 1) % face.size()])) / 2);
    }
  }
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const std::span<const int> face = m.face(f);
    const std::size_t first = m.ends[f] - face.size();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int v : face) sum += position(v);
    const auto centre = static_cast<int>(result.positions.size());
    result.positions.emplace_back(sum / static_cast<double>(face.size()));
    for (std::size_t k = 0; k < face.size(); ++k) {
      const auto after = static_cast<int>(midpoint[first + k]);
      const auto before = static_cast<int>(midpoint[first + (k + face.size() - 1) % face.size()]);
      result.add_face(std::array{face[k], after, centre, before}, m.lines[f]);
    }
  }
  return result;
}

Surface to_quad_mesh(const PolygonMesh& m) {
  Surface s;
  s.file_vertices = static_cast<int>(m.positions.size());
  s.from_file.assign(m.positions.size(), -1);
  for (const int v : m.corners) s.from_file[static_cast<std::size_t>(v)] = 0;
  for (std::size_t v = 0; v < m.positions.size(); ++v) {
    if (s.from_file[v] < 0) {
      ++s.dropped;
      continue;
    }
    s.from_file[v] = static_cast<int>(s.positions.size());
    s.positions.push_back(m.positions[v]);
    s.file_vertex.push_back(static_cast<int>(v));
  }
  std::vector<std::array<int, 4>> faces;
  faces.reserve(m.face_count());
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const std::span<const int> face = m.face(f);
    if (face.size() != 4) {
      TextScanner::fail(m.name, m.lines[f],
                        "a face has " + std::to_string(face.size()) +
                            " corners; expected a quad (subdividing makes quads of any polygons)");
    }
    std::array<int, 4>& quad = faces.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) quad[k] = s.from_file[static_cast<std::size_t>(face[k])];
  }
  try {
    s.mesh = QuadMesh::from_faces(static_cast<int>(s.positions.size()), faces);
  } catch (const MeshError& error) {
    const std::string problem = manifold_problem(m);
    throw FileError(problem.empty() ? m.name + ": " + error.what() : problem);
  }
  return s;
}

Surface read_surface(const std::string& path, bool subdivided) {
  const PolygonMesh polygons = read_polygon_mesh(path);
  if (!subdivided) return to_quad_mesh(polygons);
  try {
    Surface s = to_quad_mesh(subdivide(polygons));
    s.file_vertices = static_cast<int>(polygons.positions.size());
    return s;
  } catch (const MeshError&) {
    // In the terms of the file, which knows none of the new vertices.
    if (const std::string problem = manifold_problem(polygons); !problem.empty()) throw FileError(problem);
    throw;
  }
}

}  // namespace requad::mesh
