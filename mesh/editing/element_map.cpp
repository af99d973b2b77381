#include "mesh/editing/element_map.hpp"

namespace requad::mesh {

namespace {

// The vertices, or the faces, that exist, and the elements from before the edits that they descend from.
class Ancestry {
 public:
  template <class Id>
  Ancestry(const std::vector<Id>& live, int capacity)
      : ancestor_(static_cast<std::size_t>(capacity), -1), is_old_(ancestor_.size(), false) {
    for (const Id id : live) {
      ancestor_[id.slot()] = id.index();
      is_old_[id.slot()] = true;
    }
  }

  template <class Id>
  void remove(Id id) {
    if (id.valid()) is_old_[id.slot()] = false;
  }
  template <class Id>
  void make(Id id, Id from) {
    if (!id.valid()) return;
    if (id.slot() >= ancestor_.size()) {
      ancestor_.resize(id.slot() + 1, -1);
      is_old_.resize(id.slot() + 1, false);
    }
    ancestor_[id.slot()] = ancestor_[from.slot()];
  }

  template <class Id>
  FileIndexMap file_indices(int capacity_before, const std::vector<Id>& live) const {
    FileIndexMap map;
    map.now.assign(static_cast<std::size_t>(capacity_before), -1);
    for (std::size_t index = 0; index < live.size(); ++index) {
      const std::size_t id = live[index].slot();
      if (is_old_[id]) {
        map.now[id] = static_cast<int>(index);
      } else {
        map.made.push_back(static_cast<int>(index));
        map.made_from.push_back(ancestor_[id]);
      }
    }
    return map;
  }

 private:
  std::vector<int> ancestor_;  // by id: the ancestor's id before the edits; -1 if there never was such an element
  std::vector<bool> is_old_;   // by id: whether the element was there before the edits
};

}  // namespace

int file_number(const QuadMesh& mesh, VertexId v) {
  int number = 1;
  for (int i = 0; i < v.index(); ++i) number += mesh.is_live(VertexId(i)) ? 1 : 0;
  return number;
}

ElementMap element_map(const QuadMesh& before, const Editor& editor) {
  Ancestry vertices(before.vertices(), before.vertex_capacity());
  Ancestry faces(before.faces(), before.face_capacity());
  for (const Edit& edit : editor.edits()) {
    vertices.remove(edit.removed_vertex());
    faces.remove(edit.removed_face());
    vertices.make(edit.made_vertex(), edit.changed[0]);
    faces.make(edit.made_face(), QuadMesh::face(edit.operation.h));
  }
  return {vertices.file_indices(before.vertex_capacity(), editor.mesh().vertices()),
          faces.file_indices(before.face_capacity(), editor.mesh().faces())};
}

}  // namespace requad::mesh
