#include "tests/verify/check/tamperings.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "tests/verify/check/tampering_tools.hpp"
#include "tests/verify/check/wrong_transports.hpp"

namespace requad::tests {

namespace {

// What is wrong with a mesh that is turned round or over depends on whether its sides still fit.
const char* const kOtherBoundaryOrLabels =
    "a boundary vertex has a wrong number of faces|separatrices do not have the d1, d2, p and strips";

std::vector<Tampering> with_meshes() {
  return {
      {"a configuration is dropped", "but the closed form gives",
       in_region([](ListedRegion& r) { return r.drop(first_pair(r)), true; })},
      {"the merged vertex is dropped", "0 meshes hold the merged vertex, but the region has 1",
       in_region([](ListedRegion& r) {
         for (std::size_t i = 0; i < r.meshes.size(); ++i) {
           if (r.meshes[i].kind == "merged") return r.drop(i), true;
         }
         return false;
       })},
      {"a configuration is given twice, under the label of another", "two meshes are the same",
       in_region([](ListedRegion& r) {
         if (r.meshes.size() < 2 || r.meshes[1].kind != "pair") return false;
         r.meshes[1] = r.meshes[0];
         return true;
       })},
      {"a configuration is given twice, with other names of its vertices", "two meshes are the same",
       in_region([](ListedRegion& r) {
         if (r.meshes.size() < 2 || r.meshes[1].kind != "pair") return false;
         r.meshes[1] = r.meshes[0];
         const int first = r.perimeter(), last = r.meshes[0].vertices - 1;
         rename(r, 1, [&](int v) { return v < first ? v : first + last - v; });
         std::reverse(r.meshes[1].faces.begin(), r.meshes[1].faces.end());
         return true;
       })},
      {"the merged vertex counts as a pair", "a mesh does not hold what its head says", in_region([](ListedRegion& r) {
         ListedMesh& last = r.meshes.back();
         const auto merged =
             std::find_if(r.meshes.begin(), r.meshes.end(), [](const auto& m) { return m.kind == "merged"; });
         if (merged == r.meshes.end() || merged->kind == last.kind) return false;
         std::swap(merged->kind, last.kind);
         return true;
       })},
      {"two configurations have each other's labels", "separatrices do not have the d1, d2, p and strips",
       in_region([](ListedRegion& r) {
         if (r.meshes.size() < 2 || r.meshes[1].kind != "pair") return false;
         std::swap(r.meshes[0].label, r.meshes[1].label);
         std::swap(r.meshes[0].d1_d2_p, r.meshes[1].d1_d2_p);
         std::swap(r.meshes[0].strips, r.meshes[1].strips);
         return true;
       })},
      {"the labels are (1000,-7)", "a mesh has another label than its parameters",
       in_meshes([](const ListedRegion&, ListedMesh& m) { m.label = "(1000,-7)"; })},
      {"d1 is 1000", "separatrices do not have the d1, d2, p and strips",
       in_meshes([](const ListedRegion&, ListedMesh& m) { m.d1_d2_p[0] = 1000; })},
      {"d2 is -7", "'-7' is no number", in_meshes([](const ListedRegion&, ListedMesh& m) { m.d1_d2_p[1] = -7; })},
      {"p is another", "separatrices do not have the d1, d2, p and strips",
       in_meshes([](const ListedRegion&, ListedMesh& m) { ++m.d1_d2_p[2]; })},
      {"a strip is added", "separatrices do not have the d1, d2, p and strips",
       in_meshes([](const ListedRegion&, ListedMesh& m) { ++m.strips.back(); })},
      {"the faces are clockwise", "the faces at a vertex", in_region([](ListedRegion& r) { return mirror(r), true; })},
      {"the mesh is its mirror image, with the old labels", kOtherBoundaryOrLabels, in_region([](ListedRegion& r) {
         mirror(r);
         const int n = r.perimeter(), first = r.sides[0];
         for (std::size_t i = 0; i < r.meshes.size(); ++i)
           rename(r, i, [&](int v) { return v < n ? (n + first - v) % n : v; });
         return true;
       })},
      {"the root is on another side", kOtherBoundaryOrLabels, in_region([](ListedRegion& r) {
         const int n = r.perimeter(), by = r.sides[0];
         for (std::size_t i = 0; i < r.meshes.size(); ++i)
           rename(r, i, [&](int v) { return v < n ? (v + by) % n : v; });
         return r.pair != "3-3" || r.sides[0] != r.sides[1];  // a regular digon is the same from both sides
       })},
      {"the root is beside its corner", "a boundary vertex has a wrong number of faces", in_region([](ListedRegion& r) {
         const int n = r.perimeter();
         for (std::size_t i = 0; i < r.meshes.size(); ++i) rename(r, i, [n](int v) { return v < n ? (v + 1) % n : v; });
         return true;
       })},
      {"a mesh has two more pairs", "the irregular vertices are neither the pair nor the merged vertex",
       in_region([](ListedRegion& r) {
         for (ListedMesh& m : r.meshes) {
           ListedOperation flip;
           if (!flip_far_away(r, m, flip)) continue;
           m.faces = after(m.faces, flip);
           return true;
         }
         return false;
       })},
      {"an edge is doubled", "two edges have the same ends", in_region([](ListedRegion& r) {
         for (ListedMesh& m : r.meshes) {
           for (const ListedOperation& op : all_flips(m.faces)) {
             const auto [a, b, c, d] = op.vertices;
             if (a < r.perimeter() || b < r.perimeter()) continue;
             // Two quads in a slit along a-b, with two new vertices of valence 2.
             const int x = m.vertices, y = x + 1;
             m.faces.push_back({a, b, x, y});
             m.faces.push_back({b, a, y, x});
             m.vertices += 2;
             return true;
           }
         }
         return false;
       })},
      {"a torus is laid beside the mesh", "the mesh falls apart", in_meshes([](const ListedRegion&, ListedMesh& m) {
         const auto name = [first = m.vertices](int x, int y) { return first + 4 * (x % 4) + y % 4; };
         for (int x = 0; x < 4; ++x) {
           for (int y = 0; y < 4; ++y)
             m.faces.push_back({name(x, y), name(x + 1, y), name(x + 1, y + 1), name(x, y + 1)});
         }
         m.vertices += 16;
       })},
      {"a mesh is given twice, side by side", "the numbers of vertices and faces are not those of a disk",
       in_meshes([](const ListedRegion&, ListedMesh& m) {
         const int more = m.vertices;
         for (std::size_t i = 0, n = m.faces.size(); i < n; ++i) {
           Quad f = m.faces[i];
           for (int& v : f) v += more;
           m.faces.push_back(f);
         }
         m.vertices *= 2;
       })},
      {"there is no configuration", "there is no configuration", in_region([](ListedRegion& r) {
         r.meshes.clear();
         r.edges.clear();
         return true;
       })},
  };
}

// Gives a slide of a 3-3 pair another script. Larger regions take long.
bool transport_wrongly(ListedRegion& r, WrongTransport kind) {
  if (r.pair != "3-3" || r.perimeter() > 14) return false;
  for (ListedEdge& e : r.edges) {
    if (!e.step.starts_with("slide") || e.from == e.to) continue;
    Script script = wrong_transport(r, e, kind);
    if (script.empty()) continue;
    e.script = std::move(script);
    return true;
  }
  return false;
}

std::vector<Tampering> with_edges() {
  return {
      {"the steps are nonsense", "there is no such step", in_edges([](ListedEdge& e) { e.step = "somehow"; })},
      {"the steps are others", "an edge's step does not lead from the one labelling to the other",
       in_edges([](ListedEdge& e) {
         const std::map<std::string, std::string> other{
             {"open", "slide_first"}, {"close", "slide_second"}, {"slide_first", "close"}, {"slide_second", "open"}};
         e.step = other.at(e.step);
       })},
      {"each edge is given again under another step",
       "an edge's step does not lead from the one labelling to the other", in_region([](ListedRegion& r) {
         for (std::size_t i = 0, n = r.edges.size(); i < n; ++i) {
           ListedEdge again = r.edges[i];
           again.step = again.step == "open" ? "close" : "open";
           r.edges.push_back(again);
         }
         return !r.edges.empty();
       })},
      {"each edge is given again", "a move is given twice", in_region([](ListedRegion& r) {
         const std::vector<ListedEdge> again = r.edges;
         r.edges.insert(r.edges.end(), again.begin(), again.end());
         return !r.edges.empty();
       })},
      {"each edge is given again from its other end", "a move is given twice", in_region([](ListedRegion& r) {
         const std::map<std::string, std::string> inverse_step{
             {"open", "close"}, {"close", "open"}, {"slide_first", "slide_second"}, {"slide_second", "slide_first"}};
         for (std::size_t i = 0, n = r.edges.size(); i < n; ++i) {
           ListedEdge back = r.edges[i];
           std::swap(back.from, back.to);
           std::swap(back.before, back.after);
           back.step = inverse_step.at(back.step);
           r.edges.push_back(back);
         }
         return !r.edges.empty();
       })},
      {"each mesh has a loop of no operations", "an edge's step does not lead from the one labelling to the other",
       in_region([](ListedRegion& r) {
         for (std::size_t i = 0; i < r.meshes.size(); ++i) {
           const auto at = r.meshes[i].d1_d2_p;
           r.edges.push_back({static_cast<int>(i), static_cast<int>(i), "slide_first", at, at, {}});
         }
         return true;
       })},
      {"only the edges of a spanning tree are given", "lacks a move", in_region([](ListedRegion& r) {
         std::set<int> reached{0};
         std::vector<ListedEdge> tree, rest = r.edges;
         for (bool grows = true; grows;) {
           grows = false;
           for (const ListedEdge& e : rest) {
             if (reached.count(e.from) == reached.count(e.to)) continue;
             reached.insert({e.from, e.to});
             tree.push_back(e);
             grows = true;
           }
         }
         const bool fewer = tree.size() < r.edges.size();
         r.edges = tree;
         return fewer;
       })},
      {"one edge is left out", "lacks a move",
       in_region([](ListedRegion& r) { return !r.edges.empty() && (r.edges.pop_back(), true); })},
      {"two moves in a row are one edge", "an edge's step does not lead from the one labelling to the other",
       in_region([](ListedRegion& r) {
         for (const ListedEdge& one : r.edges) {
           for (const ListedEdge& two : r.edges) {
             if (one.to != two.from || one.from == two.to || one.from == one.to || two.from == two.to) continue;
             const ListedMesh& from = r.meshes[at(one.from)];
             const ListedMesh& between = r.meshes[at(two.from)];
             const std::vector<Quad> end = after(from.faces, one.script);
             const auto image = isomorphism(between.faces, end, between.vertices, r.perimeter());
             if (image.empty()) continue;
             std::map<int, int> name;
             for (std::size_t v = 0; v < image.size(); ++v) name[static_cast<int>(v)] = image[v];
             const auto splits = [](const Script& s) {
               return static_cast<int>(
                   std::count_if(s.begin(), s.end(), [](const auto& op) { return op.word == "split"; }));
             };
             for (int i = 0; i < splits(two.script); ++i)
               name[between.vertices + i] = from.vertices + splits(one.script) + i;
             Script both = one.script;
             const Script second = translated(two.script, name);
             both.insert(both.end(), second.begin(), second.end());
             r.edges.push_back({one.from, two.to, one.step, one.before, two.after, both});
             return true;
           }
         }
         return false;
       })},
      {"a move, its inverse and the move again are one edge", "a script is made of two moves",
       in_region([](ListedRegion& r) {
         // The steps open and close have but one kind of operations: a slide, or the opening of a v6 or v2.
         ListedEdge* const e = edge_with(r, 1, "slide");
         if (e == nullptr) return false;
         e->script = there_and_back_and_there(e->script, r.meshes[at(e->from)].vertices);
         return true;
       })},
      {"an open move also flips", "an open move does not only split", in_region([](ListedRegion& r) {
         ListedEdge* const e = edge_with(r, 1, "open");
         if (e == nullptr) return false;
         const ListedOperation flip = all_flips(r.meshes[at(e->from)].faces)[0];
         e->script.insert(e->script.begin(), {flip, inverse(flip, 0)});
         return true;
       })},
      {"a close move also flips", "a close move does not only collapse", in_region([](ListedRegion& r) {
         ListedEdge* const e = edge_with(r, 1, "close");
         if (e == nullptr) return false;
         const ListedOperation flip = all_flips(r.meshes[at(e->from)].faces)[0];
         e->script.insert(e->script.begin(), {flip, inverse(flip, 0)});
         return true;
       })},
      {"a slide starts with a flip far away", "a script is no transport of one adjacent 3-5 pair",
       in_region([](ListedRegion& r) {
         for (ListedEdge& e : r.edges) {
           ListedOperation flip;
           if (!e.step.starts_with("slide") || e.script.empty() || !flip_far_away(r, r.meshes[at(e.from)], flip))
             continue;
           e.script.insert(e.script.begin(), {flip, inverse(flip, 0)});
           return true;
         }
         return false;
       })},
      {"the adjacent pair of a slide goes round the other vertex and comes back",
       "a transported pair comes back to the vertex that sent it",
       in_region([](ListedRegion& r) { return transport_wrongly(r, WrongTransport::comes_back); })},
      {"a slide transports a v3 and a v5 that have no edge in common",
       "a script is no transport of one adjacent 3-5 pair",
       in_region([](ListedRegion& r) { return transport_wrongly(r, WrongTransport::apart); })},
      {"a script leads elsewhere", "a script leads to another mesh", in_region([](ListedRegion& r) {
         ListedEdge* const e = edge_with(r, 1);
         if (e == nullptr) return false;
         e->script.clear();
         return true;
       })},
      {"an edge leads elsewhere", "an edge gives a mesh a labelling that it does not have|an edge's step does not lead",
       in_region([](ListedRegion& r) {
         const int nodes = static_cast<int>(r.meshes.size());
         if (nodes < 3 || r.edges.empty()) return false;
         ListedEdge& e = r.edges[0];
         do e.to = (e.to + 1) % nodes;
         while (e.to == e.from);
         return true;
       })},
      {"an operation is illegal", "there is no such|the new edge is no diagonal of the hexagon",
       in_region([](ListedRegion& r) {
         ListedEdge* const e = edge_with(r, 1);
         if (e == nullptr) return false;
         ListedOperation& op = e->script[0];
         if (op.word == "split") return false;
         op.vertices[0] = (op.vertices[0] + 1) % r.meshes[0].vertices;
         return true;
       })},
  };
}

std::vector<Tampering> with_files() {
  return {
      {"the content is that of another region", "the region is not the one that the file is named by",
       [](Proof& proof, Proof::File& file) {
         const auto other =
             std::find_if(proof.files.begin(), proof.files.end(), [&](const auto& f) { return f.name != file.name; });
         file.text = other->text;
         return true;
       }},
      {"the content is that of another region, with the sides of its name",
       "the closed form gives|a boundary vertex has a wrong number of faces|the numbers of vertices and faces",
       [](Proof& proof, Proof::File& file) {
         const ListedRegion own = listed_region(file.text);
         for (const Proof::File& other : proof.files) {
           ListedRegion region = listed_region(other.text);
           if (region.pair != own.pair || region.sides == own.sides) continue;
           region.sides = own.sides;
           file.text = region.text();
           return true;
         }
         return false;
       }},
      {"all files are copies of one region", "the region is not the one that the file is named by",
       [](Proof& proof, Proof::File& file) {
         for (Proof::File& f : proof.files) f.text = file.text;
         return true;
       }},
      {"the MANIFEST lists 28 copies of one region", "is listed twice",
       [](Proof& proof, Proof::File& file) {
         proof.files = std::vector<Proof::File>(28, file);
         return true;
       }},
      {"the copies have names of their own", "is no region of the families",
       [](Proof& proof, Proof::File& file) {
         const Proof::File one = file;
         proof.files.clear();
         for (int i = 0; i < 28; ++i) proof.files.push_back({"copy-" + std::to_string(i) + ".txt", one.text, ""});
         return true;
       }},
      {"the MANIFEST is cut to one file", "is missing",
       [](Proof& proof, Proof::File& file) {
         const Proof::File one = file;
         proof.files = {one};
         return true;
       }},
      {"a region is left out", "is missing",
       [](Proof& proof, Proof::File& file) {
         const std::string name = file.name;
         std::erase_if(proof.files, [&](const Proof::File& f) { return f.name == name; });
         return true;
       }},
      {"the sizes go further than the files", "is missing",
       [](Proof& proof, Proof::File&) {
         for (std::string& family : proof.families) {
           const std::size_t dots = family.find("..");
           family = family.substr(0, dots + 2) + std::to_string(std::stoi(family.substr(dots + 2)) + 2);
         }
         return true;
       }},
      {"the sizes are those of other files", "is no region of the families",
       [](Proof& proof, Proof::File&) {
         for (std::string& family : proof.families) {
           const std::size_t dots = family.find("..");
           const int last = std::stoi(family.substr(dots + 2)) + 2;
           family = family.substr(0, family.rfind(' ', dots) + 1) + std::to_string(last) + ".." + std::to_string(last);
         }
         return true;
       }},
      {"a family is not named", "is no region of the families",
       [](Proof& proof, Proof::File&) {
         proof.families.erase(proof.families.begin());
         return true;
       }},
      {"a family is named twice", "the families are not in their order, each once",
       [](Proof& proof, Proof::File&) {
         proof.families.insert(proof.families.begin(), proof.families[0]);
         return true;
       }},
      {"the files are in another order", "the files are not in order",
       [](Proof& proof, Proof::File&) {
         std::swap(proof.files.front(), proof.files.back());
         return true;
       }},
      {"the checksum is another", "the file's checksum is not the one in the MANIFEST",
       [](Proof&, Proof::File& file) {
         file.checksum = "00000000";
         return true;
       }},
      {"edges change places after the checksum was taken", "the file's checksum is not the one in the MANIFEST",
       [](Proof&, Proof::File& file) {
         ListedRegion region = listed_region(file.text);
         file.checksum = checksum_of(file.text);
         std::reverse(region.edges.begin(), region.edges.end());
         file.text = region.text();
         return region.edges.size() >= 2;
       }},
  };
}

}  // namespace

const std::vector<Tampering>& tamperings() {
  static const std::vector<Tampering> all = [] {
    std::vector<Tampering> list = with_meshes();
    for (const auto& more : {with_edges(), with_files()}) list.insert(list.end(), more.begin(), more.end());
    return list;
  }();
  return all;
}

}  // namespace requad::tests
