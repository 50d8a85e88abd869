#!/usr/bin/env python3
"""`grade --search 60` finds, for every blank of every skeleton that is left empty or filled in with a typical mistake, a scene in which
the plug-in is wrong, within 60 s, and makes it as small as twelve triangles; and none for a skeleton that is filled in rightly.
search_check.py BUILD_FOLDER

With SHADOWLAB_LONG all of them, and the cases that fail are compared with the table in app/student/grading/likely_blanks.cpp; without,
one blank. What is written, the scene and the lesson, is drawn and measured.
"""
# SPDX-License-Identifier: MIT
import os
import re
import sys
import tempfile
import time
from pathlib import Path

from kit import Failed, build, expect, fill_in, grade, install, one_line, run, succeed
from solutions import SOLUTIONS

LONG = bool(os.environ.get("SHADOWLAB_LONG"))
ROOT = Path(__file__).resolve().parent.parent.parent
MOST_TRIANGLES, SCENES, SECONDS = 12, 60, 60


def patterns():
    """{(family, failing cases): blanks} of the table."""
    text = (ROOT / "app" / "student" / "grading" / "likely_blanks.cpp").read_text()
    found = re.findall(r'\{"([\w-]+)", "([01]+)", "([\d ]+)"\}', text)
    expect(len(found) >= 20, "the table is not found")
    return {(family, failing): blanks.split() for family, failing, blanks in found}


class Searched:
    """A skeleton, filled in and searched."""

    def __init__(self, program, prefix, place, skeleton):
        self.program, self.prefix, self.skeleton = program, prefix, skeleton
        self.folder = place / f"a-{skeleton}"
        self.plugin = self.folder / "build" / f"{self.folder.name.replace('-', '_')}.so"
        succeed(program, "new-technique", self.folder.name, "--from", skeleton, cwd=place)
        self.texts = {file: file.read_text() for file in self.folder.rglob("*") if file.is_file()}

    def sheet(self, filled, out):
        for file, text in self.texts.items():
            if file.read_text() != text:
                file.write_text(text)
        fill_in(self.folder, filled)
        build(self.folder, self.prefix, "-DCMAKE_BUILD_TYPE=RelWithDebInfo")
        begin = time.monotonic()
        sheet, result = grade(self.program, self.plugin, "--search", SCENES, "--seconds", SECONDS, "-o", out, limit=600)
        return sheet, result.status, time.monotonic() - begin

    def check_files(self, found, out):
        """Scene and lesson are such, and the lesson's numbers hold."""
        scene, lesson = Path(found["scene"]), found["lesson"]
        expect(scene.parent == out and scene.exists(), str(found))
        succeed(self.program, "capture", scene, "-o", out / "scene.png", "--size", "160x90")
        expect(lesson is not None, f"a picture that is wrong makes a lesson: {found}")
        said = succeed(self.program, "lesson", lesson, "--measure", "--plugin", self.plugin).out
        expect("as expected" in said, said)
        one_line(run(self.program, "lesson", lesson), 3, "no technique is called", "add --plugin FILE")
        expect("not from the plug-in" in next(out.glob("*-search.svg")).read_text(), "the figure says of what it is drawn")
        page = next(out.glob("*-sheet.html")).read_text()
        expect(page.count("data:image/png") >= 2 and "http:" not in page and "https:" not in page and "<script" not in page, "the page stands alone")
        expect(next(out.glob("*-search.svg")).stat().st_size > 1000, "a figure")


def main():
    build_folder = Path(sys.argv[1]).resolve()
    table = patterns()
    slowest = most = trials = 0
    with tempfile.TemporaryDirectory(prefix="shadowlab search ") as temporary:
        place = Path(temporary)
        program = install(build_folder, place / "prefix")
        for skeleton in SOLUTIONS if LONG else ["planar"]:
            blanks = SOLUTIONS[skeleton]
            right = {number: blank.right for number, blank in blanks.items()}
            searched = Searched(program, place / "prefix", place, skeleton)
            sheet, status, _ = searched.sheet(right, place / "right")
            expect(status == 0 and sheet["search"]["found"] is None, f"{skeleton}, filled in rightly: {sheet['search']}")
            expect(sheet["search"]["tried"] - sheet["search"]["unfair"] >= SCENES // 2, f"too few scenes ask anything: {sheet['search']}")
            for number in blanks if LONG else [4]:
                for what, filled in (("empty", {n: code for n, code in right.items() if n != number}),
                                     (blanks[number].mistake, right | {number: blanks[number].wrong})):
                    out = place / f"{skeleton}-{number}-{what == 'empty'}"
                    sheet, status, seconds = searched.sheet(filled, out)
                    found = sheet["search"]["found"]
                    expect(status == 1 and found, f"{skeleton}, blank {number}, {what}: nothing found: {sheet['search']}")
                    print(f"{skeleton}, blank {number}, {what}: {seconds:.1f} s, scene {found['number']}, {found['trianglesBefore']} -> "
                          f"{found['triangles']} triangles, blanks {found['blanks']}: {found['sentence']}", flush=True)
                    expect(found["triangles"] <= MOST_TRIANGLES, f"{found['triangles']} triangles are too many")
                    expect(not sheet["search"]["outOfTime"], "out of time")
                    searched.check_files(found, out)
                    failing = "".join("1" if case["points"] == 0 else "0" for case in sheet["cases"])
                    expect(str(number) in table.get((sheet["family"], failing), []),
                           f"{skeleton}, blank {number}, {what}: the cases {failing} are not in the table of likely_blanks.cpp")
                    slowest, most, trials = max(slowest, seconds), max(most, found["triangles"]), trials + 1
    expect(trials >= (50 if LONG else 2), "too few trials")
    print(f"{trials} trials: at most {slowest:.1f} s with the cases of the sheet, at most {most} triangles")


if __name__ == "__main__":
    try:
        main()
    except Failed as failed:
        sys.exit(f"search_check: {failed}")
