#!/usr/bin/env python3
"""Drives the window as a hand would: a display of its own (Xvfb), real keys and a real mouse (xdotool), and what the
program says is on its screen (`demo --report`).

drive_window.py PROGRAM tries every key of `list keys`, the mouse, and all steps of all techniques. It never waits by the clock:
each step ends when a report shows what was asked for, or fails after TIMEOUT seconds without one.
"""
# SPDX-License-Identifier: MIT
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

from picked_pixels import picking
from window_driver import TIMEOUT, Display, Window, check, pane

SKY = 84  # row of the window, in which the first pane shows the background
PLACE = (100, 350)  # of the mouse: in the first pane, away from handles and the split line


def changed(*keys):
    """The state differs in what these keys lead to, and so does the picture."""
    def compare(before, after):
        a, b = before, after
        for key in keys:
            a, b = a[key], b[key]
        check(a != b, f"{'.'.join(map(str, keys))} stays {a}")
        check(before["picture"] != after.get("picture"), "the picture stays as it was")
    return compare


def state_only(*keys):
    def compare(before, after):
        a, b = before, after
        for key in keys:
            a, b = a[key], b[key]
        check(a != b, f"{'.'.join(map(str, keys))} stays {a}")
    return compare


def stage(name):
    return lambda before, after: check(pane(after)["stage"].startswith(name) if name else pane(after)["stage"] == "",
                                       f"the stage is {pane(after)['stage']}, not {name}")


def every_key(window, program):
    """Each action of `list keys` once, in an order in which each has something to do."""
    w = window
    keys = [line.split("\t") for line in
            subprocess.run([program, "list", "keys"], capture_output=True, text=True, check=True).stdout.splitlines()]
    names = {"Left": "Left", "Right": "Right", "Up": "Up", "Down": "Down", "PageDown": "Next", "PageUp": "Prior",
             "Esc": "Escape", "Space": "space", "Enter": "Return", "[": "bracketleft", "]": "bracketright",
             "+": "plus", "-": "minus", ",": "comma", ".": "period", "Tab": "Tab"}
    spelled = {}
    for action, _, written, _ in keys:
        *modifiers, key = written.split("+") if written != "+" else ["+"]
        spelled[action] = "+".join([m.lower() for m in modifiers] + [names.get(key, key if key[0] == "F" and len(key) > 1
                                                                               else key.lower())])
    tried = set()

    def press(action, compare=None):
        before, after = w.key(spelled[action], action)
        tried.add(action)
        if compare:
            try:
                compare(before, after)
            except AssertionError as error:
                raise AssertionError(f"{action} ({spelled[action]}): {error}") from None
        check(not pane(after)["fault"], f"{action}: {pane(after)['fault']}")
        return after

    press("panel", state_only("shown", "panel"))  # its times differ from frame to frame; pictures are compared below
    for number in range(1, 10):
        before = pane(w.state)["technique"]
        after = press(f"technique-{number}")
        rows = [line.split("\t") for line in subprocess.run(
            [program, "list", "techniques"], capture_output=True, text=True, check=True).stdout.splitlines()]
        known = [row[0] for row in rows if row[5] == "production"]
        expected = known[number - 1] if number <= len(known) else before
        check(pane(after)["technique"] == expected, f"key {number} shows {pane(after)['technique']}, not {expected}")
    press("undo", lambda b, a: check(pane(b)["technique"] != pane(a)["technique"], "nothing was taken back"))
    press("redo", lambda b, a: check(pane(b)["technique"] != pane(a)["technique"], "nothing was made again"))
    for _ in range(2):  # to the lecture's version, and back
        press("sister", lambda b, a: check(pane(b)["technique"] != pane(a)["technique"], "the sister is not shown"))
    press("next-pane", state_only("active"))
    press("next-pane", state_only("active"))
    press("split-left", changed("split"))
    press("split-right", changed("split"))
    press("magnifier", changed("shown", "magnifier"))
    press("magnifier", changed("shown", "magnifier"))
    press("blink", state_only("shown", "blink"))
    press("blink", state_only("shown", "blink"))
    press("previous-layout", changed("layout"))
    press("next-layout", changed("layout"))
    check(w.state["layout"] == "split", "the layouts do not go to and fro", w.state)

    finished = w.state["picture"]
    press("step-forward", stage("pass:"))
    first = pane(w.state)["stage"]
    step = w.state["picture"]
    press("source", changed("shown", "source"))
    text = w.state["picture"]
    press("source-on")
    press("source-back")
    check(w.state["picture"] == text, "a page on and back, the text is another", w.state)
    press("source", changed("shown", "source"))
    check(w.state["picture"] == step, "after the source the picture is another", w.state)
    press("step-forward-n", stage("pass:"))
    check(pane(w.state)["stage"] != first, "the second step is the first", w.state)
    press("step-back", stage(first))
    press("step-back-n", stage(""))
    check(w.state["picture"] == finished, "after the steps the picture is another", w.state)
    for action, name in (("error", "error"), ("truth", "truth"), ("outside", "outside")):
        press(action, stage(name))
        check(w.state["picture"] != finished, f"{action} looks like the finished picture", w.state)
        press(action, stage(""))
    check(w.state["picture"] == finished, "after the stages the picture is another", w.state)
    press("strip", changed("shown", "strip"))
    press("strip", changed("shown", "strip"))
    press("pick", changed("picked"))  # the mouse lies over the floor
    check(w.state["picked"]["facts"] >= 4, "nothing is known about the pixel", w.state)
    press("leave", changed("picked"))
    press("pick-partner", changed("picked"))  # without a first pixel it is the first
    press("pick-partner", changed("partner"))
    press("leave", changed("partner"))
    press("leave", changed("picked"))
    check(w.state["picture"] == finished, "a pixel that was let go leaves something", w.state)
    press("next-light", changed("light"))
    finished = w.state["picture"]  # the verdicts are about another light

    def lesson(name, step):
        return lambda b, a: check(a["lesson"] and (a["lesson"]["name"], a["lesson"]["step"]) == (name, step), f"no {step} of {name}", a)
    before = w.state["panes"]
    press("lesson-on", lesson("acne", "artefact"))
    press("lesson-on", lesson("acne", "mend"))
    press("lesson-on", lesson("peter-panning", "artefact"))
    press("lesson-back", lesson("acne", "mend"))
    press("leave", lambda b, a: check(a["lesson"] is None, "the lesson is still on", a))

    def slide(name):
        return lambda b, a: check(a["slide"] and a["slide"]["name"] == name, f"no slide {name}", a)

    def through_pictures(action, name):
        """A slide has as many pictures as it has; then comes the next one."""
        for _ in range(4):
            if press(action)["slide"]["name"] == name:
                return
        check(False, f"{action} does not come to {name}", w.state)

    press("slide-on", slide("in-shadow"))
    through_pictures("slide-on", "projection")
    through_pictures("slide-back", "in-shadow")
    press("save-slide", lambda b, a: check(any("saved as slide" in m for m in a["messages"]), "no slide was saved", a))
    while w.state["picked"]:  # that of the slide
        press("leave")
    press("leave", lambda b, a: check(a["slide"] is None, "the slides are still on", a))
    check([p["technique"] for p in w.state["panes"]] == [p["technique"] for p in before], "what was there before has not come back",
          w.state)

    for action in ("left", "right", "up", "down", "pan-left", "pan-right", "lift", "lower", "fly-left", "fly-right",
                   "fly-forward", "fly-back", "nearer", "farther"):
        press(action, changed("camera"))
    press("left")
    press("reset-camera", changed("camera"))
    w.wait("what was said of the saved slide to go", lambda s: not s["messages"] and s["settled"])
    check(w.state["picture"] == finished, "the scene's own camera shows another picture", w.state)
    press("select-next", changed("selection"))
    check(w.state["selection"] == w.state["lights"][0]["name"], "no light is selected", w.state)
    for action in ("right", "up", "lift"):
        press(action, changed("lights", 0))
    press("undo", changed("lights", 0))
    press("select-previous", lambda b, a: check(a["selection"] == "", "something is still selected", a))
    press("handles", changed("shown", "handles"))
    press("handles", changed("shown", "handles"))

    for expected in ({"lights": False, "camera": True, "objects": False}, dict.fromkeys(("lights", "camera", "objects"), True),
                     {"lights": True, "camera": False, "objects": True}):
        press("movers", lambda b, a: check(a["moves"] == expected, f"{a['moves']} move, not {expected}"))
    press("play", lambda b, a: check(a["playing"], "it does not play", a))
    w.wait("lights that move", lambda s: s["lights"] != w.state["lights"] or s["lights"][0] != finished)
    press("faster", state_only("speed"))
    press("slower", state_only("speed"))
    press("play", lambda b, a: check(not a["playing"], "it still plays", a))
    press("save-scene", lambda b, a: check(any("saved" in m for m in a["messages"]), "nothing was saved", a))
    press("screenshot")
    w.wait("a saved picture", lambda s: any("saved" in m and ".png" in m for m in s["messages"]))
    scene = w.state["scene"]
    press("next-scene")
    w.wait("another scene", lambda s: s["scene"] != scene and s["settled"])
    press("previous-scene")
    w.wait("the scene again", lambda s: s["scene"] == scene and s["settled"])

    press("keys", changed("shown", "keys"))
    press("leave", changed("shown", "keys"))
    press("keys-f1", changed("shown", "keys"))
    for _ in range(9):  # its pages; after the last one it closes
        if w.state["shown"]["keys"]:
            press("keys-f1")
    check(not w.state["shown"]["keys"], "the list of keys does not close after its last page", w.state)
    press("focus-panel", state_only("shown", "panelHasKeys"))
    w.hand("key", "Escape")
    w.wait("the keyboard back", lambda s: not s["shown"]["panelHasKeys"] and s["settled"])
    press("panel", state_only("shown", "panel"))
    press("coarse", state_only("shown", "coarse"))
    press("coarse", state_only("shown", "coarse"))
    press("presenter", changed("shown", "presenter"))
    press("presenter", changed("shown", "presenter"))
    press("reset-settings")
    press("reload-shaders")
    w.wait("shaders compiled", lambda s: any("shaders compiled" in m for m in s["messages"]))
    size = w.state["size"]
    press("full-screen")
    w.wait("a full screen", lambda s: s["size"] == [1920, 1200] and s["settled"])
    press("full-screen-f11")
    w.wait("a window again", lambda s: s["size"] == size and s["settled"])

    missing = {action for action, *_ in keys} - tried - {"quit"}
    check(not missing, f"keys that nothing tried: {sorted(missing)}")
    check(len(tried) >= 50, f"only {len(tried)} keys were tried")
    w.hand("key", spelled["quit"])
    check(w.process.wait(timeout=TIMEOUT) == 0, "the program did not end well")
    error = w.process.stderr.read()
    check(error == "", f"something was said on standard error: {error}")
    return len(tried) + 1


def every_step(window):
    """Forward through all steps of every technique, and out at the end; then Tab, which must not lead into the settings."""
    w = window
    lights = len(w.state["lights"])
    for number in (*range(1, 8), 9):  # 8 solves a room first, which takes its time
        w.key(str(number), f"technique-{number}")
        seen = []
        while len(seen) < 40:
            w.key("Next", "step-forward")
            if not pane(w.state)["stage"]:
                break
            seen.append(pane(w.state)["stage"])
        check(len(set(seen)) == len(seen), f"technique {number}: a step comes twice: {seen}")
        check(2 <= len(seen) < 40 and seen[-1].startswith("pass:light@"), f"technique {number}: the steps are {seen}")
        check(len([s for s in seen if s.startswith("pass:light@")]) == lights, f"technique {number}: not every light: {seen}")
    for key, action in (("Tab", "next-pane"), ("1", "technique-1"), ("Tab", "next-pane"), ("1", "technique-1"), ("Tab", "next-pane")):
        w.key(key, action)
    check([p["technique"] for p in w.state["panes"][:2]] == ["unshadowed"] * 2, "Tab and a number did something else", w.state)
    w.close()


def mouse(window):
    """Orbit, pan, flight, wheel, split line, a handle: each by dragging."""
    w = window

    def drag(button, start, end, what, *modifiers):
        w.hand("mousemove", *start)
        before = w.wait(f"the mouse before {what}", lambda s: s["mouse"] == list(start) and s["settled"])
        for modifier in modifiers:
            w.hand("keydown", modifier)
        w.hand("mousedown", button, "mousemove", (start[0] + end[0]) // 2, (start[1] + end[1]) // 2, "mousemove", *end)
        after = w.wait(what, lambda s: any(s[k] != before[k] for k in ("camera", "split", "lights")))
        w.hand("mouseup", button)
        for modifier in modifiers:
            w.hand("keyup", modifier)
        return before, w.wait(f"rest after {what}", lambda s: s["settled"]), after

    x, y = PLACE
    for button, what, modifiers in ((1, "orbit", ()), (2, "pan", ()), (3, "a look around", ()), (1, "pan", ("shift",))):
        before, after, _ = drag(button, (x, y), (x + 60, y + 20), what, *modifiers)
        check(before["camera"] != after["camera"], f"{what}: the camera stays")
        check(before["split"] == after["split"] and before["lights"] == after["lights"], f"{what} moves something else")
        w.hand("key", "0")
        w.wait("the scene's own camera", lambda s: s["settled"] and "reset-camera" not in s["ran"])
    before = w.state
    w.hand("mousemove", x, y, "mousedown", 1, "mousemove", x + 40, y, "mouseup", 1)  # all of it between two frames
    before = w.wait("an orbit by a quick hand", lambda s: s["camera"] != before["camera"] and s["settled"])
    w.hand("mousemove", x, y, "mousedown", 3, "keydown", "w")
    after = w.wait("flying forward", lambda s: s["camera"] != before["camera"])
    w.hand("keyup", "w", "mouseup", 3)
    ahead = sum((b - a) * (t - a) for a, b, t in zip(before["camera"]["position"], after["camera"]["position"], before["camera"]["target"]))
    check(ahead > 0, "W does not fly forward", before, after)
    before = w.wait("rest after flying", lambda s: s["settled"])
    w.hand("mousemove", x, y, "click", 4)
    w.wait("nearer by the wheel", lambda s: s["camera"] != before["camera"])
    before = w.wait("rest after the wheel", lambda s: s["settled"])
    w.hand("key", "ctrl+z")
    w.wait("the camera back", lambda s: s["camera"] != before["camera"] and s["settled"])
    width = w.state["size"][0]
    line = round(w.state["split"] * width)
    before, after, _ = drag(1, (line, y), (line - 150, y), "the split line")
    check(abs(after["split"] - (line - 150) / width) < 0.02, "the line is not where the hand let go", after)
    w.hand("key", "ctrl+z")
    w.wait("the line back", lambda s: s["split"] == before["split"] and s["settled"])

    # A thing goes where its handle is dragged; then along one axis alone, by its arrow.
    w.hand("key", "0")
    w.wait("the scene's own camera", lambda s: s["settled"] and "reset-camera" not in s["ran"], fresh=True)
    lights = [light["name"] for light in w.state["lights"]]
    name, place = next((n, p) for n, p in w.state["handles"].items() if n not in lights and abs(p[0] - line) > 40)
    start, target = w.state, (place[0] + 40, place[1] + 25)
    w.hand("mousemove", *place)
    w.wait("the mouse at a handle", lambda s: s["mouse"] == place and s["settled"])
    w.hand("mousedown", 1, "mousemove", *target)
    w.wait("a dragged handle", lambda s: s["handles"].get(name, place) != place)
    w.hand("mouseup", 1)
    after = w.wait("rest after a dragged handle", lambda s: s["settled"])
    check(after["selection"] == name, f"{name} was dragged, selected is {after['selection']}")
    check(all(abs(a - b) <= 3 for a, b in zip(after["handles"][name], target)),
          f"{name} is at {after['handles'][name]}, the hand at {target}")
    check(after["camera"] == start["camera"], "the camera moved with it")
    check(after["picture"] != start["picture"], "the picture stays")
    w.hand("key", "ctrl+z")
    w.wait("the handle back", lambda s: s["handles"].get(name) == place and s["settled"])

    # No lamp is in this picture: each is dragged by its mark at the edge.
    for number, name in enumerate(lights):
        place = w.state["handles"][name]
        before, after, _ = drag(1, tuple(place), (place[0] + 30, place[1] + 10), f"the light {name}")
        check(before["lights"][number] != after["lights"][number], f"{name} stays", after)
        check(before["camera"] == after["camera"], "the camera moved instead", after)
        w.hand("key", "ctrl+z")
        w.wait("the light back", lambda s: s["lights"] == before["lights"] and s["settled"])
        w.hand("key", "Escape")
        w.wait("nothing selected", lambda s: s["selection"] == "" and s["settled"])
    w.close()


def by_keys(program):
    with Display() as display, tempfile.TemporaryDirectory() as folder:
        window = opened(program, display, folder, "three-lights")
        print(f"start to first report: {window.first_frame:.2f} s")
        keys = every_key(window, program)
        written = sorted(os.listdir(folder))
        check([n.split(".")[-1] for n in written] == ["json"] * 4 + ["png", "txt"] and "slides.json" in written, f"written were {written}")
        return keys


def by_mouse_and_steps(program):
    with Display() as display, tempfile.TemporaryDirectory() as folder:
        window = opened(program, display, folder, "three-lights")
        window.key("i", "panel")
        mouse(window)
        window = opened(program, display, folder, "mirror-and-glass")
        window.key("i", "panel")
        picking(window, PLACE, SKY)
        every_step(opened(program, display, folder, "three-lights"))


def opened(program, display, folder, scene):
    window = Window(program, display, folder, scene, "--keep-settings", "false", "--size", "700x450")
    window.hand("mousemove", *PLACE)
    return window


def main():
    """Two displays at once: each window waits for its own picture most of the time."""
    program = os.path.abspath(sys.argv[1])
    with ThreadPoolExecutor(2) as pool:
        keys, others = pool.submit(by_keys, program), pool.submit(by_mouse_and_steps, program)
        others.result()
        print(f"{keys.result()} keys and the mouse: all as expected")


if __name__ == "__main__":
    main()
