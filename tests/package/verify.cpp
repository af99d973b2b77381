// A user of requad::verify: the table of claims.
#include <requad/verify/claims/claims.hpp>

int main() { return requad::verify::claims().empty() ? 1 : 0; }
