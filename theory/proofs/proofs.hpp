// Proofs, by exact arithmetic, of those claims that linear algebra decides for every size. requad-verify shows them
// beside the instances that it checks one by one.
//
// A proof starts from the side law, theory-1 (pair_system.hpp), which ties the strips e_i to the sides of a region.
// That the side law describes the meshes, and that a mesh realises every positive solution, is what the paper's lemmas
// say and what the instances check. From there on each step is either an argument that a reader can follow, or an exact
// computation (exact.hpp) whose outcome decides whether the step holds.
//
// proofs-2   Every proof takes what it is about as premises: the system, and the formula that the paper states. The
//            defaults are the program's own (PairSystem, tau_from_half, face_formula), so the proof is about what the
//            checks use. With false premises a proof does not go through.
//
// Cost: each proof takes milliseconds.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "theory/pair_system.hpp"
#include "theory/proofs/exact.hpp"

namespace requad::theory {

struct ProofStep {
  std::string text;
  bool computed = false;  // true if a computation decides the step, false for an argument
  bool holds = true;      // the outcome of the computation; true for an argument
};

struct Proof {
  std::string claim;  // its id: "T2"
  std::string range;  // the sizes that it is for: "all L >= 1"
  std::string statement;
  std::vector<std::string> premises;  // what the proof takes from elsewhere
  std::vector<ProofStep> steps;

  // True if there is a computed step and every one holds.
  bool proved() const;
  // The text of the first step that does not hold, or "".
  std::string failure() const;
};

// The side law as a proof takes it: E = strips e + d1 first + d2 last.
struct SideLaw {
  PairType type;
  IntegerMatrix strips;
  IntegerVector first;
  IntegerVector last;
};
SideLaw side_law(PairType type);

// T1: the strips are unique for every valence that 4 does not divide. For the other valences a regular region of side L
// has (L-1)^2 systems of strips.
struct SingleVertexPremises {
  std::function<IntegerMatrix(int)> matrix;  // of E_i = e_{i-1} + e_{i+1}, by valence
  Coefficients symbol{1, 0, 1};              // 1 + x^2: what the circulant is, times x, modulo x^l - 1
  Polynomial sharp_count;                    // in L
};
SingleVertexPremises single_vertex_premises();
Proof prove_single_vertex(const SingleVertexPremises& premises = single_vertex_premises());

// theory-5 as a proof takes it: the positions u_ij = positions (d1, d2, e_1, ..., e_k), a row for each separatrix: of v1,
// then of v2, first leg, second leg, outward ones.
struct CrossingLaw {
  SideLaw law;
  IntegerMatrix positions;
};
CrossingLaw crossing_law(PairType type);

// T11: the sides and the vector of Theorem 7.11 determine p, d1, d2 and the strips. Where 4 does not divide k, the sides
// and (d1, d2) determine the strips. In a 3-5 region the sides determine (d1, d2), and with (e1, e2) the other strips.
Proof prove_strips_determined(const std::vector<CrossingLaw>& laws = {crossing_law(kDigon), crossing_law(kHexagon),
                                                                      crossing_law(kQuad)});

// T2, T3: the parameter set and its size tau(L) for a regular region of every side.
struct RegularPremises {
  SideLaw law;
  // Which of d1 and d2 must not be 0. (true, false) takes (d,0) and leaves out its other labelling (0,d) (theory-3).
  bool d1_positive = true;
  bool d2_positive = false;
  std::function<Polynomial(const Polynomial& n, bool even)> tau;  // as stated, with n for floor(L/2)
};
RegularPremises regular_premises(PairType type);
Proof prove_regular_count(const RegularPremises& premises);

// T4: exactly M N configurations in every 3-5 region. M and N are stated as polynomials in E1, E2, E3, E4, d1, d2.
struct QuadPremises {
  SideLaw law;
  Polynomial m;
  Polynomial n;
};
QuadPremises quad_premises();
Proof prove_quad_count(const QuadPremises& premises = quad_premises());

// P3: the number of faces that each step (m,n) of the theorems adds in a region with any of the paper's three pairs.
struct FacePremises {
  SideLaw law;
  std::function<Polynomial(const Polynomial& d1, const Polynomial& d2, const std::vector<Polynomial>& e)> faces;
  std::function<Polynomial(const Polynomial& d1, const Polynomial& d2, Integer m, Integer n)> stated;
};
FacePremises face_premises(PairType type);
Proof prove_face_change(const std::vector<FacePremises>& premises = {face_premises(kDigon), face_premises(kHexagon),
                                                                     face_premises(kQuad)});

// N1: a region with a 3-5 pair never has the sides of a regular grid.
Proof prove_no_cancelling(const SideLaw& law = side_law(kQuad));

// N2: in a regular region of side L, d1 + d2 has the parity of L, and there is room for the merged vertex exactly if L
// is even.
Proof prove_merging_parity(const std::vector<SideLaw>& laws = {side_law(kDigon), side_law(kHexagon)});

// The proof of the claim with this id, with the default premises. Returns nothing for a claim that has none.
std::optional<Proof> proof_of(const std::string& claim);

}  // namespace requad::theory
