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

void require(PairType type, const Configuration& c) {
  theory::StripParameters p = c.parameters;
  if (c.merged()) p.d1 = 1;  // parameters_problem() would refuse the merged vertex; the rest is checked
  if (const std::string problem = theory::parameters_problem(type, p); !problem.empty())
    throw std::invalid_argument(problem);
  // The number of quads must fit a half-edge index. Lengths up to kMaxLength do not ensure that.
  const Integer faces = theory::PairSystem(type).face_count(c.parameters);
  if (faces > 20'000'000)
    throw std::invalid_argument("the region would have " + std::to_string(faces) +
                                " quads, more than the 20 million that are made here");
}

// The label of the region's side 1.
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
  const Core core = make_core(static_cast<int>(d1), static_cast<int>(d2));
  add_sides(core.to_v1, core.from_v1, type.l1 - 2);
  add_sides(core.to_v2, core.from_v2, type.l2 - 2);
  strips_.assign(sides_.size(), 0);
}

// R_alpha has v1 at column 0 of row 0. The first leg of v1 runs along row 0.
StripGrowth::Core StripGrowth::make_core(int d1, int d2) {
  std::vector<Line> columns(static_cast<std::size_t>(d2) + 1, Line(static_cast<std::size_t>(d1) + 1));
  for (Line& column : columns) {
    for (int& v : column) v = new_vertex();
  }
  for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
    for (std::size_t j = 0; j + 1 < columns[i].size(); ++j) {
      faces_.push_back({columns[i][j], columns[i + 1][j], columns[i + 1][j + 1], columns[i][j + 1]});
    }
  }
  Core core;
  for (const Line& column : columns) {
    core.from_v1.push_back(column.front());
    core.from_v2.push_back(column.back());
  }
  std::reverse(core.from_v2.begin(), core.from_v2.end());
  core.to_v2 = columns.back();
  core.to_v1 = columns.front();
  std::reverse(core.to_v1.begin(), core.to_v1.end());
  return core;
}

// Appends the sides that a vertex's outward separatrices cross. They run counter-clockwise down its second leg to the
// vertex and then along its first leg. The first separatrix crosses the side along the second leg, and the last one the
// side along the first leg. Those between cross a side of length 0. A single separatrix crosses one side along both
// legs.
void StripGrowth::add_sides(const Line& second_leg, const Line& first_leg, int outward) {
  if (outward == 1) {
    Line both = second_leg;
    both.insert(both.end(), first_leg.begin() + 1, first_leg.end());
    sides_.push_back(both);
    return;
  }
  sides_.push_back(second_leg);
  for (int i = 2; i < outward; ++i) sides_.push_back({first_leg.front()});
  sides_.push_back(first_leg);
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

using Line = std::vector<int>;  // the vertices along a path

class Gluing {
 public:
  Gluing(PairType type, const Configuration& c)
      : c_(c),
        outward1_(type.l1 - 2),
        outward2_(type.l2 - 2),
        label_of_first_side_(enumerate::label_of_first_side(type, c)),
        corners_(static_cast<std::size_t>(type.side_count())) {}

  Region build() {
    // R_alpha has the corners v1, x, v2, y, counter-clockwise.
    const int v1 = new_vertex();
    const Line v1_x = line_from(v1, c_.d2());  // the first leg of v1
    const Line v1_y = line_from(v1, c_.d1());  // the second
    const std::vector<Line> columns = rectangle(v1_x, v1_y, {});
    const Line& x_v2 = columns.back();
    Line y_v2;
    for (const Line& column : columns) y_v2.push_back(column.back());

    add_rays(v1, outward1_);
    add_rays(x_v2.back(), outward2_);
    for (int i = 0; i + 1 < outward1_; ++i) fill_between_rays(i);
    for (int i = 0; i + 1 < outward2_; ++i) fill_between_rays(outward1_ + i);
    fill_round_corner(outward1_ - 1, outward1_, v1_x, x_v2);
    fill_round_corner(outward1_ + outward2_ - 1, 0, reversed(y_v2), reversed(v1_y));

    const int first = label_of_first_side_ - 1;
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
  // Starts the next `count` outward separatrices at v.
  void add_rays(int v, int count) {
    for (int i = 0; i < count; ++i) rays_.push_back(line_from(v, c_.parameters.e(static_cast<int>(rays_.size()))));
  }
  static Line reversed(Line line) {
    std::reverse(line.begin(), line.end());
    return line;
  }

  // Makes a rectangle and returns its columns of vertices from left to right. The lower and the left line start at the
  // same vertex, the left one counter-clockwise of the lower one. The vertices on `upper` are new if it is empty. All
  // other vertices are new.
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

  // The rectangle between two consecutive outward separatrices of one vertex.
  void fill_between_rays(int i) {
    const auto at = static_cast<std::size_t>(i);
    corners_[at] = rectangle(rays_[at], rays_[at + 1], {}).back().back();
  }

  // Makes the three rectangles round a corner z of R_alpha, from the last outward separatrix of one vertex to the first
  // one of the other vertex. `to_z` is the first leg of the former, `from_z` the reversed second leg of the latter.
  void fill_round_corner(int last, int first, const Line& to_z, const Line& from_z) {
    const Line& ray_last = rays_[static_cast<std::size_t>(last)];
    const Line& ray_first = rays_[static_cast<std::size_t>(first)];
    const int z = to_z.back();
    // The legs continued beyond z. If a leg has length 0, then z is its vertex, and its continuation is one of the
    // rays.
    const Line along_last = to_z.size() == 1 ? ray_last : line_from(z, static_cast<Integer>(ray_last.size()) - 1);
    const Line along_first = from_z.size() == 1 ? ray_first : line_from(z, static_cast<Integer>(ray_first.size()) - 1);
    if (to_z.size() > 1) rectangle(ray_last, to_z, along_last);
    if (from_z.size() > 1) rectangle(along_first, from_z, ray_first);
    corners_[static_cast<std::size_t>(last)] = rectangle(along_last, along_first, {}).back().back();
  }

  const Configuration& c_;
  const int outward1_;  // how many outward separatrices v1 has
  const int outward2_;
  const int label_of_first_side_;
  int vertices_ = 0;
  std::vector<std::array<int, 4>> faces_;
  std::vector<Line> rays_;    // the outward separatrices, by label - 1
  std::vector<int> corners_;  // between side i and side i + 1, by label i - 1
};

}  // namespace

Region glue_region(PairType type, const Configuration& c) {
  require(type, c);
  return Gluing(type, c).build();
}

// Glues it as the merged vertex of a pair with valences k + 1 and 3.
Region glue_vertex(const theory::IntegerVector& e) {
  return glue_region({static_cast<int>(e.size()) + 1, 3}, {{0, 0, e}, 1});
}

}  // namespace requad::enumerate
