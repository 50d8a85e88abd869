#!/usr/bin/env python3
"""teaching_walk.py PROGRAM: opens the windows of docs/teaching.md and presses the keys of each script, row after row: every key has to
do what it does by `list keys`, PageDown has to lead to the slides of its row, and no row may leave anything open. It prints how long
each row waited for pictures; nothing is asserted about that. Only with SHADOWLAB_LONG; exit status 77 says that it was left out."""
# SPDX-License-Identifier: MIT
import contextlib
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from script import scripts_of

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests/window"))
from window_driver import Display, Window, check  # noqa: E402 (it lies in another folder)

LEFT_OUT = 77
MOST_PICTURES = 30  # of the slides that no row has, and of one slide
OVER_A_THING = (500, 420)  # of the mouse: where the row asks for a pixel, there is one
NAMES = {"PageDown": "Next", "PageUp": "Prior", "Esc": "Escape", "Space": "space", "[": "bracketleft", "]": "bracketright"}


class Shown(Window):
    """A teacher does not wait for the exact numbers."""

    def begun(self, state):
        return state["frames"] > 0


def spelled(key):
    """As xdotool calls it."""
    *modifiers, last = key.split("+")
    return "+".join([m.lower() for m in modifiers] + [NAMES.get(last, last.lower() if len(last) == 1 else last)])


def actions_of(program):
    told = subprocess.run([program, "list", "keys", "--json"], capture_output=True, text=True, check=True).stdout
    return {key: entry["action"] for entry in json.loads(told)["keys"] for key in entry["keys"].split(", ")}


def walk(script, program, actions):
    """Seconds that each row waited."""
    windows = {}
    waited = []
    with contextlib.ExitStack() as to_close:
        folder = to_close.enter_context(tempfile.TemporaryDirectory())
        for row in script.rows:
            seconds = 0.0
            to_reach = [slide for slide in row.slides if slide != script.rows[0].slides[0]]
            for letter, key in row.pressed:
                if letter not in windows:
                    display = to_close.enter_context(Display())  # of its own, as each window has a desktop of its own
                    windows[letter] = Shown(program, display, folder, *script.windows[letter], "--keep-settings", "false", "--size", "1280x720")
                    to_close.callback(windows[letter].close)
                    windows[letter].hand("mousemove", *OVER_A_THING)
                    # They are started ten minutes before: a technique's steps are known when its first picture is there.
                    windows[letter].wait("a first picture", lambda s: s["settled"] or any(pane["frameMs"] > 0 for pane in s["panes"]))
                seconds += pressed(windows[letter], key, actions[key])
                if key == "PageDown" and script.shows_deck(letter):
                    slide = to_reach.pop(0)
                    for _ in range(MOST_PICTURES):
                        if windows[letter].state["slide"]["name"] == slide:
                            break
                        seconds += pressed(windows[letter], key, actions[key])
                    reached = windows[letter].state["slide"]["name"]
                    check(reached == slide, f"minute {row.first_minute}: PageDown leads to {reached}, not to {slide}")
            for letter, _ in row.pressed:
                leaves_nothing(windows[letter].state, f"{script.deck}, minute {row.first_minute}, {letter}")
            waited.append(seconds)
    return waited


def leaves_nothing(state, where):
    """The next row begins with a slide or a lesson, and with nothing open that this one has opened."""
    check(state["story"] in ("slides", "lesson"), f"{where}: the band is left in mode {state['story']}")
    for part in ("keys", "strip", "source", "magnifier", "panel"):
        check(not state["shown"][part], f"{where}: {part} is left open")


def pressed(window, key, action):
    """Seconds until the key has run and its first picture is on the screen."""
    began = time.monotonic()
    window.hand("key", spelled(key))
    window.wait(f"{key} ({action})", lambda state: action in state["ran"], fresh=True)
    return time.monotonic() - began


def main():
    if "SHADOWLAB_LONG" not in os.environ:
        print("left out: it takes minutes; set SHADOWLAB_LONG")
        sys.exit(LEFT_OUT)
    program = os.path.abspath(sys.argv[1])
    actions = actions_of(program)
    for script in scripts_of((ROOT / "docs/teaching.md").read_text(encoding="utf-8")):
        for row, seconds in zip(script.rows, walk(script, program, actions)):
            if row.pressed:
                print(f"{script.deck} {row.first_minute:2}-{row.last_minute:2}: {len(row.pressed)} keys, {seconds:.1f} s", flush=True)


if __name__ == "__main__":
    main()
