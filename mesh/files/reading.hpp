// What the readers of OBJ and OFF share. For this room alone.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include "mesh/files/polygon_mesh.hpp"
#include "mesh/text/text_scanner.hpp"

namespace requad::mesh {

inline constexpr std::int64_t kMostVertices = std::numeric_limits<int>::max();

inline void check_corner_count(const TextScanner& scanner, std::int64_t corners) {
  if (corners < 3) scanner.fail("a face has " + std::to_string(corners) + " corners; expected 3 or more");
}

// OFF, or with what Geomview puts before it: [ST][C][N][4][n]OFF.
inline bool is_off_keyword(std::string_view word) {
  return word.ends_with("OFF") && word.substr(0, word.size() - 3).find_first_not_of("STCN4n") == std::string_view::npos;
}

// Throws FileError for a name with another end than those of the formats.
void require_known_end(const std::string& path);
// In the format of the path's end, or else of the first word. `name` stands for the file in messages.
PolygonMesh parse_polygon_mesh(std::string_view text, const std::string& path, const std::string& name);

// Checks what can be checked only when the whole file is read. Throws FileError.
PolygonMesh finished(PolygonMesh m, const TextScanner& scanner);

}  // namespace requad::mesh
