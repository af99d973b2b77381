#include "enumerate/generators.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace requad::enumerate {

using mesh::QuadMesh;
using mesh::Region;
using mesh::VertexId;
using theory::Configuration;
using theory::Integer;
using theory::PairType;

namespace {

using Line = std::vector<int>;  // vertices along a path

void require(PairType type, const Configuration& c) {
  theory::StripParameters p = c.parameters;
  if (c.merged()) p.d1 = 1;  // the merged vertex is welcome here; check the rest
  if (const std::string problem = theory::parameters_problem(type, p); !problem.empty())
    throw std::invalid_argument(problem);
  // The face count must fit a half-edge index; lengths up to kMaxLength alone do not ensure that.
  const Integer faces = theory::PairSystem(type).face_count(c.parameters);
  if (faces > 20'000'000)
    throw std::invalid_argument("the region would have " + std::to_string(faces) +
                                " quads, more than the 20 million that are made here");
}

// The label of which side 1 of the region is.
int label_of_first_side(PairType type, const Configuration& c) {
  const int k = type.side_count();
  return ((1 - c.p) % k + k) % k + 1;
}

Region rooted_at(int vertices, const std::vector<std::array<int, 4>>& faces, int corner) {
  Region region{QuadMesh::from_faces(vertices, faces), mesh::HalfEdgeId()};
  region.root = region.mesh.out(VertexId(corner));
  return region;
}

}  // namespace

// --- growing ---------------------------------------------------------------------------------------------------------

StripGrowth::StripGrowth(PairType type, Integer d1, Integer d2) {
  const int a = static_cast<int>(d2);  // along v1's first leg
  const int b = static_cast<int>(d1);
  std::vector<Line> grid(static_cast<std::size_t>(a) + 1, Line(static_cast<std::size_t>(b) + 1));
  for (auto& column : grid) {
    for (int& v : column) v = new_vertex();
  }
  for (std::size_t i = 0; i + 1 < grid.size(); ++i) {
    for (std::size_t j = 0; j + 1 < grid[i].size(); ++j) {
      faces_.push_back({grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]});
    }
  }
  Line bottom, top;
  for (const Line& column : grid) {
    bottom.push_back(column.front());
    top.push_back(column.back());
  }
  Line left = grid.front(), right = grid.back();
  std::reverse(left.begin(), left.end());
  std::reverse(top.begin(), top.end());
  // Counter-clockwise: down the second leg of v1 to v1, along its first leg; then the same at v2. The first and the last
  // outward separatrix of a vertex cross the side along its second and first leg, those between cross a side of length 0.
  const auto add_sides = [this](const Line& second_leg, const Line& first_leg, int outward) {
    if (outward == 1) {
      Line both = second_leg;
      both.insert(both.end(), first_leg.begin() + 1, first_leg.end());
      sides_.push_back(both);
      return;
    }
    sides_.push_back(second_leg);
    for (int i = 2; i < outward; ++i) sides_.push_back({first_leg.front()});
    sides_.push_back(first_leg);
  };
  add_sides(left, bottom, type.l1 - 2);
  add_sides(right, top, type.l2 - 2);
  strips_.assign(sides_.size(), 0);
}

void StripGrowth::add_strip(int label) {
  const std::size_t k = sides_.size();
  const auto i = static_cast<std::size_t>(label - 1);
  const Line inner = sides_[i];
  Line outer(inner.size());
  for (int& v : outer) v = new_vertex();
  for (std::size_t j = 0; j + 1 < inner.size(); ++j) faces_.push_back({outer[j], outer[j + 1], inner[j + 1], inner[j]});
  Line& before = sides_[(i + k - 1) % k];
  before.push_back(outer.front());
  Line& after = sides_[(i + 1) % k];
  after.insert(after.begin(), outer.back());
  sides_[i] = std::move(outer);
  ++strips_[i];
}

std::vector<int> StripGrowth::side_lengths() const {
  std::vector<int> lengths;
  for (const Line& side : sides_) lengths.push_back(static_cast<int>(side.size()) - 1);
  return lengths;
}

bool StripGrowth::complete() const {
  return std::all_of(strips_.begin(), strips_.end(), [](int e) { return e > 0; });
}

Region StripGrowth::region(int label) const {
  return rooted_at(vertices_, faces_, sides_[static_cast<std::size_t>(label - 1)].front());
}

Region grow_region(PairType type, const Configuration& c) {
  require(type, c);
  StripGrowth growth(type, c.d1(), c.d2());
  for (Integer round = 0; round < c.parameters.e.maxCoeff(); ++round) {
    for (int label = 1; label <= type.side_count(); ++label) {
      if (round < c.parameters.e(label - 1)) growth.add_strip(label);
    }
  }
  return growth.region(label_of_first_side(type, c));
}

// --- gluing ----------------------------------------------------------------------------------------------------------

namespace {

class Gluing {
 public:
  Gluing(PairType type, const Configuration& c)
      : type_(type), c_(c), corners_(static_cast<std::size_t>(type.side_count())) {}

  Region build() {
    const int outward1 = type_.l1 - 2;
    const int outward2 = type_.l2 - 2;
    const Integer a = c_.d2();
    const Integer b = c_.d1();
    // R_alpha: v1 -> x and y -> v2 along the first leg's direction, v1 -> y and x -> v2 along the second's.
    const int v1 = new_vertex();
    const Line v1_x = line_from(v1, a);
    const Line v1_y = line_from(v1, b);
    const std::vector<Line> core = rectangle(v1_x, v1_y, {});
    Line y_v2, x_v2;
    for (const Line& column : core) y_v2.push_back(column.back());
    x_v2 = core.back();
    const int v2 = x_v2.back();

    for (int i = 0; i < outward1; ++i) rays_.push_back(line_from(v1, c_.parameters.e(i)));
    for (int i = 0; i < outward2; ++i) rays_.push_back(line_from(v2, c_.parameters.e(outward1 + i)));
    for (int i = 0; i + 1 < outward1; ++i) between_outward(i);
    for (int i = 0; i + 1 < outward2; ++i) between_outward(outward1 + i);
    round_corner(outward1 - 1, outward1, v1_x, x_v2);
    round_corner(outward1 + outward2 - 1, 0, reversed(y_v2), reversed(v1_y));

    const int first = label_of_first_side(type_, c_) - 1;
    const std::size_t k = corners_.size();
    return rooted_at(vertices_, faces_, corners_[(static_cast<std::size_t>(first) + k - 1) % k]);
  }

 private:
  int new_vertex() { return vertices_++; }
  Line line_from(int start, Integer length) {
    Line line{start};
    for (Integer i = 0; i < length; ++i) line.push_back(new_vertex());
    return line;
  }
  static Line reversed(Line line) {
    std::reverse(line.begin(), line.end());
    return line;
  }

  // A rectangle from its lower line, its left line (which starts at the same vertex, counter-clockwise of the lower one)
  // and, if given, its upper line. All other vertices are new. Columns of vertices, left to right.
  std::vector<Line> rectangle(const Line& lower, const Line& left, const Line& upper) {
    std::vector<Line> grid(lower.size(), Line(left.size()));
    for (std::size_t i = 0; i < lower.size(); ++i) {
      for (std::size_t j = 0; j < left.size(); ++j) {
        if (j == 0) {
          grid[i][j] = lower[i];
        } else if (i == 0) {
          grid[i][j] = left[j];
        } else if (j + 1 == left.size() && !upper.empty()) {
          grid[i][j] = upper[i];
        } else {
          grid[i][j] = new_vertex();
        }
        if (i > 0 && j > 0) faces_.push_back({grid[i - 1][j - 1], grid[i][j - 1], grid[i][j], grid[i - 1][j]});
      }
    }
    return grid;
  }

  // Between consecutive outward separatrices of one vertex.
  void between_outward(int i) {
    const auto at = static_cast<std::size_t>(i);
    corners_[at] = rectangle(rays_[at], rays_[at + 1], {}).back().back();
  }

  // From the last outward separatrix of one vertex round a corner z of R_alpha to the first one of the other vertex:
  // along the first vertex's first leg to z, and along the other's second leg from z.
  void round_corner(int last, int first, const Line& to_z, const Line& from_z) {
    const Line& ray_last = rays_[static_cast<std::size_t>(last)];
    const Line& ray_first = rays_[static_cast<std::size_t>(first)];
    const int z = to_z.back();
    // The legs continued beyond z. A leg of length zero makes z the vertex itself, and the line one of its separatrices.
    const Line along_last = to_z.size() == 1 ? ray_last : line_from(z, static_cast<Integer>(ray_last.size()) - 1);
    const Line along_first = from_z.size() == 1 ? ray_first : line_from(z, static_cast<Integer>(ray_first.size()) - 1);
    if (to_z.size() > 1) rectangle(ray_last, to_z, along_last);
    if (from_z.size() > 1) rectangle(along_first, from_z, ray_first);
    corners_[static_cast<std::size_t>(last)] = rectangle(along_last, along_first, {}).back().back();
  }

  PairType type_;
  const Configuration& c_;
  int vertices_ = 0;
  std::vector<std::array<int, 4>> faces_;
  std::vector<Line> rays_;    // outward separatrices, by label - 1
  std::vector<int> corners_;  // between side i and side i + 1, by label - 1
};

}  // namespace

Region glue_region(PairType type, const Configuration& c) {
  require(type, c);
  return Gluing(type, c).build();
}

// As the merged vertex of a pair with valences k + 1 and 3.
Region glue_vertex(const theory::IntegerVector& e) {
  return glue_region({static_cast<int>(e.size()) + 1, 3}, {{0, 0, e}, 1});
}

}  // namespace requad::enumerate
