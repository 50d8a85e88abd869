#!/usr/bin/env python3
"""How long the project takes to build, in seconds of processors: beside those of a small file, which tell how fast the machine is just
now, so that a slow hour does not count.

    build_time.py [--whole] [BUILD]          BUILD: a folder for it, emptied before (build/timed)

Builds the program from nothing; with --whole also the tests. Then touches one source file of a technique, and the contract of all
techniques, and says how long it takes to a new program each time. Packages have to be there (./demo installs them), and no compiler
cache may be in the way."""
# SPDX-License-Identifier: MIT
import argparse
import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SMALL = """#include <map>
#include <random>
#include <regex>
int main() {
    std::mt19937 numbers(1);
    std::map<int, double> found;
    found[static_cast<int>(numbers())] = 1;
    return static_cast<int>(found.size()) + std::regex_match("aab", std::regex("a+b"));
}
"""
TECHNIQUE, CONTRACT = "techniques/shadow_map/technique.cpp", "techniques/technique.h"


def used(words):
    """Seconds of processors, of them in the compiler and not in the kernel, and of a clock."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    ran = subprocess.run(words, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    seconds, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    if ran.returncode != 0:
        sys.exit(ran.stdout[-3000:] + f"\nbuild_time: {' '.join(map(str, words))} failed")
    user = after.ru_utime - before.ru_utime
    return user + after.ru_stime - before.ru_stime, user, seconds


def small_file():
    """The median of five: of the compiler alone, as for all that is told beside it."""
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "small.cpp"
        source.write_text(SMALL)
        times = sorted(used(["g++", "-O2", "-std=c++20", "-c", source, "-o", Path(folder) / "small.o"])[1] for _ in range(5))
    return times[2]


def tell(what, words):
    processors, user, seconds = used(words)
    print(f"{what:<44} {processors:7.1f} s of processors ({user:.1f} of them in the compilers), {seconds:6.1f} s of the clock", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--whole", action="store_true", help="the tests as well")
    parser.add_argument("build", nargs="?", type=Path, default=ROOT / "build" / "timed", metavar="BUILD")
    chosen = parser.parse_args()
    chosen.build = chosen.build.resolve()
    cache = chosen.build / "CMakeCache.txt"
    if chosen.build.exists() and not (cache.is_file() and f"CMAKE_HOME_DIRECTORY:INTERNAL={ROOT}\n" in cache.read_text()):
        sys.exit(f"build_time: {chosen.build} is there, and is no build of this checkout; name a folder that is not there yet")
    shutil.rmtree(chosen.build, ignore_errors=True)
    ninja = ["ninja", "-C", chosen.build, "-j", str(os.cpu_count())]
    print(f"{'a small file, before':<44} {small_file():7.2f} s", flush=True)
    tell("configure", ["cmake", "--preset", "release", "-B", chosen.build])
    tell("the program, from nothing", [*ninja, "shadowlab"])
    if chosen.whole:
        tell("the tests", ninja)
    print(f"{'a small file, after':<44} {small_file():7.2f} s", flush=True)
    for touched in (TECHNIQUE, CONTRACT):
        (ROOT / touched).touch()
        tell(f"the program, {touched} touched", [*ninja, "shadowlab"])


if __name__ == "__main__":
    main()
