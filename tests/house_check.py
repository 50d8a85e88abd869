#!/usr/bin/env python3
"""House rules that a program can check: a licence line in every source file, files short enough to read, nothing left undone,
no path of one machine. house_check.py [ROOT] prints FILE:LINE: WHAT and exits with 1 if a rule is broken."""
# SPDX-License-Identifier: MIT
import re
import sys
from pathlib import Path

FOLDERS = ("app", "techniques", "shaders", "tests", "docs", ".ci")
TOP = ("CMakeLists.txt", "CMakePresets.json", "demo", "check", "README.md")
SOURCES = {".cpp", ".h", ".py", ".sh"}
TEXTS = SOURCES | {".glsl", ".vert", ".frag", ".txt", ".cmake", ".in", ".json", ".md", ".supp", ""}
LONGEST = 400
MARKS = "|".join(("TO" + "DO", "FIX" + "ME", "X" + "XX"))  # in halves, so that this file does not name them itself

UNDONE = re.compile(rf"\b(?:{MARKS})\b")
ONE_MACHINE = re.compile(r"(?<![\w./{}$>~-])/(?:home|root|Users|work|mnt|media|workspace|builds?)/[\w.-]")


def violations_of(file, text):
    lines = text.splitlines()
    path = Path(file)
    if path.suffix in SOURCES or file in ("demo", "check", ".ci/run"):
        if not any("SPDX-License-Identifier:" in line for line in lines[:30]):
            yield 1, "has no SPDX line"
    if path.suffix != ".md" and path.parts[0] in ("app", "techniques", "shaders", "tests") and len(lines) > LONGEST:
        yield len(lines), f"has {len(lines)} lines; {LONGEST} is the most, split it where a second idea begins"
    for number, line in enumerate(lines, 1):
        if UNDONE.search(line):
            yield number, "is not finished: do it, or say in the issue tracker that it is missing"
        if ONE_MACHINE.search(line):
            yield number, "names a path of one machine"


def files_of(root):
    for folder in FOLDERS:
        yield from sorted(path for path in (root / folder).rglob("*") if path.is_file() and "__pycache__" not in path.parts)
    yield from (root / name for name in TOP if (root / name).is_file())


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    if not (root / "techniques").is_dir():
        sys.exit(f"house_check: {root} is no checkout, it has no techniques/; give the folder that holds it")
    found = False
    for path in files_of(root):
        if path.suffix not in TEXTS:
            continue
        file = path.relative_to(root).as_posix()
        for line, what in violations_of(file, path.read_text(encoding="utf-8", errors="replace")):
            print(f"{file}:{line}: {what}")
            found = True
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
