#include "tests/fuzz/fuzz.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <iostream>

#include <sanitizer/allocator_interface.h>

namespace requad::fuzz {

namespace {

// The memory in use, and the most that was in use since `most` was set. Another thread of libFuzzer sometimes takes
// memory, too.
std::atomic<std::ptrdiff_t> in_use = 0;
std::atomic<std::ptrdiff_t> most = 0;

void taken(const volatile void*, std::size_t size) {
  const std::ptrdiff_t now = in_use += static_cast<std::ptrdiff_t>(size);
  if (now > most) most = now;
}

void freed(const volatile void* memory) {
  if (memory != nullptr) in_use -= static_cast<std::ptrdiff_t>(__sanitizer_get_allocated_size(memory));
}

}  // namespace

void require(bool holds, std::string_view otherwise) {
  if (holds) return;
  std::cerr << "CHECK FAILED: " << otherwise << std::endl;
  std::abort();
}

void require_one_line(std::string_view message) {
  require(!message.empty(), "an error without a message");
  const bool one_line = message.find_first_of("\r\n") == std::string_view::npos;
  require(one_line, "an error of more than one line: " + std::string(message));
}

}  // namespace requad::fuzz

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  __sanitizer_install_malloc_and_free_hooks(requad::fuzz::taken, requad::fuzz::freed);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace requad::fuzz;
  const std::ptrdiff_t before = in_use;
  most = before;
  try_input({reinterpret_cast<const char*>(data), size});  // NOLINT: bytes are what libFuzzer gives
  const auto used = static_cast<std::size_t>(most - before);
  const std::size_t allowed = kMemory.fixed + kMemory.per_byte * size;
  require(used <= allowed, "an input of " + std::to_string(size) + " bytes took " + std::to_string(used) +
                               " bytes; allowed are " + std::to_string(allowed));
  return 0;
}
