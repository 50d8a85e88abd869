#!/usr/bin/env python3
"""What the program shows and says, as one digest for each picture and each answer: recorded before the source is rearranged, compared
afterwards. Not a byte may differ but for what is measured by a clock.

    digests.py record PROGRAM FILE            writes FILE: a line for each, digest and name
    digests.py compare PROGRAM FILE           makes all of them again, prints the names of those that differ, and ends with 1 if any do
    options: --only TEXT   those whose name has TEXT in it
             --keep FOLDER pictures and answers stay there, to be looked at

Asked for are every built-in scene with every technique, its stages (four to a picture) and its steps (a film); every lesson, drawn and
measured; every slide; every figure; probes, `inspect`, `measure` and every list as JSON; the window's widgets. Pictures are small. Two
recordings of one program are alike, and only those on one machine can be compared: drivers round in their own ways. Some ten minutes on
two cores."""
# SPDX-License-Identifier: MIT
import argparse
import hashlib
import json
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

SIZE, GRID, TOLD = "96x54", "192x108", "480x270"  # of one picture, of four in a grid, of one with words in it
SLIDE = "640x360"  # the least that has room for the words of all slides
PIXELS = ("48,40", "60,30")
FIGURED = ("still-life", "mirror-and-glass", "cornell-room")  # scenes whose figures are drawn
SLOTS = 4  # pictures that one command draws
CLOCKED = ("ms", "Ms", "seconds", "Seconds", "times", "rate", "perSecond")  # how keys end under which a clock's figures stand
LISTS = ("techniques", "parameters", "stages", "source", "scenes", "figures", "decks", "lessons", "quantities", "keys", "limits")


class Program:
    def __init__(self, path):
        self.path = str(Path(path).resolve())

    def run(self, *words):
        return subprocess.run([self.path, *words], capture_output=True, text=True, check=False)

    def pairs(self, what):
        """The first two columns of a list, as of a technique and what it has; none of them twice."""
        ran = self.run("list", what)
        if ran.returncode != 0:
            sys.exit(f"digests: list {what} failed: {ran.stderr}")
        return list(dict.fromkeys(tuple(line.split("\t")[:2]) for line in ran.stdout.splitlines()))

    def listed(self, what):
        return list(dict.fromkeys(row[0] for row in self.pairs(what)))

    def techniques(self):
        """The production techniques. Those of the lecture, by the sixth column, may be rewritten freely: tests/lecture holds them to their page."""
        rows = [line.split("\t") for line in self.run("list", "techniques").stdout.splitlines()]
        return [row[0] for row in rows if len(row) < 6 or row[5] == "production"]


def pictures(program):
    """Name, and the words that draw it; OUT stands for the file."""
    techniques = program.techniques()
    shown = {one: [""] for one in techniques}
    for technique, stage in program.pairs("stages"):
        if technique in shown and not stage.startswith("pass:"):  # all steps come as one film
            shown[technique].append(stage)
    for scene in program.listed("scenes"):
        for technique, stages in shown.items():
            for first in range(0, len(stages), SLOTS):
                group = stages[first:first + SLOTS]
                chosen = [word for slot, stage in enumerate(group, 1) if stage for word in ("--stage", f"{slot}:{stage}")]
                yield f"stages/{scene}/{technique}/{','.join(stage or 'picture' for stage in group)}.png", [
                    "capture", scene, "-t", ",".join([technique] * len(group)), *chosen, "--layout", "grid", "--size", GRID, "--labels",
                    "false", "-o", "OUT"]
            yield f"steps/{scene}/{technique}.png", ["capture", scene, "-t", technique, "--steps", "--size", GRID, "-o", "OUT"]
        yield f"layouts/{scene}/diff.png", ["capture", scene, "-t", "shadow-map,shadow-volume", "--layout", "diff", "--size", GRID,
                                            "-o", "OUT"]
    for technique in techniques:
        yield f"window/{technique}.png", ["capture", "still-life", "-t", technique, "--ui", "--size", "960x540", "-o", "OUT"]
    for technique, step in (pair for pair in program.pairs("source") if pair[0] in shown):
        yield f"source/{technique}/{step}.png", ["capture", "still-life", "-t", technique, "--ui", "--stage", f"pass:{step}", "--source",
                                                 "true", "--size", "960x540", "-o", "OUT"]
    for lesson in program.listed("lessons"):
        yield f"lessons/{lesson}.png", ["lesson", lesson, "--size", TOLD, "-o", "OUT"]
    for figure in program.listed("figures"):
        for technique in techniques:
            for scene in FIGURED:
                yield f"figures/{figure}/{technique}/{scene}.svg", ["probe", scene, "--pixel", PIXELS[0], "--size", SIZE, "-t", technique,
                                                                    "--figure", figure, "--diagram", "OUT"]


def answers(program):
    techniques, scenes = program.techniques(), program.listed("scenes")
    for what in LISTS:
        yield f"list/{what}.json", ["list", what, "--json"]
    for scene in scenes:
        yield f"measure/{scene}.json", ["measure", scene, "-t", "all", "--size", SIZE, "--json"]
        yield f"inspect/{scene}.json", ["inspect", scene, "--json"]
        for technique in techniques:
            for pixel in PIXELS:
                yield f"probe/{scene}/{technique}/{pixel}.json", ["probe", scene, "-t", technique, "--pixel", pixel, "--size", SIZE,
                                                                  "--json"]
    for lesson in program.listed("lessons"):
        yield f"lessons/{lesson}.json", ["lesson", lesson, "--measure", "--json"]


def without_clocks(value):
    if isinstance(value, dict):
        return {key: without_clocks(one) for key, one in value.items() if not key.endswith(CLOCKED)}
    return [without_clocks(one) for one in value] if isinstance(value, list) else value


def digest_of(content):
    return hashlib.sha256(content).hexdigest()[:16]


def said(ran):
    """An answer that was refused counts too: its status and the line that says why."""
    try:
        return json.dumps([ran.returncode, without_clocks(json.loads(ran.stdout))], indent=1).encode()
    except ValueError:
        return f"{ran.returncode} {ran.stderr}{ran.stdout}".encode()


def all_digests(program, chosen, folder):
    def drawn(name, words):
        out = folder / name
        out.parent.mkdir(parents=True, exist_ok=True)
        ran = program.run(*[str(out) if word == "OUT" else word for word in words])
        return [(name, digest_of(out.read_bytes() if out.is_file() else said(ran).replace(str(folder).encode(), b"")))]

    def answered(name, words):
        out = folder / name
        out.parent.mkdir(parents=True, exist_ok=True)
        out.write_bytes(said(program.run(*words)))
        return [(name, digest_of(out.read_bytes()))]

    def slides(deck):
        out = folder / "slides" / deck
        ran = program.run("slides", deck, "--size", SLIDE, "--supersample", "1", "-o", str(out))
        if ran.returncode:
            sys.exit(f"digests: slides {deck} failed: {ran.stderr}")
        files = [file for file in sorted(out.rglob("*")) if file.is_file()]
        return [(f"slides/{deck}/{file.relative_to(out)}", digest_of(file.read_bytes())) for file in files]

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        waiting = [pool.submit(drawn, *one) for one in pictures(program) if chosen in one[0]]
        waiting += [pool.submit(answered, *one) for one in answers(program) if chosen in one[0]]
        waiting += [pool.submit(slides, deck) for deck in program.listed("decks") if chosen in f"slides/{deck}"]
        return dict(sorted(pair for one in waiting for pair in one.result()))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("do", choices=("record", "compare"))
    parser.add_argument("program", type=Path)
    parser.add_argument("file", type=Path)
    parser.add_argument("--only", default="", metavar="TEXT")
    parser.add_argument("--keep", type=Path, metavar="FOLDER")
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory() as made:
        found = all_digests(Program(chosen.program), chosen.only, chosen.keep or Path(made))
    if chosen.do == "record":
        chosen.file.write_text("".join(f"{digest}  {name}\n" for name, digest in found.items()))
        print(f"{len(found)} digests, written to {chosen.file}")
        return 0
    known = dict(reversed(line.split("  ", 1)) for line in chosen.file.read_text().splitlines())
    known = {name: digest for name, digest in known.items() if chosen.only in name}
    differ = [name for name in known if found.get(name) != known[name]]
    new = [name for name in found if name not in known]
    for name in differ:
        print(f"{'differs' if name in found else 'is gone'}: {name}")
    for name in new:
        print(f"is new: {name}")
    print(f"{len(known)} digests compared, {len(differ)} differ, {len(new)} new")
    return 1 if differ or not known else 0


if __name__ == "__main__":
    sys.exit(main())
