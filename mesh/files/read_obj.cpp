#include <algorithm>
#include <cmath>

#include "mesh/files/read_polygons.hpp"
#include "mesh/files/reading.hpp"

namespace requad::mesh {

namespace {

using Element = Attributes::Element;

bool is_obj_keyword(std::string_view word) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return letter(word.front()) && std::all_of(word.begin(), word.end(), [&](char c) {
           return letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
         });
}

// A corner of a face, or a vertex of a line: indices from 0, or -1.
struct Reference {
  std::int64_t vertex = -1, uv = -1, normal = -1;
};

// Reads an OBJ text line by line.
class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name) : scanner_(name, text) { mesh_.name = name; }

  PolygonMesh read() {
    for (bool more = !scanner_.at_end_of_line() || scanner_.next_line(), first = true; more;
         more = scanner_.next_line(), first = false) {
      line_ = scanner_.line();
      const std::string_view keyword = scanner_.word();
      if (first && is_off_keyword(keyword)) scanner_.fail("this is OFF, not OBJ");
      read_line(keyword);
    }
    PolygonMesh done = finished(std::move(mesh_), scanner_);
    drop_what_does_not_exist(done);
    return done;
  }

 private:
  Attributes& attributes() { return mesh_.attributes; }

  void read_line(std::string_view keyword) {
    if (keyword == "v") {
      mesh_.positions.push_back(scanner_.position());
      if (!scanner_.at_end_of_line()) {
        attributes().vertex_words.resize(mesh_.positions.size());
        attributes().vertex_words.back() = numbers_to_end();
      }
    } else if (keyword == "f" || keyword == "fo") {
      read_face();
    } else if (keyword == "vt" || keyword == "vn") {
      Eigen::Vector3d value = Eigen::Vector3d::Zero();
      std::string words = scanner_.rest_of_line();
      read_numbers(words, value);
      (keyword == "vt" ? attributes().uvs : attributes().normals).add(std::move(words), value);
    } else if (is_statement(keyword)) {
      state_.resize(std::max(state_.size(), keyword_index(keyword) + 1));
      state_[keyword_index(keyword)] = std::string(keyword) + with_blank(scanner_.rest_of_line());
      state_is_new_ = true;
    } else if (keyword == "mtllib" || keyword == "maplib") {
      attributes().libraries.push_back(std::string(keyword) + with_blank(scanner_.rest_of_line()));
    } else if (keyword == "l" || keyword == "p") {
      read_element(keyword);
    } else if (keyword == "t") {
      read_tag();
    } else if (!is_obj_keyword(keyword)) {
      scanner_.fail(TextScanner::quoted(keyword) + " does not start a line of OBJ");
    } else {
      ++attributes().not_kept["'" + std::string(keyword.substr(0, 20)) + "' lines"];
    }
  }

  static std::string with_blank(std::string words) { return words.empty() ? words : " " + words; }

  std::size_t keyword_index(std::string_view keyword) {
    auto& all = attributes().keywords;
    const auto at = std::find(all.begin(), all.end(), keyword);
    if (at != all.end()) return static_cast<std::size_t>(at - all.begin());
    all.emplace_back(keyword);
    return all.size() - 1;
  }

  // The words up to the line's end, which must be numbers; colours may be NaN.
  std::string numbers_to_end() {
    std::string words;
    while (!scanner_.at_end_of_line()) {
      const std::string_view word = scanner_.word();
      scanner_.require_number(word);
      words += (words.empty() ? "" : " ") + std::string(word);
    }
    return words;
  }

  // The first numbers of a vt or vn line. What is no number counts as 0: it is kept as text all the same.
  static void read_numbers(const std::string& words, Eigen::Vector3d& value) {
    std::size_t at = 0;
    for (double& number : value) {
      at = words.find_first_not_of(" \t", at);
      if (at == std::string::npos) return;
      const std::size_t end = std::min(words.find_first_of(" \t", at), words.size());
      number = TextScanner::number_or(std::string_view(words).substr(at, end - at), 0);
      at = end;
    }
  }

  // "v", "v/vt", "v//vn" or "v/vt/vn".
  Reference reference(std::string_view word) {
    std::string_view rest;
    const auto so_far = static_cast<std::int64_t>(mesh_.positions.size());
    const std::int64_t index = scanner_.integer(word, rest);
    if (index == 0) scanner_.fail("vertex 0 does not exist; OBJ counts from 1");
    if (index < -so_far || index > kMostVertices) {
      scanner_.fail("vertex " + std::to_string(index) + " does not exist; there are " + std::to_string(so_far) +
                    " before this line");
    }
    Reference r{index > 0 ? index - 1 : so_far + index, -1, -1};
    for (int slash = 0; !rest.empty(); ++slash) {
      if (rest.front() != '/' || slash == 2)
        scanner_.fail(TextScanner::quoted(word) + " is not a corner v, v/vt, v//vn or v/vt/vn");
      rest.remove_prefix(1);
      if (rest.empty() || rest.front() == '/') continue;
      const std::int64_t number = scanner_.integer(rest, rest);
      const auto all = static_cast<std::int64_t>((slash == 0 ? attributes().uvs : attributes().normals).words.size());
      const std::int64_t known = number > 0 ? number - 1 : number < 0 ? all + number : -1;
      (slash == 0 ? r.uv : r.normal) = known < 0 ? kMostVertices : std::min(known, kMostVertices);  // drop it later
    }
    return r;
  }

  void read_face() {
    face_.clear();
    const std::size_t first = mesh_.corners.size();
    for (std::string_view word = scanner_.word(); !word.empty(); word = scanner_.word()) {
      const Reference r = reference(word);
      face_.push_back(static_cast<int>(r.vertex));
      for (auto [index, values] : {std::pair(r.uv, &attributes().uvs), std::pair(r.normal, &attributes().normals)}) {
        if (index == -1) continue;
        values->at_corner.resize(first + face_.size(), -1);
        values->at_corner.back() = static_cast<int>(index);
      }
    }
    check_corner_count(scanner_, static_cast<std::int64_t>(face_.size()));
    mesh_.add_face(face_, line_);
    if (attributes().keywords.empty()) return;
    if (state_is_new_) {
      const auto at = std::find(attributes().states.begin(), attributes().states.end(), state_);
      state_index_ = static_cast<int>(at - attributes().states.begin());
      if (at == attributes().states.end()) attributes().states.push_back(state_);
      state_is_new_ = false;
    }
    attributes().state_of_face.resize(mesh_.face_count(), -1);
    attributes().state_of_face.back() = state_index_;
  }

  void read_element(std::string_view keyword) {
    Element element{std::string(keyword), 1, {}};
    for (std::string_view word = scanner_.word(); !word.empty(); word = scanner_.word()) {
      const Reference r = reference(word);
      std::string text;
      if (r.uv >= 0) text = "/" + std::to_string(r.uv + 1);
      element.words.push_back({static_cast<int>(r.vertex), std::move(text)});
    }
    attributes().elements.push_back(std::move(element));
  }

  // `t crease 2/1/0 A B SHARPNESS` and `t corner 1/1/0 A SHARPNESS` name vertices, counted from 0.
  void read_tag() {
    const std::string_view kind = scanner_.word();
    const bool crease = kind == "crease";
    if (!crease && kind != "corner") {
      ++attributes().not_kept["'t " + std::string(kind.substr(0, 20)) + "' tags"];
      return;
    }
    Element element{"t", 0, {{-1, std::string(kind)}}};
    element.words.push_back({-1, std::string(scanner_.word())});
    const auto& counts = element.words.back().text;
    const std::size_t vertices = crease ? 2 : 1;
    bool sound = counts.starts_with(crease ? "2/" : "1/");
    for (std::string_view word = scanner_.word(); !word.empty(); word = scanner_.word()) {
      if (element.words.size() >= 2 + vertices) {
        element.words.push_back({-1, std::string(word)});
        continue;
      }
      const double v = TextScanner::number_or(word, -1);
      sound = sound && v >= 0 && v < kMostVertices && v == std::floor(v);
      element.words.push_back({sound ? static_cast<int>(v) : 0, ""});
    }
    if (sound && element.words.size() >= 2 + vertices) {
      attributes().elements.push_back(std::move(element));
    } else {
      ++attributes().not_kept["'t " + std::string(kind) + "' tags"];
    }
  }

  // References to values and vertices that the file does not have.
  static void drop_what_does_not_exist(PolygonMesh& m) {
    Attributes& a = m.attributes;
    for (auto* values : {&a.uvs, &a.normals}) {
      for (int& index : values->at_corner) {
        if (index < static_cast<int>(values->words.size())) continue;
        index = -1;
        ++a.not_kept[values == &a.uvs ? "indices of missing 'vt' lines" : "indices of missing 'vn' lines"];
      }
      if (std::all_of(values->at_corner.begin(), values->at_corner.end(), [](int index) { return index == -1; }))
        values->at_corner.clear();
    }
    const auto vertices = static_cast<int>(m.positions.size());
    a.not_kept["lines with missing vertices"] += static_cast<int>(std::erase_if(a.elements, [&](const Element& e) {
      return std::any_of(e.words.begin(), e.words.end(), [&](const auto& word) { return word.vertex >= vertices; });
    }));
    std::erase_if(a.not_kept, [](const auto& entry) { return entry.second == 0; });
  }

  TextScanner scanner_;
  PolygonMesh mesh_;
  int line_ = 0;
  std::vector<int> face_;
  Attributes::State state_;
  bool state_is_new_ = false;
  int state_index_ = -1;
};

}  // namespace

PolygonMesh parse_obj(std::string_view text, const std::string& name) { return ObjReader(text, name).read(); }

}  // namespace requad::mesh
