#include "mesh/topology/signature.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace requad::mesh {

namespace {

constexpr std::string_view kAlphabet = "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ-_";

void write_number(std::string& text, std::uint32_t value) {
  while (value >= 32) {
    text += kAlphabet[32 + value % 32];
    value /= 32;
  }
  text += kAlphabet[value];
}

// Walks a mesh from one root after another.
class SignatureWriter {
 public:
  SignatureWriter(const QuadMesh& mesh, Orientation orientation)
      : m_(mesh),
        mirrored_(orientation == Orientation::mirrored),
        number_(static_cast<std::size_t>(mesh.face_capacity()), -1) {
    entered_.reserve(static_cast<std::size_t>(m_.face_count()));
    text_.reserve(3 * static_cast<std::size_t>(m_.face_count()) + 16);
  }

  // Stops, and returns false, as soon as the text is seen to be greater than `least`; nothing to compare with is "".
  bool write(HalfEdgeId root, const std::string& least = "") {
    for (const HalfEdgeId h : entered_) number_[QuadMesh::face(h).slot()] = -1;
    entered_.clear();
    text_.clear();
    bool is_less = least.empty();
    std::size_t compared = 0;
    meet(root);
    for (std::size_t i = 0; i < entered_.size(); ++i) {
      HalfEdgeId h = entered_[i];
      for (int k = 0; k < 4; ++k, h = mirrored_ ? QuadMesh::previous(h) : QuadMesh::next(h)) {
        const HalfEdgeId t = m_.twin(h);
        if (!t.valid()) {
          write_number(text_, 0);
        } else if (number_[QuadMesh::face(t).slot()] < 0) {
          write_number(text_, 1);
          meet(t);
        } else {
          const std::int32_t gap = place(t) - (4 * static_cast<std::int32_t>(i) + k);
          // gap < 0: the edge was written when its other side was taken
          if (gap > 0) write_number(text_, static_cast<std::uint32_t>(gap) + 1);
        }
      }
      // No signature starts another, so while the texts are alike each has a letter where the other has one.
      for (; !is_less && compared < text_.size(); ++compared) {
        if (text_[compared] > least[compared]) return false;
        is_less = text_[compared] < least[compared];
      }
    }
    return true;
  }

  const std::string& text() const { return text_; }
  std::string take_text() { return std::move(text_); }
  // The half-edge by which each face was entered, in the order of the faces.
  const std::vector<HalfEdgeId>& entered() const { return entered_; }

 private:
  void meet(HalfEdgeId h) {
    number_[QuadMesh::face(h).slot()] = static_cast<std::int32_t>(entered_.size());
    entered_.push_back(h);
  }
  // In the order of half-edges, four for each face.
  std::int32_t place(HalfEdgeId h) const {
    const std::int32_t n = number_[QuadMesh::face(h).slot()];
    const int corner = (h.index() - entered_[static_cast<std::size_t>(n)].index()) & 3;
    return 4 * n + (mirrored_ ? (4 - corner) & 3 : corner);
  }

  const QuadMesh& m_;
  bool mirrored_;
  std::vector<std::int32_t> number_;  // by face, -1 while not met
  std::vector<HalfEdgeId> entered_;
  std::string text_;
};

// Half-edges that symmetries of the mesh take to each other, as far as symmetries are known.
class Orbits {
 public:
  explicit Orbits(const QuadMesh& mesh) : parent_(static_cast<std::size_t>(mesh.half_edge_capacity())) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  // The symmetry that takes each entered half-edge to the other's in its place, and their faces along.
  void add(const std::vector<HalfEdgeId>& from, const std::vector<HalfEdgeId>& to) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      HalfEdgeId a = from[i], b = to[i];
      for (int k = 0; k < 4; ++k, a = QuadMesh::next(a), b = QuadMesh::next(b))
        parent_[representative(a)] = representative(b);
    }
  }
  std::size_t representative(HalfEdgeId h) {
    std::size_t i = h.slot();
    for (; parent_[i] != i; i = parent_[i]) parent_[i] = parent_[parent_[i]];
    return i;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

std::string signature(const QuadMesh& m, HalfEdgeId root, Orientation orientation) {
  SignatureWriter writer(m, orientation);
  writer.write(root);
  return writer.take_text();
}

std::string canonical_signature(const QuadMesh& m, Orientation orientation) {
  using KindOfVertex = std::pair<bool, int>;
  const auto kind = [&m](VertexId v) { return KindOfVertex{m.is_boundary(v), m.face_valence(v)}; };
  std::map<KindOfVertex, int> count;
  for (const VertexId v : m.vertices()) ++count[kind(v)];
  if (count.empty()) return "";
  const auto rarest = std::min_element(count.begin(), count.end(), [](const auto& a, const auto& b) {
                        return a.second < b.second;
                      })->first;
  SignatureWriter writer(m, orientation);
  std::string least;
  std::vector<HalfEdgeId> entered;  // in the walk that made it
  std::optional<Orbits> orbits;     // once a symmetry is known
  std::vector<HalfEdgeId> tried;
  std::set<std::size_t> tried_orbits;
  for (const HalfEdgeId h : m.half_edges()) {
    // Mirrored, a half-edge leaves what was its target: corresponding roots must be cut alike.
    if (kind(orientation == Orientation::kept ? m.origin(h) : m.target(h)) != rarest) continue;
    if (orbits && tried_orbits.count(orbits->representative(h)) > 0) continue;
    tried.push_back(h);
    if (writer.write(h, least)) {
      if (writer.text() == least) {
        if (!orbits) orbits.emplace(m);
        orbits->add(entered, writer.entered());
        tried_orbits.clear();
        for (const HalfEdgeId t : tried) tried_orbits.insert(orbits->representative(t));
      } else {
        least = writer.text();
        entered = writer.entered();
      }
    }
    if (orbits) tried_orbits.insert(orbits->representative(h));
  }
  return least;
}

Region from_signature(std::string_view text) {
  // Glue half-edges by their places in the order, then name vertices by walking round them.
  std::vector<std::int32_t> twin(4, -2);  // -2 not yet known, -1 boundary
  std::size_t at = 0;
  const auto read_number = [&]() -> std::int64_t {
    std::int64_t value = 0;
    for (int shift = 0;; shift += 5) {
      if (at == text.size()) throw MeshError("signature ends too early");
      const std::size_t digit = kAlphabet.find(text[at]);
      if (digit == std::string_view::npos)
        throw MeshError("signature: letter " + std::to_string(at + 1) + " is not in its alphabet");
      if (shift > 30) throw MeshError("signature: number too large at letter " + std::to_string(at + 1));
      ++at;
      value |= static_cast<std::int64_t>(digit % 32) << shift;
      if (digit == 0 && shift > 0)
        throw MeshError("signature: number with a needless digit at letter " + std::to_string(at));
      if (digit < 32) return value;
    }
  };
  for (std::size_t h = 0; h < twin.size(); ++h) {
    if (twin[h] != -2) continue;
    const std::int64_t value = read_number();
    if (value == 0) {
      twin[h] = -1;
    } else if (value == 1) {
      const std::size_t t = twin.size();
      twin.resize(t + 4, -2);
      twin[h] = static_cast<std::int32_t>(t);
      twin[t] = static_cast<std::int32_t>(h);
    } else {
      const std::size_t t = h + static_cast<std::size_t>(value - 1);
      if (t >= twin.size() || twin[t] != -2)
        throw MeshError("signature: letter " + std::to_string(at) + " glues an edge that is not free");
      twin[h] = static_cast<std::int32_t>(t);
      twin[t] = static_cast<std::int32_t>(h);
    }
  }
  if (at != text.size())
    throw MeshError("signature goes on after its last edge, from letter " + std::to_string(at + 1));

  // Corners that turning about a vertex connects are one vertex.
  const auto next = [](std::int32_t h) { return (h & ~3) | ((h + 1) & 3); };
  const auto previous = [](std::int32_t h) { return (h & ~3) | ((h + 3) & 3); };
  std::vector<int> vertex(twin.size(), -1);
  int vertices = 0;
  for (std::size_t corner = 0; corner < twin.size(); ++corner) {
    if (vertex[corner] >= 0) continue;
    const auto start = static_cast<std::int32_t>(corner);
    for (std::int32_t h = start; h >= 0 && vertex[static_cast<std::size_t>(h)] < 0;) {
      vertex[static_cast<std::size_t>(h)] = vertices;
      h = twin[static_cast<std::size_t>(previous(h))];
    }
    for (std::int32_t t = twin[corner]; t >= 0 && vertex[static_cast<std::size_t>(next(t))] < 0;
         t = twin[static_cast<std::size_t>(next(t))]) {
      vertex[static_cast<std::size_t>(next(t))] = vertices;
    }
    ++vertices;
  }
  std::vector<std::array<int, 4>> faces(twin.size() / 4);
  for (std::size_t h = 0; h < twin.size(); ++h) faces[h / 4][h % 4] = vertex[h];
  Region region{QuadMesh::from_faces(vertices, faces), HalfEdgeId(0)};
  for (std::size_t h = 0; h < twin.size(); ++h) {
    if (region.mesh.twin(HalfEdgeId(static_cast<std::int32_t>(h))).index() != twin[h]) {
      throw MeshError("signature: two boundary edges join the same vertices");
    }
  }
  return region;
}

namespace {

// Turns along the boundary from `start`, walking counter-clockwise, or clockwise if mirrored.
std::vector<int> turns_from(const std::vector<int>& turns, std::size_t start, bool mirrored) {
  const std::size_t n = turns.size();
  std::vector<int> result(n);
  // Counter-clockwise from edge `start`, the vertices are start, start+1, ...; clockwise they are start+1, start, ...
  for (std::size_t i = 0; i < n; ++i) result[i] = mirrored ? turns[(start + 1 + n - i) % n] : turns[(start + i) % n];
  return result;
}

std::vector<std::string> symmetric_signatures(const Region& r, Orientation orientation) {
  const std::vector<HalfEdgeId> loop = boundary_loop(r.mesh, r.root);
  std::vector<int> turns;
  turns.reserve(loop.size());
  for (const HalfEdgeId h : loop) turns.push_back(turn(r.mesh, r.mesh.origin(h)));
  std::vector<std::string> found;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (turns_from(turns, i, orientation == Orientation::mirrored) == turns) {
      found.push_back(signature(r.mesh, loop[i], orientation));
    }
  }
  return found;
}

}  // namespace

std::vector<std::string> rotated_signatures(const Region& r) { return symmetric_signatures(r, Orientation::kept); }
std::vector<std::string> reflected_signatures(const Region& r) {
  return symmetric_signatures(r, Orientation::mirrored);
}

}  // namespace requad::mesh
