#!/usr/bin/env python3
"""Every command line in the documentation, held against the program.

commands_check.py PROGRAM looks at the words of each: is there such a subcommand, option, technique, stage, parameter, scene, lesson or
deck, is the value in its range, and does the file exist that it reads? Commands that read a file which their page tells the
reader to type in are run, in small pictures, and so are those of which the page says what they print: they have to. With
SHADOWLAB_LONG all of them are run but `demo`, which opens a window, and full reports, which take hours (tests of their own run small
ones).
"""
# SPDX-License-Identifier: MIT
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent.parent / "docs"))
from pages import ROOT, all_pages, commands_of, extract

LEAST_COMMANDS = 100  # so that a pattern that no longer finds them is noticed
SMALL = {"capture": "160x90", "measure": "96x54", "lesson": "480x270", "slides": "640x360"}
WITH_WORDS = "400x260"  # below the picture of a step stands its title
WITHOUT_VALUE = {"--ui", "--presenter", "--keys", "--animate", "--steps", "--measure", "--json", "--report", "--help", "--version", "--quick", "--hard",
                 "--explore"}
SHORT = {"-t": "--technique", "-o": "--output", "-h": "--help"}


class Names:
    """What the program says that there is."""

    def __init__(self, program):
        self.program = program
        self.techniques = {t["id"] for t in self.list("techniques")}
        self.parameters = {p["parameter"]: p["range"] for p in self.list("parameters")}
        self.stages = {(s["technique"], s["stage"]) for s in self.list("stages")}
        self.inputs = {what: {entry["name"] for entry in self.list(what)} for what in ("scenes", "lessons", "decks")}
        self.subcommands = set(re.findall(r"^  ([\w-]+) ", self.told("--help"), re.MULTILINE))
        self.options = {}

    def list(self, what):
        return json.loads(self.told("list", what, "--json"))[what]

    def told(self, *words):
        return subprocess.run([self.program, *words], capture_output=True, text=True, check=True).stdout

    def options_of(self, subcommand):
        if subcommand not in self.options:
            self.options[subcommand] = set(re.findall(r"(?<![\w-])--[\w-]+", self.told(subcommand, "--help")))
        return self.options[subcommand]


def parsed(words):
    """Positional words and options of a command line, as (option, value) pairs."""
    positional, options, words = [], [], list(words)
    while words:
        word = words.pop(0)
        if not word.startswith("-"):
            positional.append(word)
            continue
        name, equals, value = word.partition("=")
        name = SHORT.get(name, name)
        if not equals and name not in WITHOUT_VALUE:
            value = words.pop(0) if words else ""
        options.append((name, value))
    return positional, options


def in_range(value, allowed):
    if "|" in allowed:
        return value in allowed.split("|")
    low, dots, high = allowed.partition("..")
    try:
        return not dots or float(low) <= float(value) <= float(high)
    except ValueError:
        return False


def complaints_about(command, names, files):
    """What is wrong with the words of one command; `files`: those that its page gives, or that it has written before."""
    subcommand, *words = command.words
    if subcommand.startswith("-"):
        return
    if subcommand not in names.subcommands:
        yield f"there is no subcommand {subcommand}"
        return
    positional, options = parsed(words)
    for name, _ in options:
        if name not in names.options_of(subcommand):
            yield f"{subcommand} has no option {name}"
    techniques = next((v.split(",") for n, v in options if n == "--technique"), ["shadow-volume-zfail"])
    if techniques == ["all"] and subcommand == "measure":
        techniques = sorted(names.techniques)
    yield from (f"there is no technique {t}" for t in techniques if t not in names.techniques)
    for name, value in options:
        if name == "--set":
            yield from complaints_about_setting(value, names)
        if name == "--stage":
            stage = re.sub(r"^\d:", "", value).split("@")[0]
            if not any((t, stage) in names.stages for t in techniques):
                yield f"no stage {stage} of {', '.join(techniques)}"
    what = {"lesson": "lessons", "slides": "decks"}.get(subcommand, "scenes")
    merges = subcommand == "report" and positional[:1] == ["merge"]  # the words after it are folders of parts
    inputs = [] if subcommand in ("list", "new-technique", "help") or merges else [(what, word) for word in positional]
    inputs += [(name[2:] + "s", value) for name, value in options if name in ("--lesson", "--deck")]
    inputs += [("files", value) for name, value in options if name == "--path"]
    for kind, word in inputs:
        if subcommand == "slides" and word == "lessons":  # the page of lessons, of which --only names some
            wanted = [lesson for name, value in options if name == "--only" for lesson in value.split(",")]
            yield from (f"no lesson is called {lesson}" for lesson in wanted if lesson not in names.inputs["lessons"])
            continue
        if kind == "decks" and word in names.inputs[kind]:
            slides = (ROOT / f"assets/decks/{word}.json").read_text(encoding="utf-8")
            yield from (f"the deck {word} has no slide {value}" for name, value in options
                        if name in ("--only", "--slide") and f'"name": "{value}"' not in slides)
        if word not in names.inputs.get(kind, ()) and word not in files and not (ROOT / word).is_file():
            yield f"{word} is none of the {kind}, and no file that the page gives"


def complaints_about_setting(value, names):
    setting, _, wanted = re.sub(r"^\d:", "", value).partition("=")
    if setting not in names.parameters:
        yield f"there is no parameter {setting}"
    elif not in_range(wanted, names.parameters[setting]):
        yield f"{setting} is {wanted}; it must be {names.parameters[setting]}"


def smaller(words):
    """The same command for a small picture, where no word of it counts pixels."""
    subcommand = words[0]
    if subcommand not in SMALL or any(word.startswith(("--pixel", "--row", "--ui", "--measure", "--state")) for word in words):
        return words
    kept = [word for i, word in enumerate(words) if word not in ("--size", "--supersample") and (i == 0 or words[i - 1] not in ("--size", "--supersample"))]
    more = ["--supersample", "1"] if subcommand == "slides" else []
    return [*kept, "--size", WITH_WORDS if "--steps" in words else SMALL[subcommand], *more]


def takes_hours(words):
    """A full report, a shard of one, and what is made of shards."""
    return words[0] == "report" and "--quick" not in words and "--hard" not in words


def run(command, program, folder, judged):
    """None where it went well, else what the program said. `judged`: pictures that a later command judges; they keep their size."""
    words = command.words if judged.intersection(command.words) else smaller(command.words)
    try:
        result = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True, timeout=900, check=False)
    except subprocess.TimeoutExpired:
        return "did not end within 15 minutes"
    wanting = 1 if command.words[0] == "judge" else 0  # judged, and found wanting
    if result.returncode not in (0, wanting):
        return f"exit status {result.returncode}: {result.stderr.strip()}"
    printed = iter(result.stdout.splitlines())
    for line in command.prints:
        if not any(" ".join(line.split()) == " ".join(other.split()) for other in printed):
            return f"does not print `{line}`, or not in this order"
    return None


def check_page(page, names, everything, seen):
    """Complaints about one page, and how many of its commands were looked at and run."""
    text = page.read_text(encoding="utf-8")
    complaints, ran = [], 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        files = set(extract(page, folder))
        typed = {file for file in files if "/" not in file}
        if any(file.startswith("techniques/") for file in files):  # a technique that is not in this program: a test builds it
            names = with_technique_of(page, names, text)
        (folder / "assets").symlink_to(ROOT / "assets")
        commands = commands_of(page, text)
        judged = {word for command in commands if command.words[0] == "judge" for word in command.words if word.endswith(".png")}
        for command in commands:
            wrong = list(complaints_about(command, names, files))
            complaints += [f"{os.path.relpath(page, ROOT)}:{command.line}: {what}: {command}" for what in wrong]
            _, options = parsed(command.words[1:])
            files |= {value for option, value in options if option in ("--output", "--diagram", "--stats")}
            reads_typed = any(word in typed for word in command.words)
            runs = reads_typed or command.prints or judged.intersection(command.words) or (everything and str(command) not in seen and not technique_of_page(command, names))
            film = any(word.endswith(".mp4") for word in command.words)
            if wrong or not runs or command.words[0] == "demo" or takes_hours(command.words) or (film and not shutil.which("ffmpeg")):
                continue
            seen.add(str(command))
            ran += 1
            said = run(command, names.program, folder, judged)
            if said:
                complaints.append(f"{os.path.relpath(page, ROOT)}:{command.line}: {said}: {command}")
    return complaints, len(commands), ran


class NamesOfPage:
    """The program's names, and those of the technique that a page tells how to write."""

    def __init__(self, names, technique, parameters):
        self.__dict__.update(names.__dict__)
        self.more = technique
        self.techniques = names.techniques | {technique}
        self.parameters = {**names.parameters, **parameters}
        self.stages = names.stages | {(technique, "visibility")}
        self.told, self.options_of = names.told, names.options_of


def with_technique_of(page, names, text):
    technique = re.search(r'\.id = "([\w-]+)"', text).group(1)
    reals = re.findall(r'params::real\("([\w-]+)", \w+, ([\d.]+), ([\d.]+),', text)
    return NamesOfPage(names, technique, {f"{technique}.{name}": f"{low}..{high}" for name, low, high in reals})


def technique_of_page(command, names):
    return hasattr(names, "more") and names.more in " ".join(command.words)


def main():
    names = Names(os.path.abspath(sys.argv[1]))
    everything = "SHADOWLAB_LONG" in os.environ
    complaints, looked_at, ran, seen = [], 0, 0, set()
    for page in all_pages():
        wrong, some, run_here = check_page(page, names, everything, seen)
        complaints, looked_at, ran = complaints + wrong, looked_at + some, ran + run_here
    if looked_at < LEAST_COMMANDS:
        complaints.append(f"only {looked_at} commands were found, at least {LEAST_COMMANDS} were expected")
    print("".join(line + "\n" for line in complaints), end="")
    print(f"{looked_at} commands looked at, {ran} run")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
