// Configurations as a table, one to a row.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "theory/configurations.hpp"

namespace requad::enumerate {

class ConfigurationRows {
 public:
  explicit ConfigurationRows(theory::PairType type) : type_(type) {}

  void add(const theory::Configuration& c, int faces, const std::string& signature);
  std::size_t size() const { return rows_.size(); }

  // A line of names, then a line for each configuration: d1, d2, p, m, n, the strips e1, e2, ..., faces and signature
  // (theory/configurations.hpp). No field needs quotes.
  std::string csv() const;
  // [{"d1": .., "d2": .., "p": .., "m": .., "n": .., "e": [..], "faces": .., "label": "..", "signature": ".."}, ...]
  nlohmann::ordered_json json() const;
  // In columns, without the signatures.
  std::string text() const;

 private:
  struct Row {
    theory::Configuration configuration;
    int faces;
    std::string signature;
  };
  // The names of the columns, or the numbers of a row, but for the signature.
  std::vector<std::string> heading() const;
  std::vector<std::string> numbers(const Row& row) const;

  theory::PairType type_;
  std::vector<Row> rows_;
};

}  // namespace requad::enumerate
