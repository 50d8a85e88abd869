#!/usr/bin/env python3
"""What should not happen to a window, done to it: sizes from one pixel to more than a driver can draw, hundreds of them in a row,
files dropped that are no scenes, shaders that are broken while somebody edits them.

bad_days.py PROGRAM [sizes|drops|shaders]... After each the last good state is still there: the same scene, the same picture, no fault
in a pane, as many GL objects as before; and what was wrong is said in the window. SHADOWLAB_LONG=1 does more of each.
"""
# SPDX-License-Identifier: MIT
import os
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

from window_driver import Display, Window, check

DEBIAN_PYTHON = "/usr/bin/python3"  # the one that has the package python3-xlib, whatever else is first in the PATH
DROP = os.path.join(os.path.dirname(os.path.abspath(__file__)), "drop_file.py")
SHADERS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "shaders")
LONG = bool(os.environ.get("SHADOWLAB_LONG"))
SIZE = [700, 450]
MOST = 16384  # texels on a side, of Mesa's software renderer
SCENE = '{"camera": {"position": [3, 2, 5], "target": [0, 0, 0]}, "lights": [{"type": "point", "position": [0, 3, 0]}]}'
MESH = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"


class BadDay:
    """A window, what it was like before, and whether it still is."""

    def __init__(self, program, display, folder, **environment):
        self.window = Window(program, display, folder, "three-lights", "--keep-settings", "false", "--size",
                             "x".join(map(str, SIZE)), **environment)
        self.folder = folder
        self.number = subprocess.run(["xdotool", "search", "--name", "^Shadowlab$"], env=self.window.environment,
                                     capture_output=True, text=True, check=True).stdout.split()[0]
        self.window.hand("mousemove", 600, 400)
        self.window.key("i", "panel")  # its times differ from frame to frame; pictures are compared
        self.before = self.window.state

    def resize(self, size, wait=True):
        self.window.hand("windowsize", self.number, *size)
        if wait:
            drawn = [min(s, MOST) for s in size]
            return self.window.wait(f"a window of {size}", lambda s: s["size"] == drawn and s["settled"])
        return None

    def messages(self, what, shown):
        return self.window.wait(what, lambda s: shown(s["messages"]) and s["settled"])

    def unchanged(self, what, state=None):
        """All but the messages is as before, and nothing of the card's is lost."""
        state = state or self.window.state
        for key in ("scene", "camera", "lights", "panes", "glObjects"):
            now, then = state[key], self.before[key]
            if key == "panes":
                now, then = ([{**p, "frameMs": 0, "errors": None} for p in panes] for panes in (now, then))  # of that size
            if key == "glObjects" and now < then:
                continue  # a reload lets go of what only the closed panel asked for
            check(now == then, f"{what} changed {key}: {then} is now {now}")

    def end(self):
        """The picture is the first one again, and the window ends as it should."""
        w = self.window
        while w.state["messages"]:
            w.hand("key", "Escape")
            before = len(w.state["messages"])
            w.wait("a message to go", lambda s: len(s["messages"]) < before and s["settled"])
        w.wait("the first picture", lambda s: s["settled"] and s["picture"] == self.before["picture"])
        self.unchanged("the day")
        w.hand("key", "ctrl+q")
        check(w.process.wait(timeout=60) == 0, "the program did not end well")
        error = w.process.stderr.read()
        check(error == "", f"something was said on standard error: {error}")


def sizes(day):
    """From one pixel to more than there are; many in a row; hidden and shown again."""
    tried = [(1, 1), (2, 900), (900, 2), (MOST + 600, 60), (60, MOST + 600), (3840, 2160)] if LONG else \
            [(1, 1), (2, 900), (900, 2), (MOST + 600, 60)]
    for size in tried:
        state = day.resize(size)
        day.unchanged(f"a window of {size}", {**state, "glObjects": day.before["glObjects"]})
    rounds = 1000 if LONG else 60
    for i in range(rounds):
        day.resize((1 + i * 37 % 1200, 1 + i * 53 % 900), wait=False)
    day.resize(SIZE)
    day.window.hand("windowunmap", day.number)
    day.window.hand("windowmap", day.number)
    day.window.hand("mousemove", 600, 400)
    day.window.key("h", "keys")
    while day.window.state["shown"]["keys"]:  # the list may have several pages
        day.window.key("h", "keys")
    day.unchanged(f"{rounds} resizes")
    return len(tried) + rounds


def bad_files(folder):
    """Of each: its path, and words that the window says of it."""
    def file(name, content=None):
        path = os.path.join(folder, name)
        if content is not None:
            with open(path, "wb") as output:
                output.write(content.encode() if isinstance(content, str) else content)
        return path

    yield file("broken.json", '{\n  "camera": {"position": [0, 1, 2]},,\n}\n'), (":2:",)
    yield file("wrong.json", SCENE.replace("{\"type\"", "\n{\"typ\"")), (":2:", "typ", "type")
    yield file("half.json", SCENE[:60]), (":1:",)
    yield file("empty.json", ""), ("empty.json",)
    yield file("noise.json", os.urandom(4096)), ("noise.json",)
    yield file("deep.json", "[" * 100000), ("deep.json",)
    yield file("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"), (":4:", "9")
    yield file("comma.obj", "v 0,5 0 0\n"), (":1:",)
    yield file("no-faces.obj", "v 0 0 0\n"), ("no-faces.obj",)
    yield file("noise.obj", b"\xff\xd8\xff\xe0" + bytes(range(256)) * 16), ("noise.obj",)
    yield file("gone.json"), ("gone.json",)
    yield file("notes.txt", "hello"), (".json", ".obj")
    yield file("without-ending", SCENE), (".json", ".obj")
    folder_path = file("folder.json")
    os.makedirs(folder_path, exist_ok=True)
    yield folder_path, ("directory",)
    pipe = file("pipe.obj")
    os.mkfifo(pipe)  # that nobody will ever write to
    yield pipe, ("pipe.obj",)
    os.symlink(file("round.json"), file("round.json"))
    yield file("round.json"), ("round.json",)
    os.symlink("/dev/zero", file("endless.obj"))
    yield file("endless.obj"), ("endless.obj",)
    huge = file("huge.obj", "")
    os.truncate(huge, 3 << 30)  # no disk is filled: nothing but a hole
    yield huge, ("huge.obj", "2147483648")
    yield file("two\nlines \x1b[31m.json", "{"), ("two", ":1:")
    yield file("outside.json", SCENE[:-1] + ', "objects": [{"name": "o", "mesh": "/etc/passwd"}]}'), ("outside",)


def drops(day):
    """Each bad file alone; then all at once; a good one opens before and after."""
    w = day.window

    def drop(*paths):
        subprocess.run([DEBIAN_PYTHON, DROP, day.number, *paths], env=w.environment, check=True)

    def drop_good():
        with open(os.path.join(day.folder, "good one.OBJ"), "w", encoding="utf-8") as file:
            file.write(MESH)
        drop(file.name)
        w.wait("a dropped mesh", lambda s: s["scene"] == file.name and s["settled"])
        check(w.state["picture"] != day.before["picture"], "the dropped mesh is not seen")
        w.hand("key", "ctrl+z")
        # GLFW 3.5 takes the place of a drop for that of the mouse: here the mouse comes back, as a hand would bring it.
        w.hand("mousemove", 599, 400, "mousemove", 600, 400)
        w.wait("the scene of before", lambda s: s["scene"] == day.before["scene"] and s["settled"])

    # Programs and textures for a scene of one light stay: they are there before anything is counted. And at the end something is
    # there to be made again, which an icon shows; so it is from the start.
    drop_good()
    w.key("v", "next-layout")
    w.key("ctrl+z", "undo")
    day.before.update(picture=w.state["picture"], glObjects=w.state["glObjects"])
    tried = 0
    for path, words in bad_files(day.folder):
        drop(path)
        state = day.messages(f"what comes of dropping {path!r}", lambda m: any(all(w in one for w in words) for one in m))
        check(not any(c in one for one in state["messages"] for c in "\n\x1b"), f"a message of {path!r} is more than a line", state)
        check(len(state["messages"]) <= 3, "messages pile up", state)
        day.unchanged(f"dropping {path!r}")
        w.key("Escape", "leave")
        while w.state["messages"]:
            w.key("Escape", "leave")
        tried += 1
    drop(*(path for path, _ in bad_files_again(day.folder)))
    day.messages("what comes of dropping all at once", lambda m: len(m) > 0)
    day.unchanged("dropping all at once")
    for i in range(20 if LONG else 5):  # while the one before is still being read
        drop(os.path.join(day.folder, "huge.obj" if i % 2 else "broken.json"))
    day.unchanged("dropping one after the other")
    drop_good()
    return tried


def bad_files_again(folder):
    """Those that lie in the folder by now."""
    return ((os.path.join(folder, name), ()) for name in sorted(os.listdir(folder)) if os.path.islink(os.path.join(folder, name))
            or name.endswith((".json", ".obj", ".txt")))


def shaders(day, folder):
    """A saved shader is compiled at once; one that is broken leaves the picture, and a message until it is fixed."""
    path = os.path.join(folder, "light.glsl")
    with open(path, "rb") as file:
        good = file.read()

    def write(content):
        with open(path, "wb") as file:
            file.write(content)

    def folder_instead():
        os.remove(path)
        os.mkdir(path)

    def pipe_instead():
        os.rmdir(path)
        os.mkfifo(path)

    def fixed():
        if os.path.isdir(path):
            os.rmdir(path)
        elif os.path.exists(path):
            os.remove(path)
        write(good)

    half = good.rindex(b"}")
    breaks = [lambda: write(good + b"\nfloat oops = ;\n"), lambda: write(good[:half]), lambda: write(b""),
              lambda: write(bytes(range(256)) * 8), lambda: write(good + b'\n#include "no-such-file.glsl"\n'),
              lambda: write(good + b'\n#include light\n'), lambda: write(b" " * (2 << 20)), folder_instead, pipe_instead]
    said = []
    for i, broken in enumerate(breaks):
        broken()
        said.append(day.messages(f"what is said of broken shader {i + 1}",
                                 lambda m: m and m not in said and "shaders compiled" not in m)["messages"])
        check(all((".glsl" in one or ".frag" in one) and "; " in one and len(one) < 300 for one in said[-1]), f"broken shader {i + 1}: {said[-1]}")
        day.unchanged(f"broken shader {i + 1}")
    fixed()
    day.messages("the message to go", lambda m: any("shaders compiled" in one for one in m))
    os.remove(path)  # the program's own is taken instead
    day.messages("a deleted shader to be noticed", lambda m: any("shaders compiled" in one for one in m))
    write(good)
    rounds = 100 if LONG else 4
    for i in range(rounds):  # broken and fixed, again and again
        write(good + b"\noops\n" * (i % 2 == 0) + b"\n" * i)
        day.messages(f"what is said after change {i + 1}",
                     lambda m: any("light.glsl" in one for one in m) == (i % 2 == 0))
        day.unchanged(f"change {i + 1}")
    write(good)
    day.window.wait("the messages to go", lambda s: not s["messages"] and s["settled"])
    if LONG:
        print(*(one for messages in said for one in messages), sep="\n")
    return len(breaks) + 1 + rounds


def live(program, name):
    with Display("4096x2304") as display, tempfile.TemporaryDirectory() as folder:
        copy = shutil.copytree(SHADERS, os.path.join(folder, "shaders"))
        day = BadDay(program, display, folder, SHADOWLAB_SHADERS=copy)
        tried = {"sizes": sizes, "drops": drops, "shaders": lambda day: shaders(day, copy)}[name](day)
        day.end()
        print(f"{name}: {tried} tried, the window is as it was")


def main():
    program, wanted = os.path.abspath(sys.argv[1]), sys.argv[2:] or ["sizes", "drops", "shaders"]
    with ThreadPoolExecutor(2) as pool:
        for day in [pool.submit(live, program, name) for name in wanted]:
            day.result()


if __name__ == "__main__":
    main()
