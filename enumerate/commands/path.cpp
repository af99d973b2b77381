// requad-enumerate path: a shortest script of pair moves between two configurations.

#include "enumerate/commands/arguments.hpp"
#include "enumerate/commands/commands.hpp"
#include "enumerate/realisation.hpp"
#include "mesh/topology/signature.hpp"

namespace requad::enumerate {

namespace {

using nlohmann::ordered_json;
using program::Options;
using program::UsageError;
using theory::Configuration;
using theory::IntegerVector;
using theory::PairType;

// The form in which labels of this type are written.
const char* label_form(PairType type) {
  if (!type.symmetric()) return "m,n";
  return type.has_third_index() ? "d1,d2,p" : "d1,d2";
}

// The configuration of the region whose label the option gives. Throws UsageError.
Configuration required_configuration(const Options& options, const std::string& name,
                                     const theory::RegionShape& shape) {
  const PairType type = shape.type();
  const std::string text = options.required(name, "a label as in --" + name + " 1,1");
  const std::vector<std::int64_t> label = program::parse_integers(text, "--" + name);
  const bool has_p = type.has_third_index();
  const bool is_merged = type.symmetric() && label.size() >= 2 && label[0] == 0 && label[1] == 0;
  if (label.size() != (has_p ? 3U : 2U) && !(is_merged && label.size() == 2))
    throw UsageError("--" + name + ": '" + text + "' is not of the form " + label_form(type));
  const std::vector<Configuration> all =
      is_merged ? theory::merged_configurations(shape) : theory::parameter_set(shape);
  for (const Configuration& c : all) {
    const theory::GridPoint point = theory::grid_point(type, c);
    if (point.m == label[0] && point.n == label[1] && (!has_p || is_merged || c.p == label[2])) return c;
    // A degenerate configuration has two labels.
    if (type.symmetric() && c.degenerate() && !c.merged()) {
      const Configuration other = theory::other_labelling(type, c);
      if (other.d1() == label[0] && other.d2() == label[1] && (!has_p || other.p == label[2])) return c;
    }
  }
  throw UsageError("--" + name + ": (" + text + ") is no configuration of this region");
}

int path(const Options& options) {
  require_moves(required_pair(options));
  if (reports_odd_boundary(options)) {
    const auto list = ordered_json::array();
    const IntegerVector sides = theory::to_vector(program::parse_integers(options.text("sides"), "--sides"));
    finish(options,
           {{"sides", as_ints(sides)}, {"path", list}, {"moves", list}, {"operations", list}, {"complete", true}}, "");
    return program::kDone;
  }
  const theory::RegionShape shape = required_shape(options);
  const PairType type = shape.type();
  const Configuration from = required_configuration(options, "from", shape);
  const Configuration to = required_configuration(options, "to", shape);
  const Realisation made = realise(shape, from, to);
  ordered_json json{{"sides", as_ints(shape.sides())},     {"pair", type.name()},
                    {"path", ordered_json::array()},       {"moves", ordered_json::array()},
                    {"operations", ordered_json::array()}, {"signature", mesh::signature(made.region)}};
  std::string text;
  for (std::size_t i = 0; i < made.path.size(); ++i) {
    const std::string label = theory::label(type, made.path[i]);
    json["path"].push_back(label);
    if (i > 0) {
      json["moves"].push_back(mesh::name(made.moves[i - 1].step));
      text += std::string(" ") + mesh::name(made.moves[i - 1].step) + " ";
    }
    text += label;
  }
  text += "\n";
  for (const auto& operation : made.operations) {
    json["operations"].push_back(mesh::to_string(operation));
    text += mesh::to_string(operation) + "\n";
  }
  finish(options, json, text, &made.region, theory::label(type, to) + " reached from " + theory::label(type, from));
  return program::kDone;
}

}  // namespace

program::Command path_command() {
  std::vector<program::Option> options = pair_region_options();
  options.push_back(program::value("from", "LABEL", "the label of the first configuration"));
  options.push_back(program::value("to", "LABEL", "the label of the last one"));
  options.push_back(mesh_output());
  return {
      .name = "path",
      .usage = {"--sides S1,S2,... --pair 3-3|5-5|3-5 --from LABEL --to LABEL"},
      .summary = "finds a shortest script of pair moves between two configurations, and makes the mesh it leads to",
      .text = R"(A label is d1,d2 for a 3-3 pair, d1,d2,p for a 5-5 pair, and m,n for a 3-5 pair
as in Theorem 7.4. 0,0 is the configuration in which the pair is merged.
)",
      .examples = {"requad-enumerate path --sides 8,8 --pair 3-3 --from 1,1 --to 5,1 -o result.obj"},
      .options = std::move(options),
      .run = path,
  };
}

}  // namespace requad::enumerate
