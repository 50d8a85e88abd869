// Many pictures of one scene by one slot that is set anew for each: programs that were put together once stay.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/measure/grid.h"
#include "app/session/session.h"
#include "app/session/settings.h"
#include "techniques/foundation/gl/read_back.h"

namespace shadowlab::testing {

class KeptSlot {
public:
    explicit KeptSlot(scene::Snapshot snapshot) : session_(std::move(snapshot)) {
        slots_.push_back(session::Session::makeSlot("shadow-map"));
    }
    void setScene(scene::Snapshot snapshot) { session_.setScene(std::move(snapshot)); }

    /// The light's visibility as the shader computed it: not yet rounded to bytes, and not brought into 0..1 by that. What
    /// is not among the settings ("param=value") is as it was at first. -1 where there is no surface.
    measure::Grid<float> visibility(const std::vector<std::string>& settings, ivec2 size, int light) {
        for (params::Param& param : slots_[0].params)
            param.set(param.initial);
        std::vector<std::string> full;
        for (const std::string& setting : settings)
            full.push_back("shadow-map." + setting);
        session::applySettings(slots_, full);
        View view;
        view.camera = session_.snapshot()->camera;
        view.size = size;
        FrameRequest request;
        request.stages = {{"visibility", light}};
        const session::RenderedFrame frame = session_.render(slots_[0], view, request);
        const std::vector<vec4> texels = gl::readTexels(session::findStage(frame, {"visibility", light}).texture);
        measure::Grid<float> visibility(size.x, size.y);
        for (std::size_t i = 0; i < texels.size(); ++i)
            visibility.values[i] = texels[i].g > 0.5f ? texels[i].r : -1;
        return visibility;
    }

private:
    session::Session session_;
    std::vector<session::Slot> slots_;
};

} // namespace shadowlab::testing
