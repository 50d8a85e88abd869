#!/usr/bin/env python3
"""./demo and ./check in a checkout that cannot be written say so in one line, and repeat neither bash nor a log of long ago; ./check
refuses words that it does not know before it does anything; and packages are missing where apt says so."""
# SPDX-License-Identifier: MIT
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


# What is in the way. Permissions would not stop root, a folder in place of a file stops everybody.
def build_is_a_file(build, script):
    build.write_text("")
    return build


def lock_is_a_folder(build, script):
    (build / ".lock").mkdir(parents=True)
    (build / f"{script}.log").write_text("ninja: no work to do.\n")
    return build / ".lock"


def log_is_a_folder(build, script):
    (build / f"{script}.log").mkdir(parents=True)
    return build / f"{script}.log"


def build_belongs_to_another(build, script):
    build.mkdir()
    (build / f"{script}.log").write_text("ninja: no work to do.\n")
    build.chmod(0o555)
    return build / ".lock"


def complaints_about(script, obstacle):
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder).resolve()
        shutil.copytree(ROOT / ".ci", root / ".ci")
        shutil.copy(ROOT / script, root / script)
        place = obstacle(root / "build", script)
        result = subprocess.run([root / script], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        lines = (result.stdout + result.stderr).splitlines()
        if (root / "build").is_dir():
            (root / "build").chmod(0o755)
        if result.returncode != 1 or len(lines) != 1 or not lines[0].startswith(f"{script}: {place} cannot be "):
            yield f"./{script}, {obstacle.__name__}: exit status {result.returncode}, {lines}"


def complaints_about_words(words):
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder).resolve()
        shutil.copytree(ROOT / ".ci", root / ".ci")
        shutil.copy(ROOT / "check", root / "check")
        result = subprocess.run([root / "check", *words], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        lines = (result.stdout + result.stderr).splitlines()
        if result.returncode != 2 or len(lines) != 1 or not lines[0].startswith("check: '") or (root / "build").exists():
            yield f"./check {words}: exit status {result.returncode}, {lines}"


def complaints_about_packages():
    """Which packages are missing, asked of an apt that has much to say: one with a candidate, one without, and one of two names."""
    with tempfile.TemporaryDirectory() as folder:
        apt, dpkg = Path(folder) / "apt-cache", Path(folder) / "dpkg-query"
        apt.write_text('#!/bin/sh\necho "$2:"; echo "  Installed: (none)"\n'
                       'case $2 in offered*) echo "  Candidate: 1.0" ;; *) echo "  Candidate: (none)" ;; esac\n'
                       'i=0; while [ $i -lt 5000 ]; do echo "     1.0 500" || exit 1; i=$((i + 1)); done\n')
        dpkg.write_text("#!/bin/sh\nexit 1\n")
        for program in (apt, dpkg):
            program.chmod(0o755)
        asked = "missing_of offered 'offered-if-there-is|' 'ended|' 'ended|offered-instead' needed"
        lines = subprocess.run(["bash", "-euo", "pipefail", "-c", f"PATH={folder}:$PATH; . {ROOT}/.ci/packages.sh; {asked}"],
                               capture_output=True, text=True, check=False).stdout.split()
        if lines != ["offered", "offered-if-there-is", "offered-instead", "needed"]:
            yield f".ci/packages.sh, {asked}: {lines}"


def main():
    unknown = [["--short"], ["tests"], ["--long", "test"], ["--long", ""], ["--long", "tests", "--quick"], ["-h", "-h"]]
    obstacles = [build_is_a_file, lock_is_a_folder, log_is_a_folder]
    if os.geteuid() != 0:
        obstacles.append(build_belongs_to_another)
    complaints = [c for script in ("demo", "check") for obstacle in obstacles for c in complaints_about(script, obstacle)]
    complaints += [c for words in unknown for c in complaints_about_words(words)]
    complaints += complaints_about_packages()
    print("\n".join(complaints) or f"{len(obstacles)} obstacles and {len(unknown)} unknown words, each told in one line")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
