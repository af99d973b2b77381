#include "verify/check/fillings.hpp"

#include <algorithm>
#include <array>

#include "verify/check/reading.hpp"

namespace check {

namespace {

// A letter: the number of quads, and two flags.
constexpr unsigned kQuads = 7, kOnBoundary = 8, kBoundaryEdge = 16;

unsigned bits(char letter) { return static_cast<unsigned char>(letter); }
int quads(char letter) { return static_cast<int>(bits(letter) & kQuads); }
bool on_boundary(char letter) { return (bits(letter) & kOnBoundary) != 0; }
bool boundary_edge(char letter) { return (bits(letter) & kBoundaryEdge) != 0; }
char letter(int quads, unsigned flags) { return static_cast<char>(static_cast<unsigned>(quads) | flags); }
char with_more(char l, int quads) { return static_cast<char>(static_cast<unsigned char>(l) + quads); }
char with_inner_edge(char l) { return static_cast<char>(bits(l) & ~kBoundaryEdge); }

// The most quads that a vertex can have.
int most_quads(char l, const std::string& budget) {
  return on_boundary(l) || budget.empty() ? 4 : std::max<int>(4, budget.back());
}

// Makes one vertex of two, with the edge of the second. Returns false if they cannot be one.
bool merge(char& a, char b, const std::string& budget) {
  if (on_boundary(a) && on_boundary(b)) return false;
  const int sum = quads(a) + quads(b);
  a = letter(0, ((bits(a) | bits(b)) & kOnBoundary) | (bits(b) & kBoundaryEdge));
  if (sum > most_quads(a, budget)) return false;
  a = with_more(a, sum);
  return true;
}

// Whether a vertex may be finished so, and use up exactly this.
bool may_finish(char l, const std::string& budget) {
  if (on_boundary(l) || budget.empty()) return quads(l) == 4 && budget.empty();
  return budget.size() == 1 && quads(l) == budget[0];
}

// check-1 for a hole that uses up exactly this.
bool obeys_gauss_bonnet(const std::string& word, const std::string& budget) {
  int sum = -4;
  for (const char l : word) sum += quads(l) - 2;
  for (const char valence : budget) sum += 4 - valence;
  return sum == 0;
}

// check-2 for a hole that uses up nothing.
bool closes_in_the_grid(const std::string& word) {
  std::array<int, 4> steps{};  // in each direction
  int direction = 0;
  for (const char l : word) {
    ++steps[static_cast<std::size_t>(direction)];
    direction = (direction + quads(l) + 2) & 3;
  }
  return steps[0] == steps[2] && steps[1] == steps[3];
}

bool may_be_filled(const std::string& word, const std::string& budget) {
  return obeys_gauss_bonnet(word, budget) && (!budget.empty() || closes_in_the_grid(word));
}

// Takes a valence out of the budget. Returns false if it is not there.
bool take(std::string& budget, int valence) {
  const auto it = std::find(budget.begin(), budget.end(), static_cast<char>(valence));
  if (it == budget.end()) return false;
  budget.erase(it);
  return true;
}

// Rotates the word to where it is least.
void turn_to_least(std::string& word) {
  const std::size_t n = word.size();
  std::size_t a = 0, b = 1, same = 0;
  while (a < n && b < n && same < n) {
    const char at_a = word[(a + same) % n], at_b = word[(b + same) % n];
    if (at_a == at_b) {
      ++same;
      continue;
    }
    (at_a > at_b ? a : b) += same + 1;
    if (a == b) ++b;
    same = 0;
  }
  std::rotate(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(std::min(a, b)), word.end());
}

// Puts the first vertex with the most quads first.
void turn_to_fullest(std::string& word) {
  const auto fullest = std::max_element(word.begin(), word.end(), [](char a, char b) { return quads(a) < quads(b); });
  std::rotate(word.begin(), fullest, word.end());
}

// Glues the two edges of each vertex that can have no more quads. Returns false if the hole has no filling.
bool finish_full_vertices(std::string& word, std::string& budget) {
  for (;;) {
    turn_to_fullest(word);
    if (quads(word[0]) < most_quads(word[0], budget)) {
      // A full vertex on the boundary may have fewer quads than another one inside.
      const auto full = std::find_if(word.begin(), word.end(), [&](char l) { return on_boundary(l) && quads(l) == 4; });
      if (full == word.end()) return true;
      std::rotate(word.begin(), full, word.end());
    }
    if (quads(word[0]) != 4 && !take(budget, quads(word[0]))) return false;
    if (boundary_edge(word[0]) && boundary_edge(word.back())) return false;
    if (word.size() == 2) {
      const bool finished = may_finish(word[1], budget);
      word.clear();
      return finished;
    }
    char before = word.back();
    if (!merge(before, word[1], budget)) return false;
    word.back() = before;
    word.erase(0, 2);
  }
}

}  // namespace

std::uint64_t FillingCounter::with_pair(const Region& region) {
  return count(region, {static_cast<char>(region.l2), static_cast<char>(region.l1)});
}

std::uint64_t FillingCounter::with_merged_vertex(const Region& region) {
  return region.symmetric() ? count(region, {static_cast<char>(region.side_count())}) : 0;
}

std::uint64_t FillingCounter::count(const Region& region, const Budget& budget) {
  // Outside, a side's vertex has two quads and a corner has three.
  Word word;
  for (const int side : region.sides) {
    for (int i = 0; i < side; ++i) word += letter(i == 0 ? 3 : 2, kOnBoundary | kBoundaryEdge);
  }
  if (word.size() % 2 != 0 || !obeys_gauss_bonnet(word, budget)) return 0;
  if (known_.size() > kKeptHoles) known_.clear();
  return hole(word, budget);
}

// The number of fillings of a hole that use up the budget.
std::uint64_t FillingCounter::hole(Word word, const Budget& all) {
  Budget budget = all;
  if (!finish_full_vertices(word, budget)) return 0;
  if (word.empty()) return 1;
  if (!may_be_filled(word, budget)) return 0;
  turn_to_least(word);
  constexpr std::uint64_t kInWork = ~std::uint64_t{0};
  const auto [it, is_new] = known_.emplace(word + '\0' + budget, kInWork);
  if (!is_new) {
    if (it->second == kInWork) throw Undecided("a hole needs its own number of fillings");
    return it->second;
  }
  if (known_.size() > kMostHoles || depth_ > kDeepest)
    throw Undecided("the region has too many holes to count its fillings");
  std::uint64_t& result = it->second;
  ++depth_;
  turn_to_fullest(word);
  const std::uint64_t number = covered(word, budget) + glued(word, budget);
  --depth_;
  return result = number;
}

// The fillings that have a quad on the first edge.
std::uint64_t FillingCounter::covered(const Word& word, const Budget& budget) {
  Word left{with_more(with_inner_edge(word[0]), 1), letter(1, 0), letter(1, 0), with_more(word[1], 1)};
  if (quads(left[0]) > most_quads(left[0], budget) || quads(left[3]) > most_quads(left[3], budget)) return 0;
  left.append(word, 2);
  return hole(left, budget);
}

// Those in which the first edge is the same as another one.
std::uint64_t FillingCounter::glued(const Word& word, const Budget& budget) {
  std::uint64_t number = 0;
  // The first edge runs from letter 0 to letter 1, the other one from letter i to letter i + 1.
  for (std::size_t i = 1; i < word.size(); i += 2) {
    if (boundary_edge(word[0]) && boundary_edge(word[i])) continue;
    // Letters 1 to i are one part, of which the first and the last are now one vertex; the others are the other part.
    std::array<Word, 2> parts{word.substr(1, i), word.substr(i + 1) + word[0]};
    std::array<char, 2> finished{};  // the only vertex of a part without edges
    bool possible = true;
    for (std::size_t k = 0; k < 2; ++k) {
      Word& part = parts[k];
      if (part.size() == 1) {
        finished[k] = part[0];
        part.clear();
      } else {
        char last = part.back();
        possible = possible && merge(last, part[0], budget);
        part.back() = last;
        part.erase(0, 1);
      }
    }
    if (!possible) continue;
    const std::size_t choices = std::size_t{1} << budget.size();
    Budget before;
    for (std::size_t choice = 0; choice < choices; ++choice) {
      std::array<Budget, 2> shares;
      for (std::size_t b = 0; b < budget.size(); ++b) shares[(choice >> b) & 1] += budget[b];
      if (choice > 0 && shares[1] == before) continue;  // two equal valences
      before = shares[1];
      std::uint64_t product = 1;
      for (std::size_t k = 0; k < 2; ++k) {
        if (parts[k].empty() ? !may_finish(finished[k], shares[k]) : !may_be_filled(parts[k], shares[k])) product = 0;
      }
      for (std::size_t k = 0; k < 2 && product > 0; ++k) {
        if (!parts[k].empty()) product *= hole(parts[k], shares[k]);
      }
      number += product;
    }
  }
  return number;
}

}  // namespace check
