#!/usr/bin/env python3
"""Shows that package_rules.py bites: a made-up package that is right passes, and each thing that can be wrong with it is said."""
# SPDX-License-Identifier: MIT
import struct
import sys
import tempfile
from pathlib import Path
from types import SimpleNamespace

import package_rules as rules

DESKTOP = "[Desktop Entry]\nType=Application\nName=Shadowlab\nComment=A lamp\nExec=shadowlab demo\nIcon=shadowlab\nCategories=Education;\n"
NEEDS = {rules.PROGRAM: ["libcairo.so.2", "libc.so.6", "libstdc++.so.6"], f"{rules.LIBRARIES}/libcairo.so.2": ["libpixman-1.so.0", "libX11.so.6"],
         f"{rules.LIBRARIES}/libpixman-1.so.0": ["libm.so.6"]}
CONTROL = {"Package": "shadowlab", "Version": "1.2.3", "Architecture": "amd64", "Recommends": "cmake",
           "Depends": ", ".join(f"{name} (>= 1)" for name in rules.ASKED_OF_APT)}


def section(needed, rpath=rules.RPATH):
    return "".join(f" 0x01 (NEEDED)  Shared library: [{name}]\n" for name in needed) + f" 0x0f {rpath}\n"


def write(file, content):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(content if isinstance(content, bytes) else content.encode())


def make(prefix):
    for name in [*rules.FILES, "README", "include/shadowlab/glm/glm.hpp", "share/man/man1/shadowlab.1.gz", "share/doc/shadowlab/changelog.gz"]:
        write(prefix / name, "something")
    for package in [*rules.COMPILED_IN, "libcairo2"]:
        write(prefix / rules.LICENCES / package, "something")
    for name, needed in NEEDS.items():
        write(prefix / name, section(needed))
    (prefix / rules.PROGRAM).chmod(0o755)
    write(prefix / rules.DESKTOP, DESKTOP)
    for size in rules.ICON_SIZES:
        write(prefix / rules.ICONS / f"{size}x{size}/apps/shadowlab.png", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + struct.pack(">II", size, size))


def gone(name):
    return lambda prefix: (prefix / name).unlink()


def holds(name, content):
    return lambda prefix: write(prefix / name, content)


# What is done to the unpacked archive, and a part of what has to be said then; as often as it is said.
DAMAGES = [
    (lambda prefix: None, []),
    *[(gone(name), [f"{name} is missing"]) for name in rules.FILES if name not in (rules.DESKTOP, rules.PROGRAM)],
    (gone("README"), ["README is missing"]),
    (gone("include/shadowlab/glm/glm.hpp"), ["glm.hpp is missing"]),
    (gone(f"{rules.LIBRARIES}/libcairo.so.2"), ["needs libcairo.so.2", "libpixman-1.so.0 is taken along, and nothing needs it"]),
    (gone(f"{rules.LIBRARIES}/libpixman-1.so.0"), ["libcairo.so.2 needs libpixman-1.so.0"]),
    (holds(f"{rules.LIBRARIES}/libstdc++.so.6", section(["libc.so.6"])), ["libstdc++.so.6 is taken along"]),
    (holds(rules.PROGRAM, section(NEEDS[rules.PROGRAM], "(RUNPATH) Library runpath: [/elsewhere]")), ["does not look for its libraries"]),
    (lambda prefix: (prefix / rules.PROGRAM).chmod(0o644), ["cannot be run"]),
    (gone(f"{rules.ICONS}/48x48/apps/shadowlab.png"), ["icon is missing in 48 x 48"]),
    (holds(f"{rules.ICONS}/256x256/apps/shadowlab.png", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + struct.pack(">II", 48, 48)), ["not of 256 x 256"]),
    (holds(rules.DESKTOP, DESKTOP.replace("Icon=shadowlab\n", "")), ["has no Icon", *["icon is missing"] * len(rules.ICON_SIZES)]),
    (holds(rules.DESKTOP, DESKTOP.replace("Exec=shadowlab", "Exec=shadow-lab")), ["starts what is not there"]),
    (gone("share/man/man1/shadowlab.1.gz"), ["no manual page"]),
    (gone(f"{rules.LICENCES}/libglm-dev"), ["comes from libglm-dev", "licences of what is taken along"]),
    (gone(f"{rules.LICENCES}/libcairo2"), ["licences of what is taken along"]),
]
# The same for the fields of the .deb, of which the checksums are those of its files.
FIELDS = [
    ({}, []),
    ({"Depends": CONTROL["Depends"].replace("libegl1", "libegl2")}, ["depend on libegl1"]),
    ({"Depends": CONTROL["Depends"] + ", libembree3-3"}, ["libembree3-3, which not every release has"]),
    ({"Recommends": "libosmesa6"}, ["libosmesa6, which not every release has"]),
    ({"Architecture": "all"}, ["for all"]),
    ({"Version": "1"}, ["called shadowlab 1"]),
]


def said_otherwise(what, complaints, expected):
    complaints = list(complaints)
    right = len(complaints) == len(expected) and all(any(part in complaint for complaint in complaints) for part in expected)
    if not right:
        print(f"{what}: expected {expected}, said was {complaints}")
    return not right


def main():
    rules.dynamic_section = Path.read_text
    rules.shutil = SimpleNamespace(which=lambda _: None)  # what desktop-file-validate says is not ours to test
    wrong = 0
    for number, (damage, expected) in enumerate(DAMAGES):
        with tempfile.TemporaryDirectory() as folder:
            prefix = Path(folder)
            make(prefix)
            damage(prefix)
            wrong += said_otherwise(f"damage {number}", rules.of_archive(prefix), expected)
    for fields, expected in FIELDS:
        wrong += said_otherwise(fields, rules.of_control({**CONTROL, **fields}, ["usr/a"], ["usr/a"]), expected)
    wrong += said_otherwise("a file without a checksum", rules.of_control(CONTROL, ["usr/a"], ["usr/a", "usr/b"]), ["no checksum of ['usr/b']"])
    print(f"{len(DAMAGES) + len(FIELDS) + 1} packages, {wrong} misjudged")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
