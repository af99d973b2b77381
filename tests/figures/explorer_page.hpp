// The explorer's page of some regions, open in a browser.
#pragma once

#include <string>

#include "tests/figures/explorer_examples.hpp"
#include "tests/support/browser.hpp"

namespace requad::tests {

extern const Example kDigon6, kDigon12, kHexagon6, kHexagon12, kQuad5;

class ExplorerPage {
 public:
  // Results appear at once.
  explicit ExplorerPage(const std::string& program);

  // Opens the page of a region at an address, and waits until it is there.
  void open(const Example& example, const std::string& address = "");
  // The configuration that is shown.
  std::string label() { return browser.evaluate("explorer.state().label"); }
  std::string hash() { return browser.evaluate("location.hash"); }
  // Whether the page comes to this configuration.
  bool comes_to(const std::string& label) { return browser.wait("explorer.state().label === '" + label + "'", 5); }
  // Whether the page says that something is wrong.
  bool notice() { return browser.evaluate("document.getElementById('notice').checkVisibility()"); }

  Browser browser;
};

}  // namespace requad::tests
