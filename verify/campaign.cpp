#include "verify/campaign.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mesh/program/errors.hpp"
#include "mesh/program/progress.hpp"
#include "mesh/threads/threads.hpp"
#include "verify/claims/judging.hpp"

namespace requad::verify {

namespace {

using theory::Integer;
using theory::IntegerVector;

// Calls visit(sides) for every sequence of k positive integers with this sum that is the least of its rotations.
template <class Visit>
void for_each_necklace(int k, Integer sum, Visit&& visit) {
  std::vector<Integer> sides(static_cast<std::size_t>(k), 1);
  const auto least_rotation = [&] {
    for (int shift = 1; shift < k; ++shift) {
      std::vector<Integer> rotated(sides.begin() + shift, sides.end());
      rotated.insert(rotated.end(), sides.begin(), sides.begin() + shift);
      if (rotated < sides) return false;
    }
    return true;
  };
  const auto fill = [&](auto&& self, std::size_t at, Integer left) -> void {
    if (at + 1 == sides.size()) {
      sides[at] = left;
      if (least_rotation()) visit(sides);
      return;
    }
    for (Integer x = sides.front(); left - x >= static_cast<Integer>(sides.size() - at) - 1; ++x) {
      sides[at] = x;
      self(self, at + 1, left - x);
    }
  };
  // The first entry is the least, so the others need not go below it.
  for (Integer first = 1; first * k <= sum; ++first) {
    sides[0] = first;
    if (k == 1) {
      if (first == sum) visit(sides);
    } else {
      fill(fill, 1, sum - first);
    }
  }
}

}  // namespace

CaseList list_cases(const Ranges& ranges, const std::set<Family>& families) {
  CaseList list;
  const auto add = [&](Family family, theory::PairType type, const IntegerVector& sides) {
    const theory::RegionShape shape(type, sides);
    // Empty only if both the closed form and the parameter set say so; if they differ, the claim will.
    if (theory::exact_count(shape) == 0 && theory::parameter_set(shape).empty()) {
      ++list.empty[family];
    } else {
      list.cases.push_back({family, type, sides});
    }
  };
  const auto regular = [&](Family family, theory::PairType type, program::Range lengths) {
    if (families.count(family) == 0) return;
    for (Integer length = lengths.first; length <= lengths.last; ++length) {
      add(family, type, IntegerVector::Constant(type.side_count(), length));
    }
  };
  const auto by_perimeter = [&](Family family, theory::PairType type, program::Range perimeters, bool with_regular) {
    if (families.count(family) == 0) return;
    for (Integer perimeter = perimeters.first; perimeter <= perimeters.last; ++perimeter) {
      if (perimeter % 2 != 0) continue;
      for_each_necklace(type.side_count(), perimeter, [&](const std::vector<Integer>& sides) {
        const bool equal = std::all_of(sides.begin(), sides.end(), [&](Integer x) { return x == sides[0]; });
        if (with_regular || !equal) add(family, type, theory::to_vector(sides));
      });
    }
  };
  regular(Family::regular_digon, theory::kDigon, ranges.digon);
  regular(Family::regular_hexagon, theory::kHexagon, ranges.hexagon);
  by_perimeter(Family::quad, theory::kQuad, ranges.quad_perimeter, true);
  by_perimeter(Family::other_digon, theory::kDigon, ranges.other_perimeter, false);
  by_perimeter(Family::other_hexagon, theory::kHexagon, ranges.other_perimeter, false);
  if (families.count(Family::single_vertex) > 0) {
    for (int valence = 2; valence <= 12; ++valence) {
      const theory::PairType type = valence == 2 ? theory::kDigon : theory::PairType{valence + 1, 3};
      for (const Integer length : {2, 3, 4, 6, 8})
        list.cases.push_back({Family::single_vertex, type, IntegerVector::Constant(valence, length)});
      if (valence == 4 || valence > 9) continue;
      for (Integer perimeter = ranges.other_perimeter.first;
           perimeter <= std::min<Integer>(ranges.other_perimeter.last, 20); ++perimeter) {
        if (perimeter < valence) continue;
        for_each_necklace(valence, perimeter, [&](const std::vector<Integer>& sides) {
          list.cases.push_back({Family::single_vertex, type, theory::to_vector(sides)});
        });
      }
    }
  }
  if (families.count(Family::three_vertices) > 0) {
    // Valences, and the largest perimeter: the number of fillings grows with its fourth power and more.
    const std::vector<std::pair<std::vector<int>, Integer>> kinds{
        {{3, 3, 3}, 20}, {{3, 3, 5}, 20}, {{3, 5, 5}, 18}, {{5, 5, 5}, 22}};
    for (const auto& [valences, largest] : kinds) {
      const int k = valences[0] + valences[1] + valences[2] - 8;
      for (Integer perimeter = ranges.other_perimeter.first;
           perimeter <= std::min(ranges.other_perimeter.last, largest); ++perimeter) {
        if (perimeter < k || perimeter % 2 != 0) continue;
        for_each_necklace(k, perimeter, [&, valences = valences](const std::vector<Integer>& sides) {
          list.cases.push_back(
              {Family::three_vertices, theory::PairType{k + 1, 3}, theory::to_vector(sides), valences});
        });
      }
    }
  }
  return list;
}

bool CampaignResult::passed() const {
  return std::all_of(claims.begin(), claims.end(),
                     [](const ClaimResult& c) { return !c.violation && c.instances > 0; });
}

void attach_proof(ClaimResult& result, std::optional<theory::Proof> proof) {
  if (proof && !proof->proved() && !result.violation) {
    const std::string step = proof->failure();
    result.violation =
        Violation{"the proof for " + proof->range + " fails: " + (step.empty() ? "it computes nothing" : step), "", "",
                  std::nullopt};
  }
  result.proof = std::move(proof);
}

namespace {

// A guess at the relative cost: the costly ones first, so that no thread or process is left with one at the end.
double weight(const RegionCase& region) {
  const auto length = static_cast<double>(region.sides.sum());
  switch (region.family) {
    case Family::single_vertex: return length * length;
    case Family::three_vertices: return 10 * std::pow(length, 5);
    default: return std::pow(length, 4) * static_cast<double>(region.type.rotation_count());
  }
}

}  // namespace

std::string campaign_name(const std::string& version, const std::vector<const Claim*>& selected, const Ranges& ranges,
                          const std::set<Method>& methods) {
  std::string name = "requad-verify " + version + " claims";
  std::set<Family> families;
  for (const Claim* claim : selected) {
    name += " " + claim->id;
    families.insert(claim->families.begin(), claim->families.end());
  }
  const auto span = [&name](const char* what, program::Range r) {
    name += std::string("; ") + what + " " + std::to_string(r.first) + ".." + std::to_string(r.last);
  };
  span("digon", ranges.digon);
  span("hexagon", ranges.hexagon);
  span("quad-perimeter", ranges.quad_perimeter);
  span("other-perimeter", ranges.other_perimeter);
  name += "; methods";
  for (const Method method : methods) name += std::string(" ") + verify::name(method);
  return name;
}

CampaignResult run_campaign(const std::vector<const Claim*>& selected, const CaseList& list,
                            const std::set<Method>& methods, const Running& running) {
  std::vector<CaseResult> results(list.cases.size());
  std::vector<bool> known(list.cases.size(), false);
  // Walks alone can take long for one region: their configurations are what is counted then.
  const bool walks_alone = methods == std::set<Method>{Method::walk} && !running.distribute;
  const auto steps = [&](std::size_t i) {
    const RegionCase& c = list.cases[i];
    const bool pair = c.family != Family::single_vertex && c.family != Family::three_vertices;
    return !walks_alone ? std::int64_t{1} : pair ? theory::exact_count({c.type, c.sides}) : std::int64_t{0};
  };
  std::int64_t all_steps = 0;
  for (std::size_t i = 0; i < list.cases.size(); ++i) all_steps += steps(i);
  program::Progress progress(walks_alone ? "configurations" : "regions", all_steps, running.quiet);

  if (running.journal != nullptr) {
    for (auto& [i, result] : running.journal->results()) {
      results[i] = std::move(result);
      known[i] = true;
      progress.advance(steps(i));
    }
    running.journal->results().clear();
  }
  std::vector<std::size_t> todo;
  for (std::size_t i = 0; i < list.cases.size(); ++i) {
    if (!known[i]) todo.push_back(i);
  }
  std::stable_sort(todo.begin(), todo.end(),
                   [&](std::size_t a, std::size_t b) { return weight(list.cases[a]) > weight(list.cases[b]); });
  const Done done = [&](std::size_t i, CaseResult result) {
    if (running.journal != nullptr) running.journal->append(i, result);
    results[i] = std::move(result);
    if (!walks_alone) progress.advance();
  };
  const auto walked = [&](std::int64_t configurations) { progress.advance(configurations); };
  const auto run = [&](std::size_t i) {
    return run_case(list.cases[i], selected, methods,
                    walks_alone ? enumerate::WalkProgress(walked) : enumerate::WalkProgress());
  };
  if (running.distribute) {
    running.distribute(todo, done);
  } else {
    threads::run_on_threads(todo.size(), running.threads, [&](std::size_t i) { done(todo[i], run(todo[i])); });
  }
  progress.finish();

  CampaignResult campaign;
  campaign.empty = list.empty;
  for (const CaseResult& r : results) campaign.study_seconds += r.study_seconds;
  for (std::size_t c = 0; c < selected.size(); ++c) {
    ClaimResult total;
    total.claim = selected[c];
    std::set_intersection(methods.begin(), methods.end(), total.claim->methods.begin(), total.claim->methods.end(),
                          std::inserter(total.methods, total.methods.begin()));
    for (std::size_t i = 0; i < results.size(); ++i) {
      Judgement& j = results[i].judgements[c];
      total.seconds += results[i].seconds[c];
      if (!j.applies) continue;
      ++total.instances;
      FamilyTotal& family = total.totals[list.cases[i].family];
      ++family.regions;
      family.checks += j.checks;
      if (!j.row.is_null()) total.table.push_back(std::move(j.row));
      if (j.violation && !total.violation) {
        total.violation = std::move(j.violation);
        total.violating_region = list.cases[i];
      }
    }
    try {
      attach_proof(total, theory::proof_of(total.claim->id));
    } catch (const std::exception& error) {
      if (program::is_exhaustion(error)) throw;
      total.violation =
          Violation{std::string("the proof for all sizes breaks off: ") + error.what(), "", "", std::nullopt};
    }
    campaign.claims.push_back(std::move(total));
  }
  return campaign;
}

}  // namespace requad::verify
