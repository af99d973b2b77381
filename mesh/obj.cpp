#include "mesh/obj.hpp"

#include <locale>
#include <sstream>

#include "mesh/embedding.hpp"
#include "mesh/program.hpp"

namespace requad::mesh {

void write_obj(std::ostream& out, const QuadMesh& m, const std::vector<Eigen::Vector2d>& positions,
               const std::vector<std::string>& comments) {
  out.imbue(std::locale::classic());
  out.precision(9);
  for (const std::string& comment : comments) out << "# " << comment << '\n';
  for (const VertexId v : m.vertices()) out << "v " << positions[v.slot()].x() << ' ' << positions[v.slot()].y() << " 0\n";
  for (const auto& face : m.compact_faces()) {
    out << 'f';
    for (const int corner : face) out << ' ' << corner + 1;
    out << '\n';
  }
}

void save_region(const std::string& path, const Region& region, const std::vector<std::string>& comments) {
  std::ostringstream text;
  write_obj(text, region.mesh, embed(region), comments);
  program::write_text(path, text.str());
}

}  // namespace requad::mesh
