#!/usr/bin/env python3
"""Shows that teaching_check.py bites: each fault of a made-up script must be told of, and a right one must pass."""
# SPDX-License-Identifier: MIT
import sys

from script import scripts_of
from teaching_check import complaints_about

SLIDES, KEYS = ["one", "two", "three"], {"J", "PageDown"}
SECTION = """## A lecture

    build/release/shadowlab demo --lesson acne --presenter   # A

<!-- script: made-up -->

| minutes | slides | keys | what to do |
|---|---|---|---|
{rows}

After it.
"""
RIGHT = "| 0-20 | 1 `one` | A: `J` `PageDown` | say |\n| 20-50 | 2 `two`, 3 `three` | | say |"

# (what must be said, what is written in place of what)
WRONG = [
    ("has no slide four", "`two`", "`four`"),
    ("slide two comes earlier", "2 `two`, 3 `three`", "3 `three`, 2 `two`"),
    ("slide one comes earlier", "`two`", "`one`"),
    ("the numbers [2, 2]", "3 `three`", "2 `three`"),
    ("the numbers [2]", ", 3 `", ", `"),
    ("does not begin where", "| 20-50", "| 21-50"),
    ("does not begin where", "| 20-50", "| 20-20"),
    ("ends at minute 49", "20-50", "20-49"),
    ("no key F13", "`J`", "`F13`"),
    ("no window B", "A: `J`", "B: `J`"),
]

# The same of a window that goes through the deck: PageDown leads to every slide but the first.
DECK_SECTION = SECTION.replace("--lesson acne", "--deck made-up")
DECK_RIGHT = "| 0-20 | 1 `one` | A: `J` | say |\n| 20-50 | 2 `two`, 3 `three` | A: `PageDown` `J` `PageDown` | say |"
DECK_WRONG = [
    ("PageDown stands 1 times", "`PageDown` `J` `PageDown`", "`J` `PageDown`"),
    ("PageDown stands 1 times", "A: `J`", "A: `PageDown`"),
    ("PageDown comes to three", "2 `two`, 3 `three` | A: `PageDown` `J`", "2 `two` | A: `J`"),
]


def said_of(rows, section=SECTION):
    (script,) = scripts_of(section.format(rows=rows))
    pressed = sum(len(row.pressed) for row in script.rows)
    return list(complaints_about(script, SLIDES, KEYS)), script.windows, pressed


def main():
    failures = []
    cases = [(RIGHT, SECTION, *wrong) for wrong in WRONG] + [(DECK_RIGHT, DECK_SECTION, *wrong) for wrong in DECK_WRONG]
    for right, section, said, old, new in cases:
        complaints, _, _ = said_of(right.replace(old, new, 1), section)
        if not any(said in complaint for complaint in complaints):
            failures.append(f"with {new} for {old} it says {complaints}, not '{said}'")
    if said_of(RIGHT) != ([], {"A": ["--lesson", "acne", "--presenter"]}, 2):
        failures.append(f"of the right script it says {said_of(RIGHT)}")
    if said_of(DECK_RIGHT, DECK_SECTION)[0]:
        failures.append(f"of the right script of a deck it says {said_of(DECK_RIGHT, DECK_SECTION)[0]}")
    print("".join(line + "\n" for line in failures), end="")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
