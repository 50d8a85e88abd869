#!/usr/bin/env python3
"""A machine on which OpenGL is missing, too old, or goes away: every command that draws ends with status 5 and one line that says
what was found and what mends it, and leaves nothing behind. no_graphics.py BUILD_FOLDER"""
# SPDX-License-Identifier: MIT
import os
import socket
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import outputs

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "ui"))
from window_driver import Display  # noqa: E402

NONE = "/none"
EGL, OSMESA, GLX = "libEGL", "libOSMesa", "libGLX:libGL.so"
LONGEST = 20  # seconds from the display's end to the program's; that is a hang
DRI, INSTALL_EGL = "libgl1-mesa-dri", "apt install libegl1"

# (environment, backend, what the line has to say); none to say: another backend serves
HEADLESS = [
    ({"REFUSED_LIBRARIES": EGL}, "egl", ["libEGL.so.1 is missing", INSTALL_EGL]),
    ({"REFUSED_LIBRARIES": EGL}, "auto", None),
    ({"REFUSED_LIBRARIES": OSMESA}, "osmesa", ["libOSMesa.so.8 is missing", "apt install libosmesa6"]),
    ({"REFUSED_LIBRARIES": OSMESA}, "auto", None),
    ({"REFUSED_LIBRARIES": f"{EGL}:{OSMESA}"}, "auto", ["libEGL.so.1 is missing", "libOSMesa.so.8 is missing", "DISPLAY", INSTALL_EGL, "libosmesa6"]),
    ({"LIBGL_DRIVERS_PATH": NONE}, "egl", ["no driver can be loaded", DRI]),
    ({"LIBGL_DRIVERS_PATH": NONE}, "auto", None),
    ({"LIBGL_DRIVERS_PATH": NONE, "REFUSED_LIBRARIES": OSMESA}, "auto", ["no driver can be loaded", DRI, "libosmesa6"]),
    ({"__EGL_VENDOR_LIBRARY_DIRS": NONE}, "egl", ["no display", "libegl-mesa0"]),
    ({"__EGL_VENDOR_LIBRARY_DIRS": NONE}, "auto", None),
    ({"MESA_GL_VERSION_OVERRIDE": "2.1"}, "egl", ["OpenGL 2.1", "3.3", "newer driver"]),
    ({"MESA_GL_VERSION_OVERRIDE": "3.2"}, "egl", ["OpenGL 3.2", "3.3", "newer driver"]),
    ({"MESA_GL_VERSION_OVERRIDE": "2.1"}, "osmesa", ["OpenGL 2.1", "3.3", "newer driver"]),
    ({"MESA_GL_VERSION_OVERRIDE": "3.2"}, "osmesa", ["OpenGL 3.2", "3.3", "newer driver"]),
    ({"MESA_GL_VERSION_OVERRIDE": "2.1"}, "auto", ["OpenGL 2.1", "3.3", "newer driver"]),
    ({"MESA_GL_VERSION_OVERRIDE": "3.2"}, "auto", ["OpenGL 3.2", "3.3", "newer driver"]),
    ({}, "window", ["DISPLAY", "desktop session", "--backend egl"]),
    ({"DISPLAY": ":987"}, "window", ["display :987", "desktop session"]),
    ({"DISPLAY": "no such machine:0"}, "window", ["no such machine:0", "desktop session"]),
]
# The same for windows: the backend of a capture, and the demo that would show one.
ON_DISPLAY = [
    ({"LIBGL_DRIVERS_PATH": NONE}, ["no OpenGL", DRI]),
    ({"REFUSED_LIBRARIES": GLX}, ["no OpenGL", "apt install libgl1"]),
    ({"MESA_GL_VERSION_OVERRIDE": "2.1"}, ["OpenGL 2.1", "3.3", "newer driver"]),
    ({"MESA_GL_VERSION_OVERRIDE": "3.2"}, ["OpenGL 3.2", "3.3", "newer driver"]),
]
NOTHING = {"REFUSED_LIBRARIES": f"{EGL}:{OSMESA}"}
COMMANDS = [["capture", "box.json", "-o", "x.png"], ["capture", "box.json", "-o", "f_#.png", "--frames", "2", "--stats", "s.json"],
            ["measure", "box.json"], ["measure", "box.json", "--json"], ["report", "box.json", "--quick", "-o", "report"], ["report", "--hard", "-o", "hard"],
            ["slides", "deck.json", "-o", "slides"], ["lesson", "acne"], ["lesson", "acne", "-o", "l.png"], ["demo", "box.json"],
            ["demo", "--lesson", "acne"], ["capture", "box.json", "-o", "ui.png", "--ui"]]


class Trial:
    def __init__(self, build, place):
        self.program, self.library, self.place = build / "shadowlab", build / "tests" / "librefused_libraries.so", Path(place)
        self.tried, self.wrong = 0, []

    def environment(self, changes):
        kept = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY", "LIBGL_DEBUG")}
        return {**kept, "LD_PRELOAD": str(self.library), "XDG_CONFIG_HOME": str(self.place), **changes}

    def start(self, words, changes):
        return subprocess.Popen([self.program, *words], cwd=self.place, env=self.environment(changes), stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)

    def expect(self, what, process, status, parts):
        before_end = time.monotonic()
        try:
            out, err = process.communicate(timeout=120)
        except subprocess.TimeoutExpired:
            process.kill()
            out, err = process.communicate()
            err += f"(killed after {time.monotonic() - before_end:.0f} s)"
        self.tried += 1
        right = process.returncode == status
        if status == 5:
            right = right and err.count("\n") == 1 and err.startswith("shadowlab: ") and "; " in err and out == ""
            right = right and all(part in err for part in parts)
        if not right:
            self.wrong.append(f"{what}: status {process.returncode}, says {err!r}; expected status {status} and {parts}")

    def files(self):
        return sorted(str(path) for path in self.place.rglob("*"))

    def refused(self, words, changes, parts):
        before = self.files()
        what = f"{' '.join(words)} with {changes}"
        self.expect(what, self.start(words, changes), 5, parts)
        if self.files() != before:
            self.wrong.append(f"{what}: leaves {sorted(set(self.files()) - set(before))}")


def headless(trial):
    for changes, backend, parts in HEADLESS:
        words = ["capture", "box.json", "-o", "x.png", "--size", "32x24", "--backend", backend]
        if parts is not None:
            trial.refused(words, changes, parts)
            continue
        words[words.index("x.png")] = "/dev/null"
        trial.expect(f"{' '.join(words)} with {changes}", trial.start(words, changes), 0, [])
    for words in COMMANDS:
        trial.refused(words, NOTHING, ["no graphics context"])
    trial.expect("list backends", trial.start(["list", "backends"], NOTHING), 0, [])


def display_that_hangs_up(trial):
    """Something listens where the display should be, and ends every talk at once."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        def refuse():
            while True:
                try:
                    server.accept()[0].close()
                except OSError:
                    return
        threading.Thread(target=refuse, daemon=True).start()
        port = server.getsockname()[1] - 6000
        trial.refused(["capture", "box.json", "-o", "x.png", "--backend", "window"], {"DISPLAY": f"127.0.0.1:{port}"}, ["desktop session"])


def on_display(trial):
    with Display() as display:
        for changes, parts in ON_DISPLAY:
            changes = {**changes, "DISPLAY": display.name}
            trial.refused(["capture", "box.json", "-o", "x.png", "--backend", "window"], changes, parts)
            trial.refused(["demo", "box.json"], changes, parts)


def display_that_goes(trial):
    """At moments from before the first picture to long after it."""
    for words, seconds in ((["demo", "box.json", "--report"], 0.1), (["demo", "box.json", "--report"], 0.4), (["demo", "box.json", "--report"], None),
                           (["demo", "--lesson", "acne", "--report"], None)):
        with Display() as display:
            process = trial.start(words, {"DISPLAY": display.name})
            if seconds is None:
                process.stdout.readline()  # its first picture is there
            else:
                time.sleep(seconds)
            display.server.kill()
            killed = time.monotonic()
            try:
                _, err = process.communicate(timeout=LONGEST)
            except subprocess.TimeoutExpired:
                process.kill()
                err = process.communicate()[1] + "(it hangs)"
            trial.tried += 1
            # A program that has not yet asked for the display finds none, and goes on without a window.
            fine = process.returncode == 5 and err.count("\n") == 1 and err.startswith("shadowlab: no graphics context") and "; " in err
            if not fine and not (seconds is not None and process.returncode == 0 and "no display" in err):
                trial.wrong.append(f"{' '.join(words)}, display killed after {seconds or 'the first picture'}: status {process.returncode} "
                                   f"after {time.monotonic() - killed:.1f} s, says {err!r}")


def main(build):
    with tempfile.TemporaryDirectory() as place:
        trial = Trial(build, place)
        outputs.write_inputs(trial.place)
        for part in (headless, display_that_hangs_up, on_display, display_that_goes):
            part(trial)
    print("\n".join(trial.wrong))
    least = len(HEADLESS) + len(COMMANDS) + 2 * len(ON_DISPLAY) + 5
    print(f"{trial.tried} runs without graphics, {len(trial.wrong)} wrong")
    return 1 if trial.wrong or trial.tried < least else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
