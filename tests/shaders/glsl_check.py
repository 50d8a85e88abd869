#!/usr/bin/env python3
"""Holds every GLSL program that the tests linked against Khronos' own compiler, as strict GLSL 3.30 core: both stages of a program
together, so that what one hands to the other is looked at, too. glsl_check.py FOLDER [SHADERS]

FOLDER has NAME.vert and NAME.frag of each program (tests/support/kept_programs.h). Fails as well where a file of the shaders folder
is in none of them: then no test draws with it, and no compiler has seen it."""
# SPDX-License-Identifier: MIT
import os
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
LINES_PER_FILE = 100_000  # ShaderSource::kLinesPerFile
FEWEST = 300  # programs; the tests of the shadow map's filters and biases alone link more


def validator():
    """Debian's glslang-tools; newer ones may have the second name alone."""
    for name in ("glslangValidator", "glslang"):
        if shutil.which(name):
            return name
    sys.exit("glsl_check: there is no glslangValidator; apt install glslang-tools")


def complaints_about(vertex, fragment, compiler):
    """What the compiler says about the two stages and about both together; nothing where all is well."""
    ran = subprocess.run([compiler, "-l", str(vertex), str(fragment)], capture_output=True, text=True, errors="replace", check=False)
    # What is indented goes on with the complaint before it.
    lines = re.findall(r"^(?:ERROR|WARNING).*(?:\n +.*)*", ran.stdout, re.MULTILINE)
    version = [f"ERROR: {path.name} does not begin with #version 330 core" for path in (vertex, fragment)
               if not path.read_text().startswith("#version 330 core\n")]
    if ran.returncode and not lines:
        lines = [f"ERROR: exit status {ran.returncode}: {ran.stdout or ran.stderr}"]
    missing = [f"ERROR: the vertex stage has no output {name}, which the fragment stage reads"
               for name in sorted(without_output(vertex.read_text(), fragment.read_text()) and
                                  without_output(preprocessed(vertex, compiler), preprocessed(fragment, compiler)))]
    return version + missing + [with_line(" ".join(line.split())) for line in lines]


def preprocessed(path, compiler):
    return subprocess.run([compiler, "-E", str(path)], capture_output=True, text=True, check=False).stdout


def without_output(vertex, fragment):
    return variables("in", fragment) - variables("out", vertex)


def variables(direction, text):
    """What a stage takes in, or gives out: `flat int triangle`. glslang does not miss what the stage before does not have, nor a
    `flat` that is on one side alone; GLSL 3.30 wants both."""
    declarations = re.findall(rf"^(flat )?{direction} (\w+) ([\w, ]+);", text, re.MULTILINE)
    return {f"{flat}{kind} {name.strip()}" for flat, kind, names in declarations for name in names.split(",")}


def with_line(complaint):
    """A line number says which of the included files it is of, counted from 0, and the line there."""
    return re.sub(r"\b0:(\d+):", lambda m: f"file {int(m[1]) // LINES_PER_FILE}, line {int(m[1]) % LINES_PER_FILE}:", complaint)


def characteristic(text):
    """The part of a shader file that stands in an assembled source as it is: what follows its last include."""
    lines = text.splitlines()
    last = max((number for number, line in enumerate(lines) if line.startswith(("#include", "#version"))), default=-1)
    return "\n".join(lines[last + 1:]) + "\n"


def unseen(shaders, texts):
    """The files of the shaders folder that are a part of none of the texts."""
    for path in sorted(path for path in shaders.rglob("*") if path.suffix in (".vert", ".frag", ".geom", ".glsl")):
        part = characteristic(path.read_text())
        if not any(part in text for text in texts):
            yield path.relative_to(shaders).as_posix()


def check(folder, shaders, fewest=FEWEST):
    """Prints what is wrong; returns how many things are."""
    pairs = [(path, path.with_suffix(".frag")) for path in sorted(folder.glob("*.vert"))]
    compiler = validator()
    with ThreadPoolExecutor(os.cpu_count()) as workers:
        results = list(workers.map(lambda pair: complaints_about(*pair, compiler), pairs))
    said = {}
    for (vertex, _), complaints in zip(pairs, results):
        for complaint in complaints:
            said.setdefault(complaint, f"{vertex.with_suffix('')} (.vert, .frag)")
    faults = [f"{path}: {complaint}" for complaint, path in said.items()]
    texts = {path.read_text() for pair in pairs for path in pair}
    faults += [f"shaders/{name}: no test links a program with it" for name in unseen(shaders, texts)]
    if len(pairs) < fewest:
        faults.append(f"{folder}: {len(pairs)} programs, of at least {fewest}")
    for fault in faults:
        print(fault)
    print(f"glsl_check: {len(pairs)} programs of {len(texts)} stages, {len(faults)} faults")
    return len(faults)


def main():
    folder = Path(sys.argv[1])
    shaders = Path(sys.argv[2]) if len(sys.argv) > 2 else ROOT / "shaders"
    sys.exit(1 if check(folder, shaders) else 0)


if __name__ == "__main__":
    main()
