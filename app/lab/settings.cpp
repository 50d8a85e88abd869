// SPDX-License-Identifier: MIT
#include "app/lab/settings.h"

#include <algorithm>
#include <charconv>

#include "techniques/foundation/base/error.h"

namespace shadowlab::lab {

Setting parseSetting(const std::string& text) {
    const auto refuse = [&](const std::string& why) {
        throw Error(ExitStatus::usage,
                    "--set: '" + text + "' " + why + "; write [SLOT:]ID.PARAM=VALUE, as shadow-map.resolution=1024");
    };
    const std::size_t equals = text.find('=');
    const std::size_t dot = text.find('.');
    if (equals == std::string::npos || dot == std::string::npos || dot > equals) refuse("is not a setting");
    Setting setting{0, text.substr(0, dot), text.substr(dot + 1, equals - dot - 1), text.substr(equals + 1)};
    if (const std::size_t colon = setting.id.find(':'); colon != std::string::npos) {
        const char *begin = setting.id.data(), *end = begin + colon;
        const auto [last, error] = std::from_chars(begin, end, setting.slot);
        if (error != std::errc{} || last != end || setting.slot < 1) refuse("has no slot number before the colon");
        setting.id.erase(0, colon + 1);
    }
    return setting;
}

void applySettings(std::vector<picture::Slot>& slots, const std::vector<std::string>& settings) {
    for (const std::string& text : settings) {
        const Setting setting = parseSetting(text);
        findTechnique(setting.id); // names the nearest ids when there is none
        if (setting.slot > static_cast<int>(slots.size()))
            throw Error(ExitStatus::usage, "--set: '" + text + "': the slots are numbered from 1 to " +
                                               std::to_string(slots.size()) + "; use one of these numbers");
        bool applied = false;
        for (std::size_t i = 0; i < slots.size(); ++i) {
            const bool meant = setting.slot == 0 || setting.slot == static_cast<int>(i) + 1;
            if (!meant || slots[i].info->id != setting.id) continue;
            params::setFromText(params::find(slots[i].params, setting.param, setting.id), setting.value, setting.id);
            applied = true;
        }
        if (!applied)
            throw Error(ExitStatus::usage, "--set: '" + text + "': no slot" +
                                               (setting.slot ? " " + std::to_string(setting.slot) : "") + " shows " +
                                               setting.id + "; choose it with -t");
    }
}

std::vector<std::string> settingsWithoutEffect(const std::vector<picture::Slot>& slots) {
    std::vector<std::string> sentences;
    for (const picture::Slot& slot : slots)
        for (const params::Param& param : slot.params)
            if (!params::hasEffect(param) && params::valueText(param) != params::initialText(param)) {
                const std::string text = std::string(slot.info->id) + "." + param.id + "=" + params::valueText(param);
                const std::string sentence = "'" + text + "' has no effect with the other settings as they are";
                if (std::ranges::find(sentences, sentence) == sentences.end()) sentences.push_back(sentence);
            }
    return sentences;
}

} // namespace shadowlab::lab
