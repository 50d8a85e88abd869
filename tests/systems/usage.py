"""What a package is used for, as one who has just got it does it: lists, a picture, the window with and without a display, slides,
and a technique of one's own."""
# SPDX-License-Identifier: MIT
import json
import shlex
import struct
import subprocess
import sys
import time
from pathlib import Path

from places import expect

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "window"))
from window_driver import Display  # noqa: E402

FIRST_FRAME = 60  # seconds; on a busy machine a software driver compiles its shaders for some


def expect_picture(file, size=None):
    expect(file.is_file(), f"{file} has not been written")
    head = file.read_bytes()[:24]
    expect(head[:8] == b"\x89PNG\r\n\x1a\n" and file.stat().st_size > 1000, f"{file} is no picture")
    expect(size in (None, struct.unpack(">II", head[16:24])), f"{file} is not of {size} pixels")


class Use:
    """One program in one place."""

    def __init__(self, place, program):
        self.place, self.program = place, program

    def shadowlab(self, *words, **settings):
        return self.place.run(self.program, *words, **settings)

    def pictures(self):
        expect("egl" in self.shadowlab("list", "backends"), "no way to OpenGL is listed")
        self.shadowlab("capture", "still-life", "--size", "320x240", "-o", "x.png")
        expect_picture(self.place.home / "x.png", (320, 240))
        written = self.shadowlab("demo").rstrip().splitlines()[-1]
        expect_picture(self.place.home / Path(written).relative_to(self.place.inside))

    def slides(self, *some):
        """`some`: --only SLIDE; without, all."""
        self.shadowlab("slides", "shadows", *some, "--size", "640x360", "--supersample", "1", "-o", "slides")
        expect_picture(next((self.place.home / "slides").glob("shadows-*.png"), self.place.home / "slides"), (640, 360))
        expect(some or (self.place.home / "slides/shadows.html").is_file(), "the slides have no page")

    def window(self):
        """On a display there is a window with that name, and it has drawn."""
        with Display("1280x1024") as display:
            process = self.place.start(self.program, "demo", "--report", DISPLAY=display.name)
            try:
                end, state = time.monotonic() + FIRST_FRAME, None
                while time.monotonic() < end and not (state and state["settled"]):
                    line = process.stdout.readline()
                    expect(line, f"the window is not there: {process.stderr.read() if not line else ''}")
                    state = json.loads(line)
                expect(state and state["settled"], "the window has not finished a frame")
                found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "^Shadowlab"], capture_output=True, text=True,
                                       env={"DISPLAY": display.name, "PATH": "/usr/bin:/bin"}, check=False).stdout.split()
                expect(found, "no window is seen on the display")
            finally:
                process.kill()
                process.wait()

    def technique(self):
        """The commands that `new-technique` prints, as they are printed, but for the window."""
        said = self.shadowlab("new-technique", "my-shadows", "--from", "planar")
        commands = [shlex.split(line) for line in said.splitlines() if line.startswith("    ")]
        built = [words for words in commands if words[0] == "cmake"]
        expect(len(built) == 2, f"two commands to build it are expected:\n{said}")
        for words in built:
            self.place.run(*words)
        graded = [words for words in commands if words[1] == "grade"]
        expect(len(graded) == 1, f"one command to grade it is expected:\n{said}")
        sheet = json.loads(self.place.run(*graded[0], "--json", status=1))
        expect(0 <= sheet["points"] < sheet["of"], f"with empty blanks, some cases fail: {sheet}")
        expect(all(case["failure"] == "" for case in sheet["cases"]), f"with empty blanks, every case is drawn: {sheet}")
