#!/usr/bin/env python3
"""How quick the window is: frames a second while camera and light move, and how long it takes until a change is seen.

frame_rate.py PROGRAM [SCENE] prints the figures; it asserts nothing, for they belong to the machine.
"""
# SPDX-License-Identifier: MIT
import os
import statistics
import sys
import tempfile
import time

from drive_window import Display, Window

SECONDS = 8  # of each measurement


def frames_per_second(window):
    """While it plays, from the frame numbers and times that the window itself reports."""
    first = window.wait("a moving frame", lambda s: s["playing"], fresh=True)
    times = [first["seconds"]]
    while times[-1] - first["seconds"] < SECONDS:
        times.append(window.wait("the next frame", lambda s: True, fresh=True)["seconds"])
    gaps = [b - a for a, b in zip(times, times[1:])]
    return 1 / statistics.mean(gaps), 1000 * statistics.median(gaps), 1000 * max(gaps)


def main():
    program, scene = os.path.abspath(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else "colonnade"
    with Display() as display, tempfile.TemporaryDirectory() as folder:
        window = Window(program, display, folder, scene, "--keep-settings", "false", "--size", "1280x720")
        print(f"start to first picture    {1000 * window.first_frame:6.0f} ms")
        window.hand("mousemove", 100, 600)
        switches = []
        for key in ("1", "3", "2", "4", "3"):  # the first of each compiles its shaders
            begin = time.monotonic()
            window.hand("key", key)
            window.wait("another technique", lambda s: any(r.startswith("technique-") for r in s["ran"]), fresh=True)
            switches.append(1000 * (time.monotonic() - begin))
            window.wait("rest", lambda s: s["settled"])
        print("switch of technique to picture  " + ", ".join(f"{ms:.0f}" for ms in switches) + " ms, xdotool included")
        window.hand("key", "3")
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
