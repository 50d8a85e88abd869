// SPDX-License-Identifier: MIT
#include "app/commands/words_anywhere.h"

#include <algorithm>

#include "app/commands/option_values.h"

namespace shadowlab::commands {

TakenWords takeWordsOf(const std::string& option, const std::string& example, const std::vector<std::string>& argv) {
    TakenWords taken;
    const auto take = [&](const std::string& value) {
        if (value.empty()) refuseUsage(option + ": its value is missing; write " + option + " " + example);
        if (std::ranges::find(taken.values, value) != taken.values.end())
            refuseUsage(option + " " + value + " is given twice; give it once");
        taken.values.push_back(value);
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
