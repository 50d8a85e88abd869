#!/usr/bin/env python3
"""What the refinements of each technique buy: a table on its page, between `<!-- refinements: TECHNIQUE -->` and
`<!-- end refinements -->`.

    refinements.py [--program PATH] [--only TECHNIQUE]   measures, and writes the tables
    refinements.py --check                               ends with 1 where a table is missing, has other rows than are listed here,
                                                         or counts other lines of code than the sources have; measures nothing

Each row holds a technique without one refinement against the same technique with it, on a scene that needs it: wrong pixels
(light where there is shadow, and shadow where there is light) and milliseconds of a whole frame while the light moves, both from
`shadowlab measure`, the two in one run and taking turns. The code of a refinement is that of the files named with it, without comments and
blank lines. The first row is the algorithm as the lecture has it, beside the production technique as it is by default.
"""
# SPDX-License-Identifier: MIT
import argparse
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
SIZE = "640x360"
FRAMES = 12  # of a light that turns by 2 degrees in all: every frame is a new one, and the picture stays nearly the same


class Refinement(NamedTuple):
    what: str  # it does
    scene: str
    without: tuple  # parameters of the technique as it is without
    with_it: tuple = ()
    code: tuple = ()  # files and folders below techniques/ and shaders/
    before: str = ""  # another technique to compare with; empty: the same


# The technique's page, what the lecture's version is called, all the code of the technique, and its refinements.
class Page(NamedTuple):
    page: str
    lecture: str
    lecture_code: tuple
    code: tuple
    scene: str
    refinements: tuple


# What two of the folder shadow_map have of their own; what stands in a technique's code with a "-" before it is not of it.
EXACT_MAP = ("shadow_map/exact_map.cpp", "shadow_map/exact", "shadow_map/decide.frag", "shadow_map/walk.glsl", "shadow_map/loose_edge.vert")
ALIAS_FREE_MAP = ("shadow_map/alias_free_map.cpp", "shadow_map/irregular")

PAGES = {
    "planar": Page("planar", "lecture-planar", ("lecture/planar.cpp",), ("planar",), "still-life", (
        Refinement("Only what lies between light and plane is flattened", "billiards", ("clip=false",), (),
                   ("planar/projection.cpp", "planar/behind.vert")),
        Refinement("A shadow ends where its plane's surface ends (stencil)", "still-life", ("stencil=false",), (), ("planar/drawing.cpp",)),
        Refinement("All flat faces in view receive, not the largest alone", "room-with-lamps", ("receivers=1",), (), ("planar/receivers",)),
        Refinement("What cannot shadow anything in view is left out", "colonnade", ("cull=false",), (), ("planar/flattening.cpp", "planar/casters.cpp")),
    )),
    "shadow-map": Page("shadow-map", "lecture-shadow-map", ("lecture/shadow_map.cpp",),
                       ("shadow_map", *("-" + name for name in (*EXACT_MAP, *ALIAS_FREE_MAP))), "still-life", (
        Refinement("A bias from the receiver's plane", "still-life", ("bias-mode=none",), (), ("shadow_map/bias/bias_receiver_plane.glsl",)),
        Refinement("The map holds what is in view", "hung-ring", ("fit=scene",), (), ("shadow_map/fit",)),
        Refinement("The range of depths fits the receivers", "still-life", ("depth-range=wide", "depth-format=16"), ("depth-format=16",),
                   ("shadow_map/fit",)),
        Refinement("Casters before the near plane are kept", "eye-in-shadow", ("depth-clamp=false",), (), ("shadow_map/fit",)),
        Refinement("Four cascades", "colonnade", (), ("cascades=4",), ("shadow_map/fit",)),
        Refinement("What cannot shadow anything in view is left out", "colonnade", ("cull=false",), (), ("shadow_map/fit",)),
    )),
    "shadow-map-exact": Page("shadow-map-exact", "lecture-shadow-map", ("lecture/shadow_map.cpp",),
                             (*EXACT_MAP, "shadow_map/fit", "shadow_map/maps", "shadow_map/receivers.cpp", "shadow_map/receivers.h"),
                             "still-life", (
        Refinement("Rays where the map is not certain", "still-life", (), (), EXACT_MAP, "shadow-map"),
        Refinement("What cannot shadow anything in view is left out", "colonnade", ("cull=false",), (), ("shadow_map/fit",)),
    )),
    "shadow-map-alias-free": Page("shadow-map-alias-free", "lecture-shadow-map", ("lecture/shadow_map.cpp",), ALIAS_FREE_MAP,
                                  "still-life", (
        Refinement("The visible points are tested, not texels", "still-life", (), (), ALIAS_FREE_MAP, "shadow-map"),
    )),
    "shadow-volume-zpass": Page("shadow-volume-zpass", "lecture-zpass", ("lecture/zpass.cpp",), ("shadow_volume",), "still-life", (
        Refinement("The eye may be in shadow", "eye-in-shadow", (), ("eye-correction=true",), ("shadow_volume/zpass.cpp",)),
        Refinement("Rays decide where the rasteriser may have miscounted", "colonnade", (), ("repair=true",), ("shadow_volume/repair",)),
        Refinement("Volumes of any triangles, not of closed meshes alone", "leafy", ("construction=lecture",), (),
                   ("shadow_volume/count",)),
        Refinement("What cannot shadow anything in view is left out", "colonnade", ("cull=false",), (), ("shadow_volume/cull",)),
    )),
    "shadow-volume-zfail": Page("shadow-volume-zfail", "lecture-zfail", ("lecture/zfail.cpp",), ("shadow_volume",), "still-life", (
        Refinement("Caps close the volumes", "still-life", ("caps=false",), (), ("shadow_volume/count",)),
        Refinement("No far plane cuts them open", "billiards", ("far-plane=clip", "volume-end=infinity"), ("volume-end=infinity",),
                   ("shadow_volume/count",)),
        Refinement("Volumes end behind the last receiver", "colonnade", ("volume-end=infinity",), (), ("shadow_volume/count",)),
        Refinement("Volumes of any triangles, not of closed meshes alone", "leafy", ("construction=lecture",), (),
                   ("shadow_volume/count",)),
        Refinement("Rays decide where the rasteriser may have miscounted", "colonnade", (), ("repair=true",), ("shadow_volume/repair",)),
        Refinement("What cannot shadow anything in view is left out", "colonnade", ("cull=false",), (), ("shadow_volume/cull",)),
    )),
    "shadow-volume": Page("shadow-volume", "lecture-zfail", ("lecture/zfail.cpp",), ("shadow_volume",), "still-life", (
        Refinement("Each volume is counted in the cheaper way that is right", "still-life", ("repair=false",), ("repair=false",),
                   ("shadow_volume/automatic.cpp",), "shadow-volume-zfail"),
        Refinement("Rays decide where the rasteriser may have miscounted", "colonnade", ("repair=false",), (), ("shadow_volume/repair",)),
        Refinement("What cannot shadow anything in view is left out", "colonnade", ("cull=false",), (), ("shadow_volume/cull",)),
    )),
    "ray-traced": Page("ray-traced", "lecture-ray-tracing", ("lecture/ray_tracing.cpp",), ("ray_tracing",), "still-life", (
        Refinement("A tree of boxes over all triangles", "still-life", ("structure=object-boxes",), (), ("foundation/trace/bvh",)),
        Refinement("No ray slips between two triangles", "leafy", ("intersection=naive",), (), ("foundation/trace/ray_triangle.h",)),
        Refinement("A shadow ray leaves its own triangle out", "still-life", ("exclude-source=false",), (), ("ray_tracing/picture.cpp",)),
    )),
    "radiosity": Page("radiosity", "lecture-radiosity", ("lecture/radiosity.cpp",), ("radiosity",), "cornell-room", (
        Refinement("Direct light is that of pixels, not of patches", "cornell-room", ("direct=patches",), (), ("radiosity/lights/pixel_light.h", "radiosity/lights/pixel_light.cpp")),
        Refinement("Patches end where things stand on them", "cornell-room", ("direct=patches", "cut-at-contacts=false"), ("direct=patches",), ("radiosity/patches",)),
        Refinement("Patches are cut finer where light changes", "cornell-room", ("direct=patches",), ("direct=patches", "refine=2"), ("radiosity/patches",)),
        Refinement("Form factors in closed form, not drawn", "cornell-room", ("direct=patches", "form-factors=hemicube"), ("direct=patches",), ("radiosity/form_factors",)),
    )),
}

BEGIN, END = "<!-- refinements: {} -->", "<!-- end refinements -->"


def code_lines(names):
    """Lines of code of files and folders, without comments and blank lines; less those of "-NAME"."""
    total = 0
    for name in names:
        if name.startswith("-"):
            total -= code_lines((name[1:],))
            continue
        roots = [root / name for root in (ROOT / "techniques", ROOT / "shaders") if (root / name).exists()]
        if not roots:
            sys.exit(f"refinements: there is no {name} below techniques/ or shaders/")
        for root in roots:
            for path in [root] if root.is_file() else sorted(root.rglob("*.*")):
                if path.suffix in (".h", ".cpp", ".glsl", ".vert", ".frag"):
                    text = re.sub(r"/\*.*?\*/", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
                    total += sum(1 for line in text.splitlines() if line.split("//")[0].strip())
    return total


def measured(program, scene, one, other):
    """Both in one run, frame by frame in turns: (wrong pixels, milliseconds) of each. `one`: technique and parameters."""
    words = [str(program), "measure", scene, "-t", f"{one[0]},{other[0]}", "--size", SIZE, "--frames", str(FRAMES), "--orbit-light",
             str(2 / FRAMES), "--json"]
    for slot, (technique, settings) in enumerate((one, other), 1):
        for setting in settings:
            words += ["--set", f"{slot}:{technique}.{setting}"]
    ran = subprocess.run(words, capture_output=True, text=True, check=False)
    if ran.returncode != 0:
        sys.exit(f"refinements: {' '.join(words)}: {ran.stderr}")
    return [(result["falseLit"] + result["falseShadow"], result["ms"]["frame"]) for result in json.loads(ran.stdout)["results"]]


def row(what, scene, figures, lines):
    (wrong, ms), (wrong_with, ms_with) = figures
    return f"| {what} | `{scene}` | {wrong:,} → {wrong_with:,} | {ms:.1f} → {ms_with:.1f} | {lines} |"


def table(program, technique):
    page = PAGES[technique]
    lines = [f"Wrong pixels of {SIZE.replace('x', ' x ')}, and milliseconds of a whole frame while the light moves "
             "(`python3 docs/refinements.py`; two cores, Mesa llvmpipe).", "",
             "| what it does | scene | wrong pixels | ms | lines of code |", "|---|---|---|---|---|",
             row(f"**All of it**: `{page.lecture}` → `{technique}`", page.scene,
                 measured(program, page.scene, (page.lecture, ()), (technique, ())),
                 f"{code_lines(page.lecture_code)} → {code_lines(page.code)}")]
    for one in page.refinements:
        lines.append(row(one.what, one.scene, measured(program, one.scene, (one.before or technique, one.without), (technique, one.with_it)),
                         code_lines(one.code)))
    return "\n".join(lines)


def part_of(text, technique):
    begin = text.find(BEGIN.format(technique))
    return (begin + len(BEGIN.format(technique)), text.find(END, begin)) if begin >= 0 else None


def check():
    faults = []
    for technique, page in PAGES.items():
        text = (ROOT / "docs" / f"{page.page}.md").read_text(encoding="utf-8")
        place = part_of(text, technique)
        if place is None:
            faults.append(f"docs/{page.page}.md has no table of refinements of {technique}")
            continue
        rows = [line for line in text[slice(*place)].splitlines() if line.startswith("| ")][1:]
        expected = [f"{code_lines(page.lecture_code)} → {code_lines(page.code)}", *(str(code_lines(one.code)) for one in page.refinements)]
        counted = [line.split("|")[5].strip() for line in rows]
        if counted != expected:
            faults.append(f"docs/{page.page}.md: lines of code are {expected}, the table says {counted}")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/shadowlab")
    parser.add_argument("--only", metavar="TECHNIQUE", choices=PAGES)
    chosen = parser.parse_args()
    if chosen.check:
        faults = check()
        print("\n".join(faults) if faults else f"{len(PAGES)} tables, their lines of code as in the sources")
        sys.exit(1 if faults else 0)
    for technique, page in PAGES.items():
        if chosen.only in (None, technique):
            path = ROOT / "docs" / f"{page.page}.md"
            text = path.read_text(encoding="utf-8")
            place = part_of(text, technique)
            if place is None:
                sys.exit(f"refinements: docs/{page.page}.md has no place for the table: {BEGIN.format(technique)} ... {END}")
            path.write_text(text[:place[0]] + "\n" + table(chosen.program, technique) + "\n" + text[place[1]:], encoding="utf-8")


if __name__ == "__main__":
    main()
