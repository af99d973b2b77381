// A user of requad::theory: tau(5) = 4 (Theorem 7.2).
#include <requad/theory/counts.hpp>

int main() { return requad::theory::tau_digon(5) == 4 ? 0 : 1; }
