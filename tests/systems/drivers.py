#!/usr/bin/env python3
"""The program on every OpenGL driver that this machine has: Mesa's own on the processor, one of them as a context of exactly OpenGL
3.3, forward-compatible, and the graphics card's if there is one.

drivers.py BUILD_FOLDER [DRIVER...]    all drivers, or those named (`drivers.py --list` names them)
drivers.py --short BUILD_FOLDER        those that are quick, in small pictures; with SHADOWLAB_LONG all the same

On each: the tests that every technique has to pass, the errors of all techniques in three scenes, and a window where there is an X
server to be had (Xvfb). Prints what each driver is, what it counts, and where it differs from the first. Ends with 1 where a test
fails, where an exact technique is wrong, or where a driver that rounds as the first one does counts otherwise.

A driver that does not come up is said, with the reason."""
# SPDX-License-Identifier: MIT
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "window"))
from window_driver import Display  # noqa: E402

SCENES = ("still-life", "colonnade", "leafy")  # curved meshes; many casters; holes
COUNTS = ("falseLit", "falseShadow", "ties", "coreErrors")
EXACT = ("shadow-volume", "ray-traced")
# What every technique has to do, and what is asked of each draw call.
CONTRACT = "*Contract*:StrictDraws*"
BY_A_LEVEL = "by more than a level 0"  # what these tests say of pictures that should be the same bytes
VARIABLES = ("GALLIUM_DRIVER", "MESA_LOADER_DRIVER_OVERRIDE", "LIBGL_ALWAYS_SOFTWARE", "MESA_GL_VERSION_OVERRIDE",
             "MESA_GLSL_VERSION_OVERRIDE")
OVER_LIMIT = 6  # exit status: more than the driver, or the program, can hold
LONGEST = 3600  # seconds for one command; softpipe is slow
# With a rasteriser of its own a pixel beside an edge may fall to the other side; ties leave out most of these pixels, and what a
# technique gets wrong by itself stays: so much more, a share and a number of pixels, is another's rounding and no fault.
MORE_SHARE, MORE_PIXELS = 0.05, 5


class Driver:
    def __init__(self, name, renderer, rounds_as_first=False, off_by_level=False, quick=False, **environment):
        self.name, self.renderer, self.environment = name, renderer, environment
        self.rounds_as_first, self.off_by_level, self.quick = rounds_as_first, off_by_level, quick


DRIVERS = (
    Driver("llvmpipe", "llvmpipe", quick=True, GALLIUM_DRIVER="llvmpipe", LIBGL_ALWAYS_SOFTWARE="1"),
    # As macOS and strict drivers give it: nothing newer than what was asked for, and nothing deprecated.
    Driver("llvmpipe-3.3", "llvmpipe", rounds_as_first=True, quick=True, GALLIUM_DRIVER="llvmpipe", LIBGL_ALWAYS_SOFTWARE="1",
           MESA_GL_VERSION_OVERRIDE="3.3FC", MESA_GLSL_VERSION_OVERRIDE="330"),
    # The same triangles, after others were drawn or in a part of the picture, come out with other last bits.
    Driver("softpipe", "softpipe", off_by_level=True, GALLIUM_DRIVER="softpipe", LIBGL_ALWAYS_SOFTWARE="1"),
    # OpenGL by way of Vulkan; without a card by Mesa's Vulkan on the processor (mesa-vulkan-drivers).
    Driver("zink", "zink", MESA_LOADER_DRIVER_OVERRIDE="zink", LIBGL_ALWAYS_SOFTWARE="1"),
    Driver("card", None),
)


class Trial:
    """One driver: what it is, and what came of the commands."""

    def __init__(self, driver, build, folder, size):
        self.driver, self.build, self.folder, self.size = driver, build, Path(folder), size
        self.reason, self.version, self.renderer, self.limits = None, "", "", {}
        self.passed, self.failed, self.by_a_level, self.window = 0, [], [], "-"
        self.counts, self.refused = {}, {}
        self.environment = {name: value for name, value in os.environ.items() if name not in VARIABLES}
        self.environment.pop("DISPLAY", None)
        self.environment.pop("WAYLAND_DISPLAY", None)
        self.environment.update(driver.environment, XDG_RUNTIME_DIR=folder)  # Vulkan's loader asks for one

    def run(self, *words, **more):
        return subprocess.run([str(word) for word in words], cwd=self.folder, capture_output=True, text=True, errors="replace",
                              check=False, timeout=LONGEST, env={**self.environment, **more})

    def shadowlab(self, *words, **more):
        return self.run(self.build / "shadowlab", *words, **more)

    def comes_up(self):
        backends = {entry["name"]: entry for entry in json.loads(self.shadowlab("list", "backends", "--json").stdout)["backends"]}
        egl = backends["egl"]
        self.version, self.renderer = egl["version"], egl["renderer"]
        if not egl["available"]:
            self.reason = egl["reason"]
        elif self.driver.renderer is None and any(one.renderer and one.renderer in self.renderer for one in DRIVERS):
            self.reason = f"there is none; without one Mesa draws by {self.renderer}"
        elif self.driver.renderer and not self.renderer.startswith(self.driver.renderer):
            self.reason = f"it is not there; Mesa takes {self.renderer} in its place"
        if self.reason:
            return False
        listed = json.loads(self.shadowlab("list", "limits", "--json").stdout)["limits"]
        self.limits = {entry["limit"]: entry["value"] for entry in listed}
        return True

    def contract(self):
        report = self.folder / "tests.json"
        ran = self.run(self.build / "tests" / "gl_tests", f"--gtest_filter={CONTRACT}", f"--gtest_output=json:{report}")
        if not report.exists():
            self.failed.append(f"gl_tests ended with {ran.returncode}: {ran.stdout[-500:]}{ran.stderr[-500:]}")
            return
        for suite in json.loads(report.read_text())["testsuites"]:
            for test in suite["testsuite"]:
                if self.driver.off_by_level and all(BY_A_LEVEL in one["failure"] for one in test.get("failures", [{"failure": ""}])):
                    self.by_a_level.append(f"{suite['name']}.{test['name']}")
                elif "failures" in test:
                    self.failed.append(f"{suite['name']}.{test['name']}: {test['failures'][0]['failure'].splitlines()[0:6]}")
                elif test.get("result") == "COMPLETED":
                    self.passed += 1

    def measure(self, scene, techniques):
        """Of all techniques at once; of each by itself where one wants more than this driver has."""
        ran = self.shadowlab("measure", scene, "-t", ",".join(techniques), "--size", self.size, "--json")
        if ran.returncode == 0:
            for result in json.loads(ran.stdout)["results"]:
                self.counts[scene, result["technique"]] = tuple(result[count] for count in COUNTS)
        elif ran.returncode == OVER_LIMIT and len(techniques) > 1:
            for technique in techniques:
                self.measure(scene, [technique])
        elif ran.returncode == OVER_LIMIT:
            self.refused[scene, techniques[0]] = ran.stderr.strip().splitlines()[-1]
        else:
            self.failed.append(f"measure {scene} -t {','.join(techniques)} ended with {ran.returncode}: {ran.stderr.strip()[-300:]}")

    def in_window(self, display):
        """The same picture through a window's context as through EGL's, and the window itself until its first picture."""
        pictures = []
        for backend in ("egl", "window"):
            path = self.folder / f"{backend}.png"
            words = ("capture", "still-life", "-t", "shadow-map,shadow-volume", "--size", "320x180", "--backend", backend, "-o", path)
            ran = self.shadowlab(*words, DISPLAY=display.name)
            if ran.returncode:
                self.window = f"no: {ran.stderr.strip().splitlines()[-1]}"
                return
            pictures.append(path.read_bytes())
        process = subprocess.Popen([self.build / "shadowlab", "demo", "still-life", "--report"], cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                   env={**self.environment, "DISPLAY": display.name, "XDG_CONFIG_HOME": str(self.folder)})
        first = process.stdout.readline()
        process.terminate()
        process.communicate()
        self.window = ("opens" if first.startswith("{") else "gives no picture") + \
            ("" if pictures[0] == pictures[1] else ", other bytes than egl")
        if self.window != "opens":
            self.failed.append(f"window: {self.window}")


def complaints_about(trial, first):
    """What a driver gets wrong, held against the first one."""
    for (scene, technique), counts in trial.counts.items():
        here = dict(zip(COUNTS, counts))
        what = f"{scene}, {technique}: {here}"
        if technique in EXACT and (here["falseLit"] or here["falseShadow"]):
            yield f"{what}: an exact technique is wrong"
        there = first.counts.get((scene, technique))
        if there is None or trial is first:
            continue
        if trial.driver.rounds_as_first and counts != there:
            yield f"{what}, and {first.driver.name} {dict(zip(COUNTS, there))}: the same rasteriser counts otherwise"
        for name, number, before in zip(COUNTS, counts, there):
            if name != "ties" and number > before * (1 + MORE_SHARE) + MORE_PIXELS:
                yield f"{what}: {name} is {number}, by {first.driver.name} {before}"


def aligned(rows):
    widths = [max(map(len, column)) for column in zip(*rows)]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows)


def tables(trials, techniques):
    up = [trial for trial in trials if not trial.reason]
    rows = [("driver", "OpenGL", "renderer", "sub-pixel bits", "buffer texels", "tests passed", "failed", "window")]
    rows += [(trial.driver.name, trial.version, trial.renderer, trial.limits["driver-sub-pixel"], trial.limits["driver-buffer-texture"],
              str(trial.passed), str(len(trial.failed)), trial.window) for trial in up]
    yield aligned(rows)
    rows = [("false lit / false shadow / ties / core", *(trial.driver.name for trial in up))]
    for scene in SCENES:
        for technique in techniques:
            cells = []
            for trial in up:
                counts = trial.counts.get((scene, technique))
                same = trial is not up[0] and counts == up[0].counts.get((scene, technique))
                cells.append("same" if counts and same else " / ".join(map(str, counts)) if counts else "refused")
            rows.append((f"{scene}, {technique}", *cells))
    yield aligned(rows)


def main():
    arguments = sys.argv[1:]
    if arguments == ["--list"]:
        print("\n".join(driver.name for driver in DRIVERS))
        return 0
    short = "--short" in arguments and not os.environ.get("SHADOWLAB_LONG")
    words = [argument for argument in arguments if argument != "--short"]
    if words and words[0] in ("-h", "--help"):
        print(__doc__)
        return 0
    if not words or words[0].startswith("-"):
        sys.exit(__doc__)
    build, names = Path(words[0]).resolve(), words[1:]
    if not ((build / "shadowlab").is_file() and (build / "tests" / "gl_tests").is_file()):
        sys.exit(f"drivers: {build} holds no program with its tests; name a build folder, as build/release, after ./check has made it")
    unknown = [name for name in names if name not in [driver.name for driver in DRIVERS]]
    if unknown:
        sys.exit(f"drivers: '{unknown[0]}' is no driver that is known; --list prints their names")
    size = "160x90" if short else "320x180"
    chosen = [driver for driver in DRIVERS if (driver.name in names if names else driver.quick or not short)]
    trials, wrong, techniques = [], 0, []
    with tempfile.TemporaryDirectory() as folder:
        for driver in chosen:
            own = Path(folder, driver.name)
            own.mkdir(mode=0o700)
            trial = Trial(driver, build, str(own), size)
            trials.append(trial)
            if not trial.comes_up():
                print(f"{driver.name}: not tried: {trial.reason}", flush=True)
                continue
            if not techniques:
                listed = json.loads(trial.shadowlab("list", "techniques", "--json").stdout)["techniques"]
                techniques = [entry["id"] for entry in listed if entry["group"] == "production"]
            if trials[0] is not trial or not short:  # the first one's tests are a part of gl_tests
                trial.contract()
            for scene in SCENES:
                trial.measure(scene, techniques)
            if not short and shutil.which("Xvfb"):
                with Display("640x480") as display:
                    trial.in_window(display)
    first = next((trial for trial in trials if not trial.reason), None)
    if first is None:
        sys.exit("drivers: none of those that were asked for is here" if names else "drivers: there is no driver; apt install libgl1-mesa-dri")
    for table in tables(trials, techniques):
        print("\n" + table)
    print()
    for trial in trials:
        for key, line in trial.refused.items():
            print(f"{trial.driver.name}: {', '.join(key)}: {line}")
        for test in trial.by_a_level:
            print(f"{trial.driver.name}: {test}: bytes differ, none by more than one level of 255")
        for complaint in [*trial.failed, *complaints_about(trial, first)]:
            print(f"{trial.driver.name}: FAILED: {complaint}")
            wrong += 1
    print(f"drivers: {sum(not trial.reason for trial in trials)} drivers at {size}, {wrong} faults")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
