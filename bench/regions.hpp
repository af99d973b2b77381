// The regions in which pairs are measured.
#pragma once

#include "enumerate/generators.hpp"

namespace requad::bench {

// A region with a pair that spans d x d quads and with `strips` strips of quads along every side.
inline mesh::Region spread_pair(theory::PairType type, theory::Integer d, theory::Integer strips) {
  return enumerate::glue_region(type, {{d, d, theory::IntegerVector::Constant(type.side_count(), strips)}, 1});
}

}  // namespace requad::bench
