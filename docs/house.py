#!/usr/bin/env python3
"""The house as one picture: the rooms of the source, and which of them include which. Rooms and arrows are read from the #include
lines of the sources; only the places of the boxes and the words in them are written here.

    house.py            writes docs/images/house.svg; needs Graphviz (Debian: graphviz)
    house.py --check    ends with 1 if the rooms and arrows of that picture are not those of the sources; needs nothing

A room stands above all rooms that it includes. An arrow that follows from two others is left out: where a includes b and b includes c,
a may include c as well.
"""
# SPDX-License-Identifier: MIT
import argparse
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PICTURE = ROOT / "docs/images/house.svg"
INCLUDE = re.compile(r'^#include "((?:app|techniques)/[^"]+)"', re.MULTILINE)

# The idea of each room, in a few words.
IDEAS = {
    "cli": "a file for each command",
    "window": "what GLFW and ImGui draw",
    "hard": "the hard cases",
    "report": "speed against error",
    "course": "lessons, decks, slides",
    "student": "plug-ins and grading",
    "foreign": "other renderers' pictures",
    "lab": "what the window shows, as values",
    "film": "frames that follow each other",
    "picture": "from a scene to finished pixels",
    "judge": "truth, verdict, metrics",
    "figures": "the lectures' figures",
    "drawing": "paper: SVG, Cairo, formulas",
    "context": "window, EGL, OSMesa",
    "contract": "technique.h, frame.h, probe.h",
    "lecture": "the lectures' own algorithms",
    "base": "errors, colours, names",
    "math": "vectors and matrices",
    "image": "pictures and files",
    "params": "knobs, described once",
    "gl": "OpenGL objects",
    "scene": "scenes, meshes, lights",
    "trace": "rays",
}
FLOOR_COLOURS = {"app": "#dbe9f6", "techniques": "#fde3c8", "contract": "#f6f0b8", "foundation": "#dcecd8"}
# How Graphviz names what it has drawn: a box after its room, an arrow after both.
TITLE = re.compile(r"<title>([\w.]+)(?:&#45;&gt;([\w.]+))?</title>")


def room_of(file):
    """(floor, room) of a file: app/picture/steps/x.h is in ("app", "picture")."""
    parts = Path(file).parts
    if parts[0] == "app":
        return ("app", parts[1]) if len(parts) > 2 else None
    if len(parts) == 2 or parts[1] == "probed":
        return ("contract", "contract")
    if parts[1] == "foundation":
        return ("foundation", parts[2]) if len(parts) > 3 else None
    return ("techniques", parts[1])


def read_house():
    files, arrows = defaultdict(int), defaultdict(set)
    for folder in ("app", "techniques"):
        for path in sorted((ROOT / folder).rglob("*")):
            room = room_of(path.relative_to(ROOT).as_posix()) if path.suffix in (".h", ".cpp") else None
            if room is None:
                continue
            files[room] += 1
            for included in INCLUDE.findall(path.read_text(encoding="utf-8")):
                other = room_of(included)
                if other is not None and other != room:
                    arrows[room].add(other)
    return files, arrows


def reachable(arrows, start):
    found, waiting = set(), [start]
    while waiting:
        for room in arrows[waiting.pop()]:
            if room not in found:
                found.add(room)
                waiting.append(room)
    return found


def without_shortcuts(arrows):
    """Only those arrows that do not follow from others."""
    return {room: {other for other in others if not any(other in reachable(arrows, via) for via in others - {other})}
            for room, others in list(arrows.items())}


def as_dot(rooms, arrows):
    """The same in the language of Graphviz."""
    lines = ["digraph house {", 'graph [ranksep=0.45 nodesep=0.25]', 'node [shape=box style="filled,rounded" fontname="DejaVu Sans"]',
             'edge [color="#777777" arrowsize=0.7]']
    for floor, room in sorted(rooms):
        label = f"<<b>{room}</b><br/><font point-size='10'>{IDEAS.get(room, 'a technique')}</font>>"
        lines.append(f'{room} [label={label} fillcolor="{FLOOR_COLOURS[floor]}"]')
    lines += [f"{room} -> {other}" for room, other in sorted(arrows)]
    return "\n".join([*lines, "}", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    chosen = parser.parse_args()
    files, includes = read_house()
    shown = without_shortcuts(defaultdict(set, includes))
    arrows = {(room[1], other[1]) for room, others in shown.items() for other in others}
    if chosen.check:
        titles = TITLE.findall(PICTURE.read_text(encoding="utf-8")) if PICTURE.is_file() else []
        drawn = {title for title in titles if title[1]}
        boxes = {title[0] for title in titles if not title[1] and title[0] != "house"}
        if drawn != arrows or boxes != {room for _, room in files}:
            sys.exit("house: docs/images/house.svg does not show the rooms and arrows of the sources; run docs/house.py")
        print(f"{len(boxes)} rooms and {len(drawn)} arrows, as in the sources")
        return
    try:
        drawn = subprocess.run(["dot", "-Tsvg"], input=as_dot(files, arrows), capture_output=True, text=True, check=True)
    except FileNotFoundError:
        sys.exit("house: the program dot is missing; install graphviz")
    PICTURE.write_text(re.sub(r"<!--.*?-->\n?", "", drawn.stdout, flags=re.DOTALL), encoding="utf-8")


if __name__ == "__main__":
    main()
