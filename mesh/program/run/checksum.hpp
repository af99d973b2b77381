// CRC-32 as text. It tells files apart and finds damaged lines.
#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <string_view>

#include <boost/crc.hpp>

namespace requad::program {

class Checksum {
 public:
  static constexpr std::size_t kDigits = 8;

  void add(std::string_view bytes) { crc_.process_bytes(bytes.data(), bytes.size()); }
  // The checksum of all bytes so far, in kDigits hexadecimal digits.
  std::string text() const {
    std::array<char, kDigits + 1> digits{};
    std::snprintf(digits.data(), digits.size(), "%08x", crc_.checksum());
    return digits.data();
  }

 private:
  boost::crc_32_type crc_;
};

}  // namespace requad::program
