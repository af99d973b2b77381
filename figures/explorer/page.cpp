#include "figures/explorer/explorer.hpp"
#include "figures/explorer/sources.hpp"

namespace requad::figures {

namespace {

// Replaces a mark, which occurs once, by a text.
void fill(std::string& page, const std::string& mark, const std::string& text) {
  const std::size_t at = page.find(mark);
  if (at == std::string::npos) throw std::logic_error("the explorer's page has no place " + mark);
  page.replace(at, mark.size(), text);
}

// The JSON for an HTML script element, where neither "</script" nor "<!--" may occur.
std::string embedded(const nlohmann::ordered_json& data) {
  std::string text = data.dump();
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return text;
}

}  // namespace

std::string explorer_page(const nlohmann::ordered_json& data) {
  std::string page = explorer_sources::html;
  fill(page, "<!-- styles -->", explorer_sources::css);
  fill(page, "<!-- data -->", embedded(data));
  fill(page, "<!-- program -->", explorer_sources::program);
  return page;
}

}  // namespace requad::figures
