// A folder of certificates as a prover who cheats has it: he reads it, changes what he likes, and writes it with
// counts, names of meshes and checksums that fit. Formats: verify/certificate.hpp.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace requad::tests {

using Quad = std::array<int, 4>;

struct ListedMesh {
  std::string kind;   // "pair" or "merged"
  std::string label;  // "(1,1)"
  std::array<int, 3> d1_d2_p{};
  std::vector<int> strips;
  int vertices = 0;
  std::vector<Quad> faces;
};

struct ListedOperation {
  std::string word;
  std::array<int, 4> vertices{};
};
using Script = std::vector<ListedOperation>;

struct ListedEdge {
  int from = 0;
  int to = 0;
  std::string step;
  std::array<int, 3> before{};  // d1, d2, p
  std::array<int, 3> after{};
  Script script;
};

struct ListedRegion {
  std::string pair;
  std::vector<int> sides;
  std::vector<ListedMesh> meshes;
  std::vector<ListedEdge> edges;

  int perimeter() const;
  // Removes a mesh, and the edges that lead to or from it; the others are numbered anew.
  void drop(std::size_t mesh);
  // The text, with the numbers of configurations, merged vertices and edges that there are.
  std::string text() const;
};
ListedRegion listed_region(const std::string& text);

struct Proof {
  struct File {
    std::string name;
    std::string text;
    std::string checksum;  // "": that of the text
  };
  std::vector<std::string> families;  // lines of the MANIFEST
  std::vector<File> files;

  // Throws std::out_of_range if there is no such file.
  File& file(const std::string& name);
  // Writes the folder, which holds another proof. Files that only the other one has stay where they are.
  void write(const std::filesystem::path& folder, const Proof& there) const;
};
std::string checksum_of(const std::string& text);
Proof read_proof(const std::filesystem::path& folder);

// --- what a prover can do to meshes ----------------------------------------------------------------------------------

// The faces after an operation, which may be illegal. An operation whose edge or face is not there changes nothing.
std::vector<Quad> after(std::vector<Quad> faces, const ListedOperation& operation);
std::vector<Quad> after(std::vector<Quad> faces, const Script& script);
// The operation that takes this one back, if what it made is still there. A vertex that it brings back is `made`.
ListedOperation inverse(const ListedOperation& operation, int made);
// For each vertex of one mesh the vertex of another that an isomorphism takes it to, if it takes boundary vertices to
// themselves and the meshes are isomorphic so; empty if they are not. `boundary` counts the boundary vertices.
std::vector<int> isomorphism(const std::vector<Quad>& from, const std::vector<Quad>& to, int vertices, int boundary);

}  // namespace requad::tests
