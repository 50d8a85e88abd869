// `shadowlab new-technique`: a folder in which a technique of one's own is built as a plug-in.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <string>

#include "app/cli/command.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/context/assets.h"
#include "app/course/capture_arguments.h"
#include "app/student/skeletons.h"

namespace shadowlab::cli {

namespace {

struct NewTechniqueOptions {
    std::string name;             ///< the technique's id: "my-shadows"
    std::string from = "empty";   ///< a skeleton
    std::filesystem::path output; ///< the folder to be made; empty: NAME in the current one
};

void describeNewTechnique(DescribedOptions& add) {
    add.option("NAME", "", "id of the technique: small letters, digits and hyphens, as my-shadows");
    add.option(
        "--from", "SKELETON",
        "what to begin with: empty (a technique without shadows), or one of the lecture's algorithms with blanks to "
        "be filled in: planar, shadow-map, z-fail, ray-tracing, radiosity (default empty)");
    add.option("-o,--output", "DIR", "the folder to be made (default: NAME)");
    add.footer("The folder has a README with the commands that build and try it.\n"
               "Examples:\n"
               "  shadowlab new-technique my-shadows\n"
               "  shadowlab new-technique anna-z-fail --from z-fail -o exercises/anna");
}

NewTechniqueOptions newTechniqueOptions(const GivenOptions& given) {
    NewTechniqueOptions options;
    options.name = given.required("NAME", "shadowlab new-technique my-shadows");
    const std::vector<std::string> skeletons = student::skeletonNames();
    options.from = skeletons[static_cast<std::size_t>(choiceFrom("--from", given.text("--from", "empty"), skeletons))];
    options.output = given.text("--output", options.name);
    return options;
}

std::filesystem::path ownFile() {
    std::error_code failed;
    const auto file = std::filesystem::read_symlink("/proc/self/exe", failed);
    return failed ? "shadowlab" : file;
}

/// The argument of CMake with which it finds the package that this program belongs to.
std::string whereThePackageIs() {
    const std::filesystem::path folder = ownFile().parent_path();
    if (!context::installedShare()) return "-Dshadowlab_DIR=" + folder.string();
    const std::filesystem::path prefix = folder.parent_path();
    return prefix == "/usr" || prefix == "/usr/local" ? "" : "-DCMAKE_PREFIX_PATH=" + prefix.string();
}

std::string line(const std::vector<std::string>& words) { return "    " + course::asCommandLine(words) + "\n"; }

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
          line({"cmake", "--build", build}) +
          line({program, "demo", student::sceneToTry(options.from), "--plugin", plugin}));
    if (options.from != "empty")
        print("Fill in the blanks (README.md there lists them), and see how far it is:\n" +
              line({program, "grade", "--plugin", plugin}));
    return 0;
}

Work newTechniqueWork(const GivenOptions& given) {
    return [options = newTechniqueOptions(given)] { return newTechnique(options); };
}

} // namespace

const Command kNewTechnique{"new-technique", "NAME",
                            "Writes a folder in which a technique of your own is built as a plug-in",
                            describeNewTechnique, newTechniqueWork};

} // namespace shadowlab::cli
