// `shadowlab new-technique`: a folder in which a technique of one's own is built as a plug-in.
// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "app/cli/messages.h"
#include "app/context/assets.h"
#include "app/course/capture_words.h"
#include "app/student/skeletons.h"

namespace shadowlab::cli {

namespace {

std::filesystem::path ownFile() {
    std::error_code failed;
    const auto file = std::filesystem::read_symlink("/proc/self/exe", failed);
    return failed ? "shadowlab" : file;
}

/// What CMake has to be told to find the package of this very program.
std::string whereThePackageIs() {
    const std::filesystem::path folder = ownFile().parent_path();
    if (!context::installedShare()) return "-Dshadowlab_DIR=" + folder.string();
    const std::filesystem::path prefix = folder.parent_path();
    return prefix == "/usr" || prefix == "/usr/local" ? "" : "-DCMAKE_PREFIX_PATH=" + prefix.string();
}

std::string line(const std::vector<std::string>& words) { return "    " + course::asCommandLine(words) + "\n"; }

} // namespace

int newTechnique(const NewTechniqueOptions& options) {
    student::writeSkeleton(options.from, options.name, options.output);
    const std::string folder = options.output.string(), build = (options.output / "build").string();
    std::string file = options.name;
    for (char& c : file)
        c = c == '-' ? '_' : c;
    const std::string plugin = build + "/" + file + ".so", program = ownFile().string();
    std::vector<std::string> configure{"cmake", "-S", folder, "-B", build};
    if (const std::string where = whereThePackageIs(); !where.empty()) configure.push_back(where);
    print("Written: " + folder + "\nNow build it, and look at it:\n" + line(configure) +
          line({"cmake", "--build", build}) + line({program, "demo", "sphere-on-plane", "--plugin", plugin}));
    if (options.from != "empty")
        print("Fill in the blanks (README.md there lists them), and see how far it is:\n" +
              line({program, "grade", "--plugin", plugin}));
    return 0;
}

} // namespace shadowlab::cli
