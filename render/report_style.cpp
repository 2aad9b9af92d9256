#include "render/report_style.h"

namespace collage {

std::string_view report_style() {
  return R"(:root {
  color-scheme: light dark;
  --page: #fbfaf7; --ink: #201e1b; --quiet: #69645c; --line: #dfdbd3; --shade: #f1eee8; --good: #2c6a46; --bad: #a3271c;
  --plot-1: #14637a; --plot-2: #b4492a; --plot-3: #7d6212; --plot-4: #7f2c52;
  --serif: "Iowan Old Style", "Palatino Linotype", Palatino, "URW Palladio L", P052, Charter, Georgia, "DejaVu Serif", serif;
  --sans: system-ui, "Segoe UI", "Helvetica Neue", Arial, "DejaVu Sans", sans-serif;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --page: #161514; --ink: #e9e6df; --quiet: #a09a90; --line: #35322e; --shade: #201e1c; --good: #7fc59b; --bad: #f08d80;
    --plot-1: #6bbcd3; --plot-2: #ea8f6c; --plot-3: #d1b358; --plot-4: #d88fb2;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto; max-width: 74rem; padding: clamp(1.25rem, 5vw, 4.5rem) clamp(1rem, 4vw, 3rem); background: var(--page); color: var(--ink);
  font: 1.0625rem/1.6 var(--serif); font-variant-numeric: lining-nums tabular-nums; overflow-wrap: anywhere; text-wrap: pretty;
  -webkit-text-size-adjust: 100%; text-size-adjust: 100%;
}
h1, h2, h3, p, figure, dl, dd, ul, pre { margin: 0; padding: 0; }
h1 { font-size: clamp(2.1rem, 6vw, 3.6rem); line-height: 1.08; font-weight: 400; letter-spacing: -.012em; text-wrap: balance; }
.lede { max-width: 40rem; margin-top: 1.1rem; font-size: 1.2rem; line-height: 1.5; color: var(--quiet); }
.verdict { max-width: 40rem; margin-top: 1.4rem; padding-left: .9rem; border-left: 3px solid var(--good); font: .95rem/1.5 var(--sans); }
.verdict strong { color: var(--good); font-weight: 600; }
.failed { border-color: var(--bad); }
.failed strong { color: var(--bad); }
figcaption, caption, thead, .note, .numbers dt, .credits, footer { color: var(--quiet); font-family: var(--sans); font-size: .84rem; line-height: 1.45; }
figcaption { margin-top: .6rem; max-width: 44rem; }
img { display: block; width: 100%; height: auto; background: var(--shade); }
.pictures, .plots { display: grid; gap: 1.75rem 1.5rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 15rem), 1fr)); }
.plots { grid-template-columns: repeat(auto-fit, minmax(min(100%, 21rem), 1fr)); }
.plots figure { display: flex; flex-direction: column; justify-content: flex-end; max-width: 36rem; font-family: var(--sans); }
.plots figcaption { margin: 0 0 .5rem; color: var(--ink); font-size: .9rem; }
header .pictures { margin-top: 1.75rem; }
.hero { margin-top: 2.75rem; }
.numbers { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 8.5rem), 1fr)); gap: 1.5rem; }
.numbers div { display: flex; flex-direction: column-reverse; justify-content: flex-end; }
.numbers dd { font-size: 1.9rem; line-height: 1.2; }
header .numbers { margin-top: 2.5rem; }
section { margin-top: 2.75rem; padding-top: 1.6rem; border-top: 1px solid var(--line); }
h2 { margin-bottom: 1.25rem; font-size: 1.35rem; line-height: 1.25; font-weight: 400; }
h3 { font-size: 1.15rem; line-height: 1.3; font-weight: 400; }
.content { min-width: 0; }
.content > * + * { margin-top: 2rem; }
.content > p { max-width: 40rem; }
.content > p + p { margin-top: .8rem; }
@media (min-width: 56rem), print {
  section:not(.wide) { display: grid; grid-template-columns: 11rem minmax(0, 1fr); column-gap: 3rem; }
}
.scroll { overflow-x: auto; }
.scroll:focus-visible, a:focus-visible { outline: 2px solid var(--plot-1); outline-offset: 3px; }
table { border-collapse: collapse; width: 100%; font: .92rem/1.45 var(--sans); overflow-wrap: break-word; }
.narrow { max-width: 44rem; }
caption { text-align: left; padding-bottom: .6rem; color: var(--ink); font-size: .9rem; }
th, td { padding: .55rem 0 .55rem 1.4rem; vertical-align: baseline; text-align: left; font-weight: 400; border-bottom: 1px solid var(--line); }
th:first-child, td:first-child { padding-left: 0; }
tbody tr:last-child > * { border-bottom: 0; }
thead th { padding-top: .2rem; vertical-align: bottom; border-bottom-color: var(--quiet); }
tbody th { min-width: 8rem; max-width: 30rem; }
th.number, td.number { text-align: right; }
td.number, thead .number { white-space: nowrap; }
.wide thead th:first-child, .wide tbody th { position: sticky; left: 0; background: var(--page); }
.note { display: block; max-width: 32rem; }
.cards { display: grid; gap: 2.5rem 1.75rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 17rem), 1fr)); }
.card h3 { margin-top: .9rem; }
.card p { margin-top: .3rem; font: .9rem/1.5 var(--sans); color: var(--quiet); }
.card .numbers { margin-top: .8rem; gap: .3rem 1.1rem; display: flex; flex-wrap: wrap; }
.card .numbers dd { font-size: 1.15rem; }
a { color: inherit; text-decoration-color: var(--quiet); text-decoration-thickness: 1px; text-underline-offset: .18em; }
pre { padding: 1rem 1.2rem; background: var(--shade); font: .88rem/1.7 ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace; white-space: pre-wrap; }
pre code { display: block; font: inherit; padding-left: 1.4em; text-indent: -1.4em; }
pre span { display: inline-block; vertical-align: top; max-width: 100%; text-indent: 0; }
pre code::before { content: "$ "; color: var(--quiet); }
.credits { list-style: none; }
.credits li + li { margin-top: .6rem; }
.credits cite { color: var(--ink); }
footer { margin-top: 3rem; padding-top: 1rem; border-top: 1px solid var(--line); }
@page { margin: 16mm 15mm 18mm; }
@media print {
  :root { --page: #fff; --ink: #000; --quiet: #555; --line: #d8d8d8; --shade: #f4f4f4; font-size: 9.5pt; }
  body { max-width: none; padding: 0; }
  section { margin-top: 1.4rem; padding-top: 1.1rem; }
  .content > * + * { margin-top: 1.3rem; }
  section:not(.wide) { grid-template-columns: 30mm minmax(0, 1fr); column-gap: 7mm; }
  .hero { margin-top: 1.5rem; }
  .hero img { width: auto; max-width: 100%; max-height: 115mm; }
  .pictures { grid-template-columns: repeat(auto-fit, minmax(48mm, 1fr)); }
  .plots { grid-template-columns: repeat(auto-fit, minmax(60mm, 1fr)); }
  .cards { grid-template-columns: repeat(auto-fill, minmax(50mm, 1fr)); }
  .scroll { overflow: visible; }
  .wide table { font-size: 7pt; }
  .wide table th, .wide table td { padding-left: .7em; }
  tbody th { min-width: 0; overflow-wrap: anywhere; }
  h2, h3, caption, thead, .content > p { break-after: avoid; }
  figure, tr, .card, .numbers, .verdict, pre, li { break-inside: avoid; }
  footer { margin-top: 1.2rem; padding-top: .6rem; break-before: avoid; }
}
)";
}

}  // namespace collage
