// requad-enumerate graph: the configuration graph of a region.

#include "enumerate/commands/arguments.hpp"
#include "enumerate/commands/commands.hpp"
#include "enumerate/graph_output.hpp"

namespace requad::enumerate {

namespace {

std::string graph_text(const Exploration& found, theory::Apex apex, const std::string& format) {
  if (format == "dot") return graph_dot(found, apex);
  if (format == "graphml") return graph_graphml(found, apex);
  return graph_json(found, apex).dump() + "\n";
}

int graph(const program::Options& options) {
  const theory::RegionShape shape = required_shape(options);
  const theory::Apex apex = options.has("with-apex") ? theory::Apex::with : theory::Apex::without;
  const std::string format = options.choice("format", {"json", "dot", "graphml"}, "json");
  const Exploration found = explore_all(shape, apex);
  program::Outputs outputs;
  if (options.has("json")) outputs.add(options.text("json"), graph_text(found, apex, "json"));
  if (options.has("output") || !options.on_stdout("json"))
    outputs.add(options.text("output", "-"), graph_text(found, apex, format));
  outputs.commit();
  return program::kDone;
}

}  // namespace

program::Command graph_command() {
  std::vector<program::Option> options = pair_region_options();
  options.push_back(program::flag("with-apex", "add the configuration in which the pair is merged"));
  options.push_back(program::value("format", "json|dot|graphml", "the format of the graph (default json)"));
  options.push_back(program::output("output,o", "FILE", "where the graph goes (default -)"));
  return {
      .name = "graph",
      .usage = {"--sides S1,S2,... --pair 3-3|5-5|3-5"},
      .summary = "explores the configuration graph of a region by pair moves",
      .examples = {"requad-enumerate graph --sides 9,9 --pair 3-3 --format dot -o grid.dot"},
      .options = std::move(options),
      .run = graph,
  };
}

}  // namespace requad::enumerate
