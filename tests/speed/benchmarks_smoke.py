#!/usr/bin/env python3
"""benchmarks_smoke.py PROGRAM

Runs every benchmark once, at its smallest size, and shows what fails. How fast it is, is not asked. Exits with 77, which CTest
takes for "skipped", where the program is not built: it is built on demand."""
# SPDX-License-Identifier: MIT
import json
import os
import re
import subprocess
import sys

# There are some 70; of fewer than these, registering has gone wrong.
LEAST = 60


def smallest_of_each(names):
    """The name with the smallest size, the last number in it, of those that are else the same."""
    smallest = {}
    for name in names:
        match = re.fullmatch(r"(.*)/(\d+)((?:/real_time)?)", name)
        if not match:
            raise SystemExit(f"benchmark '{name}' has no size at its end: what should its time grow with?")
        family, size = match[1] + match[3], int(match[2])
        if family not in smallest or size < smallest[family][0]:
            smallest[family] = (size, name)
    return sorted(name for _, name in smallest.values())


def main(program):
    if not os.path.exists(program):
        print(f"{program} is not built: nothing to try")
        return 77
    listed = subprocess.run([program, "--benchmark_list_tests"], capture_output=True, text=True, check=True)
    wanted = smallest_of_each(listed.stdout.split())
    if len(wanted) < LEAST:
        print(f"{len(wanted)} benchmarks: there should be {LEAST} at least")
        return 1
    # The least time there is: once around each loop, or a little more often.
    run = subprocess.run([program, "--benchmark_min_time=0.0001", "--benchmark_format=json",
                          "--benchmark_filter=^(" + "|".join(wanted) + ")$"],
                         capture_output=True, text=True)
    if run.returncode != 0:
        print(f"exit status {run.returncode}\n{run.stderr}")
        return 1
    results = [b for b in json.loads(run.stdout)["benchmarks"] if b["run_type"] == "iteration"]
    faults = [f"{b['name']}: {b.get('error_message', 'no time was measured')}" for b in results
              if b.get("error_occurred") or not b.get("real_time", 0) > 0]
    faults += [f"{name}: did not run" for name in wanted if name not in {b["name"] for b in results}]
    print("\n".join(faults) if faults else f"{len(results)} benchmarks ran")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
