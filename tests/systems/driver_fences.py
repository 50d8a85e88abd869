#!/usr/bin/env python3
"""llvmpipe's threads never touch a fence that has been freed, however late the scheduler wakes them.

usage: driver_fences.py BUILD_FOLDER
"""
# SPDX-License-Identifier: MIT
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

FEWEST_SIGNALS = 100
SKIPPED = 77


def main() -> int:
    build = Path(sys.argv[1]).resolve()
    # Not so kept, fences of maps were freed in every one of these runs.
    environment = {**os.environ, "LD_PRELOAD": str(build / "tests" / "libslow_signals.so"), "MALLOC_PERTURB_": "90"}
    with tempfile.TemporaryDirectory() as folder:
        for technique in ("shadow-map", "shadow-volume"):
            run = subprocess.run([build / "shadowlab", "capture", "colonnade", "-t", technique, "--software", "--size", "160x90", "--animate",
                                  "--frames", "24", "--orbit-light", "1", "-o", "film.png"],
                                 cwd=folder, env=environment, capture_output=True, text=True, timeout=300)
            counts = re.search(r"signals (\d+), freed (\d+)", run.stderr)
            if run.returncode or not counts:
                print(f"{technique}: status {run.returncode}: {run.stderr}")
                return 1
            signals, freed = map(int, counts.groups())
            print(f"{technique}: {signals} signals, {freed} of them of freed fences")
            if signals == 0:
                print("this driver wakes who waits in another way")
                return SKIPPED
            if freed or signals < FEWEST_SIGNALS:
                return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
