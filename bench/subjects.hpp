// The subjects that are compared, behind one interface: the bare kernel, requad, and other libraries
// (peer_subject.hpp). Also the tori on which they are measured, and the test that all of them make the same meshes.
//
// A subject is built as a torus. It finds a half-edge by its ends, and performs these operations there:
//   flip, flip_back     turns the edge by one corner counter-clockwise, and back
//   collapse, split     closes the face of the half-edge, whose origin stays, and opens it again
// Each call returns what the next call of the pair needs, since libraries differ in which handles stay valid. A subject
// without collapse and split has no Undo.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include "bench/kernel.hpp"
#include "bench/require.hpp"
#include "mesh/geometry/measures.hpp"
#include "mesh/topology/basic_operations.hpp"
#include "mesh/topology/signature.hpp"

namespace requad::bench {

using FaceList = std::vector<std::array<int, 4>>;

// n x n quads; the vertex in column i and row j is i n + j.
inline FaceList torus_faces(int n) {
  FaceList faces;
  faces.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  const auto at = [n](int i, int j) { return (i % n) * n + j % n; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  return faces;
}

// The positions of its vertices in space.
inline mesh::Positions torus_positions(int n) {
  mesh::Positions positions;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double s = 2 * std::numbers::pi * i / n, t = 2 * std::numbers::pi * j / n;
      positions.emplace_back((3 + std::cos(t)) * std::cos(s), (3 + std::cos(t)) * std::sin(s), std::sin(t));
    }
  }
  return positions;
}

// The ends of half-edges in random order and with random directions. They are four quads apart, so that an operation at
// one of them does not touch the others. Precondition: n is a multiple of 4.
inline std::vector<std::array<int, 2>> random_sites(int n) {
  std::mt19937 random(2011);
  const FaceList faces = torus_faces(n);
  std::vector<std::array<int, 2>> sites;
  for (int i = 0; i < n; i += 4) {
    for (int j = 0; j < n; j += 4) {
      const auto& face = faces[static_cast<std::size_t>(i * n + j)];
      const std::size_t k = random() % 4;
      sites.push_back({face[k], face[(k + 1) % 4]});
    }
  }
  std::shuffle(sites.begin(), sites.end(), random);
  return sites;
}

struct KernelSubject {
  using Site = int;
  struct Undo {
    int first, last, va, w;
  };
  static constexpr const char* kName = "kernel";

  explicit KernelSubject(int n) {
    kernel.build(n * n, torus_faces(n));
    kernel.find_out(n * n);
  }
  Site site(int a, int b) {
    int h = kernel.out(a);
    while (kernel.origin(Kernel::next(h)) != b) h = kernel.twin(Kernel::previous(h));
    return h;
  }
  Site flip(Site h) {
    kernel.flip_ccw(h);
    return Kernel::next(h);
  }
  Site flip_back(Site h) {
    kernel.flip_cw(h);
    return Kernel::previous(h);
  }
  Undo collapse(Site h) {
    const Undo undo{kernel.twin(Kernel::next(h)), kernel.twin(Kernel::opposite(h)), h,
                    kernel.origin(Kernel::opposite(h))};
    kernel.collapse(h);
    gone = h >> 2;
    return undo;
  }
  Site split(const Undo& undo) {
    kernel.split(undo.first, undo.last, undo.va, undo.w);
    gone = -1;
    return undo.va;
  }
  FaceList faces() {
    FaceList list;
    for (int h = 0; h < kernel.half_edges(); h += 4) {
      if (h >> 2 != gone)
        list.push_back({kernel.origin(h), kernel.origin(h + 1), kernel.origin(h + 2), kernel.origin(h + 3)});
    }
    return list;
  }

  Kernel kernel;
  int gone = -1;
};

// requad's operations, checked or not.
template <bool kChecked>
struct RequadSubject {
  using Site = mesh::HalfEdgeId;
  struct Undo {
    Site first, last;
    int corner;
  };
  static constexpr const char* kName = kChecked ? "checked" : "unchecked";

  explicit RequadSubject(int n) : mesh(mesh::QuadMesh::from_faces(n * n, torus_faces(n))) {}
  Site site(int a, int b) const { return mesh.find_half_edge(mesh::VertexId(a), mesh::VertexId(b)); }
  Site flip(Site h) {
    rotate(h, mesh::Rotation::counter_clockwise);
    return mesh::QuadMesh::next(h);
  }
  Site flip_back(Site h) {
    rotate(h, mesh::Rotation::clockwise);
    return mesh::QuadMesh::previous(h);
  }
  Undo collapse(Site h) {
    const Undo undo{mesh.twin(mesh::QuadMesh::next(h)), mesh.twin(mesh::QuadMesh::opposite(h)), h.index() & 3};
    if constexpr (kChecked) {
      refused |= mesh::collapse(mesh, h) != mesh::Refusal::none;
    } else {
      mesh::collapse_unchecked(mesh, h);
    }
    return undo;
  }
  Site split(const Undo& undo) {
    if constexpr (kChecked) {
      return mesh::split(mesh, undo.first, undo.last, undo.corner).made;
    } else {
      return mesh::split_unchecked(mesh, undo.first, undo.last, undo.corner);
    }
  }
  FaceList faces() const { return mesh.compact_faces(); }

  mesh::QuadMesh mesh;
  bool refused = false;

 private:
  void rotate(Site h, mesh::Rotation direction) {
    if constexpr (kChecked) {
      refused |= mesh::flip(mesh, h, direction) != mesh::Refusal::none;
    } else {
      mesh::flip_unchecked(mesh, h, direction);
    }
  }
};

// The canonical signature of the mesh with these faces, whose vertices may have any numbers.
inline std::string name_of(FaceList faces) {
  std::vector<int> used;
  for (const auto& face : faces) used.insert(used.end(), face.begin(), face.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (auto& face : faces) {
    for (int& v : face) v = static_cast<int>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
  }
  return mesh::canonical_signature(mesh::QuadMesh::from_faces(static_cast<int>(used.size()), faces));
}

// Throws if the subject does not make the meshes that requad makes, at every site of a small torus.
template <class Subject>
void require_same_meshes() {
  constexpr int kSmall = 8;
  RequadSubject<true> ours(kSmall);
  Subject theirs(kSmall);
  const auto compare = [&](const char* after) {
    if (name_of(ours.faces()) != name_of(theirs.faces()))
      throw std::logic_error(std::string(Subject::kName) + " makes another mesh by a " + after);
  };
  compare("build");
  for (const auto& [a, b] : random_sites(kSmall)) {
    const auto flipped = ours.flip(ours.site(a, b));
    const auto their_flipped = theirs.flip(theirs.site(a, b));
    compare("flip");
    ours.flip_back(flipped), theirs.flip_back(their_flipped);
    compare("flip back");
    if constexpr (requires { typename Subject::Undo; }) {
      const auto closed = ours.collapse(ours.site(a, b));
      const auto their_closed = theirs.collapse(theirs.site(a, b));
      compare("collapse");
      ours.split(closed), theirs.split(their_closed);
      compare("split");
    }
  }
  require(!ours.refused, "an operation on a torus was refused");
}

}  // namespace requad::bench
