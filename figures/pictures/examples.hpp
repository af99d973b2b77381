// The meshes of the figures in space: the OBJ files of mesh/examples, which CMake embeds into the library (embed.cmake);
// and what was measured.
#pragma once

namespace requad::figures::examples {

extern const char* const roof;           // Figure 1
extern const char* const dome;           // Figure 15
extern const char* const rounded_block;  // Figure 16
extern const char* const cylinder;       // Figure 17
extern const char* const sharp_block;    // Figure 18
extern const char* const rabbit;         // Figure 19

extern const char* const shape;  // bench/shape.json: what bench/shape measured

}  // namespace requad::figures::examples
