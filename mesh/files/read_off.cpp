#include <algorithm>
#include <optional>

#include "mesh/files/read_polygons.hpp"
#include "mesh/files/reading.hpp"

namespace requad::mesh {

namespace {

// How the words of a file are read. The format lets line ends stand anywhere, except that the colour of a face ends with
// its line; files in use break lines less freely, and say less. A reading that fits must take every word of the file.
struct Reading {
  bool vertices_by_lines;  // a vertex is a line: what follows its coordinates is dropped, whatever it is
  bool coloured_faces;     // what follows a face on its line is its colour; otherwise the next face
};

// Reads an OFF text in one way.
class OffReader {
 public:
  OffReader(std::string_view text, const std::string& name, const Reading& how) : scanner_(name, text), how_(how) {
    mesh_.name = name;
    mesh_.first_index = 0;
  }

  PolygonMesh read() {
    read_keyword();
    read_sizes();
    read_vertices();
    read_faces();
    if (!scanner_.at_end_of_line() || scanner_.next_line())
      scanner_.fail("more text after the last of " + std::to_string(faces_) + " faces");
    return finished(std::move(mesh_), scanner_);
  }

 private:
  // Goes to the next word, on this line or a later one. Returns false at the end of the text.
  bool find_word() { return !scanner_.at_end_of_line() || scanner_.next_line(); }

  void read_keyword() {
    if (!find_word()) scanner_.fail("nothing where OFF is expected");
    TextScanner ahead = scanner_;
    const std::string_view keyword = ahead.word();
    if (TextScanner::number_or(keyword, -1) >= 0) return;  // the keyword is optional
    if (!is_off_keyword(keyword)) scanner_.fail(TextScanner::quoted(keyword) + " where OFF is expected");
    if (keyword.find_first_of("4n") != std::string_view::npos)
      scanner_.fail(TextScanner::quoted(keyword) + " is not a surface in three dimensions");
    scanner_ = ahead;
    const auto has = [&keyword](std::string_view part) { return keyword.find(part) != std::string_view::npos; };
    has_colours_ = has("C");
    further_ = (has("ST") ? 2 : 0) + (has("N") ? 3 : 0);
    TextScanner next = scanner_;
    if (next.word() == "BINARY") scanner_.fail("this is a binary OFF file; expected the text format");
  }

  void read_sizes() {
    if (!find_word()) scanner_.fail("the file ends where the numbers of vertices and faces are expected");
    vertices_ = scanner_.integer("the number of vertices");
    const int line = scanner_.line();
    if (!find_word()) scanner_.fail("the file ends where the number of faces is expected");
    const bool one_line = scanner_.line() == line;
    faces_ = scanner_.integer("the number of faces");
    // The number of edges is not used: many files have a wrong one, and some have none.
    if (!one_line && !find_word()) scanner_.fail("the file ends where the number of edges is expected");
    if (!scanner_.at_end_of_line()) scanner_.integer("the number of edges");
    if (how_.vertices_by_lines && !scanner_.at_end_of_line())
      scanner_.fail(TextScanner::quoted(scanner_.word()) + " after the numbers of vertices, faces and edges");
    // A vertex takes at least six characters, "0 0 0" and a line's end; a face takes eight.
    const auto most = static_cast<std::int64_t>(scanner_.bytes_left() + 1);
    if (vertices_ < 0 || faces_ < 0 || vertices_ > most / 6 || faces_ > most / 8) {
      scanner_.fail(std::to_string(vertices_) + " vertices and " + std::to_string(faces_) + " faces are promised; " +
                    std::to_string(most - 1) + " characters follow");
    }
  }

  // The words of the line on which the next vertex starts.
  int words_ahead() const {
    TextScanner ahead = scanner_;
    int words = 0;
    for (; !ahead.word().empty();) ++words;
    return words;
  }

  void read_vertices() {
    mesh_.positions.reserve(static_cast<std::size_t>(vertices_));
    int further = further_;
    for (std::int64_t v = 0; v < vertices_; ++v) {
      if (!find_word())
        scanner_.fail("the file ends after " + std::to_string(v) + " of " + std::to_string(vertices_) + " vertices");
      // Geomview's colours have four numbers; those of other programs have three too.
      if (v == 0 && has_colours_) further += words_ahead() == 3 + further + 3 ? 3 : 4;
      if (how_.vertices_by_lines) {
        mesh_.positions.push_back(scanner_.position());
        while (!scanner_.at_end_of_line()) scanner_.require_number(scanner_.word());
      } else {
        Eigen::Vector3d p;
        for (double& coordinate : p) {
          if (!find_word()) scanner_.fail("the file ends where a coordinate is expected");
          coordinate = scanner_.coordinate();
        }
        mesh_.positions.push_back(p);
        for (int i = 0; i < further && find_word(); ++i) scanner_.require_number(scanner_.word());
      }
    }
    if (has_colours_) mesh_.attributes.not_kept["colours of vertices"] = static_cast<int>(vertices_);
  }

  void read_faces() {
    std::vector<int> face;
    for (std::int64_t f = 0; f < faces_; ++f) {
      if (!find_word())
        scanner_.fail("the file ends after " + std::to_string(f) + " of " + std::to_string(faces_) + " faces");
      const int line = scanner_.line();
      const std::int64_t size = scanner_.integer("a face's number of corners");
      check_corner_count(scanner_, size);
      if (size > static_cast<std::int64_t>(scanner_.bytes_left())) {
        scanner_.fail("a face with " + std::to_string(size) + " corners is promised; " +
                      std::to_string(scanner_.bytes_left()) + " characters follow");
      }
      face.clear();
      for (std::int64_t k = 0; k < size; ++k) {
        if (!find_word()) scanner_.fail("the file ends where a face's vertex is expected");
        const std::int64_t v = scanner_.integer("a face's vertex");
        if (v < 0 || v >= vertices_) {
          scanner_.fail("vertex " + std::to_string(v) + " does not exist; there are " + std::to_string(vertices_) +
                        ", counted from 0");
        }
        face.push_back(static_cast<int>(v));
      }
      if (how_.coloured_faces) {
        if (!scanner_.at_end_of_line()) ++mesh_.attributes.not_kept["colours of faces"];
        while (!scanner_.at_end_of_line()) scanner_.require_number(scanner_.word());
      }
      mesh_.add_face(face, line);
    }
  }

  TextScanner scanner_;
  Reading how_;
  PolygonMesh mesh_;
  std::int64_t vertices_ = 0, faces_ = 0;
  int further_ = 0;  // numbers of a vertex after its coordinates, without those of a colour
  bool has_colours_ = false;
};

}  // namespace

PolygonMesh parse_off(std::string_view text, const std::string& name) {
  // The usual reading comes first, and its message is the one that is reported.
  std::optional<FileError> first;
  for (const Reading& how : {Reading{true, true}, {false, true}, {true, false}, {false, false}}) {
    try {
      return OffReader(text, name, how).read();
    } catch (const FileError& error) {
      if (!first) first = error;
    }
  }
  throw *first;
}

}  // namespace requad::mesh
