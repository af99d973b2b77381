#include "tests/mesh/editing/workshop.hpp"

#include <algorithm>
#include <array>
#include <sstream>

#include "mesh/files/read_polygons.hpp"
#include "mesh/files/write_obj.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"

namespace requad::tests {

using namespace requad::mesh;

void Workshop::edit(int operations, std::mt19937& random) {
  for (int done = 0; done < operations;) {
    if (editor.run(random_operation(m, random)).refusal != Refusal::none) continue;
    ++done;
    const auto live = [&] {
      while (true) {
        const VertexId v(static_cast<int>(random() % static_cast<unsigned>(m.vertex_capacity())));
        if (m.is_live(v)) return v;
      }
    };
    if (done % 20 == 0) {
      const VertexId v = live();
      if (!editor.is_fixed(v)) editor.place(v, {positions[v.slot()].x() / 3, -0.0, positions[v.slot()].y()});
    }
    if (done % 100 == 0) {
      const std::array some{live(), live(), live()};
      editor.smooth(some, {});
    }
  }
}

Script Workshop::record() const { return record_script(input.mesh, input.positions, editor); }

Surface read_back(const std::string& text) { return to_quad_mesh(parse_obj(text, "read back")); }

bool same_positions(const QuadMesh& m, const Positions& a, const Positions& b) {
  const auto vertices = m.vertices();
  return std::all_of(vertices.begin(), vertices.end(), [&](VertexId v) { return same_bits(a[v.slot()], b[v.slot()]); });
}

Surface crooked_torus(int columns, int rows) {
  std::mt19937 random(7);
  const QuadMesh m = torus(columns, rows);
  return read_back(obj_text(m, random_positions(m, random)));
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace requad::tests
