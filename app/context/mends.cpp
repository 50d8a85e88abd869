// Advice for the case that a backend does not work.
// SPDX-License-Identifier: MIT
#include "app/context/backends.h"
#include "app/context/packages.h"

namespace shadowlab::context {

namespace {
std::string orOsmesa() { return isOsmesaHere() ? ", or take --backend osmesa" : ""; }
} // namespace

std::string mendEgl() { return mendPackages({"libegl1", "libgl1-mesa-dri"}); }

std::string mendOsmesa() {
    if (!hasOsmesaPackage())
        return "take --backend egl, which does the same without a display (Mesa ended OSMesa in 25.1)";
    return mendPackages({"libosmesa6"}) + ", or take --backend egl";
}

std::string mendDrivers() { return mendPackages({"libgl1-mesa-dri"}) + orOsmesa(); }

std::string mendEglDrivers() { return mendPackages({"libegl-mesa0", "libgl1-mesa-dri"}) + orOsmesa(); }

std::string mendWindowDrivers() { return mendPackages({"libgl1", "libgl1-mesa-dri"}) + ", or take --backend egl"; }

std::string mendDisplay() { return "start it in a desktop session, or take --backend egl, which needs no display"; }

std::string mendAll() {
    // Where EGL has its packages and a variable leads it elsewhere, one more package mends nothing.
    if (const std::string egl = mendEgl(); egl.starts_with("unset ")) return egl;
    std::vector<std::string> packages{"libegl1", "libgl1-mesa-dri"};
    if (hasOsmesaPackage()) packages.emplace_back("libosmesa6");
    return mendPackages(packages);
}

} // namespace shadowlab::context
