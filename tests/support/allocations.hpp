// Counts the allocations of the test program, by replacing operator new.
#pragma once

#include <cstdint>

namespace requad::tests {

// So far, by operator new in all its forms but the aligned ones; in all threads.
std::int64_t allocations();

}  // namespace requad::tests
