#!/usr/bin/env python3
"""Sources are compiled together, a handful of a folder at a time (techniques/joined_sources.cmake). Two things have to hold beside:

  - each file compiles by itself, so that it includes what it uses, and a build without joining works;
  - all files of a folder compile together, whichever of them are: no name in an anonymous namespace is there twice.

    sources_check.py [alone|together]        without a word: both

Nothing is generated, only read (-fsyntax-only): some four minutes for `alone` and two for `together` on two cores."""
# SPDX-License-Identifier: MIT
import json
import os
import shlex
import subprocess
import sys
import tempfile
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LEAST_FILES = 400  # of app/ and techniques/: fewer mean that the list is not read as it is meant
TARGETS = ("plugin_contract.h", "gl.h")  # generated headers


def configured(folder):
    """The compiler's words for each source file of the program, without its output."""
    subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DSHADOWLAB_JOINED=OFF",
                    "-DSHADOWLAB_TESTS=OFF", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"], check=True, stdout=subprocess.DEVNULL)
    listed = subprocess.run(["ninja", "-C", folder, "-t", "targets", "all"], check=True, capture_output=True, text=True).stdout
    generated = [line.split(":")[0] for line in listed.splitlines() if line.split(":")[0].endswith(TARGETS)]
    subprocess.run(["ninja", "-C", folder, *generated], check=True, stdout=subprocess.DEVNULL)
    words = {}
    for entry in json.loads((Path(folder) / "compile_commands.json").read_text()):
        file = Path(entry["file"])
        if file.suffix != ".cpp" or not file.is_relative_to(ROOT) or file.is_relative_to(folder):
            continue
        command = shlex.split(entry["command"])
        at = command.index("-o")
        command = [word for word in command[:at] + command[at + 2:] if word not in ("-c", entry["file"])]
        words[file] = [*command, "-fsyntax-only", "-Wall", "-Wextra", "-Wpedantic"]
    return words


def complaints(task):
    what, command, text = task
    ran = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
    return f"{what}:\n{ran.stderr[:3000]}" if ran.returncode != 0 or ran.stderr else ""


def alone(words):
    return [(file.relative_to(ROOT), [*command, str(file)], None) for file, command in words.items()]


def together(words):
    folders = defaultdict(list)
    for file in words:
        folders[file.parent].append(file)
    for folder, files in sorted(folders.items()):
        # Kernels are compiled for one processor each, and so not with others.
        joined = [file for file in sorted(files) if not any(word.startswith("-mavx") for word in words[file])]
        text = "".join(f'#include "{file}"\n' for file in joined)
        # A definition that one file alone has serves the others.
        definitions = {word for file in joined for word in words[file] if word.startswith("-D")}
        yield folder.relative_to(ROOT), [*words[joined[0]], *sorted(definitions), "-x", "c++", "-"], text


def main():
    if {"-h", "--help"} & set(sys.argv):
        print(__doc__)
        return
    asked = sys.argv[1:] or ["alone", "together"]
    if not set(asked) <= {"alone", "together"}:
        sys.exit(f"sources_check: '{' '.join(asked)}' is not understood; use alone, together, or nothing for both")
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        words = configured(folder)
        if len(words) < LEAST_FILES:
            sys.exit(f"sources_check: only {len(words)} files were found")
        tasks = [task for how in asked for task in (alone if how == "alone" else together)(words)]
        found = [text for text in pool.map(complaints, tasks) if text]
    print("".join(found), end="")
    print(f"{len(tasks)} compiled, {len(found)} with complaints")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
