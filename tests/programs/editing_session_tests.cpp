// Random editing sessions: requad-edit edits real meshes, step by step, as a user would. Each mesh that it writes is read
// and judged by means written apart from the library, and each prediction of `moves` and `atomic` is compared with what
// the edit did, measured on the written mesh.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/sanitizers.hpp"

using namespace requad::tests;

namespace {

// --- a mesh as a list of faces ---------------------------------------------------------------------------------------

struct FaceListMesh {
  std::vector<std::string> positions;      // the text after "v"
  std::vector<std::array<int, 4>> faces;   // vertices from 0
  std::map<std::array<int, 2>, int> side;  // the face on the left of each directed edge
  std::vector<std::set<int>> neighbours;   // of each vertex
  std::vector<bool> on_boundary;

  int valence(int v) const { return static_cast<int>(neighbours[static_cast<std::size_t>(v)].size()); }
  bool joined(int a, int b) const { return neighbours[static_cast<std::size_t>(a)].count(b) > 0; }
};

// Reads an OBJ file of quads. Sets `problem` if it is not a simple manifold mesh whose faces are oriented alike.
FaceListMesh read_obj(const std::filesystem::path& path, std::string& problem) {
  FaceListMesh m;
  const auto note = [&problem](const std::string& what) {
    if (problem.empty()) problem = what;
  };
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    if (line.rfind("v ", 0) == 0) m.positions.push_back(line.substr(2));
    if (line.rfind("f ", 0) != 0) continue;
    std::istringstream words(line.substr(2));
    std::vector<int> corners;
    for (std::string word; words >> word;) corners.push_back(std::atoi(word.c_str()) - 1);
    if (corners.size() != 4) {
      note("a face is no quad: " + line);
      return m;
    }
    m.faces.push_back({corners[0], corners[1], corners[2], corners[3]});
  }
  const std::size_t n = m.positions.size();
  m.neighbours.resize(n);
  m.on_boundary.resize(n);
  std::vector<int> faces_at(n);
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    const std::set<int> different(m.faces[f].begin(), m.faces[f].end());
    if (different.size() != 4 || *different.begin() < 0 || *different.rbegin() >= static_cast<int>(n))
      note("a face does not have four vertices");
    if (!problem.empty()) return m;
    for (std::size_t k = 0; k < 4; ++k) {
      const int a = m.faces[f][k], b = m.faces[f][(k + 1) % 4];
      if (!m.side.emplace(std::array{a, b}, static_cast<int>(f)).second) note("an edge has two faces on one side");
      m.neighbours[static_cast<std::size_t>(a)].insert(b);
      m.neighbours[static_cast<std::size_t>(b)].insert(a);
      ++faces_at[static_cast<std::size_t>(a)];
    }
  }
  std::vector<int> ends(n);  // boundary edges at each vertex
  for (const auto& [edge, face] : m.side) {
    if (m.side.count({edge[1], edge[0]}) > 0) continue;
    for (const int v : edge) {
      m.on_boundary[static_cast<std::size_t>(v)] = true;
      ++ends[static_cast<std::size_t>(v)];
    }
  }
  for (std::size_t v = 0; v < n; ++v) {
    // One fan: as many edges as faces, one more on the boundary, which passes once. (Two fans that touch in an interior
    // vertex would share no edge: then a walk round it would not meet all faces.)
    if (faces_at[v] == 0) note("a vertex has no face");
    if (ends[v] != 0 && ends[v] != 2) note("the boundary passes a vertex twice");
    if (static_cast<int>(m.neighbours[v].size()) != faces_at[v] + (ends[v] > 0 ? 1 : 0))
      note("two edges join two vertices");
  }
  for (std::size_t v = 0; v < n && problem.empty(); ++v) {
    if (m.on_boundary[v]) continue;
    // From one neighbour to the next one round the vertex.
    const int first = *m.neighbours[v].begin();
    int at = first, turns = 0;
    do {
      const auto& face = m.faces[static_cast<std::size_t>(m.side.at({static_cast<int>(v), at}))];
      const auto place = std::find(face.begin(), face.end(), static_cast<int>(v)) - face.begin();
      at = face[static_cast<std::size_t>((place + 3) % 4)];
      ++turns;
    } while (at != first && turns <= faces_at[v]);
    if (turns != faces_at[v]) note("the faces at a vertex are no fan");
  }
  return m;
}

int euler_characteristic(const FaceListMesh& m) {
  std::size_t edges = 0;
  for (const std::set<int>& around : m.neighbours) edges += around.size();
  return static_cast<int>(m.positions.size()) - static_cast<int>(edges / 2) + static_cast<int>(m.faces.size());
}

std::multiset<int> valences(const FaceListMesh& m) {
  std::multiset<int> result;
  for (std::size_t v = 0; v < m.positions.size(); ++v) result.insert(m.valence(static_cast<int>(v)));
  return result;
}

std::multiset<std::string> boundary(const FaceListMesh& m) {
  std::multiset<std::string> result;
  for (const auto& [edge, face] : m.side) {
    if (m.side.count({edge[1], edge[0]}) > 0) continue;
    result.insert(m.positions[static_cast<std::size_t>(edge[0])] + " | " +
                  m.positions[static_cast<std::size_t>(edge[1])]);
  }
  return result;
}

// --- sessions --------------------------------------------------------------------------------------------------------

struct Figures {
  int sessions = 0, edits = 0, refused = 0, moves = 0, atomic = 0;
};

class Session {
 public:
  Session(const std::string& path, unsigned seed, Figures& figures) : random_(seed), figures_(figures) {
    std::filesystem::copy_file(path, scratch() / "in.obj", std::filesystem::copy_options::overwrite_existing);
    mesh_ = read("in.obj");
    euler_ = euler_characteristic(mesh_);
    boundary_ = boundary(mesh_);
    choose_features();
    ++figures_.sessions;
  }

  void run(int steps) {
    for (int i = 0; i < steps; ++i) {
      INFO("step " << i);
      if (chosen(2) == 0) {
        move();
      } else {
        make_atomic();
      }
    }
  }

 private:
  int chosen(std::size_t among) { return static_cast<int>(random_() % among); }

  static FaceListMesh read(const std::string& name) {
    std::string problem;
    FaceListMesh m = read_obj(scratch() / name, problem);
    REQUIRE(problem == "");
    return m;
  }

  // Some interior edges, by the positions of their ends.
  void choose_features() {
    const int wanted = chosen(3) == 0 ? 0 : chosen(20);
    std::vector<std::array<int, 2>> edges;
    for (const auto& [edge, face] : mesh_.side) {
      if (edge[0] < edge[1] && mesh_.side.count({edge[1], edge[0]}) > 0) edges.push_back(edge);
    }
    for (int i = 0; i < wanted; ++i) {
      const auto& edge = edges[static_cast<std::size_t>(chosen(edges.size()))];
      features_.insert(
          {mesh_.positions[static_cast<std::size_t>(edge[0])], mesh_.positions[static_cast<std::size_t>(edge[1])]});
    }
  }

  std::map<std::string, int> vertex_at() const {
    std::map<std::string, int> result;
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) result[mesh_.positions[v]] = static_cast<int>(v);
    return result;
  }

  // The option that names the features in the present mesh.
  std::string feature_option() const {
    if (features_.empty()) return "";
    const auto at = vertex_at();
    std::string text;
    for (const auto& [a, b] : features_)
      text += std::to_string(at.at(a) + 1) + " " + std::to_string(at.at(b) + 1) + "\n";
    spill(scratch() / "features.txt", text);
    return " --features features.txt";
  }

  int irregular_vertex() {
    std::vector<int> list;
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
      if (!mesh_.on_boundary[v] && mesh_.valence(static_cast<int>(v)) != 4) list.push_back(static_cast<int>(v));
    }
    return list.empty() ? -1 : list[static_cast<std::size_t>(chosen(list.size()))];
  }

  // Reads the mesh that an edit wrote and checks what every edit keeps. The edit must have moved nothing on the boundary
  // and no feature.
  FaceListMesh written() const {
    FaceListMesh after = read("out.obj");
    REQUIRE(euler_characteristic(after) == euler_);
    REQUIRE(boundary(after) == boundary_);
    std::map<std::string, int> at;
    for (std::size_t v = 0; v < after.positions.size(); ++v) at[after.positions[v]] = static_cast<int>(v);
    for (const auto& [a, b] : features_) {
      INFO("feature " << a << " | " << b);
      REQUIRE(at.count(a) == 1);
      REQUIRE(at.count(b) == 1);
      REQUIRE(after.joined(at[a], at[b]));
    }
    return after;
  }

  // Calls requad-edit. Returns whether it wrote a mesh.
  static bool edits(const std::string& arguments, bool expected) {
    std::filesystem::remove(scratch() / "out.obj");
    const Outcome outcome = call("edit", arguments);
    INFO("requad-edit " << arguments << ": " << outcome.err);
    REQUIRE(outcome.code == (expected ? 0 : 1));
    REQUIRE(std::filesystem::exists(scratch() / "out.obj") == expected);
    if (!expected) REQUIRE(line_count(outcome.err) == 1);
    return expected;
  }

  // One of the listed edits, chosen at random; null if the listing is refused or empty.
  nlohmann::json one_of(const std::string& listing, const char* key) {
    const Outcome outcome = call("edit", listing + " --json - --quiet");
    INFO("requad-edit " << listing << ": " << outcome.err);
    REQUIRE((outcome.code == 0 || outcome.code == 1));
    if (outcome.code != 0) return {};
    const nlohmann::json list = nlohmann::json::parse(outcome.out)[key];
    return list.empty() ? nlohmann::json() : list[static_cast<std::size_t>(chosen(list.size()))];
  }

  void accept(FaceListMesh after) {
    mesh_ = std::move(after);
    std::filesystem::rename(scratch() / "out.obj", scratch() / "in.obj");
    ++figures_.edits;
  }

  void move() {
    const int a = irregular_vertex(), b = irregular_vertex();
    if (a < 0 || b < 0) return;
    const std::string pair = " in.obj " + std::to_string(a + 1) + " " + std::to_string(b + 1);
    const std::string features = feature_option();
    const nlohmann::json move = one_of("moves" + pair + features, "moves");
    if (move.is_null()) return;
    const std::string name = move["name"];
    if (!edits("move" + pair + " --step '" + name + "' --smooth 0 -o out.obj --quiet" + features, move["legal"])) {
      ++figures_.refused;
      return;
    }
    FaceListMesh after = written();
    const int gained = static_cast<int>(after.faces.size()) - static_cast<int>(mesh_.faces.size());
    REQUIRE(gained == move["faces"].get<int>());
    REQUIRE(gained == move["faces_made"].get<int>() - move["faces_deleted"].get<int>());
    for (const nlohmann::json& vertex : move["vertices"]) {
      if (vertex["after"].is_null()) continue;
      const int now = vertex["after"].get<int>() - 1;
      REQUIRE(now < static_cast<int>(after.positions.size()));
      const bool fixed = after.on_boundary[static_cast<std::size_t>(now)] || !features_.empty();
      if (!fixed) REQUIRE(after.valence(now) != 4);
    }
    ++figures_.moves;
    accept(std::move(after));
  }

  void make_atomic() {
    int v = irregular_vertex();
    if (v < 0 || chosen(3) == 0) v = chosen(mesh_.positions.size());
    const std::string site = " in.obj " + std::to_string(v + 1);
    const std::string features = feature_option();
    const nlohmann::json operation = one_of("atomic" + site + features, "operations");
    if (operation.is_null()) return;
    const std::string from = std::to_string(operation["from"].get<int>()),
                      to = std::to_string(operation["to"].get<int>());
    const std::string name = operation["operation"];
    if (!edits("atomic in.obj " + from + " " + to + " --make '" + name + "' --smooth 0 -o out.obj --quiet" + features,
               operation["legal"])) {
      ++figures_.refused;
      return;
    }
    FaceListMesh after = written();
    // The valences that the listing predicts.
    std::multiset<int> expected = valences(mesh_);
    for (const nlohmann::json& change : operation["valences"]) {
      if (!change["before"].is_null()) {
        REQUIRE(mesh_.valence(change["vertex"].get<int>() - 1) == change["before"].get<int>());
        expected.erase(expected.find(change["before"].get<int>()));
      }
      if (!change["after"].is_null()) expected.insert(change["after"].get<int>());
    }
    INFO("atomic " << from << " " << to << " " << name << " predicts " << operation["valences"].dump());
    REQUIRE(valences(after) == expected);
    ++figures_.atomic;
    accept(std::move(after));
  }

  std::mt19937 random_;
  Figures& figures_;
  FaceListMesh mesh_;
  int euler_ = 0;
  std::multiset<std::string> boundary_;
  std::set<std::pair<std::string, std::string>> features_;
};

void run_sessions(int sessions, int steps) {
  const std::vector<std::string> names{"hole_capsule", "pawn", "fandisk_bommes", "bigguy", "botijo_miq"};
  Figures figures;
  for (int i = 0; i < sessions; ++i) {
    const auto path = real_mesh(names[static_cast<std::size_t>(i) % names.size()]);
    if (!path) return;
    INFO("session " << i << " on " << *path);
    Session(*path, static_cast<unsigned>(i), figures).run(steps);
  }
  WARN(figures.sessions << " sessions: " << figures.edits << " edits (" << figures.moves << " moves, " << figures.atomic
                        << " atomic operations), " << figures.refused << " refused as predicted");
  CHECK(figures.moves > sessions / 10);
  CHECK(figures.atomic > sessions);
}

}  // namespace

TEST_CASE("the sessions' own validator sees what is wrong with a mesh", "[programs][sessions]") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 3 1 0\nv 3 2 0\nv 2 2 0\n";
  const auto problem_of = [](const std::string& text) {
    spill(scratch() / "validated.obj", text);
    std::string problem;
    read_obj(scratch() / "validated.obj", problem);
    return problem;
  };
  const std::string six = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n";
  CHECK(problem_of(six + "f 1 2 3 4\nf 2 5 6 3\n") == "");
  CHECK(problem_of(six + "f 1 2 3 4\nf 3 6 5 2\n") == "an edge has two faces on one side");  // turned over
  CHECK(problem_of(six + "f 1 2 3 4\nf 2 5 6 3\nf 2 5 6 3\n") == "an edge has two faces on one side");
  CHECK(problem_of(six + "f 1 2 3 4\n") == "a vertex has no face");
  CHECK(problem_of(six + "f 1 2 3 3\nf 2 5 6 3\n") == "a face does not have four vertices");
  CHECK(problem_of(six + "f 1 2 3 4\nf 2 5 6\n") == "a face is no quad: f 2 5 6");
  CHECK(problem_of(vertices + "f 1 2 3 4\nf 2 5 6 3\nf 6 7 8 9\n") == "the boundary passes a vertex twice");
  // Two spheres of two quads that have a vertex in common.
  CHECK(problem_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 3 0 0\n"
                   "f 1 2 3 4\nf 4 3 2 1\nf 1 5 6 7\nf 7 6 5 1\n") == "the faces at a vertex are no fan");
}

TEST_CASE("random editing sessions on real meshes do what is predicted", "[programs][sessions]") {
  run_sessions(kSanitized ? 8 : 40, 5);
}

TEST_CASE("ten thousand random editing sessions on real meshes do what is predicted", "[.long][sessions]") {
  run_sessions(10'000, 5);
}
