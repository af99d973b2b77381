#include "enumerate/planar_code.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <utility>

#include "mesh/text/file_error.hpp"

namespace requad::enumerate {

namespace {

using mesh::FileError;

using Rotations = std::vector<std::vector<int>>;  // for each vertex its neighbours, in cyclic order

// The faces are the orbits of darts: after u -> v comes v -> w, where w follows u in the rotation at v.
mesh::QuadMesh mesh_of(const Rotations& rotations, const std::string& where) {
  const auto fail = [&where](const std::string& why) { throw FileError(where + why); };
  const auto size = static_cast<int>(rotations.size());
  std::map<std::pair<int, int>, int> next;
  for (int v = 0; v < size; ++v) {
    const std::vector<int>& around = rotations[static_cast<std::size_t>(v)];
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (around[i] < 0 || around[i] >= size) fail("vertex " + std::to_string(around[i] + 1) + " does not exist");
      if (!next.emplace(std::pair{around[i], v}, around[(i + 1) % around.size()]).second)
        fail("two edges join the vertices " + std::to_string(v + 1) + " and " + std::to_string(around[i] + 1));
    }
  }
  std::vector<std::array<int, 4>> faces;
  while (!next.empty()) {
    const auto start = next.begin()->first;
    std::vector<int> face;
    std::pair<int, int> dart = start;
    do {
      const auto it = next.find(dart);
      if (it == next.end()) fail("vertex " + std::to_string(dart.first + 1) + " has a neighbour that does not have it");
      face.push_back(dart.first);
      dart = {dart.second, it->second};
      next.erase(it);
    } while (dart != start);
    if (face.size() != 4) fail("a face has " + std::to_string(face.size()) + " sides; expected quads");
    faces.push_back({face[0], face[1], face[2], face[3]});
  }
  try {
    return mesh::QuadMesh::from_faces(size, faces);
  } catch (const mesh::MeshError& error) {
    throw FileError(where + error.what());
  }
}

// The numbers of one graph of planar_code.
class Numbers {
 public:
  Numbers(std::string_view text, bool big_endian, const std::string& name)
      : text_(text), big_endian_(big_endian), name_(name) {}

  bool at_end() const { return at_ == text_.size(); }
  // The number of vertices, which says how wide the numbers of this graph are.
  int start_graph() {
    ++graph_;
    wide_ = false;
    const int first = number();
    wide_ = first == 0;
    return wide_ ? number() : first;
  }
  int number() {
    const int first = byte();
    if (!wide_) return first;
    const int second = byte();
    return big_endian_ ? 256 * first + second : first + 256 * second;
  }
  std::string where() const { return name_ + ": graph " + std::to_string(graph_) + ": "; }

 private:
  int byte() {
    if (at_end()) throw FileError(where() + "the text ends too early");
    return static_cast<unsigned char>(text_[at_++]);
  }
  std::string_view text_;
  bool big_endian_;
  std::string name_;
  std::size_t at_ = 0;
  int graph_ = 0;
  bool wide_ = false;
};

std::vector<mesh::QuadMesh> parse_planar_code(std::string_view text, const std::string& name) {
  const std::size_t end = text.substr(0, 40).find("<<");
  if (end == std::string_view::npos) throw FileError(name + ": the header of planar_code has no end");
  Numbers numbers(text.substr(end + 2), text.substr(0, end).ends_with(" be"), name);
  std::vector<mesh::QuadMesh> meshes;
  while (!numbers.at_end()) {
    Rotations rotations(static_cast<std::size_t>(numbers.start_graph()));
    for (std::vector<int>& around : rotations) {
      for (int v = numbers.number(); v != 0; v = numbers.number()) around.push_back(v - 1);
    }
    meshes.push_back(mesh_of(rotations, numbers.where()));
  }
  return meshes;
}

std::vector<mesh::QuadMesh> parse_ascii(std::string_view text, const std::string& name) {
  std::vector<mesh::QuadMesh> meshes;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, length);
    text.remove_prefix(std::min(length + 1, text.size()));
    const std::string where = name + ": graph " + std::to_string(meshes.size() + 1) + ": ";
    std::size_t size = 0;
    const char* const last = line.data() + line.size();
    const auto [end, error] = std::from_chars(line.data(), last, size);
    if (error != std::errc() || end == last || *end != ' ') throw FileError(where + "expected a number and a blank");
    Rotations rotations(1);
    for (const char* c = end + 1; c != last; ++c) {
      if (*c == ',') {
        rotations.emplace_back();
      } else {
        rotations.back().push_back(*c - 'a');
      }
    }
    if (rotations.size() != size)
      throw FileError(where + std::to_string(rotations.size()) + " lists of neighbours; expected " +
                      std::to_string(size));
    meshes.push_back(mesh_of(rotations, where));
  }
  return meshes;
}

}  // namespace

std::vector<mesh::QuadMesh> parse_plantri(std::string_view text, const std::string& name) {
  return text.starts_with(">>planar_code") ? parse_planar_code(text, name) : parse_ascii(text, name);
}

}  // namespace requad::enumerate
