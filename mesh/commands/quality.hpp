// What an edit did to a mesh, in numbers: before and after, as JSON and as text.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "mesh/files/surface.hpp"
#include "mesh/geometry/diagnosis.hpp"

namespace requad::edit {

struct Quality {
  mesh::Diagnosis before;
  mesh::Diagnosis after;
  double hausdorff = 0;  // hausdorff_distance() over the diagonal of the input
};

// Compares the mesh with the input that it came from. O(F log F).
Quality compare(const mesh::Surface& input, const mesh::QuadMesh& mesh, const mesh::Positions& positions);

// Adds "before", "after" and "hausdorff" to the summary.
void add(nlohmann::ordered_json& summary, const Quality& quality);
// A table of three lines, and the Hausdorff distance.
std::string to_string(const Quality& quality);

}  // namespace requad::edit
