// What the explorer's page looks like in a browser, on a desk and on a phone: nodes, labels, arrows, legend.
#include "tests/figures/explorer_page.hpp"
#include "tests/support/catch.hpp"

using namespace requad;
using namespace requad::tests;
using nlohmann::json;

TEST_CASE("in a browser, the explorer's nodes can be read and hit at any size", "[explorer][browser]") {
  const auto program = chromium();
  if (!program) return;
  ExplorerPage page(*program);
  Browser& browser = page.browser;
  const std::string least =
      "Math.min(...[...document.querySelectorAll('#graph .spot ')].map((s) => {"
      " const t = s.querySelector('text'); return t.checkVisibility() ?"
      " Number(t.getAttribute('font-size')) * t.getScreenCTM().a : 0; }))";
  const std::string current =
      "(() => { const s = document.querySelector('#graph .spot.current').getBoundingClientRect(), "
      "f = document.getElementById('graph-frame').getBoundingClientRect(); return s.left >= f.left "
      "&& s.right <= f.right && s.top >= f.top && s.bottom <= f.bottom; })()";
  for (const bool phone : {false, true}) {
    browser.show_on(phone);
    for (const auto& [e, far] : {std::pair{kDigon6, "4,0"},
                                 {kDigon12, "10,0"},
                                 {kHexagon6, "4,0,1"},
                                 {kHexagon12, "10,0,2"},
                                 {kQuad5, "4,3"}}) {
      page.open(e, far);
      CAPTURE(phone, e.type().name(), e.longest());
      CHECK(browser.evaluate(least).get<double>() > 8.5);
      CHECK(browser.evaluate(current) == true);
      CHECK(browser.evaluate("document.documentElement.scrollWidth") <= (phone ? 390 : 1280));
      if (!phone) continue;
      CHECK(browser.evaluate("[...document.querySelectorAll('#graph .spot ellipse')].every((s) => { const b = "
                             "s.getBoundingClientRect(); return b.width >= 32 && b.height >= 32; })") == true);
      // A phone has no keys.
      CHECK(browser.evaluate("[...document.querySelectorAll('kbd')].some((k) => k.checkVisibility())") == false);
      CHECK(browser.evaluate("document.getElementById('graph-help').textContent").get<std::string>().find("key") ==
            std::string::npos);
    }
  }
  // All of a large graph can be seen at once.
  browser.show_on(false);
  page.open(kHexagon12, "1,1,1");
  const std::string scrolls =
      "(() => { const f = document.getElementById('graph-frame'); return f.scrollWidth > "
      "f.clientWidth + 1; })()";
  CHECK(browser.evaluate(scrolls) == true);
  browser.click("document.getElementById('whole-graph')");
  CHECK(browser.evaluate(scrolls) == false);
  browser.click("document.getElementById('whole-graph')");
  CHECK(browser.evaluate(scrolls) == true);
  CHECK(browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, no label of the explorer's mesh covers another one or the pair", "[explorer][browser]") {
  const auto program = chromium();
  if (!program) return;
  ExplorerPage page(*program);
  Browser& browser = page.browser;
  for (const auto& [e, wheres] : {std::pair{kDigon6, std::vector<std::string>{"1,1", "4,0", "2,2", "0,0"}},
                                  {kDigon12, {"10,0", "5,5", "9,1", "2,0"}},
                                  {kHexagon6, {"1,1,1", "4,0,1", "2,2,3"}},
                                  {kHexagon12, {"10,0,1", "1,1,1", "5,5,2", "1,9,3"}},
                                  {kQuad5, {"1,1", "4,3", "2,2"}}}) {
    for (const std::string& where : wheres) {
      CAPTURE(e.type().name(), e.longest(), where);
      page.open(e, where);
      if (browser.evaluate("document.getElementById('close-up').checked") == true)
        browser.click("document.getElementById('close-up')");
      const json covered = browser.evaluate(R"((() => {
        const boxes = (css) => [...document.querySelectorAll('#mesh ' + css)].map((e) =>
            Object.assign(e.getBoundingClientRect(), {what: e.textContent || css}));
        const labels = [...boxes('.sides text'), ...boxes('.ends text')];
        const all = [...labels, ...boxes('.vertex path'), ...boxes('.head')];
        const found = [];
        labels.forEach((a, i) => all.slice(i + 1).forEach((b) => {
          const x = Math.min(a.right, b.right) - Math.max(a.left, b.left);
          const y = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
          if (x > 1 && y > 3) found.push([a.what, b.what, x, y]);
        }));
        return found;
      })())");
      CHECK(covered == json::array());
    }
  }
}

// In (1,1) eight arrows start at two vertices that are neighbours.
TEST_CASE("in a browser, the explorer's arrows can be told apart", "[explorer][browser]") {
  const auto program = chromium();
  if (!program) return;
  ExplorerPage page(*program);
  Browser& browser = page.browser;
  for (const bool phone : {false, true}) {
    browser.show_on(phone);
    for (const auto& [e, where] : {std::pair{kDigon6, "1,1"},
                                   {kDigon12, "1,1"},
                                   {kDigon12, "2,0"},
                                   {kHexagon6, "1,1,1"},
                                   {kHexagon12, "1,1,1"},
                                   {kQuad5, "2,2"}}) {
      page.open(e, where);
      CAPTURE(phone, e.type().name(), e.longest(), where);
      const json least = browser.evaluate(R"((() => {
        const middle = (p) => { const b = p.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; };
        const heads = [...document.querySelectorAll('#mesh .arrow .head')].map(middle);
        const vertices = [...document.querySelectorAll('#mesh .vertex path')].map(middle);
        const sizes = [...document.querySelectorAll('#mesh .arrow .head')].map((p) => p.getBoundingClientRect().height);
        const apart = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);
        let heads_apart = Infinity, from_vertices = Infinity;
        heads.forEach((p, i) => heads.slice(i + 1).forEach((q) => heads_apart = Math.min(heads_apart, apart(p, q))));
        heads.forEach((p) => vertices.forEach((q) => from_vertices = Math.min(from_vertices, apart(p, q))));
        return [heads.length, heads_apart / Math.max(...sizes), from_vertices, Math.min(...sizes)];
      })())");
      CAPTURE(least.dump());
      CHECK(least[0] == 8);
      CHECK(least[1] > 0.9);
      CHECK(least[2] > 11);
      CHECK(least[3] > 7);
    }
  }
}

TEST_CASE("in a browser, the explorer's legend shows what the drawings show", "[explorer][browser]") {
  const auto program = chromium();
  if (!program) return;
  ExplorerPage page(*program);
  Browser& browser = page.browser;
  for (const bool dark : {false, true}) {
    browser.set_dark(dark);
    page.open(kDigon6, "1,1");
    browser.evaluate("document.getElementById('film-to').dispatchEvent(new Event('change'))");  // shows the path
    for (const auto& [drawing, part] : {std::pair{"#mesh", ".alpha path"},
                                        {"#mesh", ".rim path"},
                                        {"#mesh", ".separatrices path"},
                                        {"#mesh", ".vertex.v3 path"},
                                        {"#mesh", ".vertex.v3 text"},
                                        {"#mesh", ".arrow.up .shaft"},
                                        {"#mesh", ".arrow.up .head"},
                                        {"#graph", ".spot.current ellipse"},
                                        {"#graph", ".spot.reachable:not(.copy) ellipse"},
                                        {"#graph", ".spot.copy:not(.reachable) ellipse"},
                                        {"#graph", ".path .path"}}) {
      CAPTURE(dark, part);
      const std::string styles = std::string(
                                     "(() => { const of = (root) => { const s = getComputedStyle("
                                     "document.querySelector(root + ' ") +
                                 part +
                                 "')); return [s.fill, s.stroke, s.strokeWidth, s.strokeDasharray, s.vectorEffect]; };"
                                 " return [of('#legend'), of('" +
                                 drawing + "')]; })()";
      const json both = browser.evaluate(styles);
      CHECK(both[0] == both[1]);
    }
  }
}
