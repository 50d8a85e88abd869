// SPDX-License-Identifier: MIT
#include "app/cli/options.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/cli/option_values.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::cli {

void DescribedOptions::option(const std::string& names, const std::string& value, const std::string& help) {
    CLI::Option* option = command_.add_option(names, help);
    option->expected(1)->take_all()->allow_extra_args(false); // GivenOptions::text refuses what is written twice
    option->type_name(value);
}

void DescribedOptions::flag(const std::string& name, const std::string& help) {
    command_.add_flag(name)->description(help);
}

void DescribedOptions::arguments(const std::string& name, const std::string& help) {
    constexpr int kAnyNumber = CLI::detail::expected_max_vector_size;
    command_.add_option(name, help)->expected(1, kAnyNumber)->take_all()->allow_extra_args(true)->type_name("");
}

void DescribedOptions::footer(const std::string& text) { command_.footer(text); }

std::vector<std::string> GivenOptions::texts(const std::string& option) const {
    const CLI::Option* found = command_.get_option(option);
    std::vector<std::string> texts = found->count() > 0 ? found->results() : std::vector<std::string>{};
    if (std::ranges::find(texts, "") != texts.end())
        refuseUsage(option + ": an empty text is given; write a value after it, or leave " + option + " out");
    return texts;
}

std::vector<std::filesystem::path> GivenOptions::allowedFolders() const {
    std::vector<std::filesystem::path> folders;
    for (const std::string& folder : texts("--allow")) {
        std::error_code ignored;
        if (!std::filesystem::is_directory(folder, ignored))
            refuseUsage("--allow: '" + scene::shown(folder) +
                        "' is no folder; write one that is there, or leave it out");
        folders.emplace_back(folder);
    }
    return folders;
}

std::string GivenOptions::text(const std::string& option, const std::string& fallback) const {
    const std::vector<std::string> given = texts(option);
    if (given.size() > 1) refuseUsage(option + " is given " + std::to_string(given.size()) + " times; give it once");
    return given.empty() ? fallback : given.front();
}

std::string GivenOptions::required(const std::string& option, const std::string& example) const {
    if (!has(option)) refuseUsage(command_.get_name() + ": " + option + " is missing; write " + example);
    return text(option);
}

bool GivenOptions::has(const std::string& option) const { return command_.get_option(option)->count() > 0; }

} // namespace shadowlab::cli
