// SPDX-License-Identifier: MIT
#include "app/lab/old_spelling.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <set>

#include "app/lab/settings.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::lab {

namespace {

/// A switch of one technique that became a technique, and the stage that went with it.
struct OldSwitch {
    std::string_view technique, param, stage, now;
};

/// Where several are on, the first counts, as it did when they were switches.
constexpr OldSwitch kOldSwitches[] = {{"shadow-map", "alias-free", "eye-samples", "shadow-map-alias-free"},
                                      {"shadow-map", "exact", "traced", "shadow-map-exact"}};

/// The notes that were made, so that each is made once.
struct Notes {
    std::mutex mutex;
    void (*note)(std::string_view) = nullptr;
    std::set<std::string> made;
};

Notes& notes() {
    static Notes all;
    return all;
}

void noteOnce(const std::string& sentence) {
    const std::lock_guard lock(notes().mutex);
    if (notes().note && notes().made.insert(sentence).second) notes().note(sentence);
}

/// None: it is no setting, which applySettings() says with its reason.
std::optional<Setting> settingOf(const std::string& text) {
    try {
        return parseSetting(text);
    } catch (const Error&) {
        return std::nullopt;
    }
}

bool isMeant(const Setting& setting, std::size_t slot) {
    return setting.slot == 0 || setting.slot == static_cast<int>(slot) + 1;
}

bool hasParam(const std::string& technique, const std::string& param) {
    const picture::Slot slot = picture::Session::makeSlot(technique);
    return std::ranges::find(slot.params, param, &params::Param::id) != slot.params.end();
}

} // namespace

void tellOldSpelling(void (*note)(std::string_view)) {
    const std::lock_guard lock(notes().mutex);
    notes().note = note;
    notes().made.clear();
}

OldSpelling::OldSpelling(std::vector<std::string> techniques, const std::vector<std::string>& stages,
                         const std::vector<std::string>& settings)
    : written_(std::move(techniques)), now_(written_) {
    const auto isOn = [&](const OldSwitch& old, std::size_t slot) {
        std::string value;
        for (const std::string& text : settings)
            if (const auto setting = settingOf(text);
                setting && setting->id == old.technique && setting->param == old.param && isMeant(*setting, slot))
                value = setting->value;
        return value == "true";
    };
    for (std::size_t slot = 0; slot < written_.size(); ++slot) {
        const OldSwitch* byStage = nullptr; // which counts more: no other technique has that stage
        const OldSwitch* bySwitch = nullptr;
        for (const OldSwitch& old : kOldSwitches) {
            if (written_[slot] != old.technique) continue;
            if (slot < stages.size() && stages[slot] == old.stage) byStage = &old;
            if (!bySwitch && isOn(old, slot)) bySwitch = &old;
        }
        const OldSwitch* const found = byStage ? byStage : bySwitch;
        if (!found) continue;
        now_[slot] = found->now;
        noteOnce(std::string(found->technique) + "'s " +
                 (found == bySwitch ? std::string(found->param) + "=true is now the technique "
                                    : "stage " + std::string(found->stage) + " is now one of the technique ") +
                 now_[slot]);
    }
}

std::vector<std::string> OldSpelling::today(const std::string& text) const {
    const std::optional<Setting> setting = settingOf(text);
    if (!setting) return {text};
    const bool isSwitch = std::ranges::any_of(kOldSwitches, [&](const OldSwitch& old) {
        return old.technique == setting->id && old.param == setting->param;
    });
    std::vector<std::string> result;
    bool isAboutSome = false, isAboutChanged = false;
    for (std::size_t slot = 0; slot < written_.size(); ++slot) {
        if (written_[slot] != setting->id || !isMeant(*setting, slot)) continue;
        isAboutSome = true;
        const bool changed = now_[slot] != written_[slot];
        isAboutChanged = isAboutChanged || changed;
        if (changed && !hasParam(now_[slot], setting->param) && hasParam(written_[slot], setting->param)) continue;
        result.push_back(std::to_string(slot + 1) + ":" + now_[slot] + "." + setting->param + "=" + setting->value);
    }
    if (isSwitch && isAboutSome) {
        bool value = false;
        params::Param known = params::boolean(setting->param, value, "");
        params::setFromText(known, setting->value, setting->id);
        return {};
    }
    return isAboutChanged ? result : std::vector{text};
}

void respell(std::vector<std::string>& techniques, const std::vector<std::string>& stages,
             std::vector<std::string>& settings) {
    const OldSpelling spelling(techniques, stages, settings);
    std::vector<std::string> today;
    for (const std::string& setting : settings)
        std::ranges::move(spelling.today(setting), std::back_inserter(today));
    techniques = spelling.techniques();
    settings = std::move(today);
}

} // namespace shadowlab::lab
