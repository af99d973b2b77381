// The proofs for all sizes that the claims name. Each proof holds, and a proof that fails makes its claim fail.
#include <algorithm>

#include "tests/support/catch.hpp"
#include "theory/proofs/proofs.hpp"
#include "verify/report/html.hpp"
#include "verify/report/report.hpp"

using namespace requad;
using namespace requad::theory;

TEST_CASE("every proof holds, with computed steps", "[proofs]") {
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

TEST_CASE("a proof that fails makes its claim fail, in every report", "[proofs]") {
  using namespace requad::verify;
  const Claim& t2 = *std::find_if(claims().begin(), claims().end(), [](const Claim& c) { return c.id == "T2"; });
  Ranges ranges;
  ranges.digon = {3, 4};
  ranges.other_perimeter = {4, 6};
  CampaignResult result =
      run_campaign({&t2}, list_cases(ranges, t2.families), {Method::moves}, {.threads = 1, .quiet = true});
  REQUIRE(result.passed());
  const auto good = report_json(result, ranges)["claims"][0]["proof"];
  CHECK(good["proved"] == true);
  CHECK(good["for"] == "all L >= 1");
  CHECK(good["steps"].size() > 5);
  CHECK(report_text(result, ranges).find("T2     all L >= 1") != std::string::npos);
  CHECK(report_html(result, ranges).find("Proved</span> for all L &gt;= 1") != std::string::npos);

  RegularPremises wrong = regular_premises(kDigon);
  wrong.tau = [](const Polynomial& n, bool) { return n * n; };
  attach_proof(result.claims[0], prove_regular_count(wrong));
  CHECK_FALSE(result.passed());
  CHECK(report_json(result, ranges)["claims"][0]["verdict"] == "fails");
  CHECK(report_json(result, ranges)["claims"][0]["proof"]["proved"] == false);
  CHECK(report_text(result, ranges).find("T2 fails: the proof for all L >= 1 fails: L = 0 mod 2") != std::string::npos);
  CHECK(report_html(result, ranges).find("Not proved</span>") != std::string::npos);

  // A proof without a computed step does not count.
  ClaimResult empty;
  attach_proof(empty, Proof{});
  CHECK(empty.violation.has_value());
  ClaimResult none;
  attach_proof(none, std::nullopt);
  CHECK_FALSE(none.violation.has_value());
}
