#include "theory/proofs/proofs.hpp"

#include <algorithm>

namespace requad::theory {

bool Proof::proved() const {
  return failure().empty() && std::any_of(steps.begin(), steps.end(), [](const ProofStep& s) { return s.computed; });
}

std::string Proof::failure() const {
  const auto it = std::find_if(steps.begin(), steps.end(), [](const ProofStep& s) { return s.computed && !s.holds; });
  return it == steps.end() ? "" : it->text;
}

SideLaw side_law(PairType type) {
  const PairSystem system(type);
  return {type, system.strip_matrix(), system.first_offset(), system.last_offset()};
}

std::optional<Proof> proof_of(const std::string& claim) {
  if (claim == "T1") return prove_single_vertex();
  if (claim == "T2") return prove_regular_count(regular_premises(kDigon));
  if (claim == "T3") return prove_regular_count(regular_premises(kHexagon));
  if (claim == "T4") return prove_quad_count();
  if (claim == "T11") return prove_strips_determined();
  if (claim == "P3") return prove_face_change();
  if (claim == "N1") return prove_no_cancelling();
  if (claim == "N2") return prove_merging_parity();
  return std::nullopt;
}

}  // namespace requad::theory
