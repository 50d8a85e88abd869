"""What tests of plug-ins have in common: a program to run, an installed prefix, a folder from a skeleton, and its build."""
# SPDX-License-Identifier: MIT
import json
import re
import subprocess
from pathlib import Path


class Failed(Exception):
    pass


def expect(condition, what):
    if not condition:
        raise Failed(what)


class Result:
    def __init__(self, words, done):
        self.words, self.status = words, done.returncode
        self.out, self.err = done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace")

    def __str__(self):
        return f"$ {' '.join(map(str, self.words))}\nstatus {self.status}\n{self.out}{self.err}"


def run(*words, cwd=None, limit=120):
    words = [str(word) for word in words]
    return Result(words, subprocess.run(words, cwd=cwd, capture_output=True, timeout=limit, check=False))


def succeed(*words, **settings):
    result = run(*words, **settings)
    expect(result.status == 0, str(result))
    return result


def one_line(result, status, *parts):
    """A refusal: that status, one line on standard error with these parts and a remedy, nothing on standard output."""
    expect(result.status == status, f"status {status} expected\n{result}")
    expect(result.err.startswith("shadowlab: ") and result.err.count("\n") == 1 and "; " in result.err, f"one line expected\n{result}")
    expect(result.out == "", f"nothing on standard output expected\n{result}")
    for part in parts:
        expect(part in result.err, f"'{part}' is not said\n{result}")


def fill_in(folder, blanks):
    """Puts code into numbered blanks: {1: "return 0;"}. What a student would do in an editor."""
    left = set(blanks)
    for file in sorted(folder.rglob("*")):
        if file.suffix not in (".cpp", ".glsl", ".vert", ".frag"):
            continue
        text = file.read_text()

        def filled(match):
            number = int(match.group(2))
            if number not in blanks:
                return match.group(0)
            left.discard(number)
            return match.group(1) + blanks[number] + "\n" + match.group(3)

        file.write_text(re.sub(r"(=== BLANK (\d+):[^\n]*\n(?:[ ]*// (?!===)[^\n]*\n)*).*?([ ]*// === END OF BLANK)", filled, text, flags=re.DOTALL))
    expect(not left, f"{folder} has no blanks {sorted(left)}")


def build(folder, prefix, *options, targets=()):
    """Configures and builds a plug-in's folder against an installed prefix, as its README says. Returns what the compiler said."""
    succeed("cmake", "-G", "Ninja", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={prefix}", *options)
    return succeed("cmake", "--build", folder / "build", "-j", "2", *(("--target", *targets) if targets else ()), limit=300).out


def grade(program, plugin, *options, limit=300):
    """The score sheet, as JSON, and the result of the command."""
    result = run(program, "grade", "--plugin", plugin, "--json", *options, limit=limit)
    expect(result.status in (0, 1), str(result))
    return json.loads(result.out), result


def install(build_folder, prefix):
    succeed("cmake", "--install", build_folder, "--prefix", prefix)
    return Path(prefix) / "bin" / "shadowlab"
