#include "enumerate/search/valence_budget.hpp"

#include <algorithm>
#include <map>

namespace requad::enumerate {

ValenceBudget::ValenceBudget(const std::vector<int>& irregular) {
  std::map<int, int> counts;
  for (const int l : irregular) ++counts[l], least_ += std::min(4 - l, 0), most_ += std::max(4 - l, 0);
  int codes = 1;
  for (const auto& [valence, count] : counts) {
    kinds_.push_back({valence, count, codes});
    codes *= count + 1;
  }
  code_ = codes - 1;
  // Every multiset that is not empty is a smaller one with one more vertex, of the last kind it has. Its sums are those
  // of the smaller one, both without and with the index of that vertex.
  sums_.assign(entry(codes, least_), 0);
  sums_[entry(0, 0)] = 1;
  for (int code = 1; code < codes; ++code) {
    const Kind& last = *std::find_if(kinds_.rbegin(), kinds_.rend(), [&](const Kind& k) { return k.weight <= code; });
    const int smaller = code - last.weight;
    for (int sum = least_; sum <= most_; ++sum) {
      if (sums_[entry(smaller, sum)] == 0) continue;
      sums_[entry(code, sum)] = 1;
      sums_[entry(code, sum + 4 - last.valence)] = 1;
    }
  }
}

}  // namespace requad::enumerate
