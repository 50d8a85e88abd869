#!/usr/bin/env python3
"""The speaker's notes of the built-in decks, taken from the script of the lectures.

deck_notes.py writes them; deck_notes.py --check says which are not as docs/teaching.md has them, and exits with 1 if there are any.
A row of the script names its slides; what is to be done and said, and what is to be asked, becomes the `notes` of each of them.
"""
# SPDX-License-Identifier: MIT
import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NAME = re.compile(r'^    \{"name": "([\w-]+)"')
NOTES = re.compile(r'^     "notes": \[.*\],$')
LEAST = 40  # notes in both decks, so that a table that is no longer found is noticed


def plain(markdown):
    """Without the marks of Markdown."""
    text = re.sub(r"\[([^\]]+)\]\([^)]*\)", r"\1", markdown)
    return re.sub(r"[*`]", "", text).strip()


def notes_of_slides(script):
    """From a slide's name to its paragraphs, of all rows `| minutes | slides | keys | what to do and to say | ask |`."""
    notes = {}
    for line in script.splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if len(cells) != 5 or not re.match(r"\d+-\d+$", cells[0]):
            continue
        _, slides, _, say, ask = cells
        said = [plain(say)] if say else []
        asked = ["Ask: " + plain(ask)] if ask else []
        for slide in re.findall(r"`([\w-]+)`", slides):
            notes.setdefault(slide, []).extend(said + asked)
    return notes


def with_notes(deck, notes):
    """The text of a deck with these notes behind the line of each slide's name, and how many slides have some."""
    lines, count = [], 0
    for line in deck.splitlines(keepends=True):
        if NOTES.match(line.rstrip("\n")):
            continue
        lines.append(line)
        found = NAME.match(line)
        if found and notes.get(found.group(1)):
            lines.append(f'     "notes": {json.dumps(notes[found.group(1)], ensure_ascii=False)},\n')
            count += 1
    return "".join(lines), count


def main():
    checks = sys.argv[1:] == ["--check"]
    notes = notes_of_slides((ROOT / "docs/teaching.md").read_text(encoding="utf-8"))
    total, stale = 0, []
    for file in sorted((ROOT / "assets/decks").glob("*.json")):
        before = file.read_text(encoding="utf-8")
        after, count = with_notes(before, notes)
        total += count
        if before == after:
            continue
        stale.append(str(file.relative_to(ROOT)))
        if not checks:
            file.write_text(after, encoding="utf-8")
    if checks and stale:
        print("".join(f"{file}: notes are not those of docs/teaching.md; run docs/deck_notes.py\n" for file in stale), end="")
    if total < LEAST:
        print(f"only {total} slides have notes, at least {LEAST} were expected")
    sys.exit(1 if (checks and stale) or total < LEAST else 0)


if __name__ == "__main__":
    main()
