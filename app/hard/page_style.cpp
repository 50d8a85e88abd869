// SPDX-License-Identifier: MIT
#include "app/hard/page.h"

namespace shadowlab::hard {

// Blue, yellow and orange of Okabe and Ito's palette, lightened: distinguishable with any kind of colour vision, and in grey by the
// sign beside them.
const std::string_view kHardStyle = R"(
.matrix { font-size: 13px; line-height: 17px }
.matrix th, .matrix td { padding: 3px 6px; border-right: 1px solid #ddd; white-space: nowrap }
.matrix thead th { position: sticky; top: 0; white-space: normal; min-width: 6.5em; text-align: right }
.matrix .plain { font-weight: normal }
.matrix tbody th { position: sticky; left: 0; background: #fff; white-space: normal; min-width: 14em }
.matrix tbody th span { font-weight: normal }
.matrix small, .legend small { color: #333 }
.exact { background: #d9edf9 } .edges { background: #fbf5c4 } .wrong { background: #f5c26b } .nothing { background: #eee }
.bad { outline: 3px solid #d55e00; outline-offset: -3px; font-weight: bold }
.legend { max-width: none } .legend span { padding: .1rem .4rem; border: 1px solid #999; margin-left: .8rem }
.tests { overflow-wrap: anywhere; max-width: 40rem }
dialog { max-width: min(1100px, 96vw); border: 2px solid #000; padding: 1rem }
dialog h2 { border: 0; margin: 0; padding: 0 }
dialog img { display: block; width: 100%; border: 1px solid #666; image-rendering: pixelated }
/* On a phone the long names of columns are broken, as other tables' are: they stand beside the numbers. */
@media screen and (max-width: 700px) { .matrix td { white-space: normal } }
@media print { .matrix { font-size: 7pt; line-height: 1.3 } .matrix th, .matrix td { padding: 1px 2px; position: static;
  white-space: normal; min-width: 0; print-color-adjust: exact; -webkit-print-color-adjust: exact } dialog { display: none } }
)";

const std::string_view kHardScript = R"(
const dialog = document.getElementById('shown');
for (const link of document.querySelectorAll('.shot'))
  link.addEventListener('click', event => {
    if (event.ctrlKey || event.metaKey || event.shiftKey) return; // a tab of its own, as with any link
    event.preventDefault();
    document.getElementById('about').textContent = link.dataset.about;
    document.getElementById('facts').textContent = link.dataset.facts;
    for (const [id, file, what] of [['picture', link.getAttribute('href'), 'the picture'],
                                    ['errors', link.dataset.errors, 'where it is wrong']]) {
      const image = document.getElementById(id);
      image.src = file; image.alt = link.dataset.about + ': ' + what;
    }
    dialog.showModal();
  });
dialog.addEventListener('click', event => { if (event.target === dialog) dialog.close() });
)";

} // namespace shadowlab::hard
