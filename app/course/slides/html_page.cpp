// SPDX-License-Identifier: MIT
#include "app/course/slides/pages.h"

#include "app/drawing/formula.h"
#include "app/drawing/markup.h"
#include "app/drawing/prose.h"
#include "app/picture/verdict_reasons.h"

namespace shadowlab::course {

namespace {

// A slide fills the window as far as its shape allows; below it stand its caption or its notes, if they are wanted, and the keys. Without
// scripts all slides stand one below the other, as in print. On a phone they do so too: there each is its title, the part of the slide
// that its pictures fill, and below it as text what is written on it.
constexpr std::string_view kStyle = R"(
:root { color-scheme: light; --below: 0rem; --keys: 0rem }
* { box-sizing: border-box }
body { margin: 0; background: #d9d9d9; color: #1a1a1a; font: 18px/1.4 'DejaVu Sans', Verdana, sans-serif }
section { margin: 0 auto 1rem; max-width: calc(100vh * 16 / 9) }
section img { display: block; width: 100%; height: auto; background: #fff }
math mi, math mn, math mtext { font-family: 'DejaVu Sans', Verdana, sans-serif }
math .variable { font-style: italic }
math .vector { font-weight: bold }
h1, h2, .told { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%) }
.caption, .notes { margin: 0; padding: .5rem 1rem; background: #fff; border-top: 2px solid #e69f00 }
.notes { display: none; border-color: #0072b2; max-height: 10rem; overflow-y: auto; font-size: 16px }
.notes p { margin: 0 0 .4rem }
body.keys { --keys: 2.2rem }
#black { position: fixed; inset: 0; z-index: 3; background: #000; cursor: none }
#keys { position: fixed; inset: auto 0 0 0; height: 2.2rem; padding: 0 1rem; display: flex; gap: 1.2rem; align-items: center;
  white-space: nowrap; overflow: hidden; background: #1a1a1a; color: #f5f5f5; font-size: 15px }
#keys kbd { font: inherit; font-weight: bold; color: #ffd479 }
#place { margin-left: auto }
#black[hidden], #keys[hidden] { display: none }
@media (min-width: 701px) {
  .one { overflow: hidden }
  .one main { height: calc(100vh - var(--keys)); display: flex; flex-direction: column; justify-content: center }
  .one .caption { display: none }
  .one section { display: none; margin: 0 auto; width: 100%; max-width: calc((100vh - var(--below) - var(--keys)) * 16 / 9) }
  .one section.now { display: block }
  .one.captions { --below: 7rem }
  .one.spoken { --below: 10rem }
  .one.captions.spoken { --below: 17rem }
  .captions .caption, .spoken .notes { display: block }
  .all main { display: grid; grid-template-columns: repeat(auto-fill, minmax(16rem, 1fr)); gap: 1rem; padding: 1rem 1rem 3rem }
  .all section { margin: 0; cursor: pointer; outline: 2px solid #999 }
  .all section.now { outline: 5px solid #e69f00 }
  .all .caption, .all .notes { display: none }
}
@media screen and (max-width: 700px) {
  #keys { display: none }
  h1, h2, .told { position: static; width: auto; height: auto; overflow: visible; clip-path: none }
  h1 { font-size: 1.4rem; margin: .8rem 1rem }
  h2 { font-size: 1.15rem; margin: 0; padding: .6rem 1rem }
  .told { padding: .4rem 1rem; overflow-wrap: anywhere }
  .told p { margin: .4rem 0 }
  .told .formula { overflow-x: auto; padding: .2rem 0 }
  .sheet { position: relative; overflow: hidden; margin: 0 .4rem; aspect-ratio: var(--shape) }
  .sheet img { position: absolute; width: calc(100% / var(--wide)); max-width: none; left: calc(-100% * var(--left) / var(--wide));
    top: calc(-100% * var(--top) / var(--high)) }
  .wordy { display: none }
  .told li { white-space: pre-wrap }
  .told ol { margin: .4rem 0; padding: 0; list-style: none; font: 14px/1.5 'DejaVu Sans Mono', monospace }
  section { background: #fff; max-width: none }
  .measured section { content-visibility: auto }
}
@media print {
  @page { size: 13.333in 7.5in; margin: 0 }
  body, body.one, body.all { background: none; overflow: visible }
  .one main, .all main { display: block; height: auto; padding: 0 }
  section, .one section, .all section { display: block; margin: 0; max-width: none; outline: none; break-after: page; break-inside: avoid }
  section:last-of-type { break-after: auto }
  section img { width: 13.333in; height: 7.5in; object-fit: contain }
  .caption, .one .caption, .notes, .one .notes, #keys, #black { display: none }
}
)";

constexpr std::string_view kScript = R"(
const slides = [...document.querySelectorAll('section')], body = document.body, keys = document.getElementById('keys');
const black = document.getElementById('black'), phone = matchMedia('(max-width: 700px)');
let now = Math.max(0, slides.findIndex(s => '#' + s.id === location.hash));
function show(number) {
  now = Math.min(slides.length - 1, Math.max(0, number));
  const alone = body.classList.contains('one') && !phone.matches;
  slides.forEach((s, i) => { s.classList.toggle('now', i === now); s.inert = alone && i !== now });
  history.replaceState(null, '', '#' + slides[now].id);
  document.title = slides[now].getAttribute('aria-label');
  document.getElementById('place').textContent = (now + 1) + ' of ' + slides.length;
  if (!alone) slides[now].scrollIntoView({ block: phone.matches ? 'start' : 'nearest' });
}
function layout(name) { body.classList.remove('one', 'all'); body.classList.add(name); show(now) }
function showKeys(visible) { keys.hidden = !visible; body.classList.toggle('keys', visible) }
const dark = () => { black.hidden = !black.hidden };
const does = {
  ArrowRight: () => show(now + 1), PageDown: () => show(now + 1), ' ': () => show(now + 1),
  ArrowLeft: () => show(now - 1), PageUp: () => show(now - 1), p: () => show(now - 1),
  Home: () => show(0), End: () => show(slides.length - 1),
  o: () => layout(body.classList.contains('all') ? 'one' : 'all'), Enter: () => layout('one'), Escape: () => layout('one'),
  c: () => body.classList.toggle('captions'), n: () => body.classList.toggle('spoken'), h: () => showKeys(keys.hidden),
  b: dark, '.': dark,
  f: () => document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen(),
};
addEventListener('keydown', e => {
  const key = e.key.length === 1 ? e.key.toLowerCase() : e.key; // also with Caps Lock
  if (e.ctrlKey || e.altKey || e.metaKey || !Object.hasOwn(does, key)) return;
  e.preventDefault();
  if (!black.hidden) dark(); // any of the keys brings the slide back, as it was
  else does[key]();
});
black.addEventListener('click', dark);
addEventListener('hashchange', () => { const i = slides.findIndex(s => '#' + s.id === location.hash); if (i >= 0) show(i) });
document.addEventListener('fullscreenchange', () => showKeys(!document.fullscreenElement));
phone.addEventListener('change', () => show(now));
let touched = null;
addEventListener('touchstart', e => { touched = e.changedTouches[0].clientX });
addEventListener('touchend', e => {
  const by = e.changedTouches[0].clientX - touched;
  if (!phone.matches && Math.abs(by) > 40) show(now + (by < 0 ? 1 : -1));
});
slides.forEach((s, i) => s.querySelector('img').addEventListener('click', e => {
  if (phone.matches) return;
  if (body.classList.contains('all')) { now = i; layout('one') }
  else show(now + (e.clientX < innerWidth / 3 ? -1 : 1));
}));
if (phone.matches && !location.hash) body.classList.add('one');
else layout('one');
showKeys(true);
// On a phone slides out of view are not laid out or painted; as many as fifty would delay each that is shown. Their heights, which stand for them, are measured.
function measure() {
  if (!phone.matches || body.classList.contains('measured')) return;
  slides.map(s => s.offsetHeight).forEach((height, i) => { slides[i].style.containIntrinsicHeight = 'auto ' + height + 'px' });
  body.classList.add('measured');
}
measure();
phone.addEventListener('change', measure);
)";

// In the order in which somebody needs them who has never seen the page.
constexpr std::string_view kKeys =
    "<span><kbd>Right</kbd> on</span><span><kbd>Left</kbd> back</span><span><kbd>f</kbd> full screen</span>"
    "<span><kbd>b</kbd> black</span><span><kbd>n</kbd> notes</span><span><kbd>c</kbd> caption</span>"
    "<span><kbd>o</kbd> all slides</span><span><kbd>h</kbd> hide this line</span><span id=\"place\"></span>";

/// All that a slide says beside its pictures, on a phone, and for who cannot see it.
std::string toldWords(const Slide& slide) {
    std::string html;
    for (const std::string& text : slide.written.text)
        html += "<p>" + drawing::proseMarkup(text) + "</p>";
    for (const std::string& tex : slide.formulas)
        html += "<div class=\"formula\">" + drawing::Formula(tex).mathML(true) + "</div>";
    if (!slide.pseudocode.empty()) {
        html += "<ol>";
        for (const std::string& line : slide.pseudocode)
            html += "<li>" + drawing::escapedMarkup(line) + "</li>";
        html += "</ol>";
    }
    return html;
}

/// The whole slide as a picture, and in the style where on it its pictures are: a phone shows that part alone.
std::string sheet(const PageSlide& page, double aspect) {
    const Slide& slide = page.slide;
    const std::string image = "<img alt=\"" + drawing::escapedMarkup(slide.alt.empty() ? slide.title : slide.alt) +
                              "\" src=\"data:image/" +
                              (page.webp.empty() ? "png;base64," + drawing::base64(page.png) : "webp;base64," + drawing::base64(page.webp)) + "\">";
    const dvec2 corner = page.picturesAt.corner, size = page.picturesAt.size;
    if (size.x <= 0 || size.y <= 0) return "<div class=\"sheet wordy\">" + image + "</div>\n";
    const auto place = [](const std::string& name, double share) { return "--" + name + ": " + picture::fixed(share, 5); };
    return "<div class=\"sheet\" style=\"" + place("left", corner.x) + "; " + place("top", corner.y) + "; " + place("wide", size.x) + "; " +
           place("high", size.y) + "; " + place("shape", aspect * size.x / size.y) + "\">" + image + "</div>\n";
}

} // namespace

std::string htmlPage(const Deck& deck, const std::vector<PageSlide>& slides, double aspect, const ExploreCode& code) {
    std::string page = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
                       drawing::escapedMarkup(deck.title()) + "</title>\n<style>" + std::string(kStyle) + code.style +
                       "</style>\n</head>\n<body>\n<h1>" + drawing::escapedMarkup(deck.title()) + "</h1>\n<main>\n";
    std::string explored;
    for (std::size_t i = 0; i < slides.size(); ++i) {
        const Slide& slide = slides[i].slide;
        const std::string place = std::to_string(i + 1) + " of " + std::to_string(slides.size());
        const bool isExplored = !slides[i].explored.empty();
        page += "<section id=\"" + slide.name + "\"" + (isExplored ? " class=\"explorable\"" : "") + " aria-label=\"" + place + ": " +
                drawing::escapedMarkup(slide.title) + "\">\n<h2>" + drawing::proseMarkup(slide.written.title) + "</h2>\n" +
                sheet(slides[i], aspect);
        if (isExplored) page += "<div class=\"explore\" data-slide=\"" + slide.name + "\"></div>\n";
        explored += slides[i].explored;
        if (const std::string words = toldWords(slide); !words.empty())
            page += "<div class=\"told\">" + words + "</div>\n";
        if (!slide.written.caption.empty()) page += "<p class=\"caption\">" + drawing::proseMarkup(slide.written.caption) + "</p>\n";
        if (!slide.written.notes.empty()) {
            page += "<div class=\"notes\">";
            for (const std::string& note : slide.written.notes)
                page += "<p>" + drawing::proseMarkup(note) + "</p>";
            page += "</div>\n";
        }
        page += "</section>\n";
    }
    page += "</main>\n<div id=\"keys\" hidden>" + std::string(kKeys) + "</div>\n<div id=\"black\" hidden></div>\n" + explored;
    page += "<script>" + std::string(kScript) + "</script>\n";
    if (!code.script.empty()) page += "<script>" + code.script + "</script>\n";
    return page + "</body>\n</html>\n";
}

} // namespace shadowlab::course
