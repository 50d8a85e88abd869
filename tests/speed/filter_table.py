#!/usr/bin/env python3
"""What every filter of the shadow map costs and how wrong it is, on all built-in scenes, as `shadowlab measure` finds it.

filter_table.py PROGRAM [TABLE.md [CHART.svg]]

Cost: what a frame takes longer than without shadows, the light moving, so that maps are new in each frame; the filters of one
scene and resolution are measured in one run. Error: root mean square of the visibility against the exact answer for the
light's centre; for pcss, where the light has an area, for that. One is better than another if it is neither slower nor more wrong, on the mean over all scenes; those that
none is better than are the Pareto set.
"""
# SPDX-License-Identifier: MIT
import json
import math
import subprocess
import sys

FILTERS = []  # those of the program, in its order: filters_of()
COLORS = ["#000000", "#56B4E9", "#0072B2", "#009E73", "#999999", "#E69F00", "#CC79A7", "#D55E00", "#8B5A2B"]
RESOLUTIONS = [256, 512, 1024, 2048]
MOTION = ["--frames", "5", "--orbit-light", "5"]


def filters_of(program):
    listed = subprocess.run([program, "list", "parameters"], capture_output=True, text=True, check=True).stdout
    row = next(line.split("\t") for line in listed.splitlines() if line.startswith("shadow-map.filter\t"))
    return row[2].split("|")


def scene_names(program):
    listed = subprocess.run([program, "list", "scenes"], capture_output=True, text=True, check=True).stdout
    return [line.split("\t")[0] for line in listed.splitlines() if line]


def measured(program, scene, resolution):
    """Of each filter: (cost in ms, RMSE)."""
    arguments = [program, "measure", scene, "--json", *MOTION, "-t", ",".join(["unshadowed"] + ["shadow-map"] * len(FILTERS))]
    for slot, name in enumerate(FILTERS, start=2):
        arguments += ["--set", f"{slot}:shadow-map.filter={name}", "--set", f"{slot}:shadow-map.resolution={resolution}"]
    results = json.loads(subprocess.run(arguments, capture_output=True, text=True, check=True).stdout)["results"]
    without = results[0]["ms"]["frame"]
    return [(result["ms"]["frame"] - without, result["rmse"]) for result in results[1:]]


def pareto_set(points):
    """Keys of those than which none is both cheaper and less wrong."""
    def is_better(a, b):
        return a != b and a[0] <= b[0] and a[1] <= b[1]
    return {key for key, point in points.items() if not any(is_better(other, point) for other in points.values())}


def table(scenes, cells, means, pareto):
    lines = ["| filter | texels | mean ms | mean RMSE | Pareto |" + "".join(f" {scene} |" for scene in scenes),
             "|---|---:|---:|---:|---|" + "---:|" * len(scenes)]
    for key in sorted(means, key=lambda key: (FILTERS.index(key[0]), key[1])):
        cost, error = means[key]
        each = "".join(f" {ms:.1f} / {rmse:.4f} |" for ms, rmse in (cells[scene, *key] for scene in scenes))
        lines.append(f"| `{key[0]}` | {key[1]} | {cost:.1f} | {error:.4f} | {'yes' if key in pareto else ''} |{each}")
    return "\n".join(lines) + "\n"


def chart(means, pareto):
    """Error over cost, both logarithmic; a line joins the resolutions of one filter."""
    width, height, left, top, right, bottom = 720, 430, 70, 20, 110, 50
    costs, errors = [p[0] for p in means.values()], [p[1] for p in means.values()]
    low = (math.log(min(costs) * 0.9), math.log(min(errors) * 0.9))
    high = (math.log(max(costs) * 1.1), math.log(max(errors) * 1.1))

    def place(point):
        share = [(math.log(value) - low[i]) / (high[i] - low[i]) for i, value in enumerate(point)]
        return left + share[0] * (width - left - right), height - bottom - share[1] * (height - top - bottom)

    def text(x, y, words, anchor="middle", color="#222222", extra=""):
        return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{color}" {extra}>{words}</text>'

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="DejaVu Sans, sans-serif" '
           'font-size="12">', f'<rect width="{width}" height="{height}" fill="white"/>']
    for value in (1, 2, 5, 10, 20, 50, 100, 200):
        if low[0] <= math.log(value) <= high[0]:
            x = place((value, errors[0]))[0]
            out += [f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{top}" y2="{height - bottom}" stroke="#e2e2e2"/>',
                    text(x, height - bottom + 16, value)]
    for value in (0.005, 0.01, 0.02, 0.05, 0.1, 0.2):
        if low[1] <= math.log(value) <= high[1]:
            y = place((costs[0], value))[1]
            out += [f'<line x1="{left}" x2="{width - right}" y1="{y:.1f}" y2="{y:.1f}" stroke="#e2e2e2"/>',
                    text(left - 6, y + 4, value, "end")]
    out += [text((left + width - right) / 2, height - 12, "cost of the shadows, ms (mean over the built-in scenes)"),
            text(18, (top + height - bottom) / 2, "RMSE of visibility", extra=f'transform="rotate(-90 18 {(top + height - bottom) / 2})"')]
    for name, color in zip(FILTERS, COLORS):
        places = [place(means[name, resolution]) for resolution in RESOLUTIONS]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
        out.append(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="1.5"/>')
        for resolution, (x, y) in zip(RESOLUTIONS, places):
            fill = color if (name, resolution) in pareto else "white"
            out.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{fill}" stroke="{color}" stroke-width="1.5"/>')
        y = top + 16 + 18 * FILTERS.index(name)
        out += [f'<circle cx="{width - right + 18}" cy="{y - 4}" r="4" fill="white" stroke="{color}" stroke-width="1.5"/>',
                text(width - right + 30, y, name, "start")]
    y = top + 16 + 18 * len(FILTERS) + 8
    out += [f'<circle cx="{width - right + 18}" cy="{y - 4}" r="4" fill="#222222"/>', text(width - right + 30, y, "Pareto set", "start")]
    return "\n".join(out + ["</svg>"]) + "\n"


def main():
    program = sys.argv[1]
    FILTERS.extend(filters_of(program))
    scenes, cells, means = scene_names(program), {}, {}
    for scene in scenes:
        for resolution in RESOLUTIONS:
            for name, cell in zip(FILTERS, measured(program, scene, resolution)):
                cells[scene, name, resolution] = cell
            print(f"{scene}, {resolution} texels", file=sys.stderr)
    for name in FILTERS:
        for resolution in RESOLUTIONS:
            own = [cells[scene, name, resolution] for scene in scenes]
            means[name, resolution] = (sum(c[0] for c in own) / len(own), sum(c[1] for c in own) / len(own))
    pareto = pareto_set(means)
    written = table(scenes, cells, means, pareto)
    print(written)
    for path, content in zip(sys.argv[2:], [written, chart(means, pareto)]):
        with open(path, "w", encoding="utf-8") as file:
            file.write(content)


if __name__ == "__main__":
    main()
