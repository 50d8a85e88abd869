// What is said of Debian's packages when a library is missing: none that is installed, none that cannot be had.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace shadowlab::context {

/// How to come by what these packages hold: "apt install" of those that are not installed. Where all of them are, an environment
/// variable leads their libraries astray, or one of them is damaged.
std::string mendPackages(const std::vector<std::string>& packages);

/// Whether this system's distribution has the package libosmesa6: Mesa ended OSMesa in 25.1.
bool hasOsmesaPackage();

// --- what both are made of

/// `dpkgFolder`: with the file "status".
bool isInstalled(std::string_view package, const std::filesystem::path& dpkgFolder);
/// By the lines of /etc/os-release.
bool hasOsmesaPackage(std::string_view osRelease);

} // namespace shadowlab::context
