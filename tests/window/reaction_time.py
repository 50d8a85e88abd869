#!/usr/bin/env python3
"""How soon the window reacts to a key that opens the strip of stages or changes the layout, and how soon it has settled.

/usr/bin/python3 reaction_time.py PROGRAM [SCENE [KEYS]] prints the figures; it asserts nothing, for they belong to the machine.
For each key: milliseconds until a frame with the new layout is on the screen ("reacts"), and until also the small pictures and the
exact errors are there ("settles"). Beside each stands the processor time that the program has used until then, in all its threads:
other programs on the machine change it far less. "gap" is the longest time between two states that the window has reported: as
long as the strip is being drawn, each slice of it is one. KEYS, as xdotool names them, are pressed before, to choose techniques.
"""
# SPDX-License-Identifier: MIT
import os
import sys
import tempfile
import time

from frame_rate import Keyboard
from window_driver import Display, Window

ROUNDS = 3  # the first compiles shaders and builds what techniques need, the others are what a class sees
LAYOUTS = [("v", "next-layout")] * 5
KEYS = [("t", "strip"), ("t", "strip"), *LAYOUTS, ("t", "strip"), *LAYOUTS, ("t", "strip")]


def processor_ms(process):
    with open(f"/proc/{process.pid}/stat", encoding="ascii") as stat:
        fields = stat.read().rsplit(")", 1)[1].split()
    return 1000 * (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def timed(window, keyboard, key, action):
    """Milliseconds and processor milliseconds to the first frame, the same to the settled one, and the longest gap."""
    used, begin = processor_ms(window.process), time.monotonic()

    def since():
        return [1000 * (time.monotonic() - begin), processor_ms(window.process) - used]

    keyboard.press(key)
    window.wait(f"{key} ({action})", lambda s: action in s["ran"], fresh=True)
    reacted, gap, last = since(), 0, window.state["seconds"]
    while not window.state["settled"]:
        window.wait("the next state", lambda s: True, fresh=True)
        gap, last = max(gap, window.state["seconds"] - last), window.state["seconds"]
    return [*reacted, *since(), 1000 * gap]


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
            print(f"round {turn + 1}                  reacts  (proc)  settles (proc)     gap  (ms)")
            for key, action in KEYS:
                times = timed(window, keyboard, key, action)
                strip = window.state["shown"]["strip"]
                name = ("strip opens" if strip else "strip closes") if key == "t" else \
                    f"to {window.state['layout']}{' with strip' if strip else ''}"
                print(f"  {name:22}" + "".join(f"{ms:8.0f}" for ms in times), flush=True)
        window.close()


if __name__ == "__main__":
    main()
