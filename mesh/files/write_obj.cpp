#include "mesh/files/write_obj.hpp"

#include <array>

#include "mesh/geometry/drawing.hpp"
#include "mesh/text/number_text.hpp"

namespace requad::mesh {

namespace {

using FileFaces = std::vector<std::array<int, 4>>;

// Faces count vertices from 0, in the order of the positions.
class ObjWriter {
 public:
  explicit ObjWriter(const Attributes& attributes) : a_(attributes) {}

  std::string text(const Positions& positions, const FileFaces& faces) {
    for (const std::string& line : a_.libraries) add_line(line);
    for (std::size_t v = 0; v < positions.size(); ++v) {
      text_ += 'v';
      append_position(text_, positions[v]);
      add_line(v < a_.vertex_words.size() ? with_blank(a_.vertex_words[v]) : "");
    }
    for (const std::string& words : a_.uvs.words) add_line("vt" + with_blank(words));
    for (const std::string& words : a_.normals.words) add_line("vn" + with_blank(words));
    for (std::size_t f = 0; f < faces.size(); ++f) {
      change_state(a_.state(f));
      text_ += 'f';
      for (std::size_t k = 0; k < 4; ++k) {
        text_ += ' ';
        append_number(text_, faces[f][k] + 1);
        add_values(4 * f + k);
      }
      text_ += '\n';
    }
    for (const Attributes::Element& element : a_.elements) {
      text_ += element.keyword;
      for (const Attributes::Element::Word& word : element.words) {
        text_ += ' ';
        if (word.vertex >= 0) append_number(text_, word.vertex + element.first_index);
        text_ += word.text;
      }
      text_ += '\n';
    }
    return std::move(text_);
  }

 private:
  static std::string with_blank(const std::string& words) { return words.empty() ? words : " " + words; }
  void add_line(const std::string& line) { text_ += line + '\n'; }

  // "/uv", "//normal", "/uv/normal" or nothing.
  void add_values(std::size_t corner) {
    const int uv = a_.uvs.at(corner), normal = a_.normals.at(corner);
    if (uv < 0 && normal < 0) return;
    text_ += '/';
    if (uv >= 0) append_number(text_, uv + 1);
    if (normal < 0) return;
    text_ += '/';
    append_number(text_, normal + 1);
  }

  // Writes the statements in which the state differs from that of the face before.
  void change_state(int state) {
    if (state == state_) return;
    const auto line = [this](int of, std::size_t keyword) {
      static const std::string none;
      if (of < 0 || keyword >= a_.states[static_cast<std::size_t>(of)].size()) return none;
      return a_.states[static_cast<std::size_t>(of)][keyword];
    };
    for (std::size_t k = 0; k < a_.keywords.size(); ++k) {
      const std::string now = line(state, k);
      if (now == line(state_, k)) continue;
      // The state before the first statement is the keyword without a name.
      add_line(!now.empty() ? now : a_.keywords[k] == "s" ? "s off" : a_.keywords[k]);
    }
    state_ = state;
  }

  const Attributes& a_;
  std::string text_;
  int state_ = -1;
};

Positions live_positions(const QuadMesh& m, const Positions& positions) {
  Positions live;
  for (const VertexId v : m.vertices()) live.push_back(positions[v.slot()]);
  return live;
}

}  // namespace

std::string obj_text(const QuadMesh& m, const Positions& positions, const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& comment : comments) text += "# " + comment + '\n';
  return text + obj_text(m, positions, Attributes{});
}

std::string obj_text(const QuadMesh& m, const Positions& positions, const Attributes& attributes) {
  return ObjWriter(attributes).text(live_positions(m, positions), m.compact_faces());
}

std::string obj_text(const Region& region, const std::vector<std::string>& comments) {
  Positions positions;
  for (const Eigen::Vector2d& p : draw(region)) positions.emplace_back(p.x(), p.y(), 0);
  return obj_text(region.mesh, positions, comments);
}

std::string whole_obj_text(const Surface& s) {
  Positions all;
  std::size_t unused = 0;
  for (const int slot : s.from_file)
    all.push_back(slot < 0 ? s.unused[unused++] : s.positions[static_cast<std::size_t>(slot)]);
  FileFaces faces = s.mesh.compact_faces();
  for (auto& face : faces) {
    for (int& v : face) v = s.file_vertex[static_cast<std::size_t>(v)];
  }
  return ObjWriter(s.attributes).text(all, faces);
}

}  // namespace requad::mesh
