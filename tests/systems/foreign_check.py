#!/usr/bin/env python3
"""Scenes are exported, drawn by other renderers, and their pictures judged: Blender (Cycles), POV-Ray, and three.js in Chromium.

foreign_check.py PROGRAM [--scene WORD] [--to FORMAT] [--three FOLDER] [--keep FOLDER]

Every light of every scene is drawn twice by each renderer: as an image of its visibility, and as a shaded picture beside the same without
shadows. `judge` holds both against the truth, after it has held the renderer's picture of the calibration board against the board. Cycles and
POV-Ray send rays, and so does the page of three.js with shadows=rays: none of their pixels may be misjudged outside ties. With its shadow
maps three.js has the boundaries where their texels have them: these numbers are told, with a wide bound. Last (as the scene "readme") all
commands of the README of a scene with odd names are run.

three.js comes from the npm registry into a temporary folder, or from FOLDER (its build/). A renderer that is not installed is left out
with a line that says so. Ends with 77 (skipped) without SHADOWLAB_LONG in the environment or without any of the renderers; with 1 where
something is over its bound."""
# SPDX-License-Identifier: MIT
import argparse
import base64
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
SIZE = "320x180"
LIGHTS = {"still-life": ("key",), "three-lights": ("left", "middle", "right"), "colonnade": ("sun",), "lattice": ("sun",),
          "hung-ring": ("sun",), "room-with-lamps": ("spot", "panel", "bulb")}
# Lights with an area are drawn as points, and judged by their centres.
BY_CENTRE = ("panel", "bulb")
# By visibility alone, and not by a pair: a pair needs the other lights as bright as in the scene. With its maps three.js takes a panel for a point
# without a cosine; POV-Ray's lights that cast no shadow have no cone and shine to all sides. The others have them as they are.
VISIBILITY_ALONE = (("three-map", "spot"), ("three-map", "panel"), ("three-map", "bulb"), ("pov", "panel"), ("pov", "bulb"))
PICTURES = ("visibility", "shaded", "unshadowed")
THREE_VERSION = "0.187"
# Of the pixels with a surface, how many a shadow map may misjudge. In the colonnade one map of 4096 texels has to cover 26 m, and the
# flutes of the columns are a few of its texels deep.
LEAST_RIGHT_OF_MAPS = 0.985
LONGEST = 1200  # seconds, for one command
ODD_SCENE = {"camera": {"position": [0, 3, 7], "target": [0, 0, 0]},
             "lights": [{"name": "Key & Fill #1", "type": "point", "position": [2, 5, 3], "intensity": 40},
                        {"name": "Sun/1", "type": "directional", "direction": [0.4, -1, -0.3]},
                        {"name": "--help", "type": "spot", "position": [2.5, 3, 2], "direction": [-0.6, -1, -0.5], "coneDegrees": 70}],
             "objects": [{"shape": "quad", "size": [9, 9]}, {"shape": "box", "size": [1.5, 1.5, 1.5], "translate": [0, 1, 0]}]}


def run(words, folder=None, allowed=(0,)):
    done = subprocess.run([str(word) for word in words], cwd=folder, capture_output=True, text=True, errors="replace", check=False, timeout=LONGEST)
    if done.returncode not in allowed:
        raise SystemExit(f"{' '.join(map(str, words))}\nended with {done.returncode}: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


class Blender:
    name, format, key = "Cycles", "blender", "blender"
    misses = "blender is not installed"

    @staticmethod
    def is_there(_):
        return bool(shutil.which("blender"))

    def draw(self, folder, stem, picture, light, output):
        words = ["--picture", picture, "--light", light] if light else []
        run(["blender", "-b", "--factory-startup", "--python-exit-code", "3", "--python", folder / f"{stem}.py", "--", *words, "--size", SIZE, "-o", output])


class PovRay:
    name, format, key = "POV-Ray", "pov", "pov"
    misses = "povray is not installed"
    NUMBERS = {"look": 0, "shaded": 1, "unshadowed": 2, "visibility": 3}

    @staticmethod
    def is_there(_):
        return bool(shutil.which("povray"))

    def draw(self, folder, stem, picture, light, output):
        width, height = SIZE.split("x")
        alpha = ["+UA"] if picture == "visibility" else []
        number = re.search(rf"^//   (\d+)  {re.escape(light)}$", (folder / f"{stem}.pov").read_text(), re.MULTILINE).group(1) if light else 0
        run(["povray", f"+W{width}", f"+H{height}", "-D", "-A", "+FN16", "File_Gamma=srgb", *alpha, f"+I{stem}.pov",
             f"Declare=Picture={self.NUMBERS[picture]}", f"Declare=Light={number}", f"+O{output}"], folder)


class Three:
    format = "three"
    misses = "chromium is not installed, or three.js cannot be had by npm"

    def __init__(self, shadows):
        self.shadows, self.name, self.key = shadows, f"three.js, {shadows}", f"three-{shadows}"

    @staticmethod
    def is_there(words):
        return bool(shutil.which("chromium")) and words.three is not None

    def draw(self, folder, stem, picture, light, output):
        query = f"?picture={picture}&size={SIZE}&shadows={self.shadows}" + (f"&light={light}" if light else "")
        page = run(["chromium", "--headless", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                    "--virtual-time-budget=60000", "--dump-dom", f"file://{folder / stem}.html{query}"])
        found = re.search(r'href="data:image/png;base64,([^"]*)"', page)
        if not found:
            said = re.search(r'<p id="message">([^<]*)', page)
            raise SystemExit(f"three.js: {stem}.html{query} has drawn nothing: {said.group(1) if said else page[:500]}")
        output.write_bytes(base64.b64decode(found.group(1)))


def judged(program, picture, scene, light, *further):
    answer = run([program, "judge", picture, scene, "--light", light, *further, "--json"], allowed=(0, 1, 3))
    return json.loads(answer)


def complaints_about(renderer, scene, program, folder, three):
    """Draws all pictures of one scene, and prints a line for each light."""
    exported = folder / f"{scene}-{renderer.key}"
    shutil.rmtree(exported, ignore_errors=True)
    module = ["--three-module", three / "three.module.js"] if renderer.format == "three" else []
    run([program, "export", scene, "-o", exported, "--to", renderer.format, "--size", SIZE, *module])
    board = exported / "calibration.png"
    renderer.draw(exported, "calibration", "look", None, board)
    for light in LIGHTS[scene]:
        pictures = PICTURES[:1] if (renderer.key, light) in VISIBILITY_ALONE else PICTURES
        files = {picture: exported / f"{picture}-{light}.png" for picture in pictures}
        for picture, file in files.items():
            renderer.draw(exported, "scene", picture, light, file)
        how = ["--by-centre"] if light in BY_CENTRE else []
        answers = {"visibility": judged(program, files["visibility"], scene, light, "--calibration", board, *how)}
        if "shaded" in files:
            answers["a pair"] = judged(program, files["shaded"], scene, light, "--reference", files["unshadowed"], "--calibration", board, *how)
        for kind, answer in answers.items():
            if not answer["calibration"]["right"]:
                yield f"{renderer.name}, {scene}: the calibration is wrong: {answer['calibration']['faults']}"
                return
            numbers = answer["judged"]
            wrong = numbers["falseLit"] + numbers["falseShadow"]
            print(f"| {scene} | {light} | {renderer.name} | {kind} | {numbers['pixels']} | {numbers['ties']} | {numbers['notJudged']} | "
                  f"{numbers['falseLit']} | {numbers['falseShadow']} | {numbers['coreErrors']} |", flush=True)
            allowed = (1 - LEAST_RIGHT_OF_MAPS) * numbers["pixels"] if renderer.key == "three-map" else 0
            if wrong > allowed:
                yield f"{renderer.name}, {scene}, light {light}, {kind}: {wrong} pixels are misjudged outside ties"
            if numbers["lit"] < 1000 or numbers["shadowed"] < 100:
                yield f"{scene}, light {light}: too little is lit or in shadow to prove anything"


def complaints_about_readme(renderer, program, folder):
    """Every command of a README is run in its folder as it stands there, the first judge line included. The scene lies where a relative name
    leads elsewhere, and its lights have names that no command line takes as they are."""
    place = folder / "readme"
    place.mkdir(exist_ok=True)
    (place / "odd names.json").write_text(json.dumps(ODD_SCENE))
    (place / "shadowlab").unlink(missing_ok=True)
    (place / "shadowlab").symlink_to(program)
    exported = f"made-{renderer.format}"
    shutil.rmtree(place / exported, ignore_errors=True)
    run([program, "export", "odd names.json", "-o", exported, "--to", renderer.format, "--size", "160x90"], place)
    lines = [line[4:] for line in (place / exported / "README.md").read_text().splitlines() if line.startswith("    ")]
    commands = [line for line in lines if line.startswith(("povray ", "blender "))]
    for command in commands:
        run(["sh", "-c", command], place / exported)
    pictures = len(list((place / exported).glob("*.png")))
    print(f"{renderer.name}: {len(commands)} commands of the README have drawn {pictures} pictures")
    if not len(commands) == pictures == 2 + 3 * len(ODD_SCENE["lights"]):
        yield f"{renderer.name}: {len(commands)} commands of the README have drawn {pictures} pictures"
    judge = next(line for line in lines if line.startswith("shadowlab judge "))
    answer = json.loads(run(["sh", "-c", f"../{judge} --json"], place / exported, allowed=(0, 1, 3)))["judged"]
    if answer["falseLit"] + answer["falseShadow"] or answer["shadowed"] < 100:
        yield f"{renderer.name}: by the README's judge line {answer}"


def three_from_npm(folder):
    """The folder of three.module.js; None where npm or the registry is not there."""
    if not shutil.which("npm"):
        return None
    done = subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--prefix", str(folder), f"three@{THREE_VERSION}"], capture_output=True, check=False,
                          timeout=LONGEST)
    return folder / "node_modules/three/build" if done.returncode == 0 else None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=Path)
    parser.add_argument("--scene", default="", help="only those with that word in their name")
    parser.add_argument("--to", default="", help="only that format")
    parser.add_argument("--three", type=Path, help="the folder of three.module.js, in place of npm's")
    parser.add_argument("--keep", type=Path, help="where everything is written")
    words = parser.parse_args()
    if not os.environ.get("SHADOWLAB_LONG"):
        print("skipped: it takes SHADOWLAB_LONG in the environment")
        return SKIPPED
    complaints = []
    with tempfile.TemporaryDirectory() as temporary:
        folder = (words.keep or Path(temporary)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        if words.three is None and words.to in ("", "three"):
            words.three = three_from_npm(folder / "npm")
        renderers = [renderer for renderer in (Blender(), PovRay(), Three("rays"), Three("map")) if words.to in ("", renderer.format)]
        for renderer in renderers:
            if not renderer.is_there(words):
                print(f"left out: {renderer.name}, for {renderer.misses}")
        renderers = [renderer for renderer in renderers if renderer.is_there(words)]
        if not renderers:
            print("skipped: none of the renderers is there")
            return SKIPPED
        scenes = [scene for scene in LIGHTS if words.scene in scene]
        assert scenes or words.scene in "readme", f"no scene is called {words.scene}"
        print("| scene | light | renderer | judged by | pixels | ties | not judged | false lit | false shadow | core errors |\n"
              "|---|---|---|---|---|---|---|---|---|---|")
        for scene in scenes:
            for renderer in renderers:
                complaints += complaints_about(renderer, scene, words.program.resolve(), folder, words.three)
        for renderer in renderers:
            if renderer.format != "three" and words.scene in "readme":
                complaints += complaints_about_readme(renderer, words.program.resolve(), folder)
    print("\n" + "\n".join(complaints or ["all within their bounds"]))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
