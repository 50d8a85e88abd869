#!/usr/bin/env python3
"""Shows that glsl_check.py bites: each planted fault must be told of, and programs without one must pass."""
# SPDX-License-Identifier: MIT
import contextlib
import io
import sys
import tempfile
from pathlib import Path

from glsl_check import check

VERTEX = """#version 330 core
layout(location = 0) in vec3 positionMesh;
layout(location = 4) in int triangleOfMesh;
uniform mat4 clipFromMesh;
flat out int triangle;
out vec3 place;

void main() {
    gl_Position = clipFromMesh * vec4(positionMesh, 1.0);
    triangle = triangleOfMesh;
    place = positionMesh;
}
"""
FRAGMENT = """#version 330 core
uniform sampler2D source;
flat in int triangle;
in vec3 place;
vec3 right = dFdx(place);
out vec4 result;

void main() {
    uint number = uint(triangle);
    result = texture(source, place.xy + right.xy) * float(number);
}
"""

# (what must be said, stage, what is written in place of what); some that Mesa lets pass
PLANTED = [
    ("cannot convert from", "frag", ("uint(triangle)", "triangle")),
    ("not supported", "frag", ("uniform sampler2D", "layout(binding = 0) uniform sampler2D")),
    ("textureGather", "frag", ("texture(source, place.xy + right.xy)", "textureGather(source, place.xy)")),
    ("double", "frag", ("float(number)", "float(double(number))")),
    ("must be qualified as flat", "frag", ("flat in int", "in int")),
    ("Types must match", "vert", ("out vec3 place", "out vec4 place"), ("place = positionMesh", "place = vec4(positionMesh, 1.0)")),
    ("no output vec3 place", "vert", ("out vec3 place", "out vec3 spot"), ("place = positionMesh", "spot = positionMesh")),
    ("no output flat int triangle", "vert", ("flat out int triangle", "out int triangle")),
    ("extension not supported", "frag", ("uniform sampler2D source;", "uniform sampler2D source;\n#extension GL_NO_such : require")),
    ("#version 330 core", "vert", ("#version 330 core", "#version 420 core")),
    ("undeclared identifier", "frag", ("number);", "numbr);")),
    ("undeclared identifier", "vert", ("clipFromMesh * vec4", "gl_ModelViewMatrix * vec4")),
]


def faults_of(vertex, fragment, shaders=None, fewest=1):
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as said:
        programs, files = Path(folder, "programs"), Path(folder, "shaders")
        programs.mkdir()
        files.mkdir()
        (programs / "1.vert").write_text(vertex)
        (programs / "1.frag").write_text(fragment)
        for name, text in (shaders or {}).items():
            (files / name).write_text(text)
        count = check(programs, files, fewest)
    return count, said.getvalue()


def main():
    wrong = []

    def expect(what, holds, said):
        if not holds:
            wrong.append(what)
            print(f"{what}: {said}")

    count, said = faults_of(VERTEX, FRAGMENT, {"a.vert": VERTEX, "b.glsl": "flat in int triangle;\n"})
    expect("right programs pass", count == 0, said)
    for expected, stage, *changes in PLANTED:
        texts = {"vert": VERTEX, "frag": FRAGMENT}
        for before, after in changes:
            assert before in texts[stage], before
            texts[stage] = texts[stage].replace(before, after)
        count, said = faults_of(texts["vert"], texts["frag"])
        expect(f"{expected} ({changes[0][1].splitlines()[-1]})", count > 0 and expected in said, said)
    count, said = faults_of(VERTEX, FRAGMENT, {"c.frag": FRAGMENT + "// another\n"})
    expect("a file that no program has", count == 1 and "shaders/c.frag: no test links" in said, said)
    count, said = faults_of(VERTEX, FRAGMENT, fewest=2)
    expect("too few programs", count == 1 and "1 programs, of at least 2" in said, said)
    print(f"glsl_selftest: {len(PLANTED) + 3} trials, {len(wrong)} went wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
