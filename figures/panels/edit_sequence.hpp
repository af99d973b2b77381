// Edits of a mesh in space, one after the other, and the mesh between them.
//
// Terms
//   stage     the mesh at a moment, with its features
//   sequence  edits that start from one mesh. They are those of requad-edit, and keep the shape as it does.
// An edit of a figure must be possible: what is refused throws std::logic_error with the reason.
// Costs: those of the edits; a copy of the mesh for each stage.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mesh/editing/editor.hpp"
#include "mesh/editing/shape_keeper.hpp"
#include "mesh/files/feature_edges.hpp"
#include "mesh/files/surface.hpp"

namespace requad::figures {

struct Stage {
  mesh::QuadMesh mesh;
  mesh::Positions positions;
  mesh::FeatureEdges features = {};

  int count(int valence) const;  // interior vertices of this valence
  int irregular() const;         // interior vertices of other valences than 4
};

class EditSequence {
 public:
  // Edges at which the surface bends by `feature_angle` degrees or more are features; none are if it is 0.
  explicit EditSequence(mesh::Surface surface, double feature_angle = 0);
  // The same for the text of an OBJ file.
  explicit EditSequence(const char* obj, double feature_angle = 0);
  EditSequence(const EditSequence&) = delete;
  EditSequence& operator=(const EditSequence&) = delete;

  Stage stage() const;
  // The vertex that would have this number, counted from 1, if the mesh were written now.
  mesh::VertexId vertex(int number) const;

  // An atomic operation along the edge from one vertex to another, by its name (irregular/atomic_operations.hpp).
  void make(const std::string& name, mesh::VertexId from, mesh::VertexId to);
  // One of the moves of a pair, by its name or step (irregular/possible_moves.hpp).
  void move(const std::string& step, mesh::VertexId a, mesh::VertexId b);
  // Cancels a v3 and a v5 with the help of others (irregular/complementary_operations.hpp).
  void cancel(mesh::VertexId three, mesh::VertexId five, const std::vector<mesh::VertexId>& helpers);
  // Parts vertices until none has a valence other than 3, 4 and 5.
  void part();
  // Moves a 3-3 or 5-5 pair until a separatrix joins it. Returns the two vertices as they are then.
  std::array<mesh::VertexId, 2> align(mesh::VertexId a, mesh::VertexId b);
  // Reduces the mesh as far as it goes. Returns the stage at which no more than each of these numbers of irregular
  // vertices were left for the first time; the numbers must fall. A number that is not reached has no stage.
  std::vector<Stage> reduce(const std::vector<int>& at = {});

 private:
  // What the editor had done when an edit begins. Keeps the shape from the first edit on.
  std::size_t begin();

  mesh::QuadMesh mesh_;
  mesh::Positions positions_;
  mesh::FeatureSet features_;
  mesh::SectorPlan plan_;
  mesh::Editor editor_;
  std::optional<mesh::ShapeKeeper> shape_;
};

}  // namespace requad::figures
