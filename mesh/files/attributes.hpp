// What a file says of a mesh beside positions and faces: groups, materials, texture coordinates, normals and more.
//
// Terms
//   statement    A line that holds for the faces after it, until another line with its keyword: o, g, usemtl, s and
//                their like.
//   state        The statements that hold for a face, one for each keyword.
//   values       Texture coordinates (vt) or normals (vn). A corner of a face has one of each, or none.
//   element      A line that names vertices and is no face: l, p, and the tags `t crease` and `t corner` of OpenSubdiv.
//   words        Text that is kept as the file has it, so that it is written with the same characters.
//
// Vertices, faces and corners have the indices of the mesh to which the attributes belong: those of a PolygonMesh, or, for
// files that are written, those of the live elements in order. Empty vectors stand for "none has any".
#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace requad::mesh {

struct Attributes {
  using State = std::vector<std::string>;  // by keyword: the line, or "" if there was none
  struct Values {
    std::vector<std::string> words;        // by index: what follows vt or vn
    std::vector<Eigen::Vector3d> numbers;  // by index; missing ones are 0
    std::vector<int> at_corner;            // by corner: an index, or -1

    int at(std::size_t corner) const { return corner < at_corner.size() ? at_corner[corner] : -1; }
    int add(std::string text, const Eigen::Vector3d& value) {
      words.push_back(std::move(text));
      numbers.push_back(value);
      return static_cast<int>(words.size()) - 1;
    }
    friend bool operator==(const Values&, const Values&) = default;
  };
  struct Element {
    struct Word {
      int vertex = -1;   // the vertex that the word names, or -1
      std::string text;  // the word, or what follows the vertex's number
      friend bool operator==(const Word&, const Word&) = default;
    };
    std::string keyword;
    int first_index = 1;  // the number of the first vertex in this kind of element
    std::vector<Word> words;
    friend bool operator==(const Element&, const Element&) = default;
  };

  std::vector<std::string> libraries;  // lines that hold for the whole file: mtllib
  std::vector<std::string> keywords;   // of statements, in the order in which they first occur
  std::vector<State> states;
  std::vector<int> state_of_face;         // an index, or -1 if no statement came before
  std::vector<std::string> vertex_words;  // by vertex: what follows the coordinates, which is a weight or a colour
  Values uvs, normals;
  std::vector<Element> elements;
  std::map<std::string, int> not_kept;  // by kind: how many lines or words are not kept

  bool empty() const { return *this == Attributes{}; }
  int state(std::size_t face) const { return face < state_of_face.size() ? state_of_face[face] : -1; }
  friend bool operator==(const Attributes&, const Attributes&) = default;
};

// Whether the lines with this keyword are statements.
bool is_statement(std::string_view keyword);

// What is not kept, as a part of a sentence: "2 curves, 1 tag"; "" if everything is.
std::string not_kept_text(const Attributes& attributes);

}  // namespace requad::mesh
