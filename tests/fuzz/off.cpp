// The OFF reader.
#include "tests/fuzz/surface.hpp"

const requad::fuzz::Memory requad::fuzz::kMemory{32 << 10, 400};

void requad::fuzz::try_input(std::string_view text) { try_reader(text, mesh::parse_off); }
