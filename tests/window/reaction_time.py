#!/usr/bin/env python3
"""How soon the window reacts to a key that opens the strip of stages or changes the layout, and how soon it has settled.

/usr/bin/python3 reaction_time.py PROGRAM [SCENE [KEYS]] prints the figures; it asserts nothing, for they belong to the machine.
For each key: milliseconds until a frame with the new layout is on the screen, until the pictures are finished, and until also the
exact errors are there (settled); then the processor time of the program, all its threads, which other programs on the machine
change far less. KEYS, as xdotool names them, are pressed before, to choose techniques.
"""
# SPDX-License-Identifier: MIT
import os
import statistics
import sys
import tempfile
import time

from frame_rate import Keyboard
from window_driver import Display, Window

ROUNDS = 3  # the first compiles shaders and builds what techniques need, the others are what a class sees
SMALL_GAP = 0.35  # seconds: a window that reports nothing for so long was blocked, not idle


def processor_seconds(process):
    with open(f"/proc/{process.pid}/stat", encoding="ascii") as stat:
        fields = stat.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def timed(window, keyboard, key, action):
    """Milliseconds to the first frame and to the settled one, the longest the window was silent, processor ms."""
    used = processor_seconds(window.process)
    begin = last = time.monotonic()
    keyboard.press(key)
    window.wait(f"{key} ({action})", lambda s: action in s["ran"], fresh=True)
    reacted = time.monotonic() - begin
    silent = 0
    while True:
        now = time.monotonic()
        silent, last = max(silent, now - last), now
        if window.state["settled"]:
            break
        window.wait("the next state", lambda s: True, fresh=True)
    return [1000 * t for t in (reacted, last - begin, processor_seconds(window.process) - used)]


def main():
    program, scene = os.path.abspath(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else "still-life"
    with Display() as display, tempfile.TemporaryDirectory() as folder:
        window = Window(program, display, folder, scene, "--keep-settings", "false", "--size", "1280x720")
        window.hand("mousemove", 100, 600)
        for key in sys.argv[3].split() if len(sys.argv) > 3 else []:
            window.hand("key", key)
        window.wait("rest", lambda s: s["settled"])
        keyboard = Keyboard(display.name)
        for turn in range(ROUNDS):
            print(f"round {turn + 1}                  reacts  settles  processor (ms)")
            for key, action, what in [("t", "strip", "strip opens"), ("t", "strip", "strip closes")] + \
                    [("v", "next-layout", None)] * 5 + [("t", "strip", "strip opens")] + \
                    [("v", "next-layout", None)] * 5 + [("t", "strip", "strip closes")]:
                times = timed(window, keyboard, key, action)
                strip = " with strip" if window.state["shown"]["strip"] and not what else ""
                name = what or f"to {window.state['layout']}{strip}"
                print(f"  {name:22}" + "".join(f"{ms:8.0f}" for ms in times), flush=True)
        window.close()


if __name__ == "__main__":
    main()
