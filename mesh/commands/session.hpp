// An editing session: a surface with its features and an editor, the numbers of vertices in files, local fits, and
// the output of the result.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "mesh/commands/arguments.hpp"
#include "mesh/editing/shape_keeper.hpp"
#include "mesh/irregular/complementary_operations.hpp"
#include "mesh/program/program.hpp"

namespace requad::edit {

// The options of an editing command: its own, then those that all editing commands have.
std::vector<program::Option> editing_options(std::vector<program::Option> own = {});
program::Option allow_inverted_option();

class Session {
 public:
  // Reads the surface that the first word names. Throws as read_input() and read_features() do.
  Session(const program::Options& options, const std::string& command);
  // Takes a surface that was read before. Reads the features. Seams of texture coordinates are features if the options
  // allow that (keeps_seams()) and `seams` is set.
  Session(const program::Options& options, std::string command, mesh::Surface input, bool seams = false);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const program::Options& options() const { return options_; }
  const mesh::Surface& input() const { return input_; }
  const mesh::QuadMesh& mesh() const { return mesh_; }
  const mesh::Positions& positions() const { return positions_; }
  const mesh::FeatureSet& features() const { return features_; }
  mesh::Editor& editor() { return editor_; }

  // The vertex with this number in the input file, counted from 1. Throws UsageError.
  mesh::VertexId vertex(const std::string& word) const;
  // The number that the vertex would have if the mesh were written now, counted from 1.
  int number(mesh::VertexId v) const;
  // "12 (v3)", and "12 (v3) and 40 (v5)".
  std::string describe(mesh::VertexId v) const;
  std::string describe(mesh::VertexId a, mesh::VertexId b) const;

  // Keeps the shape from now on (editing/shape_keeper.hpp). Returns the editor's mark. O(size of the mesh).
  std::size_t begin();
  // Fits the mesh to the input, as ShapeKeeper does it. --smooth gives the number of rounds; 0 leaves all vertices where
  // the operations placed them. Precondition: the mark is not before that of begin().
  void fit_since(std::size_t mark);
  void fit_transport(std::size_t mark);
  // Whether the mesh has more inverted quads than the input. Says so on standard error, unless --allow-inverted is
  // there: a command that promises that no mesh gets worse then ends with kCheckFailed. `subject` names what was edited.
  bool is_worse(const std::string& subject) const;

  // Ends a command whose edit was made. Adds the sizes before and after to the summary. Writes the files of -o,
  // --script, --map and --json, either all or none, and prints the text. Returns the exit code.
  int done(nlohmann::ordered_json summary, const std::string& text);
  // Ends a command whose edit cannot be made. Prints one line on standard error and writes no file. `subject` names
  // what was to be edited. Returns the exit code.
  int refused(const std::string& subject, mesh::Refusal why, const mesh::Obstacles& obstacles = {});

 private:
  int rounds() const;

  const program::Options& options_;
  std::string command_;
  mesh::Surface input_;
  mesh::QuadMesh mesh_;
  mesh::Positions positions_;
  mesh::FeatureSet features_;
  mesh::SectorPlan plan_;
  mesh::Editor editor_;
  std::optional<mesh::ShapeKeeper> shape_;
};

}  // namespace requad::edit
