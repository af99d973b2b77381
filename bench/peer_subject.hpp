// Half-edge libraries as subjects (subjects.hpp): the set-up that all of them share, and operations by setters.
//
// A Library holds a mesh and gives the same names to the functions of every library:
//   Site, Vertex, Face              its handles; a Site is a half-edge
//   reserve(), vertex(i)            called once before vertices are added; the handle of vertex i
//   add_vertex(), add_face(a, b, c, d)
//   between(a, b)                   the half-edge from a to b
//   next, previous, opposite, face, source, target      of a half-edge
//   first(face)                     a half-edge of a face
//   for_each_face(visit)            the faces that are not deleted
//   link(a, b)                      makes b the next of a
//   set_face(h, f), set_target(h, v), set_first(f, h)
//   replace_out(v, out, other)      if the vertex keeps the half-edge `out`, it keeps `other` from now on
#pragma once

#include "bench/subjects.hpp"

namespace requad::bench {

// Builds the torus, finds half-edges and lists faces.
template <class Library>
struct PeerSubject : Library {
  using typename Library::Face;
  using typename Library::Site;

  explicit PeerSubject(int n) {
    this->reserve();
    for (int v = 0; v < n * n; ++v) this->add_vertex();
    for (const auto& [a, b, c, d] : torus_faces(n)) {
      this->add_face(this->vertex(a), this->vertex(b), this->vertex(c), this->vertex(d));
    }
  }
  Site site(int a, int b) { return this->between(this->vertex(a), this->vertex(b)); }
  FaceList faces() const {
    FaceList list;
    this->for_each_face([&](Face f) {
      std::array<int, 4>& corners = list.emplace_back();
      Site h = this->first(f);
      for (int& v : corners) {
        v = static_cast<int>(this->source(h).idx());
        h = this->next(h);
      }
    });
    return list;
  }
};

// Flips by setters.
template <class Library>
struct SetterSubject : PeerSubject<Library> {
  using PeerSubject<Library>::PeerSubject;
  using typename Library::Site;

  Site flip(Site h) {
    Library& m = *this;
    const Site t = m.opposite(h), h1 = m.next(h), h2 = m.next(h1), h3 = m.next(h2);
    const Site t1 = m.next(t), t2 = m.next(t1), t3 = m.next(t2);
    const auto f = m.face(h), g = m.face(t);
    const auto u = m.target(t), v = m.target(h);
    m.link(t1, h), m.link(h, h2), m.link(h3, t1), m.link(h1, t), m.link(t, t2), m.link(t3, h1);
    m.set_face(t1, f), m.set_face(h1, g);
    m.set_target(h, m.target(h1)), m.set_target(t, m.target(t1));
    m.set_first(f, h), m.set_first(g, t);
    m.replace_out(u, h, t1), m.replace_out(v, t, h1);
    return h;
  }
  Site flip_back(Site h) {
    Library& m = *this;
    const Site t = m.opposite(h), t1 = m.previous(h), h1 = m.previous(t), h2 = m.next(h), t2 = m.next(t);
    const Site h3 = m.previous(t1), t3 = m.previous(h1);
    const auto f = m.face(h), g = m.face(t);
    const auto p = m.target(h), r = m.target(t);
    m.link(h3, h), m.link(h, h1), m.link(h1, h2), m.link(t3, t), m.link(t, t1), m.link(t1, t2);
    m.set_face(t1, g), m.set_face(h1, f);
    m.set_target(h, m.target(t3)), m.set_target(t, m.target(h3));
    m.set_first(f, h), m.set_first(g, t);
    m.replace_out(r, h, t2), m.replace_out(p, t, h2);
    return h;
  }
};

}  // namespace requad::bench
