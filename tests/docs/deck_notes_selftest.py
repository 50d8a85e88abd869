#!/usr/bin/env python3
"""docs/deck_notes.py keeps apart what a lecturer says and what is done with keys of the program's window, which do nothing in a browser;
and every slide of the built-in decks has notes."""
# SPDX-License-Identifier: MIT
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "docs"))
import deck_notes  # noqa: E402

LEAST_SLIDES, LEAST_IN_WINDOW = 70, 10  # so that decks or notes that are no longer found are noticed
CELLS = (
    ("*Look.* `N`: one pass. *Count.*", ["Look.", "In the program's window: N: one pass.", "Count."]),
    ("The line. `O`: from outside; it is long. *Inside.* `O`: back.",
     ["The line.", "In the program's window: O: from outside; it is long.", "Inside.", "In the program's window: O: back."]),
    ("`Y` shows it: *one comparison*. `Esc` leads back.", ["In the program's window: Y shows it: one comparison. Esc leads back."]),
    ("With `two-sided=false`, *as always*.", ["With two-sided=false, as always."]),
)
# A key that is named: "N:", "(N)", "PageDown", "Esc leads". A sentence may begin with the word A or I, so these are left out.
NAMED = re.compile(r"(?<![\w$])(?:[B-HJ-Z]: |\([A-Z]\)|PageDown|PageUp|Esc\b|Space\b|Shift\+)")


def complaints():
    for cell, expected in CELLS:
        if deck_notes.paragraphs(cell) != expected:
            yield f"of {cell!r} it makes {deck_notes.paragraphs(cell)}"
    slides = in_window = 0
    for file in sorted((ROOT / "assets/decks").glob("*.json")):
        lines = file.read_text(encoding="utf-8").splitlines()
        for line, below in zip(lines, lines[1:]):
            name = deck_notes.NAME.match(line)
            if not name:
                continue
            slides += 1
            if not deck_notes.NOTES.match(below):
                yield f"{file.name}: slide {name.group(1)} has no notes"
                continue
            for note in re.findall(r'"((?:[^"\\]|\\.)*)"', below)[1:]:
                in_window += note.startswith(deck_notes.IN_WINDOW)
                if NAMED.search(note) and not note.startswith(deck_notes.IN_WINDOW):
                    yield f"{file.name}: slide {name.group(1)} names a key of the window: {note}"
    if slides < LEAST_SLIDES or in_window < LEAST_IN_WINDOW:
        yield f"only {slides} slides and {in_window} notes about the window were found"


def main():
    found = list(complaints())
    print("".join(line + "\n" for line in found), end="")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
