// requad-enumerate: regions, configuration graphs and paths of moves.

#include <algorithm>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "enumerate/generators.hpp"
#include "enumerate/graph_output.hpp"
#include "enumerate/realisation.hpp"
#include "enumerate/search/search.hpp"
#include "enumerate/search/spheres.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/program/options.hpp"
#include "mesh/program/program.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "theory/counts.hpp"
#include "theory/joined.hpp"

namespace {

using namespace requad;
using nlohmann::ordered_json;
using program::Options;
using program::UsageError;
using theory::Configuration;
using theory::IntegerVector;
using theory::PairType;
using theory::RegionShape;

constexpr const char* kHelp =
    R"(requad-enumerate: regions of quad meshes, their irregular vertices, and all their fillings

  requad-enumerate region digon|hexagon|quad D1 D2 E1,E2,... [-o FILE.obj]
      the region with these separatrix-strip parameters: R_alpha is a D1 x D2 grid, E1,E2,... are the strip counts
      (2 for a digon with a 3-3 pair, 6 for a hexagon with a 5-5 pair, 4 for a quadrilateral with a 3-5 pair)
      --generator glue|grow|moves   how it is made; all three give the same mesh (default glue)
  requad-enumerate graph --sides S1,S2,... --pair 3-3|5-5|3-5 [--with-apex] [--format json|dot|graphml] [-o FILE]
      the configuration graph of a region, explored by pair moves; --with-apex adds the merged configuration
  requad-enumerate path --sides S1,S2,... --pair P --from M,N[,P] --to M,N[,P] [-o FILE.obj]
      a shortest script of pair moves between two configurations, and the mesh it makes;
      labels are (d1,d2), for a hexagon (d1,d2,p), for a 3-5 pair (m,n) as in Theorem 7.4; 0,0 is the merged vertex
  requad-enumerate search --sides S1,S2,... --irregular L1,L2,... [--list] [--limit-seconds S] [--max-faces F]
                          [--journal FILE]
      every filling of a boundary whose interior irregular valences are exactly these, by exhaustive search;
      --interior-quads Q1,Q2,... instead of --sides gives the number of quads at each boundary vertex;
      --irregular '' asks for regular grids; --list prints a signature for each filling;
      --journal FILE keeps what is found and what is left: killed or out of time, the same command goes on
  requad-enumerate sphere --irregular L1,L2,... --vertices A..B [--list] [--limit-seconds S] [--journal FILE]
      all closed quad spheres with these irregular valences, up to isomorphism
  requad-enumerate signature FILE [--subdivide]
      the canonical signature of a mesh in an OBJ or OFF file, one for it and its mirror image: two files print the same
      line iff their meshes are isomorphic; --subdivide cuts each polygon into quads first
  requad-enumerate signature --from-signature TEXT [-o FILE.obj]
      checks a signature, and draws the region that it names

Common options: --json FILE|-   -o FILE|-   --quiet   --threads N   --help   --version
Sides are read counter-clockwise. Exit code: 0 done, 1 a check failed, 2 bad arguments, 3 a limit was reached.

Examples:
  requad-enumerate region digon 2 1 3,2 -o region.obj
  requad-enumerate graph --sides 9,9 --pair 3-3 --format dot -o grid.dot
  requad-enumerate path --sides 8,8 --pair 3-3 --from 1,1 --to 5,1 -o result.obj
  requad-enumerate search --sides 6,6,6 --irregular 3,3,5
  requad-enumerate search --sides 12,12,12 --irregular 3,3,5 --journal run.journal --limit-seconds 3600
  requad-enumerate sphere --irregular 3,3,3,3,3,3,3,3 --vertices 8..20
  requad-enumerate signature bunny.obj
)";

PairType parse_pair(const std::string& text) {
  const auto type = theory::pair_type(text);
  if (!type) throw UsageError("--pair: '" + text + "' is not one of 3-3, 5-5, 3-5");
  return *type;
}

PairType parse_shape(const std::string& text) {
  static const std::map<std::string, PairType> kShapes{
      {"digon", theory::kDigon}, {"hexagon", theory::kHexagon}, {"quad", theory::kQuad}};
  const auto it = kShapes.find(text);
  if (it == kShapes.end()) throw UsageError("region: '" + text + "' is not one of digon, hexagon, quad");
  return it->second;
}

// The one configuration of the region that has this label.
Configuration find_configuration(const RegionShape& shape, const std::string& text, const char* option) {
  const PairType type = shape.type();
  const std::vector<std::int64_t> at = program::parse_integers(text, option);
  const bool third = type.has_third_index();
  const bool merged = type.symmetric() && at.size() >= 2 && at[0] == 0 && at[1] == 0;
  if (at.size() != (third ? 3U : 2U) && !(merged && at.size() == 2)) {
    throw UsageError(std::string(option) + ": '" + text + "' is not of the form " +
                     (third              ? "d1,d2,p"
                      : type.symmetric() ? "d1,d2"
                                         : "m,n"));
  }
  std::vector<Configuration> all = theory::parameter_set(shape);
  if (merged) all = theory::merged_configurations(shape);
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

PairType required_pair(const Options& options) {
  if (!options.has("pair")) throw UsageError("--pair is missing; expected 3-3, 5-5 or 3-5");
  return parse_pair(options.text("pair"));
}

// The region that --sides and --pair ask for.
RegionShape required_shape(const Options& options) {
  const PairType type = required_pair(options);
  if (!options.has("sides")) throw UsageError("--sides is missing; expected side lengths as in --sides 9,9");
  IntegerVector sides = theory::to_vector(program::parse_integers(options.text("sides"), "--sides"));
  if (const std::string problem = RegionShape::problem(type, sides); !problem.empty())
    throw UsageError("--sides: " + problem);
  RegionShape shape(type, std::move(sides));
  // What exploring would keep in memory: every configuration's mesh.
  constexpr double kMostQuads = 2e8;
  const auto longest = static_cast<double>(shape.longest());
  const double area = longest * longest / 2;
  const double configurations =
      longest > 20'000 ? longest * longest / 4 : static_cast<double>(theory::exact_count(shape));
  if (area * std::max(configurations, 1.0) > kMostQuads) {
    throw UsageError("--sides: about " + std::to_string(static_cast<std::int64_t>(configurations)) +
                     " configurations of some " + std::to_string(static_cast<std::int64_t>(area)) +
                     " quads are more than this command keeps in memory");
  }
  return shape;
}

// With the region that -o asks for, if it does.
void finish(const Options& options, const ordered_json& summary, const std::string& text,
            const mesh::Region* region = nullptr, const std::string& comment = "") {
  program::Outputs outputs;
  if (region != nullptr && options.has("output"))
    outputs.add(options.text("output"), mesh::obj_text(*region, {comment}));
  program::finish(options, summary.dump(), text, std::move(outputs));
}

std::vector<int> as_ints(const IntegerVector& v) { return {v.begin(), v.end()}; }

std::vector<int> as_ints(const std::vector<std::int64_t>& values, const char* what) {
  std::vector<int> result;
  for (const std::int64_t x : values) {
    if (x < 0 || x > 100'000) throw UsageError(std::string(what) + ": " + std::to_string(x) + " is not in 0..100000");
    result.push_back(static_cast<int>(x));
  }
  return result;
}

// --- region ----------------------------------------------------------------------------------------------------------

int region(const Options& options, const std::vector<std::string>& words) {
  options.allow_only("region", {"output", "generator"});
  if (words.size() != 4) throw UsageError("region: expected digon|hexagon|quad D1 D2 E1,E2,...");
  const PairType type = parse_shape(words[0]);
  Configuration c;
  c.parameters = {program::parse_integer(words[1], "D1"), program::parse_integer(words[2], "D2"),
                  theory::to_vector(program::parse_integers(words[3], "strip counts"))};
  if (const std::string problem = theory::parameters_problem(type, c.parameters); !problem.empty()) {
    throw UsageError("region: " + problem);
  }
  const IntegerVector sides = theory::region_sides(type, c);
  const std::string generator = options.text("generator", "glue");
  mesh::Region made;
  if (generator == "glue") {
    made = enumerate::glue_region(type, c);
  } else if (generator == "grow") {
    made = enumerate::grow_region(type, c);
  } else if (generator == "moves") {
    const RegionShape shape(type, sides);
    made = enumerate::realise(shape, enumerate::simplest_configuration(shape), c).region;
  } else {
    throw UsageError("--generator: '" + generator + "' is not one of glue, grow, moves");
  }
  const std::string signature = mesh::signature(made);
  const std::string text = "sides " + theory::joined(sides, " ") + "\nfaces " + std::to_string(made.mesh.face_count()) +
                           "\nvertices " + std::to_string(made.mesh.vertex_count()) + "\nsignature " + signature + "\n";
  finish(options,
         {{"pair", type.name()},
          {"sides", as_ints(sides)},
          {"faces", made.mesh.face_count()},
          {"vertices", made.mesh.vertex_count()},
          {"signature", signature}},
         text, &made,
         "region with a " + type.name() + " pair, parameters " + words[1] + " " + words[2] + " " + words[3]);
  return program::kDone;
}

// --- graph -----------------------------------------------------------------------------------------------------------

int graph(const Options& options) {
  options.allow_only("graph", {"sides", "pair", "with-apex", "format", "output"});
  const RegionShape shape = required_shape(options);
  const theory::Apex apex = options.has("with-apex") ? theory::Apex::with : theory::Apex::without;
  const std::string format = options.text("format", "json");
  if (format != "json" && format != "dot" && format != "graphml") {
    throw UsageError("--format: '" + format + "' is not one of json, dot, graphml");
  }
  const enumerate::Exploration found = enumerate::explore_all(shape, apex);
  program::Outputs outputs;
  if (options.has("json")) outputs.add(options.text("json"), enumerate::graph_json(found, apex).dump() + "\n");
  if (options.has("output") || !options.on_stdout("json")) {
    outputs.add(options.text("output", "-"), format == "dot"       ? enumerate::graph_dot(found, apex)
                                             : format == "graphml" ? enumerate::graph_graphml(found, apex)
                                                                   : enumerate::graph_json(found, apex).dump() + "\n");
  }
  outputs.commit();
  return program::kDone;
}

// --- path ------------------------------------------------------------------------------------------------------------

int path(const Options& options) {
  options.allow_only("path", {"sides", "pair", "from", "to", "output"});
  const RegionShape shape = required_shape(options);
  for (const char* end : {"from", "to"}) {
    if (!options.has(end))
      throw UsageError(std::string("--") + end + " is missing; expected a label as in --" + end + " 1,1");
  }
  const Configuration from = find_configuration(shape, options.text("from"), "--from");
  const Configuration to = find_configuration(shape, options.text("to"), "--to");
  const enumerate::Realisation made = enumerate::realise(shape, from, to);
  ordered_json json{{"sides", as_ints(shape.sides())},     {"pair", shape.type().name()},
                    {"path", ordered_json::array()},       {"moves", ordered_json::array()},
                    {"operations", ordered_json::array()}, {"signature", mesh::signature(made.region)}};
  std::string text;
  for (std::size_t i = 0; i < made.path.size(); ++i) {
    const std::string label = theory::label(shape.type(), made.path[i]);
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
  finish(options, json, text, &made.region,
         theory::label(shape.type(), to) + " reached from " + theory::label(shape.type(), from));
  return program::kDone;
}

// --- search ----------------------------------------------------------------------------------------------------------

std::vector<int> irregular_valences(const Options& options) {
  if (!options.has("irregular"))
    throw UsageError("--irregular is missing; expected valences as in --irregular 3,3,5, or '' for none");
  const std::string text = options.text("irregular");
  return text.empty() ? std::vector<int>{} : as_ints(program::parse_integers(text, "--irregular"), "--irregular");
}

enumerate::SearchLimits search_limits(const Options& options, program::Progress& progress) {
  enumerate::SearchLimits limits;
  limits.progress = [&progress](std::int64_t states) { progress.advance(states); };
  limits.threads = options.threads();
  if (options.has("limit-seconds"))
    limits.seconds = static_cast<double>(options.integer("limit-seconds", 0, 1, 10'000'000));
  if (options.has("max-faces"))
    limits.faces = static_cast<int>(options.integer("max-faces", 0, 1, enumerate::kMostFaces));
  return limits;
}

// The journal of a run whose result depends on this program and these words, and nothing else.
std::optional<enumerate::SearchJournal> search_journal(const Options& options, const std::string& words) {
  if (!options.has("journal")) return std::nullopt;
  return enumerate::SearchJournal{options.text("journal"),
                                  "requad-enumerate " + program::version_and_build(REQUAD_VERSION) + " " + words};
}

std::string lines_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

int search(const Options& options) {
  options.allow_only("search",
                     {"sides", "interior-quads", "irregular", "list", "limit-seconds", "max-faces", "journal"});
  if (options.has("sides") == options.has("interior-quads"))
    throw UsageError("search: expected either --sides or --interior-quads");
  enumerate::SearchProblem problem{{}, irregular_valences(options)};
  std::vector<int> sides;
  if (options.has("sides")) {
    sides = as_ints(program::parse_integers(options.text("sides"), "--sides"), "--sides");
    for (const int side : sides) {
      if (side < 1) throw UsageError("--sides: side " + std::to_string(side) + " is below 1");
    }
    problem = enumerate::search_problem(sides, std::move(problem.irregular));
  } else {
    problem.interior_quads =
        as_ints(program::parse_integers(options.text("interior-quads"), "--interior-quads"), "--interior-quads");
  }
  if (const std::string what = enumerate::problem_with(problem); !what.empty()) throw UsageError("search: " + what);
  program::Progress progress("states", 0, options.quiet());
  const enumerate::SearchLimits limits = search_limits(options, progress);
  if (enumerate::may_be_infinite(problem) && !limits.faces && !limits.seconds) {
    throw UsageError(
        "search: these valences can close a tube of any length, so there may be infinitely many fillings; give "
        "--max-faces or --limit-seconds");
  }
  std::string words = (sides.empty() ? "search, interior quads " + theory::joined(problem.interior_quads, ",")
                                     : "search, sides " + theory::joined(sides, ",")) +
                      "; irregular " + theory::joined(problem.irregular, ",");
  if (limits.faces) words += "; faces up to " + std::to_string(*limits.faces);
  if (options.has("list")) words += "; with signatures";
  const enumerate::CountedSearch found =
      enumerate::count_fillings(problem, limits, options.has("list"), search_journal(options, words));
  progress.finish();
  const bool complete = found.outcome.complete();

  ordered_json json{{"sides", sides}, {"irregular", problem.irregular}};
  if (!options.has("sides")) json["interior_quads"] = problem.interior_quads;
  // A limit gives no count, only a lower bound; up to a face limit the numbers by faces are exact all the same.
  json["count"] = complete ? ordered_json(found.outcome.count) : ordered_json(nullptr);
  if (!complete) json["at_least"] = found.outcome.count;
  json["complete"] = complete;
  json["by_faces"] = ordered_json::object();
  for (const auto& [faces, count] : found.outcome.by_faces) json["by_faces"][std::to_string(faces)] = count;
  json["orbits"] = complete
                       ? ordered_json{{"rotations", found.orbits.rotations}, {"reflections", found.orbits.reflections}}
                       : ordered_json(nullptr);
  json["states"] = found.outcome.states;
  if (options.has("list")) json["fillings"] = found.signatures;

  std::string text = complete ? "count " + std::to_string(found.outcome.count) + "\n"
                              : "undecided: at least " + std::to_string(found.outcome.count) + "\n";
  for (const auto& [faces, count] : found.outcome.by_faces)
    text += std::to_string(faces) + " faces: " + std::to_string(count) + "\n";
  if (complete) {
    text += "up to rotations " + std::to_string(found.orbits.rotations) + ", and reflections " +
            std::to_string(found.orbits.reflections) + "\n";
  }
  finish(options, json, text + lines_of(found.signatures));
  return complete ? program::kDone : program::kUndecided;
}

int sphere(const Options& options) {
  options.allow_only("sphere", {"irregular", "vertices", "list", "limit-seconds", "journal"});
  if (!options.has("vertices")) throw UsageError("--vertices is missing; expected a range as in --vertices 8..20");
  const program::Range range = program::parse_range(options.text("vertices"), "--vertices");
  if (range.first < 4 || range.last > enumerate::kMostFaces) {
    throw UsageError("--vertices: " + options.text("vertices") + " is not within 4.." +
                     std::to_string(enumerate::kMostFaces));
  }
  const std::vector<int> irregular = irregular_valences(options);
  program::Progress progress("states", 0, options.quiet());
  const std::string words =
      "sphere, irregular " + theory::joined(irregular, ",") + "; vertices up to " + std::to_string(range.last);
  const enumerate::SphereOutcome found = enumerate::search_spheres(
      irregular, static_cast<int>(range.last), search_limits(options, progress), search_journal(options, words));
  progress.finish();
  const auto in_range = [&](const std::map<int, std::int64_t>& counts) {
    ordered_json json = ordered_json::object();
    for (auto v = range.first; v <= range.last; ++v) {
      const auto it = counts.find(static_cast<int>(v));
      json[std::to_string(v)] = it == counts.end() ? 0 : it->second;
    }
    return json;
  };
  const ordered_json counts = in_range(found.counts), oriented = in_range(found.oriented_counts);
  ordered_json json{{"irregular", irregular},
                    {"counts", counts},
                    {"oriented_counts", oriented},
                    {"complete", found.complete},
                    {"states", found.states}};
  if (!found.complete) json["counts"] = nullptr, json["oriented_counts"] = nullptr, json["at_least"] = counts;
  if (options.has("list")) json["spheres"] = found.signatures;
  std::string text = found.complete ? "" : "undecided: at least\n";
  for (const auto& [v, count] : counts.items()) {
    text += v + " vertices: " + count.dump() + " (" + oriented[v].dump() + " if mirror images differ)\n";
  }
  finish(options, json, options.has("list") ? text + lines_of(found.signatures) : text);
  return found.complete ? program::kDone : program::kUndecided;
}

// The signature of a mesh in a file, which is connected but else as it may be.
int file_signature(const Options& options, const std::string& path) {
  options.allow_only("signature FILE", {"subdivide"});
  const mesh::QuadMesh m = mesh::read_surface(path, options.has("subdivide")).mesh;
  if (const int components = mesh::component_count(m); components != 1) {
    throw UsageError(path + ": the mesh has " + std::to_string(components) + " components; a signature names one");
  }
  const std::string kept = mesh::canonical_signature(m),
                    mirrored = mesh::canonical_signature(m, mesh::Orientation::mirrored);
  const std::string& canonical = std::min(kept, mirrored);
  const bool open = mesh::boundary_loop_count(m) > 0;
  finish(options,
         {{"vertices", m.vertex_count()},
          {"faces", m.face_count()},
          {"closed", !open},
          {"canonical", canonical},
          {"oriented", kept},
          {"chiral", kept != mirrored}},
         canonical + "\n");
  return program::kDone;
}

int signature(const Options& options, const std::vector<std::string>& words) {
  if (words.size() > 1 || words.empty() != options.has("from-signature")) {
    throw UsageError("signature: expected either a mesh file or --from-signature");
  }
  if (!words.empty()) return file_signature(options, words.front());
  options.allow_only("signature", {"from-signature", "output"});
  const mesh::Region rebuilt = mesh::from_signature(options.text("from-signature"));
  const bool open = mesh::boundary_loop_count(rebuilt.mesh) > 0;
  if (options.has("output")) {
    if (const std::string problem = mesh::region_problem(rebuilt); !problem.empty())
      throw UsageError("signature: no drawing, since " + problem);
  }
  const std::string canonical = std::min(mesh::canonical_signature(rebuilt.mesh),
                                         mesh::canonical_signature(rebuilt.mesh, mesh::Orientation::mirrored));
  finish(options,
         {{"vertices", rebuilt.mesh.vertex_count()},
          {"faces", rebuilt.mesh.face_count()},
          {"closed", !open},
          {"canonical", canonical}},
         "vertices " + std::to_string(rebuilt.mesh.vertex_count()) + "\nfaces " +
             std::to_string(rebuilt.mesh.face_count()) + "\ncanonical " + canonical + "\n",
         &rebuilt, "rebuilt from its signature");
  return program::kDone;
}

int main_body(int argc, char** argv) {
  const Options options(argc, argv,
                        {{"with-apex", "list", "subdivide"},
                         {"generator", "sides", "interior-quads", "pair", "format", "from", "to", "irregular",
                          "vertices", "limit-seconds", "max-faces", "journal", "from-signature"},
                         {},
                         {"output,o"}});
  if (program::answered(options, "requad-enumerate", REQUAD_VERSION, kHelp)) return program::kDone;
  options.require_outputs();
  std::vector<std::string> words = options.words();
  if (words.empty()) throw UsageError("expected one of region, graph, path, search, sphere, signature; see --help");
  const std::string command = words.front();
  words.erase(words.begin());
  if (command == "region") return region(options, words);
  if (command == "signature") return signature(options, words);
  if (!words.empty()) throw UsageError(command + ": unexpected argument '" + words.front() + "'; see --help");
  if (command == "graph") return graph(options);
  if (command == "path") return path(options);
  if (command == "search") return search(options);
  if (command == "sphere") return sphere(options);
  throw UsageError("'" + command + "' is not one of region, graph, path, search, sphere, signature; see --help");
}

}  // namespace

int main(int argc, char** argv) {
  return program::run("requad-enumerate", [argc, argv] { return main_body(argc, argv); });
}
