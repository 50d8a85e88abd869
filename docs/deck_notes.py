#!/usr/bin/env python3
"""The speaker's notes of the built-in decks, taken from the script of the lectures.

deck_notes.py writes them; deck_notes.py --check says which are not as docs/teaching.md has them, and exits with 1 if there are any.
A row of the script names its slides; what is to be done and said, and what is to be asked, becomes the `notes` of each of them. Notes are
read beside the slides of a browser as well, where the keys of the program's window do nothing: what is to be done with them says so. A slide
that no row names has its notes from the table `| slide | what to say |`.
"""
# SPDX-License-Identifier: MIT
import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NAME = re.compile(r'^    \{"name": "([\w-]+)"')
NOTES = re.compile(r'^     "notes": \[.*\],$')
KEY = re.compile(r"`(?:[A-Z0-9]|(?:Shift|Ctrl)\+[A-Z]|PageDown|PageUp|Space|Esc|Left|Right|Tab)`")
IN_WINDOW = "In the program's window: "
LEAST = 60  # slides with notes in both decks, so that a table that is no longer found is noticed


def plain(markdown):
    """Without the marks of Markdown."""
    text = re.sub(r"\[([^\]]+)\]\([^)]*\)", r"\1", markdown)
    return re.sub(r"[*`]", "", text).strip()


def paragraphs(say):
    """What is to be done and said, in the order of the cell. What is said stands in italics; a key and what follows it, up to the next
    italics, is done in the window, and is a paragraph of its own that says so."""
    told = []
    for part in re.split(r"(?<!\*)(\*[^*]+\*)(?!\*)", say):
        key = None if part.startswith("*") else KEY.search(part)
        begin = part.rfind(". ", 0, key.start()) + 1 if key else len(part)  # of the sentence that names the key
        for is_done, piece in ((False, part[:begin].strip()), (True, part[begin:].strip())):
            if not piece:
                continue
            goes_on = told and (told[-1][1].endswith(":") or piece[0] in ".,;:")  # the same sentence, said and done
            if told and (goes_on or told[-1][0] == is_done):
                told[-1][1] += ("" if piece[0] in ".,;:" else " ") + piece
            else:
                told.append([is_done, piece])
    return [(IN_WINDOW if is_done else "") + plain(text) for is_done, text in told]


def notes_of_slides(script):
    """From a slide's name to its paragraphs, of all rows `| minutes | slides | keys | what to do and to say | ask |`, and of the
    rows `| slide | what to say |`."""
    notes = {}
    for line in script.splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if len(cells) == 5 and re.match(r"\d+-\d+$", cells[0]):
            _, slides, _, say, ask = cells
        elif len(cells) == 2 and re.fullmatch(r"\d+ `[\w-]+`", cells[0]):
            (slides, say), ask = cells, ""
        else:
            continue
        asked = ["Ask: " + plain(ask)] if ask else []
        for slide in re.findall(r"`([\w-]+)`", slides):
            notes.setdefault(slide, []).extend(paragraphs(say) + asked)
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
