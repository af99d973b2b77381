// The sources of the explorer's page: explorer.html, explorer.css and the .js files, joined in order. CMake embeds them
// into the library; see embed.cmake.
#pragma once

namespace requad::figures::explorer_sources {

extern const char* const html;
extern const char* const css;
extern const char* const program;

}  // namespace requad::figures::explorer_sources
