// requad-enumerate graph: the configuration graph of a region.

#include <functional>
#include <iostream>
#include <optional>
#include <utility>

#include "enumerate/commands/arguments.hpp"
#include "enumerate/commands/commands.hpp"
#include "enumerate/graphs/attributed_graph.hpp"
#include "enumerate/graphs/configuration_rows.hpp"
#include "enumerate/graphs/graph_output.hpp"
#include "mesh/program/layout.hpp"

namespace requad::enumerate {

namespace {

const std::vector<program::Format>& formats() {
  static const std::vector<program::Format> all{{"json", {"json"}},
                                                {"node_link", {"json"}},
                                                {"dot", {"dot", "gv"}},
                                                {"graphml", {"graphml", "xml"}},
                                                {"csv", {"csv"}}};
  return all;
}

std::string graph_text(const Exploration& found, theory::Apex apex, const std::string& format) {
  if (format == "dot") return graph_dot(found, apex);
  if (format == "graphml") return graph_graphml(found, apex);
  if (format == "csv") return graph_csv(found, apex);
  return (format == "node_link" ? graph_node_link(found, apex) : graph_json(found, apex)).dump() + "\n";
}

std::string empty_graph_text(theory::PairType type, const std::string& format) {
  if (format == "dot") return to_dot(AttributedGraph{});
  if (format == "graphml") return to_graphml(AttributedGraph{});
  if (format == "csv") return ConfigurationRows(type).csv();
  return (format == "node_link" ? to_node_link(AttributedGraph{}) : empty_graph_json()).dump() + "\n";
}

// Says on standard error, in one line, which part of the graph is not written.
void report_merged_left_out(const Exploration& found) {
  std::int64_t merged = 0, moves = 0;
  for (std::size_t i = 0; i < found.nodes.size(); ++i) merged += found.holds_pair(static_cast<int>(i)) ? 0 : 1;
  for (const FoundMove& move : found.moves) moves += move.to >= 0 && !found.holds_pair(move.to) ? 1 : 0;
  if (merged == 0) return;
  std::cerr << "requad-enumerate: left out: " << program::counted(merged, "configuration")
            << " in which the pair is merged, and " << program::counted(moves, "edge")
            << " to it; --with-apex adds them\n";
}

// Where the graph alone goes: to -o, or to standard output unless the JSON of --json goes there.
bool is_written(const program::Options& options) { return options.has("output") || !options.on_stdout("json"); }

int graph(const program::Options& options) {
  const theory::Apex apex = options.has("with-apex") ? theory::Apex::with : theory::Apex::without;
  const theory::PairType type = required_pair(options);
  require_moves(type);
  std::optional<Exploration> found;
  std::function<std::string(const std::string&)> text = [type](const std::string& wanted) {
    return empty_graph_text(type, wanted);
  };
  if (!reports_odd_boundary(options)) {
    found = explore_all(required_shape(options), apex);
    text = [&found, apex](const std::string& wanted) { return graph_text(*found, apex, wanted); };
  }
  program::Outputs outputs;
  if (options.has("json")) outputs.add(options.text("json"), text("json"));
  if (is_written(options)) outputs.add(options.text("output", "-"), text(options.format().name));
  outputs.commit();
  if (found && apex == theory::Apex::without) report_merged_left_out(*found);
  return program::kDone;
}

}  // namespace

program::Command graph_command() {
  std::vector<program::Option> options = pair_region_options();
  options.push_back(program::flag("with-apex", "add the configuration in which the pair is merged"));
  options.push_back(program::only_if(
      program::value("format", "NAME",
                     "the format of the graph (default: what the end of FILE says, else json)\n"
                     "  json       ours, with scripts\n"
                     "  node_link  JSON for networkx.node_link_graph()\n"
                     "  dot        with positions, for `neato -n2`\n"
                     "  graphml    with typed attributes\n"
                     "  csv        the configurations alone, as a table"),
      [](const program::Options& given) {
        return is_written(given) ? "" : std::string("--format has no effect beside --json -, without -o");
      }));
  options.push_back(program::output("output,o", "FILE", "where the graph goes (default -)", formats()));
  return {
      .name = "graph",
      .usage = {"--sides S1,S2,... --pair 3-3|5-5|3-5"},
      .summary = "explores the configuration graph of a region by pair moves",
      .text = R"(Each edge has the step of its move, and the script of operations that makes the
move on the mesh that `requad-enumerate signature --from-signature` makes of the
first node's signature.
)",
      .examples = {"requad-enumerate graph --sides 9,9 --pair 3-3 -o grid.dot",
                   "requad-enumerate graph --sides 5,4,4,7 --pair 3-5 --format csv"},
      .options = std::move(options),
      .run = graph,
  };
}

}  // namespace requad::enumerate
