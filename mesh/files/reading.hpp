// What the readers of OBJ and OFF share. For this room alone.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include "mesh/files/polygon_mesh.hpp"
#include "mesh/files/text_scanner.hpp"

namespace requad::mesh {

inline constexpr std::int64_t kMostVertices = std::numeric_limits<int>::max();

inline void check_corner_count(const TextScanner& scanner, std::int64_t corners) {
  if (corners < 3) scanner.fail("a face has " + std::to_string(corners) + " corners; expected 3 or more");
}

// OFF, or with what Geomview puts before it: [ST][C][N][4][n]OFF.
inline bool is_off_keyword(std::string_view word) {
  return word.ends_with("OFF") && word.substr(0, word.size() - 3).find_first_not_of("STCN4n") == std::string_view::npos;
}

// Checks what can be checked only when the whole file is read. Throws FileError.
PolygonMesh finished(PolygonMesh m, const TextScanner& scanner);

}  // namespace requad::mesh
