#include "mesh/editing/affected_region.hpp"

#include <algorithm>

#include "mesh/topology/id_lists.hpp"

namespace requad::mesh {

AffectedRegion affected_region_since(const Editor& editor, BreadthFirstDistances& around, std::size_t mark, int rings) {
  const QuadMesh& m = editor.mesh();
  AffectedRegion result;
  std::vector<VertexId> ids;
  for (std::size_t i = mark; i < editor.mark(); ++i) {
    const Edit& edit = editor.edits()[i];
    if (!edit.operates) continue;
    for (const VertexId v : edit.changed) {
      if (v.valid()) ids.push_back(v);
    }
  }
  sort_once(ids);
  for (const VertexId v : ids) (m.is_live(v) ? result.changed : result.removed).push_back(v);
  const auto always = [](VertexId) { return true; };
  around.measure(m, result.changed, always, always, [rings](VertexId, int d) { return d >= rings; });
  result.near = around.met();
  const auto outer =
      std::find_if(result.near.begin(), result.near.end(), [&](VertexId v) { return around.distance(v) >= rings; });
  result.inner = static_cast<std::size_t>(outer - result.near.begin());
  return result;
}

}  // namespace requad::mesh
