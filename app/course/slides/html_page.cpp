// SPDX-License-Identifier: MIT
#include "app/course/slides/pages.h"
#include "app/drawing/formula.h"
#include "app/drawing/markup.h"

namespace shadowlab::course {

namespace {

// A slide fills the window as far as its shape allows. Without scripts all slides stand one below the other, as in print.
constexpr std::string_view kStyle = R"(
:root { color-scheme: light }
* { box-sizing: border-box }
body { margin: 0; background: #d9d9d9; color: #1a1a1a; font: 18px/1.4 'DejaVu Sans', Verdana, sans-serif }
section { margin: 0 auto 1rem; max-width: calc(100vh * 16 / 9) }
section img { display: block; width: 100%; height: auto; background: #fff }
h1, h2, .told { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%) }
.caption { margin: 0; padding: .5rem 1rem; background: #fff; border-top: 2px solid #e69f00 }
.one .caption { display: none }
.one.captions .caption { display: block }
.one { overflow: hidden }
.one main { height: 100vh; display: flex; flex-direction: column; justify-content: center }
.one section { display: none; margin: 0 auto; width: 100% }
.one section.now { display: block }
.one.captions section { max-width: calc((100vh - 7rem) * 16 / 9) }
.all main { display: grid; grid-template-columns: repeat(auto-fill, minmax(16rem, 1fr)); gap: 1rem; padding: 1rem }
.all section { margin: 0; cursor: pointer; outline: 2px solid #999 }
.all section.now { outline: 5px solid #e69f00 }
.all .caption { display: none }
#keys { position: fixed; inset: auto 0 0 0; padding: .6rem 1rem; background: #1a1a1a; color: #f5f5f5; font-size: 16px }
#keys[hidden] { display: none }
@media (max-width: 700px) { .one .caption { display: block } }
@media print {
  @page { size: 13.333in 7.5in; margin: 0 }
  body, body.one, body.all { background: none; overflow: visible }
  .one main, .all main { display: block; height: auto; padding: 0 }
  section, .one section, .all section { display: block; margin: 0; max-width: none; outline: none; break-after: page; break-inside: avoid }
  section:last-of-type { break-after: auto }
  section img { width: 13.333in; height: 7.5in; object-fit: contain }
  .caption, .one .caption, #keys { display: none }
}
)";

constexpr std::string_view kScript = R"(
const slides = [...document.querySelectorAll('section')], body = document.body, keys = document.getElementById('keys');
let now = Math.max(0, slides.findIndex(s => '#' + s.id === location.hash));
function show(number) {
  now = Math.min(slides.length - 1, Math.max(0, number));
  slides.forEach((s, i) => { s.classList.toggle('now', i === now); s.inert = body.classList.contains('one') && i !== now });
  history.replaceState(null, '', '#' + slides[now].id);
  document.title = slides[now].getAttribute('aria-label');
  if (body.classList.contains('all')) slides[now].scrollIntoView({ block: 'nearest' });
}
function layout(name) { body.classList.remove('one', 'all'); body.classList.add(name); show(now) }
const does = {
  ArrowRight: () => show(now + 1), PageDown: () => show(now + 1), ' ': () => show(now + 1), n: () => show(now + 1),
  ArrowLeft: () => show(now - 1), PageUp: () => show(now - 1), p: () => show(now - 1),
  Home: () => show(0), End: () => show(slides.length - 1),
  o: () => layout(body.classList.contains('all') ? 'one' : 'all'), Enter: () => layout('one'), Escape: () => layout('one'),
  c: () => body.classList.toggle('captions'), h: () => { keys.hidden = !keys.hidden },
  f: () => document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen(),
};
addEventListener('keydown', e => {
  if (e.ctrlKey || e.altKey || e.metaKey || !does[e.key]) return;
  e.preventDefault(); does[e.key]();
});
addEventListener('hashchange', () => { const i = slides.findIndex(s => '#' + s.id === location.hash); if (i >= 0) show(i) });
let touched = null;
addEventListener('touchstart', e => { touched = e.changedTouches[0].clientX });
addEventListener('touchend', e => {
  const by = e.changedTouches[0].clientX - touched;
  if (Math.abs(by) > 40) show(now + (by < 0 ? 1 : -1));
});
slides.forEach((s, i) => s.addEventListener('click', e => {
  if (body.classList.contains('all')) { now = i; layout('one') }
  else show(now + (e.clientX < innerWidth / 3 ? -1 : 1));
}));
layout('one');
)";

/// All that a slide says beside its pictures, for who cannot see it.
std::string toldWords(const Slide& slide) {
    std::string html;
    for (const std::string& text : slide.text)
        html += "<p>" + drawing::escapedMarkup(text) + "</p>";
    for (const std::string& tex : slide.formulas)
        html += "<p>" + drawing::escapedMarkup(drawing::Formula(tex).spoken()) + "</p>";
    if (!slide.pseudocode.empty()) {
        html += "<ol>";
        for (const std::string& line : slide.pseudocode)
            html += "<li>" + drawing::escapedMarkup(line) + "</li>";
        html += "</ol>";
    }
    return html;
}

} // namespace

std::string htmlPage(const Deck& deck, const std::vector<PageSlide>& slides) {
    std::string page = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
                       drawing::escapedMarkup(deck.title()) + "</title>\n<style>" + std::string(kStyle) +
                       "</style>\n</head>\n<body>\n<h1>" + drawing::escapedMarkup(deck.title()) + "</h1>\n<main>\n";
    for (std::size_t i = 0; i < slides.size(); ++i) {
        const Slide& slide = slides[i].slide;
        const std::string place = std::to_string(i + 1) + " of " + std::to_string(slides.size());
        page += "<section id=\"" + slide.name + "\" aria-label=\"" + place + ": " +
                drawing::escapedMarkup(slide.title) + "\">\n<h2>" + drawing::escapedMarkup(slide.title) +
                "</h2>\n<img alt=\"" + drawing::escapedMarkup(slide.alt.empty() ? slide.title : slide.alt) +
                "\" src=\"data:image/png;base64," + drawing::base64(slides[i].png) + "\">\n";
        if (const std::string words = toldWords(slide); !words.empty())
            page += "<div class=\"told\">" + words + "</div>\n";
        if (!slide.caption.empty()) page += "<p class=\"caption\">" + drawing::escapedMarkup(slide.caption) + "</p>\n";
        page += "</section>\n";
    }
    return page +
           "</main>\n<div id=\"keys\" hidden>Right, Space, PageDown: on. Left, PageUp: back. Home, End. o: all slides. "
           "c: captions. f: full screen. h: this help.</div>\n<script>" +
           std::string(kScript) + "</script>\n</body>\n</html>\n";
}

} // namespace shadowlab::course
