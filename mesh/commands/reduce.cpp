// requad-edit reduce: removes irregular vertices, by the cheapest cancellations first (Figure 19).

#include "mesh/irregular/reduce.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/commands/commands.hpp"
#include "mesh/commands/session.hpp"
#include "mesh/editing/element_map.hpp"
#include "mesh/geometry/diagnosis.hpp"
#include "mesh/program/run/progress.hpp"

namespace requad::edit {

namespace {

using mesh::Refusal;
using nlohmann::ordered_json;
using program::Options;

// Why the reduction ended.
std::string ending(const mesh::ReduceReport& report, int until) {
  if (report.minimal)
    return "nothing of opposite index is left within a patch of the surface: there the sum of 4 - l(v) is fixed "
           "(discrete Gauss-Bonnet)";
  if (report.after <= until) return "--until is reached";
  std::string text = report.lost_patience ? "the last attempts failed (--patience tries more)"
                                          : "what is left cannot be cancelled here";
  for (const auto& [refusal, count] : report.refusals)
    text += "; " + counted(count, "pair: ", "pairs: ") + std::string(refusal.clause());
  if (report.too_far > 0)
    text += "; " + counted(report.too_far, "pair would", "pairs would") +
            " lead too far from the surface (--max-deviation allows more)";
  if (report.unsymmetric > 0)
    text += "; " + counted(report.unsymmetric, "pair", "pairs") + " cannot be cancelled on both sides (--symmetry)";
  if (report.inward > 0)
    text += "; " + counted(report.inward, "pair at the boundary would", "pairs at the boundary would") +
            " make vertices inside irregular (see --boundary)";
  if (report.worn > 0)
    text += "; " + counted(report.worn, "pair would", "pairs would") + " go beyond --max-quality-loss";
  if (report.folded > 0)
    text += "; " + counted(report.folded, "pair would", "pairs would") +
            " leave more quads inverted (--allow-inverted cancels them nevertheless)";
  return text;
}

// The images about the plane that --symmetry names. Throws UsageError if the mesh is not symmetric about it.
std::optional<mesh::Mirror> symmetry(const Options& options, const Session& session) {
  if (!options.has("symmetry")) return std::nullopt;
  const std::string name = options.choice("symmetry", {"x", "y", "z"}, "x");
  const mesh::Axis axis = name == "x" ? mesh::Axis::x : name == "y" ? mesh::Axis::y : mesh::Axis::z;
  mesh::VertexId without;
  std::optional<mesh::Mirror> mirror = mesh::Mirror::find(session.mesh(), session.positions(), axis, &without);
  if (!mirror) {
    throw program::UsageError("reduce: --symmetry: IN is not symmetric in " + name + ": vertex " +
                              std::to_string(mesh::file_number(session.mesh(), without)) +
                              " or a face at it has no image");
  }
  return mirror;
}

int reduce(const Options& options) {
  output_path(options, "reduce");
  mesh::ReduceOptions how;
  how.until = static_cast<int>(options.integer("until", 0, 0, 1'000'000'000));
  how.cost = options.choice("cost", {"fit", "curvature"}, "fit") == "fit" ? mesh::ReduceCost::fit
                                                                          : mesh::ReduceCost::curvature;
  const double deviation = options.number("max-deviation", -1, 0, 1);
  how.sweeps = static_cast<int>(options.integer("smooth", how.sweeps, 0, 100'000));
  how.final_rounds = static_cast<int>(options.integer("final-smooth", how.final_rounds, 0, 100'000));
  how.fit_all = options.has("final-smooth");
  how.patience = static_cast<int>(options.integer("patience", how.patience, 0, 1'000'000));
  how.allow_inverted = options.has("allow-inverted");
  how.run = tasks(options);

  Session session(options, "reduce");
  const double diagonal = mesh::bounding_box_diagonal(session.mesh(), session.positions());
  if (deviation >= 0) how.max_deviation = deviation * diagonal;
  how.max_quality_loss = options.number("max-quality-loss", deviation >= 0 ? 0.05 : 2, 0, 2);
  how.symmetry = symmetry(options, session);
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

  ordered_json left = ordered_json::object();
  std::string kinds;
  for (const auto& [l, n] : mesh::diagnose(session.mesh(), session.positions()).valences) {
    if (l == 4) continue;
    left[std::to_string(l)] = n;
    kinds += (kinds.empty() ? "" : " ") + std::to_string(n) + " v" + std::to_string(l);
  }
  const std::string beside = session.features().empty() ? "" : " beside those that features ask for";
  const std::string why = ending(report, how.until);
  return session.done({{"irregular", {{"before", report.before}, {"after", report.after}}},
                       {"left", left},
                       {"cancelled", report.cancelled},
                       {"couriers", report.transports},
                       {"operations", report.operations},
                       {"measured", report.measured},
                       {"too_far", report.too_far},
                       {"folded", report.folded},
                       {"worn", report.worn},
                       {"inward", report.inward},
                       {"unsymmetric", report.unsymmetric},
                       {"minimal", report.minimal},
                       {"ended", why},
                       {"feature_edges", session.features().size()}},
                      std::to_string(report.before) + " irregular vertices" + beside + " became " +
                          std::to_string(report.after) + " by " +
                          counted(report.cancelled, "cancellation", "cancellations") +
                          "; inside the mesh there are now " + (kinds.empty() ? "none" : kinds) + "\n" + why + "\n");
}

}  // namespace

program::Command reduce_command() {
  return {
      .name = "reduce",
      .usage = {"IN -o OUT"},
      .summary = "cancels pairs of a v3 and a v5, the cheapest first",
      .text = R"(The reduction ends when N irregular vertices are left, or none that can be
cancelled. The mesh is fitted to the surface of IN all the time: its vertices
stay near the surface, and what sticks out of IN stays covered. No cancellation
is made that leaves more quads inverted. If nothing can be cancelled, OUT is IN,
bit by bit. The order: parts of IN where the mesh is coarse are left for last.
)",
      .examples = {"requad-edit reduce mesh/examples/figure-16.obj -o less.obj",
                   "requad-edit reduce mesh/examples/figure-15.obj --symmetry x -o less.obj",
                   "requad-edit reduce mesh/examples/figure-17.obj --feature-angle 40 --until 8 --max-deviation 0.01 "
                   "-o less.obj"},
      .options = editing_options({
          program::value("until", "N", "stop at N irregular vertices (default 0)"),
          program::value("max-deviation", "D",
                         "keep the Hausdorff distance of OUT and IN within D times the diagonal of IN\n"
                         "(default 0.02); if D is given, with more care, which takes longer"),
          program::value("max-quality-loss", "Q",
                         "make no cancellation that lets the mean scaled Jacobian fall by more than Q below\n"
                         "that of IN (default 0.05 with --max-deviation, no bound without)"),
          program::value("cost", "fit|curvature",
                         "what makes a cancellation cheap (default fit): few\n"
                         "  fit        points of IN whose quad goes, and few operations\n"
                         "  curvature  changes of the sum of |mean curvature|, as in the paper"),
          program::value("final-smooth", "N",
                         "fit all that was edited in N rounds at the end (default 20); if N is given, fit\n"
                         "the whole mesh, whatever was edited"),
          program::value("patience", "N",
                         "end when N cancellations in a row turn out to be impossible without losing the shape\n"
                         "or inverting quads (default 64; 0: try them all, and search longer for each)"),
          program::value("symmetry", "x|y|z",
                         "make each cancellation on both sides of the plane through the middle of IN that has\n"
                         "this normal, so that OUT is as symmetric as IN; a pair whose cancellation would meet\n"
                         "its image stays"),
          allow_inverted_option(),
      }),
      .words = {1, 1},
      .files = {0},
      .run = reduce,
  };
}

}  // namespace requad::edit
