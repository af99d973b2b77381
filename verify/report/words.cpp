#include "verify/report/words.hpp"

#include <map>
#include <stdexcept>

namespace requad::verify {

const std::string& heading(const std::string& claim, const std::string& key) {
  static const std::map<std::string, std::string> kHeadings{
      // Totals.
      {"family", "regions of the family"},
      {"regions", "regions judged"},
      {"checks", "comparisons"},
      // What region.
      {"sides", "side lengths"},
      {"pair", "pair"},
      {"valence", "valence"},
      {"irregular", "valences"},
      // Theorems 7.1 to 7.4.
      {"predicted", "configurations, by the closed form"},
      {"parameters", "configurations, by listing parameters"},
      {"tau", "tau(L)"},
      {"bound", "bound: tau of the regular region around it"},
      {"M", "M"},
      {"N", "N"},
      {"moves", "configurations, found by moves"},
      {"edges", "edges, found by moves"},
      {"edges_with_apex", "edges with the merged vertex, found by moves"},
      {"isomorphic", "graph as predicted"},
      {"search", "fillings, found by search"},
      {"walk", "configurations, visited by the walk"},
      {"walk_edges", "edges with the merged vertex, walked"},
      // P4, P5 and P6.
      {"blocked", "moves with a feature in their way"},
      {"made_round_the_feature", "made round the feature"},
      {"possible", "with a path round the feature"},
      {"from_the_v3_without_passing_the_v5", "pipelines from the v3 that do not pass the v5"},
      {"made", "moves made"},
      // F1.
      {"faces_of_grid", "faces of the grid"},
      {"nodes_of_smaller_grid", "nodes of the grid of side L - 1"},
      {"dual_edges", "edges between these faces"},
      // N3.
      {"fillings", "fillings with the three"},
      {"with_one_vertex", "fillings with one vertex"},
      {"cancelled", "fillings where a pair is cancelled"},
      {"couriers", "transports that cancel"},
      {"with_two_vertices", "fillings with two vertices"},
      {"merged", "fillings where a pair is merged"},
      {"with_fewer_vertices", "fillings with one or two vertices"},
      {"with_fewer_reached", "of these, reached by edits"},
      {"components", "parts of the graph of edits"},
      {"not_edited", "fillings that no edit makes simpler"},
  };
  // Where a key means something else than elsewhere.
  static const std::map<std::string, std::string> kOfClaims{
      {"T1 predicted", "positive solutions of the circulant system"},
      {"P5 moves", "moves"},
      {"P6 moves", "moves tried"},
      {"F1 isomorphic", "the smaller grid, as predicted"},
  };
  const auto special = kOfClaims.find(claim + " " + key);
  return special != kOfClaims.end() ? special->second : kHeadings.at(key);
}

std::string explanation(Method method) {
  switch (method) {
    case Method::moves:
      return "starts with one mesh and makes every pair move that the mesh allows, then every pair move of each mesh "
             "that results, until nothing new is found. Two meshes are the same configuration if an isomorphism that "
             "fixes the boundary joins them.";
    case Method::search:
      return "fills the boundary with quads in every possible way, with the same irregular vertices. It uses no "
             "theorem and no move.";
    case Method::walk:
      return "makes pair moves and their inverses on one mesh, which visits every configuration and goes along every "
             "edge of the graph both ways. Where the mesh is, it tells by the separatrices of the pair: which boundary "
             "vertices they meet (Theorem 7.11). It keeps one mesh only, and so it reaches the largest regions.";
  }
  return "";
}

}  // namespace requad::verify
