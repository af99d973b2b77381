// Handles of mesh elements. Each wraps an index into the mesh's arrays. The three types do not compare with each other.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace requad::mesh {

template <class Tag>
class Handle {
 public:
  // A default handle names no element.
  constexpr Handle() = default;
  constexpr explicit Handle(std::int32_t index) : index_(index) {}

  // Position in the mesh's arrays; -1 for none.
  constexpr std::int32_t index() const { return index_; }
  constexpr std::size_t slot() const { return static_cast<std::size_t>(index_); }
  constexpr bool valid() const { return index_ >= 0; }

  friend constexpr auto operator<=>(const Handle&, const Handle&) = default;

 private:
  std::int32_t index_ = -1;
};

using VertexId = Handle<struct VertexTag>;
using HalfEdgeId = Handle<struct HalfEdgeTag>;
using FaceId = Handle<struct FaceTag>;

}  // namespace requad::mesh

template <class Tag>
struct std::hash<requad::mesh::Handle<Tag>> {
  std::size_t operator()(const requad::mesh::Handle<Tag>& handle) const noexcept {
    return std::hash<std::int32_t>{}(handle.index());
  }
};
