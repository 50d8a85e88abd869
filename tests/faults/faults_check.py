#!/usr/bin/env python3
"""Bad files and bad days, one row each, through the installed program: its exit status, what it says in how many lines, and that
nothing else on the disk has changed.

faults_check.py BUILD [WORD]...   installs the program from that build folder into a folder of its own, runs every row (with WORDs:
those whose titles hold one), prints how many were tried and passed, and exits with 1 if one failed. The rows are in meshes.py, gltf.py,
scenes.py, references.py and outputs.py. SHADOWLAB_LONG=1 runs those that take long, too.
"""
# SPDX-License-Identifier: MIT
import dataclasses
import hashlib
import os
import re
import stat
import subprocess
import sys
import tempfile
from pathlib import Path

from gltf import GLTF
from meshes import MESHES
from outputs import OUTPUTS
from references import REFERENCES
from row import TIME_LIMIT
from scenes import SCENES

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))
from osmesa import WITHOUT, may_lack_osmesa  # noqa: E402

LEAST_ROWS = 265  # fewer, and rows have been lost
ERRORS_PAGE = Path(__file__).resolve().parents[2] / "docs" / "errors.md"


def listing(folder):
    """Of everything below a folder: kind, permissions and content. Sparse files are told by their size."""
    found = {}
    for path in sorted(folder.rglob("*")):
        info = path.lstat()
        name = os.fsencode(path.relative_to(folder))
        if stat.S_ISLNK(info.st_mode):
            found[name] = ("link", os.readlink(path))
        elif stat.S_ISREG(info.st_mode):
            digest = info.st_size if info.st_size > 1 << 26 else hashlib.sha256(path.read_bytes()).hexdigest()
            found[name] = ("file", info.st_mode, digest)
        else:
            found[name] = ("other", info.st_mode)
    return found


def complaint(row, result, before, after):
    """What is wrong with the outcome; empty: nothing."""
    out, err = result.stdout, result.stderr
    if result.returncode != row.status:
        return f"status {result.returncode}, not {row.status}"
    lines = err.decode(errors="replace").splitlines()
    if row.status and len(lines) != 1:
        return f"{len(lines)} lines on standard error, not one"
    if any(not line.startswith("shadowlab: ") for line in lines):
        return "a line that does not begin with the program's name"
    if row.status and "; " not in lines[0]:
        return "no remedy is named"
    if row.status == 0 and not row.says and lines:
        return "something is said where nothing is wrong"
    if any(c < 32 and c != 10 or c == 127 for c in err):
        return "a control character on standard error"
    if len(err) > 2100:  # the program cuts at 2000, without its name
        return f"a message of {len(err)} bytes"
    for part in row.says:
        if part not in err.decode(errors="replace"):
            return f"'{part}' is not said"
    if row.status and out and not row.prints:
        return "something on standard output"
    expected = {os.fsencode(name) for name in row.writes} if row.status == 0 else set()
    changed = {name for name in before | after if before.get(name) != after.get(name)}
    if changed != expected:
        return f"changed on disk: {sorted(changed)}, expected: {sorted(expected)}"
    return ""


def tried(row, program):
    """None: it passed; else what was wrong, with all that was said."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "work"
        folder.mkdir()
        row.prepare(folder)
        before = listing(folder)
        words = [str(program), *row.words]
        environment = {**os.environ, "HOME": name, **row.environment}
        environment.pop("DISPLAY", None)
        shown = " ".join(words)[:300]
        try:
            result = subprocess.run(words, cwd=folder, env=environment, capture_output=True, timeout=TIME_LIMIT, check=False,
                                    stdin=subprocess.DEVNULL)
        except subprocess.TimeoutExpired:
            return f"{row.title}: no end in {TIME_LIMIT} s\n  $ {shown}"
        wrong = complaint(row, result, before, listing(folder))
        return f"{row.title}: {wrong}\n  $ {shown}\n  {result.stderr.decode(errors='replace')[:600]}" if wrong else None


def main():
    build, wanted = Path(sys.argv[1]).resolve(), sys.argv[2:]
    families = {"mesh": MESHES, "glTF": GLTF, "scene": SCENES, "reference": REFERENCES, "output": OUTPUTS}
    rows = [dataclasses.replace(row, title=f"{family}: {row.title}") for family, table in families.items() for row in table]
    if len({row.title for row in rows}) != len(rows):
        sys.exit("two rows have the same title")
    told = {int(status) for cell in re.findall(r"^\| ([\d, ]+) \|", ERRORS_PAGE.read_text(), re.MULTILINE) for status in cell.split(",")}
    if untold := {row.status for row in rows} - told:
        sys.exit(f"statuses that docs/errors.md does not tell: {sorted(untold)}")
    if not os.environ.get("SHADOWLAB_LONG"):
        rows = [row for row in rows if not row.is_long]
    if not wanted and len(rows) < LEAST_ROWS:
        sys.exit(f"only {len(rows)} rows")
    rows = [row for row in rows if not wanted or any(word in row.title for word in wanted)]
    if may_lack_osmesa(build / "shadowlab"):
        print(WITHOUT)
        rows = [row for row in rows if "osmesa" not in row.words]
    with tempfile.TemporaryDirectory() as prefix:
        subprocess.run(["cmake", "--install", build, "--prefix", prefix], check=True, stdout=subprocess.DEVNULL)
        failures = [failure for failure in (tried(row, Path(prefix) / "bin" / "shadowlab") for row in rows) if failure]
    print(*failures, sep="\n")
    print(f"{len(rows)} cases tried, {len(rows) - len(failures)} passed")
    sys.exit(1 if failures or not rows else 0)


if __name__ == "__main__":
    main()
