// A user of requad::enumerate: tau(5) = 4 (Theorem 7.2), counted by moves.
#include <requad/enumerate/exploration.hpp>

int main() {
  const auto shape = requad::theory::RegionShape::regular(requad::theory::kDigon, 5);
  return requad::enumerate::explore_all(shape, requad::theory::Apex::without).nodes.size() == 4 ? 0 : 1;
}
