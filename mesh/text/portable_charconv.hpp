// Numbers as text where the standard library lacks std::to_chars and std::from_chars for floating-point numbers, as the
// library of Emscripten 3.1.6 does (__cpp_lib_to_chars). For number_text.hpp, which takes the standard's where it can.
// All builds compile these, so that tests can compare them with the standard's.
#pragma once

#include <charconv>

namespace requad::mesh::portable {

// As std::to_chars(first, last, value) for a finite value: the fewest digits that read back as the same bits. Of several
// texts that are as short the standard takes the nearest, and this one that of the correctly rounded digits.
// Precondition: there is room.
char* to_chars(char* first, char* last, double value);
char* to_chars(char* first, char* last, float value);

// As std::from_chars(first, last, value). It does not know "nan(...)". Precondition: LC_NUMERIC is "C".
std::from_chars_result from_chars(const char* first, const char* last, double& value);

}  // namespace requad::mesh::portable
