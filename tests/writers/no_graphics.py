#!/usr/bin/env python3
"""A machine on which OpenGL is missing, too old, or goes away: every command that draws ends with status 5 and one line that says
what was found and its remedy, and leaves nothing behind. What is advised is no package that is installed, and none that cannot be
had. Where only a window cannot be opened, the demo writes its picture. no_graphics.py BUILD_FOLDER"""
# SPDX-License-Identifier: MIT
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import outputs

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "window"))
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))
from osmesa import WITHOUT, may_lack_osmesa  # noqa: E402
from window_driver import Display  # noqa: E402

NONE = "/none"
BARE = {"DPKG_ADMINDIR": "bare"}  # where nothing is installed, as dpkg is told of it
EGL, OSMESA, GLX = "libEGL", "libOSMesa", "libGLX:libGL.so"
# Mesa's GLX reads a reply that never came, and crashes, where the X server dies while a window is made. As this can take a tenth of a
# second and more, the same moment would be met again: each further try waits twice as long as the one before, the last 1.6 s or more.
MESA_TRIES = 5
LONGEST = 20  # seconds from the display's end to the program's; that is a hang

# (environment, backend, what the line has to say); none to say: another backend serves
HEADLESS = [
    ({"REFUSED_LIBRARIES": EGL}, "egl", ["libEGL.so.1 is missing", "libegl1"]),
    ({"REFUSED_LIBRARIES": EGL, **BARE}, "egl", ["libEGL.so.1 is missing", "apt install libegl1 libgl1-mesa-dri"]),
    ({"REFUSED_LIBRARIES": OSMESA}, "osmesa", ["libOSMesa.so.8 is missing", "--backend egl"]),
    ({"REFUSED_LIBRARIES": OSMESA}, "auto", None),
    ({"REFUSED_LIBRARIES": f"{EGL}:{OSMESA}"}, "auto", ["libEGL.so.1 is missing", "libOSMesa.so.8 is missing", "DISPLAY", "libegl1"]),
    ({"REFUSED_LIBRARIES": f"{EGL}:{OSMESA}", **BARE}, "auto", ["libEGL.so.1 is missing", "apt install libegl1 libgl1-mesa-dri"]),
    ({"GALLIUM_DRIVER": "none"}, "egl", ["no driver can be loaded", "unset GALLIUM_DRIVER"]),
    ({"GALLIUM_DRIVER": "none"}, "auto", ["no driver can be loaded", "unset GALLIUM_DRIVER"]),
    ({"__EGL_VENDOR_LIBRARY_DIRS": NONE}, "egl", ["no display", "unset __EGL_VENDOR_LIBRARY_DIRS"]),
    ({"__EGL_VENDOR_LIBRARY_DIRS": NONE, **BARE}, "egl", ["no display", "apt install libegl-mesa0 libgl1-mesa-dri"]),
    ({"MESA_GL_VERSION_OVERRIDE": "2.1"}, "egl", ["OpenGL 2.1", "3.3", "newer driver"]),
    ({"MESA_GL_VERSION_OVERRIDE": "3.2"}, "egl", ["OpenGL 3.2", "3.3", "newer driver"]),
    ({"MESA_GL_VERSION_OVERRIDE": "2.1"}, "auto", ["OpenGL 2.1", "3.3", "newer driver"]),
    ({"MESA_GL_VERSION_OVERRIDE": "3.2"}, "auto", ["OpenGL 3.2", "3.3", "newer driver"]),
    ({}, "window", ["DISPLAY", "desktop session", "--backend egl"]),
    ({"DISPLAY": ":987"}, "window", ["display :987", "desktop session"]),
    ({"DISPLAY": "no such machine:0"}, "window", ["no such machine:0", "desktop session"]),
]
# Those that ask for OSMesa, or count on it.
WITH_OSMESA = [
    ({"MESA_GL_VERSION_OVERRIDE": "2.1"}, "osmesa", ["OpenGL 2.1", "3.3", "newer driver"]),
    ({"MESA_GL_VERSION_OVERRIDE": "3.2"}, "osmesa", ["OpenGL 3.2", "3.3", "newer driver"]),
    ({"__EGL_VENDOR_LIBRARY_DIRS": NONE}, "auto", None),
    ({"REFUSED_LIBRARIES": EGL}, "auto", None),
    ({"REFUSED_LIBRARIES": OSMESA, **BARE}, "osmesa", ["apt install libosmesa6, or take --backend egl"]),
    ({"REFUSED_LIBRARIES": f"{EGL}:{OSMESA}", **BARE}, "auto", ["apt install libegl1 libgl1-mesa-dri libosmesa6"]),
]
# Drivers were files at a place that a variable names, until they went into one library (Mesa 24.3).
OF_FILES = [
    ({"LIBGL_DRIVERS_PATH": NONE}, "egl", ["no driver can be loaded", "unset LIBGL_DRIVERS_PATH"]),
    ({"LIBGL_DRIVERS_PATH": NONE, **BARE}, "egl", ["no driver can be loaded", "apt install libgl1-mesa-dri"]),
    ({"LIBGL_DRIVERS_PATH": NONE, "REFUSED_LIBRARIES": OSMESA}, "auto", ["no driver can be loaded"]),
]
# The same for windows, which are opened by GLX or by EGL: the backend of a capture, and the demo that would show one.
ON_DISPLAY = [
    ({"GALLIUM_DRIVER": "none"}, ["no OpenGL", "unset GALLIUM_DRIVER"]),
    ({"REFUSED_LIBRARIES": f"{GLX}:{EGL}"}, ["no OpenGL", "libgl1"]),
    ({"REFUSED_LIBRARIES": f"{GLX}:{EGL}", **BARE}, ["no OpenGL", "apt install libgl1 libgl1-mesa-dri, or take --backend egl"]),
    ({"MESA_GL_VERSION_OVERRIDE": "2.1"}, ["OpenGL 2.1", "3.3", "newer driver"]),
    ({"MESA_GL_VERSION_OVERRIDE": "3.2"}, ["OpenGL 3.2", "3.3", "newer driver"]),
]
CARD = {"force_gl_renderer": "some card", "MESA_DEBUG": "silent"}  # which else speaks of the first
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

    def listed(self, changes):
        return subprocess.run([self.program, "list", "backends"], env=self.environment(changes), capture_output=True, text=True, check=True).stdout

    def advises_well(self, line):
        """Packages that are told to be installed are not there, those to be installed again are."""
        advised = re.search(r"apt (install|reinstall)((?: [a-z0-9][a-z0-9.+-]+)+)", line)
        if not advised or not shutil.which("dpkg-query"):
            return True
        shown = subprocess.run(["dpkg-query", "-W", "-f", "${Package} ${db:Status-Status}\n"], capture_output=True, text=True, check=True)
        installed = {row.split()[0] for row in shown.stdout.splitlines() if row.endswith(" installed")}
        return all((package in installed) == (advised.group(1) == "reinstall") for package in advised.group(2).split())

    def expect(self, what, process, status, parts, is_bare=False):
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
            right = right and (is_bare or self.advises_well(err))
        if not right:
            self.wrong.append(f"{what}: status {process.returncode}, says {err!r}; expected status {status} and {parts}")

    def files(self):
        return sorted(str(path) for path in self.place.rglob("*"))

    def refused(self, words, changes, parts):
        before = self.files()
        what = f"{' '.join(words)} with {changes}"
        self.expect(what, self.start(words, changes), 5, parts, "DPKG_ADMINDIR" in changes)
        if self.files() != before:
            self.wrong.append(f"{what}: leaves {sorted(set(self.files()) - set(before))}")

    def instead(self, words, changes, why, made):
        """The demo writes a picture in place of a window, and says why in one line."""
        what = f"{' '.join(words)} with {changes}"
        process = self.start(words, changes)
        try:
            out, err = process.communicate(timeout=LONGEST)
        except subprocess.TimeoutExpired:
            process.kill()
            out, err = process.communicate()
        self.tried += 1
        place = self.place / made
        said = [line for line in err.splitlines() if line.startswith("shadowlab: ") and "written instead" in line]
        if process.returncode != 0 or len(said) != 1 or why not in said[0] or out != f"{place}\n" or not place.exists():
            self.wrong.append(f"{what}: status {process.returncode}, prints {out!r}, says {err!r}; expected {made} and '{why}'")
        if place.is_dir():
            shutil.rmtree(place)
        else:
            place.unlink(missing_ok=True)

    def opens_a_window(self, words, changes):
        what = f"{' '.join(words)} with {changes}"
        process = self.start([*words, "--report"], changes)
        first = process.stdout.readline()  # of its first picture
        process.terminate()
        err = process.communicate()[1]
        self.tried += 1
        if not first.startswith("{") or err:
            self.wrong.append(f"{what}: no window; prints {first!r}, says {err!r}")


def headless(trial):
    trial.lacks_osmesa = may_lack_osmesa(trial.program)
    trial.has_files = "no driver" in trial.listed({"LIBGL_DRIVERS_PATH": NONE})
    if trial.lacks_osmesa:
        print(WITHOUT)
    for changes, backend, parts in HEADLESS + ([] if trial.lacks_osmesa else WITH_OSMESA) + (OF_FILES if trial.has_files else []):
        words = ["capture", "box.json", "-o", "x.png", "--size", "32x24", "--backend", backend]
        if parts is not None:
            trial.refused(words, changes, parts)
            continue
        words[words.index("x.png")] = "/dev/null"
        trial.expect(f"{' '.join(words)} with {changes}", trial.start(words, changes), 0, [])
    for words in COMMANDS:
        trial.refused(words, NOTHING, ["no graphics context"])
    trial.expect("list backends", trial.start(["list", "backends"], NOTHING), 0, [])
    for deck, lesson, made in ((None, None, "box-comparison.png"), ("deck.json", None, "deck-slides"), (None, "acne", "acne-lesson.png")):
        trial.instead(["demo", "box.json", *(["--deck", deck] if deck else []), *(["--lesson", lesson] if lesson else [])], {},
                      "there is no display", made)


def software(trial):
    """Mesa says the name that `force_gl_renderer` holds: what a graphics card is to --software."""
    words = ["capture", "box.json", "-o", "x.png", "--size", "32x24", "--software"]
    trial.refused([*words, "--backend", "egl"], CARD, ["some card", "--software"])
    if trial.lacks_osmesa:
        trial.refused(words, CARD, ["some card", "--software"])
    words[words.index("x.png")] = "/dev/null"
    for before in ({}, {"LIBGL_ALWAYS_SOFTWARE": "0"}, {"GALLIUM_DRIVER": "softpipe"}):
        trial.expect(f"{' '.join(words)} with {before}", trial.start(words, before), 0, [])
    trial.refused(["capture", "box.json", "-o", "x.png", "--software", "--backend", "egl"], {"GALLIUM_DRIVER": "none"}, ["unset GALLIUM_DRIVER"])
    trial.expect("list backends --software", trial.start(["list", "backends", "--software"], CARD), 0, [])


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
    window = ["capture", "box.json", "-o", "x.png", "--backend", "window"]
    with Display() as display:
        for changes, parts in ON_DISPLAY:
            changes = {**changes, "DISPLAY": display.name}
            trial.refused(window, changes, parts)
            if GLX not in changes.get("REFUSED_LIBRARIES", "") or trial.lacks_osmesa:
                trial.refused(["demo", "box.json"], changes, ["no graphics context"])
        trial.refused([*window, "--software"], {**CARD, "DISPLAY": display.name}, ["some card", "--software"])
        trial.opens_a_window(["demo", "box.json", "--software"], {"DISPLAY": display.name, "LIBGL_ALWAYS_SOFTWARE": "0"})
        trial.opens_a_window(["demo", "box.json"], {"DISPLAY": display.name, "REFUSED_LIBRARIES": GLX})


def display_without_glx(trial):
    """As those of VNC and NX: a window is opened by EGL, and where that is missing, too, the demo writes its pictures."""
    with Display("1280x1024", "-extension", "GLX") as display:
        trial.opens_a_window(["demo", "box.json"], {"DISPLAY": display.name})
        if trial.lacks_osmesa:
            return
        changes = {"DISPLAY": display.name, "REFUSED_LIBRARIES": EGL}
        trial.refused(["capture", "box.json", "-o", "x.png", "--backend", "window"], changes, ["no OpenGL", "GLX"])
        for words, made in (([], "box-comparison.png"), (["--lesson", "acne"], "acne-lesson.png"), (["--deck", "deck.json"], "deck-slides")):
            trial.instead(["demo", "box.json", *words], changes, "no window can be opened (", made)


def display_that_goes(trial):
    """At moments from before the first picture to long after it."""
    for words, seconds in ((["demo", "box.json", "--report"], 0.1), (["demo", "box.json", "--report"], 0.4), (["demo", "box.json", "--report"], None),
                           (["demo", "--lesson", "acne", "--report"], None)):
        wrong = "not tried"
        for attempt in range(1 if seconds is None else MESA_TRIES):
            status, wrong = display_goes(trial, words, seconds and seconds * 2 ** attempt)
            if not wrong or status != -signal.SIGSEGV:
                break
        trial.tried += 1
        if wrong:
            trial.wrong.append(wrong)


def display_goes(trial, words, seconds):
    """The status, and what is wrong with the end of the program whose display goes after so many seconds, None: after its first picture."""
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
    # A program that has no window yet goes on without one.
    fine = process.returncode == 5 and err.count("\n") == 1 and err.startswith("shadowlab: no graphics context") and "; " in err
    if fine or seconds is not None and process.returncode == 0 and "written instead" in err:
        return process.returncode, ""
    return process.returncode, (f"{' '.join(words)}, display killed after {seconds or 'the first picture'}: status {process.returncode} "
                                f"after {time.monotonic() - killed:.1f} s, says {err!r}")


def main(build):
    with tempfile.TemporaryDirectory() as place:
        trial = Trial(build, place)
        outputs.write_inputs(trial.place)
        (trial.place / "bare").mkdir()
        (trial.place / "bare" / "status").write_text("")
        for part in (headless, software, display_that_hangs_up, on_display, display_without_glx, display_that_goes):
            part(trial)
    print("\n".join(trial.wrong))
    least = len(HEADLESS) + len(COMMANDS) + len(ON_DISPLAY) + 20
    print(f"{trial.tried} runs without graphics, {len(trial.wrong)} wrong")
    return 1 if trial.wrong or trial.tried < least else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
