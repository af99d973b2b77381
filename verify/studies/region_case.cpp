#include "verify/studies/region_case.hpp"

#include "theory/joined.hpp"

namespace requad::verify {

const char* name(Family family) {
  switch (family) {
    case Family::regular_digon: return "regular digons";
    case Family::regular_hexagon: return "regular hexagons";
    case Family::quad: return "3-5 regions";
    case Family::other_digon: return "non-regular digons";
    case Family::other_hexagon: return "non-regular hexagons";
    case Family::single_vertex: return "regions with one irregular vertex";
    case Family::three_vertices: return "regions with three irregular vertices";
  }
  return "";
}

namespace {

struct FamilyOf {
  Family operator()(const PairCase& pair) const {
    if (pair.shape.type() == theory::kQuad) return Family::quad;
    const bool digon = pair.shape.type() == theory::kDigon;
    if (pair.shape.is_regular()) return digon ? Family::regular_digon : Family::regular_hexagon;
    return digon ? Family::other_digon : Family::other_hexagon;
  }
  Family operator()(const VertexCase&) const { return Family::single_vertex; }
  Family operator()(const TripleCase&) const { return Family::three_vertices; }
};

struct SidesOf {
  const theory::IntegerVector& operator()(const PairCase& pair) const { return pair.shape.sides(); }
  const theory::IntegerVector& operator()(const VertexCase& vertex) const { return vertex.sides; }
  const theory::IntegerVector& operator()(const TripleCase& triple) const { return triple.sides; }
};

struct HeldBy {
  std::string operator()(const PairCase& pair) const { return pair.shape.type().name(); }
  std::string operator()(const VertexCase& vertex) const { return "v" + std::to_string(vertex.valence()); }
  std::string operator()(const TripleCase& triple) const { return theory::joined(triple.valences, "-"); }
};

}  // namespace

Family family_of(const RegionCase& region) { return std::visit(FamilyOf{}, region); }

const theory::IntegerVector& sides_of(const RegionCase& region) { return std::visit(SidesOf{}, region); }

std::string describe(const RegionCase& region) {
  return std::visit(HeldBy{}, region) + " region with sides " + theory::joined(sides_of(region), " ");
}

}  // namespace requad::verify
