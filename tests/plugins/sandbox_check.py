#!/usr/bin/env python3
"""What a plug-in that reaches for something outside gets: in the sandbox nothing, and without it what the guide says. sandbox_check.py
BUILD_FOLDER

With SHADOWLAB_LONG each attack is tried without the sandbox as well, where it has to succeed, and the limits are. Where bwrap cannot make a sandbox, the limits are still checked, and a line says that the rest is not.
"""
# SPDX-License-Identifier: MIT
import os
import shutil
import socket
import sys
import tempfile
import time
from pathlib import Path

from kit import Failed, build, expect, grade, install, one_line, run

HERE = Path(__file__).resolve().parent
LONG = bool(os.environ.get("SHADOWLAB_LONG"))
LIMITS = ["--family", "planar", "--time-limit", "4", "--memory-limit", "700", "--backend", "osmesa"]


class Grading:
    def __init__(self, program, plugin):
        self.program, self.plugin = program, plugin

    def of(self, behaviour, *options, prey=""):
        """The sheet of the plug-in with that behaviour, and what was said beside it."""
        os.environ.update({"SHADOWLAB_MISBEHAVIOUR": behaviour, "SHADOWLAB_PREY": str(prey)})
        try:
            sheet, result = grade(self.program, self.plugin, *LIMITS, *options)
        finally:
            del os.environ["SHADOWLAB_MISBEHAVIOUR"], os.environ["SHADOWLAB_PREY"]
        expect(result.status == 1, str(result))
        expect(len(sheet["cases"]) >= 8, str(result))
        return sheet, result

    def failures(self, behaviour, *options, prey=""):
        return {case["failure"] for case in self.of(behaviour, *options, prey=prey)[0]["cases"]}


def has_sandbox(program, plugin):
    result = run(program, "grade", "--plugin", plugin, "--sandbox", "on", *LIMITS, limit=300)
    if result.status != 1:
        one_line(result, 3, "--sandbox on", "--sandbox auto")
        print(f"skipped: no sandbox here: {result.err.strip()}", flush=True)
    return result.status == 1


def asleep_for_long(program):
    """Processes of the program that are still there."""
    found = []
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            if str(program) in (entry / "cmdline").read_text():
                found.append(int(entry.name))
        except OSError:
            pass
    return found


def check_reach(grading, place):
    """Each reaches what it is after without the sandbox, else the test would prove nothing. In it, it has the sheet of one that does not
    try."""
    honest = grading.of("draws", "--sandbox", "on")[0]
    home = place / "home"
    home.mkdir()
    (home / "secret").write_text("the key of the safe\n")
    listening = socket.create_server(("127.0.0.1", 0))
    for behaviour, prey, got in (("reads-home", home / "secret", "it has read the key of the safe"),
                                 ("writes-file", home / "file", "it has written a file"),
                                 ("opens-socket", listening.getsockname()[1], "it has a connection"),
                                 ("sees-processes", os.getpid(), "it sees the process")):
        if LONG or behaviour == "reads-home":
            expect(any(got in failure for failure in grading.failures(behaviour, "--sandbox", "off", prey=prey)), f"{behaviour} does not work")
            (home / "file.new").unlink(missing_ok=True)
        sheet, result = grading.of(behaviour, "--sandbox", "on", prey=prey)
        expect(sheet == honest, f"{behaviour} in the sandbox: {sheet}")
        expect(result.err == "", f"nothing is said about a sandbox that is there\n{result}")
        expect(not (home / "file.new").exists(), "a file was written")
        print(f"{behaviour}: contained", flush=True)
    listening.close()


def check_limits(grading, program, sandbox):
    # Processes that have forked share their pages, and each of them counts: which limit is met first is a matter of luck.
    for behaviour, said in (("forks", ("processes", "MiB")), ("eats-memory", ("more than 700 MiB",)), ("never-ends", ("within",))):
        failures = grading.failures(behaviour, "--sandbox", sandbox)
        expect(failures and all(any(word in failure for word in (*said, "within")) for failure in failures), f"{behaviour}: {failures}")
        expect(any(word in failure for word in said for failure in failures), f"{behaviour}: {failures}")
    grading.of("leaves-process", "--sandbox", sandbox)
    time.sleep(0.5)
    expect(not asleep_for_long(program), f"a process is left: {asleep_for_long(program)}")
    print(f"limits, sandbox {sandbox}: kept", flush=True)


def check_words(grading, sandbox):
    """What a plug-in prints changes nothing: no mark, and no picture of a search."""
    honest = grading.of("draws", "--sandbox", sandbox, "--search", "3")[0]
    boasting = grading.of("prints-score", "--sandbox", sandbox, "--search", "3")[0]
    expect(boasting == honest, f"printing has changed the sheet:\n{boasting}\n{honest}")
    expect(honest["points"] < honest["of"], "the plug-in draws nothing right")


def main():
    build_folder = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory(prefix="shadowlab sandbox ") as temporary:
        place = Path(temporary)
        program = install(build_folder, place / "prefix")
        folder = place / "misbehaving"
        folder.mkdir()
        shutil.copy(HERE / "misbehaving.cpp", folder)
        (folder / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\nproject(misbehaving CXX)\nfind_package(shadowlab REQUIRED)\n"
                                               "shadowlab_plugin(misbehaving FAMILY planar)\n")
        build(folder, place / "prefix", "-DCMAKE_BUILD_TYPE=Debug")
        plugin = folder / "build" / "misbehaving.so"
        grading = Grading(program, plugin)
        sandboxes = ["on", "off"] if has_sandbox(program, plugin) else ["off"]
        if "on" in sandboxes:
            check_reach(grading, place)
        for sandbox in sandboxes if LONG else sandboxes[:1]:
            check_limits(grading, program, sandbox)
            check_words(grading, sandbox)
        # Where there is no bwrap, one line says so.
        os.environ["PATH"], path = str(place), os.environ["PATH"]
        result = grading.of("draws")[1]
        os.environ["PATH"] = path
        expect(result.err.count("\n") == 1 and "no sandbox" in result.err and "apt install bubblewrap" in result.err, str(result))


if __name__ == "__main__":
    try:
        main()
    except Failed as failed:
        sys.exit(f"sandbox_check: {failed}")
