#include "tests/verify/check/tampering_tools.hpp"

#include <algorithm>
#include <array>

namespace requad::tests {

std::function<bool(Proof&, Proof::File&)> in_region(const std::function<bool(ListedRegion&)>& change) {
  return [change](Proof&, Proof::File& file) {
    ListedRegion region = listed_region(file.text);
    if (!change(region)) return false;
    file.text = region.text();
    return true;
  };
}

std::function<bool(Proof&, Proof::File&)> in_meshes(
    const std::function<void(const ListedRegion&, ListedMesh&)>& change) {
  return in_region([change](ListedRegion& r) {
    for (ListedMesh& m : r.meshes) change(r, m);
    return true;
  });
}

std::function<bool(Proof&, Proof::File&)> in_edges(const std::function<void(ListedEdge&)>& change) {
  return in_region([change](ListedRegion& r) {
    for (ListedEdge& e : r.edges) change(e);
    return !r.edges.empty();
  });
}

std::size_t first_pair(const ListedRegion& r) {
  return at(
      static_cast<int>(std::find_if(r.meshes.begin(), r.meshes.end(), [](const auto& m) { return m.kind == "pair"; }) -
                       r.meshes.begin()));
}

ListedEdge* edge_with(ListedRegion& r, std::size_t at_least, const std::string& step) {
  const auto it = std::find_if(r.edges.begin(), r.edges.end(), [&](const ListedEdge& e) {
    return e.script.size() >= at_least && (step.empty() || e.step.starts_with(step));
  });
  return it == r.edges.end() ? nullptr : &*it;
}

void rename(ListedRegion& r, std::size_t mesh, const std::function<int(int)>& name) {
  for (Quad& f : r.meshes[mesh].faces) std::transform(f.begin(), f.end(), f.begin(), name);
  for (ListedEdge& e : r.edges) {
    if (at(e.from) != mesh) continue;
    for (ListedOperation& op : e.script)
      std::transform(op.vertices.begin(), op.vertices.end(), op.vertices.begin(), name);
  }
}

void mirror(ListedRegion& r) {
  for (ListedMesh& m : r.meshes) {
    for (Quad& f : m.faces) std::reverse(f.begin(), f.end());
  }
  for (ListedEdge& e : r.edges) {
    for (ListedOperation& op : e.script) {
      auto& v = op.vertices;
      if (op.word == "collapse") std::swap(v[1], v[3]);
      if (op.word == "split") std::swap(v[1], v[2]);
    }
  }
}

Script translated(Script script, const std::map<int, int>& name) {
  for (ListedOperation& op : script) {
    for (int& v : op.vertices) {
      if (const auto it = name.find(v); it != name.end()) v = it->second;
    }
  }
  return script;
}

Script there_and_back_and_there(const Script& script, int next_vertex) {
  Script all = script;
  for (const ListedOperation& op : script) next_vertex += op.word == "split" ? 1 : 0;
  std::map<int, int> name;  // of vertices that went, as they came back
  for (auto op = script.rbegin(); op != script.rend(); ++op) {
    ListedOperation back = translated({inverse(*op, next_vertex)}, name)[0];
    if (op->word == "collapse") name[op->vertices[2]] = next_vertex++;
    all.push_back(back);
  }
  for (ListedOperation op : script) {
    if (op.word == "split") name[op.vertices[3]] = next_vertex++;
    all.push_back(translated({op}, name)[0]);
  }
  return all;
}

std::vector<ListedOperation> all_flips(const std::vector<Quad>& faces) {
  std::map<std::array<int, 2>, Quad> left;
  for (Quad f : faces) {
    for (int turn = 0; turn < 4; ++turn) {
      left[{f[0], f[1]}] = f;
      std::rotate(f.begin(), f.begin() + 1, f.end());
    }
  }
  std::vector<ListedOperation> flips;
  for (const auto& [edge, f] : left) {
    const auto across = left.find({edge[1], edge[0]});
    if (edge[0] > edge[1] || across == left.end()) continue;
    const Quad& g = across->second;
    flips.push_back({"flip", {edge[0], edge[1], g[2], f[2]}});
    flips.push_back({"flip", {edge[0], edge[1], g[3], f[3]}});
  }
  return flips;
}

std::set<int> irregular(const std::vector<Quad>& faces, int boundary) {
  std::map<int, int> valence;
  for (const Quad& f : faces) {
    for (const int v : f) ++valence[v];
  }
  std::set<int> result;
  for (const auto& [v, l] : valence) {
    if (v >= boundary && l != 4) result.insert(v);
  }
  return result;
}

bool flip_far_away(const ListedRegion& r, const ListedMesh& m, ListedOperation& flip) {
  const std::set<int> pair = irregular(m.faces, r.perimeter());
  for (const ListedOperation& op : all_flips(m.faces)) {
    const bool inside = std::all_of(op.vertices.begin(), op.vertices.end(), [&](int v) { return v >= r.perimeter(); });
    if (!inside || std::any_of(op.vertices.begin(), op.vertices.end(), [&](int v) { return pair.count(v) > 0; }))
      continue;
    flip = op;
    return true;
  }
  return false;
}

}  // namespace requad::tests
