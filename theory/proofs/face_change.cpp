// P3: the number of quads that a step makes.
#include "theory/configuration_graph.hpp"
#include "theory/proofs/argument.hpp"

namespace requad::theory {

FacePremises face_premises(PairType type) {
  FacePremises premises{side_law(type),
                        [type](const Polynomial& d1, const Polynomial& d2, const std::vector<Polynomial>& e) {
                          return PairSystem(type).face_formula(d1, d2, e);
                        },
                        {}};
  if (type.symmetric()) {
    // Half the growth of d1^2 + d2^2, which a 5-5 region gains with the distance of its pair and a 3-3 region loses.
    const int sign = type == kDigon ? -1 : 1;
    premises.stated = [sign](const Polynomial& d1, const Polynomial& d2, Integer m, Integer n) {
      return sign * (m * d1 + n * d2 + 1);
    };
  } else {
    premises.stated = [](const Polynomial& d1, const Polynomial& d2, Integer m, Integer n) {
      return m * (d1 - d2) - n * (d1 + d2);
    };
  }
  return premises;
}

namespace {

// What a step (m, n) does to the parameters while the sides stay as they are.
struct Change {
  GridPoint d;            // added to (d1, d2)
  RationalVector strips;  // added to (e_1, .., e_k)
  bool keeps_sides = true;
  std::string what;  // "(d1,d2) + (1,1)"
};

// With equal valences (m, n) is added to (d1, d2), and the side law fixes the change of the strips.
Change symmetric_change(const SideLaw& law, GridPoint step) {
  const IntegerVector rest = -step.m * law.first - step.n * law.last;
  Change change;
  change.d = step;
  change.strips = inverse(to_rational(law.strips)) * rational_vector(rest);
  change.what = "(d1,d2) + (" + std::to_string(step.m) + "," + std::to_string(step.n) + ")";
  return change;
}

// With a 3-5 pair (m, n) is added to (e1, e2) and taken from (e3, e4), which must be in the kernel of the side law.
Change quad_change(const SideLaw& law, GridPoint step) {
  Change change;
  change.strips = {step.m, step.n, -step.m, -step.n};
  change.what = "(e1,e2) + (" + std::to_string(step.m) + "," + std::to_string(step.n) + ")";
  for (const Rational& side : to_rational(law.strips) * change.strips) {
    change.keeps_sides = change.keeps_sides && side == 0;
  }
  return change;
}

void require_step(Argument& argue, const FacePremises& about, GridPoint step) {
  const SideLaw& law = about.law;
  const Change change = law.type.symmetric() ? symmetric_change(law, step) : quad_change(law, step);
  const Polynomial d1 = Polynomial::variable(0);
  const Polynomial d2 = Polynomial::variable(1);
  std::vector<std::string> names{"d1", "d2"};
  std::vector<Polynomial> before, after;  // the strips
  bool integral = true;
  for (std::size_t i = 0; i < change.strips.size(); ++i) {
    names.push_back("e" + std::to_string(i + 1));
    before.push_back(Polynomial::variable(i + 2));
    after.push_back(before.back() + change.strips[i]);
    integral = integral && change.strips[i].is_integer();
  }
  const Polynomial grown = about.faces(d1 + change.d.m, d2 + change.d.n, after) - about.faces(d1, d2, before);
  const Polynomial stated = about.stated(d1, d2, step.m, step.n);
  argue.require(change.keeps_sides && integral && grown == stated,
                law.type.name() + ", " + change.what + ": the strips change by " + list(change.strips) +
                    ", the number of quads by " + grown.text(names) + "; stated is " + stated.text(names) + ".");
}

}  // namespace

Proof prove_face_change(const std::vector<FacePremises>& premises) {
  Proof proof{"P3",
              "all d1, d2, e_i",
              "A step (m,n) changes the number of quads by m d1 + n d2 + 1 for a 5-5 pair, by minus that for a 3-3 "
              "pair, and by m (d1 - d2) - n (d1 + d2) for a 3-5 pair: by the length d1 + d2 of the connecting path, or "
              "the difference of its legs.",
              {kSideLawPremise,
               "The number of quads is d1 d2 + the sum of e_i e_{i+1} + d1 (e of the firsts) + d2 (e of the lasts) "
               "(instances: P3)."},
              {}};
  Argument argue(proof);
  for (const FacePremises& about : premises) {
    for (int step = 0; step < kStepCount; ++step) require_step(argue, about, step_offset(about.law.type, step));
  }
  return proof;
}

}  // namespace requad::theory
