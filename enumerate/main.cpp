// requad-enumerate: regions, configuration graphs and paths of moves.

#include <iostream>
#include <map>

#include <boost/program_options.hpp>
#include <nlohmann/json.hpp>

#include "enumerate/generators.hpp"
#include "enumerate/graph_output.hpp"
#include "enumerate/realisation.hpp"
#include "mesh/obj.hpp"
#include "mesh/program.hpp"
#include "mesh/signature.hpp"
#include "theory/counts.hpp"

namespace {

namespace po = boost::program_options;
using namespace requad;
using nlohmann::ordered_json;
using program::UsageError;
using theory::Configuration;
using theory::IntegerVector;
using theory::PairType;

constexpr const char* kHelp = R"(requad-enumerate: regions of quad meshes that hold a pair of irregular vertices

  requad-enumerate region digon|hexagon|quad D1 D2 E1,E2,... [-o FILE.obj]
      the region with these separatrix-strip parameters: R_alpha is a D1 x D2 grid, E1,E2,... are the strip counts
      (2 for a digon with a 3-3 pair, 6 for a hexagon with a 5-5 pair, 4 for a quadrilateral with a 3-5 pair)
      --generator glue|grow|moves   how it is made; all three give the same mesh (default glue)
  requad-enumerate graph --sides S1,S2,... --pair 3-3|5-5|3-5 [--with-apex] [--format json|dot|graphml]
      the configuration graph of a region, found by pair moves; --with-apex adds the merged configuration
  requad-enumerate path --sides S1,S2,... --pair P --from M,N[,P] --to M,N[,P] [-o FILE.obj]
      a shortest script of pair moves between two configurations, and the mesh it makes;
      labels are (d1,d2), for a hexagon (d1,d2,p), for a 3-5 pair (m,n) as in Theorem 7.4; 0,0 is the merged vertex

Common options: --json FILE|-   -o FILE|-   --quiet   --threads N   --help   --version
Sides are read counter-clockwise. Exit code: 0 done, 1 a check failed, 2 bad arguments.

Examples:
  requad-enumerate region digon 2 1 3,2 -o region.obj
  requad-enumerate graph --sides 9,9 --pair 3-3 --format dot -o grid.dot
  requad-enumerate path --sides 8,8 --pair 3-3 --from 1,1 --to 5,1 -o result.obj
)";

IntegerVector to_vector(const std::vector<std::int64_t>& values) {
  IntegerVector v(static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) v(static_cast<Eigen::Index>(i)) = values[i];
  return v;
}

PairType parse_pair(const std::string& text) {
  static const std::map<std::string, PairType> kPairs{
      {"3-3", theory::kDigon}, {"5-5", theory::kHexagon}, {"3-5", theory::kQuad}, {"5-3", theory::kQuad}};
  const auto it = kPairs.find(text);
  if (it == kPairs.end()) throw UsageError("--pair: '" + text + "' is not one of 3-3, 5-5, 3-5");
  return it->second;
}

PairType parse_shape(const std::string& text) {
  static const std::map<std::string, PairType> kShapes{
      {"digon", theory::kDigon}, {"hexagon", theory::kHexagon}, {"quad", theory::kQuad}};
  const auto it = kShapes.find(text);
  if (it == kShapes.end()) throw UsageError("region: '" + text + "' is not one of digon, hexagon, quad");
  return it->second;
}

// The one configuration of the region that has this label.
Configuration find_configuration(PairType type, const IntegerVector& sides, const std::string& text, const char* option) {
  const std::vector<std::int64_t> at = program::parse_integers(text, option);
  const bool third = type.symmetric() && type.rotation_count() > 1;
  const bool merged = type.symmetric() && at.size() >= 2 && at[0] == 0 && at[1] == 0;
  if (at.size() != (third && !merged ? 3U : 2U)) {
    throw UsageError(std::string(option) + ": '" + text + "' is not of the form " + (third ? "d1,d2,p" : type.symmetric() ? "d1,d2" : "m,n"));
  }
  std::vector<Configuration> all = theory::parameter_set(type, sides);
  if (merged) all = theory::merged_configurations(type, sides);
  for (const Configuration& c : all) {
    const theory::GridPoint here = theory::grid_point(type, c);
    if (here.m == at[0] && here.n == at[1] && (!third || merged || c.p == at[2])) return c;
    if (type.symmetric() && c.degenerate() && !c.merged()) {
      const Configuration other = theory::other_labelling(type, c);
      if (other.d1() == at[0] && other.d2() == at[1] && (!third || other.p == at[2])) return c;
    }
  }
  throw UsageError(std::string(option) + ": (" + text + ") is no configuration of this region");
}

IntegerVector required_sides(const po::variables_map& options, PairType type) {
  if (options.count("sides") == 0) throw UsageError("--sides is missing; expected side lengths as in --sides 9,9");
  IntegerVector sides = to_vector(program::parse_integers(options["sides"].as<std::string>(), "--sides"));
  if (const std::string problem = theory::sides_problem(type, sides); !problem.empty()) throw UsageError("--sides: " + problem);
  return sides;
}

PairType required_pair(const po::variables_map& options) {
  if (options.count("pair") == 0) throw UsageError("--pair is missing; expected 3-3, 5-5 or 3-5");
  return parse_pair(options["pair"].as<std::string>());
}

void finish(const po::variables_map& options, const ordered_json& summary, const std::string& text) {
  if (options.count("json") != 0) {
    program::write_text(options["json"].as<std::string>(), summary.dump() + "\n");
  }
  const bool stdout_taken = (options.count("json") != 0 && options["json"].as<std::string>() == "-") ||
                            (options.count("output") != 0 && options["output"].as<std::string>() == "-");
  if (!stdout_taken && options.count("quiet") == 0) std::cout << text;
}

std::vector<int> as_ints(const IntegerVector& v) {
  std::vector<int> result;
  for (const auto x : v) result.push_back(static_cast<int>(x));
  return result;
}

// --- region ----------------------------------------------------------------------------------------------------------

int region(const po::variables_map& options, const std::vector<std::string>& words) {
  if (words.size() != 4) throw UsageError("region: expected digon|hexagon|quad D1 D2 E1,E2,...");
  const PairType type = parse_shape(words[0]);
  Configuration c;
  c.parameters = {program::parse_integer(words[1], "D1"), program::parse_integer(words[2], "D2"),
                  to_vector(program::parse_integers(words[3], "strip counts"))};
  if (const std::string problem = theory::parameters_problem(type, c.parameters); !problem.empty()) {
    throw UsageError("region: " + problem);
  }
  const IntegerVector sides = theory::region_sides(type, c);
  const std::string generator = options["generator"].as<std::string>();
  mesh::Region made;
  if (generator == "glue") {
    made = enumerate::glue_region(type, c);
  } else if (generator == "grow") {
    made = enumerate::grow_region(type, c);
  } else if (generator == "moves") {
    made = enumerate::realise(type, sides, enumerate::simplest_configuration(type, sides), c).region;
  } else {
    throw UsageError("--generator: '" + generator + "' is not one of glue, grow, moves");
  }
  if (options.count("output") != 0) {
    mesh::save_region(options["output"].as<std::string>(), made,
                      {"region with a " + type.name() + " pair, parameters " + words[1] + " " + words[2] + " " + words[3]});
  }
  const std::string signature = mesh::signature(made);
  std::string text = "sides";
  for (const auto side : sides) text += " " + std::to_string(side);
  text += "\nfaces " + std::to_string(made.mesh.face_count()) + "\nvertices " + std::to_string(made.mesh.vertex_count()) +
          "\nsignature " + signature + "\n";
  finish(options,
         {{"pair", type.name()}, {"sides", as_ints(sides)}, {"faces", made.mesh.face_count()},
          {"vertices", made.mesh.vertex_count()}, {"signature", signature}},
         text);
  return program::kDone;
}

// --- graph -----------------------------------------------------------------------------------------------------------

int graph(const po::variables_map& options) {
  const PairType type = required_pair(options);
  const IntegerVector sides = required_sides(options, type);
  const theory::Apex apex = options.count("with-apex") != 0 ? theory::Apex::with : theory::Apex::without;
  const std::string format = options["format"].as<std::string>();
  if (format != "json" && format != "dot" && format != "graphml") {
    throw UsageError("--format: '" + format + "' is not one of json, dot, graphml");
  }
  const enumerate::Exploration found = enumerate::explore_all(type, sides, apex);
  std::string text;
  if (format == "json") text = enumerate::graph_json(found, apex).dump() + "\n";
  if (format == "dot") text = enumerate::graph_dot(found, apex);
  if (format == "graphml") text = enumerate::graph_graphml(found, apex);
  if (options.count("json") != 0) {
    program::write_text(options["json"].as<std::string>(), enumerate::graph_json(found, apex).dump() + "\n");
    if (options["json"].as<std::string>() == "-") return program::kDone;
  }
  program::write_text(options.count("output") != 0 ? options["output"].as<std::string>() : "-", text);
  return program::kDone;
}

// --- path ------------------------------------------------------------------------------------------------------------

int path(const po::variables_map& options) {
  const PairType type = required_pair(options);
  const IntegerVector sides = required_sides(options, type);
  for (const char* end : {"from", "to"}) {
    if (options.count(end) == 0) throw UsageError(std::string("--") + end + " is missing; expected a label as in --" + end + " 1,1");
  }
  const Configuration from = find_configuration(type, sides, options["from"].as<std::string>(), "--from");
  const Configuration to = find_configuration(type, sides, options["to"].as<std::string>(), "--to");
  const enumerate::Realisation made = enumerate::realise(type, sides, from, to);
  if (options.count("output") != 0) {
    mesh::save_region(options["output"].as<std::string>(), made.region, {theory::label(type, to) + " reached from " + theory::label(type, from)});
  }
  ordered_json json{{"sides", as_ints(sides)}, {"pair", type.name()}, {"path", ordered_json::array()},
                    {"moves", ordered_json::array()}, {"operations", ordered_json::array()},
                    {"signature", mesh::signature(made.region)}};
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
  for (const auto& op : made.operations) {
    json["operations"].push_back(mesh::to_string(op));
    text += mesh::to_string(op) + "\n";
  }
  finish(options, json, text);
  return program::kDone;
}

int main_body(int argc, char** argv) {
  po::options_description visible;
  visible.add_options()("help,h", "")("version", "")("quiet,q", "")("json", po::value<std::string>())("threads", po::value<std::string>())(
      "output,o", po::value<std::string>())("generator", po::value<std::string>()->default_value("glue"))("sides", po::value<std::string>())(
      "pair", po::value<std::string>())("with-apex", "")("format", po::value<std::string>()->default_value("json"))(
      "from", po::value<std::string>())("to", po::value<std::string>());
  po::options_description all;
  all.add(visible).add_options()("words", po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add("words", -1);
  po::variables_map options;
  try {
    using Style = po::command_line_style::style_t;
    // No guessing of abbreviated options.
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional)
                  .style(Style::unix_style & ~Style::allow_guessing).run(), options);
  } catch (const po::error& error) {
    throw UsageError(std::string(error.what()) + "; see --help");
  }
  if (options.count("help") != 0) {
    std::cout << kHelp;
    return program::kDone;
  }
  if (options.count("version") != 0) {
    std::cout << "requad-enumerate " REQUAD_VERSION "\n";
    return program::kDone;
  }
  if (options.count("words") == 0) throw UsageError("expected one of region, graph, path; see --help");
  std::vector<std::string> words = options["words"].as<std::vector<std::string>>();
  const std::string command = words.front();
  words.erase(words.begin());
  if (command == "region") return region(options, words);
  if (!words.empty()) throw UsageError(command + ": unexpected argument '" + words.front() + "'; see --help");
  if (command == "graph") return graph(options);
  if (command == "path") return path(options);
  throw UsageError("'" + command + "' is not one of region, graph, path; see --help");
}

}  // namespace

int main(int argc, char** argv) {
  return program::run("requad-enumerate", [argc, argv] { return main_body(argc, argv); });
}
