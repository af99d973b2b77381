#include "figures/grid_figure.hpp"

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <tuple>

namespace requad::figures {

namespace {

using enumerate::Exploration;
using enumerate::FoundMove;
using theory::Configuration;
using theory::PairType;

constexpr const char* kRed = "#c0392b";   // even sides
constexpr const char* kBlue = "#1f5fa8";  // odd sides
const char* parity_colour(int length) { return length % 2 == 0 ? kRed : kBlue; }

using Place = std::array<double, 2>;

// Adds a found grid to a figure. `place` puts a labelling somewhere; two labellings of one configuration that get two
// places make a node and its copy. Edges join the labellings that a move goes between.
void add_grid(GridFigure& figure, const Exploration& found, const std::string& prefix, const std::string& colour,
              const std::function<Place(const Configuration&)>& place) {
  std::map<std::pair<long, long>, int> node_at;
  const auto key = [](Place at) { return std::pair{std::lround(at[0] * 1024), std::lround(at[1] * 1024)}; };
  const auto add_node = [&](const Configuration& labelling, std::size_t found_node, int same_as) {
    const auto [it, is_new] = node_at.emplace(key(place(labelling)), static_cast<int>(figure.nodes.size()));
    if (is_new) {
      const auto& node = found.nodes[found_node];
      figure.nodes.push_back({prefix + std::to_string(figure.nodes.size()), theory::label(found.type, labelling), place(labelling),
                              colour, same_as, node.reading.configuration, node.region.mesh.face_count(), node.signature});
    }
    return it->second;
  };
  for (std::size_t i = 0; i < found.nodes.size(); ++i) {
    const Configuration& c = found.nodes[i].reading.configuration;
    const int node = add_node(c, i, -1);
    if (found.type.symmetric() && c.degenerate() && !c.merged()) add_node(theory::other_labelling(found.type, c), i, node);
  }
  // A move and its inverse join the same two places: keep the first met.
  std::set<std::pair<int, int>> drawn;
  for (const FoundMove& move : found.moves) {
    if (move.to < 0) continue;
    const auto from = node_at.find(key(place(move.before.value())));
    const auto to = node_at.find(key(place(move.after.value())));
    if (from == node_at.end() || to == node_at.end()) throw std::logic_error("a move leaves the grid");
    const std::pair<int, int> ends = std::minmax(from->second, to->second);
    if (!drawn.insert(ends).second) continue;
    figure.edges.push_back({from->second, to->second, mesh::name(move.move.step), move.operations,
                            move.faces_made - move.faces_deleted, colour});
  }
}

// The regular region of side `length` and the next smaller one, if it holds a pair.
std::vector<int> two_lengths(int length) {
  if (length < 3) throw std::invalid_argument("a regular region of side " + std::to_string(length) + " holds no pair; the least side is 3");
  return length == 3 ? std::vector<int>{3} : std::vector<int>{length, length - 1};
}

std::string sides_text(int length) {
  std::string text;
  for (const int l : two_lengths(length)) text += (text.empty() ? "" : " and ") + std::to_string(l);
  return text;
}

Exploration explore_regular(PairType type, int length) {
  return enumerate::explore_all(type, theory::IntegerVector::Constant(type.side_count(), length), theory::Apex::with);
}

}  // namespace

GridFigure figure_10(int length) {
  GridFigure figure{"Figure 10: configurations of a 3-3 pair in regular digons of side " + sides_text(length), {}, {}};
  for (const int l : two_lengths(length)) {
    const Exploration found = explore_regular(theory::kDigon, l);
    add_grid(figure, found, "L" + std::to_string(l) + "_", parity_colour(l), [](const Configuration& c) -> Place {
      return {static_cast<double>(c.d1() - c.d2()), static_cast<double>(c.d1() + c.d2())};
    });
  }
  return figure;
}

GridFigure figure_11(int length) {
  GridFigure figure{"Figure 11: configurations of a 5-5 pair in regular hexagons of side " + sides_text(length), {}, {}};
  for (const int l : two_lengths(length)) {
    const Exploration found = explore_regular(theory::kHexagon, l);
    const double shift = l == length ? 0.0 : 0.87 * (2 * length - 5) + 2;  // beside the first
    // The axis of (x,0,p) is that of (0,x,p+1): three axes, quadrant p between axis p and axis p - 1, p increasing
    // clockwise.
    const auto axis = [](int p) -> Place {
      const double angle = std::numbers::pi * (0.5 - 2.0 / 3.0 * (p - 1));
      return {std::cos(angle), std::sin(angle)};
    };
    add_grid(figure, found, "L" + std::to_string(l) + "_", parity_colour(l), [=](const Configuration& c) -> Place {
      const Place u = axis(c.p);
      const Place v = axis(c.p - 1);
      const auto m = static_cast<double>(c.d1());
      const auto n = static_cast<double>(c.d2());
      return {shift + m * u[0] + n * v[0], m * u[1] + n * v[1]};
    });
  }
  return figure;
}

GridFigure figure_12(int d1, int d2, int m, int n) {
  if (d1 < 0 || d2 < 0 || d1 + d2 == 0 || m < 1 || n < 1) {
    throw std::invalid_argument("a 3-5 region needs d1, d2 >= 0, not both 0, and M, N >= 1");
  }
  const theory::PairType type = theory::kQuad;
  Configuration first;
  first.parameters = {d1, d2, theory::IntegerVector::Ones(4)};
  first.parameters.e(2) = m;  // e1 + e3 = M + 1, e2 + e4 = N + 1
  first.parameters.e(3) = n;
  const theory::IntegerVector sides = theory::region_sides(type, first);
  GridFigure figure{"Figure 12: configurations of a 3-5 pair in a region with sides", {}, {}};
  for (const auto side : sides) figure.title += " " + std::to_string(side);
  const Exploration found = enumerate::explore_all(type, sides, theory::Apex::without);
  add_grid(figure, found, "n", kBlue, [type](const Configuration& c) -> Place {
    const theory::GridPoint at = theory::grid_point(type, theory::canonical(type, c));
    return {static_cast<double>(at.m), static_cast<double>(at.n)};
  });
  return figure;
}

}  // namespace requad::figures
