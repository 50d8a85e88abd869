#!/usr/bin/env python3
"""What the program shows on a terminal and what it writes into a pipe. terminal_check.py PROGRAM runs it on pseudo-terminals of some
widths: lists are aligned and no line of them or of another table is wider than the terminal; `measure` says on standard error how far it is, and wipes that line. In
a pipe lists are lines with tabs, and standard error stays empty."""
# SPDX-License-Identifier: MIT
import fcntl
import os
import pty
import re
import struct
import subprocess
import sys
import termios

MEASURE = ["measure", "sphere-on-plane", "-t", "shadow-map,shadow-volume", "--size", "96x54"]

TABLES = (
    [*MEASURE, "--frames", "2"],
    ["measure", "three-lights", "-t", "shadow-map,shadow-volume-zfail,ray-traced", "--size", "96x54"],
    ["inspect", "still-life"],
    ["probe", "still-life", "-t", "shadow-map", "--pixel", "100,60", "--size", "192x108"],
    ["lesson", "acne", "--measure"],
)


def on_terminal(program, words, columns, which):
    """What appears where standard output (which=1) or standard error (2) is a terminal; the other one is a pipe."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 40, columns, 0, 0))
    streams = {"stdout": theirs, "stderr": subprocess.PIPE} if which == 1 else {"stdout": subprocess.PIPE, "stderr": theirs}
    text = b""
    with subprocess.Popen([program, *words], stdin=subprocess.DEVNULL, **streams) as child:
        os.close(theirs)
        try:
            while part := os.read(ours, 65536):
                text += part
        except OSError:  # how a terminal says that its other end was closed
            pass
        child.communicate()
    os.close(ours)
    return child.returncode, text.decode().replace("\r\n", "\n")


def cells(text):
    """What a table says, in whatever lines."""
    return sorted(text.split())


def too_wide(program):
    """Tables that are wider than 80 columns in a pipe: on a terminal of 80 they say the same, and none of their lines is longer."""
    compared = 0
    for words in TABLES:
        piped = subprocess.run([program, *words], capture_output=True, text=True, check=True).stdout
        status, text = on_terminal(program, words, 80, 1)
        wide = [line for line in text.splitlines() if len(line) > 80]
        if status != 0 or wide:
            yield f"{' '.join(words)} on 80 columns: status {status}, too wide: {wide[:1]}"
        # Times differ from run to run, so numbers with a point are left out; heads and names of rows are said again where a table goes on.
        missing = [cell for cell in cells(piped) if not re.search(r"\d\.\d", cell) and cell not in text]
        if missing:
            yield f"{' '.join(words)} on 80 columns: {missing[:3]} is not there"
        compared += any(len(line) > 80 for line in piped.splitlines())
        status, text = on_terminal(program, words, 400, 1)
        if status != 0 or [len(cells(line)) for line in text.splitlines()] != [len(cells(line)) for line in piped.splitlines()]:
            yield f"{' '.join(words)} on 400 columns is not as in a pipe"
    if compared < 3:
        yield f"only {compared} of the tables are wider than 80 columns in a pipe"


def complaints(program):
    def piped(*words):
        return subprocess.run([program, *words], capture_output=True, text=True, check=True)

    for what in ("techniques", "parameters", "scenes", "lessons", "keys", "limits", "decks", "figures"):
        rows = [line.split("\t") for line in piped("list", what).stdout.splitlines()]
        if len({len(row) for row in rows}) != 1:
            yield f"list {what}: rows of different lengths in a pipe"
        for columns in (80, 120, 200):
            status, text = on_terminal(program, ["list", what], columns, 1)
            wide = [line for line in text.splitlines() if len(line) > columns and " " in line.strip()]
            if status != 0 or "\t" in text or wide:
                yield f"list {what} on {columns} columns: status {status}, tabs {text.count(chr(9))}, too wide: {wide[:1]}"
            missing = [row[0] for row in rows if row[0] not in text]
            if missing:
                yield f"list {what} on {columns} columns: {missing[0]} is not there"
    yield from too_wide(program)
    _, text = on_terminal(program, ["list"], 80, 1)
    lines = text.splitlines()
    if not lines or not lines[0].startswith("list  ") or len({line.index(re.split(r" {2,}", line)[2]) for line in lines[1:10]}) != 1:
        yield f"list: its columns are not aligned:\n{text}"

    status, progress = on_terminal(program, MEASURE, 80, 2)
    steps = re.findall(r"measuring: step (\d+) of (\d+)", progress)
    if status != 0 or len(steps) < 4 or steps[-1][0] != steps[-1][1] or len({total for _, total in steps}) != 1:
        yield f"measure: status {status}, told these steps: {steps}"
    if not progress.endswith("\r\033[K"):
        yield f"measure: the line of its progress is left behind: {progress[-40:]!r}"
    if piped(*MEASURE).stderr:
        yield "measure: something on standard error that is no terminal"


def main():
    found = list(complaints(os.path.abspath(sys.argv[1])))
    print("".join(line + "\n" for line in found), end="")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
