// Counts the allocations of the test program, by replacing operator new.
#pragma once

#include <cstdint>

namespace requad::tests {

// The number of allocations so far, in all threads, by every form of operator new except the aligned ones.
std::int64_t allocations();

}  // namespace requad::tests
