"""The blanks of the skeletons (assets/skeletons), filled in: rightly, with the lecture's own lines, and with one mistake each that
students make.

`solutions(skeleton)` is {number: Blank}. The right ones together get full marks; each mistake, in place of the right one, costs some.
"""
# SPDX-License-Identifier: MIT
import json
import re
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent


@dataclass
class Blank:
    right: str
    mistake: str  # in a few words
    wrong: str


# In the order of the blanks: the mistake in words, what is exchanged in the right lines for it, and for what; or all of them.
ALL = None
MISTAKES = {
    "planar": [
        ("the transposed matrix", "outerProduct(lightView, planeView)", "outerProduct(planeView, lightView)"),
        ("the sign of D", ", -glm::dot", ", glm::dot"),
        ("the stencil is not asked", "GL_EQUAL", "GL_ALWAYS"),
        ("nothing is clipped at the plane", ALL, "gl_ClipDistance[0] = 1.0;"),
    ],
    "shadow-map": [
        ("the sun looks the other way", "ball.centerWorld + 2", "ball.centerWorld - 2"),
        ("a fixed near and far plane", "1.0, near, distance + radius", "1.0, 0.01 + 0.0 * near, 1000.0"),
        ("no bias at all", ALL, ""),
        ("what is behind the lamp is not left out", "if (positionLightClip.w <= 0.0) return vec3(-1.0);", ""),
        ("the comparison is the wrong way around", "d < z", "d > z"),
    ],
    "z-fail": [
        ("the sun is taken for a place", "lightMesh.w * aMesh", "aMesh"),
        ("all edges have one direction", "fromAToB ? OutlineEdge{edge.a, edge.b}", "!fromAToB ? OutlineEdge{edge.a, edge.b}"),
        ("twenty metres are taken for enough", "if (distance == 0) return vec4(awayMesh, 0);", "if (distance == 0) distance = 20;"),
        ("no bottom cap", ALL, ""),
        ("they are subtracted", "GL_INCR_WRAP", "GL_DECR_WRAP"),
        ("the wrong ones are culled", "GL_BACK", "GL_FRONT"),
        ("the depth test's other outcome: z-pass", "GL_KEEP, change, GL_KEEP", "GL_KEEP, GL_KEEP, change"),
    ],
    "ray-tracing": [
        ("through the corners of the pixels", " + 0.5", ""),
        ("what stands behind the lamp casts shadows", "source.type != scene::LightType::directional", "false"),
        ("half the way: the ray goes along the surface", "2.0 * glm::dot", "1.0 * glm::dot"),
        ("eta is upside down", "eta * u + (eta * cosIncoming", "u / eta + (cosIncoming / eta"),
        ("total reflection is lost", "node.kR += std::exchange(node.kT, 0.0)", "node.kT = 0"),
        ("one level too few", "node.level == maximumDepth", "node.level + 1 >= maximumDepth"),
        ("glass is not seen through", "if (node.kT > 0) node.refraction = split(*T);", ""),
        ("the two coefficients are exchanged", "node->kR * I_R + node->kT * I_T", "node->kT * I_R + node->kR * I_T"),
    ],
    "radiosity": [
        ("the receiver's cosine is forgotten", "cosJ * cosK /", "cosJ + 0 * cosK /"),
        ("nothing hides anything", ALL, "(void)rays, (void)p, (void)q;\nfree += 1;"),
        ("the areas are exchanged", "patches[j].area);\n", "patches[k].area);\n"),
        ("pi is forgotten", "return pi * emitted", "return emitted"),
        ("rho is forgotten", "equations.rho[i] * gathered", "gathered"),
    ],
}


def lecture_lines(blank):
    """What `first` to `last` of a blank stand for in techniques/lecture and shaders/lecture, without indentation."""
    mark = re.compile(rf"^\s*// \[anchor: {re.escape(blank['anchor'])}\]$")
    for file in sorted([*(ROOT / "techniques" / "lecture").rglob("*.cpp"), *(ROOT / "shaders" / "lecture").iterdir()]):
        lines = [line.strip() for line in file.read_text().splitlines()]
        anchors = [number for number, line in enumerate(lines) if mark.match(line)]
        if anchors:
            first = lines.index(blank["first"], anchors[0])
            return "\n".join(lines[first:lines.index(blank.get("last", blank["first"]), first) + 1])
    raise ValueError(f"no anchor {blank['anchor']}")


def solutions(skeleton):
    text = (ROOT / "assets" / "skeletons" / f"{skeleton}.json").read_text()
    blanks = json.loads(re.sub(r"^//.*$", "", text, flags=re.MULTILINE))["blanks"]
    assert len(blanks) == len(MISTAKES[skeleton]), skeleton
    filled = {}
    for number, (blank, (mistake, part, wrong)) in enumerate(zip(blanks, MISTAKES[skeleton]), 1):
        right = lecture_lines(blank)
        assert part is ALL or right.count(part) == 1, f"{skeleton}, blank {number}: '{part}' is not in {right}"
        filled[number] = Blank(right, mistake, wrong if part is ALL else right.replace(part, wrong))
        assert filled[number].right != filled[number].wrong
    return filled


SOLUTIONS = {skeleton: solutions(skeleton) for skeleton in MISTAKES}
