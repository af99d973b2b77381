// Numbers as people read them, the same in every locale.
#pragma once

#include <cstdint>
#include <string>

namespace requad::verify {

std::string grouped(std::int64_t number);  // "117 886", with thin spaces that do not break
std::string seconds_text(double seconds);  // "under 0.01 s", "0.04 s", "12.3 s", "8 min 20 s", "2 h 5 min"

}  // namespace requad::verify
