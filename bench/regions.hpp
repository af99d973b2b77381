// The regions that pairs are measured in.
#pragma once

#include "enumerate/generators.hpp"

namespace requad::bench {

// A pair that spans d x d quads, with as many strips of quads along every side: room for every step.
inline mesh::Region spread_pair(theory::PairType type, theory::Integer d, theory::Integer strips) {
  return enumerate::glue_region(type, {{d, d, theory::IntegerVector::Constant(type.side_count(), strips)}, 1});
}

}  // namespace requad::bench
