"""What a page of the documentation asks a reader to type: files, and command lines of the program.

A file is a fenced block below a line that ends in its name: `ball.json`: with the colon. A command is a line of an indented or
fenced block that begins with build/release/shadowlab, or code within a sentence that begins with shadowlab. Words in capitals
(FILE, SCENE) and dots (...) stand for something else: such a line is no command. A block of the language console holds commands,
each after "$ shadowlab", and below each of them lines that it prints.

pages.py PAGE FOLDER writes the files of a page below a folder. One that has not changed is left alone: nothing is built anew.
"""
# SPDX-License-Identifier: MIT
import re
import shlex
import sys
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NAMED = re.compile(r"`([\w./-]+)`[^`\n]*:\s*\Z")
TYPED = re.compile(r"^(?:    )?(build/release/shadowlab (?:.*\\\n)*.*)$", re.MULTILINE)
MENTIONED = re.compile(r"`(?:build/release/)?(shadowlab [^`]+)`")
PROMPT = "$ shadowlab "
MARKER = re.compile(r"<!-- (picture|lesson|slide|figure) [\w-]+: (.+?) -->")
SUBCOMMANDS = {"picture": "capture", "lesson": "lesson", "slide": "slides", "figure": "probe"}
STANDS_FOR_ANOTHER = re.compile(r"(?<![\w=./-])[A-Z]{3,}(?![\w-]|\.\w)|=[A-Z]{3,}\b|\.\.\.")


class Command(NamedTuple):
    page: Path
    line: int
    words: list  # after the program's name
    prints: tuple = ()  # lines that have to be among what it writes, in this order

    def __str__(self):
        return shlex.join(["shadowlab", *self.words])


def files_of(text):
    """Name and contents of each file that the page gives, in order."""
    for match in FENCE.finditer(text):
        named = NAMED.search(text[:match.start()].rstrip())
        if named:
            yield named.group(1), match.group(2)


def commands_of(page, text):
    """All commands of the page, in the order in which they stand there."""
    found = []
    for pattern in (TYPED, MENTIONED):
        for match in pattern.finditer(text):
            words = split(match.group(1))
            if words:
                found.append((match.start(), words))
    for match in MARKER.finditer(text):
        if "{" not in match.group(2):
            output = ["--diagram", "figure.svg"] if match.group(1) == "figure" else ["-o", "picture.png"]
            found.append((match.start(), [SUBCOMMANDS[match.group(1)], *shlex.split(match.group(2)), *output]))
    commands = [(start, Command(page, text.count("\n", 0, start) + 1, words)) for start, words in found]
    for match in FENCE.finditer(text):
        if match.group(1) == "console":
            commands += [(match.start(2), command) for command in transcript_of(page, match.group(2), text.count("\n", 0, match.start(2)) + 1)]
    return [command for _, command in sorted(commands, key=lambda pair: pair[0])]


def transcript_of(page, block, first_line):
    """The commands of a console block, with what they print."""
    commands = []
    for number, line in enumerate(block.splitlines(), first_line):
        if line.startswith(PROMPT):
            commands.append(Command(page, number, shlex.split(line[len(PROMPT):])))
        else:
            commands[-1] = commands[-1]._replace(prints=(*commands[-1].prints, line))
    return commands


def split(line):
    """The words after the program's name; none where the line is a pattern for many commands, or a name alone."""
    try:
        words = shlex.split(re.sub(r"\s#\s.*", "", line.replace("\\\n", " ").replace("\n", " ")))
    except ValueError:  # a quotation that does not end is no command line
        return []
    alone = len(words) == 2 and not words[1].startswith("--")
    if STANDS_FOR_ANOTHER.search(" ".join(words)) or alone:
        return []
    return words[1:]


def all_pages():
    return [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def extract(page, folder):
    """Writes the files of a page below a folder, and returns their names."""
    names = []
    for name, contents in files_of(page.read_text(encoding="utf-8")):
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.is_file() or path.read_text(encoding="utf-8") != contents:
            path.write_text(contents, encoding="utf-8")
        names.append(name)
    return names


if __name__ == "__main__":
    extract(Path(sys.argv[1]), Path(sys.argv[2]))
