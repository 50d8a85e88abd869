#!/usr/bin/env python3
"""Writes the parts of README.md and docs/ that the program knows better than any hand: tables, the index, the pictures.

generate.py              rewrites what stands between `<!-- generated: NAME -->` and `<!-- end generated -->`, and makes a
                         page, to be filled in, for every technique that has none
generate.py --check      writes nothing; exits with 1 when a part is out of date, a page or a picture is missing, a link is dead,
                         or git does not track a picture
generate.py --pictures   draws the pictures as well, with `shadowlab capture`:
                         `<!-- picture NAME: ARGUMENTS -->` asks for docs/images/NAME.png wherever it stands,
                         `<!-- lesson NAME: ARGUMENTS -->` for the same of `shadowlab lesson ARGUMENTS`,
                         `<!-- slide NAME: ARGUMENTS -->` of `shadowlab slides ARGUMENTS`, which draw one slide,
                         `<!-- figure NAME: ARGUMENTS -->` for docs/images/NAME.svg of `shadowlab probe ARGUMENTS`, and
                         `<!-- gallery: ARGUMENTS -->` on a technique's page for a picture of each of its stages
                         that is not asked for by name. Files that a page gives (pages.py) may be named in its markers
--only NAME              with --pictures: that picture alone; may be repeated
--program PATH           the program to ask, build/release/shadowlab by default
"""
# SPDX-License-Identifier: MIT
import argparse
import itertools
import json
import math
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from pages import SUBCOMMANDS, extract

ROOT = Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"
IMAGES = DOCS / "images"
# Pages that are about no technique, by who looks for them; what is not listed here stands last.
PAGES = {
    "To use it": ["packages", "window", "measuring", "judge", "report", "performance", "pixel", "outside", "export", "source", "sequences", "errors",
                  "shadow-map-filters"],
    "To teach with it": ["teaching", "lecture", "exercises", "grading", "decks", "explore", "lessons", "hard-cases"],
    "To build on": ["tour", "conventions", "scene_format", "gltf", "adding_a_technique", "plugins", "relations", "systems"],
}
LARGEST_PICTURE = 150_000  # bytes: a clone stays small, a page loads at once

BLOCK = re.compile(r"(<!-- generated: ([\w-]+) -->\n).*?(<!-- end generated -->)", re.DOTALL)
PICTURE = re.compile(r"<!-- (picture|lesson|slide|figure) ([\w-]+): (.+?) -->")
GALLERY = re.compile(r"<!-- gallery: (.+?) -->")
LINK = re.compile(r"\]\(([^)\s#]+)(?:#[^)]*)?\)|<img src=\"([^\"]+)\"")
UNWRITTEN = "(to be written)"

PAGE = f"""# {{title}}

{UNWRITTEN}: the idea in five sentences.

Paper: {{paper}}.

## In the lecture

{UNWRITTEN}: the lecture's steps, and which pass does which.

## Passes

<!-- generated: passes -->
<!-- end generated -->

## Stages

<!-- gallery: still-life --size 640x360 -->
<!-- generated: stages -->
<!-- end generated -->

## Parameters

<!-- generated: parameters -->
<!-- end generated -->

## What goes wrong

It gets wrong: {{getsWrong}}. {UNWRITTEN}: each artefact with the parameter values that show it.

## Lessons

<!-- generated: artefacts -->
<!-- end generated -->
"""


class Program:
    """What `shadowlab list` says about techniques that belong to this checkout."""

    def __init__(self, path):
        self.path = path
        self.techniques = [t for t in self.list("techniques") if (ROOT / t["folder"] / "technique.cpp").is_file()]
        self.lecture = [t for t in self.techniques if t["group"] == "lecture"]  # one page for all of them, and no pictures
        self.techniques = [t for t in self.techniques if t["group"] != "lecture"]
        self.parameters = self.list("parameters")
        self.stages = self.list("stages")
        self.source = self.list("source")  # fails where an anchor is missing or stands in two places

    def list(self, what):
        try:
            result = subprocess.run([self.path, "list", what, "--json"], capture_output=True, text=True, check=True)
        except OSError as error:
            sys.exit(f"generate.py: {self.path}: {error.strerror}; build the program with ./demo, or name it with --program")
        except subprocess.CalledProcessError as error:
            sys.exit(f"generate.py: `shadowlab list {what}` failed: {error.stderr.strip()}")
        return json.loads(result.stdout)[what]

    def stages_of(self, technique):
        """A technique's own stages, where it is wrong, and what a second camera sees. What else the session derives looks
        alike for all: measuring.md."""
        return [s for s in self.stages if s["technique"] == technique and not s["stage"].startswith("pass:")
                and (not s["derived"] or s["stage"] in ("error", "outside"))]

    def passes_of(self, technique):
        return [s for s in self.stages if s["technique"] == technique and s["stage"].startswith("pass:")]

    def source_of(self, technique, stage):
        """Where a pass is done, as links. No line numbers: they change with every line above them, the anchors do not."""
        files = {}
        for s in self.source:
            if s["technique"] == technique and "pass:" + s["pass"] == stage:
                files.setdefault(s["file"], []).append(s["anchor"])
        return ", ".join(f"[{Path(file).name}](../{file}) {' '.join(map(code, anchors))}" for file, anchors in files.items())

    def lessons_of(self, technique):
        """The lessons about a technique, in the order of the course: it is the first that a lesson's file names."""
        lessons = []
        for lesson in self.list("lessons"):
            file = ROOT / "assets/lessons" / f"{lesson['name']}.json"
            named = re.search(r'"technique": "([\w-]+)"', file.read_text(encoding="utf-8"))
            if named and named.group(1) == technique:
                lessons.append(lesson)
        return lessons

    def parameters_of(self, technique):
        return [p for p in self.parameters if p["parameter"].rpartition(".")[0] == technique]


def table(head, rows):
    def line(cells):
        return "| " + " | ".join(str(cell).replace("|", "\\|") for cell in cells) + " |"

    return "\n".join([line(head), "|" + "---|" * len(head), *map(line, rows)]) + "\n"


def code(text):
    return f"`{text}`" if text else ""


def range_text(parameter):
    return " ".join(filter(None, (code(parameter["range"]), parameter["unit"])))


def meaning_text(parameter):
    """The help, and in words what those choices are whose ids are abbreviations."""
    choices = (choice.split(": ", 1) for choice in parameter["choices"].split("; ") if choice)
    named = "; ".join(f"{code(choice)}: {name}" for choice, name in choices)
    return parameter["help"] + (f" {named}." if named else "")


def parameters_table(program, technique):
    """A table for each group of the panel, in its order: the basic parameters first."""
    tables = []
    for group, members in itertools.groupby(program.parameters_of(technique), key=lambda p: p["group"]):
        rows = [(code(p["parameter"].rpartition(".")[2]), p["label"], code(p["default"]), range_text(p), meaning_text(p)) for p in members]
        tables.append(f"**{group or 'Basic'}**\n\n" + table(("parameter", "in the panel", "default", "range", "meaning"), rows))
    return "\n".join(tables) if tables else "It has none.\n"


def passes_table(program, technique):
    passes = program.passes_of(technique)
    more = [(key, title) for key, title in (("why", "why"), ("pseudocode", "in the lecture"), ("glState", "state")) if any(p.get(key) for p in passes)]
    rows = [(code(p["stage"]), p["caption"] + (", for each light" if p["perLight"] else ""), *(p.get(key, "") for key, _ in more),
             program.source_of(technique, p["stage"]))
            for p in passes]
    return table(("pass", "what it does", *(title for _, title in more), "source"), rows)


def stages_table(program, technique):
    def picture(stage):
        return f'<img src="images/{technique}-{stage["stage"]}.png" alt="{stage["caption"]}" width="320">'

    rows = [(code(s["stage"] + ("@LIGHT" if s["perLight"] else "")), s["caption"], picture(s)) for s in program.stages_of(technique)]
    return table(("stage", "what it shows", "picture"), rows)


def techniques_table(program, folder):
    """`folder`: from where the links go."""
    rows = [(f"[{t['title']}]({'docs/' if folder == ROOT else ''}{t['id']}.md)", t["paper"],
             f"[{t['folder']}]({'' if folder == ROOT else '../'}{t['folder']})", t["getsWrong"]) for t in program.techniques]
    return table(("technique", "paper", "folder", "what it gets wrong"), rows)


def lecture_table(program):
    rows = [(code(t["id"]), t["title"], t["paper"], f"[{t['sister']}]({t['sister']}.md)", t["getsWrong"]) for t in program.lecture]
    return table(("id", "technique", "paper", "its refined sister", "what it gets wrong"), rows)


def keys_table(program):
    rows = []
    for key in program.list("keys"):
        if rows and rows[-1][3] == key["help"]:
            rows[-1][1] += ", " + code(key["keys"])
        else:
            rows.append([key["group"], code(key["keys"]), key["help"].replace("|", "\\|"), key["help"]])
    return table(["where", "keys", "what they do"], [row[:3] for row in rows])


def lessons_table(program):
    rows = [[lesson["chapter"], code(lesson["name"]), lesson["title"], lesson["happens"].replace("|", "\\|"), lesson["mends"].replace("|", "\\|")]
            for lesson in program.list("lessons")]
    return table(["chapter", "lesson", "title", "what is wrong", "its remedy"], rows)


def artefacts_table(program, technique):
    """What the built-in lessons show of a technique. They measure what they show: a test fails when an artefact is not there."""
    def picture(lesson):
        name = f"lesson-{lesson['name']}"
        return f'<img src="images/{name}.png" alt="{lesson["title"]}: the artefact, and its remedy" width="480"><br>`shadowlab lesson {lesson["name"]} -o {name}.png`'

    rows = [(f"**{lesson['title']}.** {lesson['happens']}", picture(lesson)) for lesson in program.lessons_of(technique)]
    return table(("what is wrong", "the artefact, and its remedy"), rows) if rows else "None is about this technique alone.\n"


def quantities_table(program):
    rows = [[code(quantity["quantity"]), quantity["unit"], quantity["help"]] for quantity in program.list("quantities")]
    return table(["quantity", "unit", "what it is"], rows)


def pages_list(program):
    ids = {t["id"] for t in program.techniques}
    left = sorted(p.stem for p in DOCS.glob("*.md") if p.stem not in ids and p.stem != "README")
    groups = {heading: [name for name in names if name in left] for heading, names in PAGES.items()}
    groups["To build on"] += [name for name in left if not any(name in names for names in groups.values())]
    return "\n".join(f"**{heading}**\n\n" + "".join(map(page_line, names)) for heading, names in groups.items())


def page_line(name):
    """A page's title, and the first sentence that stands on it."""
    text = (DOCS / f"{name}.md").read_text(encoding="utf-8")
    title = re.search(r"^# (.+)$", text, re.MULTILINE).group(1)
    opening = re.search(r"\n\n([^#<|`\n].+?[.:])(?:\s|$)", text, re.DOTALL)
    return f"- [{title}]({name}.md)" + (f": {' '.join(opening.group(1).split()).rstrip(':')}" if opening else "") + "\n"


def regenerated(program, path, text):
    def block(match):
        name, technique = match.group(2), path.stem
        makers = {"techniques": lambda: techniques_table(program, path.parent), "lecture": lambda: lecture_table(program),
                  "pages": lambda: pages_list(program),
                  "parameters": lambda: parameters_table(program, technique), "passes": lambda: passes_table(program, technique),
                  "stages": lambda: stages_table(program, technique), "keys": lambda: keys_table(program),
                  "artefacts": lambda: artefacts_table(program, technique), "lessons": lambda: lessons_table(program), "quantities": lambda: quantities_table(program)}
        if name not in makers:
            sys.exit(f"generate.py: {path}: there is no generated part '{name}'; there are {', '.join(makers)}")
        return match.group(1) + "\n" + makers[name]() + "\n" + match.group(3)

    return BLOCK.sub(block, text)


def every_technique(program):
    """Capture arguments that put all techniques into one picture of equal cells."""
    count = len(program.techniques)
    columns = count if count <= 3 else math.ceil(math.sqrt(count))
    rows = math.ceil(count / columns)
    # However many there are, the picture stays as wide as a page and within LARGEST_PICTURE.
    layout, cell = ("side", (480, 360)) if rows == 1 else ("grid", (960 // columns, 960 // columns * 9 // 16))
    ids = ",".join(t["id"] for t in program.techniques)
    return f"-t {ids} --layout {layout} --size {columns * cell[0]}x{rows * cell[1]}"


def wanted_pictures(program):
    """Name of each picture, the page that asks for it, and the words of the command line that it is made with."""
    pictures = {}
    ids = {t["id"] for t in program.techniques}
    for path in (ROOT / "README.md", *sorted(DOCS.glob("*.md"))):
        text = re.sub(r"```.*?```", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
        for kind, name, arguments in PICTURE.findall(text):
            pictures[name] = path, f"{SUBCOMMANDS[kind]} " + arguments.replace("{every technique}", every_technique(program))
        gallery = GALLERY.search(text)
        if gallery and path.stem in ids:
            for stage in program.stages_of(path.stem):
                pictures.setdefault(f"{path.stem}-{stage['stage']}",
                                    (path, f"capture {gallery.group(1)} -t {path.stem} --stage {stage['stage']}"))
        if path.stem in ids and "<!-- generated: artefacts -->" in text:
            for lesson in program.lessons_of(path.stem):
                pictures.setdefault(f"lesson-{lesson['name']}", (path, f"lesson {lesson['name']} --size 640x360"))
    return pictures


def draw_picture(program, name, page, arguments):
    figure, slides = arguments.startswith("probe "), arguments.startswith("slides ")
    output = IMAGES / (f"{name}.svg" if figure else f"{name}.png")
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        extract(page, folder)
        # The same bytes on every machine with the same Mesa, whatever graphics card it has. A figure needs none.
        words = ["--diagram", "drawn.svg"] if figure else ["--software", "-o", "drawn" if slides else "drawn.png"]
        command = [os.path.abspath(program.path), *shlex.split(arguments), *words]
        if subprocess.run(command, cwd=folder, check=False, stdout=subprocess.DEVNULL).returncode != 0:
            sys.exit(f"generate.py: picture {name} could not be drawn: {shlex.join(command)}")
        drawn = sorted((folder / "drawn").glob("*.png")) if slides else sorted(folder.glob("drawn.*"))
        if len(drawn) != 1:
            sys.exit(f"generate.py: picture {name} is to be one slide, not {len(drawn)}; name it with --only")
        shutil.copyfile(drawn[0], output)
    if output.stat().st_size > LARGEST_PICTURE:
        sys.exit(f"generate.py: {output} has {output.stat().st_size} bytes, {LARGEST_PICTURE} is the most; choose a smaller --size")


def draw_pictures(program, only):
    IMAGES.mkdir(exist_ok=True)
    pictures = wanted_pictures(program)
    for name in only:
        if name not in pictures:
            sys.exit(f"generate.py: no page asks for a picture {name}; there are {', '.join(sorted(pictures))}")
    for name, (page, arguments) in pictures.items():
        if name in only or not only:
            draw_picture(program, name, page, arguments)
    # Some are drawn by hand, as a browser shows them: those that a page has stay.
    shown = "".join(page.read_text() for page in [ROOT / "README.md", *(ROOT / "docs").glob("*.md")])
    for picture in IMAGES.glob("*.png"):
        if picture.stem not in pictures and f"images/{picture.name}" not in shown:
            picture.unlink()
    total = sum(p.stat().st_size for p in IMAGES.glob("*.png"))
    print(f"{len(pictures)} pictures, {total // 1000} kB, in {IMAGES}", file=sys.stderr)


def tracked_files():
    """The paths that git tracks, None where git is not in use."""
    if not (ROOT / ".git").exists():
        return None
    command = ["git", "-c", "safe.directory=*", "-C", str(ROOT), "ls-files", "-z"]
    try:
        listed = subprocess.run(command, capture_output=True, text=True, errors="replace", check=True).stdout
        return set(listed.split("\0"))
    except (OSError, subprocess.CalledProcessError):
        return None


def complaints_about(path, text, tracked):
    name = path.relative_to(ROOT)
    if UNWRITTEN in text and path.name != "adding_a_technique.md":
        yield f"{name}: a part is still {UNWRITTEN}; write it"
    for match in LINK.finditer(re.sub(r"```.*?```", "", text, flags=re.DOTALL)):
        target = match.group(1) or match.group(2)
        if re.match(r"[a-z]+:", target):
            continue
        if (path.parent / target).exists():
            picture = os.path.relpath(path.parent / target, ROOT)
            if picture.endswith((".png", ".svg")) and tracked is not None and picture not in tracked:
                yield (f"{name}: git does not track {picture}, so a fresh clone would lack it; "
                       f"`git add` it (`git check-ignore -v` says whether .gitignore is in the way)")
            continue
        fix = "draw it with docs/generate.py --pictures" if target.endswith(".png") else "fix the link"
        yield f"{name}: there is no {target}; {fix}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--pictures", action="store_true")
    parser.add_argument("--only", action="append", default=[], metavar="NAME")
    parser.add_argument("--program", default=str(ROOT / "build/release/shadowlab"))
    options = parser.parse_args()
    program = Program(options.program)

    complaints = []
    tracked = tracked_files() if options.check else None
    for technique in program.techniques:
        page = DOCS / f"{technique['id']}.md"
        if page.is_file():
            continue
        if options.check:
            complaints.append(f"technique '{technique['id']}' has no page; run docs/generate.py, and fill in docs/{page.name}")
        else:
            page.write_text(PAGE.format(**technique), encoding="utf-8")
            print(f"{page.relative_to(ROOT)}: new, to be filled in", file=sys.stderr)
    for path in (ROOT / "README.md", *sorted(DOCS.glob("*.md"))):
        text = path.read_text(encoding="utf-8")
        new = regenerated(program, path, text)
        if new != text and options.check:
            complaints.append(f"{path.relative_to(ROOT)}: is out of date; run docs/generate.py")
        elif new != text:
            path.write_text(new, encoding="utf-8")
            print(f"{path.relative_to(ROOT)}: brought up to date", file=sys.stderr)
        if options.check:
            complaints += complaints_about(path, new, tracked)
    if options.pictures and not options.check:
        draw_pictures(program, options.only)
    print("".join(complaint + "\n" for complaint in complaints), end="")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
