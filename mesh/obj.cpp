#include "mesh/obj.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <locale>

#include "mesh/embedding.hpp"

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
  const std::string temporary = path + ".part";
  {
    std::ofstream out(temporary);
    write_obj(out, region.mesh, embed(region), comments);
    out.flush();
    if (!out) {
      std::remove(temporary.c_str());
      throw MeshError(path + ": can not be written");
    }
  }
  std::error_code error;
  std::filesystem::rename(temporary, path, error);
  if (error) {
    std::remove(temporary.c_str());
    throw MeshError(path + ": " + error.message());
  }
}

}  // namespace requad::mesh
