"""The program's window on a display of its own, hands for it, and what it reports of itself."""
# SPDX-License-Identifier: MIT
import json
import os
import queue
import subprocess
import threading
import time

# Function keys by their codes: of their names xdotool makes keys that are held with Alt, where X has tables of keys of 2025 (xkb-data 2.48).
KEY_CODES = {**{f"F{n}": 66 + n for n in range(1, 11)}, "F11": 95, "F12": 96}
TIMEOUT = 90  # seconds without the expected report: far beyond any frame, also on a busy machine


class Display:
    """An X server nobody else uses: keys go where the test means them to go."""

    def __init__(self, size="1920x1200", *further):
        self.size, self.further = size, further

    def __enter__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", self.size + "x24", "-noreset", "-nolisten", "tcp", *self.further],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as numbers:
            self.name = ":" + numbers.readline().strip()
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()


class Window:
    """The program's window, its reports, and hands for it."""

    def begun(self, state):
        """Whether the window can be worked with: here, when also its exact numbers are there."""
        return state["settled"]

    def __init__(self, program, display, folder, *arguments, **environment):
        self.environment = {**os.environ, "DISPLAY": display.name, "XDG_CONFIG_HOME": folder, **environment}
        self.environment.pop("WAYLAND_DISPLAY", None)
        self.started = time.monotonic()
        self.process = subprocess.Popen([program, "demo", "--report", *arguments], cwd=folder, env=self.environment,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.reports = queue.Queue()
        self.state = {}
        threading.Thread(target=self._listen, daemon=True).start()
        self.first_frame = None
        self.wait("the first picture", self.begun)

    def _listen(self):
        for line in self.process.stdout:
            if self.first_frame is None:
                self.first_frame = time.monotonic() - self.started
            self.reports.put(json.loads(line))
        self.reports.put(None)

    def wait(self, what, shown, fresh=False):
        """The next state for which `shown` holds; the present one, too, unless it has to be `fresh`."""
        end = time.monotonic() + TIMEOUT
        if self.state and not fresh and shown(self.state):
            return self.state
        while True:
            try:
                if time.monotonic() > end + 4 * TIMEOUT:  # reports that never end, of something that moves
                    raise queue.Empty
                report = self.reports.get(timeout=max(0.01, end - time.monotonic()))
            except queue.Empty:
                raise AssertionError(f"{what}: not seen in {TIMEOUT} s; the last state was {self.state}") from None
            if report is None:
                raise AssertionError(f"{what}: the program has ended: {self.process.stderr.read()}")
            self.state = report
            if shown(report):
                return report

    def hand(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True)

    def key(self, keys, action):
        """Presses keys, and waits until that action has run and its picture is on the screen."""
        before = self.state
        self.hand("key", "+".join(str(KEY_CODES.get(key, key)) for key in keys.split("+")))
        self.wait(f"{keys} ({action})", lambda s: action in s["ran"], fresh=True)
        return before, self.wait(f"the picture after {keys} ({action})", lambda s: s["settled"] or s["playing"]
                                 or s["shown"]["blink"])

    def close(self):
        self.process.terminate()
        self.process.wait()


def pane(state, number=None):
    return state["panes"][(state["active"] if number is None else number) - 1]


def check(condition, what, *states):
    if not condition:
        raise AssertionError(what + "".join(f"\n  {s}" for s in states))
