#include "mesh/element_map.hpp"

namespace requad::mesh {

namespace {

// `kept` by id before; the places of `live`.
template <class Id>
PlaceMap places(const std::vector<bool>& kept, const std::vector<Id>& live) {
  PlaceMap map;
  map.now.assign(kept.size(), -1);
  for (std::size_t place = 0; place < live.size(); ++place) {
    const std::size_t id = live[place].slot();
    if (id < kept.size() && kept[id]) {
      map.now[id] = static_cast<int>(place);
    } else {
      map.made.push_back(static_cast<int>(place));
    }
  }
  return map;
}

template <class Id>
std::vector<bool> marked(const std::vector<Id>& live, int capacity) {
  std::vector<bool> marks(static_cast<std::size_t>(capacity), false);
  for (const Id id : live) marks[id.slot()] = true;
  return marks;
}

template <class Id>
void remove(std::vector<bool>& kept, Id id) {
  if (id.valid() && id.slot() < kept.size()) kept[id.slot()] = false;
}

}  // namespace

ElementMap element_map(const QuadMesh& before, const Editor& editor) {
  std::vector<bool> vertices = marked(before.vertices(), before.vertex_capacity());
  std::vector<bool> faces = marked(before.faces(), before.face_capacity());
  for (const Edit& edit : editor.edits()) {
    remove(vertices, edit.removed_vertex());
    remove(faces, edit.removed_face());
  }
  return {places(vertices, editor.mesh().vertices()), places(faces, editor.mesh().faces())};
}

}  // namespace requad::mesh
