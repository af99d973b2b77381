// Wavefront OBJ output.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "mesh/region.hpp"

namespace requad::mesh {

// Writes the live elements with these positions (by vertex slot), vertices renumbered in id order. Comment lines start
// the file. Numbers do not depend on the locale. O(V + F).
void write_obj(std::ostream& out, const QuadMesh& mesh, const std::vector<Eigen::Vector2d>& positions,
               const std::vector<std::string>& comments = {});

// A region drawn by embed(), written to a file as a whole or not at all, or to stdout if path is "-". Throws
// program::UsageError with a one-line reason.
void save_region(const std::string& path, const Region& region, const std::vector<std::string>& comments = {});

}  // namespace requad::mesh
