#!/usr/bin/env python3
"""Shows that include_check.py, house_check.py and docs/generate.py --check bite: a made-up tree with each violation must be
flagged at the very line, and a clean tree that comes close to each rule must pass. What they ask git is tried where there is git."""
# SPDX-License-Identifier: MIT
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

TESTS = Path(__file__).resolve().parent
SPDX = "// SPDX-License-Identifier: MIT\n"

# What is allowed, and close to what is not.
CLEAN = {
    "CMakeLists.txt": "find_package(PNG REQUIRED) # never OpenGL::GL\ntarget_link_libraries(app PRIVATE glfw OpenGL::EGL)\n",
    "techniques/technique.h": SPDX + '#include "techniques/foundation/scene/model/scene.h"\n',
    "techniques/frame.cpp": SPDX + '#include "techniques/technique.h"\n#include "techniques/foundation/gl/program.h"\n',
    "techniques/foundation/scene/model/scene.h": SPDX + '#include <vector>\n#include <png.h>\n// #include "app/picture/session.h"\n',
    "techniques/foundation/scene/model/mesh.h": SPDX + '#include "scene.h"\n/*\n#include <imgui.h>\n*/\n',
    "techniques/foundation/gl/program.h": SPDX + '#include <glad/gl.h>\n#include "techniques/foundation/scene/model/scene.h"\n',
    "techniques/planar/technique.cpp": SPDX + '#include "techniques/planar/matrix.h"\n#include "techniques/technique.h"\n#include <glad/gl.h>\n',
    "techniques/planar/matrix.h": SPDX + '#include "../foundation/scene/model/scene.h"\n',
    "techniques/foundation/image/image.h": SPDX + '#include "techniques/foundation/math/types.h"\n',
    "techniques/foundation/image/output_file.cpp": SPDX + "::rename(from, to);\n",
    "techniques/foundation/image/read.cpp": SPDX + "std::ifstream in(path); std::string text = renamed(path);\n",
    "techniques/foundation/math/types.h": SPDX + "#include <glm/glm.hpp>\n",
    "techniques/foundation/trace/bvh/bvh.h": SPDX + '#include "../scene/model/scene.h"\n#include "../image/image.h"\n',
    "app/main.cpp": SPDX + '#include "techniques/technique.h"\n#include "app/cli/list.h"\n#include "app/context/signals.h"\n',
    "app/cli/list.h": SPDX + '#include "app/window/panel.h"\n#include "app/judge/time.h"\n#include "../picture/session.h"\n',
    "app/window/panel.h": SPDX + '#include <imgui.h>\n#include "app/picture/session.h"\n',
    "app/judge/time.h": SPDX + '#include "app/judge/grid.h"\n',
    "app/picture/session.h": SPDX + '#include "app/context/signals.h"\n#include "app/judge/time.h"\n',
    "app/context/signals.h": SPDX + '#include "signals_of_windows.h"\n#include <GLFW/glfw3.h>\n',
    "app/context/signals_of_windows.h": "/* SPDX-License-Identifier: MIT */\n",
    "tests/planar/matrix_test.cpp": SPDX + '#include "techniques/planar/matrix.h"\n#include "app/main.cpp"\n#include <glad/gl.h>\n',
    "shaders/light.glsl": "float one() { return 1.0; }\n",
    "shaders/planar/flat.frag": '#version 330 core\n#include "light.glsl"\n#include "planar/flat.glsl"\n',
    ".ci/run": "# SPDX-License-Identifier: MIT\n",
    ".clang-format": "BasedOnStyle: LLVM\n",
    ".clang-tidy": "Checks: -*\n",
    ".gitignore": "/build/\n",
    "CMakePresets.json": "{}\n",
    "LICENSE": "MIT\n",
    "README.md": "An SPDX-License-Identifier: line stands in every source file.\n",
    "assets/models/make.py": "print()\n",
    "check": "# SPDX-License-Identifier: MIT\n",
    "demo": "# SPDX-License-Identifier: MIT\n",
    "docs/tour.md": "Run `/usr/bin/glad`, or build/home/x.\n",
}

# (check, file, line, text of the file): each must be flagged at that line, and nothing else.
BROKEN = [
    ("include", "techniques/foundation/scene/model/light.h", 2, SPDX + '#include "techniques/technique.h"\n'),
    ("include", "techniques/foundation/trace/bvh.cpp", 2, SPDX + '#include "techniques/planar/matrix.h"\n'),
    ("include", "techniques/foundation/trace/ray.cpp", 2, SPDX + '#include "app/window/panel.h"\n'),
    ("include", "techniques/foundation/image/png/png.cpp", 2, SPDX + "#include <glad/gl.h>\n"),
    ("include", "techniques/foundation/image/jpg.cpp", 2, SPDX + '#include "techniques/foundation/gl/program.h"\n'),
    ("include", "techniques/foundation/image/gif.cpp", 2, SPDX + '#include "../gl/program.h"\n'),
    ("include", "techniques/foundation/gl/window.cpp", 3, SPDX + "\n# include <GLFW/glfw3.h>\n"),
    ("include", "techniques/frame.h", 2, SPDX + '#include "techniques/planar/matrix.h"\n'),
    ("include", "techniques/registry.cpp", 2, SPDX + '#include "app/picture/session.h"\n'),
    ("include", "techniques/registry.h", 2, SPDX + "#include <glad/gl.h>\n"),
    ("include", "techniques/shadow_map/a.cpp", 2, SPDX + '#include "techniques/planar/matrix.h"\n'),
    ("include", "techniques/shadow_map/b.cpp", 2, SPDX + '#include "../planar/matrix.h"\n'),
    ("include", "techniques/shadow_map/c.cpp", 4, SPDX + '/* #include\n*/\n#include "app/window/panel.h"\n'),
    ("include", "techniques/shadow_map/d.cpp", 2, SPDX + '#include "tests/planar/matrix_test.cpp"\n'),
    ("include", "techniques/shadow_map/e.cpp", 2, SPDX + "#include <imgui.h>\n"),
    ("include", "techniques/shadow_map/f.cpp", 2, SPDX + "#include <EGL/egl.h>\n"),
    ("include", "techniques/shadow_map/g.cpp", 3, SPDX + '#define OTHER "techniques/planar/matrix.h"\n#include OTHER\n'),
    ("include", "app/picture/a.cpp", 2, SPDX + "#include <GL/gl.h>\n"),
    ("include", "app/picture/b.cpp", 2, SPDX + "#include <imgui_internal.h>\n"),
    ("include", "app/picture/c.cpp", 2, SPDX + '#include "tests/planar/matrix_test.cpp"\n'),
    ("include", "app/picture/d.cpp", 2, SPDX + '#include "techniques/planar/matrix.h"\n'),
    ("include", "app/picture/e.cpp", 2, SPDX + '#include "app/cli/list.h"\n'),
    ("include", "app/picture/f.cpp", 2, SPDX + '#include "../window/panel.h"\n'),
    ("include", "app/judge/c.cpp", 2, SPDX + '#include "app/picture/session.h"\n'),
    ("include", "app/figures/a.cpp", 2, SPDX + '#include "app/judge/grid.h"\n'),
    ("include", "app/context/a.cpp", 2, SPDX + '#include "app/picture/session.h"\n'),
    ("include", "app/context/b.cpp", 2, SPDX + '#include "app/cli/list.h"\n'),
    ("include", "app/window/a.cpp", 2, SPDX + '#include "app/cli/list.h"\n'),
    ("include", "app/judge/a.cpp", 2, SPDX + '#include "app/cli/list.h"\n'),
    ("include", "app/judge/b.cpp", 2, SPDX + '#include "app/window/panel.h"\n'),
    ("include", "app/cli/a.cpp", 2, SPDX + '#include "app/main.cpp"\n'),
    ("include", "app/cli/b.cpp", 2, SPDX + '#include "app/more/c.cpp"\n'),
    ("include", "app/more/c.cpp", 2, SPDX + '#include "app/picture/session.h"\n'),
    *(("include", f"techniques/foundation/math/{other}.h", 2, SPDX + f'#include "techniques/foundation/{other}/x.h"\n')
      for other in ("scene", "image", "params", "trace", "gl")),
    ("include", "techniques/foundation/image/bmp.cpp", 2, SPDX + '#include "techniques/foundation/scene/model/scene.h"\n'),
    ("include", "techniques/foundation/params/param.h", 2, SPDX + '#include "../scene/model/scene.h"\n'),
    ("include", "tests/a_test.cpp", 2, SPDX + "#include <GL/osmesa.h>\n"),
    ("include", "shaders/planar/a.frag", 2, '#version 330 core\n#include "shadow_map/lookup.glsl"\n'),
    ("include", "shaders/b.glsl", 1, '#include "planar/flat.frag"\n'),
    ("include", "app/CMakeLists.txt", 2, "find_package(PNG)\ntarget_link_libraries(app PRIVATE OpenGL::GL)\n"),
    ("include", "techniques/CMakeLists.txt", 1, "find_package(OpenGL REQUIRED)\n"),
    ("include", "tests/CMakeLists.txt", 2, "target_link_libraries(t\n  PRIVATE -lOSMesa)\n"),
    ("house", "app/a.cpp", 1, "int main() {}\n"),
    ("house", "techniques/planar/b.h", 402, SPDX + "\n" * 401),
    ("house", "tests/c_test.cpp", 3, SPDX + "\n// TO" + "DO later\n"),
    ("house", "shaders/d.glsl", 2, "float x;\n// FIX" + "ME\n"),
    ("house", "app/picture/keep.cpp", 3, SPDX + "#include <fstream>\nstd::of" + "stream out(path);\n"),
    ("house", "techniques/planar/keep.cpp", 2, SPDX + "std::filesystem::rena" + "me(from, to);\n"),
    ("house", "docs/e.md", 1, "cd /ho" + "me/someone/shadowlab\n"),
    ("house", "docs/f.py", 1, "print()\n"),
    ("house", "app/g.cpp", 1, "// The program. SPDX-License-Identifier: MIT\n"),
    ("house", "app/h.h", 2, "// The program's own header.\n// SPDX-License-Identifier: MIT. Includes nothing.\n"),
    ("house", "shaders/i.glsl", 1, "float one; // SPDX-License-Identifier: MIT\n"),
]


def write(root, files):
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def run(check, root):
    command = [sys.executable, str(TESTS / f"{check}_check.py"), str(root)]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    return result.returncode, result.stdout.splitlines(), result.stderr


def git(root, *arguments):
    subprocess.run(["git", "-C", str(root), *arguments], capture_output=True, check=True)


def top_level_complaints():
    """A file that is tracked at the top level without a reason is flagged; one that only lies there is not."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        write(root, CLEAN)
        git(root, "init")
        git(root, "add", "--all")
        write(root, {"only-here.png": ""})
        results = [run("house", root)]
        write(root, {"b.png": ""})
        git(root, "add", "b.png")
        results.append(run("house", root))
    if [(status, [line.split(":")[0] for line in lines]) for status, lines, _ in results] != [(0, []), (1, ["b.png"])]:
        yield f"house_check: of files at the top level it says {results}"


def picture_complaints():
    """A picture that a page shows and git does not track is missing in every clone."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        write(root, {"README.md": "![a](docs/images/a.png)\n", "docs/tour.md": "# Tour\n\n<img src=\"images/b.png\">\n",
                     "docs/images/a.png": "", "docs/images/b.png": "", ".gitignore": "b.png\n",
                     "program": '#!/bin/sh\necho "{\\"$2\\": []}"\n'})
        (root / "program").chmod(0o755)
        for script in ("generate.py", "pages.py"):
            shutil.copy(TESTS.parent / "docs" / script, root / "docs")
        command = [sys.executable, str(root / "docs/generate.py"), "--check", "--program", str(root / "program")]

        def said():
            result = subprocess.run(command, capture_output=True, text=True, check=False)
            return result.returncode, [line.split(",")[0] for line in result.stdout.splitlines()], result.stderr

        without_git = said()
        git(root, "init")
        git(root, "add", "--all")
        ignored = said()
        git(root, "add", "--force", "docs/images/b.png")
        results = [without_git, ignored, said()]
    if results != [(0, [], ""), (1, ["docs/tour.md: git does not track docs/images/b.png"], ""), (0, [], "")]:
        yield f"docs/generate.py --check: of pictures that git does not track it says {results}"


def main():
    for name in [name for name in os.environ if name.startswith("GIT_")]:
        del os.environ[name]  # in a hook they name the repository of the hook
    complaints = []
    if shutil.which("git"):
        complaints += [*top_level_complaints(), *picture_complaints()]
    else:
        print("there is no git: what the checks ask it is not tried")
    for check in ("include", "house"):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            write(root, CLEAN)
            status, lines, errors = run(check, root)
            if status != 0 or lines:
                complaints.append(f"{check}_check: flags a clean tree: {lines} {errors}")
            broken = [case for case in BROKEN if case[0] == check]
            write(root, {file: text for _, file, _, text in broken})
            status, lines, errors = run(check, root)
            if status != 1:
                complaints.append(f"{check}_check: exit status {status} for a broken tree {errors}")
            flagged = {tuple(line.split(":")[:2]) for line in lines}
            for _, file, line, _ in broken:
                wanted = (file, str(line))
                if wanted not in flagged:
                    complaints.append(f"{check}_check: does not see the fault at {':'.join(wanted)}")
                flagged.discard(wanted)
            complaints += [f"{check}_check: flags {':'.join(place)}, where nothing is wrong" for place in sorted(flagged)]
    print("\n".join(complaints) or f"{len(BROKEN)} faults, each flagged where it is; the clean tree passes")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
