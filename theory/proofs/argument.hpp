// What several proofs share: collecting the steps, quoting numbers in them, and the side law solved for the strips.
// Private to this room.
#pragma once

#include <string>
#include <vector>

#include "theory/proofs/exact.hpp"
#include "theory/proofs/proofs.hpp"

namespace requad::theory {

// Premises that several proofs take from elsewhere.
extern const char* const kSideLawPremise;
extern const char* const kEhrhartPremise;

// Appends steps to a proof, which must outlive it.
class Argument {
 public:
  explicit Argument(Proof& proof) : proof_(proof) {}
  // Appends an argument, for a reader to follow.
  void say(std::string text) { proof_.steps.push_back({std::move(text), false, true}); }
  // Appends a computed step and returns `holds`, its outcome.
  bool require(bool holds, std::string text) {
    proof_.steps.push_back({std::move(text), true, holds});
    return holds;
  }

 private:
  Proof& proof_;
};

RationalVector rational_vector(const IntegerVector& v);
// Precondition: both have the same length.
Rational dot(const RationalVector& a, const IntegerVector& b);
// "(1/2,-3,0)".
std::string list(const RationalVector& v);

// length L + d1 d1 + d2 d2 with three coefficients. In a regular region of side L every strip has this form.
struct StripForm {
  Rational length, d1, d2;
  Polynomial polynomial() const;  // in (L, d1, d2)
  std::string text() const { return polynomial().text({"L", "d1", "d2"}); }
};

// The strips e_1, e_2, ... of a regular region. Throws std::domain_error where they are not unique.
std::vector<StripForm> strip_forms(const SideLaw& law);
// "e1 = 1/2 L - 1/2 d1, e2 = ...".
std::string text(const std::vector<StripForm>& forms);
// True if every coefficient of every form is half an odd integer. All strips are then integers exactly if L + d1 + d2
// is even.
bool parity_decides(const std::vector<StripForm>& forms);

// Requires theory-3 for all sizes: the two labellings of a segment have the same sides.
void require_segments_agree(Argument& argue, PairType type);

}  // namespace requad::theory
