#!/usr/bin/env python3
"""The page of lessons in Chromium and in Firefox, with the network off: a lesson is answered, mended and scored, by keys, by mouse and by finger,
in a wide window and on a phone.

lessons_page_check.py PROGRAM

The page is made with `PROGRAM slides lessons`. Needs the package websocket-client (python3-websocket in Debian). Ends with 77 (skipped) without
SHADOWLAB_LONG=1 in the environment, or where neither browser is there; with 1 where something is wrong."""
# SPDX-License-Identifier: MIT
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import browsers

SKIPPED = 77
LONGEST = 600  # seconds, for the page
WIDE, PHONE = (1280, 720), (360, 740)
LESSON = "document.querySelector('.lesson.now')"
SCORE = "document.querySelector('.score p').textContent"
SPLIT = LESSON + ".querySelector('.slider input').value"
BOX = "(r => [r.left, r.top, r.width, r.height])(" + LESSON + ".querySelector('.picture').getBoundingClientRect())"


class Check:
    def __init__(self, browser):
        self.browser, self.made, self.wrong = browser, 0, []

    def that(self, what, holds):
        self.made += 1
        if not holds:
            self.wrong.append(what)
            print(f"{self.browser.name}: {what}: not so", file=sys.stderr)

    def ask(self, expression):
        return self.browser.ask(expression.replace("LESSON", LESSON))


def answer(check, lessons):
    """The first lesson, by keys."""
    browser = check.browser
    check.that("nothing is answered", check.ask(SCORE) == f"None of {lessons} answered yet")
    check.ask("document.querySelector('#overview a').focus()")
    browser.press("Enter")
    browser.wait(f"{LESSON} !== null", "the first lesson")
    check.that("the heading has the focus", check.ask("document.activeElement.tagName") == "H2")
    width = check.ask("(async () => { const image = LESSON.querySelector('img.before'); await image.decode(); return image.naturalWidth })()")
    check.that("its picture is there", width > 0)
    right = check.ask("Number(LESSON.dataset.right)")
    check.ask(f"LESSON.querySelectorAll('.choices button')[{right}].focus()")
    browser.press("Enter")
    check.that("the answer is right, in words", "Right" in check.ask("LESSON.querySelector('.verdict').textContent"))
    check.that("and is read out", "Right." in check.ask("document.querySelector('[role=status]').textContent"))
    check.that("it counts", check.ask(SCORE) == f"1 of {lessons} answered, 1 right at the first try")


def mend(check):
    """The line between before and after, by keys, by mouse and by finger."""
    browser = check.browser
    check.ask("LESSON.querySelector('button.main').focus()")
    browser.press("Enter")
    browser.wait("document.activeElement.type === 'range'", "the line between before and after")
    browser.press("ArrowLeft")  # ends the line's own movement
    before = float(check.ask(SPLIT))
    browser.press("ArrowLeft")
    check.that("a key moves the line", float(check.ask(SPLIT)) < before)
    for finger, size in ((False, WIDE), (True, PHONE)):
        browser.window(*size, finger)
        left, top, width, height = check.ask(BOX)
        browser.drag((left + width * 0.3, top + height / 2), (left + width * 0.8, top + height / 2), finger)
        who = "a finger" if finger else "the mouse"
        check.that(f"{who} moves the line", abs(float(check.ask(SPLIT)) - 80) <= 3)  # percent; a finger is not as exact as a mouse


def go_through(check, page, lessons):
    """Every lesson on a phone; what was answered is kept, and forgotten when that is asked for."""
    browser = check.browser
    browser.open("about:blank")
    browser.open(f"{page.as_uri()}#lesson-1")
    browser.wait(f"{LESSON} !== null", "the lesson after the page was opened again")
    check.that("what was answered is kept", check.ask("LESSON.classList.contains('told')"))
    for number in range(1, lessons + 1):
        check.ask(f"location.hash = '#lesson-{number}'")
        browser.wait(f"{LESSON}.id === 'lesson-{number}'", f"lesson {number}")
        check.ask("LESSON.classList.contains('told') || LESSON.querySelectorAll('.choices button')[0].click()")
        check.ask("LESSON.querySelector('button.main').click()")
        check.that(f"lesson {number} is no wider than a phone", check.ask("document.documentElement.scrollWidth") <= PHONE[0])
    check.ask("location.hash = ''")
    check.that("all are answered", check.ask(SCORE).startswith(f"{lessons} of {lessons}"))
    check.ask("document.querySelector('.score button').click()")
    check.that("all is forgotten", check.ask(SCORE).startswith("None"))
    foreign = [request for request in browser.requests if not request.startswith(("data:", "file:", "about:", "blob:"))]
    check.that(f"nothing is asked of a network: {foreign}", not foreign)
    check.that(f"no complaints: {browser.complaints}", not browser.complaints)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    if os.environ.get("SHADOWLAB_LONG") != "1" or browsers.websocket is None or not browsers.installed():
        print("the page of lessons is not driven: needs SHADOWLAB_LONG=1, python3-websocket, and chromium or firefox-esr")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([os.path.abspath(sys.argv[1]), "slides", "lessons", "-o", folder], check=True, timeout=LONGEST)
        page = Path(folder) / "lessons.html"
        lessons = page.read_text(encoding="utf-8").count('<section class="lesson')
        wrong = made = 0
        for kind in browsers.installed():
            browser = kind()
            check = Check(browser)
            try:
                browser.window(*WIDE)
                browser.open(page.as_uri())
                answer(check, lessons)
                mend(check)
                go_through(check, page, lessons)
            finally:
                browser.close()
            made += check.made
            wrong += len(check.wrong)
            print(f"{browser.name}: {check.made} checks, {len(check.wrong)} wrong")
        return 1 if wrong or made < 2 * lessons or lessons < 30 else 0


if __name__ == "__main__":
    sys.exit(main())
