#include "mesh/editing/untangling.hpp"

#include <vector>

#include "mesh/geometry/measures.hpp"

namespace requad::mesh {

namespace {

// The corners of all inverted faces, whose number comes into `faces`.
std::vector<VertexId> corners_of_inverted(const QuadMesh& m, const Positions& positions, int& faces) {
  std::vector<VertexId> corners;
  faces = 0;
  for (const FaceId f : m.faces()) {
    if (!is_inverted(m, positions, f)) continue;
    ++faces;
    for (const VertexId v : m.corners(f)) corners.push_back(v);
  }
  return corners;
}

}  // namespace

Untangling untangle(Editor& editor, SmoothingOptions how) {
  constexpr int kWidest = 64;            // rings
  constexpr int kIterationsPerRing = 8;  // so many that a change can cross the neighbourhood
  const QuadMesh& m = editor.mesh();
  BreadthFirstDistances around;
  Untangling result;
  std::vector<VertexId> corners = corners_of_inverted(m, *editor.positions(), result.before);
  result.after = result.before;
  const std::optional<double> guard = how.guard;
  for (int rings = 2; rings <= kWidest && result.after > 0;) {
    const auto always = [](VertexId) { return true; };
    around.measure(m, corners, always, always, [rings](VertexId, int d) { return d > rings; });
    const std::vector<VertexId> near = around.met();
    const std::size_t mark = editor.mark();
    how.iterations = kIterationsPerRing * rings;
    how.guard.reset();
    editor.smooth(near, how);
    how.guard = guard;
    editor.smooth(near, how);
    int left = 0;
    std::vector<VertexId> now = corners_of_inverted(m, *editor.positions(), left);
    if (left < result.after) {
      result.after = left;
      corners = std::move(now);
    } else {
      editor.roll_back(mark);
      rings *= 2;
    }
  }
  return result;
}

}  // namespace requad::mesh
