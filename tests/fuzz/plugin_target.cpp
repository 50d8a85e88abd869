// Plug-ins, as far as nothing of them runs: the file is looked through, and so is what one says of itself. The bytes are the
// file; the words between their line feeds are also taken for a folder, an id, a title, ids of passes and of stages.
// `HERE-THE-CONTRACT` in them becomes that of this program, which is another whenever a header changes.
// SPDX-License-Identifier: MIT
#include <sstream>
#include <vector>

#include "app/student/plugin_file.h"
#include "app/student/plugins.h"
#include "tests/fuzz/target.h"

namespace shadowlab::fuzz {

namespace {

struct Nothing final : Technique {
    Progress render(Frame&) override { return {}; }
};

std::vector<TechniqueInfo> described;

/// What a plug-in of these words would say.
Plugin pluginOf(const std::vector<std::string>& words) {
    const auto word = [&](std::size_t i) { return i < words.size() ? std::string_view(words[i]) : std::string_view(); };
    TechniqueInfo info;
    info.id = word(1);
    info.title = word(2);
    info.make = [] { return std::unique_ptr<Technique>(std::make_unique<Nothing>()); };
    for (std::size_t i = 3; i < words.size(); ++i)
        if (i % 2)
            info.passes.push_back({.id = word(i), .title = word(2), .why = {}, .glState = {}});
        else
            info.stages.push_back({.id = word(i), .caption = word(2)});
    described.assign(words.size() > 8 ? 2 : 1, info);
    Plugin plugin;
    plugin.folder = word(0);
    plugin.techniques = [] { return std::span<const TechniqueInfo>(described); };
    return plugin;
}

} // namespace

Outcome feed(std::string_view bytes) {
    std::string text(bytes);
    constexpr std::string_view kHere = "HERE-THE-CONTRACT";
    if (const std::size_t at = text.find(kHere); at != std::string::npos)
        text.replace(at, kHere.size(), contractOfProgram());
    std::vector<std::string> words;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        words.push_back(line);
    try {
        const Plugin plugin = pluginOf(words);
        for (const TechniqueInfo& info : student::checkedTechniques(plugin)) {
            require(student::isKebabCase(info.id), "an id that was taken is one");
            for (const StageInfo& stage : info.stages)
                require(student::isKebabCase(stage.id), "a stage's id that was taken is one");
        }
    } catch (const student::PluginFault& fault) {
        require(std::string_view(fault.what()).find("; ") != std::string_view::npos, "a message without a remedy");
    }
    const std::filesystem::path file = written("made-up.so", text);
    return outcomeOf([&] { student::requirePluginFile(file); });
}

} // namespace shadowlab::fuzz
