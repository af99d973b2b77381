#include "tests/figures/explorer_page.hpp"

#include <filesystem>

#include "figures/explorer/explorer.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/theory/integer_vector.hpp"

namespace requad::tests {

const Example kDigon6{theory::kDigon, sides({6, 6})};
const Example kDigon12{theory::kDigon, sides({12, 12})};
const Example kHexagon6{theory::kHexagon, sides({6, 6, 6, 6, 6, 6})};
const Example kHexagon12{theory::kHexagon, sides({12, 12, 12, 12, 12, 12})};
const Example kQuad5{theory::kQuad, sides({6, 5, 5, 8})};

ExplorerPage::ExplorerPage(const std::string& program) : browser(program) {
  browser.show_on(false);
  browser.set_reduced_motion(true);
}

void ExplorerPage::open(const Example& e, const std::string& address) {
  const std::string name = "page-" + e.type().name() + "-" + std::to_string(e.longest()) + ".html";
  const std::string path = (scratch() / name).string();
  if (!std::filesystem::exists(path)) spill(path, figures::explorer_page(figures::explorer_data(explored(e))));
  browser.open(path, address);
  REQUIRE(browser.wait("window.explorer"));
}

}  // namespace requad::tests
