#include "verify/report/style.hpp"

namespace requad::verify {

// The colours of meshes are those of the explorer.
const char* const kReportStyle = R"(:root {
  color-scheme: light dark;
  --ground: #ffffff; --panel: #f6f7f9; --ink: #1c2430; --soft: #55606d; --line: #c3cad3; --link: #1a5596;
  --edge: #6c7783; --rim: #1c2430; --alpha: #bcd7f5; --walk: #2f7d4f;
  --v2: #7b3fa0; --v3: #1f5fa8; --v5: #c86400; --v6: #b3261e;
  --digon: #b3261e; --hexagon: #1f5fa8;
  --holds: #1b6e3a; --fails: #b3261e; --undecided: #8a5a00;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --ground: #12161c; --panel: #1b2129; --ink: #e8edf3; --soft: #a9b4c0; --line: #3a4552; --link: #8cbcf3;
    --edge: #8f9ba8; --rim: #e8edf3; --alpha: #24476e; --walk: #74cf9a;
    --v2: #c79be8; --v3: #7db4f0; --v5: #f5a04b; --v6: #ff8d82;
    --digon: #ff9d92; --hexagon: #7db4f0;
    --holds: #74cf9a; --fails: #ff9d92; --undecided: #f0c274;
  }
}
* { box-sizing: border-box; }
html { scroll-padding-top: 1rem; }
body {
  margin: 0 auto; max-width: 62rem; padding: 1.5rem 1rem 4rem; background: var(--ground); color: var(--ink);
  font: 16px/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; overflow-wrap: break-word;
}
h1 { margin: 0 0 0.5rem; line-height: 1.2; font-size: 1.9rem; }
h2 { margin: 0 0 0.75rem; line-height: 1.3; font-size: 1.3rem; }
h3 { margin: 1.5rem 0 0.5rem; font-size: 1.05rem; }
section { margin-top: 2.5rem; border-top: 1px solid var(--line); padding-top: 1.25rem; }
p, figcaption, dd, li { max-width: 46rem; }
a { color: var(--link); }
.soft, .where, figcaption { color: var(--soft); }
.where { font-weight: 400; font-size: 1rem; margin: 0 0.4rem; }
.summary { font-size: 1.2rem; font-weight: 600; }
.statement { font-size: 1.05rem; }
.holds { color: var(--holds); } .fails { color: var(--fails); } .undecided { color: var(--undecided); }
.verdict { display: inline-block; border: 1px solid; border-radius: 1rem; padding: 0 0.6rem; font-size: 0.9rem; }
.verdict.holds::before { content: "\2713\00a0"; } .verdict.fails::before { content: "\2717\00a0"; }
.verdict.undecided::before { content: "?\00a0"; }
dl { display: grid; grid-template-columns: minmax(5.5rem, max-content) minmax(0, 1fr); gap: 0.25rem 1rem; margin: 0.75rem 0; }
dt { color: var(--soft); }
dd { margin: 0; }
.methods dt { color: var(--ink); font-weight: 600; }
code { overflow-wrap: anywhere; }
nav { margin-top: 1rem; }
nav a { display: inline-block; padding: 0.3rem 0.5rem; min-width: 2.4rem; }
figure { margin: 1rem 0; }
figcaption { font-size: 0.92rem; margin-top: 0.25rem; }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(13rem, 1fr)); gap: 1rem; }
.cards figure { margin: 0; background: var(--panel); border-radius: 0.6rem; padding: 0.8rem; }
.cards svg { display: block; margin: 0 auto 0.5rem; height: 9.5rem; }
.cards strong { color: var(--ink); }
.scroll { overflow-x: auto; max-width: 100%; }
table { border-collapse: collapse; font-size: 0.9rem; margin: 0.5rem 0; }
th, td { padding: 0.3rem 0.7rem; text-align: right; vertical-align: top; border-bottom: 1px solid var(--line); }
th { vertical-align: bottom; font-weight: 600; color: var(--soft); line-height: 1.25; min-width: 6.5rem; max-width: 10rem; }
td { font-variant-numeric: tabular-nums; white-space: nowrap; }
td.words, th.words { text-align: left; }
details { margin: 0.75rem 0; }
summary { cursor: pointer; padding: 0.4rem 0; }
:focus-visible { outline: 3px solid var(--link); outline-offset: 2px; }

/* Pictures. */
.picture { max-width: 100%; height: auto; }
.picture path, .picture circle { stroke-linejoin: round; stroke-linecap: round; fill: none; }
.picture text { fill: var(--ink); font-family: inherit; }
.picture .tick { fill: var(--soft); }
.mesh .ground { fill: var(--ground); }
.mesh .alpha { fill: var(--alpha); }
.mesh .edges { stroke: var(--edge); stroke-width: 0.9; }
.mesh .rim { stroke: var(--rim); stroke-width: 1.8; }
.mesh .vertex { stroke: var(--ground); stroke-width: 1; }
.mesh .v2 { fill: var(--v2); } .mesh .v3 { fill: var(--v3); } .mesh .v5 { fill: var(--v5); } .mesh .v6 { fill: var(--v6); }
.cards .mesh .ground { fill: var(--ground); }
.graph .line { stroke: var(--soft); stroke-width: 2.5; }
.graph .plate { fill: var(--ground); }
.copy .rim { stroke-dasharray: 5 5; }
.copy .edges { stroke: var(--line); }
.copy .alpha { fill: none; }
.plot .gridline { stroke: var(--line); }
.plot .axis { stroke: var(--soft); stroke-width: 1.5; }
.plot .line { stroke-width: 2; }
.plot .digon { --colour: var(--digon); } .plot .hexagon { --colour: var(--hexagon); }
.plot .line, .plot .mark { stroke: var(--colour, var(--ink)); }
.plot .hexagon .line { stroke-dasharray: 9 5; }
.plot .mark { stroke-width: 1.4; }
.plot .dot { fill: var(--colour, var(--ink)); }
.times .bar { fill: var(--hexagon); }
.times .other { fill: var(--soft); }

@media (max-width: 40rem) {
  body { padding-top: 1rem; }
  h1 { font-size: 1.5rem; }
  nav a { padding: 0.45rem 0.5rem; }
  dl { grid-template-columns: minmax(0, 1fr); gap: 0; }
  dd { margin-bottom: 0.5rem; }
  th, td { padding: 0.3rem 0.45rem; }
  .overview { font-size: 0.85rem; }
  .overview th { min-width: 0; }
  .overview td.words { white-space: normal; }
}
@media print {
  @page { margin: 18mm 16mm; }
  body { max-width: none; padding: 0; font-size: 10pt; }
  nav, details.rows { display: none; }
  a { color: inherit; text-decoration: none; }
  section { break-before: auto; }
  h2, h3 { break-after: avoid; }
  figure, tr, dl { break-inside: avoid; }
  p, li, dd { orphans: 3; widows: 3; }
  /* Proofs are printed whether they are open or not. */
  details.proof::details-content { content-visibility: visible; display: block; block-size: auto; }
  .scroll { overflow: visible; }
  .picture, .verdict { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  .cards { grid-template-columns: repeat(3, 1fr); }
}
)";

}  // namespace requad::verify
