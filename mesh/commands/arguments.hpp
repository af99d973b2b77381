// What several commands of requad-edit take from their arguments: a mesh file, features, and where the result goes.
#pragma once

#include <string>
#include <vector>

#include "mesh/files/feature_edges.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/program/options.hpp"

namespace requad::edit {

// --subdivide, and the options that name features.
std::vector<program::Option> input_options();
// -o. A result as OBJ goes there.
program::Option output_option();

// Reads the surface in the file that the first word names; with --subdivide its polygons are cut into quads. Throws
// FileError.
mesh::Surface read_input(const program::Options& options);

// Whether --feature-angle or --features is given. Throws UsageError if both are.
bool wants_features(const program::Options& options);
// The feature edges that these options ask for; none if neither is given. Throws UsageError or FileError.
mesh::FeatureEdges read_features(const program::Options& options, const mesh::Surface& surface);

// The path that -o gives. Throws UsageError if there is none, or if it names an OFF file.
std::string output_path(const program::Options& options, const std::string& command);

// "1 vertex", "2 vertices".
std::string counted(int count, const std::string& one, const std::string& many);

}  // namespace requad::edit
