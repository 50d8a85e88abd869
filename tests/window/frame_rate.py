#!/usr/bin/env python3
"""How quick the window is: frames a second while camera and light move, and how long it takes until a change is seen.

/usr/bin/python3 frame_rate.py PROGRAM [SCENE [KEYS]] prints the figures; it asserts nothing, for they belong to the machine.
KEYS, as xdotool names them, are pressed before light and camera turn; the default is 3, which shows the third technique. Ray
tracing alone in the window: "7 shift+v shift+v".
"""
# SPDX-License-Identifier: MIT
import os
import statistics
import sys
import tempfile
import time

import Xlib.display
from Xlib import X, XK
from Xlib.ext import xtest

from window_driver import Display, Window

SECONDS = 8  # of each measurement


def frames_per_second(window):
    """While it plays, from the frame numbers and times that the window itself reports."""
    first = window.wait("a moving frame", lambda s: s["playing"], fresh=True)
    times = [first["seconds"]]
    while times[-1] - first["seconds"] < SECONDS:
        times.append(window.wait("the next frame", lambda s: True, fresh=True)["seconds"])
    gaps = [b - a for a, b in zip(times, times[1:])]
    return 1 / statistics.mean(gaps), 1000 * statistics.median(gaps), 1000 * max(gaps)


class Keyboard:
    """Keys without a program of their own in between, so that nothing but the window is timed."""

    def __init__(self, name):
        self.display = Xlib.display.Display(name)

    def press(self, letter):
        code = self.display.keysym_to_keycode(XK.string_to_keysym(letter))
        for event in (X.KeyPress, X.KeyRelease):
            xtest.fake_input(self.display, event, code)
        self.display.flush()


def milliseconds(window, press, what, shown):
    begin = time.monotonic()
    press()
    window.wait(what, shown, fresh=True)
    return 1000 * (time.monotonic() - begin)


def main():
    program, scene = os.path.abspath(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else "colonnade"
    with Display() as display, tempfile.TemporaryDirectory() as folder:
        window = Window(program, display, folder, scene, "--keep-settings", "false", "--size", "1280x720")
        print(f"start to first picture    {1000 * window.first_frame:6.0f} ms")
        window.hand("mousemove", 100, 600)
        keyboard = Keyboard(display.name)
        for what in ("first", "second"):  # the first time a technique's shaders are compiled, and what it needs is built
            switches = []
            for key in "1234567":
                switches.append(milliseconds(window, lambda: keyboard.press(key), f"technique {key}",
                                             lambda s: f"technique-{key}" in s["ran"]))
                window.wait("rest", lambda s: s["settled"])
            print(f"{what} switch to techniques 1 to 7  " + ", ".join(f"{ms:.0f}" for ms in switches) + " ms")
        for key in sys.argv[3].split() if len(sys.argv) > 3 else ["3"]:
            window.hand("key", key)
        window.wait("rest", lambda s: s["settled"])
        window.hand("key", "c")
        for what, keys in (("light turns, settings shown", ()), ("camera turns, settings shown", ("a",)),
                           ("camera turns, pictures alone", ("i",)),
                           ("camera turns, coarse where slow", ("i", "c"))):
            for key in keys:
                window.hand("key", key)
            window.wait("rest", lambda s: s["settled"])
            window.hand("key", "space")
            rate, median, worst = frames_per_second(window)
            drafts = window.state["draft"]
            window.hand("key", "space")
            window.wait("rest", lambda s: s["settled"] and not s["playing"])
            print(f"{what:32}{rate:5.1f} frames a second, median {median:.0f} ms, worst {worst:.0f} ms, draft {drafts}")
        window.close()


if __name__ == "__main__":
    main()
