// requad-enumerate configurations: what the side-length law says of a region with any pair.

#include <cmath>

#include "enumerate/commands/arguments.hpp"
#include "enumerate/commands/commands.hpp"
#include "enumerate/generators.hpp"
#include "enumerate/graphs/configuration_rows.hpp"
#include "mesh/topology/signature.hpp"

namespace requad::enumerate {

namespace {

int configurations(const program::Options& options) {
  const theory::PairType type = required_pair(options);
  ConfigurationRows rows(type);
  std::vector<int> sides;
  if (reports_odd_boundary(options)) {
    sides = required_ints(options, "sides");
  } else {
    const theory::RegionShape shape = required_shape(options);
    sides = as_ints(shape.sides());
    for (const theory::Configuration& c : theory::parameter_set(shape)) {
      const mesh::Region region = glue_region(type, c);
      rows.add(c, region.mesh.face_count(), mesh::signature(region));
    }
  }
  const std::string text = "count " + std::to_string(rows.size()) + "\n" + (rows.size() == 0 ? "" : rows.text());
  program::Outputs outputs;
  if (options.has("output")) {
    const nlohmann::ordered_json list = rows.json();
    outputs.add(options.text("output"), options.format().name == "csv" ? rows.csv() : list.dump() + "\n");
  }
  program::finish(options,
                  nlohmann::ordered_json{
                      {"sides", sides}, {"pair", type.name()}, {"count", rows.size()}, {"configurations", rows.json()}}
                      .dump(),
                  text, std::move(outputs));
  return program::kDone;
}

}  // namespace

program::Command configurations_command() {
  std::vector<program::Option> options = pair_region_options();
  options[1].meaning = "the valences of the pair: any two but 4";
  options.push_back(program::output("output,o", "FILE", "write the list with the signatures too, as CSV or JSON; or -",
                                    {{"csv", {"csv"}}, {"json", {"json"}}}));
  return {
      .name = "configurations",
      .usage = {"--sides S1,S2,... --pair L1-L2"},
      .summary = "lists the configurations of a region with any pair, by the side-length law",
      .text = R"(The law holds for any two valences, so 3-6 and 5-6 pairs are counted, too. A
region has L1 + L2 - 4 sides.
)",
      .examples = {"requad-enumerate configurations --sides 4,4,4,3,3 --pair 3-6",
                   "requad-enumerate configurations --sides 4,4,3,3,3,3,4 --pair 5-6 -o list.csv"},
      .options = std::move(options),
      .run = configurations,
  };
}

}  // namespace requad::enumerate
