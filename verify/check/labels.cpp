#include "verify/check/labels.hpp"

#include <algorithm>
#include <optional>

#include "verify/check/reading.hpp"

namespace check {

namespace {

// A vertex of a path, and the one before it.
struct Arrival {
  int from;
  int at;
  int length;  // in edges
};

std::size_t position(const Disk::Star& star, int end) {
  return static_cast<std::size_t>(std::find(star.ends.begin(), star.ends.begin() + star.size, end) - star.ends.begin());
}

// Follows paths of edges on a mesh with few irregular vertices.
class Tracer {
 public:
  explicit Tracer(const Disk& disk) : disk_(disk) {}

  // The end that comes `turn` places counter-clockwise after the one where a path came from.
  int turned(int at, int from, std::size_t turn) const {
    const Disk::Star star = disk_.star(at);
    return star.ends[(position(star, from) + turn) % star.size];
  }
  bool regular(int v) const { return disk_.inside(v) && disk_.star(v).size == 4; }
  // The separatrix whose first edge is from -> at, to where it ends: on the boundary or at an irregular vertex.
  Arrival trace(int from, int at) const { return walk({from, at, 1}, disk_.vertices()); }
  // Goes on straight until the length is `length` or the path ends.
  Arrival walk(Arrival path, int length) const {
    while (path.length < length && regular(path.at)) {
      const int next = turned(path.at, path.from, 2);
      path = {path.at, next, path.length + 1};
    }
    return path;
  }

 private:
  const Disk& disk_;
};

class Reader {
 public:
  Reader(const Region& region, const Disk& disk) : region_(region), disk_(disk), tracer_(disk) {
    for (std::size_t s = 0; s < region.sides.size(); ++s) {
      for (int i = 0; i < region.sides[s]; ++i) side_of_.push_back(i == 0 ? -1 : static_cast<int>(s));
    }
  }

  std::vector<Labelling> merged(int v) const {
    std::vector<int> outward;
    const Disk::Star star = disk_.star(v);
    for (std::size_t i = 0; i < star.size; ++i) outward.push_back(star.ends[i]);
    Labelling one = labelling(0, 0, {v, v}, outward, outward.size());
    std::rotate(one.e.begin(), one.e.end() - (one.p - 1), one.e.end());
    one.p = 1;
    std::vector<Labelling> all;
    for (int p = 1; p <= region_.labellings(); ++p) {
      all.push_back(one);
      std::rotate(one.e.begin(), one.e.begin() + 1, one.e.end());
      ++one.p;
    }
    return all;
  }

  std::vector<Labelling> pair(int v1, int v2) const {
    std::vector<Labelling> all;
    const Disk::Star star = disk_.star(v1);
    for (std::size_t leg = 0; leg < star.size; ++leg) {
      for_each_frame(v1, v2, star.ends[leg], [&](int d1, int d2, int second_leg_of_v2) {
        std::vector<int> outward;
        for (std::size_t i = 2; i < star.size; ++i) outward.push_back(star.ends[(leg + i) % star.size]);
        const std::size_t of_v1 = outward.size();
        for (int i = 1; i <= region_.l2 - 2; ++i)
          outward.push_back(tracer_.turned(v2, second_leg_of_v2, static_cast<std::size_t>(i)));
        all.push_back(labelling(d1, d2, {v1, v2}, outward, of_v1));
      });
    }
    require(!all.empty(), "the separatrices of the pair span no grid");
    std::sort(all.begin(), all.end(), std::greater<>());  // d1 > 0 first
    const Labelling& first = all[0];
    if (first.d1 > 0 && first.d2 > 0) {
      require(all.size() == 1, "the pair spans two grids");
    } else {
      require(all.size() == 2 && other(first) == all[1], "a segment does not have its two labellings");
    }
    return all;
  }

 private:
  // Calls found(d1, d2, second leg of v2) for each grid from v1 to v2 whose first leg starts with v1 -> leg.
  template <class Found>
  void for_each_frame(int v1, int v2, int leg, Found&& found) const {
    const int second_leg = tracer_.turned(v1, leg, 1);
    // A segment along the second leg.
    if (const Arrival end = tracer_.trace(v1, second_leg); end.at == v2) found(end.length, 0, end.from);
    Arrival path{v1, leg, 1};
    for (;; path = tracer_.walk(path, path.length + 1)) {
      if (path.at == v2) {
        found(0, path.length, tracer_.turned(v2, path.from, 1));
        return;
      }
      if (!tracer_.regular(path.at)) return;
      // To the left, and the same grid the other way round.
      const Arrival end = tracer_.trace(path.at, tracer_.turned(path.at, path.from, 3));
      if (end.at == v2) {
        const Arrival corner = tracer_.walk({v1, second_leg, 1}, end.length);
        if (corner.length == end.length && tracer_.regular(corner.at)) {
          const Arrival other = tracer_.walk({corner.at, tracer_.turned(corner.at, corner.from, 1), 1}, path.length);
          if (other.at == v2 && other.length == path.length) found(end.length, path.length, end.from);
        }
      }
      require(path.length < disk_.vertices(), "a separatrix does not end");
    }
  }

  // The labelling with these first vertices of the outward separatrices; `of_v1` of them leave the first vertex.
  Labelling labelling(int d1, int d2, std::array<int, 2> pair, const std::vector<int>& outward,
                      std::size_t of_v1) const {
    const std::size_t k = region_.sides.size();
    Labelling result{d1, d2, 1, {}};
    for (std::size_t i = 0; i < k; ++i) {
      const Arrival end = tracer_.trace(pair[i < of_v1 ? 0 : 1], outward[i]);
      const int side = disk_.inside(end.at) ? -1 : side_of_[static_cast<std::size_t>(end.at)];
      if (i == 0) result.p = side + 1;
      require(side >= 0 && static_cast<std::size_t>(side) == (static_cast<std::size_t>(result.p - 1) + i) % k,
              "an outward separatrix does not meet its side");
      result.e.push_back(end.length);
    }
    for (std::size_t i = 0; i < k; ++i) {
      const bool of_pair = d1 + d2 > 0;
      const bool first = of_pair && (i == 0 || i == of_v1);
      const bool last = of_pair && (i + 1 == of_v1 || i + 1 == k);
      const int length = result.e[(i + k - 1) % k] + result.e[(i + 1) % k] + (first ? d1 : 0) + (last ? d2 : 0);
      require(length == region_.sides[(static_cast<std::size_t>(result.p - 1) + i) % k],
              "the separatrices do not obey the side-length law");
    }
    reduce(result);
    return result;
  }

  // Of two equal vertices either may be v1.
  void reduce(Labelling& labelling) const {
    const int half = region_.side_count() / 2;
    if (!region_.symmetric() || labelling.p <= half) return;
    labelling.p -= half;
    std::rotate(labelling.e.begin(), labelling.e.begin() + half, labelling.e.end());
  }

  Labelling other(const Labelling& segment) const {
    Labelling result{0, segment.d1, segment.p % region_.side_count() + 1, segment.e};
    std::rotate(result.e.begin(), result.e.begin() + 1, result.e.end());
    reduce(result);
    return result;
  }

  const Region& region_;
  const Disk& disk_;
  Tracer tracer_;
  std::vector<int> side_of_;  // of each boundary vertex; -1: a corner
};

}  // namespace

std::string label(const Region& region, const Labelling& labelling) {
  const bool merged = labelling.d1 + labelling.d2 == 0;
  const int m = region.symmetric() ? labelling.d1 : labelling.e[0];
  const int n = region.symmetric() ? labelling.d2 : labelling.e[1];
  std::string text = "(" + std::to_string(m) + "," + std::to_string(n);
  if (region.l2 == 5 && !merged) text += "," + std::to_string(labelling.p);
  return text + ")";
}

std::vector<Labelling> read_labellings(const Region& region, const Disk& disk) {
  const std::vector<Irregular>& irregular = disk.irregular();
  const Reader reader(region, disk);
  if (irregular.size() == 1 && region.symmetric() && irregular[0].index == 4 - region.side_count())
    return reader.merged(irregular[0].vertex);
  if (irregular.size() == 2) {
    const auto [a, b] = std::array{irregular[0], irregular[1]};
    if (a.index == 4 - region.l1 && b.index == 4 - region.l2) return reader.pair(a.vertex, b.vertex);
    if (b.index == 4 - region.l1 && a.index == 4 - region.l2) return reader.pair(b.vertex, a.vertex);
  }
  throw Rejected("the irregular vertices are neither the pair nor the merged vertex");
}

}  // namespace check
