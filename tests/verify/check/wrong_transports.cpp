#include "tests/verify/check/wrong_transports.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <set>

#include "tests/verify/check/tampering_tools.hpp"

namespace requad::tests {

namespace {

using Indices = std::map<int, int>;  // 4 - valence of the irregular vertices inside

Indices indices(const std::vector<Quad>& faces, int boundary) {
  Indices valence;
  for (const Quad& f : faces) {
    for (const int v : f) ++valence[v];
  }
  Indices result;
  for (const auto& [v, l] : valence) {
    if (v >= boundary && l != 4) result[v] = 4 - l;
  }
  return result;
}

// How many faces each boundary vertex has. No operation may change this.
std::vector<int> boundary_faces(const std::vector<Quad>& faces, int boundary) {
  std::vector<int> result(at(boundary), 0);
  for (const Quad& f : faces) {
    for (const int v : f) {
      if (v < boundary) ++result[at(v)];
    }
  }
  return result;
}

bool has_edge(const std::vector<Quad>& faces, int a, int b) {
  return std::any_of(faces.begin(), faces.end(), [=](const Quad& f) {
    const auto it = std::find(f.begin(), f.end(), a);
    if (it == f.end()) return false;
    const std::size_t k = static_cast<std::size_t>(it - f.begin());
    return f[(k + 1) % 4] == b || f[(k + 3) % 4] == b;
  });
}

// All operations, legal or not, at these vertices. `next` is the name that a split gives.
std::vector<ListedOperation> operations_at(const std::vector<Quad>& faces, int boundary, const Indices& irregular,
                                           int next) {
  std::vector<ListedOperation> all = all_flips(faces);
  std::map<int, std::set<int>> neighbours;
  for (Quad f : faces) {
    for (int turn = 0; turn < 4; ++turn) {
      if (f[2] >= boundary) all.push_back({"collapse", {f[0], f[1], f[2], f[3]}});
      neighbours[f[0]].insert({f[1], f[3]});
      std::rotate(f.begin(), f.begin() + 1, f.end());
    }
  }
  for (const auto& [v, ends] : neighbours) {
    if (v < boundary) continue;
    for (const int a : ends) {
      for (const int b : ends) {
        if (a != b) all.push_back({"split", {v, a, b, next}});
      }
    }
  }
  std::erase_if(all, [&](const ListedOperation& op) {
    return std::none_of(op.vertices.begin(), op.vertices.end(), [&](int v) { return irregular.count(v) > 0; });
  });
  return all;
}

// The mesh up to isomorphism rel boundary, with two vertices that keep their names apart.
std::vector<int> form(const std::vector<Quad>& faces, int boundary, int one, int two) {
  std::map<std::array<int, 2>, Quad> left;
  for (Quad f : faces) {
    for (int turn = 0; turn < 4; ++turn) {
      left[{f[0], f[1]}] = f;
      std::rotate(f.begin(), f.begin() + 1, f.end());
    }
  }
  std::map<int, int> name;
  for (int v = 0; v < boundary; ++v) name[v] = v;
  std::vector<int> result;
  std::set<Quad> met;
  std::deque<std::array<int, 2>> queue{{0, 1}};
  while (!queue.empty()) {
    const auto [a, b] = queue.front();
    queue.pop_front();
    const auto it = left.find({a, b});
    if (it == left.end()) continue;
    const Quad& f = it->second;
    Quad key = f;
    std::sort(key.begin(), key.end());
    if (!met.insert(key).second) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      result.push_back(name.emplace(f[k], static_cast<int>(name.size())).first->second);
      queue.push_back({f[(k + 1) % 4], f[k]});
    }
  }
  result.push_back(name[one]);
  result.push_back(name[two]);
  return result;
}

struct OnTheWay {
  std::vector<Quad> faces;
  Script script;
  int next;   // the name that a split gives
  int moved;  // p where it is, -1 before the first operation
};

// Whether the irregular vertices are p, q, a v3 and a v5, and the latter two have an edge in common or not.
bool fits(const std::vector<Quad>& faces, Indices irregular, int p, int q, bool joined) {
  irregular.erase(p);
  irregular.erase(q);
  if (irregular.size() != 2) return false;
  const auto [u, index] = *irregular.begin();
  const auto [v, other] = *irregular.rbegin();
  return index * other == -1 && has_edge(faces, u, v) == joined;
}

Script transport(const ListedRegion& region, const ListedEdge& edge, WrongTransport kind, int p, int q) {
  const int boundary = region.perimeter();
  const ListedMesh& from = region.meshes[at(edge.from)];
  const ListedMesh& to = region.meshes[at(edge.to)];
  const Indices before = indices(from.faces, boundary);
  const std::vector<int> wanted = boundary_faces(from.faces, boundary);
  const auto stays = [&before](const Indices& irregular, int v, int index_of) {
    return irregular.count(v) > 0 && irregular.at(v) == before.at(index_of);
  };
  const bool comes_back = kind == WrongTransport::comes_back;
  std::set<std::vector<int>> seen;
  std::deque<OnTheWay> queue{{from.faces, {}, from.vertices, -1}};
  while (!queue.empty()) {
    const OnTheWay here = queue.front();
    queue.pop_front();
    for (const ListedOperation& op : operations_at(here.faces, boundary, indices(here.faces, boundary), here.next)) {
      OnTheWay next{after(here.faces, op), here.script, here.next + (op.word == "split" ? 1 : 0), here.moved};
      const Indices irregular = indices(next.faces, boundary);
      if (boundary_faces(next.faces, boundary) != wanted) continue;
      next.script.push_back(op);
      if (comes_back && irregular.size() == 2 && here.moved >= 0 && stays(irregular, q, q) &&
          !stays(irregular, here.moved, p) && !isomorphism(to.faces, next.faces, to.vertices, boundary).empty())
        return next.script;
      if (irregular.size() != 4 || !stays(irregular, q, q)) continue;
      if (here.moved < 0 && stays(irregular, p, p)) continue;
      const auto can_be_read = [&](int v, bool joined) {
        return v != q && stays(irregular, v, p) && fits(next.faces, irregular, v, q, joined);
      };
      bool read_as_adjacent = false;
      for (const auto& [v, index] : irregular) read_as_adjacent = read_as_adjacent || can_be_read(v, true);
      for (const auto& [v, index] : irregular) {
        if ((here.moved >= 0 && v != here.moved) || !can_be_read(v, comes_back)) continue;
        if (!comes_back && !read_as_adjacent) {
          next.script.push_back(inverse(op, here.next));
          return next.script;
        }
        next.moved = v;
        if (seen.insert(form(next.faces, boundary, v, q)).second) queue.push_back(next);
      }
    }
  }
  return {};
}

}  // namespace

Script wrong_transport(const ListedRegion& region, const ListedEdge& edge, WrongTransport kind) {
  const std::set<int> pair = irregular(region.meshes[at(edge.from)].faces, region.perimeter());
  if (pair.size() != 2) return {};
  const int one = *pair.begin(), two = *pair.rbegin();
  Script script = transport(region, edge, kind, one, two);
  return script.empty() ? transport(region, edge, kind, two, one) : script;
}

}  // namespace requad::tests
