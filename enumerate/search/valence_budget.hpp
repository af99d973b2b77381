// The irregular vertices that a partial mesh still lacks, as a multiset of valences.
//
// A vertex of valence l has the index 4 - l. Discrete Gauss-Bonnet fixes the sum of the indices inside a hole, so a
// hole can be filled only if the indices of some part of the multiset have that sum. can_sum_to() reads the answer from
// a table.
//
// Internal: not installed.
#pragma once

#include <cstddef>
#include <vector>

namespace requad::enumerate {

class ValenceBudget {
 public:
  // Everything is left at first. `irregular` has an entry for each vertex, none of them 4. Takes time and memory in
  // proportion to the number of parts of the multiset times the range of their sums.
  explicit ValenceBudget(const std::vector<int>& irregular);

  // A kind, 0..kind_count() - 1, stands for one valence of the multiset; they are in increasing order.
  int kind_count() const { return static_cast<int>(kinds_.size()); }
  int valence(int kind) const { return at(kind).valence; }
  bool has(int kind) const { return at(kind).left > 0; }
  // Precondition: has(kind).
  void take(int kind) { --at(kind).left, code_ -= at(kind).weight; }
  // Precondition: one of this kind was taken.
  void give_back(int kind) { ++at(kind).left, code_ += at(kind).weight; }
  bool empty() const { return code_ == 0; }

  // Whether the indices of some part of what is left have this sum. O(1).
  bool can_sum_to(int index) const { return least_ <= index && index <= most_ && sums_[entry(code_, index)] != 0; }
  // The largest such sum for the whole multiset.
  int largest_sum() const { return most_; }

 private:
  struct Kind {
    int valence;
    int left;
    int weight;  // of one vertex, in code_
  };
  const Kind& at(int kind) const { return kinds_[static_cast<std::size_t>(kind)]; }
  Kind& at(int kind) { return kinds_[static_cast<std::size_t>(kind)]; }
  std::size_t entry(int code, int index) const {
    return static_cast<std::size_t>(code * (most_ - least_ + 1) + index - least_);
  }

  std::vector<Kind> kinds_;
  int code_ = 0;            // what is left, as a mixed-radix number
  std::vector<char> sums_;  // by code, then by sum: whether some part of that multiset has that sum
  int least_ = 0;           // the range of all sums
  int most_ = 0;
};

}  // namespace requad::enumerate
