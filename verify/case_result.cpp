#include "verify/case_result.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "mesh/program/run/errors.hpp"
#include "mesh/program/run/journal_file.hpp"
#include "verify/claims/judging.hpp"

namespace requad::verify {

using nlohmann::ordered_json;
using program::integer_from;

CaseResult run_case(const RegionCase& region, const std::vector<const Claim*>& selected,
                    const std::set<Method>& methods, const enumerate::WalkProgress& progress) {
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  CaseResult result;
  const auto start = Clock::now();
  try {
    const Study s = study(region, methods, progress);
    result.study_seconds = since(start);
    result.method_seconds = seconds_of(s);
    result.fillings = fillings_searched(s);
    for (std::size_t i = 0; i < selected.size(); ++i) {
      const auto judging = Clock::now();
      Judgement j = selected[i]->judge_safely(s);
      if (j.applies) result.judgements.push_back({i, std::move(j), since(judging)});
    }
  } catch (const std::exception& error) {
    if (program::is_exhaustion(error)) throw;
    result.judgements.clear();
    for (std::size_t i = 0; i < selected.size(); ++i) result.judgements.push_back({i, broken_off(error), 0});
  }
  return result;
}

namespace {

// The mesh without gaps in its ids. No report and no file shows these gaps.
ordered_json region_json(const mesh::Region& region) {
  const auto faces = region.mesh.faces();
  std::size_t root = 0;
  while (faces[root] != mesh::QuadMesh::face(region.root)) ++root;
  return {{"vertices", region.mesh.vertex_count()},
          {"root", 4 * root + static_cast<std::size_t>(region.root.index() & 3)},
          {"faces", region.mesh.compact_faces()}};
}

constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

mesh::Region region_from(const ordered_json& json) {
  std::vector<std::array<int, 4>> faces;
  const auto corners = static_cast<std::int64_t>(4 * json.at("faces").size());
  for (const ordered_json& face : json["faces"]) {
    if (face.size() != 4) throw std::invalid_argument("a face has " + std::to_string(face.size()) + " corners");
    std::array<int, 4>& quad = faces.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) quad[k] = static_cast<int>(integer_from(face.at(k), 0, corners));
  }
  // Each vertex has a face.
  return {mesh::QuadMesh::from_faces(static_cast<int>(integer_from(json.at("vertices"), 0, corners)), faces),
          mesh::HalfEdgeId(static_cast<std::int32_t>(integer_from(json.at("root"), 0, corners - 1)))};
}

}  // namespace

// What was predicted and found is reported of a violation only.
ordered_json to_json(const CaseResult& result) {
  ordered_json json{{"study_seconds", result.study_seconds}};
  for (const auto& [method, seconds] : result.method_seconds) json["methods"][name(method)]["seconds"] = seconds;
  if (result.fillings) json["fillings"] = *result.fillings;
  json["claims"] = ordered_json::array();
  for (const ClaimJudgement& judged : result.judgements) {
    const Judgement& j = judged.judgement;
    ordered_json entry{{"claim", judged.claim}, {"seconds", judged.seconds}, {"checks", j.checks}};
    if (!j.row.is_null()) entry["row"] = j.row;
    if (j.violation) {
      entry["violation"] = {
          {"what", j.violation->what}, {"configuration", j.violation->configuration},
          {"move", j.violation->move}, {"predicted", j.predicted},
          {"found", j.found},          {"mesh", j.violation->mesh ? region_json(*j.violation->mesh) : ordered_json()}};
    }
    json["claims"].push_back(std::move(entry));
  }
  return json;
}

CaseResult case_result(const ordered_json& json, std::size_t claims) {
  CaseResult result;
  result.study_seconds = json.at("study_seconds").get<double>();
  if (const auto methods = json.find("methods"); methods != json.end()) {
    for (const Method method : {Method::moves, Method::search, Method::walk}) {
      if (methods->contains(name(method)))
        result.method_seconds[method] = methods->at(name(method)).at("seconds").get<double>();
    }
  }
  if (json.contains("fillings")) result.fillings = integer_from(json["fillings"], 0, kMost);
  for (const ordered_json& entry : json.at("claims")) {
    const auto i = static_cast<std::size_t>(integer_from(entry.at("claim"), 0, static_cast<std::int64_t>(claims) - 1));
    if (!result.judgements.empty() && i <= result.judgements.back().claim)
      throw std::invalid_argument("the claims are not in order");
    ClaimJudgement& judged = result.judgements.emplace_back();
    judged.claim = i;
    judged.seconds = entry.at("seconds").get<double>();
    Judgement& j = judged.judgement;
    j.checks = integer_from(entry.at("checks"), 0, kMost);
    if (entry.contains("row")) j.row = entry["row"];
    if (entry.contains("violation")) {
      const ordered_json& v = entry["violation"];
      j.violation = Violation{v.at("what").get<std::string>(), v.at("configuration").get<std::string>(),
                              v.at("move").get<std::string>(), std::nullopt};
      j.predicted = v.at("predicted").get<std::string>();
      j.found = v.at("found").get<std::string>();
      if (!v.at("mesh").is_null()) j.violation->mesh = region_from(v["mesh"]);
    }
  }
  return result;
}

}  // namespace requad::verify
