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

// Writes the rooted signatures of a mesh, from one root after another.
class SignatureWriter {
 public:
  SignatureWriter(const QuadMesh& mesh, Orientation orientation)
      : m_(mesh),
        mirrored_(orientation == Orientation::mirrored),
        face_number_(static_cast<std::size_t>(mesh.face_capacity()), -1) {
    entered_.reserve(static_cast<std::size_t>(m_.face_count()));
    text_.reserve(3 * static_cast<std::size_t>(m_.face_count()) + 16);
  }

  // Returns false as soon as the text turns out to be greater than `least`. If that is "", every text counts as less.
  bool write(HalfEdgeId root, const std::string& least = "") {
    for (const HalfEdgeId h : entered_) face_number_[QuadMesh::face(h).slot()] = -1;
    entered_.clear();
    text_.clear();
    bool is_less = least.empty();
    std::size_t compared = 0;
    enter(root);
    for (std::size_t i = 0; i < entered_.size(); ++i) {
      HalfEdgeId h = entered_[i];
      for (int k = 0; k < 4; ++k, h = mirrored_ ? QuadMesh::previous(h) : QuadMesh::next(h)) {
        const HalfEdgeId t = m_.twin(h);
        if (!t.valid()) {
          write_number(text_, 0);
        } else if (face_number_[QuadMesh::face(t).slot()] < 0) {
          write_number(text_, 1);
          enter(t);
        } else {
          const std::int32_t gap = number(t) - (4 * static_cast<std::int32_t>(i) + k);
          // If the gap is negative, the edge was written when its twin was reached.
          if (gap > 0) write_number(text_, static_cast<std::uint32_t>(gap) + 1);
        }
      }
      // No signature is the start of another. So if the texts are the same so far, `least` goes on where this one does.
      for (; !is_less && compared < text_.size(); ++compared) {
        if (text_[compared] > least[compared]) return false;
        is_less = text_[compared] < least[compared];
      }
    }
    return true;
  }

  const std::string& text() const { return text_; }
  std::string take_text() { return std::move(text_); }
  // By number of the face, the half-edge by which it was entered.
  const std::vector<HalfEdgeId>& entered() const { return entered_; }

 private:
  void enter(HalfEdgeId h) {
    face_number_[QuadMesh::face(h).slot()] = static_cast<std::int32_t>(entered_.size());
    entered_.push_back(h);
  }
  // The number of a half-edge: 4 * number of the face + number within the face.
  std::int32_t number(HalfEdgeId h) const {
    const std::int32_t n = face_number_[QuadMesh::face(h).slot()];
    const int corner = (h.index() - entered_[static_cast<std::size_t>(n)].index()) & 3;
    return 4 * n + (mirrored_ ? (4 - corner) & 3 : corner);
  }

  const QuadMesh& m_;
  bool mirrored_;
  std::vector<std::int32_t> face_number_;  // by face slot, -1 before the face is reached
  std::vector<HalfEdgeId> entered_;
  std::string text_;
};

// Classes of half-edges that the symmetries found so far map to each other.
class Orbits {
 public:
  explicit Orbits(const QuadMesh& mesh) : parent_(static_cast<std::size_t>(mesh.half_edge_capacity())) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  // Adds the symmetry that maps each half-edge of `from`, with its face, to the half-edge of `to` at the same index.
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
  std::vector<HalfEdgeId> entered;  // by the traversal that gave `least`
  std::optional<Orbits> orbits;     // once a symmetry is known
  std::vector<HalfEdgeId> tried;
  std::set<std::size_t> tried_orbits;
  for (const HalfEdgeId h : m.half_edges()) {
    // In the reflected mesh a half-edge leaves what was its target.
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

namespace {

// Reads the numbers of a signature.
class SignatureReader {
 public:
  explicit SignatureReader(std::string_view text) : text_(text) {}

  std::int64_t number() {
    std::int64_t value = 0;
    for (int shift = 0;; shift += 5) {
      if (at_ == text_.size()) throw MeshError("signature ends too early");
      const std::size_t digit = kAlphabet.find(text_[at_]);
      if (digit == std::string_view::npos)
        throw MeshError("signature: letter " + std::to_string(at_ + 1) + " is not in its alphabet");
      if (shift > 30) throw MeshError("signature: number too large at letter " + std::to_string(at_ + 1));
      ++at_;
      value |= static_cast<std::int64_t>(digit % 32) << shift;
      if (digit == 0 && shift > 0)
        throw MeshError("signature: number with a needless digit at letter " + std::to_string(at_));
      if (digit < 32) return value;
    }
  }
  // How many letters were read.
  std::size_t at() const { return at_; }
  bool at_end() const { return at_ == text_.size(); }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

// The twin of each half-edge; -1 on the boundary.
std::vector<std::int32_t> twins_of_signature(std::string_view text) {
  constexpr std::int32_t kBoundary = -1, kUnknown = -2;
  SignatureReader reader(text);
  std::vector<std::int32_t> twin(4, kUnknown);
  const auto glue = [&twin](std::size_t h, std::size_t t) {
    twin[h] = static_cast<std::int32_t>(t);
    twin[t] = static_cast<std::int32_t>(h);
  };
  for (std::size_t h = 0; h < twin.size(); ++h) {
    if (twin[h] != kUnknown) continue;
    const std::int64_t value = reader.number();
    if (value == 0) {
      twin[h] = kBoundary;
    } else if (value == 1) {
      const std::size_t t = twin.size();
      twin.resize(t + 4, kUnknown);
      glue(h, t);
    } else {
      const std::size_t t = h + static_cast<std::size_t>(value - 1);
      if (t >= twin.size() || twin[t] != kUnknown)
        throw MeshError("signature: letter " + std::to_string(reader.at()) + " glues an edge that is not free");
      glue(h, t);
    }
  }
  if (!reader.at_end())
    throw MeshError("signature goes on after its last edge, from letter " + std::to_string(reader.at() + 1));
  return twin;
}

// The vertices of glued faces: half-edges that turning round their origin connects leave the same vertex.
struct Vertices {
  std::vector<int> of_half_edge;
  int count = 0;
};
Vertices number_vertices(const std::vector<std::int32_t>& twin) {
  const auto next = [](std::int32_t h) { return (h & ~3) | ((h + 1) & 3); };
  const auto previous = [](std::int32_t h) { return (h & ~3) | ((h + 3) & 3); };
  Vertices vertices{std::vector<int>(twin.size(), -1), 0};
  const auto vertex = [&vertices](std::int32_t h) -> int& {
    return vertices.of_half_edge[static_cast<std::size_t>(h)];
  };
  for (std::size_t corner = 0; corner < twin.size(); ++corner) {
    const auto start = static_cast<std::int32_t>(corner);
    if (vertex(start) >= 0) continue;
    for (std::int32_t h = start; h >= 0 && vertex(h) < 0;) {
      vertex(h) = vertices.count;
      h = twin[static_cast<std::size_t>(previous(h))];
    }
    for (std::int32_t t = twin[corner]; t >= 0 && vertex(next(t)) < 0; t = twin[static_cast<std::size_t>(next(t))]) {
      vertex(next(t)) = vertices.count;
    }
    ++vertices.count;
  }
  return vertices;
}

}  // namespace

Region from_signature(std::string_view text) {
  const std::vector<std::int32_t> twin = twins_of_signature(text);
  const Vertices vertices = number_vertices(twin);
  std::vector<std::array<int, 4>> faces(twin.size() / 4);
  for (std::size_t h = 0; h < twin.size(); ++h) faces[h / 4][h % 4] = vertices.of_half_edge[h];
  Region region{QuadMesh::from_faces(vertices.count, faces), HalfEdgeId(0)};
  for (std::size_t h = 0; h < twin.size(); ++h) {
    if (region.mesh.twin(HalfEdgeId(static_cast<std::int32_t>(h))).index() != twin[h]) {
      throw MeshError("signature: two boundary edges join the same vertices");
    }
  }
  return region;
}

namespace {

// The turns along the boundary, from edge `start` on: counter-clockwise, or clockwise if mirrored.
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
