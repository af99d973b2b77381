#include "tests/support/allocations.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/support/sanitizers.hpp"

namespace {

std::atomic<std::int64_t> allocated{0};

}  // namespace

// ThreadSanitizer has its own operators. The tests of costs fail there, so they are left out.
#if !REQUAD_THREAD_SANITIZER
namespace {

void* counted(std::size_t size) noexcept {
  ++allocated;
  return std::malloc(size == 0 ? 1 : size);
}
void* counted_or_throw(std::size_t size) {
  if (void* p = counted(size)) return p;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return counted_or_throw(size); }
void* operator new[](std::size_t size) { return counted_or_throw(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { std::free(p); }
#endif

namespace requad::tests {

std::int64_t allocations() { return allocated; }

}  // namespace requad::tests
