#!/usr/bin/env python3
"""The arrows between the layers, checked: app -> the contract (techniques/*.h and techniques/probed/) <- techniques/<x>, and from all of them to
techniques/foundation and the libraries; within app/ the order of its rooms, APP_ORDER.

include_check.py [ROOT] reads every C++ file, shader and CMake file of a checkout, prints FILE:LINE: WHAT for each arrow that
points the wrong way, and exits with 1 if there is one. The rules are the functions whose names begin with `rule_`.
"""
# SPDX-License-Identifier: MIT
import os
import re
import sys
from pathlib import Path, PurePosixPath

CPP_ENDINGS = {".c", ".cc", ".cpp", ".cxx", ".h", ".hh", ".hpp", ".inl", ".in"}
SHADER_ENDINGS = {".glsl", ".vert", ".frag", ".geom"}
# The rooms of app/, the lowest first: a room includes only those before it. "main" is main.cpp; nothing includes it.
APP_ORDER = ("context", "drawing", "figures", "judge", "picture", "film", "lab", "foreign", "student", "course", "report", "hard", "window", "cli",
             "main")
# What the lower folders of the foundation leave alone, of its other folders.
FOUNDATION_WITHOUT = {"math": {"scene", "image", "params", "trace", "gl"}, "image": {"scene"}, "params": {"scene"}}

FOLDERS = ("app", "techniques", "shaders", "tests")

INCLUDE = re.compile(r'^[ \t]*(?:#|%:)[ \t]*(?:include|include_next|import)\b[ \t]*(.*)$', re.MULTILINE)
MODULE_IMPORT = re.compile(r'^[ \t]*(?:export[ \t]+)?import[ \t]*(["<].*)$', re.MULTILINE)
NAMED = re.compile(r'^(?:"([^"]+)"|<([^>]+)>)')
COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)


def without_comments(text):
    """Comments become blanks and continued lines are joined; line numbers stay."""
    def blank(match):
        found = match.group(0)
        return found if found.startswith('"') else re.sub(r"[^\n]", " ", found)

    return COMMENT_OR_TEXT.sub(blank, text.replace("\\\n", "  "))


class Include:
    """One include directive: of which file, where, and what it names, as a path below the root where it is ours."""

    def __init__(self, root, file, line, text):
        named = NAMED.match(text)
        self.file, self.line, self.macro = file, line, text
        self.name = name = (named.group(1) or named.group(2)) if named else None
        self.target = None
        if name:
            beside = os.path.normpath(os.path.join(os.path.dirname(file), name))
            from_root = os.path.normpath(name)
            ours = beside if os.path.isfile(os.path.join(root, beside)) else from_root
            self.target = PurePosixPath(Path(ours).as_posix())

    def targets(self, *folders):
        return self.target is not None and str(self.target).startswith(tuple(f"{folder}/" for folder in folders))


def layer(path):
    """foundation, foundation/gl, contract (files beside the folders of the techniques, and probed/), technique, app, tests or shaders."""
    parts = PurePosixPath(path).parts
    if parts[0] != "techniques":
        return parts[0]
    if len(parts) == 2 or parts[1] == "probed":
        return "contract"
    if parts[1] != "foundation":
        return "technique"
    return "foundation/gl" if len(parts) > 3 and parts[2] == "gl" else "foundation"


def rule_foundation(include):
    if not layer(include.file).startswith("foundation"):
        return None
    if include.targets("techniques") and not include.targets("techniques/foundation") or include.targets("app", "tests"):
        return "the foundation includes only the foundation and libraries"
    if layer(include.file) == "foundation" and include.targets("techniques/foundation/gl"):
        return "of the foundation, only techniques/foundation/gl touches GL"
    folder = PurePosixPath(include.file).parts[2]
    if include.targets(*(f"techniques/foundation/{other}" for other in FOUNDATION_WITHOUT.get(folder, ()))):
        return f"techniques/foundation/{folder} lies below techniques/foundation/{include.target.parts[2]}"
    return None


def rule_technique(include):
    if layer(include.file) not in ("technique", "contract"):
        return None
    if include.targets("app", "tests"):
        return "nothing under techniques/ includes app/ or tests/"
    if include.target is None or not include.targets("techniques") or include.targets("techniques/foundation"):
        return None
    if layer(include.target) == "technique":
        own = PurePosixPath(include.file).parts[1]
        if layer(include.file) == "contract":
            return "the contract knows no technique; the list of them is generated"
        if include.target.parts[1] != own:
            return "a technique never includes another"
    return None


def rule_app_knows_contracts_only(include):
    if layer(include.file) != "app":
        return None
    if include.targets("tests"):
        return "the program does not include its tests"
    if include.targets("techniques") and layer(include.target) == "technique":
        return "the program knows techniques by their contract only: the files directly under techniques/, and techniques/probed"
    return None


def app_folder(path):
    """picture for app/picture/x.h and app/picture/steps/y.h, main for the files directly in app/."""
    parts = PurePosixPath(path).parts
    return parts[1] if len(parts) > 2 else "main"


def rule_order_within_app(include):
    if layer(include.file) != "app" or not include.targets("app"):
        return None
    user, used = app_folder(include.file), app_folder(include.target)
    for folder in (user, used):
        if folder not in APP_ORDER:
            return f"app/{folder} has no place in the order within app/; give it one in APP_ORDER"
    if user == used:
        return None
    if APP_ORDER.index(user) < APP_ORDER.index(used):
        return f"within app/ the order is {' -> '.join(reversed(APP_ORDER))}, so {user} does not include {used}"
    return None


def rule_gl_through_glad(include):
    if not include.name:
        return None
    if re.match(r"(GL|GLES\d?|OpenGL|GLUT)/", include.name):
        return "GL is called through glad only: include <glad/gl.h>"
    if include.name.startswith("glad/") and layer(include.file) in ("foundation", "contract"):
        return "glad belongs into techniques/foundation/gl, the techniques' folders and app/"
    if include.name.startswith(("GLFW/", "EGL/")) and layer(include.file) not in ("app", "tests"):
        return "a technique never sees a window or a context: GLFW and EGL belong into app/"
    return None


def rule_imgui(include):
    base = PurePosixPath(include.name or "").name
    if base.startswith("imgui") and not include.file.startswith("app/window/"):
        return "imgui belongs into app/window"
    return None


def rule_shader(include):
    parts = PurePosixPath(include.file).parts
    if parts[0] != "shaders" or not include.name:
        return None
    target = PurePosixPath(os.path.normpath(include.name)).parts
    if len(target) > 1 and (len(parts) < 3 or target[0] != parts[1]):
        return "a shader includes files of its own folder and of the root of shaders/"
    return None


def rule_can_be_read(include):
    if include.macro.startswith("FT_"):
        return None  # FreeType names its headers by macros: <FT_FREETYPE_H>
    return "an include by macro cannot be checked: write the file's name" if include.name is None else None


RULES = [rule for name, rule in sorted(globals().items()) if name.startswith("rule_")]


def includes_of(root, file):
    text = without_comments(Path(root, file).read_text(encoding="utf-8", errors="replace"))
    for pattern in (INCLUDE, MODULE_IMPORT):
        for match in pattern.finditer(text):
            yield Include(root, file, text.count("\n", 0, match.start()) + 1, match.group(1).strip())


LINKED = re.compile(r"OpenGL::(?:GL|OpenGL|GLX|GLU|GLES\d)\b|-lGL\b|-lOpenGL\b|-lOSMesa\b|\bOSMesa::\w+|\bPkgConfig::OSMesa\b|"
                    r"find_package\s*\(\s*(?:OpenGL|OSMesa)\b|"
                    r"(?:find_library|pkg_check_modules|pkg_search_module)\s*\([^)]*\b(?:osmesa|OSMesa|GL|gl)\b|"
                    r"target_link_libraries\s*\([^)]*\b(?:GL|OpenGL|OSMesa)\b(?!::)")


def cmake_violations(root, file):
    """libGL beside OSMesa gives a black picture and no error; both are loaded at run time."""
    text = re.sub(r"#[^\n]*", "", Path(root, file).read_text(encoding="utf-8", errors="replace"))
    for match in LINKED.finditer(text):
        line = text.count("\n", 0, match.end()) + 1
        yield line, f"'{' '.join(match.group(0).split())}': neither libGL nor libOSMesa is linked, GL comes through glad"


def files_of(root):
    for folder in FOLDERS:
        for path in sorted(Path(root, folder).rglob("*")):
            if path.is_file():
                yield path.relative_to(root).as_posix()
    yield "CMakeLists.txt"


def violations(root):
    for file in files_of(root):
        name = PurePosixPath(file)
        if not Path(root, file).is_file():
            continue
        if name.name == "CMakeLists.txt" or name.suffix == ".cmake":
            yield from ((file, line, what) for line, what in cmake_violations(root, file))
        elif name.suffix in CPP_ENDINGS | SHADER_ENDINGS:
            for include in includes_of(root, file):
                for what in filter(None, (rule(include) for rule in RULES)):
                    yield file, include.line, f"includes {include.name or include.macro}: {what}"


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    if not Path(root, "techniques").is_dir():
        sys.exit(f"include_check: {root} is no checkout, it has no techniques/; give the folder that holds it")
    found = list(violations(root))
    for file, line, what in found:
        print(f"{file}:{line}: {what}")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
