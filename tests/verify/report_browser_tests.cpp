// The HTML report in a browser: on a phone, on a desk, in the dark, and on paper.
#include "tests/support/browser.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/verify/small_campaign.hpp"
#include "verify/report/html.hpp"

using namespace requad;
using namespace requad::tests;

namespace {

// Texts that are seen but have too little contrast with what lies below them: at least 4.5 is asked for (WCAG 2.1, 1.4.3).
const char* const kTooFaint = R"((() => {
  const channel = (x) => x <= 0.03928 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
  const parts = (colour) => (colour.match(/[\d.]+/g) ?? []).map(Number);
  const luminance = (c) => 0.2126 * channel(c[0] / 255) + 0.7152 * channel(c[1] / 255) + 0.0722 * channel(c[2] / 255);
  const ground = (e) => {
    for (; e; e = e.parentElement) {
      const c = parts(getComputedStyle(e).backgroundColor);
      if (c.length === 3 || c[3] === 1) return c;
    }
    return [255, 255, 255];
  };
  const faint = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  let seen = 0;
  while (walker.nextNode()) {
    const e = walker.currentNode.parentElement;
    if (!walker.currentNode.textContent.trim() || !e.checkVisibility()) continue;
    ++seen;
    const style = getComputedStyle(e);
    const [a, b] = [luminance(parts(e.closest('svg') ? style.fill : style.color)), luminance(ground(e))];
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < 4.5) faint.push([walker.currentNode.textContent.trim().slice(0, 40), contrast]);
  }
  return seen > 300 ? faint : ["only", seen];
})())";

// The least height of letters in pictures, in pixels of the screen.
const char* const kLeastLetters =
    "Math.min(...[...document.querySelectorAll('svg text')].map((t) => "
    "Number(t.getAttribute('font-size')) * t.getScreenCTM().a))";

}  // namespace

TEST_CASE("in a browser, the report can be read at any width, in the dark and on paper", "[report][browser]") {
  const auto program = chromium();
  if (!program) return;
  Browser browser(*program);
  const std::string path = (scratch() / "report.html").string();
  spill(path,
        verify::report_html(run_small(2), small_ranges(), {"0.0 (build 0)", "requad-verify", "today", "here", 1}));
  for (const bool phone : {false, true}) {
    for (const bool dark : {false, true}) {
      CAPTURE(phone, dark);
      browser.set_size(phone ? 390 : 1280, 844, phone);
      browser.set_dark(dark);
      browser.open(path);
      CHECK(browser.evaluate("document.documentElement.scrollWidth") <= (phone ? 390 : 1280));
      CHECK(browser.evaluate(kTooFaint) == nlohmann::json::array());
      CHECK(browser.evaluate(kLeastLetters).get<double>() > 9.5);
      CHECK(browser.evaluate("getComputedStyle(document.body).backgroundColor") ==
            (dark ? "rgb(18, 22, 28)" : "rgb(255, 255, 255)"));
      // All pictures are seen, and none is wider than the page.
      CHECK(
          browser.evaluate("[...document.querySelectorAll('svg')].filter((s) => s.checkVisibility() && s.clientWidth > "
                           "100 && s.clientWidth <= document.body.clientWidth).length") == 12);
      // The first picture is near the top: a reader sees it at once.
      CHECK(browser.evaluate("document.querySelector('svg').getBoundingClientRect().top") < (phone ? 2000 : 1000));
      // A finger can hit each claim.
      CHECK(browser.evaluate("[...document.querySelectorAll('nav a')].every((a) => a.offsetHeight >= 32)") == true);
      CHECK(browser.complaints() == std::vector<std::string>{});
    }
  }
  browser.set_size(700, 990, false);
  browser.set_print(true);
  browser.open(path);
  CHECK(browser.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)");
  CHECK(browser.evaluate(kTooFaint) == nlohmann::json::array());
  CHECK(browser.evaluate("document.querySelector('nav').checkVisibility()") == false);
  CHECK(browser.evaluate("[...document.querySelectorAll('details.rows')].some((d) => d.checkVisibility())") == false);
  // The proofs are printed, though they are closed on the screen.
  CHECK(browser.evaluate("document.querySelectorAll('details.proof').length > 0 && "
                         "[...document.querySelectorAll('details.proof ol')].every((p) => p.offsetHeight > 20 && "
                         "p.checkVisibility({contentVisibilityAuto: true}))") == true);
  CHECK(browser.evaluate("document.documentElement.scrollWidth") <= 700);
}
