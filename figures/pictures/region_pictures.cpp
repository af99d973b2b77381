#include "figures/pictures/region_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "enumerate/generators.hpp"
#include "enumerate/labels.hpp"
#include "figures/pictures/panel.hpp"
#include "mesh/topology/separatrix.hpp"

namespace requad::figures {

namespace {

using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Region;
using mesh::VertexId;

void triangle(Canvas& canvas, Point at, bool convex) {
  constexpr double kRadius = 5;
  const double s = convex ? 1 : -1;
  canvas.polygon(
      {at + kRadius * Point(0, s), at + kRadius * Point(-0.87, -0.5 * s), at + kRadius * Point(0.87, -0.5 * s)},
      convex ? ink::kBlue : ink::kRed, Stroke{ink::kBlack, 0.5});
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

void paint_path(Canvas& canvas, const MeshPicture& picture, const std::vector<HalfEdgeId>& path, bool loop) {
  picture.path(canvas, path, kGreenLine);
  for (std::size_t i = loop ? 0 : 1; i < path.size(); ++i) {
    const HalfEdgeId in = path[(i + path.size() - 1) % path.size()];
    const int quads = quads_on_left(picture.mesh(), in, path[i]);
    if (quads != 2) triangle(canvas, picture.at(picture.mesh().origin(path[i])), quads == 1);
  }
}

}  // namespace

Paint paint_turns_and_smallest() {
  return [](Canvas& canvas) {
    // A grid of regular vertices is the region of a "vertex of valence 4".
    const Region grid = region_with({4, 4}, 0, 0, {3, 4, 3, 4});
    const QuadMesh& m = grid.mesh;
    // The path starts at the first interior vertex on the diagonal, to the right.
    const HalfEdgeId first = m.straight(m.twin(QuadMesh::opposite(grid.root)));
    for (const bool loop : {false, true}) {
      const MeshPicture picture(grid, {loop ? 400.0 : 130.0, 0}, 26);
      picture.background(canvas, rgb(0xffffff));
      picture.edges(canvas);
      paint_path(canvas, picture, path_of(m, first, loop ? "sssslslsrslsslsss" : "slsrslr"), loop);
      canvas.text({loop ? 400.0 : 130.0, picture.low().y() - 16}, loop ? "a loop" : "an open path", 10);
    }
    canvas.text({-20, 0}, "(a)", 12);
    const std::array<std::pair<theory::PairType, std::vector<theory::Integer>>, 3> kinds{
        {{theory::kDigon, {1, 1}}, {theory::kHexagon, {1, 1, 1, 1, 1, 1}}, {theory::kQuad, {1, 1, 1, 1}}}};
    const std::array<std::array<theory::Integer, 2>, 3> extents{{{3, 2}, {2, 3}, {4, 0}}};
    canvas.text({-20, -200}, "(b)", 12);
    for (std::size_t row = 0; row < kinds.size(); ++row) {
      for (std::size_t column = 0; column < extents.size(); ++column) {
        const auto [d1, d2] = extents[column];
        Panel panel{region_with(kinds[row].first, d1, d2, kinds[row].second),
                    {kinds[row].first.name() + ":  d_1 = " + std::to_string(d1) + ", d_2 = " + std::to_string(d2)}};
        const enumerate::Reading reading = enumerate::read(panel.region, kinds[row].first);
        const mesh::PairFrame& frame = reading.frames.at(0).frame;
        panel.grey = mesh::ring(panel.region.mesh, frame);
        panel.blue = mesh::grid(panel.region.mesh, frame).value();
        paint_panel(canvas, panel, {90 + 190 * static_cast<double>(column), -200 - 165 * static_cast<double>(row)}, 17);
      }
    }
  };
}

Paint paint_separatrices() {
  return [](Canvas& canvas) {
    struct Kind {
      theory::PairType type;
      theory::Integer d1, d2;
      std::vector<theory::Integer> strips;
      double x, unit;
      const char* words;
    };
    const std::vector<Kind> kinds{{theory::kDigon, 3, 2, {2, 3}, 0, 27, "(a) a 3-3 pair"},
                                  {theory::kHexagon, 3, 2, {2, 2, 2, 3, 2, 2}, 370, 21, "(b) a 5-5 pair"},
                                  {theory::kQuad, 3, 2, {2, 3, 2, 2}, 690, 21, "(c) a 3-5 pair"}};
    for (const Kind& kind : kinds) {
      const Region region = region_with(kind.type, kind.d1, kind.d2, kind.strips);
      const MeshPicture picture(region, {kind.x, 0}, kind.unit);
      const QuadMesh& m = region.mesh;
      const enumerate::Reading reading = enumerate::read(region, kind.type);
      // The frame whose labels are those of the region: label 1 on side 1.
      const auto frame = std::find_if(reading.frames.begin(), reading.frames.end(), [](const auto& f) {
                           return f.labelling.p == 1;
                         })->frame;
      picture.background(canvas, rgb(0xffffff));
      picture.faces(canvas, mesh::grid(m, frame).value(), ink::kPaleBlue);
      picture.edges(canvas);
      picture.boundary(canvas, {ink::kRed, 2});
      const Point centre = (picture.at(frame.v1) + picture.at(frame.v2)) / 2;

      int label = 0;
      std::vector<Point> stars;
      for (const HalfEdgeId h : mesh::outward_of_both(m, frame)) {
        ++label;
        const auto path = mesh::trace(m, h).path;
        picture.path(canvas, path, kGreenLine);
        stars.push_back(picture.at(m.target(path.back())));
        // The text lies beside the middle edge of the separatrix, clear of the line.
        const HalfEdgeId at = path[path.size() / 2];
        const Point from = picture.at(m.origin(at)), to = picture.at(m.target(at));
        const Point along = (to - from).normalized();
        canvas.text((from + to) / 2 + 9 * Point(-along.y(), along.x()) - Point(0, 4), "e_" + std::to_string(label), 11,
                    ink::kGreen);
      }
      // The legs of v1: the first is d2 long, the second d1 (mesh/irregular/pair_frame.hpp).
      const auto leg_text = [&](HalfEdgeId h, int length, const std::string& words) {
        for (int i = 0; i < length / 2; ++i) h = m.straight(h);
        const Point from = picture.at(m.origin(h)), to = picture.at(m.target(h));
        const Point middle = length % 2 == 0 ? from : Point((from + to) / 2);
        canvas.text(middle + 0.35 * (centre - middle).normalized() * 21 - Point(0, 4), words, 11);
      };
      leg_text(frame.first_leg, frame.d2, "d_2");
      leg_text(frame.second_leg, frame.d1, "d_1");
      for (const Point& star : stars) mark_star(canvas, star, 5, ink::kYellow);
      picture.irregular(canvas, 5);
      for (const auto& [v, name] : {std::pair{frame.v1, "v_1"}, {frame.v2, "v_2"}}) {
        const Point out = (picture.at(v) - centre).normalized();
        canvas.text(picture.at(v) + 13 * Point(out.y(), -out.x()) - Point(0, 4), name, 11);
      }
      // The sides: their corners and lengths.
      const std::vector<int> sides = mesh::side_lengths(region);
      const Point page = (picture.low() + picture.high()) / 2;
      HalfEdgeId h = region.root;
      for (std::size_t side = 0; side < sides.size(); ++side) {
        triangle(canvas, picture.at(m.origin(h)), true);
        const auto on_side = [&](int edges) {
          HalfEdgeId g = h;
          for (int i = 0; i < edges; ++i) g = m.next_on_boundary(g);
          return picture.at(m.origin(g));
        };
        const int length = sides[side];
        const Point middle = (on_side(length / 2) + on_side((length + 1) / 2)) / 2;
        const Point out = (middle - page).normalized();
        for (int i = 0; i < length; ++i) h = m.next_on_boundary(h);
        canvas.text(middle + Point(30 * out.x(), 17 * out.y()) - Point(0, 4),
                    "E_" + std::to_string(side + 1) + " = " + std::to_string(sides[side]), 11, ink::kRed);
      }
      canvas.text({kind.x, -150}, kind.words, 12);
    }
  };
}

Paint paint_lone_v8(int length) {
  return [length](Canvas& canvas) {
    const theory::PairType type{6, 6};  // merged: a v8
    constexpr double kSpacing = 130, kSize = 106;
    for (const theory::Configuration& c :
         theory::merged_configurations({type, theory::IntegerVector::Constant(8, length)})) {
      const theory::Integer i = c.parameters.e(0), j = c.parameters.e(1);
      Panel panel{enumerate::glue_region(type, c), {"e_1 = " + std::to_string(i) + ", e_2 = " + std::to_string(j)}};
      const VertexId v = mesh::irregular_vertices(panel.region.mesh).at(0);
      panel.region.mesh.for_each_out(v, [&](HalfEdgeId h) {
        panel.lines.push_back({mesh::trace(panel.region.mesh, h).path, {ink::kGreen, 1.1}});
      });
      const MeshPicture probe(panel.region, Point::Zero(), 1);
      paint_panel(canvas, panel, kSpacing * Point(static_cast<double>(i), static_cast<double>(j)),
                  kSize / (probe.high().x() - probe.low().x()));
    }
  };
}

}  // namespace requad::figures
