#!/usr/bin/env python3
"""Plug-ins as a student meets them: the program is installed into a temporary prefix, moved, and asked for folders of techniques;
these are built from what was installed alone, loaded, and graded. plugins_check.py BUILD_FOLDER

With SHADOWLAB_LONG every skeleton is filled in, and every typical mistake has to cost marks; without, one of them.
"""
# SPDX-License-Identifier: MIT
import os
import re
import shutil
import sys
import tempfile
from pathlib import Path

from kit import Failed, build, expect, fill_in, grade, install, one_line, run, succeed
from solutions import SOLUTIONS

HERE = Path(__file__).resolve().parent
LONG = bool(os.environ.get("SHADOWLAB_LONG"))

def pixels_of(png):
    """The compressed pixels, without the texts that say how the picture was made."""
    data, at, pixels = png.read_bytes(), 8, b""
    while at < len(data):
        length, kind = int.from_bytes(data[at:at + 4], "big"), data[at + 4:at + 8]
        pixels += data[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    expect(pixels, f"{png} has no pixels")
    return pixels


def misbehaving(program, *words, behaviour, do=run):
    os.environ["SHADOWLAB_MISBEHAVIOUR"] = behaviour
    try:
        return do(program, *words)
    finally:
        del os.environ["SHADOWLAB_MISBEHAVIOUR"]


def check_new_technique(program, place):
    """Refusals leave nothing behind."""
    before = sorted(place.iterdir())
    for name, part in (("My-Shadows", "no name"), ("my--shadows", "no name"), ("2d", "no name"), ("", "empty text"), ("../x", "no name"),
                       ("class", "namespace"), ("gl", "namespace"), ("shadow-map", "already"), ("planar", "already"), ("x" * 41, "41")):
        one_line(run(program, "new-technique", name, cwd=place), 2, part)
    one_line(run(program, "new-technique", "a", "--from", "z-fial", cwd=place), 2, "z-fail")
    one_line(run(program, "new-technique", "a", "-o", "no/such/folder", cwd=place), 4, "no/such/folder")
    expect(sorted(place.iterdir()) == before, "a refusal has left something behind")
    succeed(program, "new-technique", "my-own", cwd=place)
    one_line(run(program, "new-technique", "my-own", cwd=place), 4, "already")
    texts = [file.read_text() for file in (place / "my-own").rglob("*") if file.is_file()]
    expect(len(texts) == 4, "four files are expected")
    expect(not any(word in text for text in texts for word in ("my_shadows", "my-shadows", "My shadows")), "the skeleton's name is left")


def check_faults_of_files(program, place, plugin):
    """What is wrong with a file is said before anything of it runs."""
    def refused(file, *parts):
        one_line(run(program, "list", "techniques", "--plugin", file, cwd=place), 3, str(file), *parts)

    refused("none.so", "no such file")
    refused(place, "is a file")
    (place / "text.so").write_text("int main() {}\n")
    refused("text.so", "no shared library")
    bytes_of = plugin.read_bytes()
    mark = b"shadowlab plug-in contract "
    at = bytes_of.index(mark) + len(mark)
    (place / "other.so").write_bytes(bytes_of[:at] + b"0123456789abcdef" + bytes_of[at + 16:])
    refused("other.so", "another version", "0123456789abcdef")
    (place / "none_of_ours.so").write_bytes(bytes_of.replace(mark, b"x" * len(mark)))
    refused("none_of_ours.so", "no plug-in")
    (place / "half.so").write_bytes(bytes_of[:at + 20])
    refused("half.so")  # what the loader makes of it differs
    (place / "without_entry.so").write_bytes(bytes_of.replace(b"shadowlabPlugin\0", b"shadowlabPlugim\0"))
    refused("without_entry.so", "shadowlabPlugin")
    one_line(run(program, "list", "techniques", "--plugin"), 2, "--plugin")
    one_line(run(program, "list", "techniques", "--plugin", plugin, "--plugin", plugin), 2, "twice")


def check_faults_of_code(program, plugin):
    for behaviour, words in (("bad-id", "'Bad Id'"), ("taken-id", "'shadow-map' already"), ("throws-in-list", "no list today"),
                             ("lists-none", "lists none"), ("crashes-in-list", "it crashes (aborted)"), ("exits-in-list", "it ends the program")):
        one_line(misbehaving(program, "list", "techniques", "--plugin", plugin, behaviour=behaviour), 3, str(plugin), words)
    one_line(misbehaving(program, "grade", "--plugin", plugin, behaviour="crashes-in-list"), 3, "crashes")
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / "x.png"
        picture.write_text("old")
        one_line(misbehaving(program, "capture", "sphere-on-plane", "-t", "misbehaving", "--plugin", plugin, "--size", "32x24", "-o", picture,
                             behaviour="exits"), 70, "ended the program")
        expect(os.listdir(folder) == ["x.png"] and picture.read_text() == "old", "the old picture is kept, and nothing else is there")


def check_plugin_is_everywhere(program, place, plugin):
    out = succeed(program, "--plugin", plugin, "list", "techniques").out
    expect(f"my-own\tMy own\tnone\tevery cast shadow\t{plugin}\tproduction\t\n" in out, out)
    expect(len(out.splitlines()) >= 9, "ours are still there")
    expect("my-own.darkness\t0\t0..1" in succeed(program, "list", "parameters", f"--plugin={plugin}").out, "its parameter")
    visibility = place / "own.png"
    size = ["--size", "64x48"]
    succeed(program, "capture", "still-life", "-t", "my-own", "-o", visibility, "--plugin", plugin, "--stage", "visibility", *size)
    expect(visibility.stat().st_size > 100, "a picture")
    ours = place / "ours.png"
    succeed(program, "capture", "still-life", "-t", "unshadowed", "-o", ours, "--stage", "visibility", *size)
    expect(pixels_of(visibility) == pixels_of(ours), "the empty skeleton draws what `unshadowed` draws")
    succeed(program, "capture", "still-life", "-t", "my-own", "-o", visibility, "--plugin", plugin, "--stage", "visibility", *size,
            "--set", "my-own.darkness=1")
    expect(pixels_of(visibility) != pixels_of(ours), "its parameter does something")
    table = succeed(program, "measure", "still-life", "-t", "my-own", "--plugin", plugin, *size).out
    expect("my-own" in table, table)
    succeed(program, "probe", "still-life", "--pixel", "30,30", "-t", "my-own", "--plugin", plugin, *size)
    one_line(run(program, "grade", "--plugin", plugin), 2, "--family")
    one_line(run(program, "grade"), 2, "--plugin is missing")
    one_line(run(program, "grade", "--plugin", plugin, "--sheet", "html:a.html", "--sheet", "text:./a.html"), 2, "two sheets", "a.html")
    nowhere = ["--sheet", "html:/dev/null", "--sheet", "text:/dev/null"]  # takes any number of them: it is the plug-in that is refused
    one_line(run(program, "grade", "--plugin", "none.so", *nowhere), 3, "none.so")
    # It was made from no skeleton with blanks, so none is named.
    sheet = run(program, "grade", "--plugin", plugin, "--family", "planar").out
    expect("0/3" in sheet and "blank" not in sheet, sheet)


def check_misbehaving(program, plugin, place):
    """What happens to it is a line of the sheet, and the sheet goes on."""
    limits = ["--time-limit", "10" if LONG else "1", "--memory-limit", "700"]
    said = {"crashes": "segmentation fault", "never-ends": "within", "throws": "the student's own words", "breaks-gl": "GL_INVALID",
            "exits": "it has ended the program itself", "eats-memory": "more than 700 MiB"}
    for behaviour in said if LONG else ["crashes", "never-ends"]:
        sheet, result = misbehaving(program, plugin, *limits, "-o", place / behaviour, behaviour=behaviour, do=grade)
        expect(result.status == 1, str(result))
        expect(sheet["points"] == 0 and len(sheet["cases"]) >= 8, str(result))
        for case in sheet["cases"]:
            slow = not LONG and "within" in case["failure"]  # a second is little for a process on a busy machine
            expect(case["hint"] == "" and case["blanks"] == [], f"{behaviour}: nothing is said of an idea: {case}")
            expect(case["wrong"] is None and (said[behaviour] in case["failure"] or slow), f"{behaviour}: {case}")
        expect(Path(sheet["picture"]).stat().st_size > 1000, "a picture that says so")


def check_example_of_the_guide(program, prefix, place):
    """The technique of docs/adding_a_technique.md, as it stands there, is a plug-in as well."""
    guide = (HERE.parent.parent / "docs" / "adding_a_technique.md").read_text()
    code = re.findall(r"```(?:cpp|glsl)\n(.*?)```", guide, re.DOTALL)
    expect(len(code) == 2, "the guide has one file of C++ and one of GLSL")
    folder = place / "guide"
    (folder / "shaders" / "bounding_spheres").mkdir(parents=True)
    (folder / "technique.cpp").write_text(code[0])
    (folder / "shaders" / "bounding_spheres" / "visibility.glsl").write_text(code[1])
    (folder / "CMakeLists.txt").write_text((place / "my-own" / "CMakeLists.txt").read_text().replace("my_own", "bounding_spheres"))
    expect("warning" not in build(folder, prefix, "-DCMAKE_BUILD_TYPE=Debug"), "no warnings")
    succeed(program, "measure", "still-life", "-t", "bounding-spheres", "--size", "64x48", "--plugin",
            folder / "build" / "bounding_spheres.so")


def check_skeleton(program, prefix, place, skeleton, mistakes):
    """As it is, it runs and is far from full marks; filled in it has all; with one mistake it has lost some."""
    blanks = SOLUTIONS[skeleton]
    # Without optimisation a picture of these takes longer than a case may.
    build_type = "RelWithDebInfo" if skeleton in ("ray-tracing", "radiosity") else "Debug"
    right = {number: blank.right for number, blank in blanks.items()}
    folder = place / f"a-{skeleton}"
    plugin = folder / "build" / f"{folder.name.replace('-', '_')}.so"
    succeed(program, "new-technique", folder.name, "--from", skeleton, cwd=place)
    texts = {file: file.read_text() for file in folder.rglob("*") if file.is_file()}

    def sheet_of(filled):
        for file, text in texts.items():
            file.write_text(text)
        fill_in(folder, filled)
        said = build(folder, prefix, f"-DCMAKE_BUILD_TYPE={build_type}")
        expect("warning" not in said, said)
        sheet, result = grade(program, plugin, "-o", folder)
        return sheet, result.status

    if LONG:
        sheet, status = sheet_of({})
        expect(status == 1 and sheet["points"] < sheet["of"] / 3, f"unfilled {skeleton}: {sheet}")
        for case in sheet["cases"]:
            expect(case["wrong"] is not None and case["failure"] == "", f"a blank one still runs: {case}")
    sheet, status = sheet_of(right)
    expect(status == 0 and sheet["points"] == sheet["of"] and sheet["picture"] is None, f"filled in {skeleton}: {sheet}")
    for case in sheet["cases"]:
        if case["judged"] == "visibility":
            expect(case["lit"] > 500 and case["shadowed"] > 500, f"the case proves nothing: {case}")
        expect(all(case[key] for key in ("idea", "reason")), f"the case says too little: {case}")
    if LONG:
        expect(grade(program, plugin)[0] == sheet, "the same plug-in has the same sheet")
    for number in mistakes:
        sheet, status = sheet_of(right | {number: blanks[number].wrong})
        print(f"{skeleton}, blank {number}, {blanks[number].mistake}: {sheet['points']} of {sheet['of']}", flush=True)
        expect(status == 1 and sheet["points"] < sheet["of"], f"a mistake has cost nothing: {blanks[number].mistake}: {sheet}")
        expect(Path(sheet["picture"]).stat().st_size > 1000, "a picture of the first failing case")


def main():
    build_folder = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory(prefix="shadowlab plugins ") as temporary:  # with a blank, as folders of people have
        place = Path(temporary)
        install(build_folder, place / "first")
        prefix = place / "prefix"
        (place / "first").rename(prefix)  # what was installed may be moved
        program = prefix / "bin" / "shadowlab"
        check_new_technique(program, place)
        build(place / "my-own", prefix, "-DCMAKE_BUILD_TYPE=Debug")
        own = place / "my-own" / "build" / "my_own.so"
        check_plugin_is_everywhere(program, place, own)
        check_faults_of_files(program, place, own)
        if LONG:
            check_example_of_the_guide(program, prefix, place)
        folder = place / "misbehaving"
        folder.mkdir()
        shutil.copy(HERE / "misbehaving.cpp", folder)
        (folder / "CMakeLists.txt").write_text((place / "my-own" / "CMakeLists.txt").read_text().replace("my_own)", "misbehaving FAMILY planar)"))
        build(folder, prefix, "-DCMAKE_BUILD_TYPE=Debug")
        check_faults_of_code(program, folder / "build" / "misbehaving.so")
        check_misbehaving(program, folder / "build" / "misbehaving.so", place)
        for skeleton in SOLUTIONS if LONG else ["planar"]:
            check_skeleton(program, prefix, place, skeleton, SOLUTIONS[skeleton] if LONG else [2])


if __name__ == "__main__":
    try:
        main()
    except Failed as failed:
        sys.exit(f"plugins_check: {failed}")
