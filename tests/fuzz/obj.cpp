// The OBJ reader.
#include "tests/fuzz/surface.hpp"

const std::size_t requad::fuzz::kBytesPerByte = 1000;

void requad::fuzz::try_input(std::string_view text) { try_reader(text, mesh::parse_obj); }
