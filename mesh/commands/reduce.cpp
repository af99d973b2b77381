// requad-edit reduce: fewer irregular vertices, by the cheapest cancellations first (Figure 19).

#include "mesh/irregular/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mesh/commands/session.hpp"
#include "mesh/geometry/diagnosis.hpp"
#include "mesh/geometry/hausdorff_distance.hpp"

namespace requad::edit {

namespace {

using mesh::Refusal;
using nlohmann::ordered_json;
using program::Options;
using program::UsageError;

// Why it ends where it ends.
std::string ending(const mesh::ReduceReport& report, int until) {
  if (report.minimal)
    return "nothing of opposite index is left within a patch of the surface: there the sum of 4 - l(v) is fixed "
           "(discrete "
           "Gauss-Bonnet)";
  if (report.after <= until) return "--until is reached";
  std::string text = "what is left can not be cancelled here";
  for (const auto& [refusal, count] : report.refusals)
    text += "; " + counted(count, "pair: ", "pairs: ") + std::string(refusal.clause());
  if (report.too_far > 0)
    text += "; " + counted(report.too_far, "pair would", "pairs would") + " go beyond --max-deviation";
  return text;
}

int reduce(const Options& options) {
  if (options.words().size() != 1) throw UsageError("reduce: expected one mesh file; see --help");
  output_path(options, "reduce");
  mesh::ReduceOptions how;
  how.until = static_cast<int>(options.integer("until", 0, 0, 1'000'000'000));
  const std::string cost = options.text("cost", "shape");
  if (cost != "shape" && cost != "curvature") throw UsageError("--cost: '" + cost + "' is not one of shape, curvature");
  how.cost = cost == "shape" ? mesh::ReduceCost::shape : mesh::ReduceCost::curvature;
  const double deviation = options.number("max-deviation", -1, 0, 1);
  how.smoothing_iterations = static_cast<int>(options.integer("smooth", how.smoothing_iterations, 0, 100'000));
  how.final_iterations = static_cast<int>(options.integer("final-smooth", how.final_iterations, 0, 100'000));

  Session session(options, "reduce");
  how.surface = &session.surface();
  const double diagonal = mesh::bounding_box_diagonal(session.mesh(), session.positions());
  if (deviation >= 0) how.max_deviation = deviation * diagonal;
  const std::vector<mesh::VertexId> all = session.mesh().vertices();
  const auto is_irregular = [&](mesh::VertexId v) { return session.editor().sectors().is_irregular(v); };
  const auto count = std::count_if(all.begin(), all.end(), is_irregular);
  program::Progress progress("irregular vertices less", count, options.quiet());
  int last = static_cast<int>(count);
  how.progress = [&](int irregular) {
    progress.advance(std::max(0, last - irregular));
    last = std::min(last, irregular);
  };
  const mesh::ReduceReport report = mesh::reduce(session.editor(), how);
  progress.finish();

  const double hausdorff = mesh::hausdorff_distance({session.mesh(), session.positions()},
                                                    {session.input().mesh, session.input().positions}) /
                           diagonal;
  ordered_json left = ordered_json::object();
  std::string kinds;
  for (const auto& [l, n] : mesh::diagnose(session.mesh(), session.positions()).valences) {
    if (l == 4) continue;
    left[std::to_string(l)] = n;
    kinds += (kinds.empty() ? "" : " ") + std::to_string(n) + " v" + std::to_string(l);
  }
  const std::string beside = session.features().empty() ? "" : " beside those that features ask for";
  const std::string why = ending(report, how.until);
  char measured[64];
  std::snprintf(measured, sizeof measured, "%.4f", hausdorff);
  return session.done({{"irregular", {{"before", report.before}, {"after", report.after}}},
                       {"left", left},
                       {"cancelled", report.cancelled},
                       {"couriers", report.transports},
                       {"operations", report.operations},
                       {"measured", report.measured},
                       {"minimal", report.minimal},
                       {"ended", why},
                       {"feature_edges", session.features().size()},
                       {"hausdorff", hausdorff}},
                      std::to_string(report.before) + " irregular vertices" + beside + " became " +
                          std::to_string(report.after) + " by " +
                          counted(report.cancelled, "cancellation", "cancellations") +
                          "; inside the mesh there are now " + (kinds.empty() ? "none" : kinds) + "\n" + why +
                          "\nHausdorff distance from the input, over the diagonal: " + measured + "\n");
}

}  // namespace

Command reduce_command() {
  return {
      "reduce",
      std::string(
          "  requad-edit reduce IN -o OUT [--until N] [--max-deviation D] [--cost shape|curvature] [--final-smooth N]\n"
          "      cancels pairs of a v3 and a v5, the cheapest first, until N irregular vertices or none that can be\n"
          "      cancelled are left. D: how far a face's centre may come from IN's surface, over its diagonal.\n"
          "      Cost: the change of sum (1 - scaled Jacobian) area, or of |mean curvature| (the paper's)\n") +
          kEditingHelp,
      {"requad-edit reduce spot.obj -o spot8.obj", "requad-edit reduce fandisk.obj --feature-angle 40 -o less.obj",
       "requad-edit reduce bunny.obj --until 40 --max-deviation 0.01 -o less.obj"},
      editing_options({{}, {"until", "max-deviation", "cost", "final-smooth"}, {}}),
      reduce};
}

}  // namespace requad::edit
