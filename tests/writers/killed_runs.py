#!/usr/bin/env python3
"""Runs that are killed at random moments, by SIGKILL, SIGINT, SIGTERM or SIGHUP, again and again until one comes to its end: no file is ever
damaged, nothing is left behind, and the result is the one of a run that nobody disturbs. killed_runs.py BUILD_FOLDER [SEED]

A sequence of pictures, which begins again, and a report and slides, which go on where they were. With SHADOWLAB_LONG a hundred kills; without, six."""
# SPDX-License-Identifier: MIT
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import outputs

KILLS = 100 if os.environ.get("SHADOWLAB_LONG") else 6
SIGNALS = (signal.SIGKILL, signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
TECHNIQUES = "unshadowed,planar,shadow-map,shadow-volume-zfail"
WORKS = {
    "sequence": ["capture", "box.json", "-o", "FOLDER/f_##.png", "--size", "160x120", "--frames", "30", "--orbit-light", "90", "--labels", "false"],
    "report": ["report", "box.json", "--quick", "--size", "160x120", "-t", TECHNIQUES, "-o", "FOLDER"],
    "slides": ["slides", "deck.json", "--size", "640x360", "-o", "FOLDER"],
}
MOST_GRACE = 10  # seconds until a signal has ended a run; the program allows itself two
INTERRUPTED = "shadowlab: note: interrupted; the same command goes on from here\n"  # a report or slides; a sequence begins again
MEASURED = (".html", ".svg", ".csv", "report.json")  # files of a report with times in them; parts are told by their names


class Work:
    def __init__(self, name, program, place):
        self.name, self.program, self.place = name, program, place
        started = time.monotonic()
        self.undisturbed = place / f"{name}-undisturbed"
        run = self.start(self.undisturbed)
        err = run.communicate(timeout=600)[1]
        assert run.returncode == 0, err
        self.seconds = time.monotonic() - started
        self.expected = outputs.contents(self.undisturbed)
        self.folder = place / f"{name}-killed"
        self.tries = 0

    def start(self, folder):
        folder.mkdir(exist_ok=True)
        words = [word.replace("FOLDER", str(folder)) for word in WORKS[self.name]]
        return subprocess.Popen([self.program, *words], cwd=self.place, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def is_measured(self, name):
        return self.name == "report" and (name.endswith(MEASURED) or Path(name).name.startswith(("times-", "machine-")))

    def damaged(self, is_finished):
        now = outputs.contents(self.folder)
        for name, data in now.items():
            if outputs.TEMPORARY.search(name) or outputs.UNFINISHED.fullmatch(name):
                if is_finished:
                    yield f"{name} is left behind"
            elif name not in self.expected:
                yield f"{name} should not be there"
            elif data != self.expected[name] and not (self.is_measured(name) and outputs.is_whole(name, data, self.expected[name])):
                yield f"{name} is damaged"
        if is_finished:
            yield from (f"{name} is missing" for name in self.expected if name not in now)

    def kill_once(self, chance, which):
        """Starts the work, or goes on with it, and ends it at a random moment. Whether it had come to its end before, and what is wrong."""
        self.tries += 1
        self.folder.mkdir(exist_ok=True)
        before = outputs.contents(self.folder)  # a run that SIGKILL has ended leaves its temporaries to the next one
        run = self.start(self.folder)
        try:
            run.wait(chance.uniform(0, self.seconds * 1.05))
        except subprocess.TimeoutExpired:
            run.send_signal(which)
        killed = time.monotonic()
        try:
            err = run.communicate(timeout=MOST_GRACE)[1]
        except subprocess.TimeoutExpired:
            run.kill()
            run.communicate()
            return False, [f"{which.name} does not end it within {MOST_GRACE} s"]
        wrong = []
        if run.returncode not in (0, -which, -signal.SIGKILL, 128 + which):
            wrong.append(f"status {run.returncode} after {which.name}, says {err!r}")
        if run.returncode in (-signal.SIGINT, -signal.SIGTERM, -signal.SIGHUP):
            early = time.monotonic() - killed  # before main() begins, a signal ends every program like that
            if any(outputs.TEMPORARY.search(name) and name not in before for name in outputs.contents(self.folder)):
                wrong.append(f"{which.name} is not handled ({early:.1f} s)")
        if which != signal.SIGKILL and run.returncode == 128 + which and err not in ("", INTERRUPTED):
            wrong.append(f"{which.name} says {err!r}")
        return run.returncode == 0, wrong + list(self.damaged(run.returncode == 0))

    def stop_after_a_slide(self):
        """So that there is something to go on from, wherever chance has struck."""
        run = self.start(self.folder)
        while run.poll() is None and not any(self.folder.glob("*.unfinished.json")):
            time.sleep(0.001)
        run.kill()
        run.communicate()

    def finish(self):
        noted = sum(len(json.loads(data)["slides"]) for name, data in outputs.contents(self.folder).items() if outputs.UNFINISHED.fullmatch(name))
        run = self.start(self.folder)
        err = run.communicate(timeout=600)[1]
        wrong = [f"status {run.returncode}: {err!r}"] if run.returncode else []
        if (f"note: {noted} of " in err) != (noted > 0):
            wrong.append(f"{noted} slides stood, and it says {err!r}")
        wrong += self.damaged(True)
        shutil.rmtree(self.folder)
        return wrong


def main(build, seed):
    signal.signal(signal.SIGHUP, signal.SIG_DFL)  # also where this was started with nohup
    chance, kills, wrong, moments = random.Random(seed), Counter(), [], 0
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        outputs.write_inputs(place)
        works = [Work(name, build / "shadowlab", place) for name in WORKS]
        while moments < KILLS:
            work = works[moments % len(works)]
            which = SIGNALS[moments // len(works) % len(SIGNALS)]  # each work by each of them
            was_done, faults = work.kill_once(chance, which)
            moments += not was_done
            kills[f"{work.name} by {which.name}"] += not was_done
            wrong += [f"{work.name}, run {work.tries}: {fault}" for fault in faults]
            if was_done:
                shutil.rmtree(work.folder)
        works[-1].stop_after_a_slide()
        for work in works:
            wrong += [f"{work.name}, at its end: {fault}" for fault in (work.finish() if work.folder.exists() else [])]
    print("\n".join(wrong[:40]))
    print(", ".join(f"{name} {count}" for name, count in sorted(kills.items())))
    print(f"seed {seed}: {moments} runs killed, {len(wrong)} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve(), int(sys.argv[2]) if len(sys.argv) > 2 else random.SystemRandom().randrange(10 ** 6)))
