// Arguments that several commands of requad-edit have in common: a mesh file, features, and the output file.
#pragma once

#include <string>
#include <vector>

#include "mesh/files/feature_edges.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/geometry/in_chunks.hpp"
#include "mesh/program/layout.hpp"
#include "mesh/program/options.hpp"

namespace requad::edit {

// The options --subdivide and --weld, and the options that name features.
std::vector<program::Option> input_options();
// Whether the seams of texture coordinates are features of an edit.
std::vector<program::Option> seam_options();
// Those of input_options() and seam_options().
std::vector<program::Option> input_and_seam_options();
// What these say; without them seams are kept, unless each face has a texture for itself. `seams`: those of the surface.
// Throws UsageError if both are given, or one for a mesh without seams.
bool keeps_seams(const program::Options& options, const mesh::Surface& surface, const mesh::FeatureEdges& seams);

// "not kept: ..." as a line of text, or "".
std::string not_kept_line(const mesh::Attributes& attributes);

// The option -o, which names an OBJ file for the result.
program::Option output_option();

// Reads the surface from the file that the first word names. With --subdivide, cuts its polygons into quads; with --weld,
// joins vertices. Throws FileError.
mesh::Surface read_input(const program::Options& options);

// Whether --feature-angle or --features is given.
bool wants_features(const program::Options& options);
// The feature edges that these options ask for; none if neither is given. Throws UsageError or FileError.
mesh::FeatureEdges read_features(const program::Options& options, const mesh::Surface& surface);

// The path that -o gives. Throws UsageError if -o is missing.
std::string output_path(const program::Options& options, const std::string& command);

// On as many threads as --threads says.
mesh::RunTasks tasks(const program::Options& options);

// Says on standard error, in one line, how many vertices of the file the result lacks since no face has them.
void report_left_out(const program::Options& options, const mesh::Surface& surface);

using program::counted;

}  // namespace requad::edit
