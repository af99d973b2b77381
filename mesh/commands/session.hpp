// What the editing commands share: a surface with its features and an editor, vertices by their numbers in files, local
// smoothing, and how results are written.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "mesh/commands/command.hpp"
#include "mesh/editing/affected_region.hpp"
#include "mesh/geometry/nearest_points.hpp"
#include "mesh/irregular/complementary_operations.hpp"

namespace requad::edit {

// The options of every command that edits, beside its own, and the lines of help on them.
program::OptionTable editing_options(program::OptionTable own = {});
extern const std::string kEditingHelp;
// Those of a command that only looks.
program::OptionTable looking_options();
extern const std::string kLookingHelp;

class Session {
 public:
  // Reads the surface that the first word names. Throws like read_input().
  Session(const program::Options& options, const std::string& command);
  // Takes the surface; reads the features.
  Session(const program::Options& options, std::string command, mesh::Surface input);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const program::Options& options() const { return options_; }
  const mesh::Surface& input() const { return input_; }
  const mesh::QuadMesh& mesh() const { return mesh_; }
  const mesh::Positions& positions() const { return positions_; }
  const mesh::FeatureSet& features() const { return features_; }
  mesh::Editor& editor() { return editor_; }
  // The input's surface.
  const mesh::SurfaceIndex& surface();

  // The vertex that a word names: its number in the input file, from 1. Throws UsageError.
  mesh::VertexId vertex(const std::string& word) const;
  // The number that a vertex has in the mesh as it would be written now, from 1.
  int number(mesh::VertexId v) const;
  // "12 (v3)".
  std::string describe(mesh::VertexId v) const;

  // Smooths round what edits changed since the mark, unless --smooth 0 says not to.
  void smooth_since(std::size_t mark);

  // The end of an edit that was made: writes --script, --map, -o and --json, all or none, and reports. `summary` gets the
  // sizes before and after.
  int done(nlohmann::ordered_json summary, const std::string& text);
  // The end of one that can not be made: one line on standard error with the reason, exit code 1, nothing written.
  int refused(const std::string& wish, mesh::Refusal why, const mesh::Obstacles& obstacles = {});

 private:
  const program::Options& options_;
  std::string command_;
  mesh::Surface input_;
  mesh::QuadMesh mesh_;
  mesh::Positions positions_;
  mesh::FeatureSet features_;
  mesh::SectorPlan plan_;
  mesh::Editor editor_;
  std::optional<mesh::SurfaceIndex> surface_;
  mesh::BreadthFirstDistances distances_;
};

}  // namespace requad::edit
