#include "mesh/files/write_obj.hpp"

#include "mesh/files/number_text.hpp"
#include "mesh/geometry/drawing.hpp"

namespace requad::mesh {

std::string obj_text(const QuadMesh& m, const Positions& positions, const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& comment : comments) text += "# " + comment + '\n';
  for (const VertexId v : m.vertices()) {
    text += 'v';
    append_position(text, positions[v.slot()]);
    text += '\n';
  }
  for (const auto& face : m.compact_faces()) {
    text += 'f';
    for (const int corner : face) {
      text += ' ';
      append_number(text, corner + 1);
    }
    text += '\n';
  }
  return text;
}

std::string obj_text(const Region& region, const std::vector<std::string>& comments) {
  Positions positions;
  for (const Eigen::Vector2d& p : draw(region)) positions.emplace_back(p.x(), p.y(), 0);
  return obj_text(region.mesh, positions, comments);
}

}  // namespace requad::mesh
