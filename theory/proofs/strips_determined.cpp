// T11: sides and (d1, d2) determine the strips.
#include "theory/proofs/argument.hpp"

namespace requad::theory {

namespace {

void require_strips_unique(Argument& argue, const SideLaw& law) {
  const int k = law.type.side_count();
  const int found = rank(to_rational(law.strips));
  argue.require(found == k, law.type.name() + ": the matrix of the strips has rank " + std::to_string(found) +
                                " of k = " + std::to_string(k) +
                                ", so E - d1 (firsts) - d2 (lasts) has one preimage, whatever the sizes.");
}

// The columns of d1 and d2 are independent of those of the strips.
void require_sides_give_d(Argument& argue, const SideLaw& law) {
  const RationalMatrix strips = to_rational(law.strips);
  RationalMatrix all = strips;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    all[i].insert(all[i].begin(), {Rational(law.first(row)), Rational(law.last(row))});
  }
  const int raised = rank(all) - rank(strips);
  argue.require(raised == 2,
                law.type.name() + ": the columns of d1 and d2 raise the rank of the system from " +
                    std::to_string(rank(strips)) + " by " + std::to_string(raised) +
                    ". No combination of them is a combination of strips, so equal sides have equal d1 and d2.");
}

// Two more rows, e1 and e2, make the matrix of the strips regular.
void require_two_strips_give_the_others(Argument& argue, const SideLaw& law) {
  const int k = law.type.side_count();
  RationalMatrix rows = to_rational(law.strips);
  const std::size_t columns = rows.size();
  for (std::size_t given = 0; given < 2; ++given) {
    rows.emplace_back(columns, 0);
    rows.back()[given] = 1;
  }
  const int found = rank(rows);
  argue.require(found == k, law.type.name() + ": with e1 and e2 given the rank is " + std::to_string(found) +
                                " of k = " + std::to_string(k) + ", so the other strips follow.");
}

}  // namespace

Proof prove_strips_determined(const std::vector<SideLaw>& laws) {
  Proof proof{
      "T11",
      "all sides, d1, d2",
      "The linear system has a unique solution. The sides and (d1,d2) determine all strips of a 3-3 or 5-5 pair. The "
      "sides alone determine (d1,d2) of a 3-5 pair, and together with (e1,e2) the other strips.",
      {kSideLawPremise,
       "The intersection points (S_ij, u_ij) determine the labelling p and d1, d2, e1, e2 (instances: T11)."},
      {}};
  Argument argue(proof);
  for (const SideLaw& law : laws) {
    if (law.type.side_count() % 4 != 0) {
      require_strips_unique(argue, law);
    } else {
      require_sides_give_d(argue, law);
      require_two_strips_give_the_others(argue, law);
    }
  }
  return proof;
}

}  // namespace requad::theory
