#include "verify/check/disk.hpp"

#include <algorithm>

#include "verify/check/reading.hpp"

namespace check {

namespace {

std::size_t position(const Face& face, int v) {
  return static_cast<std::size_t>(std::find(face.begin(), face.end(), v) - face.begin());
}

}  // namespace

Disk::Disk(const Region& region, const std::vector<Face>& faces, int vertices) : boundary_(region.perimeter()) {
  for (const int side : region.sides) {
    wanted_.push_back(1);
    wanted_.insert(wanted_.end(), static_cast<std::size_t>(side - 1), 2);
  }
  // Euler's formula, V - E + F = 1 with 2 E = 4 F + n. So there are not more vertices than the file has room for.
  require(vertices >= boundary_ && 2 * (vertices - static_cast<int>(faces.size()) - 1) == boundary_,
          "the numbers of vertices and faces are not those of a disk");
  at_.resize(static_cast<std::size_t>(vertices));
  faces_.resize(faces.size());
  for (std::size_t id = 0; id < faces.size(); ++id) {
    for (const int v : faces[id]) require(v < vertices, "a vertex is beyond the number of vertices");
    add(static_cast<int>(id), faces[id]);
  }
  for (int v = 0; v < vertices; ++v) check_star(v);
  require(form().size() == 4 * faces.size(), "the mesh falls apart");
}

void Disk::add(int id, const Face& face) {
  for (std::size_t i = 0; i < 4; ++i) {
    require(std::count(face.begin(), face.end(), face[i]) == 1, "a face has one vertex twice");
    Faces& faces = at(face[i]);
    require(faces.size < kMostFaces, "a vertex has too many faces");
    faces.ids[faces.size++] = id;
  }
  faces_[static_cast<std::size_t>(id)] = face;
  ++face_count_;
}

void Disk::remove(int id) {
  for (const int v : face(id)) {
    Faces& faces = at(v);
    const auto end = faces.ids.begin() + static_cast<std::ptrdiff_t>(faces.size);
    *std::find(faces.ids.begin(), end, id) = faces.ids[--faces.size];
  }
  --face_count_;
}

void Disk::replace(int id, const Face& face) {
  remove(id);
  add(id, face);
}

std::array<int, 2> Disk::left_of(int a, int b) const {
  if (a < 0 || a >= vertices()) return {-1, -1};
  for (std::size_t i = 0; i < at(a).size; ++i) {
    const int id = at(a).ids[i];
    const std::size_t k = position(face(id), a);
    if (face(id)[(k + 1) % 4] == b) return {id, static_cast<int>(k)};
  }
  return {-1, -1};
}

Face Disk::turned(const std::array<int, 2>& corner) const {
  Face f = face(corner[0]);
  std::rotate(f.begin(), f.begin() + corner[1], f.end());
  return f;
}

Disk::Star Disk::star(int v) const {
  const Faces& faces = at(v);
  require(faces.size > 0, "a vertex has no face");
  // Each face leads from one end to the next one counter-clockwise.
  std::array<std::array<int, 2>, kMostFaces> steps{};
  for (std::size_t i = 0; i < faces.size; ++i) {
    const Face& f = face(faces.ids[i]);
    const std::size_t k = position(f, v);
    steps[i] = {f[(k + 1) % 4], f[(k + 3) % 4]};
    for (std::size_t j = 0; j < i; ++j)
      require(steps[i][0] != steps[j][0] && steps[i][1] != steps[j][1], "two edges have the same ends");
  }
  Star star;
  int end = inside(v) ? steps[0][0] : (v + 1) % boundary_;
  for (std::size_t met = 0; met < faces.size; ++met) {
    star.ends[star.size++] = end;
    const auto step = std::find_if(steps.begin() + static_cast<std::ptrdiff_t>(met),
                                   steps.begin() + static_cast<std::ptrdiff_t>(faces.size),
                                   [end](const auto& s) { return s[0] == end; });
    require(step != steps.begin() + static_cast<std::ptrdiff_t>(faces.size), "the faces at a vertex are not one fan");
    end = (*step)[1];
    std::swap(*step, steps[met]);
  }
  if (inside(v)) {
    require(end == star.ends[0], "the faces at a vertex inside do not close up");
  } else {
    require(end == (v + boundary_ - 1) % boundary_, "the boundary is not 0, 1, 2, ...");
    star.ends[star.size++] = end;
  }
  return star;
}

void Disk::check_star(int v) {
  const std::size_t faces = at(v).size;
  star(v);
  if (inside(v)) {
    require(faces >= 2 && faces < kMostFaces, "the valence of a vertex inside is not in 2..7");
  } else {
    require(faces == wanted_[static_cast<std::size_t>(v)], "a boundary vertex has a wrong number of faces");
  }
  std::erase_if(irregular_, [v](const Irregular& other) { return other.vertex == v; });
  if (inside(v) && faces != 4) irregular_.push_back({v, 4 - static_cast<int>(faces)});
  require(irregular_.size() <= kMostIrregular, "there are too many irregular vertices");
}

void Disk::check_around(int v) {
  for (std::size_t i = 0; i < at(v).size; ++i) {
    const Face f = face(at(v).ids[i]);
    for (const int corner : f) check_star(corner);
  }
}

void Disk::apply(const Operation& operation) {
  const auto [a, b, c, d] = operation.vertices;
  switch (operation.kind) {
    case Operation::Kind::flip: return flip(a, b, c, d);
    case Operation::Kind::collapse: return collapse(a, b, c, d);
    case Operation::Kind::split: return split(a, b, c, d);
  }
}

void Disk::flip(int a, int b, int c, int d) {
  const auto one = left_of(a, b), two = left_of(b, a);
  require(one[0] >= 0 && two[0] >= 0, "flip: there is no such inner edge");
  const Face f = turned(one), g = turned(two);  // a b p q and b a r s
  const int p = f[2], q = f[3], r = g[2], s = g[3];
  if ((c == r && d == p) || (c == p && d == r)) {
    replace(one[0], {a, r, p, q});
    replace(two[0], {r, s, b, p});
  } else {
    require((c == s && d == q) || (c == q && d == s), "flip: the new edge is no diagonal of the hexagon");
    replace(one[0], {s, b, p, q});
    replace(two[0], {q, a, r, s});
  }
  for (const int v : {a, b, p, q, r, s}) check_star(v);
}

void Disk::collapse(int a, int b, int c, int d) {
  const auto corner = left_of(a, b);
  require(corner[0] >= 0 && turned(corner) == Face{a, b, c, d}, "collapse: there is no such face");
  require(inside(c), "collapse: the vertex that goes is on the boundary");
  remove(corner[0]);
  while (at(c).size > 0) {
    const int id = at(c).ids[0];
    Face f = face(id);
    f[position(f, c)] = a;
    replace(id, f);
  }
  std::erase_if(irregular_, [c](const Irregular& other) { return other.vertex == c; });
  check_star(b);
  check_star(d);
  check_around(a);
}

void Disk::split(int v, int a, int b, int w) {
  require(w == vertices(), "split: the new vertex does not have the next number");
  at_.emplace_back();
  int to = a;
  while (to != b || at(w).size == 0) {
    const auto corner = left_of(v, to);
    require(corner[0] >= 0, "split: the two edges bound no sector");
    Face f = turned(corner);
    to = f[3];
    f[0] = w;
    replace(corner[0], f);
  }
  faces_.emplace_back();
  add(static_cast<int>(faces_.size()) - 1, {v, a, w, b});
  check_around(v);
  check_around(w);
}

std::vector<int> Disk::form() const {
  std::vector<int> names(at_.size(), -1);
  for (int v = 0; v < boundary_; ++v) names[static_cast<std::size_t>(v)] = v;
  int next = boundary_;
  std::vector<int> form;
  form.reserve(4 * static_cast<std::size_t>(face_count_));
  std::vector<bool> met(faces_.size());
  std::vector<std::array<int, 2>> queue{left_of(0, 1)};
  met[static_cast<std::size_t>(queue[0][0])] = true;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Face f = turned(queue[i]);
    for (std::size_t k = 0; k < 4; ++k) {
      int& name = names[static_cast<std::size_t>(f[k])];
      if (name < 0) name = next++;
      form.push_back(name);
      const auto across = left_of(f[(k + 1) % 4], f[k]);
      if (across[0] < 0 || met[static_cast<std::size_t>(across[0])]) continue;
      met[static_cast<std::size_t>(across[0])] = true;
      queue.push_back(across);
    }
  }
  return form;
}

}  // namespace check
