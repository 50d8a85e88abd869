// SPDX-License-Identifier: MIT
#include "app/cli/global_options.h"

#include <algorithm>

#include "app/cli/option_values.h"

namespace shadowlab::cli {

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

bool takeFlag(const std::string& option, std::vector<std::string>& argv) {
    const auto end = std::ranges::find(argv, "--"); // what is behind it is left as it is
    for (auto word = argv.begin(); word != end; ++word)
        if (word->starts_with(option + "=")) refuseUsage(option + " takes no value; leave out what is behind it");
    const auto kept = std::remove(argv.begin(), end, option);
    const bool isThere = kept != end;
    argv.erase(kept, end);
    return isThere;
}

} // namespace shadowlab::cli
