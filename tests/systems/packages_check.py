#!/usr/bin/env python3
"""Makes the packages of a build folder, looks into them, and uses what is in them.

packages_check.py BUILD_FOLDER                 the archive is unpacked in a temporary folder, and used with an empty environment;
                                               with SHADOWLAB_LONG also with a display
packages_check.py BUILD_FOLDER --system DIR... as root: in a copy of each clean system (`debootstrap --variant=minbase SUITE DIR`) the .deb
                                               is installed, used and removed, and the archive is used, by one who is not root.
                                               Needs xvfb and xdotool here, and a mirror of Debian for the systems
"""
# SPDX-License-Identifier: MIT
import argparse
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import package_rules
from places import USER, CleanSystem, Failed, Here, expect
from usage import Use

MESA = ("libegl1", "libgl1", "libgl1-mesa-dri")  # what archive_readme.txt asks for
COMPILER = ("g++", "cmake", "make")  # plugins.md; make is what apt adds to cmake by itself
ARCHIVE, DEB = "shadowlab-*.tar.gz", "shadowlab_*.deb"
ONE_SLIDE = "seen-by-the-light"


def said(*words):
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, check=False)
    expect(done.returncode == 0, f"$ {' '.join(map(str, words))}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


def pack(kind, pattern, build_folder, place, *settings):
    said("cpack", "-G", kind, "--config", build_folder / "CPackConfig.cmake", "-B", place / kind, *settings)
    made = the_one(place / kind, pattern)
    print(f"{made.name}: {made.stat().st_size / 1e6:.1f} MB", flush=True)
    return made


def the_one(folder, pattern):
    found = list(folder.glob(pattern))
    expect(len(found) == 1, f"one {pattern} is expected, not {len(found)}")
    return found[0]


def unpack(archive, folder):
    """Returns the folder that the archive makes: one, so that nothing else is overwritten."""
    folder.mkdir(parents=True)
    with tarfile.open(archive) as file:
        # Where Python knows filters (3.11.4, 3.12), that of data: nothing outside of the folder, nothing that is no file.
        file.extractall(folder, **({"filter": "data"} if hasattr(tarfile, "data_filter") else {}))
    made = list(folder.iterdir())
    expect(len(made) == 1 and made[0].is_dir(), f"the archive makes one folder, not {[m.name for m in made]}")
    return made[0]


def without_complaints(what, complaints):
    complaints = list(complaints)
    expect(not complaints, "".join(f"\n  {what}: {complaint}" for complaint in complaints))


def look_into(deb, place):
    said("dpkg-deb", "-R", deb, place)
    sums = (place / "DEBIAN/md5sums").read_text() if (place / "DEBIAN/md5sums").is_file() else ""
    for line in said("dpkg-deb", "-c", deb).splitlines():
        expect(line.split()[1] == "root/root", f"a file of the package does not belong to root: {line}")
    control = dict(re.findall(r"^([\w-]+): (.*)$", (place / "DEBIAN/control").read_text(), re.MULTILINE))
    files = [f.relative_to(place).as_posix() for f in place.rglob("*") if f.is_file() and "DEBIAN" not in f.parts]
    without_complaints(deb.name, package_rules.of_deb(place, control, re.findall(r"^[0-9a-f]{32}  (.+)$", sums, re.MULTILINE), files))
    if shutil.which("lintian"):
        said("lintian", "--allow-root", "--fail-on", "error", deb)
    else:
        print("lintian is not installed, and has not been asked", flush=True)


def use_here(archive, place):
    home = place / "a home with blanks"
    folder = unpack(archive, home / "Downloads")
    without_complaints(archive.name, package_rules.of_archive(folder))
    use = Use(Here(home), folder / "bin/shadowlab")
    if os.environ.get("SHADOWLAB_LONG"):
        everything(use)
        return
    use.pictures()
    use.slides("--only", ONE_SLIDE)
    use.technique()


def use_in(system, archive, deb):
    shutil.copy(deb, system.root / "tmp")
    system.install(f"/tmp/{deb.name}")
    system.install(*COMPILER, "libglm-dev")
    everything(Use(system, "shadowlab"))
    files = [Path(line) for line in system.as_root("dpkg", "-L", "shadowlab").splitlines()]
    files = [file for file in files if (system.root / file.relative_to("/")).is_file()]
    expect(len(files) > 100, "the installed package has files")
    clean(system.home)
    (system.root / "tmp" / deb.name).unlink()
    system.as_root("apt-get", "purge", "-y", "-qq", "shadowlab", "libglm-dev")
    system.as_root("apt-get", "autoremove", "--purge", "-y", "-qq")
    left = [file for file in files if (system.root / file.relative_to("/")).exists()]
    left += [line for line in system.as_root("find", "/", "-xdev", "-iname", "*shadowlab*").splitlines() if line]
    expect(not left, f"the package has been removed, and left behind: {left[:5]}")

    system.install(*MESA)
    folder = unpack(archive, system.home / "my programs")
    said("chown", "-R", f"{USER}:{USER}", system.home)
    everything(Use(system, system.inside / folder.relative_to(system.home) / "bin/shadowlab"))


def everything(use):
    use.pictures()
    use.window()
    use.slides()
    use.technique()


def clean(home):
    for left in home.iterdir():
        shutil.rmtree(left) if left.is_dir() else left.unlink()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build_folder", type=Path)
    parser.add_argument("--system", type=Path, nargs="+", default=[])
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="shadowlab packages ") as temporary:
        place = Path(temporary)
        build_folder = options.build_folder.resolve()
        with ThreadPoolExecutor() as pool:  # the .deb takes as long to make as the archive to use
            # Not compressed where it is only looked into: that takes less time.
            loose = [] if options.system else ["-D", "CPACK_DEBIAN_COMPRESSION_TYPE=none"]
            deb = pool.submit(pack, "DEB", DEB, build_folder, place, *loose)
            archive = pack("TGZ", ARCHIVE, build_folder, place)
            use_here(archive, place)
            deb = deb.result()
        look_into(deb, place / "deb")
        for pristine in options.system:
            with CleanSystem(pristine) as system:
                use_in(system, archive, deb)
                print(f"{pristine.name}: Debian {(system.root / 'etc/debian_version').read_text().strip()}: the package and the archive serve", flush=True)


if __name__ == "__main__":
    try:
        main()
    except Failed as failed:
        sys.exit(f"packages_check: {failed}")
