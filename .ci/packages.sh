# Shared by ./demo and ./check: which Debian packages the project needs, how missing ones are installed, how a step is run.
# To be sourced, with `root` set to the folder of the checkout and `log` to the file that long output goes to.
# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2034,SC2154

# `ONE|OTHER` is the first of them that apt has, with nothing behind the last bar: where it has none, none is needed. Releases differ.
# To build and run the program. libgtest-dev and librapidcheck-dev: configuring looks for them, though nothing links them yet.
# libegl1, libgl1-mesa-dri and libosmesa6 are loaded at run time, and no other package pulls all three in; Debian 13 is the last
# with OSMesa, which Mesa ended in 25.1.
build_packages=(
    g++ cmake ninja-build python3-glad
    libcairo2-dev libcli11-dev libegl-dev libeigen3-dev libfreetype-dev libglfw3-dev libglm-dev libgtest-dev libimgui-dev
    libpng-dev librapidcheck-dev libtinygltf-dev libtinyobjloader-dev libturbojpeg0-dev libwebp-dev nlohmann-json3-dev pkgconf zlib1g-dev
    libegl1 libgl1-mesa-dri 'libosmesa6|'
)
# To run the tests as well: xvfb and xauth are the display of those that need one, xdotool the hands at its keys and mouse,
# python3-xlib those that drop files on it. dpkg-dev and file make packages; dpkg-dev brings make, with which plug-ins are built.
# locales: one with a decimal comma is made of it. bubblewrap is the sandbox in which students' plug-ins are graded.
test_packages=('bubblewrap|' dpkg-dev file glslang-tools locales python3 python3-xlib xauth xdotool xvfb)
# For the long form: fuzz targets are built with clang (14, which `clang` stands for on Debian 12, does not know all of C++20 that is
# used here), setarch runs tests under the thread sanitizer, and zink draws by Mesa's Vulkan driver for
# processors (tests/systems/drivers.py). Blender draws what radiosity is held against (tests/systems/cycles_check.py); Blender, POV-Ray
# and three.js (npm) in Chromium draw exported scenes (tests/systems/foreign_check.py). Chromium and Firefox open slides that can be explored
# (tests/systems/explore_check.py).
long_packages=('blender|' 'chromium|' 'clang-16|clang' 'firefox-esr|' 'libclang-rt-16-dev|libclang-rt-dev' mesa-vulkan-drivers 'npm|' 'povray|'
    'python3-websocket|' util-linux)

# Debian's own tools and libraries, whatever else (conda, pyenv, a home-made cmake) is installed and first in the PATH.
use_debian_tools() {
    export PATH=/usr/sbin:/usr/bin:/sbin:/bin
    unset AR AS CC CXX CFLAGS CXXFLAGS CPPFLAGS LD LDFLAGS CPATH C_INCLUDE_PATH CPLUS_INCLUDE_PATH LIBRARY_PATH
    unset CMAKE_PREFIX_PATH CMAKE_MODULE_PATH CMAKE_INCLUDE_PATH CMAKE_LIBRARY_PATH CMAKE_TOOLCHAIN_FILE CMAKE_GENERATOR
    unset CMAKE_BUILD_TYPE PKG_CONFIG_PATH PYTHONHOME PYTHONPATH
}

say() { printf '%s\n' "$*" >&2; }

# One line on what stands in the way from the beginning, and how to go on.
refuse() {
    say "$(basename "$0"): $*"
    exit 1
}

# One line on what failed, and how to go on. The log's last lines come first: they usually say why.
fail() {
    if [[ -s ${log:-} ]]; then
        tail -n 25 "$log" >&2
        refuse "$* (log: $log)"
    fi
    refuse "$*"
}

# What clang's programs end in, those of `long_packages`.
clang_ending() { if [[ -x /usr/bin/clang-16 ]]; then printf -- -16; fi; }

# Whole answers are read: a pipe that is closed at the first match would make apt-cache fail, and the package look as if there were none.
is_installed() { [[ " $(dpkg-query -W -f '${db:Status-Status} ' "$1" 2>/dev/null)" == *' installed '* ]]; }
is_offered() { [[ $(LC_ALL=C apt-cache policy "$1" 2>/dev/null) == *$'\n  Candidate: '[^\(]* ]]; }

# missing_of PACKAGE...: the names of those that are not there yet, as far as apt knows of any.
missing_of() {
    local package names name
    for package in "$@"; do
        IFS='|' read -ra names <<<"$package"
        for name in "${names[@]}"; do
            if is_installed "$name"; then continue 2; fi
        done
        for name in "${names[@]}"; do
            if is_offered "$name"; then
                printf '%s\n' "$name"
                continue 2
            fi
        done
        if [[ $package != *'|' ]]; then printf '%s\n' "${names[0]}"; fi
    done
}

# install_missing PACKAGE...: installs with apt what is not there yet, and says so before.
install_missing() {
    if [[ ! -x /usr/bin/dpkg-query || ! -x /usr/bin/apt-get ]]; then
        say "$(basename "$0"): this is no Debian system, so nothing is installed; needed is what Debian calls: $*"
        return
    fi
    local missing=()
    mapfile -t missing < <(missing_of "$@")
    if ((${#missing[@]} == 0)); then return; fi

    local as_root=(env DEBIAN_FRONTEND=noninteractive)
    local manually="apt-get install --no-install-recommends ${missing[*]}"
    say "Missing, to be installed with apt: ${missing[*]}"
    if ((EUID != 0)); then
        [[ -x /usr/bin/sudo ]] || fail "these packages are missing, and there is no sudo; run as root: $manually"
        sudo true || fail "these packages are missing, and sudo was refused; run as root: $manually"
        as_root=(sudo "${as_root[@]}")
    fi
    local apt=("${as_root[@]}" apt-get -y -o DPkg::Lock::Timeout=120)
    "${apt[@]}" update </dev/null >"$log" 2>&1 || say "apt-get update had errors; trying with the package lists there are"
    mapfile -t missing < <(missing_of "$@") # which names there are, apt may only know now
    "${apt[@]}" install --no-install-recommends "${missing[@]}" </dev/null >"$log" 2>&1 ||
        fail "apt could not install the packages; mend that and try again, or run as root: $manually"
}

# configure PRESET [OPTION...]: makes build/PRESET when it is not there, was made by other presets, or belongs to another place
# (a build folder cannot be moved). Everything else that changes, ninja sees by itself.
configure() {
    local folder=$root/build/$1 preset=$1 fresh=()
    shift
    if [[ -f $folder/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
        fresh=(--fresh)
    elif [[ -f $folder/build.ninja && ! $root/CMakePresets.json -nt $folder/build.ninja ]]; then
        return
    fi
    (cd "$root" && cmake --preset "$preset" "${fresh[@]}" "$@") >"$log" 2>&1 || fail "cmake could not configure build/$preset"
    touch "$folder/build.ninja"
}

# build PRESET TARGET...: silent when there is nothing to do. On a terminal the current step shows in one line.
build() {
    local folder=$root/build/$1 announced=
    shift
    ninja -C "$folder" -j "$(nproc)" "$@" 2>&1 | tee "$log" | while IFS= read -r line; do
        [[ $line == \[*/*\]* && $line != *Re-checking* ]] || continue
        if [[ -z $announced ]]; then
            announced=yes
            say "Building in $folder ..."
        fi
        if [[ -t 2 ]]; then printf '\r\033[K%s' "${line:0:$((${COLUMNS:-80} - 1))}" >&2; fi
    done || {
        if [[ -t 2 ]]; then printf '\n' >&2; fi
        fail "the build failed"
    }
    if [[ -t 2 ]]; then printf '\r\033[K' >&2; fi
}

# Two runs at a time would build into one folder: the second waits for the first, and then begins the log.
lock_build_folder() {
    local mend="use a checkout of your own, or mend the permissions of this one"
    mkdir -p "$root/build" 2>/dev/null || refuse "$root/build cannot be made; $mend"
    # What bash itself has to say stays unheard: it comes to the same.
    { exec {lock_fd}>"$root/build/.lock"; } 2>/dev/null || refuse "$root/build/.lock cannot be written; $mend"
    if ! flock -n "$lock_fd"; then
        say "Waiting for another run in the same checkout ..."
        flock "$lock_fd"
    fi
    { : >"$log"; } 2>/dev/null || refuse "$log cannot be written; $mend"
}
unlock_build_folder() { exec {lock_fd}>&-; }
