#include "mesh/signature.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
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

}  // namespace

std::string signature(const QuadMesh& m, HalfEdgeId root, Orientation orientation) {
  const bool mirrored = orientation == Orientation::mirrored;
  const auto following = [mirrored](HalfEdgeId h) { return mirrored ? QuadMesh::previous(h) : QuadMesh::next(h); };

  // Per face: its number and the half-edge it was entered by, -1 while not met. Four order places for each face.
  std::vector<std::int32_t> number(static_cast<std::size_t>(m.face_capacity()), -1);
  std::vector<HalfEdgeId> entered;
  entered.reserve(static_cast<std::size_t>(m.face_count()));
  const auto meet = [&](HalfEdgeId h) {
    number[QuadMesh::face(h).slot()] = static_cast<std::int32_t>(entered.size());
    entered.push_back(h);
  };
  const auto place = [&](HalfEdgeId h) {
    const std::int32_t n = number[QuadMesh::face(h).slot()];
    const int corner = (h.index() - entered[static_cast<std::size_t>(n)].index()) & 3;
    return 4 * n + (mirrored ? (4 - corner) & 3 : corner);
  };

  std::string text;
  text.reserve(3 * static_cast<std::size_t>(m.face_count()) + 16);
  meet(root);
  for (std::size_t i = 0; i < entered.size(); ++i) {
    HalfEdgeId h = entered[i];
    for (int k = 0; k < 4; ++k, h = following(h)) {
      const HalfEdgeId t = m.twin(h);
      if (!t.valid()) {
        write_number(text, 0);
      } else if (number[QuadMesh::face(t).slot()] < 0) {
        write_number(text, 1);
        meet(t);
      } else {
        const std::int32_t gap = place(t) - (4 * static_cast<std::int32_t>(i) + k);
        if (gap > 0) {
          // gap < 0: the edge was written when its other side was taken
          write_number(text, static_cast<std::uint32_t>(gap) + 1);
        }
      }
    }
  }
  return text;
}

std::string canonical_signature(const QuadMesh& m, Orientation orientation) {
  using KindOfVertex = std::pair<bool, int>;
  const auto kind = [&m](VertexId v) { return KindOfVertex{m.is_boundary(v), m.face_valence(v)}; };
  std::map<KindOfVertex, int> count;
  for (const VertexId v : m.vertices()) ++count[kind(v)];
  if (count.empty()) return "";
  const auto rarest = std::min_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; })->first;
  std::string least;
  for (const HalfEdgeId h : m.half_edges()) {
    // Mirrored, a half-edge leaves what was its target: corresponding roots must be cut alike.
    if (kind(orientation == Orientation::kept ? m.origin(h) : m.target(h)) != rarest) continue;
    std::string text = signature(m, h, orientation);
    if (least.empty() || text < least) least = std::move(text);
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
      if (digit == std::string_view::npos) throw MeshError("signature: letter " + std::to_string(at + 1) + " is not in its alphabet");
      if (shift > 30) throw MeshError("signature: number too large at letter " + std::to_string(at + 1));
      ++at;
      value |= static_cast<std::int64_t>(digit % 32) << shift;
      if (digit == 0 && shift > 0) throw MeshError("signature: number with a needless digit at letter " + std::to_string(at));
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
      if (t >= twin.size() || twin[t] != -2) throw MeshError("signature: letter " + std::to_string(at) + " glues an edge that is not free");
      twin[h] = static_cast<std::int32_t>(t);
      twin[t] = static_cast<std::int32_t>(h);
    }
  }
  if (at != text.size()) throw MeshError("signature goes on after its last edge, from letter " + std::to_string(at + 1));

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
std::vector<std::string> reflected_signatures(const Region& r) { return symmetric_signatures(r, Orientation::mirrored); }

}  // namespace requad::mesh
