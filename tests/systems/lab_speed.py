#!/usr/bin/env python3
"""How soon the labs of a page are there on a phone's processor: Chromium, slowed down four times.

lab_speed.py PAGE.html [ROUNDS]

Prints the least, the middle and the longest of the labs' times, for a window of a phone's size and for a wide one: from the call of a slide
until its lab's first picture is on the screen, and from a key at the lamp until the next picture is there. Asserts nothing: the figures belong to
the machine, which should do nothing else. Needs Chromium and the package websocket-client (python3-websocket in Debian)."""
# SPDX-License-Identifier: MIT
import re
import statistics
import sys
import time
from pathlib import Path

import browsers

SLOWER = 4
WINDOWS = {"a phone, 390 x 844": (390, 844, True), "wide, 1280 x 800": (1280, 800, False)}
# A picture that is drawn on the stage is on the screen when the frame after it has been made: then messages are answered again.
SCRIPT = """
window.begun = window.shown = null;
addEventListener('keydown', () => { if (window.waiting) { window.begun = performance.now(); window.waiting = false } }, true);
const draw = CanvasRenderingContext2D.prototype.drawImage;
CanvasRenderingContext2D.prototype.drawImage = function (...words) {
  draw.apply(this, words);
  if (!this.canvas.closest('.stage') || window.begun === null || window.shown !== null) return;
  const begun = window.begun;
  window.begun = null;
  requestAnimationFrame(() => {
    const channel = new MessageChannel();
    channel.port1.onmessage = () => { window.shown = performance.now() - begun };
    channel.port2.postMessage(0);
  });
}"""


def times(page, name, elsewhere, window):
    """Milliseconds to the first picture of a lab, and to the next one of the lamp, or None without a lamp."""
    browser = browsers.Chromium()
    try:
        browser.window(*window)
        browser.before(SCRIPT)
        browser.open(f"{page.as_uri()}#{elsewhere}")
        time.sleep(1)
        browser.call("Emulation.setCPUThrottlingRate", rate=SLOWER)
        browser.ask(f"begun = performance.now(); location.hash = '#{name}'; 0")
        first = browser.wait("shown", f"the first picture of {name}")
        browser.wait(f"document.querySelector('#{name} .explore').dataset.ready", f"all of {name}")
        time.sleep(2)  # the lamp's neighbours are decoded ahead
        if not browser.ask(f"const lamp = document.querySelector('#{name} .lamp-group input'); if (lamp) lamp.focus(); Boolean(lamp)"):
            return first, None
        browser.ask("shown = null; waiting = true; 0")
        browser.press("ArrowRight")
        return first, browser.wait("shown", f"the next picture of {name}")
    finally:
        browser.close()


def main():
    page, rounds = Path(sys.argv[1]).resolve(), int(sys.argv[2]) if len(sys.argv) > 2 else 1
    text = page.read_text()
    labs, slides = re.findall(r'id="explore-([\w-]+)"', text), re.findall(r'<section id="([\w-]+)"', text)
    for what, window in WINDOWS.items():
        # From half a deck away, so that the lab has not been built as a neighbour of the slide before.
        taken = [times(page, name, slides[(slides.index(name) + len(slides) // 2) % len(slides)], window) for _ in range(rounds) for name in labs]
        for column, of in enumerate(("first picture", "lamp moved")):
            found = sorted(each[column] for each in taken if each[column] is not None)
            print(f"{what:20} {of:14} {found[0]:5.0f} {statistics.median(found):5.0f} {found[-1]:5.0f} ms, {len(found)} times")


if __name__ == "__main__":
    main()
