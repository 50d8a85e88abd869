// SPDX-License-Identifier: MIT
#include "app/cli/capture/capture_stats.h"

#include <algorithm>

#include "techniques/foundation/params/param_json.h"

namespace shadowlab::cli {

CaptureStats::CaptureStats(const scene::Scene& scene, const CaptureOptions& options, const context::Context& context,
                           const std::vector<picture::Slot>& slots)
    : scene_(scene.name), renderer_(context::glRenderer()), version_(context::glVersion()), backend_(context.backend()),
      size_(options.size) {
    std::string techniques, settings;
    for (const picture::Slot& slot : slots) {
        SlotStats stats{std::string(slot.info->id), params::toJson(slot.params), {}, {}, {}};
        // As --set takes them: of several slots, each with its number.
        const std::string prefix = slots.size() > 1 ? std::to_string(slots_.size() + 1) + ":" : "";
        for (const params::Param& param : slot.params)
            settings += prefix + stats.technique + "." + param.id + "=" + params::valueText(param) + "\n";
        techniques += (techniques.empty() ? "" : ",") + stats.technique;
        slots_.push_back(std::move(stats));
    }
    pngText_ = {{"Software", "shadowlab " SHADOWLAB_VERSION}, {"Scene", scene_}, {"Techniques", techniques}};
    // As --stage takes it: one for all, or each with its number.
    std::string stages;
    const bool sameForAll =
        std::ranges::adjacent_find(options.stages, std::ranges::not_equal_to()) == options.stages.end();
    for (std::size_t i = 0; i < (sameForAll ? std::min<std::size_t>(1, options.stages.size()) : options.stages.size());
         ++i)
        if (!options.stages[i].isPicture())
            stages += (stages.empty() ? "" : "\n") + (sameForAll ? "" : std::to_string(i + 1) + ":") +
                      options.stages[i].text();
    if (!stages.empty()) pngText_.push_back({"Stage", stages});
    if (!options.light.empty()) pngText_.push_back({"Light", options.light});
    if (!settings.empty()) pngText_.push_back({"Settings", settings});
}

void CaptureStats::add(std::size_t slot, const picture::RenderedFrame& rendered) {
    SlotStats& stats = slots_[slot];
    stats.times.addFrame(rendered.frameMs, rendered.prepareMs);
    stats.times.addPasses(rendered.result.passMs);
    stats.counters = rendered.result.counters;
    stats.notes = rendered.result.notes;
}

std::string CaptureStats::json() const {
    Json root;
    root["scene"] = scene_;
    root["size"] = {size_.x, size_.y};
    root["backend"] = backend_;
    root["renderer"] = renderer_;
    root["version"] = version_;
    root["results"] = Json::array();
    for (const SlotStats& slot : slots_) {
        Json entry;
        entry["technique"] = slot.technique;
        entry["parameters"] = slot.parameters;
        entry["frames"] = slot.times.frames();
        entry["ms"] = timesJson(slot.times);
        entry["counters"] = countersJson(slot.counters);
        entry["found"] = Json::array();
        for (const Note& note : slot.notes)
            entry["found"].push_back({{"what", note.label}, {"is", note.text}});
        root["results"].push_back(std::move(entry));
    }
    // A file's name may hold bytes that are no UTF-8; JSON may not.
    return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace shadowlab::cli
