#!/usr/bin/env python3
"""The same bytes wherever and however a command runs: any number of threads, locale, time zone, folder, umask, home, and all three
kinds of graphics context. same_bytes.py BUILD_FOLDER

Pictures and visibility of every registered technique, the numbers of `measure` (its times apart), a diagram, a slide, and lists.
The locale with a decimal comma is made by localedef, and forced on the program as a library might do it. Without that program
(Debian's package locales) a line says so. With SHADOWLAB_LONG all variations for each technique; without, each for one of them."""
# SPDX-License-Identifier: MIT
import hashlib
import json
import os
import shutil
import stat
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import outputs

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "window"))
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))
from osmesa import WITHOUT, may_lack_osmesa  # noqa: E402
from window_driver import Display  # noqa: E402

LONG = bool(os.environ.get("SHADOWLAB_LONG"))
SCENE = """{"camera": {"position": [-3, 2.5, 4], "target": [0, 0.5, 0]}, "ambient": [0.05, 0.05, 0.05],
"lights": [{"name": "key", "type": "point", "position": [2, 5, 3], "intensity": 40},
           {"name": "panel", "type": "rect", "position": [0, 4, 0], "edgeU": [1, 0, 0], "edgeV": [0, 0, 1], "intensity": 3}],
"objects": [{"shape": "quad", "size": [6, 6]}, {"shape": "box", "size": [1, 1, 1], "translate": [0, 0.5, 0]},
            {"shape": "torus", "radii": [0.6, 0.2], "segments": [16, 8], "translate": [1.2, 0.9, 0.8], "rotateDegrees": [70, 0, 20]}]}
"""
OWN = ("ms", "truthMs", "backend")  # of a run of `measure`: what it may not share with another


def without_own(value):
    if isinstance(value, dict):
        return {key: without_own(inner) for key, inner in value.items() if key not in OWN}
    return [without_own(inner) for inner in value] if isinstance(value, list) else value


class Runner:
    def __init__(self, build, place):
        self.program, self.comma, self.place = build / "shadowlab", build / "tests" / "libcomma_locale.so", Path(place)
        (self.place / "scene.json").write_text(SCENE)
        outputs.write_inputs(self.place)
        self.numbers = iter(range(10 ** 9))

    def digest(self, words, changes=None, folder=None, umask=0o022, more=()):
        """Of all that a command writes and says. OUT in its words stands for a folder of its own."""
        changes = dict(changes or {})
        out = self.place / f"out{next(self.numbers)}"
        out.mkdir(mode=0o755)
        words = [word.replace("OUT", str(out)).replace("IN", str(self.place)) for word in words]
        words += more
        environment = {**os.environ}
        for name, value in changes.items():
            environment[name] = value
            if value is None:
                del environment[name]
        run = subprocess.run([self.program, *words], cwd=folder or self.place, env=environment, capture_output=True, umask=umask,
                             timeout=600)
        assert run.returncode == 0, f"{words} with {changes}: {run.stderr}"
        said = run.stdout.replace(str(out).encode(), b"OUT")
        if "--json" in words:
            said = json.dumps(without_own(json.loads(said))).encode()
        written = outputs.contents(out)
        for path in out.rglob("*"):
            mode, most = stat.S_IMODE(path.stat().st_mode), 0o777 if path.is_dir() else 0o666
            assert mode == most & ~umask, f"{words}: {path.name} has the mode {mode:o} under the umask {umask:o}"
        assert said or written, f"{words} makes nothing"
        shutil.rmtree(out)
        return hashlib.sha256(repr((said, sorted(written.items()))).encode()).hexdigest()


def comma_locale(place):
    """The environment of a locale with a decimal comma; none where it cannot be made."""
    if not shutil.which("localedef"):
        return None
    made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", str(place / "de_DE.UTF-8")], capture_output=True, text=True)
    if not (place / "de_DE.UTF-8").is_dir():
        print(made.stderr)
        return None
    return {"LOCPATH": str(place), "LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"}


def variations(runner, display):
    elsewhere = runner.place / "else where"
    elsewhere.mkdir()
    yield "again", {}
    for threads in (1, 2, 4, 16):
        yield f"{threads} threads", {"changes": {"SHADOWLAB_THREADS": str(threads)}}
        yield f"{threads} threads of the rasteriser", {"changes": {"LP_NUM_THREADS": str(threads)}}
    yield "another time zone", {"changes": {"TZ": "Pacific/Chatham"}}
    yield "another folder", {"folder": elsewhere}
    yield "a narrow umask", {"umask": 0o077}
    yield "a wide umask", {"umask": 0o000}
    yield "no home", {"changes": {"HOME": None, "XDG_CONFIG_HOME": None, "XDG_CACHE_HOME": None}}
    yield "no such home", {"changes": {"HOME": "/none"}}
    comma = comma_locale(runner.place)
    if comma:
        yield "a locale with commas", {"changes": comma}
        yield "that locale taken over", {"changes": {**comma, "LD_PRELOAD": str(runner.comma)}}
    else:
        print("no locale with a decimal comma: install the package locales")
    if may_lack_osmesa(runner.program):
        print(WITHOUT)
    else:
        yield "context osmesa", {"more": ["--backend", "osmesa"]}
    yield "context egl", {"more": ["--backend", "egl"]}
    yield "context window", {"more": ["--backend", "window"], "changes": {"DISPLAY": display.name}}
    yield "context by --software", {"more": ["--software"]}


def commands(program):
    """Names, and words; all that draw take --backend."""
    listed = subprocess.run([program, "list", "techniques", "--json"], capture_output=True, check=True).stdout
    techniques = [row["id"] for row in json.loads(listed)["techniques"] if row["group"] == "production"]
    for technique in techniques:
        words = ["capture", "IN/scene.json", "-t", technique, "--size", "64x48"]
        yield f"picture by {technique}", [*words, "-o", "OUT/x.png"]
        yield f"visibility by {technique}", [*words, "-o", "OUT/v.png", "--stage", "visibility", "--light", "key"]
        yield f"measure {technique}", ["measure", "IN/scene.json", "-t", technique, "--size", "64x48", "--json"]
    yield "legend and labels", ["capture", "IN/scene.json", "-t", "shadow-map,shadow-volume", "--layout", "diff", "--size", "640x360", "-o", "OUT/x.png"]
    yield "film", ["capture", "IN/scene.json", "--size", "64x48", "--frames", "3", "--orbit-light", "90", "--animate", "-o", "OUT/x.png"]
    yield "slides", ["slides", "IN/deck.json", "--size", "640x360", "--supersample", "1", "-o", "OUT"]
    yield "lesson", ["lesson", "acne", "-o", "OUT/l.png"]


# None of these draws.
LISTS = [("diagram", ["probe", "IN/scene.json", "--pixel", "30,24", "--size", "64x48", "-t", "shadow-map", "--diagram", "OUT/d.svg"]),
         ("parameters", ["list", "parameters"]), ("limits", ["list", "limits"]), ("inspection", ["inspect", "IN/scene.json"])]


def chosen(works, ways):
    """Every work in every way; in the short form each way for one technique's picture, visibility and numbers, in turn, and those ways
    for all other works that change how numbers are written, or what draws."""
    if LONG:
        return [(work, way) for work in works for way in ways]
    pairs = []
    techniques = [work for work in works if " by " in work[0] or work[0].startswith("measure")]
    for i, way in enumerate(ways):
        pairs += [(techniques[(i * 7 + j * 5) % len(techniques)], way) for j in range(4)]
        if "comma" in way[0] or "locale" in way[0] or way[0].startswith("context"):
            pairs += [(work, way) for work in works if work not in techniques]
    return pairs


def main(build):
    with tempfile.TemporaryDirectory() as place, Display() as display, ThreadPoolExecutor(os.cpu_count()) as pool:
        runner = Runner(build, place)
        works = list(commands(runner.program))
        ways = list(variations(runner, display))
        pairs = chosen(works, ways) + [(work, way) for work in LISTS for way in ways if not way[0].startswith("context")]
        used = {name: words for (name, words), _ in pairs}
        expected = dict(zip(used, pool.map(runner.digest, used.values())))
        found = list(pool.map(lambda pair: runner.digest(pair[0][1], **pair[1][1]), pairs))
    differ = [f"{name}: other bytes with {way}" for ((name, _), (way, _)), digest in zip(pairs, found) if digest != expected[name]]
    print("\n".join(differ))
    print(f"{len(used)} commands, {len(ways)} ways to run them, {len(pairs)} comparisons, {len(differ)} differ")
    return 1 if differ or len(used) < 20 or len(pairs) < 100 else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
