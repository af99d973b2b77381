#include "mesh/files/attributes.hpp"

#include <algorithm>
#include <array>

namespace requad::mesh {

bool is_statement(std::string_view keyword) {
  static constexpr std::array<std::string_view, 10> all{"o",      "g",     "usemtl", "s",          "mg",
                                                        "usemap", "bevel", "lod",    "shadow_obj", "trace_obj"};
  return std::find(all.begin(), all.end(), keyword) != all.end();
}

std::string not_kept_text(const Attributes& attributes) {
  std::string text;
  for (const auto& [kind, count] : attributes.not_kept) {
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
  }
  return text;
}

}  // namespace requad::mesh
