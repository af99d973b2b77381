#include "mesh/files/welding.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "mesh/text/text_scanner.hpp"

namespace requad::mesh {

std::vector<int> first_at_same_place(const Positions& positions) {
  std::vector<int> first(positions.size()), order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&positions](int v) {
    const Eigen::Vector3d& p = positions[static_cast<std::size_t>(v)];
    return std::tuple(p.x(), p.y(), p.z());
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const auto of_a = key(a), of_b = key(b);
    return of_a != of_b ? of_a < of_b : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
    first[static_cast<std::size_t>(order[i])] = same ? first[static_cast<std::size_t>(order[i - 1])] : order[i];
  }
  return first;
}

int coincident_vertices(const Positions& positions) {
  const std::vector<int> first = first_at_same_place(positions);
  int count = 0;
  for (std::size_t v = 0; v < first.size(); ++v) count += first[v] != static_cast<int>(v) ? 1 : 0;
  return count;
}

void weld(PolygonMesh& m) {
  m.same_as = first_at_same_place(m.positions);
  const auto rename = [&m](int& v) { v = m.same_as[static_cast<std::size_t>(v)]; };
  for (int& v : m.corners) rename(v);
  for (Attributes::Element& element : m.attributes.elements) {
    for (Attributes::Element::Word& word : element.words) {
      if (word.vertex >= 0) rename(word.vertex);
    }
  }
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    std::vector<int> face(m.face(f).begin(), m.face(f).end());
    std::sort(face.begin(), face.end());
    if (std::adjacent_find(face.begin(), face.end()) != face.end())
      TextScanner::fail(m.name, m.lines[f], "two corners of this face are at one place, so it cannot be welded");
  }
}

}  // namespace requad::mesh
