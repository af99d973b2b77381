// CRC-32 as text, for what must be told apart or found damaged.
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
  // Eight hexadecimal digits, of all bytes so far.
  std::string text() const {
    std::array<char, kDigits + 1> digits{};
    std::snprintf(digits.data(), digits.size(), "%08x", crc_.checksum());
    return digits.data();
  }

 private:
  boost::crc_32_type crc_;
};

}  // namespace requad::program
