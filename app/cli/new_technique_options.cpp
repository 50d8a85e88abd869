// SPDX-License-Identifier: MIT
#include "app/cli/new_technique_options.h"

#include <CLI/CLI.hpp>

#include "app/cli/option_values.h"
#include "app/student/skeletons.h"

namespace shadowlab::cli {

void describeNewTechnique(CLI::App& command) {
    addOption(command, "NAME", "", "id of the technique: small letters, digits and hyphens, as my-shadows");
    addOption(command, "--from", "SKELETON",
              "what to begin with: empty (a technique without shadows), planar, shadow-map or z-fail, the lecture's "
              "algorithms with blanks to be filled in (default empty)");
    addOption(command, "-o,--output", "DIR", "the folder to be made (default: NAME)");
    command.footer("The folder has a README with the commands that build and try it.\n"
                   "Examples:\n"
                   "  shadowlab new-technique my-shadows\n"
                   "  shadowlab new-technique anna-z-fail --from z-fail -o exercises/anna");
}

NewTechniqueOptions newTechniqueOptions(const CLI::App& command) {
    const GivenOptions given(command);
    NewTechniqueOptions options;
    options.name = given.required("NAME", "shadowlab new-technique my-shadows");
    const std::vector<std::string> skeletons = student::skeletonNames();
    options.from = skeletons[static_cast<std::size_t>(choiceFrom("--from", given.text("--from", "empty"), skeletons))];
    options.output = given.text("--output", options.name);
    return options;
}

} // namespace shadowlab::cli
