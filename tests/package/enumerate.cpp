// A user of requad::enumerate: tau(5) = 4 (Theorem 7.2), counted by moves.
#include <requad/enumerate/exploration.hpp>

int main() {
  const auto found = requad::enumerate::explore_all(
      requad::theory::kDigon, requad::theory::IntegerVector::Constant(2, 5), requad::theory::Apex::without);
  return found.nodes.size() == 4 ? 0 : 1;
}
