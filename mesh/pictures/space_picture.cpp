#include "mesh/pictures/space_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include <Eigen/Geometry>

#include "mesh/pictures/mesh_picture.hpp"

namespace requad::pictures {

using Eigen::Vector3d;
using mesh::FaceId;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::VertexId;

namespace {

constexpr double kGap = 24;  // points between meshes
constexpr double kFine = 1.0 / 64;

// How much light falls on a face with this normal, as seen by the viewer.
double lighting(const Vector3d& normal) {
  static const Vector3d light = Vector3d(-0.4, 0.55, 0.75).normalized();
  return 0.42 + 0.58 * std::max(0.0, normal.dot(light));
}

Colour shaded(Colour colour, double light) { return {colour.red * light, colour.green * light, colour.blue * light}; }

// By face slot: whether it has the second colour of a checkerboard. Each face, breadth-first, differs from most of its
// neighbours that have a colour.
std::vector<bool> greedy_colours(const QuadMesh& m) {
  std::vector<signed char> colour(static_cast<std::size_t>(m.face_capacity()), 0);
  std::vector<FaceId> queue;
  std::vector<bool> queued(colour.size(), false);
  for (const FaceId first : m.faces()) {
    if (queued[first.slot()]) continue;
    queued[first.slot()] = true;
    queue.assign(1, first);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      int sum = 0;
      for (int k = 0; k < 4; ++k) {
        const HalfEdgeId t = m.twin(QuadMesh::half_edge(queue[i], k));
        if (!t.valid()) continue;
        const FaceId g = QuadMesh::face(t);
        sum += colour[g.slot()];
        if (queued[g.slot()]) continue;
        queued[g.slot()] = true;
        queue.push_back(g);
      }
      colour[queue[i].slot()] = sum < 0 ? 1 : -1;
    }
  }
  std::vector<bool> second(colour.size());
  for (std::size_t f = 0; f < colour.size(); ++f) second[f] = colour[f] > 0;
  return second;
}

struct Box {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity());
  Vector3d high = -low;

  void add(const SpaceSubject& subject, const Eigen::Matrix3d& frame) {
    for (const VertexId v : subject.mesh.vertices()) {
      const Vector3d p = frame * subject.positions[v.slot()];
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
};

}  // namespace

Eigen::Matrix3d View::frame() const {
  const double az = azimuth * std::numbers::pi / 180, el = elevation * std::numbers::pi / 180;
  const Vector3d viewer(std::cos(el) * std::sin(az), std::sin(el), std::cos(el) * std::cos(az));
  const Vector3d right(std::cos(az), 0, -std::sin(az));
  Eigen::Matrix3d rows;
  rows << right.transpose(), viewer.cross(right).transpose(), viewer.transpose();
  if (!z_up) return rows;
  Eigen::Matrix3d turned;
  turned << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return rows * turned;
}

View usual_view(const QuadMesh& mesh, const mesh::Positions& positions) {
  const std::vector<VertexId> vertices = mesh.vertices();
  const bool flat = std::all_of(vertices.begin(), vertices.end(), [&](VertexId v) {
    return positions[v.slot()].z() == positions[vertices.front().slot()].z();
  });
  return flat ? View{.azimuth = 0, .elevation = 0} : View{};
}

Vector3d SpacePicture::projected(const Vector3d& p) const {
  Vector3d q = scale_ * (frame_ * (p - origin_));
  q.head<2>() += centre_;
  return q;
}

SpacePicture::SpacePicture(const SpaceSubject& subject, const View& view, const Vector3d& origin, Point centre,
                           double scale, bool checkerboard)
    : frame_(view.frame()), origin_(origin), centre_(centre), scale_(scale), surface_({}), words_(subject.words) {
  const QuadMesh& m = subject.mesh;
  low_ = high_ = centre;
  bool first = true;
  for (const VertexId v : m.vertices()) {
    const Point p = projected(subject.positions[v.slot()]).head<2>();
    low_ = first ? p : Point(low_.cwiseMin(p));
    high_ = first ? p : Point(high_.cwiseMax(p));
    first = false;
  }

  std::vector<std::vector<VertexId>> features(static_cast<std::size_t>(m.vertex_capacity()));
  for (const auto& [a, b] : subject.features) {
    features[a.slot()].push_back(b);
    features[b.slot()].push_back(a);
  }
  const auto line = [&](HalfEdgeId h) {
    if (m.is_boundary(h)) return Line::boundary;
    const auto& ends = features[m.origin(h).slot()];
    return std::find(ends.begin(), ends.end(), m.target(h)) == ends.end() ? Line::plain : Line::feature;
  };
  const std::vector<bool> second = checkerboard ? greedy_colours(m) : std::vector<bool>{};
  std::vector<Facet> facets;
  std::vector<double> lengths;
  for (const FaceId f : m.faces()) {
    Facet facet;
    Quad quad;
    const auto corners = m.corners(f);
    for (std::size_t k = 0; k < 4; ++k) {
      const HalfEdgeId h = QuadMesh::half_edge(f, static_cast<int>(k));
      facet.corners[k] = projected(subject.positions[corners[k].slot()]);
      quad.sides[k] = line(h);
      lengths.push_back(mesh::edge_length(m, subject.positions, h));
    }
    const mesh::Triangle half = mesh::triangles(m, subject.positions, f)[0];
    facet.diagonal = mesh::same_bits(half[0], subject.positions[corners[0].slot()]) ? 0 : 1;
    const Vector3d normal = frame_ * mesh::face_normal(m, subject.positions, f);
    const bool inverted = mesh::is_inverted(mesh::scaled_jacobian(m, subject.positions, f));
    quad.front = inverted                           ? &Palette::inverted
                 : checkerboard && second[f.slot()] ? &Palette::dark_quad
                                                    : &Palette::quad;
    quad.back = inverted ? &Palette::inverted : &Palette::back;
    quad.front_light = lighting(normal);
    quad.back_light = lighting(-normal);
    facets.push_back(facet);
    quads_.push_back(quad);
  }
  if (!lengths.empty()) {
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    edge_ = scale * *middle;
  }
  surface_ = HiddenSurface(facets);
  for (const VertexId v : mesh::irregular_vertices(m)) {
    const Vector3d at = projected(subject.positions[v.slot()]);
    if (!surface_.covers(at)) marks_.push_back({at.head<2>(), m.valence(v)});
  }
}

double SpacePicture::mark_radius() const { return std::clamp(0.35 * edge_, 2.4, 4.6); }

void SpacePicture::paint(Canvas& canvas, const Point& by) const {
  canvas.round_to(kFine);
  const Stroke thin{canvas.palette().line, std::clamp(0.05 * edge_, 0.06, 0.5)};
  const double bold = std::clamp(5 * thin.width, 0.6, 1.6);
  for (const Piece& piece : surface_.pieces()) {
    const Quad& quad = quads_[static_cast<std::size_t>(piece.facet)];
    const Colour colour = piece.front ? shaded(canvas.palette().*quad.front, quad.front_light)
                                      : shaded(canvas.palette().*quad.back, quad.back_light);
    Polyline outline;
    bool whole = true;
    for (const Piece::Corner& c : piece.outline) {
      outline.push_back(c.at + by);
      whole = whole && c.side >= 0;
    }
    // A thin line in the colour of the quad joins a part to the others.
    canvas.polygon(outline, colour, whole ? thin : Stroke{colour, 0.2});
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const int side = piece.outline[k].side;
      if (side < 0) continue;
      const Line line = quad.sides[static_cast<std::size_t>(side)];
      if (whole && line == Line::plain) continue;
      const Stroke stroke = line == Line::plain     ? thin
                            : line == Line::feature ? Stroke{canvas.palette().ink, bold}
                                                    : Stroke{canvas.palette().path, bold};
      canvas.stroke({{outline[k], outline[(k + 1) % outline.size()]}}, stroke);
    }
  }
  for (const Mark& mark : marks_) mark_vertex(canvas, mark.at + by, mark.valence, mark_radius());
  canvas.caption(Point((low_.x() + high_.x()) / 2, low_.y() - 2 * canvas.em()) + by,
                 canvas.caption_lines(words_, high_.x() - low_.x() + kGap / 2));
}

Paint side_by_side(const std::vector<SpaceSubject>& subjects, const View& view, bool checkerboard, double size) {
  const Eigen::Matrix3d frame = view.frame();
  Box box;
  for (const SpaceSubject& subject : subjects) box.add(subject, frame);
  if (!(box.low.array() <= box.high.array()).all()) box.low = box.high = Vector3d::Zero();
  const Vector3d extent = box.high - box.low;
  const double largest = std::max(extent.x(), extent.y());
  const double scale = largest > 0 ? size / largest : 1;
  auto pictures = std::make_shared<std::vector<SpacePicture>>();
  double x = 0;
  for (const SpaceSubject& subject : subjects) {
    pictures->emplace_back(subject, view, frame.transpose() * (box.low + box.high) / 2, Point(x, 0), scale,
                           checkerboard);
    x += scale * extent.x() + kGap;
  }
  return [pictures](Canvas& canvas) {
    for (const SpacePicture& picture : *pictures) picture.paint(canvas);
  };
}

}  // namespace requad::pictures
