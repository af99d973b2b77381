// The proofs for all sizes that the claims name.
#include <algorithm>

#include "tests/support/catch.hpp"
#include "theory/proofs/proofs.hpp"
#include "verify/report.hpp"

using namespace requad;
using namespace requad::theory;

TEST_CASE("every proof goes through, with steps that compute", "[proofs]") {
  int proofs = 0;
  for (const verify::Claim& claim : verify::claims()) {
    const auto proof = proof_of(claim.id);
    if (!proof) continue;
    ++proofs;
    INFO(claim.id << ": " << proof->failure());
    CHECK(proof->claim == claim.id);
    CHECK(proof->proved());
    CHECK(!proof->statement.empty());
    CHECK(!proof->premises.empty());
    CHECK(std::count_if(proof->steps.begin(), proof->steps.end(), [](const ProofStep& s) { return s.computed; }) >= 2);
  }
  CHECK(proofs == 8);
  CHECK_FALSE(Proof{}.proved());
}
