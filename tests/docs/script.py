"""The teacher's scripts in docs/teaching.md: their rows, and the windows that their keys are pressed in."""
# SPDX-License-Identifier: MIT
import re
import shlex
from typing import NamedTuple

SECTION = re.compile(r"^## ", re.MULTILINE)
WINDOW = re.compile(r"^    build/release/shadowlab demo (.*?)\s+# ([A-Z])$", re.MULTILINE)
CODE = re.compile(r"`([^`]+)`")
NUMBERED = re.compile(r"(\d+) `([\w-]+)`")
PRESSED = re.compile(r"([A-Z]):((?:\s*`[^`]+`)+)")


class Row(NamedTuple):
    first_minute: int
    last_minute: int
    slides: list
    numbers: list  # of these slides, as the band shows them
    pressed: list  # (letter of the window, key), in order


class Script(NamedTuple):
    deck: str
    windows: dict  # letter: what stands after `demo`
    rows: list

    def shows_deck(self, letter):
        """Whether that window goes through the whole deck: there PageDown stands for "on to the next slide of the row"."""
        words = self.windows.get(letter, [])
        return "--deck" in words and "--slide" not in words


def scripts_of(text):
    """Each table below a marker <!-- script: DECK -->."""
    found = []
    for section in SECTION.split(text):
        marker = re.search(r"<!-- script: ([\w-]+) -->\n\n(.*?)\n\n", section, re.DOTALL)
        if marker:
            windows = {letter: shlex.split(words) for words, letter in WINDOW.findall(section)}
            found.append(Script(marker.group(1), windows, [row_of(line) for line in marker.group(2).split("\n")[2:]]))
    return found


def row_of(line):
    minutes, slides, keys = (cell.strip() for cell in line.strip("|").split("|")[:3])
    first, last = map(int, minutes.split("-"))
    pressed = [(letter, key) for letter, keys_there in PRESSED.findall(keys) for key in CODE.findall(keys_there)]
    numbers = [int(number) for number, _ in NUMBERED.findall(slides)]
    return Row(first, last, CODE.findall(slides), numbers, pressed)
