// A mesh as a list of faces: validated, moved by the three basic operations, and compared.
//
// Terms
//   face     four vertices, counter-clockwise.
//   star     of a vertex: the other ends of its edges, counter-clockwise. An interior vertex has as many as faces; the
//            star of a boundary vertex starts with the next vertex of the boundary, ends with the one before, and
//            has one more.
//   index    4 - l of an interior vertex of valence l. Vertices whose index is not 0 are irregular.
//
// The boundary consists of the vertices 0, 1, ..., n-1 in counter-clockwise order; side 1 of the region starts with 0.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "verify/check/region.hpp"

namespace check {

using Face = std::array<int, 4>;

struct Irregular {
  int vertex;
  int index;
  friend bool operator==(const Irregular&, const Irregular&) = default;
};

// A basic operation, as a line of a certificate says it.
struct Operation {
  enum class Kind { flip, collapse, split };
  Kind kind;
  std::array<int, 4> vertices;
};

class Disk {
 public:
  // Throws Rejected unless the faces are a quadrangulated disk with the boundary of the region and the vertices 0 to
  // vertices - 1, each edge has two different ends, no two edges have the same ends, and each vertex inside has valence
  // 2 to kMostFaces - 1. O(faces).
  Disk(const Region& region, const std::vector<Face>& faces, int vertices);

  bool inside(int v) const { return v >= boundary_; }
  int faces() const { return face_count_; }
  int vertices() const { return static_cast<int>(at_.size()); }  // those that are gone included
  // In no particular order.
  const std::vector<Irregular>& irregular() const { return irregular_; }

  struct Star {
    std::array<int, 9> ends{};
    std::size_t size = 0;
  };
  // Precondition: 0 <= v < vertices(). Throws Rejected if the faces at v are not one fan, or two edges have the same
  // ends.
  Star star(int v) const;

  // Makes the operation. Throws Rejected if there is none such, or if what it leaves is no disk as the constructor asks
  // for. The disk is then of no more use. O(1).
  //   flip a b c d       the edge a-b becomes c-d, the next diagonal of the hexagon round it
  //   collapse a b c d   the face a b c d goes, c becomes a
  //   split v a b w      along a - v - b: in the faces counter-clockwise from the one left of v -> a to the one left of
  //                      b -> v, v becomes w, the next new vertex; the face v a w b comes between
  void apply(const Operation& operation);

  // The faces, with the interior vertices renamed in the order in which a breadth-first search from the boundary edge
  // 0 -> 1 meets them. Two disks have equal forms iff they are isomorphic by a map that fixes the boundary. O(faces).
  std::vector<int> form() const;

 private:
  static constexpr std::size_t kMostFaces = 8;       // at a vertex
  static constexpr std::size_t kMostIrregular = 12;  // between the operations of a move
  struct Faces {
    std::array<int, kMostFaces> ids{};
    std::size_t size = 0;
  };

  const Face& face(int id) const { return faces_[static_cast<std::size_t>(id)]; }
  Faces& at(int v) { return at_[static_cast<std::size_t>(v)]; }
  const Faces& at(int v) const { return at_[static_cast<std::size_t>(v)]; }
  void add(int id, const Face& face);
  void remove(int id);
  void replace(int id, const Face& face);
  // The face on the left of a -> b and the position of a in it, or {-1, -1} if there is none.
  std::array<int, 2> left_of(int a, int b) const;
  // That face, turned so that it starts with a, b.
  Face turned(const std::array<int, 2>& corner) const;
  // Checks the stars of the vertices of all faces at v, and notes their indices.
  void check_around(int v);
  void check_star(int v);

  void flip(int a, int b, int c, int d);
  void collapse(int a, int b, int c, int d);
  void split(int v, int a, int b, int w);

  std::vector<std::size_t> wanted_;  // how many faces each boundary vertex is to have
  int boundary_;                     // vertices of the boundary
  std::vector<Face> faces_;          // by id
  std::vector<Faces> at_;            // of each vertex; none if it is gone
  int face_count_ = 0;
  std::vector<Irregular> irregular_;
};

}  // namespace check
