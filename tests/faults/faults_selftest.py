#!/usr/bin/env python3
"""Would faults_check.py see a program that does wrong? Small programs that each do one thing wrong, and one that does all right."""
# SPDX-License-Identifier: MIT
import stat
import sys
import tempfile
from pathlib import Path

from faults_check import tried
from row import Row

REFUSED = Row("refused", {"m.obj": "v"}, ["m.obj"], 3, ["m.obj:1:"])
DRAWN = Row("drawn", {"s.json": "{}", "old.txt": "old"}, ["s.json"], 0, [], ["x.png"])
GOOD = 'echo "shadowlab: m.obj:1: is broken; fix it" >&2; exit 3'

PROGRAMS = [  # a row, what a shell does in the place of the program, and what is said of it (nothing: it is right)
    (REFUSED, GOOD, ""),
    (DRAWN, "echo picture > x.png", ""),
    (REFUSED, GOOD.replace("exit 3", "exit 4"), "status 4"),
    (REFUSED, "exit 3", "0 lines"),
    (REFUSED, 'echo "shadowlab: more" >&2; ' + GOOD, "2 lines"),
    (REFUSED, GOOD.replace("shadowlab: ", ""), "program's name"),
    (REFUSED, GOOD.replace("; fix it", ""), "no remedy"),
    (REFUSED, GOOD.replace("m.obj:1", "m.obj"), "is not said"),
    (REFUSED, GOOD.replace("broken", r"$(printf 'bro\033[31mken')"), "control character"),
    (REFUSED, "echo started; " + GOOD, "standard output"),
    (REFUSED, "touch x.png.tmp.1; " + GOOD, "changed on disk"),
    (REFUSED, "echo vv > m.obj; " + GOOD, "changed on disk"),
    (REFUSED, "chmod 600 m.obj; " + GOOD, "changed on disk"),
    (REFUSED, "rm m.obj; " + GOOD, "changed on disk"),
    (REFUSED, "kill -SEGV $$", "status -11"),
    (DRAWN, "true", "changed on disk"),
    (DRAWN, "echo picture > x.png; rm old.txt", "changed on disk"),
    (DRAWN, 'echo picture > x.png; echo "shadowlab: note: well" >&2', "something is said"),
]


def main():
    wrong = 0
    with tempfile.TemporaryDirectory() as name:
        program = Path(name) / "program"
        for row, does, said in PROGRAMS:
            program.write_text(f"#!/bin/sh\n{does}\n")
            program.chmod(program.stat().st_mode | stat.S_IXUSR)
            found = tried(row, program) or ""
            if (said not in found) if said else found:
                wrong += 1
                print(f"{does}\n  expected: {said or 'nothing'}\n  said: {found or 'nothing'}")
    print(f"{len(PROGRAMS)} programs tried, {wrong} misjudged")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
