// The claims as one table, and how one region is judged by them.
#include "verify/claims/claims.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include <boost/algorithm/string/predicate.hpp>

#include "mesh/program/run/errors.hpp"
#include "verify/claims/judging.hpp"
#include "verify/claims/table.hpp"

namespace requad::verify {

Violation at_node(const PairStudy& s, std::size_t node, std::string what) {
  const enumerate::FoundNode& n = s.found.nodes[node];
  return {std::move(what), n.reading.problem.empty() ? theory::label(s.shape.type(), n.reading.configuration) : "", "",
          n.region};
}

Violation at_move(const PairStudy& s, const enumerate::FoundMove& move, std::string what) {
  Violation v = at_node(s, static_cast<std::size_t>(move.from), std::move(what));
  v.move = mesh::name(move.move.step);
  return v;
}

Violation at_region(const PairStudy& s, std::string what) {
  Violation v{std::move(what), "", "", std::nullopt};
  if (!s.found.nodes.empty()) v.mesh = s.found.nodes[0].region;
  return v;
}

Violation at_region(const VertexStudy& s, std::string what) {
  Violation v{std::move(what), "", "", std::nullopt};
  if (!s.glued.empty()) v.mesh = s.glued[0];
  return v;
}

std::string described(const Violation& violation) {
  std::string at;
  if (!violation.configuration.empty()) at += "configuration " + violation.configuration;
  if (!violation.move.empty()) at += (at.empty() ? "" : ", ") + ("move " + violation.move);
  return (at.empty() ? "" : at + ": ") + violation.what;
}

namespace {

template <class Kind>
Judgement judged(Judgement (*check)(const Kind&), const Study& study) {
  if constexpr (std::is_same_v<Kind, Study>) {
    return check(study);
  } else {
    const Kind* const one = std::get_if<Kind>(&study);
    return one != nullptr ? check(*one) : not_applicable();
  }
}

}  // namespace

Judgement Claim::judge(const Study& study) const {
  if (families.count(family_of(study)) == 0) return not_applicable();
  return std::visit([&study](const auto known) { return judged(known, study); }, check);
}

Judgement Claim::judge_safely(const Study& study) const {
  try {
    return judge(study);
  } catch (const std::exception& error) {
    if (program::is_exhaustion(error)) throw;
    return broken_off(error);
  }
}

const Claim* find_claim(const std::string& id) {
  const auto it = std::find_if(claims().begin(), claims().end(),
                               [&id](const Claim& c) { return boost::algorithm::iequals(c.id, id); });
  return it == claims().end() ? nullptr : &*it;
}

std::vector<RegionVerdict> judge_region(const Study& study, const std::vector<std::string>& ids) {
  std::vector<RegionVerdict> verdicts;
  for (const std::string& id : ids) {
    const Claim* const claim = find_claim(id);
    if (Judgement j = claim->judge_safely(study); j.applies) verdicts.push_back({claim, std::move(j)});
  }
  return verdicts;
}

const std::vector<Claim>& claims() {
  static const std::vector<Claim> kClaims = [] {
    std::vector<Claim> all = operation_claims();
    for (Claim& claim : region_claims()) all.push_back(std::move(claim));
    return all;
  }();
  return kClaims;
}

}  // namespace requad::verify
