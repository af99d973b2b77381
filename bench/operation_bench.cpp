// Basic operations, traversal and building against the bare kernel.

#include "bench/operation_bench.hpp"

namespace requad::bench {
namespace {

const int registered = [] {
  register_operations<KernelSubject>();
  register_operations<RequadSubject<false>>();
  register_operations<RequadSubject<true>>();
  return 0;
}();

}  // namespace
}  // namespace requad::bench
