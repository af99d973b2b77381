// The parts of the table of claims. Private to this folder; claims() joins them in this order.
#pragma once

#include <vector>

#include "verify/claims/claims.hpp"

namespace requad::verify {

std::vector<Claim> operation_claims();  // sections 2, 4, 5, 6
std::vector<Claim> region_claims();     // sections 1, 7, 8

}  // namespace requad::verify
