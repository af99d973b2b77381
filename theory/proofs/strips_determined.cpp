// T11: sides and (d1, d2) determine the strips; the points where the separatrices meet the sides determine all of these.
#include "theory/proofs/argument.hpp"
#include "theory/separatrix_vector.hpp"

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

// Which of d1 and d2 are not 0. A leg of length 0 has no separatrix of its own: the other one joins the two vertices and
// meets no side.
struct Extents {
  bool d1;
  bool d2;
  const char* text;
};

// The matrix of all that is known of a pair with these extents: the position of each separatrix that meets a side, and
// the lengths of the sides. Its columns are the unknown numbers: those of d1 and d2 that are not 0, then the strips.
RationalMatrix known_of(const CrossingLaw& crossings, const Extents& extents) {
  const SideLaw& law = crossings.law;
  const auto without_zeros = [&extents](RationalVector row) {
    if (!extents.d2) row.erase(row.begin() + 1);
    if (!extents.d1) row.erase(row.begin());
    return row;
  };
  RationalMatrix known;
  for (Eigen::Index row = 0; row < crossings.positions.rows(); ++row) {
    const Eigen::Index at = row < law.type.l1 ? row : row - law.type.l1;  // 0: first leg, 1: second leg
    if ((at == 0 && !extents.d1) || (at == 1 && !extents.d2)) continue;
    known.push_back(without_zeros(rational_vector(crossings.positions.row(row))));
  }
  const RationalMatrix strips = to_rational(law.strips);
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    RationalVector side = strips[i];
    side.insert(side.begin(), {Rational(law.first(row)), Rational(law.last(row))});
    known.push_back(without_zeros(std::move(side)));
  }
  return known;
}

// The positions and the sides determine d1, d2 and all strips.
void require_vector_gives_all(Argument& argue, const CrossingLaw& crossings) {
  for (const Extents& extents :
       {Extents{true, true, "d1, d2 >= 1"}, Extents{true, false, "d2 = 0"}, Extents{false, true, "d1 = 0"}}) {
    const RationalMatrix known = known_of(crossings, extents);
    const int unknown = crossings.law.type.side_count() + (extents.d1 ? 1 : 0) + (extents.d2 ? 1 : 0);
    const int found = rank(known);
    argue.require(found == unknown, crossings.law.type.name() + ", " + extents.text +
                                        ": the positions and the sides give a system of rank " + std::to_string(found) +
                                        " in " + std::to_string(unknown) +
                                        " unknown numbers, so they determine these.");
  }
}

}  // namespace

CrossingLaw crossing_law(PairType type) {
  // theory-5 is linear in d1, d2 and the strips: its matrix is read off at one labelling and at its neighbours.
  const int k = type.side_count();
  const auto positions = [&](const StripParameters& parameters) {
    const Configuration c{parameters, 1};
    const SeparatrixVector at = separatrix_vector(RegionShape(type, region_sides(type, c)), to_labelling(c));
    IntegerVector u(type.l1 + type.l2);
    for (int i = 0; i < type.l1; ++i) u(i) = at.at_v1[static_cast<std::size_t>(i)].distance;
    for (int i = 0; i < type.l2; ++i) u(type.l1 + i) = at.at_v2[static_cast<std::size_t>(i)].distance;
    return u;
  };
  const StripParameters base{2, 3, IntegerVector::Constant(k, 4)};
  CrossingLaw crossings{side_law(type), IntegerMatrix(type.l1 + type.l2, k + 2)};
  for (int unknown = 0; unknown < k + 2; ++unknown) {
    StripParameters next = base;
    ++(unknown == 0 ? next.d1 : unknown == 1 ? next.d2 : next.e(unknown - 2));
    crossings.positions.col(unknown) = positions(next) - positions(base);
  }
  return crossings;
}

Proof prove_strips_determined(const std::vector<CrossingLaw>& laws) {
  Proof proof{
      "T11",
      "all sides, d1, d2",
      "In a region with given sides, the points (S_ij, u_ij) where numbered separatrices meet the sides determine p, "
      "d1, "
      "d2 and all strips: they are the unique solution of a linear system. With the sides alone, (d1,d2) determine all "
      "strips of a 3-3 or 5-5 pair; of a 3-5 pair the sides determine (d1,d2), and with (e1,e2) the other strips.",
      {kSideLawPremise,
       "theory-5: where the separatrices of a pair with parameters p, d1, d2, e meet the sides. The separatrices of "
       "each "
       "vertex are numbered counter-clockwise from its first leg. (Instances: T11 reads each vector off the mesh.)"},
      {}};
  Argument argue(proof);
  argue.say(
      "The first outward separatrix of v1 meets side p, so S gives p. A leg that meets no side joins the vertices, so "
      "S "
      "tells which of d1 and d2 is 0. What remains is linear in d1, d2 and the strips.");
  for (const CrossingLaw& crossings : laws) {
    const SideLaw& law = crossings.law;
    require_vector_gives_all(argue, crossings);
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
