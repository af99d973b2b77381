#include "tests/support/mesh/regions.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <set>
#include <string>

#include "mesh/topology/signature.hpp"

namespace requad::tests {

using mesh::Region;

namespace {

// The quads of a disk, and its sides: the vertices of each side counter-clockwise. A corner belongs to both its sides.
struct Growth {
  int vertices = 0;
  std::vector<std::array<int, 4>> faces;
  std::vector<std::vector<int>> sides;

  int perimeter() const {
    return std::accumulate(sides.begin(), sides.end(), 0,
                           [](int sum, const auto& side) { return sum + static_cast<int>(side.size()) - 1; });
  }

  // Cuts the closed path `walk` into sides at its corners.
  void set_boundary(const std::vector<int>& walk, const std::vector<std::size_t>& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      std::vector<int> side;
      const std::size_t end = corners[(i + 1) % corners.size()] + (i + 1 == corners.size() ? walk.size() : 0);
      for (std::size_t at = corners[i]; at <= end; ++at) side.push_back(walk[at % walk.size()]);
      sides.push_back(side);
    }
  }

  // Adds a ring of quads round the closed path `walk`, which runs counter-clockwise round a core. Each edge of the path
  // gets one quad. Each vertex gets `extra` quads more, between those of its two edges.
  void add_ring(const std::vector<int>& walk, const std::vector<int>& extra) {
    std::vector<int> outer;
    std::vector<std::size_t> corners, first_spoke, last_spoke;
    for (std::size_t i = 0; i < walk.size(); ++i) {
      first_spoke.push_back(outer.size());
      outer.push_back(vertices++);
      for (int k = 0; k < extra[i]; ++k) {
        corners.push_back(outer.size());
        const int spoke = outer.back();
        outer.push_back(vertices++);
        outer.push_back(vertices++);
        faces.push_back({walk[i], spoke, outer[outer.size() - 2], outer.back()});
      }
      last_spoke.push_back(outer.size() - 1);
    }
    for (std::size_t i = 0; i < walk.size(); ++i) {
      const std::size_t next = (i + 1) % walk.size();
      faces.push_back({outer[last_spoke[i]], outer[first_spoke[next]], walk[next], walk[i]});
    }
    set_boundary(outer, corners);
  }

  // Adds a strip of quads along a side.
  void add_strip(std::size_t i) {
    const std::size_t k = sides.size();
    const std::vector<int> inner = sides[i];
    std::vector<int> outer(inner.size());
    for (int& v : outer) v = vertices++;
    for (std::size_t j = 0; j + 1 < inner.size(); ++j) {
      faces.push_back({outer[j], outer[j + 1], inner[j + 1], inner[j]});
    }
    sides[(i + k - 1) % k].push_back(outer.front());
    auto& after = sides[(i + 1) % k];
    after.insert(after.begin(), outer.back());
    sides[i] = outer;
  }

  Region region(std::size_t side) const {
    Region result{mesh::QuadMesh::from_faces(vertices, faces), {}};
    result.root = result.mesh.out(mesh::VertexId(sides[side].front()));
    return result;
  }
};

Growth small_star(int valence) {
  Growth g;
  const int centre = g.vertices++;
  std::vector<int> walk;
  std::vector<std::size_t> corners;
  for (int i = 0; i < 2 * valence; ++i) walk.push_back(g.vertices++);
  for (std::size_t i = 0; i < walk.size(); i += 2) {
    g.faces.push_back({centre, walk[i], walk[i + 1], walk[(i + 2) % walk.size()]});
    corners.push_back(i + 1);
  }
  g.set_boundary(walk, corners);
  return g;
}

Growth small_pair(const PairShape& shape) {
  Growth g;
  const int l1 = shape.l1, l2 = shape.l2, a = shape.d2, b = shape.d1;
  std::vector<int> walk, extra;
  if (a == 0 || b == 0) {
    const int length = a + b;
    g.vertices = length + 1;
    for (int i = 0; i < 2 * length; ++i) walk.push_back(i <= length ? i : 2 * length - i);
    extra.assign(walk.size(), 0);
    extra[0] = l1 - 2;
    extra[static_cast<std::size_t>(length)] = l2 - 2;
  } else {
    const auto at = [b](int i, int j) { return i * (b + 1) + j; };
    g.vertices = (a + 1) * (b + 1);
    for (int i = 0; i < a; ++i) {
      for (int j = 0; j < b; ++j) g.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    const auto pass = [&](int i, int j, int corner) {
      walk.push_back(at(i, j));
      extra.push_back(corner);
    };
    for (int i = 0; i < a; ++i) pass(i, 0, i == 0 ? l1 - 3 : 0);
    for (int j = 0; j < b; ++j) pass(a, j, j == 0 ? 1 : 0);
    for (int i = a; i > 0; --i) pass(i, b, i == a ? l2 - 3 : 0);
    for (int j = b; j > 0; --j) pass(0, j, j == b ? 1 : 0);
  }
  g.add_ring(walk, extra);
  return g;
}

Region with_strips(Growth growth, const std::vector<int>& strips) {
  for (std::size_t i = 0; i < strips.size(); ++i) {
    for (int layer = 1; layer < strips[i]; ++layer) growth.add_strip(i);
  }
  return growth.region(0);
}

// Visits this growth, and all those that further strips along the sides from `side` on make of it.
void for_each_grown(const Growth& growth, int perimeter, std::size_t side,
                    const std::function<void(const Growth&)>& visit) {
  if (growth.perimeter() > perimeter) return;
  visit(growth);
  for (std::size_t i = side; i < growth.sides.size(); ++i) {
    Growth more = growth;
    more.add_strip(i);
    for_each_grown(more, perimeter, i, visit);
  }
}

}  // namespace

Region star(const std::vector<int>& strips) { return with_strips(small_star(static_cast<int>(strips.size())), strips); }

Region pair_region(const PairShape& shape, const std::vector<int>& strips) {
  return with_strips(small_pair(shape), strips);
}

std::vector<SmallRegion> small_regions(int perimeter, bool with_stars, Roots roots) {
  std::vector<SmallRegion> regions;
  std::set<std::string> known;
  const auto add_all = [&](const Growth& start, const PairShape& shape) {
    for_each_grown(start, perimeter, 0, [&](const Growth& growth) {
      for (std::size_t side = 0; side < growth.sides.size(); ++side) {
        Region region = growth.region(side);
        const std::string name = roots == Roots::one ? mesh::canonical_signature(region.mesh) : mesh::signature(region);
        if (known.insert(name).second) regions.push_back({std::move(region), shape});
        if (roots == Roots::one) break;
      }
    });
  };
  for (const auto& [l1, l2] : {std::array{3, 3}, std::array{3, 5}, std::array{5, 5}}) {
    for (int d1 = 0; d1 < perimeter; ++d1) {
      for (int d2 = d1 == 0 ? 1 : 0; d1 + d2 < perimeter; ++d2) {
        const PairShape shape{l1, l2, d1, d2};
        const Growth start = small_pair(shape);
        if (start.perimeter() <= perimeter) add_all(start, shape);
      }
    }
  }
  if (with_stars) {
    for (const int valence : {2, 4, 6}) add_all(small_star(valence), {valence, 0, 0, 0});
  }
  return regions;
}

}  // namespace requad::tests
