#include "mesh/web/paint.hpp"

#include <algorithm>
#include <queue>

namespace requad::web {

using mesh::FaceId;
using mesh::HalfEdgeId;
using mesh::QuadMesh;

namespace {

// Numbers the quads breadth first, 0 for the first one of each component. choose(in, numbers) gives the number of the quad
// of half-edge `in`, beyond which it was met; `numbers` are those so far, and kNone.
constexpr float kNone = -2;
template <class Choose>
std::vector<float> spread(const QuadMesh& m, Choose&& choose) {
  std::vector<float> numbers(static_cast<std::size_t>(m.face_capacity()), kNone);
  std::queue<HalfEdgeId> waiting;
  for (const FaceId first : m.faces()) {
    if (numbers[first.slot()] != kNone) continue;
    numbers[first.slot()] = 0;
    waiting.push(QuadMesh::half_edge(first));
    while (!waiting.empty()) {
      const FaceId f = QuadMesh::face(waiting.front());
      waiting.pop();
      for (int k = 0; k < 4; ++k) {
        const HalfEdgeId across = m.twin(QuadMesh::half_edge(f, k));
        if (!across.valid()) continue;
        float& number = numbers[QuadMesh::face(across).slot()];
        if (number != kNone) continue;
        number = choose(across, numbers);
        waiting.push(across);
      }
    }
  }
  return numbers;
}

// The least colour that no adjacent quad has.
std::vector<float> colours(const QuadMesh& m) {
  return spread(m, [&m](HalfEdgeId in, const std::vector<float>& numbers) {
    const auto is_taken = [&](float colour) {
      bool taken = false;
      for (int k = 0; k < 4; ++k) {
        const HalfEdgeId across = m.twin(QuadMesh::half_edge(QuadMesh::face(in), k));
        taken = taken || (across.valid() && numbers[QuadMesh::face(across).slot()] == colour);
      }
      return taken;
    };
    float colour = 0;
    while (is_taken(colour)) ++colour;
    return colour;
  });
}

// Stripes that cross the common edge in one quad cross it in the other one, too.
std::vector<float> directions(const QuadMesh& m) {
  return spread(m, [&m](HalfEdgeId in, const std::vector<float>& numbers) {
    const HalfEdgeId out = m.twin(in);
    const auto axis = [](HalfEdgeId h) { return h.index() % 2; };
    const bool along = axis(out) == (numbers[QuadMesh::face(out).slot()] == 0 ? 0 : 1);
    return static_cast<float>(along ? axis(in) : 1 - axis(in));
  });
}

}  // namespace

float local_paint(const QuadMesh& m, const mesh::Positions& positions, FaceId f, Paint paint) {
  const double quality = mesh::scaled_jacobian(m, positions, f);
  if (mesh::is_inverted(quality)) return -1;
  return paint == Paint::quality ? static_cast<float>(quality) : 0;
}

std::vector<float> paint_all(const QuadMesh& m, const mesh::Positions& positions, Paint paint) {
  std::vector<float> numbers(static_cast<std::size_t>(m.face_capacity()), 0.0F);
  if (paint == Paint::checkerboard) numbers = colours(m);
  if (paint == Paint::stripes) numbers = directions(m);
  for (const FaceId f : m.faces()) {
    if (!is_global(paint)) {
      numbers[f.slot()] = local_paint(m, positions, f, paint);
    } else if (mesh::is_inverted(m, positions, f)) {
      numbers[f.slot()] = -1;
    }
  }
  return numbers;
}

}  // namespace requad::web
