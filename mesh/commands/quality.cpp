#include "mesh/commands/quality.hpp"

#include <array>
#include <cstdio>

#include "mesh/geometry/hausdorff_distance.hpp"

namespace requad::edit {

using mesh::Diagnosis;
using nlohmann::ordered_json;

Quality compare(const mesh::Surface& input, const mesh::QuadMesh& mesh, const mesh::Positions& positions) {
  Quality result{mesh::diagnose(input.mesh, input.positions), mesh::diagnose(mesh, positions)};
  const double diagonal = result.before.bounding_box_diagonal;
  if (diagonal > 0) {
    result.hausdorff = mesh::hausdorff_distance({mesh, positions}, {input.mesh, input.positions}) / diagonal;
  }
  return result;
}

void add(ordered_json& summary, const Quality& quality) {
  const auto sizes = [](const Diagnosis& d) {
    return ordered_json{{"vertices", d.vertices},
                        {"faces", d.faces},
                        {"interior_irregular", d.interior_irregular},
                        {"inverted", d.inverted},
                        {"scaled_jacobian", {{"least", d.scaled_jacobian.least}, {"mean", d.scaled_jacobian.mean}}}};
  };
  summary["before"] = sizes(quality.before);
  summary["after"] = sizes(quality.after);
  summary["hausdorff"] = quality.hausdorff;
}

std::string to_string(const Quality& quality) {
  std::string text = "         quads  irregular  inverted  scaled Jacobian: mean   least\n";
  const auto line = [&text](const char* name, const Diagnosis& d) {
    std::array<char, 128> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%-6s %7d  %9d  %8d  %21.4f %7.4f\n", name, d.faces,
                  d.interior_irregular, d.inverted, d.scaled_jacobian.mean, d.scaled_jacobian.least);
    text += buffer.data();
  };
  line("before", quality.before);
  line("after", quality.after);
  std::array<char, 96> buffer;
  std::snprintf(buffer.data(), buffer.size(), "Hausdorff distance from the input, over the diagonal: %.4f\n",
                quality.hausdorff);
  return text + buffer.data();
}

}  // namespace requad::edit
