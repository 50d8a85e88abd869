#!/usr/bin/env python3
"""Walks through every call by which the program changes a folder, lets it fail in each way it can, and kills the program there.
fault_walk.py BUILD_FOLDER

Afterwards every file is the old one or the new one whole, and nothing else is there; the program says so with status 0, or with
status 4 and one line. Interrupted calls and short writes are no faults: all is written. What a killed run leaves behind, the next
run sweeps up. At last a careless writer is walked through, in which faults have to be found.

With SHADOWLAB_LONG every kind of output and every fault; without, three kinds and one fault of each sort."""
# SPDX-License-Identifier: MIT
import errno
import os
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import outputs

LONG = bool(os.environ.get("SHADOWLAB_LONG"))
ALL = {"open-new": "EACCES ENOSPC EIO EMFILE EINTR", "open": "EACCES EMFILE EINTR", "write": "ENOSPC EIO EDQUOT EINTR short half-kill",
       "fsync": "EIO ENOSPC EINTR", "fsync-folder": "EIO EINTR", "close": "EIO EINTR", "rename": "EACCES EIO ENOSPC EINTR",
       "unlink": "EACCES EIO EINTR", "mkdir": "EACCES ENOSPC EIO EINTR", "fchmod": "EPERM EINTR", "flock": "ENOLCK EINTR"}
ONE_EACH = {"open-new": "EACCES EINTR", "write": "ENOSPC short half-kill", "fsync": "EIO EINTR", "close": "EIO", "rename": "EACCES EINTR",
            "unlink": "EIO", "mkdir": "ENOSPC EINTR"}
REFUSED = {"open-new", "write", "fsync", "rename", "mkdir"}  # a fault in these, which no one could pass over
LEAST_POINTS = 1500 if LONG else 100  # there are many more of each


class Walk:
    """All faults of one kind of output."""

    def __init__(self, output, build, place):
        self.output, self.place = output, place
        self.programs = {"shadowlab": build / "shadowlab", "writer_trial": build / "tests" / "writer_trial"}
        self.library = build / "tests" / "libfailing_calls.so"
        self.before = place / "before"
        outputs.write_inputs(place)
        outputs.fill(output, self.before, place, self.programs)
        self.old = outputs.contents(self.before)
        self.numbers = iter(range(10 ** 9))
        self.calls, self.new, changing = [], {}, {}
        for _ in range(2):  # what differs between two runs was measured
            folder, run = self.run("", 0)
            assert run.returncode == 0, f"{output.name}: {run.stderr}"
            changing, self.new = self.new, outputs.contents(folder)
            self.calls = Path(f"{folder}.log").read_text().split()
        assert changing.keys() == self.new.keys()
        self.measured = {name for name, data in self.new.items() if changing[name] != data}

    def command(self, folder):
        return [self.programs[self.output.program], *(word.replace("FOLDER", str(folder)) for word in self.output.words)]

    def run(self, how, at, folder=None):
        if folder is None:
            folder = self.place / str(next(self.numbers))
            shutil.copytree(self.before, folder)
        environment = {**os.environ, "FAULT_FOLDER": str(folder), "FAULT_LOG": f"{folder}.log", "FAULT_HOW": how,
                       "FAULT_AT": str(at), "LD_PRELOAD": str(self.library)}
        return folder, subprocess.run(self.command(folder), cwd=self.place, env=environment, capture_output=True, text=True,
                                      timeout=120)

    def faults(self):
        for at, call in enumerate(self.calls, 1):
            for how in (ALL if LONG else ONE_EACH).get(call, "").split():
                yield at, call, how
            if LONG or call not in ("close", "flock"):
                yield at, call, "kill"
            if LONG or call == "write":
                yield at, call, "full"

    def is_new(self, name, data):
        if name in self.measured:
            return outputs.is_whole(name, data, self.new[name])
        return data == self.new.get(name)

    def lost(self, folder, strays_allowed, is_at_end):
        """What is there that should not be, or not like that."""
        now = outputs.contents(folder)
        for name, data in now.items():
            if data == self.old.get(name) or self.is_new(name, data):
                continue
            if strays_allowed and outputs.TEMPORARY.search(name):
                continue
            if self.output.resumes and not is_at_end and outputs.UNFINISHED.fullmatch(name):
                continue
            yield f"{name} is neither the old one nor the new one" if name in self.new else f"{name} is left behind"
        yield from (f"{name} is gone" for name in self.old if name not in now)

    def all_new(self, folder):
        now = outputs.contents(folder)
        return now.keys() == self.new.keys() and all(self.is_new(name, data) for name, data in now.items())

    def judge(self, fault):
        """Nothing, or what is wrong after this fault."""
        at, call, how = fault
        is_kill = how.endswith("kill")
        folder, run = self.run(str(getattr(errno, how, how)), at)
        is_kept = call == "unlink" and how in ("EACCES", "EIO")  # what was to be taken away
        wrong = list(self.lost(folder, is_kill or is_kept, run.returncode == 0 and not is_kept))
        if is_kill:
            wrong += [f"status {run.returncode} after SIGKILL"] if run.returncode != -9 else []
            wrong += self.judge_next_run(folder)
        elif run.returncode == 0:
            if not self.all_new(folder) and not (call == "unlink" and not wrong):
                wrong.append("status 0, and not all is written")
            if call in REFUSED and how not in ("EINTR", "short"):
                wrong.append("status 0: the fault was not noticed")
        else:
            allowed = (3, 4) if call == "open" else (4,)  # something was to be read
            if run.returncode not in allowed or how in ("EINTR", "short"):
                wrong.append(f"status {run.returncode}")
            lines = [line for line in run.stderr.splitlines() if not line.startswith("shadowlab: note: ")]
            if len(lines) != 1 or not lines[0].startswith("shadowlab: ") or "; " not in lines[0]:
                wrong.append(f"says {run.stderr!r}")
            if self.output.resumes:
                wrong += self.judge_next_run(folder)
        if not wrong:
            shutil.rmtree(folder)
            Path(f"{folder}.log").unlink()
        return [f"{self.output.name}, call {at} ({call}), {how}: {what}" for what in wrong], call, run.returncode

    def judge_next_run(self, folder):
        _, run = self.run("", 0, folder)
        refused = self.output.once and run.returncode == 4
        if run.returncode != 0 and not refused:
            yield f"the next run has status {run.returncode}: {run.stderr}"
        elif self.output.appends:
            yield from (f"{name} is left behind" for name in outputs.contents(folder) if outputs.TEMPORARY.search(name))
        elif not self.all_new(folder):
            yield "after the next run not all is written, or something is left behind"


def walk(output, build, pool):
    with tempfile.TemporaryDirectory() as place:
        one = Walk(output, build, Path(place))
        results = list(pool.map(one.judge, one.faults()))
    wrong = [line for lines, _, _ in results for line in lines]
    statuses = Counter(status for _, _, status in results)
    print(f"{output.name}: {len(one.calls)} calls, {len(results)} faults, of them {statuses[-9]} kills, {statuses[4]} refusals, "
          f"{statuses[0]} without effect; {len(wrong)} wrong", flush=True)
    if output.name == "picture" and not any(call == "close" and status == 4 for _, call, status in results):
        wrong.append("picture: no close that fails is noticed")
    if output is not outputs.CARELESS:
        print("\n".join(wrong[:20]), end="\n" if wrong else "", flush=True)
    return len(results), wrong


def main(build):
    points, wrong = 0, []
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for output in outputs.LONG if LONG else outputs.SHORT:
            more, faults = walk(output, build, pool)
            points, wrong = points + more, wrong + faults
        _, careless = walk(outputs.CARELESS, build, pool)
    print(f"{points} points walked, {len(wrong)} wrong; {len(careless)} found in the careless writer")
    if points < LEAST_POINTS:
        print(f"there should be {LEAST_POINTS} points at least")
    if not careless:
        print("the careless writer passes: the walk sees nothing")
    return 1 if wrong or points < LEAST_POINTS or not careless else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
