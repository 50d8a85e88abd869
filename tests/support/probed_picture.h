// A picture and what the technique says about its pixels, from one slot with one set of parameters.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/lab/settings.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "techniques/foundation/gl/read_back.h"

namespace shadowlab::testing {

class ProbedPicture {
public:
    /// Draws the visibility stage of the first light, and one more if it is named.
    ProbedPicture(const scene::Snapshot& snapshot, const std::string& technique,
                  const std::vector<std::string>& settings, ivec2 size, std::string_view stage = {})
        : snapshot_(snapshot), session_(snapshot) {
        slots_.push_back(picture::Session::makeSlot(technique));
        std::vector<std::string> full;
        for (const std::string& setting : settings)
            full.push_back(technique + "." + setting);
        lab::applySettings(slots_, full);
        view_.camera = snapshot->camera;
        view_.size = size;
        FrameRequest request;
        request.stages = {{"visibility", 0}};
        if (!stage.empty()) request.stages.push_back({std::string(stage), 0});
        const picture::RenderedFrame frame = session_.render(slots_[0], view_, request);
        visibility_ = picture::readVisibility(picture::findStage(frame, {"visibility", 0}));
        if (!stage.empty()) texels_ = gl::readTexels(picture::findStage(frame, {std::string(stage), 0}).texture);
    }

    [[nodiscard]] const picture::VisibilityImage& visibility() const { return visibility_; }
    /// Of the other stage, row 0 on top.
    [[nodiscard]] vec4 texel(int x, int y) const {
        return texels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.size.x) +
                       static_cast<std::size_t>(x)];
    }
    [[nodiscard]] Probe probe(int x, int y) { return slots_[0].technique->probe(snapshot_, view_, {x, y}, 0); }
    [[nodiscard]] ivec2 size() const { return view_.size; }

private:
    scene::Snapshot snapshot_;
    picture::Session session_;
    std::vector<picture::Slot> slots_;
    View view_;
    picture::VisibilityImage visibility_;
    std::vector<vec4> texels_;
};

} // namespace shadowlab::testing
