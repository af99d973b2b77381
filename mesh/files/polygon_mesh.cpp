#include "mesh/files/polygon_mesh.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <tuple>

namespace requad::mesh {

namespace {

// A face's edge from one corner to the next. `corner` is the position of the first in PolygonMesh::corners.
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
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k], b = face[(k + 1) % face.size()];
      sides.push_back({std::min(a, b), std::max(a, b), m.first_corner(f) + k, f, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    return std::tie(x.low, x.high, x.corner) < std::tie(y.low, y.high, y.corner);
  });
  return sides;
}

// Calls visit(its sides) for each edge.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, Visit&& visit) {
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high;) ++end;
    visit(std::span<const Side>(sides).subspan(i, end - i));
  }
}

// Disjoint sets whose elements have a parity: whether an element is turned round with respect to its set's first.
class ParitySets {
 public:
  explicit ParitySets(std::size_t size) : parent_(size), odd_(size, false) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::size_t find(std::size_t x) const { return root(x).first; }
  bool odd(std::size_t x) const { return root(x).second; }
  // Joins the sets of a and b such that a and b have different parities, or the same one. Returns false if that
  // contradicts what was joined before.
  bool join(std::size_t a, std::size_t b, bool different) {
    const auto [root_a, odd_a] = root(a);
    const auto [root_b, odd_b] = root(b);
    if (root_a == root_b) return (odd_a != odd_b) == different;
    parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
    odd_[std::max(root_a, root_b)] = (odd_a != odd_b) != different;
    return true;
  }

 private:
  std::pair<std::size_t, bool> root(std::size_t x) const {
    bool odd = false;
    std::size_t at = x;
    for (; parent_[at] != at; at = parent_[at]) odd = odd != odd_[at];
    // Path compression: each element on the path gets its parity to the root.
    for (bool rest = odd; x != at;) {
      const std::size_t next = parent_[x];
      const bool to_parent = odd_[x];
      parent_[x] = at;
      odd_[x] = rest;
      rest = rest != to_parent;
      x = next;
    }
    return {at, odd};
  }

  mutable std::vector<std::size_t> parent_;
  mutable std::vector<bool> odd_;
};

// --- manifold_problem ------------------------------------------------------------------------------------------------

std::string line_name(const PolygonMesh& m, std::size_t face) { return "line " + std::to_string(m.lines[face]); }
std::string edge_name(const PolygonMesh& m, const Side& s) {
  return "edge " + m.vertex_name(s.low) + "-" + m.vertex_name(s.high);
}
// "file:line: reason".
std::string problem_at(const PolygonMesh& m, std::size_t face, const std::string& reason) {
  return m.name + ":" + std::to_string(m.lines[face]) + ": " + reason;
}

// A face that has the corners of another one, in the same order. Two faces with opposite orders can be a whole surface.
std::string twice_problem(const PolygonMesh& m, const std::vector<Side>& /*sides*/) {
  std::vector<std::pair<std::vector<int>, std::size_t>> faces;  // each starts with its least vertex
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    std::vector<int> face(m.face(f).begin(), m.face(f).end());
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.emplace_back(std::move(face), f);
  }
  std::sort(faces.begin(), faces.end());
  const auto twice =
      std::adjacent_find(faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice == faces.end()) return "";
  return problem_at(m, std::next(twice)->second, "this face stands in " + line_name(m, twice->second) + " already");
}

// An edge with three faces or more.
std::string edge_problem(const PolygonMesh& m, const std::vector<Side>& sides) {
  std::string problem;
  for_each_edge(sides, [&](std::span<const Side> edge) {
    if (!problem.empty() || edge.size() <= 2) return;
    problem = problem_at(m, edge[2].face,
                         edge_name(m, edge[0]) + " has " + std::to_string(edge.size()) + " faces, the first in " +
                             line_name(m, edge[0].face) + "; expected at most 2");
  });
  return problem;
}

// Neighbours that run along their edge in the same direction. Turning some faces round may make all of them agree.
std::string orientation_problem(const PolygonMesh& m, const std::vector<Side>& sides) {
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
  if (twisted) {
    return problem_at(
        m, twisted->face,
        "the surface is one-sided, like a Moebius band, and has no orientation; seen at " + edge_name(m, *twisted));
  }
  if (!unlike) return "";
  std::size_t all = 0, odd = 0;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    if (turned.find(f) != turned.find(other)) continue;
    ++all;
    odd += turned.odd(f) ? 1 : 0;
  }
  return problem_at(m, unlike->face,
                    "this face and that of " + line_name(m, other) + " are not oriented alike at " +
                        edge_name(m, *unlike) + "; turning " + std::to_string(std::min(odd, all - odd)) + " of the " +
                        std::to_string(all) + " faces round would do");
}

// A vertex whose faces form more than one fan. Precondition: the faces are oriented, at most two at an edge.
std::string fan_problem(const PolygonMesh& m, const std::vector<Side>& sides) {
  // A fan is a set of corners of one vertex that edges join.
  ParitySets fans(m.corners.size());
  const auto following = [&m](const Side& s) {
    return s.corner + 1 == m.ends[s.face] ? m.first_corner(s.face) : s.corner + 1;
  };
  for_each_edge(sides, [&](std::span<const Side> edge) {
    if (edge.size() != 2) return;
    fans.join(edge[0].corner, following(edge[1]), false);
    fans.join(edge[1].corner, following(edge[0]), false);
  });
  const std::size_t none = m.corners.size();
  std::vector<std::size_t> fan_of_vertex(m.positions.size(), none);
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    for (std::size_t corner = m.first_corner(f); corner < m.ends[f]; ++corner) {
      const std::size_t fan = fans.find(corner);
      std::size_t& known = fan_of_vertex[static_cast<std::size_t>(m.corners[corner])];
      if (known == none) known = fan;
      if (known != fan) {
        return problem_at(
            m, f, "vertex " + m.vertex_name(m.corners[corner]) + " is not manifold: its faces form more than one fan");
      }
    }
  }
  return "";
}

}  // namespace

std::string manifold_problem(const PolygonMesh& m) {
  const std::vector<Side> sides = sorted_sides(m);
  for (const auto& find_problem : {twice_problem, edge_problem, orientation_problem, fan_problem}) {
    if (const std::string problem = find_problem(m, sides); !problem.empty()) return problem;
  }
  return "";
}

}  // namespace requad::mesh
