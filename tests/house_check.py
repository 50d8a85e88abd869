#!/usr/bin/env python3
"""House rules that a program can check: a licence line in every source file, files short enough to read, nothing left undone,
no path of one machine, no output but by the one writer, and nothing at the top level that does not belong there. house_check.py [ROOT] prints FILE:LINE: WHAT
and exits with 1 if a rule is broken."""
# SPDX-License-Identifier: MIT
import re
import subprocess
import sys
from pathlib import Path

FOLDERS = ("app", "techniques", "shaders", "tests", "docs", ".ci")
TOP = ("CMakeLists.txt", "CMakePresets.json", "demo", "check", "README.md")
# All that git may track at the top level.
TOP_LEVEL = {*TOP, *FOLDERS, "assets", "LICENSE", ".clang-format", ".clang-tidy", ".gitignore"}
SOURCES = {".cpp", ".h", ".py", ".sh"}
TEXTS = SOURCES | {".glsl", ".vert", ".frag", ".txt", ".cmake", ".in", ".json", ".md", ".supp", ""}
LONGEST = 400
MARKS = "|".join(("TO" + "DO", "FIX" + "ME", "X" + "XX"))  # in halves, so that this file does not name them itself

SPDX = "SPDX-License-Identifier:"
SPDX_ALONE = re.compile(rf"\s*(?://|#|/\*)\s*{SPDX} [\w.+-]+(?:\s*\*/)?\s*")
UNDONE = re.compile(rf"\b(?:{MARKS})\b")
ONE_MACHINE = re.compile(r"(?<![\w./{}$>~-])/(?:home|root|Users|work|mnt|media|workspace|builds?)/[\w.-]")

# Nothing but these opens files to write, or moves them.
WRITERS = "techniques/foundation/image/output_f"
WRITES = re.compile(r"\b(?:ofstream|fopen|freopen|fwrite|O_CREAT)\b|::(?:rename|copy_file|create_director\w+)\(")


def violations_of(file, text):
    lines = text.splitlines()
    path = Path(file)
    spdx = next((number for number, line in enumerate(lines[:30], 1) if SPDX in line), None)
    if spdx is None and (path.suffix in SOURCES or file in ("demo", "check", ".ci/run")):
        yield 1, "has no SPDX line"
    if spdx is not None and path.suffix != ".md" and not SPDX_ALONE.fullmatch(lines[spdx - 1]):
        yield spdx, "says more than the licence in its SPDX line; give the rest a line of its own"
    if path.suffix != ".md" and path.parts[0] in ("app", "techniques", "shaders", "tests") and len(lines) > LONGEST:
        yield len(lines), f"has {len(lines)} lines; {LONGEST} is the most, split it where a second idea begins"
    for number, line in enumerate(lines, 1):
        if UNDONE.search(line):
            yield number, "is not finished: do it, or say in the issue tracker that it is missing"
        if path.parts[0] in ("app", "techniques") and not file.startswith(WRITERS) and WRITES.search(line):
            yield number, "writes by itself; outputs go through output_file.h and output_folder.h, so that they are whole or not there"
        if ONE_MACHINE.search(line):
            yield number, "names a path of one machine"


def files_of(root):
    for folder in FOLDERS:
        yield from sorted(path for path in (root / folder).rglob("*") if path.is_file() and "__pycache__" not in path.parts)
    yield from (root / name for name in TOP if (root / name).is_file())


def strangers(root):
    """What git tracks at the top level and nobody expects there. Nothing where git is not in use."""
    if not (root / ".git").exists():
        return []
    command = ["git", "-c", "safe.directory=*", "-C", str(root), "ls-files", "-z"]
    try:
        tracked = subprocess.run(command, capture_output=True, text=True, errors="replace", check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return []
    return sorted({path.split("/")[0] for path in tracked.split("\0") if path} - TOP_LEVEL)


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    if not (root / "techniques").is_dir():
        sys.exit(f"house_check: {root} is no checkout, it has no techniques/; give the folder that holds it")
    found = False
    for name in strangers(root):
        print(f"{name}:1: does not belong at the top level; move it, or take it out of git with `git rm --cached`")
        found = True
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
