// The share of light that a technique finds at every pixel, in floats: soft shadows are judged by more than black and white.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <string_view>

#include "app/lab/settings.h"
#include "app/picture/picture.h"
#include "techniques/foundation/gl/read_back.h"

namespace shadowlab::testing {

using LightShares = judge::Grid<float>;

/// No surface there.
inline constexpr float kNoShare = -1;

/// What is no number is as wrong as can be; in comparisons it would pass for right.
inline double asNumber(float share) { return std::isfinite(share) ? share : -1; }

/// One technique that is kept from picture to picture, and with it its programs. What the settings of a picture do not name is
/// at its default.
class TechniqueSlot {
public:
    TechniqueSlot(std::string technique, scene::Snapshot snapshot)
        : technique_(std::move(technique)), session_(std::move(snapshot)) {
        slots_.push_back(picture::Session::makeSlot(technique_));
    }
    void setScene(scene::Snapshot snapshot) { session_.setScene(std::move(snapshot)); }

    /// As the shader computed them: not yet rounded to bytes, and not brought into 0..1 by that.
    LightShares shares(const std::vector<std::string>& settings, ivec2 size, int light = 0) {
        FrameRequest request;
        request.stages = {{"visibility", light}};
        const picture::RenderedFrame frame = render(settings, size, request);
        const std::vector<vec4> texels = gl::readTexels(picture::findStage(frame, {"visibility", light}).texture);
        LightShares shares(size.x, size.y);
        for (std::size_t i = 0; i < texels.size(); ++i) // green: whether there is a surface
            shares.values[i] = texels[i].g > 0.5f ? texels[i].r : kNoShare;
        return shares;
    }
    /// The picture itself, as it is before exposure.
    std::vector<vec4> radiance(const std::vector<std::string>& settings, ivec2 size) {
        render(settings, size, {});
        return gl::readTexels(slots_[0].target.color);
    }
    /// What the technique's counter of that name says (Frame::count); -1: there is none.
    double counted(const std::vector<std::string>& settings, ivec2 size, std::string_view counter) {
        const picture::RenderedFrame frame = render(settings, size, {});
        const auto found = std::ranges::find(frame.result.counters, counter, &Counter::id);
        return found == frame.result.counters.end() ? -1 : found->built;
    }

private:
    picture::RenderedFrame render(const std::vector<std::string>& settings, ivec2 size, const FrameRequest& request) {
        for (const params::Param& param : slots_[0].params)
            param.set(param.initial);
        std::vector<std::string> full;
        for (const std::string& setting : settings)
            full.push_back(technique_ + "." + setting);
        lab::applySettings(slots_, full);
        View view;
        view.camera = session_.snapshot()->camera;
        view.size = size;
        return session_.render(slots_[0], view, request);
    }

    std::string technique_;
    picture::Session session_;
    std::vector<picture::Slot> slots_;
};

/// The shadow map's.
struct ShadowMapSlot : TechniqueSlot {
    explicit ShadowMapSlot(scene::Snapshot snapshot) : TechniqueSlot("shadow-map", std::move(snapshot)) {}
};

} // namespace shadowlab::testing
