// plan() of transport.hpp as an inline function, for pair moves, which make nothing but steps.
#pragma once

#include "mesh/irregular/transport.hpp"

namespace requad::mesh {

inline PlannedStep planned_step(const QuadMesh& m, AdjacentPair pair, TransportStep step, int turn) {
  const bool left = step.hand == Hand::left;
  const HalfEdgeId forth = pair.forth(m);  // u -> v, used by the left hand
  const HalfEdgeId back = pair.back(m);    // v -> u, used by the right hand
  PlannedStep result;
  switch (step.kind) {
    case TransportStep::Kind::collapse: {
      const HalfEdgeId keep = left ? forth : QuadMesh::next(back);        // u -> v or u -> d
      const HalfEdgeId from_d = left ? QuadMesh::previous(forth) : keep;  // d -> u or u -> d
      const HalfEdgeId d_c = QuadMesh::opposite(left ? forth : back);     // c -> d or d -> c
      result.operation = {BasicOperation::Kind::collapse, keep, {}, 0};
      result.at_u = left ? from_d : d_c;
      result.at_v = left ? d_c : QuadMesh::previous(back);
      result.first = d_c;
      result.next = {m.twin(d_c), !left};
      result.beside = {m.twin(from_d), left};
      break;
    }
    case TransportStep::Kind::flip: {
      const HalfEdgeId edge = left ? QuadMesh::next(forth) : QuadMesh::previous(back);  // v -> c or c -> v
      const HalfEdgeId across = m.twin(edge);
      result.operation = {left ? BasicOperation::Kind::flip_cw : BasicOperation::Kind::flip_ccw, edge, {}, 0};
      result.at_u = left ? QuadMesh::opposite(forth) : edge;
      if (across.valid()) result.at_v = left ? QuadMesh::previous(across) : QuadMesh::opposite(across);
      result.next = {edge, left};
      break;
    }
    case TransportStep::Kind::split: {
      // v -> z on the left, z -> v on the right: the sector from u to z lies beside it.
      HalfEdgeId z = left ? QuadMesh::next(forth) : QuadMesh::previous(back);
      for (int k = 1; k < turn && z.valid(); ++k) {
        z = m.twin(z);
        if (z.valid()) z = left ? QuadMesh::next(z) : QuadMesh::previous(z);
      }
      result.next = {z, !left};
      if (!z.valid()) break;
      result.operation = left ? BasicOperation{BasicOperation::Kind::split, z, forth, 0}
                              : BasicOperation{BasicOperation::Kind::split, back, z, 0};
      result.at_v = left ? QuadMesh::next(z) : z;
      break;
    }
  }
  if (result.at_u.valid()) result.next_u = m.origin(result.at_u);
  if (result.at_v.valid()) result.next_v = m.origin(result.at_v);
  return result;
}

}  // namespace requad::mesh
