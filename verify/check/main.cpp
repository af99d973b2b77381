// requad-verify-check: checks certificates again. `requad-verify check DIR` starts it.
//
// This program shares no code with the programs that make certificates. It has a parser of its own, a mesh that is a
// list of faces, its own validation, operations that follow their definitions, and its own comparison of meshes. It
// uses the C++ standard library and nothing else. verify/certificate.hpp describes the format. For each region it
// checks that
//   - every mesh is a quadrangulated disk, simple and manifold, with the sides that are claimed, and its irregular
//     vertices are the pair, or the merged vertex;
//   - no two meshes are isomorphic by a map that fixes the boundary;
//   - every operation of every script is legal and keeps the boundary, and the script leads to the mesh that it names;
//   - the numbers of configurations and edges are as claimed, the edges connect all configurations, no edge is given
//     twice, and for a regular digon or hexagon the number of configurations is tau(L).
// Exit code: 0 all certificates hold, 1 one does not hold, 2 undecided: one cannot be read, or memory ran out.

#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <map>
#include <new>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Face = std::array<int, 4>;
using Faces = std::vector<Face>;

// A certificate does not hold. The message says what is wrong.
class Rejected : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void require(bool holds, const std::string& problem) {
  if (!holds) throw Rejected(problem);
}

// --- meshes ----------------------------------------------------------------------------------------------------------

// The face and the corner of each directed edge, by its two vertices.
std::map<std::array<int, 2>, std::array<std::size_t, 2>> directed_edges(const Faces& faces) {
  std::map<std::array<int, 2>, std::array<std::size_t, 2>> edges;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 4; ++k) {
      const int a = faces[f][k], b = faces[f][(k + 1) % 4];
      require(a != b && a != faces[f][(k + 2) % 4], "a face has one vertex twice");
      require(edges.emplace(std::array{a, b}, std::array{f, k}).second, "an edge is used twice in one direction");
    }
  }
  return edges;
}

struct Boundary {
  std::vector<int> sides;
  int length() const {
    int sum = 0;
    for (const int s : sides) sum += s;
    return sum;
  }
  // The number of faces at each boundary vertex: one at the start of a side, two elsewhere.
  std::vector<int> faces() const {
    std::vector<int> result;
    for (const int s : sides) {
      result.push_back(1);
      result.insert(result.end(), static_cast<std::size_t>(s - 1), 2);
    }
    return result;
  }
};

// Requires a simple manifold disk with this boundary. Returns the valences of the irregular interior vertices, sorted.
std::vector<int> check_disk(const Faces& faces, const Boundary& boundary) {
  const auto edges = directed_edges(faces);
  const int n = boundary.length();
  std::map<int, int> degree;  // faces at each vertex
  for (const Face& f : faces) {
    for (const int v : f) ++degree[v];
  }
  std::size_t boundary_edges = 0;
  for (const auto& [edge, corner] : edges) {
    if (edges.count({edge[1], edge[0]}) > 0) continue;
    ++boundary_edges;
    require(edge[0] >= 0 && edge[0] < n && edge[1] == (edge[0] + 1) % n, "the boundary is not 0, 1, 2, ...");
  }
  require(boundary_edges == static_cast<std::size_t>(n), "the boundary has a wrong length");
  // The faces at each vertex must form one fan: going round the vertex once must meet all of them.
  const std::vector<int> wanted = boundary.faces();
  std::vector<int> irregular;
  std::map<int, int> start;  // a neighbour of the vertex; of a boundary vertex the next one on the boundary
  for (const auto& [edge, corner] : edges) {
    if (start.count(edge[0]) == 0 || edges.count({edge[1], edge[0]}) == 0) start[edge[0]] = edge[1];
  }
  for (const auto& [v, count] : degree) {
    int met = 0;
    int to = start[v];
    do {
      const auto it = edges.find({v, to});
      if (it == edges.end()) break;
      ++met;
      to = faces[it->second[0]][(it->second[1] + 3) % 4];  // the next edge counter-clockwise
    } while (to != start[v]);
    require(met == count, "the faces at a vertex are not one fan");
    if (v < n) {
      require(count == wanted[static_cast<std::size_t>(v)], "a boundary vertex has a wrong number of faces");
    } else if (count != 4) {
      irregular.push_back(count);
    }
  }
  const auto edge_count = (edges.size() + boundary_edges) / 2;
  require(degree.size() + faces.size() == edge_count + 1, "the mesh is no disk");
  // The mesh is connected: all faces are reached from the first one, over common edges.
  std::set<std::size_t> reached{0};
  std::vector<std::size_t> stack{0};
  while (!stack.empty()) {
    const Face f = faces[stack.back()];
    stack.pop_back();
    for (std::size_t k = 0; k < 4; ++k) {
      const auto it = edges.find({f[(k + 1) % 4], f[k]});
      if (it != edges.end() && reached.insert(it->second[0]).second) stack.push_back(it->second[0]);
    }
  }
  require(reached.size() == faces.size(), "the mesh falls apart");
  std::sort(irregular.begin(), irregular.end());
  return irregular;
}

// The faces, with the interior vertices renamed in the order in which a breadth-first search from the boundary edge
// 0 -> 1 meets them. Two meshes have equal forms iff they are isomorphic by a map that fixes the boundary.
std::vector<int> form(const Faces& faces, int boundary_length) {
  const auto edges = directed_edges(faces);
  std::map<int, int> name;
  for (int v = 0; v < boundary_length; ++v) name[v] = v;
  std::vector<int> result;
  std::set<std::size_t> met;
  std::vector<std::array<int, 2>> queue{{0, 1}};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const auto it = edges.find(queue[i]);
    if (it == edges.end() || !met.insert(it->second[0]).second) continue;
    const Face& f = faces[it->second[0]];
    for (std::size_t k = 0; k < 4; ++k) {
      const int v = f[(it->second[1] + k) % 4], w = f[(it->second[1] + k + 1) % 4];
      result.push_back(name.emplace(v, static_cast<int>(name.size())).first->second);
      queue.push_back({w, v});  // the face across
    }
  }
  return result;
}

// --- operations ------------------------------------------------------------------------------------------------------

Face turned(const Face& f, std::size_t k) { return {f[k], f[(k + 1) % 4], f[(k + 2) % 4], f[(k + 3) % 4]}; }

void flip(Faces& faces, int u, int v, int x, int y) {
  const auto edges = directed_edges(faces);
  const auto one = edges.find({u, v}), two = edges.find({v, u});
  require(one != edges.end() && two != edges.end(), "flip: there is no such inner edge");
  const Face f = turned(faces[one->second[0]], one->second[1]);  // u v p q
  const Face g = turned(faces[two->second[0]], two->second[1]);  // v u r s
  const int p = f[2], q = f[3], r = g[2], s = g[3];
  const std::set<int> ends{x, y};
  if (ends == std::set<int>{r, p}) {
    faces[one->second[0]] = {u, r, p, q};
    faces[two->second[0]] = {r, s, v, p};
  } else {
    require(ends == std::set<int>{s, q}, "flip: the new edge is no diagonal of the hexagon");
    faces[one->second[0]] = {s, v, p, q};
    faces[two->second[0]] = {q, u, r, s};
  }
}

void collapse(Faces& faces, int a, int b, int c, int d) {
  const auto edges = directed_edges(faces);
  const auto it = edges.find({a, b});
  require(it != edges.end() && turned(faces[it->second[0]], it->second[1]) == Face{a, b, c, d},
          "collapse: there is no such face");
  faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(it->second[0]));
  for (Face& f : faces) std::replace(f.begin(), f.end(), c, a);
}

void split(Faces& faces, int v, int a, int b, int w) {
  const auto edges = directed_edges(faces);
  int to = a;
  for (;;) {
    const auto it = edges.find({v, to});
    require(it != edges.end(), "split: the two edges bound no sector");
    Face& f = faces[it->second[0]];
    to = f[(it->second[1] + 3) % 4];
    std::replace(f.begin(), f.end(), v, w);
    if (to == b) break;
    require(to != a, "split: the two edges bound no sector");
  }
  faces.push_back({v, a, w, b});
}

// --- certificates ----------------------------------------------------------------------------------------------------

// The lines of a certificate, split into words.
class Lines {
 public:
  explicit Lines(std::istream& in) : in_(in) {}
  // The next line. It must start with the word `first`, unless that is "", and have `words` words, unless that is 0.
  std::vector<std::string> next(const std::string& first, std::size_t words) {
    std::string line;
    require(static_cast<bool>(std::getline(in_, line)), "the file ends too early");
    ++number_;
    std::vector<std::string> result;
    std::istringstream split(line);
    for (std::string word; split >> word;) result.push_back(word);
    require(words == 0 || result.size() == words, "a line has a wrong number of words");
    require(!result.empty() && (first.empty() || result[0] == first), "expected '" + first + "'");
    return result;
  }
  // Requires that no line is left.
  void finish() {
    std::string rest;
    require(!std::getline(in_, rest), "the file goes on after 'end'");
  }
  int number() const { return number_; }

 private:
  std::istream& in_;
  int number_ = 0;
};

// A decimal number of at most seven digits and nothing else.
int number(const std::string& word) {
  require(!word.empty() && word.size() <= 7 &&
              std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; }) &&
              (word == "0" || word[0] != '0'),
          "'" + word + "' is no number");
  return std::stoi(word);
}

long long tau(int length) {
  const long long n = length / 2;
  return length % 2 == 0 ? n * (n - 1) : n * n;
}

void check(Lines& lines) {
  const auto title = lines.next("requad", 3);
  require(title[1] == "certificate" && title[2] == "1", "not a certificate of version 1");
  const std::string pair = lines.next("pair", 2)[1];
  const std::map<std::string, std::vector<int>> known{{"3-3", {3, 3}}, {"5-5", {5, 5}}, {"3-5", {3, 5}}};
  require(known.count(pair) > 0, "unknown pair");
  const std::vector<int>& valences = known.at(pair);
  const int side_count = valences[0] + valences[1] - 4;
  Boundary boundary;
  const auto sides = lines.next("sides", static_cast<std::size_t>(side_count) + 1);
  for (std::size_t i = 1; i < sides.size(); ++i) boundary.sides.push_back(number(sides[i]));
  for (const int s : boundary.sides) require(s > 0, "a side is 0");
  const int configurations = number(lines.next("configurations", 2)[1]);
  const int merged = number(lines.next("merged", 2)[1]);
  const int edge_total = number(lines.next("edges", 2)[1]);
  if (pair != "3-5" && std::set<int>(boundary.sides.begin(), boundary.sides.end()).size() == 1) {
    require(configurations == (pair == "5-5" ? 3 : 1) * tau(boundary.sides[0]),
            "the number of configurations is not tau(L)");
  }

  const int total = configurations + merged;
  require(total > 0, "no configuration");
  std::vector<Faces> meshes;
  std::vector<int> vertex_counts;
  std::map<std::vector<int>, int> seen;
  std::set<std::string> labels;
  int pairs = 0;
  for (int i = 0; i < total; ++i) {
    const auto head = lines.next("mesh", 8);
    require(number(head[1]) == i && head[4] == "vertices" && head[6] == "faces", "a mesh has a wrong head");
    require(head[2] == "pair" || head[2] == "merged", "a mesh neither holds the pair nor is merged");
    require(labels.insert(head[3]).second, "two meshes have one label");
    pairs += head[2] == "pair" ? 1 : 0;
    Faces faces;
    std::set<int> vertices;
    for (int f = number(head[7]); f > 0; --f) {
      const auto words = lines.next("", 4);
      faces.push_back({number(words[0]), number(words[1]), number(words[2]), number(words[3])});
      vertices.insert(faces.back().begin(), faces.back().end());
    }
    require(!faces.empty(), "a mesh has no face");
    const int count = number(head[5]);
    require(static_cast<int>(vertices.size()) == count && *vertices.rbegin() == count - 1,
            "the vertices are not 0, 1, ..., as many as claimed");
    vertex_counts.push_back(count);
    const std::vector<int> expected = head[2] == "pair" ? valences : std::vector<int>{side_count};
    require(check_disk(faces, boundary) == expected, "the irregular vertices are not those claimed");
    require(seen.emplace(form(faces, boundary.length()), i).second, "two meshes are the same");
    meshes.push_back(std::move(faces));
  }
  require(pairs == configurations, "not as many meshes hold the pair as claimed");

  std::vector<int> group(meshes.size());
  for (std::size_t i = 0; i < group.size(); ++i) group[i] = static_cast<int>(i);
  std::set<std::string> edges;
  for (int e = 0; e < edge_total; ++e) {
    const auto head = lines.next("edge", 7);
    const int from = number(head[1]), to = number(head[2]);
    require(from < total && to < total && head[3] == "step" && head[5] == "operations", "an edge has a wrong head");
    Faces faces = meshes[static_cast<std::size_t>(from)];
    int next_vertex = vertex_counts[static_cast<std::size_t>(from)];
    require(edges.insert(head[1] + " " + head[2] + " " + head[4]).second, "an edge is given twice");
    for (int i = number(head[6]); i > 0; --i) {
      const auto words = lines.next("", 5);
      const int a = number(words[1]), b = number(words[2]), c = number(words[3]), d = number(words[4]);
      if (words[0] == "flip") {
        flip(faces, a, b, c, d);
      } else if (words[0] == "collapse") {
        collapse(faces, a, b, c, d);
      } else {
        require(words[0] == "split", "unknown operation");
        require(d == next_vertex++, "split: the new vertex does not have the next number");
        split(faces, a, b, c, d);
      }
      check_disk(faces, boundary);
    }
    require(form(faces, boundary.length()) == form(meshes[static_cast<std::size_t>(to)], boundary.length()),
            "a script leads to another mesh");
    const int old = group[static_cast<std::size_t>(to)], now = group[static_cast<std::size_t>(from)];
    std::replace(group.begin(), group.end(), old, now);
  }
  require(std::set<int>(group.begin(), group.end()).size() == 1, "the configurations are not connected by the edges");
  lines.next("end", 1);
  lines.finish();
}

// Prints exactly one line on standard error, even if names of files contain line breaks.
void report(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = '?';
  }
  std::cerr << "requad-verify-check: " << text << "\n";
}

constexpr int kHolds = 0, kDoesNotHold = 1, kUndecided = 2;

int check_folder(const std::string& folder) {
  std::ifstream manifest(folder + "/MANIFEST");
  if (!manifest) {
    report(folder + "/MANIFEST cannot be read");
    return kUndecided;
  }
  int checked = 0;
  std::set<std::string> files;
  for (std::string file; std::getline(manifest, file);) {
    std::ifstream in(folder + "/" + file);
    if (!in || file.find('/') != std::string::npos || !files.insert(file).second) {
      report(folder + "/" + file + " cannot be read, or is listed twice");
      return kUndecided;
    }
    Lines lines(in);
    try {
      check(lines);
    } catch (const std::bad_alloc&) {
      throw;  // the certificate may hold all the same
    } catch (const std::exception& error) {
      report(file + ":" + std::to_string(lines.number()) + ": " + error.what());
      return kDoesNotHold;
    }
    ++checked;
  }
  if (checked == 0) {
    report(folder + "/MANIFEST lists no certificate");
    return kUndecided;
  }
  std::cout << checked << " certificates hold\n";
  return kHolds;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string first = argc == 2 ? argv[1] : "";
  if (argc != 2) {
    report("expected one folder; see --help");
    return kUndecided;
  }
  int code = kHolds;
  if (first == "--help") {
    std::cout << R"(requad-verify-check: checks certificates again

Usage:
  requad-verify-check DIR

DIR is a folder that `requad-verify --certificate DIR` wrote. This program has no
code in common with requad-verify. `requad-verify check DIR` starts it.

Exit code: 0 all certificates hold, 1 one does not hold, 2 undecided: one can
not be read, or memory ran out

Examples:
  requad-verify --claim T2 --digon 3..8 --certificate proof && requad-verify-check proof
)";
  } else {
    try {
      code = check_folder(first);
    } catch (const std::bad_alloc&) {
      report("out of memory");
      return kUndecided;
    }
  }
  std::cout.flush();
  if (std::cout) return code;
  report("standard output cannot be written");
  return kUndecided;
}
