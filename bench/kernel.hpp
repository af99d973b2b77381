// The bare kernel that ratios refer to: a closed quad mesh as two integer arrays, twin and origin, and nothing else.
//
// It does only what a basic operation needs. It has no handles, no boundary, no half-edge for each vertex and no free
// lists (the caller keeps the ids of what was removed), and it does not test whether an operation is legal. So it
// shows how fast this data structure can be, but it cannot edit meshes by itself. A flip moves the edge into the
// neighbouring slot: two outer twins change instead of six.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace requad::bench {

class Kernel {
 public:
  static int next(int h) { return (h & ~3) | ((h + 1) & 3); }
  static int previous(int h) { return (h & ~3) | ((h + 3) & 3); }
  static int opposite(int h) { return h ^ 2; }

  int& twin(int h) { return twin_[static_cast<std::size_t>(h)]; }
  int& origin(int h) { return origin_[static_cast<std::size_t>(h)]; }
  int out(int v) const { return out_[static_cast<std::size_t>(v)]; }
  int half_edges() const { return static_cast<int>(twin_.size()); }

  // Pairs half-edges in one pass. The half-edges out of a vertex that are not paired yet form a list, linked through
  // `twin`.
  void build(int vertices, std::span<const std::array<int, 4>> faces) {
    twin_.resize(4 * faces.size());
    origin_.resize(4 * faces.size());
    std::vector<int> waiting(static_cast<std::size_t>(vertices), -1);
    for (int h = 0; h < half_edges(); ++h) {
      const std::array<int, 4>& face = faces[static_cast<std::size_t>(h) / 4];
      const int from = face[static_cast<std::size_t>(h) % 4];
      const int to = face[static_cast<std::size_t>(h + 1) % 4];
      origin(h) = from;
      int* link = &waiting[static_cast<std::size_t>(to)];
      while (*link >= 0 && faces[static_cast<std::size_t>(*link) / 4][static_cast<std::size_t>(*link + 1) % 4] != from)
        link = &twin(*link);
      if (*link >= 0) {
        const int other = *link;
        *link = twin(other);
        twin(h) = other, twin(other) = h;
      } else {
        twin(h) = waiting[static_cast<std::size_t>(from)];
        waiting[static_cast<std::size_t>(from)] = h;
      }
    }
  }
  // Finds a half-edge out of each vertex, for traversal. Operations do not maintain it.
  void find_out(int vertices) {
    out_.resize(static_cast<std::size_t>(vertices));
    for (int h = 0; h < half_edges(); ++h) out_[static_cast<std::size_t>(origin(h))] = h;
  }

  void flip_ccw(int h) {
    const int t = twin(h), h1 = next(h), t1 = next(t);
    const int outer_h1 = twin(h1), outer_t1 = twin(t1);
    glue(outer_t1, h), glue(outer_h1, t), glue(h1, t1);
    origin(h1) = origin(next(t1));
    origin(t1) = origin(next(h1));
  }
  void flip_cw(int h) {
    const int t = twin(h), h3 = previous(h), t3 = previous(t);
    const int outer_h3 = twin(h3), outer_t3 = twin(t3);
    glue(outer_t3, h), glue(outer_h3, t), glue(h3, t3);
    origin(h) = origin(t3);
    origin(t) = origin(h3);
  }
  // Merges the corner opposite the origin of h into that origin. A split may use the face and the vertex again.
  void collapse(int h) {
    const int h1 = next(h), h2 = opposite(h), h3 = previous(h);
    const int a = origin(h), first = twin(h1);
    for (int x = first;; x = twin(previous(x))) {
      origin(x) = a;
      if (previous(x) == twin(h2)) break;
    }
    glue(first, twin(h));
    glue(twin(h2), twin(h3));
  }
  // Moves the sector from first to last to vertex w. Opens the face of va between w and the old vertex, the origin of
  // va.
  void split(int first, int last, int va, int w) {
    const int aw = next(va), wb = opposite(va), bv = previous(va);
    const int v = origin(first);
    origin(aw) = origin(next(first));
    for (int x = first;; x = twin(previous(x))) {
      origin(x) = w;
      if (previous(x) == last) break;
    }
    origin(va) = v, origin(wb) = w, origin(bv) = origin(last);
    const int av = twin(first), vb = twin(last);
    glue(va, av), glue(bv, vb), glue(aw, first), glue(wb, last);
  }

 private:
  void glue(int a, int b) { twin(a) = b, twin(b) = a; }

  std::vector<int> twin_;
  std::vector<int> origin_;
  std::vector<int> out_;
};

}  // namespace requad::bench
