#!/usr/bin/env python3
"""Every Debian of today, tried from nothing: a system that debootstrap makes, with nothing but git, and in it a clone of this checkout.

    systems.py [--systems FOLDER] [--tests all|none] [--keep] [RELEASE...]   RELEASE: bookworm, trixie, sid; without one, all three

Root makes the systems, once, in FOLDER (build/systems); a copy of each is used and, without --keep, thrown away. What its tests said is
kept as FOLDER/RELEASE-tests.log. In the copy runs what README tells a new user, `./demo`; then `list backends`, `measure -t all` of three
scenes, and all tests: first without a display, those that need a window with an X server of their own (Xvfb), then the ones of the
window's context under Xvfb. Printed are the figures of the first two tables of docs/systems.md. Ends with 1 where something did not work.
Some 25 minutes for a release on two cores, most of it for the tests."""
# SPDX-License-Identifier: MIT
import argparse
import json
import os
import re
import resource
import shutil
import subprocess
import sys
import time
from pathlib import Path

from places import CleanSystem, Failed, expect

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests" / "building"))
from build_time import SMALL  # noqa: E402

RELEASES = ("bookworm", "trixie", "sid")
SCENES = ("still-life", "colonnade", "leafy")
SIZE = "640x360"
HOUR = 3600  # seconds; longer than any step, also where three releases share two cores
NEEDS_DISPLAY = "Context*:SameBytes*"  # tests that say why they skip where there is no display
BUILT_IN = "release"


def pristine(folder, release):
    """The system as debootstrap leaves it. One that was interrupted is made again."""
    system = folder / release
    if not (system / "made").exists():
        expect(shutil.which("debootstrap"), "debootstrap makes the systems, and is not here; apt install debootstrap")
        subprocess.run(["rm", "-rf", system], check=True)
        folder.mkdir(parents=True, exist_ok=True)
        log = folder / f"{release}.log"
        with log.open("w") as out:
            made = subprocess.run(["debootstrap", "--variant=minbase", "--include=ca-certificates,git", release, system], stdout=out,
                                  stderr=out, check=False)
        expect(made.returncode == 0, f"debootstrap could not make {release}: see {log}")
        (system / "made").touch()
    return system


class Trial:
    """What a new user does, in one system."""

    def __init__(self, system):
        self.system = system
        self.checkout = system.inside / "shadowlab"
        self.row = {}

    def shell(self, line, **settings):
        return self.system.as_root("bash", "-c", f"cd {self.checkout} && {line}", limit=HOUR, **settings)

    def timed(self, line):
        """Seconds of a clock, and of processors: of all that the line started."""
        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
        out = self.shell(line)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return out, time.monotonic() - start, used

    def clone(self):
        # A bundle: the checkout itself cannot be seen from inside.
        bundle = self.system.home / "checkout.bundle"
        subprocess.run(["git", "-c", "safe.directory=*", "-C", ROOT, "bundle", "create", "-q", bundle, "HEAD"], check=True)
        self.system.as_root("git", "clone", "-q", self.system.inside / "checkout.bundle", self.checkout)
        packages = "root=$PWD log=/tmp/log && . .ci/packages.sh && install_missing"
        self.shell(f'{packages} "${{build_packages[@]}}"')
        return f'{packages} "${{test_packages[@]}}"'

    def demo(self):
        out, seconds, used = self.timed("./demo")
        picture = out.split()[-1]
        expect((self.system.root / picture.lstrip("/")).read_bytes()[:4] == b"\x89PNG", f"{picture} is no picture")
        backends = {one["name"]: one for one in json.loads(self.shell(f"build/{BUILT_IN}/shadowlab list backends --json"))["backends"]}
        version = backends["egl"].get("version", "") or ""
        self.row.update({
            "system": self.shell(". /etc/os-release; echo $PRETTY_NAME").strip(),
            "Mesa": (re.search(r"Mesa (\S+)", version) or [None, "?"])[1],
            "compiler": "g++ " + self.shell("g++ -dumpfullversion").strip(),
            "EGL": "yes" if backends["egl"]["available"] else "no",
            "OSMesa": "yes" if backends["osmesa"]["available"] else "has none",
            "demo": f"{seconds:.0f} s", "processor": f"{used:.0f} s", "small file": f"{self.small_file():.1f} s"})

    def small_file(self):
        """Processor seconds that the system's compiler takes for the small file beside which build times are told: median of five."""
        (self.system.root / "tmp" / "small.cpp").write_text(SMALL)
        return sorted(self.timed("g++ -O2 -std=c++20 -c /tmp/small.cpp -o /tmp/small.o")[2] for _ in range(5))[2]

    def errors(self):
        counts = {}
        for scene in SCENES:
            measured = json.loads(self.shell(f"build/{BUILT_IN}/shadowlab measure {scene} -t all --size {SIZE} --json"))
            for result in measured["results"]:
                counts[scene, result["technique"]] = (result["falseLit"], result["falseShadow"], result["ties"])
        expect(len(counts) >= 8 * len(SCENES), f"only {len(counts)} techniques were measured")
        return counts

    def tests(self, install, log):
        self.shell(install)
        self.shell(f"cmake --preset {BUILT_IN} >/tmp/log && ninja -C build/{BUILT_IN} >/tmp/log")
        self.system.alone = True
        out = self.shell(f"ctest --test-dir build/{BUILT_IN} -j 2 --no-tests=error --output-on-failure || true")
        log.write_text(out)
        told = re.search(r"tests passed, (\d+) tests failed out of (\d+)", out)
        expect(told, "ctest did not come to its end:\n" + out[-2000:])
        failed = re.findall(r"^\s*\d+ - (\S+) \((?!Skipped)", out, re.M)
        window = self.shell(f"xvfb-run -a -s '-screen 0 1280x1024x24 -noreset' build/{BUILT_IN}/tests/gl_tests --gtest_brief=1 "
                            f"--gtest_filter='{NEEDS_DISPLAY}' 2>&1 || true")
        passed = re.search(r"\[  PASSED  \] (\d+) tests", window)
        with log.open("a") as end:
            end.write(window)
        self.row["tests"] = f"{int(told[2]) - int(told[1])} of {told[2]}" + (f" (not {', '.join(failed)})" if failed else "")
        self.row["under Xvfb"] = f"{passed[1] if passed else 0} passed" + (", some failed" if "FAILED" in window else "")
        return not failed and bool(passed) and "FAILED" not in window


def print_tables(rows, errors):
    columns = list(dict.fromkeys(column for row in rows for column in row))
    print(f"| {' | '.join(columns)} |\n|{'---|' * len(columns)}")
    for row in rows:
        print(f"| {' | '.join(row.get(column, '') for column in columns)} |")
    if not errors:
        return
    names, kinds = list(errors), list(next(iter(errors.values())))
    print(f"\n| false lit / false shadow / ties | {' | '.join(names)} |\n|{'---|' * (len(names) + 1)}")
    for kind in kinds:
        told = [" / ".join(map(str, errors[name].get(kind, ("?",)))) for name in names]
        print(f"| {', '.join(kind)} | {' | '.join(['the same' if i and one == told[0] else one for i, one in enumerate(told)])} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--systems", type=Path, default=ROOT / "build" / "systems", metavar="FOLDER", help="where the systems are kept")
    parser.add_argument("--tests", choices=("all", "none"), default="all")
    parser.add_argument("--keep", action="store_true", help="leave the copies, to look into what failed")
    parser.add_argument("releases", nargs="*", metavar="RELEASE")
    chosen = parser.parse_args()
    if os.geteuid() != 0:
        sys.exit("systems.py: only root can make systems and enter them; run it as root")
    for release in chosen.releases:
        if release not in RELEASES:
            sys.exit(f"systems.py: '{release}' is no release that is tried; choose from {', '.join(RELEASES)}")
    rows, errors, worked = [], {}, True
    for release in chosen.releases or RELEASES:
        trial = None
        try:
            with CleanSystem(pristine(chosen.systems, release), keep=chosen.keep) as system:
                trial = Trial(system)
                install_tests = trial.clone()
                trial.demo()
                errors[release] = trial.errors()
                if chosen.tests == "all":
                    worked &= trial.tests(install_tests, chosen.systems / f"{release}-tests.log")
        except Failed as what:
            print(f"systems.py: {release}: {what}", file=sys.stderr)
            worked = False
        rows.append({"release": release, **(trial.row if trial else {})})
        print(f"systems.py: {rows[-1]}", file=sys.stderr)
    print_tables(rows, errors)
    sys.exit(0 if worked else 1)


if __name__ == "__main__":
    main()
