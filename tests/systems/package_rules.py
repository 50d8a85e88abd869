"""What must be true of a package before it is run: which files, libraries, licences and menu entry it has, and what it asks apt for.
Each rule looks at an unpacked package and yields what is wrong."""
# SPDX-License-Identifier: MIT
import configparser
import re
import shutil
import struct
import subprocess

PROGRAM = "bin/shadowlab"
LIBRARIES = "lib/shadowlab"
LICENCES = "share/doc/shadowlab/licences"
# Where libraries that are taken along are looked for. DT_RPATH: DT_RUNPATH does not hold for what these libraries need in turn.
RPATH = "(RPATH) Library rpath: [$ORIGIN/../lib/shadowlab]"
DESKTOP = "share/applications/shadowlab.desktop"
ICONS = "share/icons/hicolor"
ICON_SIZES = (16, 48, 256)
FILES = [PROGRAM, DESKTOP, f"{ICONS}/scalable/apps/shadowlab.svg", "share/doc/shadowlab/copyright", "share/doc/shadowlab/README.md",
         "share/shadowlab/assets/scenes/still-life.json", "share/shadowlab/shaders/shade_light.frag",
         "include/shadowlab/techniques/plugin.h", "include/shadowlab/glad/gl.h", "lib/cmake/shadowlab/shadowlab-config.cmake"]
# What either package has compiled in, by the packages that it comes from.
COMPILED_IN = ["libcli11-dev", "libeigen3-dev", "libglm-dev", "libimgui-dev", "libtinygltf-dev", "libtinyobjloader-dev",
               "nlohmann-json3-dev"]

# A system with Mesa's drivers has these, in a version that its drivers can live with: a package must bring none of them.
OF_THE_SYSTEM = {"ld-linux-x86-64.so.2", "libc.so.6", "libm.so.6", "libdl.so.2", "libpthread.so.0", "librt.so.1", "libGL.so.1", "libGLX.so.0",
                 "libEGL.so.1", "libOpenGL.so.0", "libGLdispatch.so.0", "libstdc++.so.6", "libgcc_s.so.1", "libz.so.1", "libexpat.so.1",
                 "libX11.so.6", "libX11-xcb.so.1", "libXext.so.6", "libxcb.so.1", "libxcb-shm.so.0"}
# What apt has to bring; the rest is what dpkg-shlibdeps finds. Loaded at run time, so that no tool would miss them.
ASKED_OF_APT = ["libc6", "libstdc++6", "libcairo2", "libglfw3", "libegl1", "libgl1", "libgl1-mesa-dri"]
# Names that Debian 12, Debian 13 and unstable do not share.
OF_ONE_RELEASE = re.compile(r"\blib(embree|stb|tinygltf|tinyobjloader|osmesa)[\w.+-]*")


def dynamic_section(file):
    return subprocess.run(["readelf", "-W", "-d", file], capture_output=True, text=True, check=True, env={"LC_ALL": "C", "PATH": "/usr/bin:/bin"}).stdout


def needed_by(file):
    return re.findall(r"\(NEEDED\)\s+Shared library: \[(.+?)\]", dynamic_section(file))


def of_files(prefix):
    for name in FILES:
        if not (prefix / name).is_file():
            yield f"{name} is missing"
    if (prefix / PROGRAM).is_file() and not (prefix / PROGRAM).stat().st_mode & 0o111:
        yield f"{PROGRAM} cannot be run"
    if not list((prefix / "share/man/man1").glob("shadowlab.1*")):
        yield "there is no manual page"
    for package in COMPILED_IN:
        if not (prefix / LICENCES / package).is_file() or not (prefix / LICENCES / package).stat().st_size:
            yield f"the licence of what comes from {package} is missing"


def of_menu(prefix):
    """The menu entry, its program, and its icon in each size that it is said to have."""
    if not (prefix / DESKTOP).is_file():
        return
    entry = configparser.ConfigParser(interpolation=None)
    entry.optionxform = str
    entry.read(prefix / DESKTOP, encoding="utf-8")
    values = dict(entry["Desktop Entry"]) if entry.has_section("Desktop Entry") else {}
    for key in ("Type", "Name", "Comment", "Exec", "Icon", "Categories"):
        if not values.get(key):
            yield f"the menu entry has no {key}"
    if not (prefix / "bin" / values.get("Exec", "?").split()[0]).is_file():
        yield f"the menu entry starts what is not there: {values.get('Exec')}"
    for size in ICON_SIZES:
        icon = prefix / ICONS / f"{size}x{size}" / "apps" / f"{values.get('Icon', '?')}.png"
        if not icon.is_file():
            yield f"the menu entry's icon is missing in {size} x {size}"
        elif struct.unpack(">II", icon.read_bytes()[16:24]) != (size, size):
            yield f"{icon.name} is not of {size} x {size} pixels"
    if shutil.which("desktop-file-validate"):
        said = subprocess.run(["desktop-file-validate", prefix / DESKTOP], capture_output=True, text=True, check=False)
        if said.returncode != 0 or said.stdout:
            yield f"desktop-file-validate: {said.stdout}{said.stderr}"


def of_taken_along(prefix, brought_by_apt=False):
    """Every library that is needed is taken along or is the system's; nothing is taken along that is the system's or that nothing needs."""
    if not (prefix / PROGRAM).is_file():
        return
    if RPATH not in " ".join(dynamic_section(prefix / PROGRAM).split()):
        yield f"{PROGRAM} does not look for its libraries in {LIBRARIES}"
    there = {file.name: file for file in (prefix / LIBRARIES).glob("*")}
    needed = set()
    for file in [prefix / PROGRAM, *there.values()]:
        for name in needed_by(file):
            needed.add(name)
            if name not in there and name not in OF_THE_SYSTEM and not brought_by_apt:
                yield f"{file.name} needs {name}, which a bare system lacks"
    for name in sorted(there):
        if name in OF_THE_SYSTEM:
            yield f"{name} is taken along, and would stand in the way of the system's drivers"
        elif name not in needed:
            yield f"{name} is taken along, and nothing needs it"
    if len(list((prefix / LICENCES).glob("*"))) < len(COMPILED_IN) + (1 if there else 0):
        yield "the licences of what is taken along are missing"


def of_archive(prefix):
    yield from of_files(prefix)
    yield from of_menu(prefix)
    yield from of_taken_along(prefix)
    for name in ("README", "include/shadowlab/glm/glm.hpp"):
        if not (prefix / name).is_file():
            yield f"{name} is missing"


def of_control(control, checksums, files):
    """The fields of a .deb, its list of checksums, and its list of files."""
    if control.get("Package") != "shadowlab" or not re.fullmatch(r"\d+\.\d+\.\d+", control.get("Version", "")):
        yield f"the package is called {control.get('Package')} {control.get('Version')}"
    if control.get("Architecture") not in ("amd64", "arm64"):
        yield f"the package is for {control.get('Architecture')}"
    asked = re.findall(r"(?:^|,)\s*([\w.+-]+)", control.get("Depends", ""))
    for name in ASKED_OF_APT:
        if name not in asked:
            yield f"the package does not depend on {name}"
    for name in OF_ONE_RELEASE.finditer(", ".join(control.get(field, "") for field in ("Depends", "Recommends"))):
        yield f"the package depends on {name.group()}, which not every release has"
    without_sum = {f for f in files if not f.startswith("etc/")} - set(checksums)
    if without_sum or not files:
        yield f"there is no checksum of {sorted(without_sum)[:3] or 'anything'}"


def of_deb(unpacked, control, checksums, files):
    prefix = unpacked / "usr"
    yield from of_control(control, checksums, files)
    yield from of_files(prefix)
    yield from of_menu(prefix)
    yield from of_taken_along(prefix, brought_by_apt=True)
    if not (prefix / "share/doc/shadowlab/changelog.gz").is_file():
        yield "the list of changes is missing"
    strangers = [f for f in files if not f.startswith("usr/")]
    if strangers:
        yield f"the package writes outside of /usr: {strangers[:3]}"
