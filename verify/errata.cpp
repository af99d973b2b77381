#include "verify/errata.hpp"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <optional>

#include "enumerate/edits.hpp"
#include "enumerate/exploration.hpp"
#include "mesh/topology/separatrix.hpp"
#include "verify/case_list.hpp"
#include "verify/studies/study.hpp"

namespace requad::verify {

namespace {

constexpr int kLongestSide = 8;

enumerate::Exploration explored(theory::PairType type, int length, theory::Apex apex) {
  return enumerate::explore_all(theory::RegionShape::regular(type, length), apex);
}

// The first regular region for which `shows` returns a text.
std::optional<Erratum> first_instance(theory::PairType type, theory::Apex apex, Erratum erratum,
                                      const std::function<std::string(int, const enumerate::Exploration&)>& shows) {
  for (int length = 3; length <= kLongestSide; ++length) {
    const std::string text = shows(length, explored(type, length, apex));
    if (text.empty()) continue;
    erratum.instance =
        std::string(type == theory::kDigon ? "digon" : "hexagon") + " of side " + std::to_string(length) + ": " + text;
    return erratum;
  }
  return std::nullopt;
}

// How many (m, n) with m, n >= 0 and 0 < m + n <= bound.
std::size_t points_up_to(int bound) {
  std::size_t count = 0;
  for (int s = 1; s <= bound; ++s) count += static_cast<std::size_t>(s) + 1;
  return count;
}

// What is wrong with the text of the pipeline of a 3-5 pair: the first region in which a v3 that starts cannot do without
// passing the v5.
std::optional<Erratum> pipeline_from_the_v3() {
  Ranges ranges;
  ranges.quad_perimeter = {16, 18};
  for (const RegionCase& region : list_cases(ranges, {Family::quad})) {
    const enumerate::Exploration e = enumerate::explore_all(std::get<PairCase>(region).shape, theory::Apex::without);
    for (const enumerate::FoundMove& move : e.moves) {
      const mesh::PairFrame& frame = move.move.frame;
      if (move.to < 0 || frame.distance() < 3) continue;
      const enumerate::FoundNode& from = e.nodes[static_cast<std::size_t>(move.from)];
      const std::string& to = e.nodes[static_cast<std::size_t>(move.to)].signature;
      const auto made = [&](mesh::VertexId first, mesh::VertexId last) {
        const auto ends = enumerate::pipelines(from.region, first, last, enumerate::Passing::not_allowed);
        return std::count(ends.begin(), ends.end(), to) > 0;
      };
      if (made(frame.v2, frame.v1) || !made(frame.v1, frame.v2)) continue;
      return Erratum{
          "Section 6",
          "A 3-5 pair moves in each of four directions by moving the v3, transporting the 3-5 pair and removing it at "
          "the v5; alternatively, in reverse.",
          "In reverse, from the v5, always. From the v3 the pair must pass the v5 in some directions if there is no "
          "way "
          "round: the v5 is then a v6 for a while, and a split ends the move in place of a removal.",
          describe(region) + ", configuration " + theory::label(e.shape.type(), from.reading.configuration) + ", " +
              mesh::name(move.move.step) +
              ": no order of operations that starts at the v3 changes the v5 by the last "
              "operation alone, though one that starts at the v5 changes the v3 so"};
    }
  }
  return std::nullopt;
}

// The smallest region that can be filled with three irregular vertices, but not with fewer.
std::optional<Erratum> three_without_room() {
  Ranges ranges;
  ranges.other_perimeter = {7, 20};
  for (const RegionCase& region : list_cases(ranges, {Family::three_vertices})) {
    const TripleStudy s = search_triple(std::get<TripleCase>(region));
    if (s.fillings.empty() || !s.fewer.empty()) continue;
    return Erratum{
        "Section 1",
        "A region with three irregular vertices can be edited by canceling or merging the irregular vertices.",
        "True if one of them is a v3, as far as all fillings were searched. Three v5s need room: some regions can be "
        "filled with three v5s, but with no fewer irregular vertices of any valences.",
        describe(region) + ": " + std::to_string(s.fillings.size()) + " filling of " +
            std::to_string(s.fillings.front().mesh.face_count()) + " faces, signature " + s.signatures.front() +
            ", and none with one or two irregular vertices"};
  }
  return std::nullopt;
}

std::vector<Erratum> search_errata() {
  std::vector<Erratum> found;
  const auto add = [&found](std::optional<Erratum> erratum) {
    if (erratum) found.push_back(std::move(*erratum));
  };
  for (const theory::PairType type : {theory::kDigon, theory::kHexagon}) {
    const auto quadrants = static_cast<std::size_t>(type.rotation_count());
    add(first_instance(
        type, theory::Apex::without,
        {type == theory::kDigon ? "Theorem 7.2" : "Theorem 7.3",
         type == theory::kDigon
             ? "The configurations are parametrised by all (m,n) with m, n >= 0 and 0 < m+n <= L-2."
             : "The configurations are parametrised by all (m,n,p) with m, n >= 0, 0 < m+n <= L-2 and p = 1, 2, 3.",
         "Only those with m+n of the parity of L, and (x,0) is the same configuration as (0,x), for a hexagon in the "
         "next quadrant.",
         ""},
        [&](int length, const enumerate::Exploration& e) -> std::string {
          const std::size_t written = quadrants * points_up_to(length - 2);
          if (written == e.nodes.size()) return "";
          return "the set as written has " + std::to_string(written) + " elements, there are " +
                 std::to_string(e.nodes.size()) + " configurations";
        }));
  }
  add(first_instance(theory::kDigon, theory::Apex::without,
                     {"Proof of Theorem 7.2", "0 < m+n < E1-2", "0 < m+n <= E1-2, as in the theorem itself.", ""},
                     [](int length, const enumerate::Exploration& e) -> std::string {
                       for (const auto& node : e.nodes) {
                         const auto& c = node.reading.configuration;
                         if (c.d1() + c.d2() == length - 2) return theory::label(e.shape.type(), c) + " exists";
                       }
                       return "";
                     }));
  add(first_instance(
      theory::kDigon, theory::Apex::with,
      {"Proof of Theorem 7.2", "Every grid point corresponds to a requadrangulation, and (0,0) is the merged vertex.",
       "(0,0) exists for even L only, and neither tau(L) nor the parameter set counts it.", ""},
      [](int length, const enumerate::Exploration& e) -> std::string {
        std::size_t merged = 0;
        for (const auto& node : e.nodes) merged += node.reading.configuration.merged() ? 1 : 0;
        return merged == 0 ? "has no merged configuration" : length % 2 == 0 ? "" : "has one though L is odd";
      }));
  add(first_instance(theory::kDigon, theory::Apex::without,
                     {"Lemma 7.9", "A convex region R that contains no irregular vertices has 4 - G(R) sides.",
                      "The lemma is used, and holds, for regions with irregular vertices inside; without any, G is 0. "
                      "What must be regular is the boundary.",
                      ""},
                     [](int, const enumerate::Exploration& e) -> std::string {
                       const mesh::Region& region = e.nodes.front().region;
                       return std::to_string(mesh::irregular_vertices(region.mesh).size()) +
                              " irregular vertices inside, G = " + std::to_string(mesh::total_index(region.mesh)) +
                              ", " + std::to_string(mesh::side_lengths(region).size()) + " sides";
                     }));
  add(first_instance(theory::kHexagon, theory::Apex::without,
                     {"Proof of Theorem 7.3",
                      "Two separatrices meet the first of two consecutive sides d1 apart, the second d2 apart (E3 and "
                      "E4 are such sides).",
                      "They meet the first side d2 apart and the second d1 apart, with the d1 and d2 of Equation 2: E3 "
                      "= d2 + e2 + e4, "
                      "E4 = d1 + e3 + e5. The parameter set is symmetric, so the theorem is as it was.",
                      ""},
                     [](int, const enumerate::Exploration& e) -> std::string {
                       for (const enumerate::FoundNode& node : e.nodes) {
                         const enumerate::LabelledFrame& labelled = node.reading.frames.front();
                         const theory::Configuration& c = labelled.labelling;
                         if (c.d1() == c.d2() || c.degenerate()) continue;
                         // Side 3 of Equation 2 is the one that v1's last outward separatrix meets, the fifth counted from its first leg.
                         const auto vector = enumerate::separatrix_vector(node.region, labelled.frame);
                         const mesh::BoundaryPosition last = vector[4];
                         for (std::size_t i = 5; i < vector.size(); ++i) {
                           if (vector[i].side != last.side) continue;
                           return theory::label(e.shape.type(), node.reading.configuration) +
                                  " has d1 = " + std::to_string(c.d1()) + ", d2 = " + std::to_string(c.d2()) +
                                  ", and a separatrix of each vertex meets E3, " +
                                  std::to_string(std::abs(last.distance - vector[i].distance)) + " apart";
                         }
                       }
                       return "";
                     }));
  add(pipeline_from_the_v3());
  add(three_without_room());
  return found;
}

}  // namespace

const std::vector<Erratum>& find_errata() {
  static const std::vector<Erratum> found = search_errata();
  return found;
}

std::string errata_text() {
  std::string text;
  for (const Erratum& e : find_errata()) {
    text += e.where + ": " + e.written + "\n     found: " + e.found + "\n     shown by: " + e.instance + '\n';
  }
  return text;
}

}  // namespace requad::verify
