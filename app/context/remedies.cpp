// Advice for the case that a backend does not work.
// SPDX-License-Identifier: MIT
#include "app/context/backends.h"
#include "app/context/packages.h"

namespace shadowlab::context {

namespace {
std::string orOsmesa() { return isOsmesaHere() ? ", or take --backend osmesa" : ""; }
} // namespace

std::string remedyEgl() { return remedyPackages({"libegl1", "libgl1-mesa-dri"}); }

std::string remedyOsmesa() {
    if (!hasOsmesaPackage())
        return "take --backend egl, which does the same without a display (Mesa ended OSMesa in 25.1)";
    return remedyPackages({"libosmesa6"}) + ", or take --backend egl";
}

std::string remedyDrivers() { return remedyPackages({"libgl1-mesa-dri"}) + orOsmesa(); }

std::string remedyEglDrivers() { return remedyPackages({"libegl-mesa0", "libgl1-mesa-dri"}) + orOsmesa(); }

std::string remedyWindowDrivers() { return remedyPackages({"libgl1", "libgl1-mesa-dri"}) + ", or take --backend egl"; }

std::string remedyDisplay() { return "start it in a desktop session, or take --backend egl, which needs no display"; }

std::string remedyAll() {
    // Where EGL has its packages and a variable leads it elsewhere, one more package changes nothing.
    if (const std::string egl = remedyEgl(); egl.starts_with("unset ")) return egl;
    std::vector<std::string> packages{"libegl1", "libgl1-mesa-dri"};
    if (hasOsmesaPackage()) packages.emplace_back("libosmesa6");
    return remedyPackages(packages);
}

} // namespace shadowlab::context
