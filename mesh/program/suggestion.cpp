#include "mesh/program/suggestion.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace requad::program {

namespace {

std::string lower(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

// The Damerau-Levenshtein distance with swaps of neighbours only ("optimal string alignment"). O(|a| |b|).
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
  constexpr std::size_t kLongest = 40;
  if (word.size() > kLongest) return "";
  std::string nearest;
  std::size_t least = word.size() / 3 + 2;  // not near any more
  for (const std::string& candidate : known) {
    const std::size_t d = distance(lower(word), lower(candidate));
    if (d >= least || d >= std::min(word.size(), candidate.size())) continue;
    least = d;
    nearest = candidate;
  }
  return nearest;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const std::string near = suggestion(word, known);
  return near.empty() ? "" : "; did you mean '" + near + "'?";
}

}  // namespace requad::program
