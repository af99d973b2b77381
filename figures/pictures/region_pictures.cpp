#include <algorithm>
#include <cmath>
#include <numeric>

#include "enumerate/generators.hpp"
#include "enumerate/labels.hpp"
#include "figures/panels/labels.hpp"
#include "figures/panels/sheet.hpp"
#include "figures/pictures/paper_pictures.hpp"
#include "mesh/topology/separatrix.hpp"

namespace requad::figures {

namespace {

using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Region;
using mesh::VertexId;

// The mark of a turn: convex a disc, concave a ring. No irregular vertex looks like them.
void mark_turn(Canvas& canvas, Point at, bool convex) {
  constexpr double kRadius = 3.8;
  if (convex) {
    canvas.circle(at, kRadius, canvas.palette().convex, Stroke{canvas.palette().ink, 0.5});
  } else {
    canvas.circle(at, kRadius, canvas.palette().paper, Stroke{canvas.palette().concave, 1.8});
  }
}

// The path that starts with h. At each vertex it goes straight on for 's', left for 'l' and right for 'r'.
std::vector<HalfEdgeId> path_of(const QuadMesh& m, HalfEdgeId h, const std::string& turns) {
  std::vector<HalfEdgeId> path{h};
  for (const char turn : turns) {
    const HalfEdgeId left = QuadMesh::next(path.back());
    path.push_back(turn == 'l' ? left : turn == 's' ? m.cw(left) : m.cw(m.cw(left)));
  }
  return path;
}

// The number of quads on the left of a path at the vertex between two consecutive half-edges.
int quads_on_left(const QuadMesh& m, HalfEdgeId in, HalfEdgeId out) {
  int quads = 1;
  for (HalfEdgeId h = QuadMesh::next(in); h != out && h.valid(); h = m.cw(h)) ++quads;
  return quads;
}

void mark_turns(Canvas& canvas, const MeshPicture& picture, const std::vector<HalfEdgeId>& path, bool loop) {
  for (std::size_t i = loop ? 0 : 1; i < path.size(); ++i) {
    const HalfEdgeId in = path[(i + path.size() - 1) % path.size()];
    const int quads = quads_on_left(picture.mesh(), in, path[i]);
    if (quads != 2) mark_turn(canvas, picture.at(picture.mesh().origin(path[i])), quads == 1);
  }
}

// --- Figure 14 -------------------------------------------------------------------------------------------------------

// The frame of a region whose labels are those of the region: label 1 on side 1.
mesh::PairFrame own_frame(const Region& region, theory::PairType type) {
  const enumerate::Reading reading = enumerate::read(region, type);
  return std::find_if(reading.frames.begin(), reading.frames.end(), [](const auto& f) { return f.labelling.p == 1; })
      ->frame;
}

// What a region of Figure 14 has beside its mesh: sides, corners, separatrices, and their names.
class Names {
 public:
  Names(Canvas& canvas, const MeshPicture& picture, const mesh::PairFrame& frame)
      : canvas_(canvas), picture_(picture), m_(picture.mesh()), frame_(frame), places_(canvas) {}

  void paint() {
    picture_.boundary(canvas_, {canvas_.palette().side, 2});
    const auto separatrices = outward();
    for (const auto& path : separatrices) picture_.path(canvas_, path, dashed());
    places_.block(closed(picture_.outline()), 3);
    for (const auto& path : separatrices) places_.block(picture_.line(path), 3);
    for (const auto& path : separatrices) star(path);
    for (const VertexId v : {frame_.v1, frame_.v2}) places_.block_point(picture_.at(v), kMarkRadius);
    picture_.irregular(canvas_);
    sides();
    constexpr std::array directions{0.4, 2.7, -0.4, -2.7, 1.2, 1.9, -1.2, -1.9, 0.0, 3.14, 0.8, 2.3, -0.8, -2.3};
    for (const auto& [v, words] : {std::pair{frame_.v1, "v_1"}, {frame_.v2, "v_2"}}) {
      const double r = kMarkRadius;
      const Point at = picture_.at(v);
      const Polyline mark{at + Point(-r, -r), at + Point(r, -r), at + Point(r, r), at + Point(-r, r)};
      places_.put(words, canvas_.palette().ink, places_.round(mark, words, directions));
    }
    for (std::size_t i = 0; i < separatrices.size(); ++i)
      name_path(separatrices[i], "e_" + std::to_string(i + 1), canvas_.palette().path);
    // The legs of v1: the first is d2 long, the second d1 (mesh/irregular/pair_frame.hpp).
    name_path(leg(frame_.first_leg, frame_.d2), "d_2", canvas_.palette().ink);
    name_path(leg(frame_.second_leg, frame_.d1), "d_1", canvas_.palette().ink);
  }

 private:
  // Told from the sides, which are solid, without colours.
  Stroke dashed() const { return {canvas_.palette().path, 2, {5, 3.6}}; }
  static Polyline closed(Polyline line) {
    line.push_back(line.front());
    return line;
  }
  std::vector<std::vector<HalfEdgeId>> outward() const {
    std::vector<std::vector<HalfEdgeId>> paths;
    for (const HalfEdgeId h : mesh::outward_of_both(m_, frame_)) paths.push_back(mesh::trace(m_, h).path);
    return paths;
  }
  std::vector<HalfEdgeId> leg(HalfEdgeId h, int length) const {
    std::vector<HalfEdgeId> path{h};
    while (static_cast<int>(path.size()) < length) path.push_back(m_.straight(path.back()));
    return path;
  }
  void star(const std::vector<HalfEdgeId>& path) {
    const Point at = picture_.at(m_.target(path.back()));
    mark_star(canvas_, at, 5, canvas_.palette().first_star);
    places_.block_point(at, 5);
  }
  // A name beside the middle of one of the edges of a path, the middle and outer ones first.
  void name_path(const std::vector<HalfEdgeId>& path, const std::string& words, Colour colour) {
    const double em = canvas_.em(), half = canvas_.width_of(words) / 2;
    std::vector<std::size_t> order(path.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto from_middle = [&](std::size_t i) {
      return std::abs(static_cast<double>(i) + 0.4 - static_cast<double>(path.size()) / 2);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return from_middle(a) < from_middle(b); });
    std::vector<LabelPlaces::Place> places;
    for (const std::size_t i : order) {
      const Point from = picture_.at(m_.origin(path[i])), to = picture_.at(m_.target(path[i]));
      const Point along = (to - from).normalized(), across(-along.y(), along.x());
      const double away = 4 + std::abs(across.x()) * half + std::abs(across.y()) * 0.45 * em;
      for (const double side : {1.0, -1.0, 1.25, -1.25, 1.8, -1.8}) {
        for (const double shift : {0.0, 0.25, -0.25})
          places.push_back({(from + to) / 2 + shift * (to - from) + side * away * across - Point(0, 0.27 * em)});
      }
    }
    places_.put(words, colour, places);
  }
  // Corners, and lengths of sides outside of the region.
  void sides() {
    const std::vector<int> lengths = mesh::side_lengths(picture_.region());
    const Point page = (picture_.low() + picture_.high()) / 2;
    HalfEdgeId h = picture_.region().root;
    for (std::size_t side = 0; side < lengths.size(); ++side) {
      mark_turn(canvas_, picture_.at(m_.origin(h)), true);
      std::vector<Point> points{picture_.at(m_.origin(h))};
      for (int i = 0; i < lengths[side]; ++i) {
        h = m_.next_on_boundary(h);
        points.push_back(picture_.at(m_.origin(h)));
      }
      const auto length = points.size() - 1;
      const Point middle = (points[length / 2] + points[(length + 1) / 2]) / 2;
      const Point along = (points[length / 2 + 1] - points[(length - 1) / 2]).normalized();
      const Point out = (middle - page).dot(Point(along.y(), -along.x())) > 0 ? Point(along.y(), -along.x())
                                                                              : Point(-along.y(), along.x());
      const std::string words = "E_" + std::to_string(side + 1) + " = " + std::to_string(lengths[side]);
      const double em = canvas_.em(), half = canvas_.width_of(words) / 2;
      const double away = 5 + std::abs(out.x()) * half + std::abs(out.y()) * 0.5 * em;
      std::vector<LabelPlaces::Place> places;
      for (const double more : {0.0, 0.4, 0.8, 1.2})
        places.push_back({middle + (away + more * em) * out - Point(0, 0.27 * em)});
      places_.put(words, canvas_.palette().side, places);
    }
  }

  Canvas& canvas_;
  const MeshPicture& picture_;
  const QuadMesh& m_;
  const mesh::PairFrame& frame_;
  LabelPlaces places_;
};

}  // namespace

Paint paint_turns_and_smallest() {
  Sheet sheet(34, 22);
  // A grid of regular vertices is the region of a "vertex of valence 4".
  const Region grid = region_with({4, 4}, 0, 0, {3, 4, 3, 4});
  // The path starts at the first interior vertex on the diagonal, to the right.
  const HalfEdgeId first = grid.mesh.straight(grid.mesh.twin(QuadMesh::opposite(grid.root)));
  for (const bool loop : {false, true}) {
    const auto path = path_of(grid.mesh, first, loop ? "sssslslsrslsslsss" : "slsrslr");
    Panel panel{grid, {loop ? "(a) a loop" : "(a) an open path"}};
    panel.lines = {{path}};
    panel.overlay = [path, loop](Canvas& canvas, const MeshPicture& picture) {
      mark_turns(canvas, picture, path, loop);
    };
    panel.unit = 19;
    sheet.add(panel, 0, loop ? 1.55 : 0.45);
  }
  const std::array<std::pair<theory::PairType, std::vector<theory::Integer>>, 3> kinds{
      {{theory::kDigon, {1, 1}}, {theory::kHexagon, {1, 1, 1, 1, 1, 1}}, {theory::kQuad, {1, 1, 1, 1}}}};
  const std::array<std::array<theory::Integer, 2>, 3> extents{{{3, 2}, {2, 3}, {4, 0}}};
  for (std::size_t row = 0; row < kinds.size(); ++row) {
    for (std::size_t column = 0; column < extents.size(); ++column) {
      const auto [d1, d2] = extents[column];
      Panel panel{
          region_with(kinds[row].first, d1, d2, kinds[row].second),
          {"(b) " + kinds[row].first.name() + ": d_1 = " + std::to_string(d1) + ", d_2 = " + std::to_string(d2)}};
      const enumerate::Reading reading = enumerate::read(panel.region, kinds[row].first);
      const mesh::PairFrame& frame = reading.frames.at(0).frame;
      panel.grey = mesh::ring(panel.region.mesh, frame);
      panel.blue = mesh::grid(panel.region.mesh, frame).value();
      panel.unit = 17;
      sheet.add(panel, static_cast<int>(row) + 1, static_cast<double>(column));
    }
  }
  return sheet.paint();
}

Paint paint_separatrices() {
  struct Kind {
    theory::PairType type;
    theory::Integer d1, d2;
    std::vector<theory::Integer> strips;
    double unit;
    const char* words;
  };
  const std::vector<Kind> kinds{{theory::kDigon, 3, 2, {2, 3}, 25, "(a) a 3-3 pair"},
                                {theory::kHexagon, 3, 2, {2, 2, 2, 3, 2, 2}, 22, "(b) a 5-5 pair"},
                                {theory::kQuad, 3, 2, {2, 3, 2, 2}, 24, "(c) a 3-5 pair"}};
  Sheet sheet(14);
  for (const Kind& kind : kinds) {
    Panel panel{region_with(kind.type, kind.d1, kind.d2, kind.strips), {kind.words}};
    const mesh::PairFrame frame = own_frame(panel.region, kind.type);
    panel.blue = mesh::grid(panel.region.mesh, frame).value();
    panel.unit = kind.unit;
    panel.overlay = [frame](Canvas& canvas, const MeshPicture& picture) { Names(canvas, picture, frame).paint(); };
    panel.margin = [](const Canvas& canvas) {
      return canvas.style().labels ? Point(3.8, 1.6) * canvas.em() : Point(0, 0);
    };
    sheet.add(panel, 0, static_cast<double>(&kind - kinds.data()));
  }
  return sheet.paint();
}

Paint paint_lone_v8(int length) {
  const theory::PairType type{6, 6};  // merged: a v8
  constexpr double kSize = 118;
  Sheet sheet(26, 20);
  for (const theory::Configuration& c :
       theory::merged_configurations({type, theory::IntegerVector::Constant(8, length)})) {
    const theory::Integer i = c.parameters.e(0), j = c.parameters.e(1);
    Panel panel{enumerate::glue_region(type, c), {"e_1 = " + std::to_string(i) + ", e_2 = " + std::to_string(j)}};
    const VertexId v = mesh::irregular_vertices(panel.region.mesh).at(0);
    panel.region.mesh.for_each_out(v, [&](HalfEdgeId h) {
      panel.lines.push_back({mesh::trace(panel.region.mesh, h).path, Panel::Line::Kind::thin});
    });
    const MeshPicture probe(panel.region, Point::Zero(), 1);
    panel.unit = kSize / (probe.high().x() - probe.low().x());
    sheet.add(panel, length - static_cast<int>(j), static_cast<double>(i));
  }
  return sheet.paint();
}

}  // namespace requad::figures
