// SPDX-License-Identifier: MIT
#include "app/context/packages.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "techniques/foundation/base/software.h"

namespace shadowlab::context {

namespace {

/// Each leads the loaders of EGL, GLX and Mesa to other drivers than those of the packages.
constexpr std::array<const char*, 5> kLeadAstray{"LIBGL_DRIVERS_PATH", "__EGL_VENDOR_LIBRARY_DIRS",
                                                 "__EGL_VENDOR_LIBRARY_FILENAMES", "MESA_LOADER_DRIVER_OVERRIDE",
                                                 "GALLIUM_DRIVER"};

bool leadsAstray(const char* name) {
    const char* const value = std::getenv(name);
    return value && *value && !isSoftware(value); // these drivers every Mesa has
}

std::string textOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// dpkg's database; DPKG_ADMINDIR names another one, as it does for dpkg itself.
std::filesystem::path dpkgFolder() {
    const char* const given = std::getenv("DPKG_ADMINDIR");
    return given && *given ? given : "/var/lib/dpkg";
}

/// Value of `KEY=value` or `KEY="value"`.
std::string valueOf(std::string_view key, std::string_view lines) {
    const std::string begin = "\n" + std::string(key) + "=";
    const std::string text = "\n" + std::string(lines) + "\n";
    const std::size_t at = text.find(begin);
    if (at == std::string::npos) return "";
    std::string value = text.substr(at + begin.size(), text.find('\n', at + 1) - at - begin.size());
    std::erase(value, '"');
    return value;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += " " + word;
    return text;
}

} // namespace

bool isInstalled(std::string_view package, const std::filesystem::path& dpkgFolder) {
    const std::string all = "\n" + textOf(dpkgFolder / "status");
    const std::string begin = "\nPackage: " + std::string(package) + "\n";
    // One paragraph for each architecture.
    for (std::size_t at = all.find(begin); at != std::string::npos; at = all.find(begin, at + 1)) {
        const std::string paragraph = all.substr(at, all.find("\n\n", at) - at);
        if (paragraph.find("\nStatus: install ok installed") != std::string::npos) return true;
    }
    return false;
}

std::string remedyPackages(const std::vector<std::string>& packages) {
    const std::filesystem::path dpkg = dpkgFolder();
    if (!std::filesystem::exists(dpkg / "status")) return "install what Debian calls" + joined(packages);
    std::vector<std::string> missing;
    std::ranges::copy_if(packages, std::back_inserter(missing),
                         [&](const std::string& package) { return !isInstalled(package, dpkg); });
    if (!missing.empty()) return "apt install" + joined(missing);
    if (const auto astray = std::ranges::find_if(kLeadAstray, leadsAstray); astray != kLeadAstray.end())
        return std::string("unset ") + *astray;
    return "apt reinstall" + joined(packages) + ", which should have it";
}

bool hasOsmesaPackage(std::string_view osRelease) {
    // The last releases with Mesa 25.0 or older. Those of unstable and testing have no number.
    constexpr int kLastDebian = 13, kLastUbuntu = 25; // 25.04; 25.10 has no more
    const std::string id = valueOf("ID", osRelease), version = valueOf("VERSION_ID", osRelease);
    int number = 0;
    std::from_chars(version.data(), version.data() + version.size(), number);
    if (number == 0) return false;
    return (id == "debian" && number <= kLastDebian) || (id == "ubuntu" && number <= kLastUbuntu && version != "25.10");
}

bool hasOsmesaPackage() { return hasOsmesaPackage(textOf("/etc/os-release")); }

} // namespace shadowlab::context
