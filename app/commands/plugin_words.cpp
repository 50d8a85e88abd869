// SPDX-License-Identifier: MIT
#include "app/commands/plugin_words.h"

#include <algorithm>

#include "app/commands/option_values.h"

namespace shadowlab::commands {

PluginWords takePluginWords(const std::vector<std::string>& argv) {
    const std::string option = "--plugin";
    PluginWords taken;
    const auto take = [&](const std::string& file) {
        if (file.empty()) refuseUsage("--plugin: its value is missing; write --plugin FILE.so");
        if (std::ranges::find(taken.files, file) != taken.files.end())
            refuseUsage("--plugin " + file + " is given twice; give it once");
        taken.files.push_back(file);
    };
    for (std::size_t i = 0; i < argv.size(); ++i) {
        if (argv[i] == "--") {
            taken.words.insert(taken.words.end(), argv.begin() + static_cast<std::ptrdiff_t>(i), argv.end());
            break;
        }
        if (argv[i] == option)
            take(++i < argv.size() ? argv[i] : "");
        else if (argv[i].starts_with(option + "="))
            take(argv[i].substr(option.size() + 1));
        else
            taken.words.push_back(argv[i]);
    }
    return taken;
}

} // namespace shadowlab::commands
