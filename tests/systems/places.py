"""Where a package is tried: a bare folder on this machine, or a clean system in a folder of its own. Both run words in a home folder
as if nothing else were set."""
# SPDX-License-Identifier: MIT
import os
import shutil
import subprocess
from pathlib import Path

BARE_PATH = "/usr/bin:/bin"
USER = 1000  # no root: a package has to serve one who may only write to a home folder
LIMIT = 300  # seconds; the slowest step, grading a plug-in, takes some 10 on two cores


class Failed(Exception):
    pass


def expect(condition, what):
    if not condition:
        raise Failed(what)


class Here:
    """This machine, with an empty environment."""

    def __init__(self, folder):
        self.home = self.inside = Path(folder)

    def environment(self, settings):
        return [f"HOME={self.inside}", f"PATH={BARE_PATH}", *(f"{key}={value}" for key, value in settings.items())]

    def words(self, words, settings):
        return ["env", "-i", "-C", str(self.inside), *self.environment(settings), *map(str, words)]

    def start(self, *words, **settings):
        return subprocess.Popen(self.words(words, settings), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace")

    def run(self, *words, status=0, limit=LIMIT, **settings):
        process = self.start(*words, **settings)
        try:
            out, err = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            process.kill()
            raise Failed(f"{' '.join(map(str, words))}: not done after {limit} s") from None
        expect(process.returncode == status,
               f"$ {' '.join(map(str, words))}\nstatus {process.returncode}, expected was {status}\n{out[-2000:]}{err[-2000:]}")
        return out


class CleanSystem(Here):
    """A copy of a system that debootstrap has made, gone afterwards unless it is to be kept. What is mounted is mounted for one
    command only."""

    # What is run in it: its own processes and none of ours, and the X server of this machine, if it has one.
    ENTER = ('mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" && mkdir -p "$1/tmp/.X11-unix" && { [ ! -d /tmp/.X11-unix ] || '
             'mount --bind /tmp/.X11-unix "$1/tmp/.X11-unix"; } && system=$1 user=$2 && shift 2 && exec chroot --userspec="$user" '
             '"$system" "$@"')
    # The same without a network and without the X server of this machine: X servers inside have all their numbers to themselves.
    ENTER_ALONE = ('mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" && ip link set lo up && system=$1 user=$2 && shift 2 && '
                   'exec chroot --userspec="$user" "$system" "$@"')

    def __init__(self, pristine, keep=False):
        self.pristine = Path(pristine).resolve()
        self.root = self.pristine.with_name(f"{self.pristine.name}-packages-{os.getpid()}")
        self.inside = Path("/", "home", "student")
        self.home = self.root / "home" / "student"
        self.user = f"{USER}:{USER}"
        self.alone = False
        self.keep = keep

    def __enter__(self):
        expect(os.geteuid() == 0, "a clean system can be entered by root alone; run this as root, or without --system")
        expect((self.pristine / "etc/debian_version").is_file(), f"{self.pristine} is no Debian system; make one with debootstrap")
        try:
            subprocess.run(["cp", "-a", "--reflink=auto", self.pristine, self.root], check=True)
            self.home.mkdir()
            os.chown(self.home, USER, USER)
            # Lists of packages may be old where the clock is not theirs.
            self.as_root("apt-get", "update", "-qq", "-o", "Acquire::Check-Valid-Until=false")
        except BaseException:
            self.keep = False
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        if not self.keep:
            shutil.rmtree(self.root, ignore_errors=True)

    def words(self, words, settings):
        work = "/" if self.user == "0:0" else str(self.inside)
        apart = ["unshare", "--mount", "--pid", "--fork", "--kill-child", *(["--net"] if self.alone else [])]
        return [*apart, "sh", "-c", self.ENTER_ALONE if self.alone else self.ENTER, "sh", str(self.root), self.user, "env", "-i",
                "-C", work, *self.environment(settings), *map(str, words)]

    def environment(self, settings):
        # sbin: what dpkg runs.
        return [*super().environment(settings), "PATH=/usr/sbin:/usr/bin:/sbin:/bin", "DEBIAN_FRONTEND=noninteractive"]

    def as_root(self, *words, **settings):
        self.user = "0:0"
        try:
            return self.run(*words, **settings)
        finally:
            self.user = f"{USER}:{USER}"

    def install(self, *packages):
        self.as_root("apt-get", "install", "-y", "-qq", "--no-install-recommends", *packages)
