// Edit scripts: edits as lines of text, which can be replayed and undone to the last bit.
//
// A script belongs to one mesh. It says what was done to it, where each vertex went, and what undoes each line, so that
// the mesh and the script give the result, and the result and the script give the mesh.
//
//   requad-script 1                       the format and its version
//   mesh 2930 2928 0123456789abcdef       the mesh: vertices, faces, fingerprint
//   flip_ccw H                            the operations of basic_operations.hpp (what undoes a flip is known)
//   flip_cw H
//   collapse H removes V X Y Z undo split FIRST LAST CORNER
//   split FIRST LAST CORNER makes V X Y Z undo collapse H
//   place V X Y Z from X Y Z              a vertex moves
//   end 2931 2929 0123456789abcdef        the result, in the same terms; nothing follows
//
// Blank lines and what follows a # do not count. Vertices and faces are counted from 0 in the order of the file, less
// the vertices that no face has; half-edge H leaves corner H mod 4 of face H div 4. What is made gets the number that
// was freed last, or else the next new one. Coordinates are finite and have the digits that it takes to read back the
// same bits.
//
// Laws
//   W1  parse_script(to_string(s)) is s, if s was recorded or parsed; an inverse() lives in memory only: parse_script
//       refuses the free ids in its text.
//   W2  Replayed on the mesh that it was recorded on, a script gives the same mesh, with all ids, free ids and bits.
//   W3  Its inverse() gives the mesh back likewise: from memory, or from a file by restore_ids().
//   W4  A script that is not what it must be, or is replayed on another mesh, changes nothing, and one line says why.
// Costs: linear in the script, with little for each line; a replay costs what its operations do.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/editing/editor.hpp"
#include "mesh/files/polygon_mesh.hpp"

namespace requad::mesh {

// What tells meshes apart: equal for a mesh and the one that is read from its file, ids aside.
struct MeshDigest {
  int vertices = 0;
  int faces = 0;
  std::uint64_t fingerprint = 0;  // FNV-1a of the live vertices' coordinates and the faces, in their order

  friend bool operator==(const MeshDigest&, const MeshDigest&) = default;
};
MeshDigest digest(const QuadMesh& mesh, const Positions& positions);

// One line: an operation, or a vertex that moves.
struct Change {
  int line = 0;  // of the text that it was read from
  std::optional<BasicOperation> operation;
  BasicOperation inverse;  // of the operation
  VertexId vertex;         // that moves, that a collapse removes, or that a split makes; none for a flip
  // Where the vertex was, unless it is made; and where it comes to, unless it is removed.
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
};

struct Script {
  std::string name;  // the file, for messages
  MeshDigest before;
  MeshDigest after;
  std::vector<Change> changes;
};

// What an editor has done since the mesh was `before`. Precondition: that had no free ids, as a mesh that was read; the
// editor has positions, and has not forgotten anything.
Script record_script(const QuadMesh& before, const Positions& positions, const Editor& editor);

std::string to_string(const Script& script);
// Throws FileError "name:line: reason" for whatever is not well-formed, names a vertex or face that can not exist where
// it stands, makes one by another number than is next, or does not lead to the numbers of vertices and faces at its
// end.
Script parse_script(std::string_view text, const std::string& name);

// What undoes the script.
Script inverse(const Script& script);

// Gives a mesh that was written after the script and read again the ids that it had, for inverse(). Throws FileError if
// it is not the script's result.
void restore_ids(const Script& script, Surface& surface);

// Makes the changes; if that is refused, none at all. Refused is an operation or a placement for the sake of a feature:
// its line and why. Precondition: the editor has positions.
struct Replay {
  Refusal refusal = Refusal::none;  // breaks_feature or moves_feature
  int line = 0;
};
// Throws FileError, "name: reason" if the mesh or the result is not the script's, "name:line: reason" if a line is not
// legal or does not find what it names.
Replay replay(Editor& editor, const Script& script);

}  // namespace requad::mesh
