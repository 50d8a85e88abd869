#!/usr/bin/env python3
"""Radiosity and our paths held against a renderer that others wrote: Cycles, of Blender.

cycles_check.py PROGRAM [--samples N] [--scene WORD] [--keep FOLDER]

Scenes (cycles_scenes.py) are drawn by radiosity as it is by default, by `ray-traced` with `interreflection`, and by Cycles, the latter
two with N samples for each pixel (4096). Compared is the mean radiance of blocks of 8 x 8 pixels in red, green and blue. Printed
for each pair: by how much the sum of all blocks differs, the root of the mean square of the blocks' differences, and the largest of
them, all as shares of the mean radiance. Before that three lamps above a plane are held against closed forms, in Cycles and in ours.

All three send the rays of a pixel through its centre, Cycles within a hundredth of a pixel. So outlines are where they are, and
pixels that have one so near to their centre are left out. So are blocks that show a piece of a lamp, and those that show nothing but
the background. All are counted.

The program writes PNG alone, so each picture is taken four times, at exposures a few hundredths apart, at which no compared pixel is
at its largest value. It is decoded, and the mean taken: what 8 bits round off falls another way each time. The four pictures of
paths and of Cycles are also of other random numbers, a quarter of the samples each, and their scatter says how exact their mean is.

Ends with 77 (skipped) without SHADOWLAB_LONG in the environment, or without Blender; with 1 where something is over its bound."""
# SPDX-License-Identifier: MIT
import argparse
import array
import json
import math
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

from cycles_scenes import LAMPS, TRIALS, for_blender, radiance_under, under_one_lamp

SKIPPED = 77
BLOCK = 8
FEWEST_PIXELS = 48  # of the 64 of a block; one with more at edges is left out
TAKES = 4
MARK_SAMPLES = 256
BRIGHTEST = 0.8  # what the brightest pixel that is no lamp comes to, of what 8 bits can hold
STEP = 0.931  # from one exposure to the next, so that no two round alike
LIGHTS = 16  # pixels along an edge of the pictures of lamps above a plane
CLOSED_FORM = 0.002  # by how much Cycles may be off there: the rectangle is sampled
CLOSED_FORM_8_BITS = 0.004  # and ours, whose pixels are rounded
# How far our paths may be from Cycles: both follow chance, and both should come to the same light.
PATHS_RMS, PATHS_TOTAL = 0.01, 0.005
LONGEST = 7200  # seconds, for one command


def run(words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, errors="replace", check=False, timeout=LONGEST)
    if done.returncode:
        raise SystemExit(f"{' '.join(map(str, words))}\nended with {done.returncode}: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


def decoded_png(path):
    """Rows of bytes of a picture of 8 bits a channel, and how many channels it has."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color, *_, interlaced = struct.unpack(">IIBBBBB", body)
        if kind == b"IDAT":
            packed += body
        at += 12 + length
    assert depth == 8 and color in (2, 6) and not interlaced
    channels = 4 if color == 6 else 3
    raw, stride, rows = zlib.decompress(packed), width * channels, []
    above = bytes(stride)
    for y in range(height):
        kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride):
            left, up, corner = (row[x - channels] if x >= channels else 0), above[x], (above[x - channels] if x >= channels else 0)
            if kind == 1:
                row[x] = row[x] + left & 255
            elif kind == 2:
                row[x] = row[x] + up & 255
            elif kind == 3:
                row[x] = row[x] + (left + up) // 2 & 255
            elif kind == 4:
                nearest = min((abs(up - corner), 0, left), (abs(left - corner), 1, up), (abs(left + up - 2 * corner), 2, corner))
                row[x] = row[x] + nearest[2] & 255
        rows.append(row)
        above = row
    return rows, channels


def linear(byte):
    s = byte / 255
    return s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4


LINEAR = [linear(byte) for byte in range(256)]


class Ours:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def picture(self, scene, size, exposure, technique, *settings):
        """Linear radiance, three numbers a pixel, and the pixels (counted) of which a channel is at its largest value."""
        file, out = self.folder / "scene.json", self.folder / f"{technique}.png"
        file.write_text(json.dumps({**scene, "exposure": exposure}), encoding="utf-8")
        words = [word for setting in settings for word in ("--set", f"{technique}.{setting}")]
        run([self.program, "capture", file, "-t", technique, *words, "--size", f"{size[0]}x{size[1]}", "--software", "-o", out])
        rows, channels = decoded_png(out)
        values, full = [], set()
        for y, row in enumerate(rows):
            for x in range(size[0]):
                pixel = row[x * channels:x * channels + 3]
                values += [LINEAR[byte] / exposure for byte in pixel]
                if 255 in pixel:
                    full.add(y * size[0] + x)
        return values, full


def by_cycles(jobs, folder):
    """Draws all jobs, {scene, samples, seed}, with one start of Blender; of each three numbers a pixel."""
    jobs = [{**job, "output": str(folder / f"cycles{n}")} for n, job in enumerate(jobs)]
    (folder / "jobs.json").write_text(json.dumps(jobs), encoding="utf-8")
    run(["blender", "-b", "--factory-startup", "--python-exit-code", "3", "--python", Path(__file__).with_name("cycles_render.py"), "--",
         folder / "jobs.json"])
    return [array.array("f", Path(job["output"]).read_bytes()) for job in jobs]


def complaints_about_lamps(ours, folder):
    """Each kind of lamp above a plane, at every pixel, against its closed form."""
    scenes = [under_one_lamp(lamp) for lamp in LAMPS]
    size = (LIGHTS, LIGHTS)
    drawn = by_cycles([{"scene": for_blender(scene, size), "samples": 1024, "seed": 1} for scene in scenes], folder)
    half = 4 * math.tan(math.radians(20))
    centres = [((i + 0.5) / LIGHTS * 2 - 1) * half for i in range(LIGHTS)]
    reflectance = scenes[0]["materials"]["grey"]["diffuse"]
    for lamp, scene, cycles in zip(LAMPS, scenes, drawn):
        exact = [value for z in centres for x in centres for value in radiance_under(lamp, (x, z), reflectance)]
        exposure = BRIGHTEST / max(exact)
        pictures = {"Cycles": cycles, "radiosity": ours.picture(scene, size, exposure, "radiosity")[0],
                    "paths": ours.picture(scene, size, exposure, "ray-traced", "samples=1024", "interreflection=true",
                                          "antialias=false")[0]}
        for name, picture in pictures.items():
            off = [p / e - 1 for p, e in zip(picture, exact)]
            total, worst = sum(off) / len(off), max(map(abs, off))
            print(f"a {lamp['type']} lamp above a plane, {name}: on average {100 * total:+.3f} %, at the worst of {len(off)} values "
                  f"{100 * worst:.2f} %", flush=True)
            if abs(total) > (CLOSED_FORM if name == "Cycles" else CLOSED_FORM_8_BITS):
                yield f"a {lamp['type']} lamp above a plane: {name} is off by {100 * total:+.2f} %"


def marked(scene):
    """The same, lit by nothing: red where something shines, green the polygon's number, blue its square; the background is black."""
    polygons = [{**polygon, "reflectance": [0, 0, 0], "radiance": [float(any(polygon["radiance"])), number, number ** 2]}
                for number, polygon in enumerate(scene["polygons"], 1)]
    return {**scene, "polygons": polygons, "lamps": [], "background": [0, 0, 0]}


class Blocks:
    """Which blocks of a picture are compared, and which pixels of them."""

    def __init__(self, marks, size):
        self.size, self.across, self.compared, self.lamps, self.empty = size, size[0] // BLOCK, [], 0, 0
        # The mean of squares is the square of the mean where all samples have met the same polygon.
        at_edge = {at // 3 for at in range(0, len(marks), 3) if abs(marks[at + 2] - marks[at + 1] ** 2) > 1e-4 * (1 + marks[at + 2])}
        self.at_edges = len(at_edge)
        self.places = []  # of the pixels of each block
        for block in range(self.across * (size[1] // BLOCK)):
            top, left = block // self.across * BLOCK, block % self.across * BLOCK
            pixels = [y * size[0] + x for y in range(top, top + BLOCK) for x in range(left, left + BLOCK)]
            shines, shows = any(marks[3 * at] for at in pixels), any(marks[3 * at + 1] for at in pixels)
            self.lamps += shines
            self.empty += not shows
            self.places.append([at for at in pixels if at not in at_edge])
            if shows and not shines and len(self.places[-1]) >= FEWEST_PIXELS:
                self.compared.append(block)

    def means(self, values):
        """Of a picture, three values a pixel: three for each block that is compared."""
        return {block: [sum(values[3 * at + c] for at in self.places[block]) / len(self.places[block]) for c in range(3)]
                for block in self.compared}

    def where(self, block):
        return f"{block % self.across},{block // self.across}"


def mean_of(takes):
    return {block: [sum(take[block][c] for take in takes) / len(takes) for c in range(3)] for block in takes[0]}


def level(blocks):
    return sum(map(sum, blocks.values())) / (3 * len(blocks))


def scatter(takes):
    """The standard error of the takes' mean, RMS over blocks and colours, as a share of the mean radiance."""
    mean, n = mean_of(takes), len(takes)
    squares = sum((take[b][c] - mean[b][c]) ** 2 for take in takes for b in mean for c in range(3))
    return math.sqrt(squares / (n * (n - 1)) / (3 * len(mean))) / level(mean)


def difference(a, b):
    """Of blocks `a` from blocks `b`: that of the sum, RMS, the largest, and its block and colour; all as shares of b's mean."""
    off = {(block, c): (a[block][c] - b[block][c]) / level(b) for block in b for c in range(3)}
    worst = max(off, key=lambda at: abs(off[at]))
    return level(a) / level(b) - 1, math.sqrt(sum(o * o for o in off.values()) / len(off)), off[worst], worst


def complaints_about(trial, ours, samples, folder):
    each = max(1, samples // TAKES)
    scene = for_blender(trial.scene, trial.size)
    *drawn, marks = by_cycles([*({"scene": scene, "samples": each, "seed": take} for take in range(TAKES)),
                               {"scene": marked(scene), "samples": MARK_SAMPLES, "seed": 0}], folder)
    blocks = Blocks(marks, trial.size)
    used = [at for block in blocks.compared for at in blocks.places[block]]
    brightest = max(max(picture[3 * at:3 * at + 3]) for picture in drawn for at in used)
    takes = {"radiosity": [], "paths": [], "Cycles": [blocks.means(picture) for picture in drawn]}
    full = set()
    for take in range(TAKES):
        exposure = BRIGHTEST / brightest * STEP ** take
        for name, technique, *settings in (("radiosity", "radiosity"), ("paths", "ray-traced", f"samples={each}", "interreflection=true",
                                                                         "antialias=false", f"seed={take}")):
            values, over = ours.picture(trial.scene, trial.size, exposure, technique, *settings)
            takes[name].append(blocks.means(values))
            full |= over
    means = {name: mean_of(several) for name, several in takes.items()}
    (folder / f"{trial.name.replace(' ', '-')}.json").write_text(json.dumps(means), encoding="utf-8")

    print(f"\n{trial.name}, {trial.size[0]} x {trial.size[1]}: {len(blocks.compared)} of {len(blocks.places)} blocks; left out: "
          f"{blocks.lamps} that show a lamp, {blocks.empty} that show no surface, and {blocks.at_edges} pixels at edges. By chance: Cycles "
          f"{100 * scatter(takes['Cycles']):.2f} %, paths {100 * scatter(takes['paths']):.2f} %.")
    if len(blocks.compared) < trial.least_blocks:
        yield f"{trial.name}: only {len(blocks.compared)} blocks are compared; {trial.least_blocks} should be"
    if clipped := len(full.intersection(used)):
        yield f"{trial.name}: {clipped} of the compared pixels are brighter than the picture can hold"
    for a, b in (("radiosity", "Cycles"), ("radiosity", "paths"), ("paths", "Cycles")):
        total, rms, worst, (block, color) = difference(means[a], means[b])
        print(f"| {trial.name} | {a} | {b} | {100 * total:+.2f} % | {100 * rms:.2f} % | {100 * worst:+.1f} % (block {blocks.where(block)}, "
              f"{'red green blue'.split()[color]}) |", flush=True)
        if a == "radiosity" and rms > trial.allowed:
            yield f"{trial.name}: blocks of radiosity are {100 * rms:.2f} % off those of {b}; {100 * trial.allowed:.0f} % are allowed"
        if a == "paths" and (rms > PATHS_RMS or abs(total) > PATHS_TOTAL):
            yield f"{trial.name}: paths are not Cycles: {100 * rms:.2f} % of blocks, {100 * total:+.2f} % in all"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=Path)
    parser.add_argument("--samples", type=int, default=4096)
    parser.add_argument("--scene", default="", help="only those with that word in their name")
    parser.add_argument("--keep", type=Path, help="where the blocks' means are written, as JSON")
    words = parser.parse_args()
    if not os.environ.get("SHADOWLAB_LONG") or not shutil.which("blender"):
        print("skipped: it takes SHADOWLAB_LONG in the environment, and Blender")
        return SKIPPED
    complaints = []
    with tempfile.TemporaryDirectory() as temporary:
        folder = words.keep or Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        ours = Ours(words.program.resolve(), folder)
        complaints += complaints_about_lamps(ours, folder)
        trials = [trial for trial in TRIALS if words.scene in trial.name]
        assert trials, f"no scene is called {words.scene}"
        for trial in trials:
            complaints += complaints_about(trial, ours, words.samples, folder)
    print("\n" + "\n".join(complaints or ["all within their bounds"]))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
