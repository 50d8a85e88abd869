#!/usr/bin/env python3
"""A page of slides that can be explored, in Chromium and in Firefox, with the network off: all that the lab of a slide does, by keys, by mouse and by
finger, in a wide window and on a phone.

explore_check.py PROGRAM [--browser NAME] [--keep FOLDER]

A small deck is made with `PROGRAM slides DECK --explore`. What each browser shows is compared with the data that the page carries. Needs the package
websocket-client (python3-websocket in Debian). A browser that is not installed is left out with a line that says so. Ends with 77 (skipped) without
SHADOWLAB_LONG=1 in the environment, or where neither browser is there; with 1 where something is wrong."""
# SPDX-License-Identifier: MIT
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import browsers
from explored_lab import Lab

SKIPPED = 77
LONGEST = 1200  # seconds, for the deck
PAIR, ALONE = "pair", "alone"
TASK = 170_000  # wrong pixels: half of 768 x 432; half of the places have 181,000 and more, the others 162,000 at most
DECK = {"title": "Explored", "subtitle": "Two slides", "scene": "still-life", "slides": [
    {"name": PAIR, "title": "A shadow map beside shadow volumes", "slots": [{"technique": "shadow-map"}, {"technique": "shadow-volume"}], "layout": "split",
     "explore": {"lamp": 12, "settings": {"shadow-map.resolution": [64, 256, 1024]}, "stages": ["light-depth"], "ask": 12},
     "caption": "Texels are squares.", "alt": "A table with shadows."},
    {"name": ALONE, "title": "When z-pass fails", "scene": "eye-in-shadow", "slots": [{"technique": "shadow-volume-zpass"}],
     "explore": {"lamp": 12, "task": {"question": "Find a place of the lamp at which z-pass misjudges half of the picture.", "number": "coreErrors",
                                      "at-least": TASK, "told": "Right: the eye is in shadow, and so is much of the ground."}},
     "caption": "The eye in shadow.", "alt": "A room whose eye stands in shadow."}]}
WIDE, PHONE = (1280, 720), (360, 740)
LYING = ((640, 360), (667, 375), (740, 360), (844, 390))
WINDOWS = (WIDE, (1024, 768), (1920, 1080))
CONTROLS = ("button", "radio", "slider", "combobox", "checkbox", "link", "image", "img", "dialog", "group")


def lab_is_there(lab):
    lab.expect(lab.ask("ROOT.offsetHeight") > 300, "there is no lab")
    lab.expect(lab.ask(f"document.querySelector('#{lab.name} .sheet').offsetHeight") == 0, "the still slide is shown beside the lab")
    lab.expect(lab.ask("(d => new Set(d).size)(ROOT.querySelector('canvas').getContext('2d').getImageData(0, 0, 640, 300).data)") > 10, "the picture is empty")
    lab.expect(lab.ask("typeof element === 'undefined' && typeof ShadowlabExplore === 'object'"), "the script leaks names into the page")


def says_nothing_at_first(lab):
    """What stands there from the start is not read out; it would be, for every lab that comes near while the page is scrolled."""
    time.sleep(1)  # more than the rest after which numbers are read out
    said = lab.ask("ROOT.querySelector('.spoken').textContent")
    lab.expect(said == "", f"is read out though nothing was changed: {said}")


def lamp_moves(lab, finger=False):
    start, first = lab.lamp(), lab.picture()
    if not finger:
        lab.focus("input[type=range]")
        lab.press("ArrowRight")
        lab.expect(lab.lamp() == start + 1, "an arrow key does not move the lamp by one")
        lab.expect(lab.picture() != first, "the picture stays when the lamp is moved by a key")
        lab.expect(lab.ask(f"document.getElementById('{lab.name}').classList.contains('now')"), "an arrow key at the lamp turns the slide")
        lab.press("ArrowLeft")
        lab.expect(lab.lamp() == start and lab.picture() == first, "the lamp does not come back to its first picture")
    places = len(lab.data["lamp"]["positions"])
    to = (start + places // 3) % places
    lab.browser.drag(lab.plan_place(start), lab.plan_place(to), finger)
    lab.expect(lab.lamp() == to, f"dragged on the plan to position {to}, the lamp is at {lab.lamp()}")
    lab.expect(lab.picture() != first, "the picture stays when the lamp is dragged")
    seen = [i for i, position in enumerate(lab.data["lamp"]["positions"]) if position["picture"]]
    if len(seen) > 1:
        from_place, to_place = seen[0], seen[len(seen) // 2]
        lab.browser.drag(lab.plan_place(lab.lamp()), lab.plan_place(from_place), finger)
        left, top, width, height = lab.box(".picture")
        ends = [(left + width * x, top + height * y) for x, y in (lab.data["lamp"]["positions"][place]["picture"] for place in (from_place, to_place))]
        lab.browser.drag(*ends, finger)
        lab.expect(lab.lamp() != from_place, "the lamp is not moved on the picture")
    return to


def line_moves(lab, finger=False):
    before = lab.picture()
    left, top, width, height = lab.box(".split .grip")
    line = int(lab.ask("ROOT.querySelector('.split').getAttribute('aria-valuenow')"))
    lab.expect(line == 50 and min(width, height) >= 44, f"the line stands at {line} percent, its handle is {width:.0f} x {height:.0f}")
    lab.browser.drag((left + width / 2, top + height / 2), (left + width / 2 - 90, top + height / 2), finger)
    line = int(lab.ask("ROOT.querySelector('.split').getAttribute('aria-valuenow')"))
    lab.expect(line < 48 and lab.picture() != before, f"dragged to the left, the line stands at {line} percent")
    lab.focus(".split")
    ends = []
    for key, place in (("Home", 0), ("End", 100), ("ArrowLeft", 98)):
        lab.press(key)
        line = int(lab.ask("ROOT.querySelector('.split').getAttribute('aria-valuenow')"))
        lab.expect(line == place, f"{key} brings the line to {line} percent")
        ends.append(lab.picture())
    lab.expect(ends[0] != ends[1], "both sides of the line show the same")


def setting_changes(lab):
    place, setting = lab.lamp(), lab.data["settings"][0]
    value = next(i for i in range(len(setting["values"])) if i != setting["start"])
    variant = next(i for i, values in enumerate(lab.data["variants"]) if values[0] == value)
    before, picture = lab.numbers(0, place), lab.picture()
    lab.click(".settings-group label", value)
    wanted = lab.numbers(0, place, variant)
    lab.expect(wanted != before, "the deck does not tell this setting apart")
    told = json.dumps(format(round(wanted["falseLit"] + wanted["falseShadow"]), ","))
    lab.wait(f"ROOT.querySelector('.numbers-group tr:nth-child(3) td').textContent === {told}", "the setting's number of wrong pixels")
    lab.expect(lab.picture() != picture, "a setting does not change the picture")
    lab.wait(f"ROOT.querySelector('.spoken').textContent.includes({told})", "the number is read out")
    lab.click(".settings-group label", setting["start"])
    lab.expect(lab.picture() == picture, "the setting does not go back")


def views_change(lab):
    seen = {lab.picture()}
    count = lab.ask("ROOT.querySelectorAll('.left > .choices input').length")
    lab.expect(count == 3 + len(lab.data["views"]), f"there are {count} views")
    for i in range(1, count):
        lab.click(".left > .choices label", i)
        seen.add(lab.picture())
    lab.expect(len(seen) == count, f"{count} views show {len(seen)} pictures")
    lab.click(".left > .choices label", 1)
    lab.expect(all(label in lab.text(".foot") for _, label in lab.data["verdictColors"]), "errors have no legend")
    lab.click(".left > .choices label", 0)


def steps_go_on(lab):
    steps = [step for step in lab.data["steps"] if step["pane"] == 0]
    lab.expect(len(steps) > 1, "the deck has no steps")
    before = lab.picture()
    lab.click(".steps-group > button")
    for i, step in enumerate(steps):
        lab.expect(f"Step {i + 1} of {len(steps)}: {step['title']}" in lab.text(".step-title"), f"step {i + 1} is told as {lab.text('.step-title')}")
        marked = lab.ask("[...ROOT.querySelectorAll('.code li')].flatMap((line, i) => line.getAttribute('aria-current') ? [i + 1] : [])")
        lab.expect(marked == sorted(step["lines"]), f"step {i + 1} marks the lines {marked}")
        lab.press("Enter")
    lab.ask("[...ROOT.querySelectorAll('.steps-group .row button')].pop().click()")
    lab.expect(not lab.text(".code"), "the pseudocode stays when the steps are left")
    lab.picture()
    return before


def pixel_answers(lab, finger=False):
    lab.click(".ask-group > button", finger=finger)
    lab.click(".ring", 5, finger)
    lab.wait("ROOT.querySelector('.panel').offsetHeight > 0 && ROOT.querySelector('.verdict').textContent.length > 20", "an answer")
    lab.expect("Point 6" in lab.text(".verdict"), f"asked at point 6, it tells {lab.text('.verdict')}")
    lab.expect(lab.ask("ROOT.querySelectorAll('.facts tr').length") in range(1, 7), "the first facts are not there")
    if not finger:
        lab.press("ArrowLeft", "Enter")
        lab.wait("ROOT.querySelector('.verdict').textContent.startsWith('Point 5')", "the answer of the ring to the left")
    with_figure = lab.wait("[...ROOT.querySelectorAll('.figure img')].some(image => image.src && image.naturalWidth > 0) && 'yes'", "a figure")
    lab.expect(with_figure == "yes", "an answer has no figure")
    lab.click(".figure", finger=finger)
    lab.wait("ROOT.querySelector('dialog').open", "the large figure")
    lab.expect(lab.ask("ROOT.querySelector('dialog img').getBoundingClientRect().width >= innerWidth - 20"), "the large figure is small")
    lab.press("Escape")
    lab.expect(not lab.ask("ROOT.querySelector('dialog').open") and lab.ask("ROOT.querySelector('.panel').offsetHeight > 0"), "Esc does not close the figure alone")
    lab.click(".ask-group > button", finger=finger)
    lab.expect(lab.ask("ROOT.querySelector('.rings').hidden"), "the rings stay")


def task_is_judged(lab, is_kept=True):
    task, places = lab.data["task"], range(len(lab.data["lamp"]["positions"]))
    solves = {place: lab.numbers(task["pane"], place)[task["number"]] >= task["atLeast"] for place in places}
    lab.expect(True in solves.values() and False in solves.values(), f"the task is no task: {solves}")
    for right in (False, True):
        lab.move_to(next(place for place in places if solves[place] == right))
        lab.click(".task-group button")
        told = lab.text(".answer")
        lab.expect(told.startswith("Not yet") != right, f"at a place that {'solves' if right else 'does not solve'} the task it tells {told}")
        lab.expect(format(round(lab.numbers(task["pane"], lab.lamp())[task["number"]]), ",") in told, f"the number is missing: {told}")
    if is_kept:
        key = lab.ask("Object.keys(localStorage).find(key => localStorage.getItem(key) === 'solved')")
        lab.expect(lab.text(".solved") and key and lab.name in key, f"that the task is solved is not kept, but {key}")


def keys_go_back(lab):
    lab.focus("input[type=range]")
    lab.press("Escape", "End")
    lab.expect(not lab.ask(f"document.getElementById('{lab.name}').classList.contains('now')") or lab.name == ALONE, "after Esc the keys do not turn slides")
    lab.press("o")
    lab.expect(lab.ask("getComputedStyle(ROOT).display") == "none" and lab.ask(f"document.querySelector('#{lab.name} .sheet').offsetHeight > 50"),
               "among all slides the still one is not shown")
    lab.press("Escape")


def fits(lab, width, height):
    lab.browser.window(width, height)
    time.sleep(0.5)
    outside = lab.ask("[...ROOT.querySelectorAll('.stage, .picture, .left > .choices, .column, .turners')].filter(part => { const at = part.getBoundingClientRect();"
                      " return at.left < -1 || at.right > innerWidth + 1 || at.bottom > innerHeight + 1 }).map(part => part.className)")
    lab.expect(not outside, f"at {width} x {height} these leave the window: {outside}")
    over = lab.ask("(([a, b]) => a.right > b.left + 1)([...ROOT.querySelectorAll('.left, .column')].map(part => part.getBoundingClientRect()))")
    lab.expect(not over, f"at {width} x {height} the picture reaches into the column")
    lab.expect(lab.ask("(part => part.scrollWidth <= part.clientWidth + 1)(ROOT.querySelector('.column'))"), f"at {width} x {height} the column is cut off")


def opens_at_its_slide(lab):
    lab.wait(f"Math.abs(document.getElementById('{lab.name}').getBoundingClientRect().top) < 2", "the slide that the address names")


def fits_phone(lab):
    wide = lab.ask("document.documentElement.scrollWidth")
    lab.expect(wide <= PHONE[0], f"on a phone the page is {wide} pixels wide")
    outside = lab.ask("[...ROOT.querySelectorAll('*')].filter(part => part.offsetParent && !part.closest('.picture, .formula') &&"
                      " part.getBoundingClientRect().right > 361).map(part => part.className + ' ' + part.textContent.slice(0, 40))")
    lab.expect(not outside, f"on a phone these leave the window: {outside}")
    small = lab.ask("[...ROOT.querySelectorAll('button:not(.ring), select, .options span, input[type=range]')].filter(part => part.offsetParent &&"
                    " (part.offsetHeight < 44 || part.offsetWidth < 30)).map(part => part.textContent)")
    lab.expect(not small, f"too small for a finger: {small}")


def lying_phone_reaches_all(lab):
    """On a phone that lies, or in a window at twice the size, no picture covers what changes it."""
    for window in LYING:
        lab.browser.window(*window, True)
        for control in (".lamp-group input[type=range]", ".settings-group input", ".steps-group button", ".ask-group > button"):
            # Again until it holds: labs that come into sight further down change the page's height.
            lab.wait("(control => { control.scrollIntoView({ block: 'center' }); const at = control.getBoundingClientRect(); const hit ="
                     " document.elementFromPoint(at.left + at.width / 2, at.top + at.height / 2);"
                     f" return hit && hit.closest('.group') === control.closest('.group') }})(ROOT.querySelector('{control}'))",
                     f"{control} in {window}, with nothing over it")
        wide = lab.ask("document.documentElement.scrollWidth")
        lab.expect(wide <= window[0], f"in {window} the page is {wide} pixels wide")


def everything_has_a_name(lab):
    named = [(role, name) for role, name in lab.browser.names() if role in CONTROLS]
    nameless = [role for role, name in named if not name.strip()]
    lab.expect(len(named) > 15, f"only {len(named)} controls are read out")
    lab.expect(not nameless, f"these have no name: {nameless}")


def prints_stills(lab):
    lab.browser.prefer(media="print")
    shown = lab.ask("[getComputedStyle(ROOT).display, " + f"getComputedStyle(document.querySelector('#{lab.name} .sheet')).display]")
    lab.browser.prefer()
    lab.expect(shown[0] == "none" and shown[1] != "none", f"printed, the lab is {shown[0]} and the still slide {shown[1]}")


def rests(browser, page):
    for wish, players in (("no-preference", 1), ("reduce", 0)):
        browser.prefer(prefers_reduced_motion=wish)
        lab = Lab(browser, page, PAIR)
        lab.expect(lab.ask("ROOT.querySelectorAll('.play').length") == players, f"with the wish for motion {wish} the lamp runs, or does not")
    browser.prefer()


def scrolls_over_the_picture(lab):
    lab.ask(f"document.getElementById('{lab.name}').scrollIntoView()")
    time.sleep(0.3)
    left, top, width, height = lab.ask("(at => [at.left, at.top, at.width, at.height])(ROOT.querySelector('.picture').getBoundingClientRect())")
    before = lab.ask("scrollY")
    lab.browser.drag((left + width / 4, top + height * 0.8), (left + width / 4, top + height * 0.8 - 150), True)
    time.sleep(0.5)
    lab.expect(lab.ask("scrollY") > before + 50, "a finger on the picture does not scroll the page")


def swipe_turns_nothing(lab):
    left, top, width, height = lab.box(".picture")
    lab.browser.drag((left + width * 0.9, top + height * 0.1), (left + width * 0.1, top + height * 0.1), True)
    lab.expect(lab.ask(f"document.getElementById('{lab.name}').classList.contains('now')"), "a swipe over the lab turns the slide")


def does_without(browser, page):
    """What a browser lacks is said in words. Comes last: what is taken away stays away."""
    browser.window(*WIDE)
    browser.before("delete self.DecompressionStream; Object.defineProperty(self, 'localStorage', {get() { throw new Error('refused') }})")
    lab = Lab(browser, page, PAIR)
    lab.click(".ask-group > button")
    lab.click(".ring", 5)
    lab.wait("ROOT.querySelector('.verdict').textContent.includes('cannot unpack')", "a word on answers that cannot be unpacked")
    task_is_judged(Lab(browser, page, ALONE), False)
    # A picture that cannot be decoded, with a view asked for meanwhile; and no way to decode any.
    late = "self.createImageBitmap = () => new Promise((kept, fail) => setTimeout(() => fail(new Error('no memory')), 500))"
    press = f"[document.querySelector('#{PAIR} .left input:not(:checked)')].some(view => view && (view.click(), true))"
    for script in (late, "delete self.createImageBitmap"):
        browser.before(script)
        browser.open("about:blank")
        browser.open(f"{page.as_uri()}#{PAIR}")
        if script == late:
            browser.wait(press, "a view before the first picture")
        browser.wait(f"document.querySelector('#{PAIR} .sheet').offsetHeight > 300", "the still slide where there can be no lab")
        browser.wait(f"document.querySelector('#{PAIR} .excuse').offsetHeight > 10", "a word on why there is no lab")


def check(browser, page, keep):
    """All checks in one browser. Returns how many were made."""
    done = []

    def run(test, *words):
        try:
            test(*words)
        except AssertionError as wrong:
            raise AssertionError(f"{test.__name__}: {wrong}") from wrong
        done.append(test.__name__)

    def picture(name):
        if keep:
            browser.picture(keep / f"{browser.name}-{name}.png")

    browser.window(*WIDE)
    lab = Lab(browser, page, PAIR)
    for test in (lab_is_there, says_nothing_at_first, lamp_moves, line_moves, setting_changes, views_change, steps_go_on, pixel_answers):
        run(test, lab)
    picture("pair")
    for window in WINDOWS:
        run(fits, lab, *window)
    browser.window(*WIDE)
    if browser.name == "Chromium":
        run(everything_has_a_name, lab)
        run(prints_stills, lab)
        run(rests, browser, page)
        lab = Lab(browser, page, PAIR)
    run(keys_go_back, lab)
    lab = Lab(browser, page, ALONE)
    for test in (lab_is_there, lamp_moves, task_is_judged, keys_go_back):
        run(test, lab)
    picture("alone")
    browser.window(1024, 768, True)
    run(swipe_turns_nothing, Lab(browser, page, PAIR))
    run(lying_phone_reaches_all, Lab(browser, page, PAIR))
    browser.window(*PHONE, True)
    run(opens_at_its_slide, Lab(browser, page, ALONE))
    lab = Lab(browser, page, PAIR)
    for test in (fits_phone, scrolls_over_the_picture):
        if test is fits_phone or browser.name == "Chromium":  # Firefox's touches by BiDi do not scroll
            run(test, lab)
    for test in (lamp_moves, line_moves, pixel_answers):
        run(test, lab, True)
    run(fits_phone, lab)
    picture("phone")
    run(does_without, browser, page)
    strange = [url[:100] for url in browser.requests if not url.startswith(("data:", "blob:", "about:", page.as_uri()))]
    lab.expect(not strange, f"the page asks for {strange}")
    lab.expect(not browser.complaints, f"the page complains: {browser.complaints}")
    return len(done)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=Path)
    parser.add_argument("--browser", default="", help="only the one whose name has that word in it")
    parser.add_argument("--keep", type=Path, help="where the deck and pictures of the windows are written")
    words = parser.parse_args()
    if os.environ.get("SHADOWLAB_LONG") != "1":
        print("skipped: it takes SHADOWLAB_LONG=1 in the environment")
        return SKIPPED
    wanted = [kind for kind in (browsers.Chromium, browsers.Firefox) if words.browser.lower() in kind.name.lower()]
    kinds = [kind for kind in wanted if kind in browsers.installed()]
    for kind in wanted:
        if kind not in kinds:
            print(f"left out: {kind.name}, for {'it' if browsers.websocket else 'the package websocket-client'} is not installed")
    if not kinds:
        print("skipped: neither browser can be driven")
        return SKIPPED
    complaints = []
    with tempfile.TemporaryDirectory() as temporary:
        folder = (words.keep or Path(temporary)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "explored.json").write_text(json.dumps(DECK))
        made = subprocess.run([words.program.resolve(), "slides", folder / "explored.json", "--explore", "-o", folder, "--size", "960x540"], capture_output=True, text=True,
                              errors="replace", check=False, timeout=LONGEST)
        page = folder / "explored.html"
        if made.returncode or not page.is_file():
            print(f"no deck was made ({made.returncode}): {made.stderr[-2000:]}")
            return 1
        text = page.read_text()
        if re.search(r"""(?:src|href)=["']?(?!data:|#)[a-z]+:""", text):
            complaints.append("the page names an address")
        for kind in kinds:
            browser = kind()
            try:
                print(f"{kind.name}: {check(browser, page, words.keep and folder)} checks", flush=True)
            except AssertionError as wrong:
                complaints.append(str(wrong))
            finally:
                browser.close()
    print("\n".join(complaints or ["all is as it should be"]))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
