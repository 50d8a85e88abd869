#!/usr/bin/env python3
"""teaching_check.py PROGRAM: the scripts in docs/teaching.md can be held. Minutes follow each other and are 50 in all; slides are in
the deck, in its order, each shown once, with their numbers there; where a window goes through the deck, no slide is left out; each window is one that is started; keys are keys of the window. Words in code that
look like a slide, a lesson, a scene or a stage are one."""
# SPDX-License-Identifier: MIT
import json
import re
import subprocess
import sys
from pathlib import Path

from script import CODE, scripts_of

ROOT = Path(__file__).resolve().parent.parent.parent
MINUTES = 50
LEAST = {"slides": 15, "keys": 20}  # of each script: so that a table that is no longer read is noticed
NAME = re.compile(r"[a-z]+(?:-[a-z]+)+|[a-z]{5,}")


def names(program, what, key):
    told = subprocess.run([program, "list", what, "--json"], capture_output=True, text=True, check=True).stdout
    return {entry[key] for entry in json.loads(told)[what]}


def slides_of(deck):
    """Names in the order of the file. A deck may have comments, so it is not read as JSON."""
    return re.findall(r'\{"name": "([\w-]+)"', (ROOT / f"assets/decks/{deck}.json").read_text(encoding="utf-8"))


def complaints_about(script, slides, keys):
    minute, place = 0, -1
    for row in script.rows:
        where = f"{script.deck}, minutes {row.first_minute}-{row.last_minute}"
        if row.first_minute != minute or row.last_minute <= minute:
            yield f"{where}: does not begin where the row before ends, at {minute}"
        minute = row.last_minute
        for slide in row.slides:
            if slide not in slides:
                yield f"{where}: the deck has no slide {slide}"
            elif slides.index(slide) <= place:
                yield f"{where}: slide {slide} comes earlier in the deck"
            else:
                place = slides.index(slide)
        if row.numbers != [slides.index(slide) + 1 for slide in row.slides if slide in slides]:
            yield f"{where}: the numbers {row.numbers} are not those that the band shows"
        for letter, key in row.pressed:
            if letter not in script.windows:
                yield f"{where}: no window {letter} was started"
            if key not in keys:
                yield f"{where}: the window has no key {key}"
        for letter in filter(script.shows_deck, script.windows):
            # The window starts with the deck's first slide; every other one is gone to, so that no row needs what is left of another.
            reached = [slide for slide in row.slides if slide != slides[0]]
            turned = row.pressed.count((letter, "PageDown"))
            if turned != len(reached):
                yield f"{where}: PageDown stands {turned} times for window {letter}, and the row has {len(reached)} slides to go to"
    left_out = [slide for slide in slides if all(slide not in row.slides for row in script.rows)]
    if left_out and any(script.shows_deck(letter) for letter in script.windows):
        yield f"{script.deck}: PageDown comes to {', '.join(left_out)}, which no row has"
    if minute != MINUTES:
        yield f"{script.deck}: the script ends at minute {minute}, not {MINUTES}"


def main():
    program = sys.argv[1]
    text = (ROOT / "docs/teaching.md").read_text(encoding="utf-8")
    keys = {key for written in names(program, "keys", "keys") for key in written.split(", ")}
    scripts = scripts_of(text)
    complaints = [] if len(scripts) == 2 else [f"{len(scripts)} scripts were found, not 2"]
    known = names(program, "lessons", "name") | names(program, "scenes", "name") | names(program, "stages", "stage")
    known |= names(program, "decks", "name") | {"edgeErrorPx", "ffmpeg"}
    for script in scripts:
        slides = slides_of(script.deck)
        known |= set(slides)
        complaints += complaints_about(script, slides, keys)
        shown = sum(len(row.slides) for row in script.rows)
        if shown < LEAST["slides"] or sum(len(row.pressed) for row in script.rows) < LEAST["keys"]:
            complaints.append(f"{script.deck}: too few slides or keys were found")
    for word in CODE.findall(re.sub(r"```.*?```", "", text, flags=re.DOTALL)):
        if NAME.fullmatch(word) and word not in known and word not in keys:
            complaints.append(f"{word} is no slide, lesson, scene, stage or deck")
    print("".join(f"docs/teaching.md: {complaint}\n" for complaint in complaints), end="")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
