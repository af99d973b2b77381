#include "tests/verify/check/proof.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <stdexcept>

#include "mesh/program/run/checksum.hpp"
#include "tests/support/programs.hpp"

namespace requad::tests {

namespace {

std::size_t slot(int i) { return static_cast<std::size_t>(i); }

template <class Numbers>
std::string words(const Numbers& numbers) {
  std::string text;
  for (const int number : numbers) text += " " + std::to_string(number);
  return text;
}

}  // namespace

int ListedRegion::perimeter() const { return std::accumulate(sides.begin(), sides.end(), 0); }

void ListedRegion::drop(std::size_t mesh) {
  meshes.erase(meshes.begin() + static_cast<std::ptrdiff_t>(mesh));
  const int gone = static_cast<int>(mesh);
  std::erase_if(edges, [gone](const ListedEdge& e) { return e.from == gone || e.to == gone; });
  for (ListedEdge& e : edges) {
    if (e.from > gone) --e.from;
    if (e.to > gone) --e.to;
  }
}

std::string ListedRegion::text() const {
  std::ostringstream out;
  const auto pairs = std::count_if(meshes.begin(), meshes.end(), [](const auto& m) { return m.kind == "pair"; });
  out << "requad certificate 2\npair " << pair << "\nsides" << words(sides) << "\nconfigurations " << pairs
      << "\nmerged " << static_cast<std::ptrdiff_t>(meshes.size()) - pairs << "\nedges " << edges.size() << "\n";
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const ListedMesh& m = meshes[i];
    out << "mesh " << i << " " << m.kind << " " << m.label << " d1 " << m.d1_d2_p[0] << " d2 " << m.d1_d2_p[1] << " p "
        << m.d1_d2_p[2] << " strips" << words(m.strips) << " vertices " << m.vertices << " faces " << m.faces.size()
        << "\n";
    for (const Quad& f : m.faces) out << words(f).substr(1) << "\n";
  }
  for (const ListedEdge& e : edges) {
    out << "edge " << e.from << " " << e.to << " step " << e.step << " from" << words(e.before) << " to"
        << words(e.after) << " operations " << e.script.size() << "\n";
    for (const ListedOperation& op : e.script) out << op.word << words(op.vertices) << "\n";
  }
  out << "end\n";
  return out.str();
}

ListedRegion listed_region(const std::string& text) {
  std::istringstream in(text);
  ListedRegion region;
  std::string word;
  std::size_t pairs = 0, merged = 0, edges = 0;
  in >> word >> word >> word >> word >> region.pair >> word;
  for (int side = 0; in >> side;) region.sides.push_back(side);
  in.clear();
  in >> word >> pairs >> word >> merged >> word >> edges;
  for (std::size_t i = 0; i < pairs + merged; ++i) {
    ListedMesh m;
    std::size_t faces = 0;
    in >> word >> word >> m.kind >> m.label >> word >> m.d1_d2_p[0] >> word >> m.d1_d2_p[1] >> word >> m.d1_d2_p[2] >>
        word;
    m.strips.resize(region.sides.size());
    for (int& strip : m.strips) in >> strip;
    in >> word >> m.vertices >> word >> faces;
    m.faces.resize(faces);
    for (Quad& face : m.faces) {
      for (int& v : face) in >> v;
    }
    region.meshes.push_back(m);
  }
  for (std::size_t i = 0; i < edges; ++i) {
    ListedEdge e;
    std::size_t operations = 0;
    in >> word >> e.from >> e.to >> word >> e.step >> word;
    for (int& number : e.before) in >> number;
    in >> word;
    for (int& number : e.after) in >> number;
    in >> word >> operations;
    e.script.resize(operations);
    for (ListedOperation& op : e.script) {
      in >> op.word;
      for (int& v : op.vertices) in >> v;
    }
    region.edges.push_back(e);
  }
  in >> word;
  if (!in || word != "end" || region.text() != text) throw std::logic_error("not a certificate as this test knows it");
  return region;
}

Proof::File& Proof::file(const std::string& name) {
  for (File& f : files) {
    if (f.name == name) return f;
  }
  throw std::out_of_range(name);
}

std::string checksum_of(const std::string& text) {
  program::Checksum checksum;
  checksum.add(text);
  return checksum.text();
}

void Proof::write(const std::filesystem::path& folder, const Proof& there) const {
  std::map<std::string, std::string> texts;  // of the files there
  for (const File& f : there.files) texts[f.name] = f.text;
  std::filesystem::create_directories(folder);
  std::string manifest = "requad manifest 2\n";
  for (const std::string& family : families) manifest += family + "\n";
  manifest += "certificates " + std::to_string(files.size()) + "\n";
  for (const File& f : files) {
    manifest += f.name + " " + (f.checksum.empty() ? checksum_of(f.text) : f.checksum) + "\n";
    if (texts[f.name] != f.text) spill(folder / f.name, f.text);
  }
  spill(folder / "MANIFEST", manifest + "end\n");
}

Proof read_proof(const std::filesystem::path& folder) {
  Proof proof;
  std::istringstream in(slurp(folder / "MANIFEST"));
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("family ")) proof.families.push_back(line);
    const std::string name = line.substr(0, line.find(' '));
    if (name.ends_with(".txt")) proof.files.push_back({name, slurp(folder / name), ""});
  }
  return proof;
}

// --- what a prover can do to meshes ----------------------------------------------------------------------------------

namespace {

// The face on the left of a -> b, turned so that it starts with a; none if there is none.
Quad* left_of(std::vector<Quad>& faces, int a, int b) {
  for (Quad& f : faces) {
    for (int turn = 0; turn < 4; ++turn) {
      if (f[0] == a && f[1] == b) return &f;
      std::rotate(f.begin(), f.begin() + 1, f.end());
    }
  }
  return nullptr;
}

}  // namespace

std::vector<Quad> after(std::vector<Quad> faces, const ListedOperation& operation) {
  const auto [a, b, c, d] = operation.vertices;
  Quad* const face = left_of(faces, a, b);
  if (face == nullptr) return faces;
  if (operation.word == "flip") {
    Quad* const across = left_of(faces, b, a);
    if (across == nullptr) return faces;
    const Quad f = *face, g = *across;  // a b p q and b a r s
    if (c == f[2] || d == f[2]) {
      *face = {a, g[2], f[2], f[3]};
      *across = {g[2], g[3], b, f[2]};
    } else {
      *face = {g[3], b, f[2], f[3]};
      *across = {f[3], a, g[2], g[3]};
    }
  } else if (operation.word == "collapse") {
    faces.erase(faces.begin() + (face - faces.data()));
    for (Quad& f : faces) std::replace(f.begin(), f.end(), c, a);
  } else {
    for (int to = b; to != c;) {
      Quad* const next = left_of(faces, a, to);
      if (next == nullptr) break;
      to = (*next)[3];
      (*next)[0] = d;
    }
    faces.push_back({a, b, d, c});
  }
  return faces;
}

std::vector<Quad> after(std::vector<Quad> faces, const Script& script) {
  for (const ListedOperation& operation : script) faces = after(std::move(faces), operation);
  return faces;
}

ListedOperation inverse(const ListedOperation& operation, int made) {
  const auto [a, b, c, d] = operation.vertices;
  if (operation.word == "flip") return {"flip", {c, d, a, b}};
  if (operation.word == "collapse") return {"split", {a, b, d, made}};
  return {"collapse", {a, b, d, c}};
}

std::vector<int> isomorphism(const std::vector<Quad>& from, const std::vector<Quad>& to, int vertices, int boundary) {
  if (from.size() != to.size()) return {};
  const auto corners = [](const std::vector<Quad>& faces) {
    std::map<std::array<int, 2>, Quad> result;  // by the first edge
    for (Quad f : faces) {
      for (int turn = 0; turn < 4; ++turn) {
        result[{f[0], f[1]}] = f;
        std::rotate(f.begin(), f.begin() + 1, f.end());
      }
    }
    return result;
  };
  const auto here = corners(from), there = corners(to);
  std::vector<int> image(slot(vertices), -1);
  std::iota(image.begin(), image.begin() + boundary, 0);
  std::vector<std::array<int, 2>> queue{{0, 1}};
  std::set<std::array<int, 2>> met;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const auto [a, b] = queue[i];
    const auto face = here.find({a, b});
    if (!met.insert({a, b}).second || face == here.end()) continue;
    const auto other = there.find({image[slot(a)], image[slot(b)]});
    if (other == there.end()) return {};
    for (std::size_t k = 0; k < 4; ++k) {
      int& v = image[slot(face->second[k])];
      if (v < 0) v = other->second[k];
      if (v != other->second[k]) return {};
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const int v = face->second[k], w = face->second[(k + 1) % 4];
      queue.push_back({v, w});
      queue.push_back({w, v});
    }
  }
  return image;
}

}  // namespace requad::tests
