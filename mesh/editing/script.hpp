// Edit scripts: edits as lines of text, which can be replayed and undone to the last bit.
//
// A script belongs to one mesh. It says what was done, where each vertex came to, and what undoes each line. So the
// mesh and the script give the result, and the result and the script give the mesh.
//
//   requad-script 1                       the format and its version
//   mesh 2930 2928 0123456789abcdef X Y   the mesh: number of vertices, number of faces, fingerprint. X and Y are the
//                                         fingerprints of the faces alone, before and after; older scripts lack them
//   flip_ccw H                            the operations of basic_operations.hpp; what undoes a flip follows from it
//   flip_cw H
//   collapse H removes V X Y Z undo split FIRST LAST CORNER
//   split FIRST LAST CORNER makes V X Y Z undo collapse H
//   place V X Y Z from X Y Z              a vertex moves to the first position, from the second
//   end 2931 2929 0123456789abcdef        the result, in the same terms; nothing follows
//
// Blank lines are skipped, and so is what follows a #. Vertices and faces are counted from 0 in the order of the file;
// vertices that no face has do not count. Half-edge H leaves corner H mod 4 of face H div 4. A new element gets the
// number that was freed last, or the next new number if none is free. Coordinates are finite and have the digits that
// it takes to read back the same bits.
//
// Laws
//   editing-11  parse_script(to_string(s)) is s if s was recorded or parsed. (An inverse() cannot be written and read:
//               it starts from a mesh with free ids, which the text does not tell.)
//   editing-12  Replayed on the mesh on which it was recorded, a script gives the same mesh, with the same ids, the
//               same free ids next, and the same bits.
//   editing-13  Its inverse() gives the mesh back in the same sense. It is replayed on the result in memory, or on one
//               that was read from a file and went through restore_ids().
//   editing-14  A malformed script, or one that is replayed on another mesh, changes nothing, and the message is one
//               line.
//   editing-16  A mesh whose faces are those of the script, and whose coordinates another program has rounded, is taken
//               by accept_rounded(). The vertices that the script moves come to the bits that it says; all others keep
//               what they have.
// Costs: linear in the script, with little work for each line; a replay costs what its operations cost.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/editing/editor.hpp"
#include "mesh/files/surface.hpp"

namespace requad::mesh {

// Tells meshes apart. A mesh has the same digest as the one that is read from its file, although ids may differ.
struct MeshDigest {
  int vertices = 0;
  int faces = 0;
  std::uint64_t fingerprint = 0;  // FNV-1a of the coordinates of the live vertices, then of the live faces, in order
  std::optional<std::uint64_t> connectivity = {};  // the same of the faces alone; missing in older scripts

  friend bool operator==(const MeshDigest& a, const MeshDigest& b) {
    return a.vertices == b.vertices && a.faces == b.faces && a.fingerprint == b.fingerprint;
  }
  // Whether the faces are known to be the same.
  bool same_faces(const MeshDigest& other) const {
    return vertices == other.vertices && faces == other.faces && connectivity && connectivity == other.connectivity;
  }
};
MeshDigest digest(const QuadMesh& mesh, const Positions& positions);

// One line: an operation, or a vertex that moves.
struct Change {
  int line = 0;  // its line, if the script was read from a text
  std::optional<BasicOperation> operation;
  BasicOperation inverse;  // of the operation
  VertexId vertex;         // the vertex that moves, or that a collapse removes, or that a split makes; none for a flip
  // Where the vertex was before, unless it is made; and where it is afterwards, unless it is removed.
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
};

struct Script {
  std::string name;  // the file, for messages
  MeshDigest before;
  MeshDigest after;
  std::vector<Change> changes;
  bool rounded = false;  // whether the mesh at hand was accept_rounded(): then only faces are compared
};

// What an editor has done since the mesh was `before`. Preconditions: that mesh had no free ids, like one that was read
// from a file; the editor has positions, and has not forgotten any edit.
Script record_script(const QuadMesh& before, const Positions& positions, const Editor& editor);

std::string to_string(const Script& script);
// Throws FileError "name:line: reason" for a line that is not well-formed, or names an element that cannot exist there,
// or gives a new element another number than the next; and for an end that has other numbers of vertices and faces than
// the lines lead to.
Script parse_script(std::string_view text, const std::string& name);

// The script that undoes this one.
Script inverse(const Script& script);

// Gives a mesh that was written after the script, and read again, the ids that it had when it was written. The
// inverse() of the script needs them. Coordinates may be rounded. Throws FileError if the mesh is not the script's
// result.
void restore_ids(const Script& script, Surface& surface);

// How far coordinates may be from those that were written, for accept_rounded(): this times the diagonal of the bounding
// box. Programs write six digits or more.
inline constexpr double kRoundingTolerance = 1e-5;
// If the mesh, with the ids of the script's start, differs from it in coordinates alone: puts each vertex that the script
// moves or removes to where the script has it, and sets `rounded`. Returns the largest distance of such a vertex from
// there; 0 if nothing was rounded, or if the mesh is another one, which replay() then refuses. Throws FileError if the
// distance is larger than the tolerance: it names the vertex. Vertices that the script leaves alone are not compared.
double accept_rounded(Script& script, Surface& surface);

struct Replay {
  Refusal refusal = Refusal::none;  // breaks_feature or moves_feature
  int line = 0;                     // the line that was refused
};
// Makes all changes, or none if one is refused because it would break a feature or move a vertex of one. Throws
// FileError and makes no change in other cases: "name: reason" if the mesh is not the script's, or the result is not;
// "name:line: reason" if a line is not legal, or an element is not as it says. Precondition: the editor has positions.
Replay replay(Editor& editor, const Script& script);

}  // namespace requad::mesh
