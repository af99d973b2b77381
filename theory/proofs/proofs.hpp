// Proofs by exact arithmetic: claims that linear algebra decides for every size, beside the instances that
// requad-verify runs through.
//
// A proof starts from Law 1 (pair_system.hpp), which ties the strips e_i to the sides of a region; that Law 1 describes
// the meshes, and that every positive solution is realised by one, is what the paper's lemmas say and what the
// instances check. From there on each step is either an argument that a reader can follow, or an exact computation
// (exact.hpp) whose outcome decides whether the step holds.
//
// Law 5   every proof takes what it is about as premises: the system, and the formula that the paper states. The
//         defaults are the program's own (PairSystem, tau_from_half, face_formula), so that the proof is about what the
//         checks use; with any other premises a false statement must come out unproved.
//
// Cost: each takes milliseconds.
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
  bool computed = false;  // decided by a computation; else an argument
  bool holds = true;      // of a computed step
};

struct Proof {
  std::string claim;  // of the claims ledger
  std::string range;  // what it is proved for: "all L >= 1"
  std::string statement;
  std::vector<std::string> premises;  // what it takes from elsewhere
  std::vector<ProofStep> steps;

  // Every computed step holds, and there is one.
  bool proved() const;
  // Text of the first step that does not hold, "" if there is none.
  std::string failure() const;
};

// Law 1 as a proof takes it.
struct SideLaw {
  PairType type;
  IntegerMatrix strips;
  IntegerVector first;
  IntegerVector last;
};
SideLaw side_law(PairType type);

// T1: uniqueness for every valence that 4 does not divide, (L-1)^2 strips for every other in a regular region of side
// L.
struct SingleVertexPremises {
  std::function<IntegerMatrix(int)> matrix;  // of E_i = e_{i-1} + e_{i+1} for a valence
  Coefficients symbol{1, 0, 1};              // 1 + x^2: what the circulant is, times x, modulo x^l - 1
  Polynomial sharp_count;                    // in L
};
SingleVertexPremises single_vertex_premises();
Proof prove_single_vertex(const SingleVertexPremises& premises = single_vertex_premises());

// T11: sides and (d1, d2) determine the strips where 4 does not divide k; in a 3-5 region the sides determine (d1, d2),
// and (e1, e2) the other strips.
Proof prove_strips_determined(const std::vector<SideLaw>& laws = {side_law(kDigon), side_law(kHexagon),
                                                                  side_law(kQuad)});

// T2, T3: the parameter set and its size tau(L) for a regular region of every side.
struct RegularPremises {
  SideLaw law;
  // Which of d1, d2 must not be 0: (true, false) takes (d,0) and leaves its other labelling (0,d) away (Law 3).
  bool d1_positive = true;
  bool d2_positive = false;
  std::function<Polynomial(const Polynomial& n, bool even)> tau;  // stated, with n for floor(L/2)
};
RegularPremises regular_premises(PairType type);
Proof prove_regular_count(const RegularPremises& premises);

// T4: exactly M N configurations in every 3-5 region. The stated M and N are polynomials in E1, E2, E3, E4, d1, d2.
struct QuadPremises {
  SideLaw law;
  Polynomial m;
  Polynomial n;
};
QuadPremises quad_premises();
Proof prove_quad_count(const QuadPremises& premises = quad_premises());

// P3: the faces that each step (m,n) of the theorems makes, in any region with a pair of the paper's.
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

// N2: in a regular region of side L, d1 + d2 has the parity of L, and there is room for the merged vertex iff L is
// even.
Proof prove_merging_parity(const std::vector<SideLaw>& laws = {side_law(kDigon), side_law(kHexagon)});

// The proof that belongs to a claim of the ledger, with the default premises; nothing for the other claims.
std::optional<Proof> proof_of(const std::string& claim);

}  // namespace requad::theory
