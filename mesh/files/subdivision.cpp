#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <sstream>
#include <unordered_map>

#include "mesh/files/polygon_mesh.hpp"
#include "mesh/text/number_text.hpp"
#include "mesh/text/text_scanner.hpp"

namespace requad::mesh {

namespace {

using Values = Attributes::Values;

std::vector<double> numbers_in(const std::string& words) {
  std::vector<double> numbers;
  std::istringstream in(words);
  for (std::string word; in >> word;) numbers.push_back(TextScanner::number_or(word, 0));
  return numbers;
}

// The means of the numbers of some words; "" if they have different counts, or none.
std::string mean_of(const std::vector<const std::string*>& all) {
  std::vector<double> sum = numbers_in(*all.front());
  for (std::size_t i = 1; i < all.size(); ++i) {
    const std::vector<double> next = numbers_in(*all[i]);
    if (next.size() != sum.size()) return "";
    std::transform(sum.begin(), sum.end(), next.begin(), sum.begin(), std::plus<>());
  }
  std::string words;
  for (const double number : sum) {
    words += words.empty() ? "" : " ";
    append_number(words, number / static_cast<double>(all.size()));
  }
  return words;
}

// Values of a subdivided mesh, of which each mean is listed once.
class MeanValues {
 public:
  MeanValues(const Values& before, bool unit) : values_{before.words, before.numbers, {}}, unit_(unit) {}

  // The mean of the values with these indices; -1 if one is missing.
  int mean(std::vector<int> indices) {
    std::sort(indices.begin(), indices.end());
    if (indices.front() < 0) return -1;
    if (indices.front() == indices.back()) return indices.front();
    const auto [at, is_new] = known_.emplace(indices, 0);
    if (!is_new) return at->second;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::vector<const std::string*> words;
    for (const int i : indices) {
      sum += values_.numbers[static_cast<std::size_t>(i)];
      words.push_back(&values_.words[static_cast<std::size_t>(i)]);
    }
    Eigen::Vector3d value = sum / static_cast<double>(indices.size());
    std::string text = unit_ ? "" : mean_of(words);
    if (unit_) value.normalize();
    if (text.empty()) {  // also if the lines have two and three numbers
      append_position(text, value);
      text.erase(0, 1);
    }
    return at->second = values_.add(std::move(text), value);
  }
  Values& values() { return values_; }

 private:
  Values values_;
  bool unit_;
  std::map<std::vector<int>, int> known_;
};

// For the corners of the quads that subdivide() makes, face by face.
Values subdivided(const PolygonMesh& m, const Values& before, bool unit) {
  MeanValues means(before, unit);
  std::vector<int> at_corner;
  if (!before.at_corner.empty()) {
    for (std::size_t f = 0; f < m.face_count(); ++f) {
      const std::size_t n = m.face(f).size();
      std::vector<int> here, middle;
      for (std::size_t k = 0; k < n; ++k) here.push_back(before.at(m.first_corner(f) + k));
      for (std::size_t k = 0; k < n; ++k) middle.push_back(means.mean({here[k], here[(k + 1) % n]}));
      const int centre = means.mean(here);
      for (std::size_t k = 0; k < n; ++k) {
        const std::array<int, 4> quad{here[k], middle[k], centre, middle[(k + n - 1) % n]};
        at_corner.insert(at_corner.end(), quad.begin(), quad.end());
      }
    }
  }
  means.values().at_corner = std::move(at_corner);
  return std::move(means.values());
}

}  // namespace

PolygonMesh subdivide(const PolygonMesh& m) {
  PolygonMesh result;
  result.name = m.name;
  result.first_index = m.first_index;
  result.positions = m.positions;
  result.same_as = m.same_as;
  result.corners.reserve(4 * m.corners.size());
  const Attributes& before = m.attributes;
  Attributes& after = result.attributes;
  after = {before.libraries, before.keywords, before.states, {}, before.vertex_words, {}, {},
           before.elements,  before.not_kept};
  const auto position = [&m](int v) -> const Eigen::Vector3d& { return m.positions[static_cast<std::size_t>(v)]; };
  const auto words = [&before](int v) -> const std::string& {
    static const std::string none;
    return static_cast<std::size_t>(v) < before.vertex_words.size() ? before.vertex_words[static_cast<std::size_t>(v)]
                                                                    : none;
  };
  // Adds the mean of some vertices.
  const auto add = [&](std::span<const int> vertices) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::vector<const std::string*> texts;
    for (const int v : vertices) {
      sum += position(v);
      texts.push_back(&words(v));
    }
    result.positions.emplace_back(sum / static_cast<double>(vertices.size()));
    if (before.vertex_words.empty()) return;
    after.vertex_words.resize(result.positions.size());
    after.vertex_words.back() = mean_of(texts);
  };

  // The vertex at the middle of each edge, by its ends; in the order in which the faces first come to it.
  std::unordered_map<std::uint64_t, int> middles;
  middles.reserve(m.corners.size());
  const auto key = [](int a, int b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint64_t>(std::max(a, b));
  };
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const std::span<const int> face = m.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::array<int, 2> ends{face[k], face[(k + 1) % face.size()]};
      if (middles.emplace(key(ends[0], ends[1]), static_cast<int>(result.positions.size())).second) add(ends);
    }
  }
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const std::span<const int> face = m.face(f);
    const auto centre = static_cast<int>(result.positions.size());
    add(face);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int from = face[(k + face.size() - 1) % face.size()];
      result.add_face(std::array{face[k], middles.at(key(face[k], face[(k + 1) % face.size()])), centre,
                                 middles.at(key(from, face[k]))},
                      m.lines[f]);
      if (!before.state_of_face.empty()) after.state_of_face.push_back(before.state(f));
    }
  }
  after.uvs = subdivided(m, before.uvs, false);
  after.normals = subdivided(m, before.normals, true);

  // A tag of an edge becomes two.
  after.elements.clear();
  for (const Attributes::Element& element : before.elements) {
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < element.words.size(); ++i) {
      if (element.words[i].vertex >= 0) ends.push_back(i);
    }
    const auto middle = element.keyword == "t" && ends.size() == 2
                            ? middles.find(key(element.words[ends[0]].vertex, element.words[ends[1]].vertex))
                            : middles.end();
    if (middle == middles.end()) {
      after.elements.push_back(element);
      continue;
    }
    for (const std::size_t moved : {ends[1], ends[0]}) {
      after.elements.push_back(element);
      after.elements.back().words[moved].vertex = middle->second;
    }
  }
  return result;
}

}  // namespace requad::mesh
