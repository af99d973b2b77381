// A user of the installed package: tau(5) = 4 (Theorem 7.2), counted by moves.
#include "enumerate/exploration.hpp"
#include "theory/counts.hpp"

int main() {
  const auto shape = requad::theory::RegionShape::regular(requad::theory::kDigon, 5);
  const auto found = requad::enumerate::explore_all(shape, requad::theory::Apex::without);
  return found.nodes.size() == 4 && requad::theory::tau_digon(5) == 4 ? 0 : 1;
}
