// Which of Debian's packages to install when a library is missing: only those that are not installed and that exist.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace shadowlab::context {

/// "apt install" of those packages that are not installed. Where all of them are, the message says that an environment variable
/// leads to other libraries, or that a package is damaged.
std::string remedyPackages(const std::vector<std::string>& packages);

/// Whether this system's distribution has the package libosmesa6: Mesa ended OSMesa in 25.1.
bool hasOsmesaPackage();

// --- parts of both, for tests

/// `dpkgFolder`: with the file "status".
bool isInstalled(std::string_view package, const std::filesystem::path& dpkgFolder);
/// By the lines of /etc/os-release.
bool hasOsmesaPackage(std::string_view osRelease);

} // namespace shadowlab::context
