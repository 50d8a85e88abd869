// SPDX-License-Identifier: MIT
#include "app/report/page/page_style.h"

namespace shadowlab::report {

// Every number and picture can be read without the script below: it sorts, folds the pictures away, and copies commands.
const std::string_view kPageStyle = R"(
:root { color-scheme: light }
* { box-sizing: border-box }
body { margin: 0 auto; max-width: 1500px; padding: 0 1.2rem 3rem; color: #000; background: #fff;
  font: 15px/1.45 'DejaVu Sans', Verdana, sans-serif }
h1 { font-size: 1.7rem; margin: 1.2rem 0 .4rem }
h2 { font-size: 1.3rem; margin: 2.5rem 0 .5rem; padding-top: .6rem; border-top: 3px solid #000 }
h3 { font-size: 1.05rem; margin: 1.5rem 0 .4rem }
p { max-width: 75ch; margin: .4rem 0 }
a { color: #00548a }
:focus-visible { outline: 3px solid #d55e00; outline-offset: 1px }
.wide { overflow-x: auto; border: 1px solid #999 }
table { border-collapse: separate; border-spacing: 0; width: 100% }
caption { text-align: left; padding: .4rem .5rem; font-weight: bold }
th, td { padding: .25rem .5rem; text-align: right; vertical-align: top; border-bottom: 1px solid #ccc;
  font-variant-numeric: tabular-nums }
thead th { background: #ececec; border-bottom: 2px solid #000; vertical-align: bottom }
td:not(.text) { white-space: nowrap }
.text { text-align: left }
.details > td { white-space: normal }
.text.name { min-width: 15.5rem; overflow-wrap: anywhere }
/* Rows as high as whole pixels: else the lines below the heads, which stay when the table is moved, come and go. */
.points { font-size: 14px; line-height: 21px }
.points th, .points td { padding: 4px 6px }
.points tbody th { position: sticky; left: 0; background: #fff; font-weight: normal }
.points tbody:target th, .points tbody:target td { background: #e3f1fa }
.best > tr:first-child > * { font-weight: bold }
.mark { width: 1.1em; height: 1.1em; vertical-align: -.2em; margin-right: .3em }
.chart { margin: .8rem 0; max-width: 1000px }
.chart svg { width: 100%; height: auto; border: 1px solid #999 }
.phone-legend { display: none }
.spot:hover circle { stroke: #d55e00; stroke-width: 4px }
.verdict { font-weight: bold }
.verdict + .text { min-width: 18rem }
.details > td { text-align: left; background: #f6f6f6 }
.shown { position: sticky; left: .5rem; max-width: min(1100px, calc(100vw - 4rem)) }
.pair { display: flex; flex-wrap: wrap; gap: 1rem; margin: .3rem 0 }
figure { margin: 0 }
.pair figure { flex: 1 1 320px; max-width: 640px }
.pair svg { display: block; width: 100%; height: auto; border: 1px solid #666; background: #fff; image-rendering: pixelated }
figcaption { font-size: .9em; margin-top: .2rem }
.command { display: flex; flex-wrap: wrap; gap: .5rem; align-items: flex-start; margin: .4rem 0 }
code { font: 14px/1.4 'DejaVu Sans Mono', monospace; background: #fff; border: 1px solid #999; padding: .2rem .4rem;
  overflow-wrap: anywhere; flex: 0 1 auto }
button { font: inherit; color: inherit; cursor: pointer }
thead button { border: 0; background: none; padding: 0; font-weight: bold; text-align: inherit }
th[aria-sort] button { text-decoration: underline }
th[aria-sort=ascending] button::after { content: ' ▲' }
th[aria-sort=descending] button::after { content: ' ▼' }
.open { border: 0; background: none; padding: 0; text-align: left; color: #00548a }
.open::before { content: '▸ ' }
.open[aria-expanded=true]::before { content: '▾ ' }
.told { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%) }
.store { position: absolute; width: 0; height: 0; overflow: hidden }
/* A phone: a chart's plot is as wide as the screen, and its legend is text below it; a row of a table becomes a card, its cells below one
   another. Their names come from the script; without it the table is moved sideways. */
@media screen and (max-width: 700px) {
  body { padding: 0 .8rem 2rem }
  h1 { font-size: 1.4rem }
  .plot { position: relative; overflow: hidden; aspect-ratio: var(--shape); border: 1px solid #999 }
  .plot svg { position: absolute; width: calc(100% * var(--wide)); left: calc(-100% * var(--left)); top: calc(-100% * var(--top));
    border: 0 }
  .phone-legend { display: block; margin: .5rem 0; overflow-wrap: anywhere }
  .phone-legend ul { list-style: none; margin: 0; padding: 0 }
  .phone-legend ol { margin: .2rem 0; padding-left: 1.6rem }
  .phone-legend .mark { position: static; width: 1.1em; border: 0 }
  .text.name { min-width: 9rem }
  .cards, .cards tbody, .cards tr, .cards th, .cards td { display: block; width: auto; min-width: 0 }
  .cards caption { display: block }
  .cards thead, .cards tr[hidden] { display: none }
  .cards tr { border-bottom: 2px solid #000; padding: .2rem 0 }
  .cards tbody th { position: static; border: 0; font-size: 1.05em; white-space: normal }
  .cards td { border: 0; text-align: left; white-space: normal; overflow-wrap: anywhere }
  .cards td[data-head] { display: flow-root; text-align: right; border-top: 1px solid #ddd }
  .cards td[data-head]::before { content: attr(data-head); float: left; width: 45%; margin-right: 1rem; text-align: left; color: #333;
    font-weight: normal }
  .cards .shown { position: static; max-width: none }
  .verdict + .text { min-width: 0 }
}
@media print {
  @page { size: A4 landscape; margin: 12mm }
  body { font-size: 9pt; max-width: none; padding: 0 }
  .wide { overflow: visible; border: 0 }
  .points { font-size: 8pt; line-height: 1.4 }
  .points th, .points td { padding: .15rem .25rem; position: static }
  .text.name { min-width: 8rem }
  .chart { max-width: 17cm; break-inside: avoid }
  h2 { break-before: page }
  h2.first { break-before: auto }
  tbody, figure { break-inside: avoid }
  thead { display: table-header-group }
  .copy { display: none }
  .verdict + .text { min-width: 0 }
  .points-frame { break-before: page }
  .growth { break-inside: avoid }
  thead button { display: contents }
  thead th, .details > td { print-color-adjust: exact; -webkit-print-color-adjust: exact }
}
)";

const std::string_view kPageScript = R"(
const told = document.getElementById('told');
function valueOf(body, column) {
  const text = body.rows[0].cells[column].dataset.v;
  return text === undefined ? body.rows[0].cells[column].textContent : text === '' ? null : Number(text);
}
function compare(a, b, sign) {
  if (a === null || b === null) return (a === null) - (b === null);
  return sign * (typeof a === 'number' ? a - b : a.localeCompare(b, 'en', { numeric: true }));
}
function sortBy(table, column) {
  const head = table.tHead.rows[0].cells[column], down = head.getAttribute('aria-sort') === 'ascending';
  for (const cell of table.tHead.rows[0].cells) cell.removeAttribute('aria-sort');
  head.setAttribute('aria-sort', down ? 'descending' : 'ascending');
  [...table.tBodies].sort((a, b) => compare(valueOf(a, column), valueOf(b, column), down ? -1 : 1))
    .forEach(body => table.append(body));
  told.textContent = 'Sorted by ' + head.textContent + (down ? ', descending' : ', ascending');
}
for (const table of document.querySelectorAll('table.sortable'))
  [...table.tHead.rows[0].cells].forEach((cell, column) => {
    const button = document.createElement('button');
    button.type = 'button'; button.append(...cell.childNodes); cell.append(button);
    button.addEventListener('click', () => sortBy(table, column));
  });
function show(body, isShown) {
  body.rows[1].hidden = !isShown;
  body.querySelector('.open').setAttribute('aria-expanded', isShown);
}
for (const body of document.querySelectorAll('.points tbody')) {
  const name = body.rows[0].cells[0], button = document.createElement('button');
  button.type = 'button'; button.className = 'open'; button.append(...name.childNodes); name.append(button);
  button.setAttribute('aria-controls', body.rows[1].id);
  show(body, false);
  body.rows[0].addEventListener('click', () => { if (String(getSelection()) === '') show(body, body.rows[1].hidden) });
}
for (const line of document.querySelectorAll('.command')) {
  const button = document.createElement('button'), code = line.querySelector('code');
  button.type = 'button'; button.className = 'copy'; button.textContent = 'Copy'; line.append(button);
  button.addEventListener('click', async () => {
    getSelection().selectAllChildren(code);
    try { await navigator.clipboard.writeText(code.textContent); told.textContent = button.textContent = 'Copied' }
    catch { told.textContent = button.textContent = 'Selected: press Ctrl+C' }
  });
}
function showTarget() {
  const body = document.getElementById(location.hash.slice(1));
  if (body && body.matches('.points tbody')) { show(body, true); body.scrollIntoView({ block: 'start' }) }
}
addEventListener('hashchange', showTarget);
for (const spot of document.querySelectorAll('.spot'))
  spot.addEventListener('click', () => { if (spot.getAttribute('href') === location.hash) showTarget() });
showTarget();
)";

// The head of its column beside every cell, for the cards of a phone.
const std::string_view kCardsScript = R"(
for (const table of document.querySelectorAll('.wide table')) {
  const heads = [...table.tHead.rows[table.tHead.rows.length - 1].cells].map(head => head.textContent.trim());
  for (const body of table.tBodies)
    for (const row of body.rows)
      if (row.cells.length === heads.length)
        [...row.cells].forEach((cell, i) => { if (cell.matches('td')) cell.dataset.head = heads[i] });
  table.classList.add('cards');
}
)";

} // namespace shadowlab::report
