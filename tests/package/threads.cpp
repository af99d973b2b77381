// A user of requad::threads.
#include <atomic>

#include <requad/mesh/threads/threads.hpp>

int main() {
  std::atomic<int> sum = 0;
  requad::threads::run_on_threads(10, 2, [&](std::size_t i) { sum += static_cast<int>(i); });
  return sum == 45 ? 0 : 1;
}
