// SPDX-License-Identifier: MIT
#include "app/picture/steps/step_lift.h"

#include <algorithm>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/framebuffer.h"
#include "techniques/foundation/gl/read_back.h"

namespace shadowlab::picture {

namespace {

constexpr float kLiftedWhite = 1; ///< linear: a white surface is at most as bright as the picture can be
constexpr int kMostLift = 64;        ///< beyond it an ambient light is none
// A few samples tell whether a light is on. Some of them may be brighter than the ambient light: surfaces that glow, as lamps do.
constexpr ivec2 kSamples{64, 36};
constexpr double kMostGlowing = 0.05;

float brightest(const vec3& color) { return std::max({color.r, color.g, color.b}); }

/// The part of the picture that is drawn, in a few of its texels.
std::vector<vec4> samplesOf(const gl::Texture2D& radiance, const Region& region) {
    const ivec2 size = radiance.size();
    const bool all = region.size.x <= 0 || region.size.y <= 0;
    const ivec2 corner = all ? ivec2(0) : region.corner, extent = all ? size : region.size;
    const gl::Texture2D small(radiance.internalFormat(), kSamples, "samples of a step");
    const gl::Framebuffer source(&radiance, nullptr, "step"), destination(&small, nullptr, "samples of a step");
    gl::setBaselineState();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, destination.id());
    const int low = size.y - corner.y - extent.y; // GL counts rows from below
    glBlitFramebuffer(corner.x, low, corner.x + extent.x, low + extent.y, 0, 0, kSamples.x, kSamples.y, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    return gl::readTexels(small);
}

} // namespace

int stepLift(const gl::Texture2D& radiance, const Region& region, const scene::Scene& scene) {
    const float ambientWhite = brightest(scene.ambient) * scene.exposure;
    if (ambientWhite <= 0) return 1;
    int lift = 1;
    while (lift < kMostLift && 2.0f * static_cast<float>(lift) * ambientWhite <= kLiftedWhite)
        lift *= 2;
    if (lift == 1) return 1;
    const std::vector<vec4> samples = samplesOf(radiance, region);
    // Ambient light alone leaves nothing brighter than that. What would be is lit already.
    const auto lit = std::ranges::count_if(samples, [&](const vec4& texel) {
        return brightest(vec3(texel)) * scene.exposure * static_cast<float>(lift) > kLiftedWhite;
    });
    return static_cast<double>(lit) > kMostGlowing * static_cast<double>(samples.size()) ? 1 : lift;
}

std::string liftNote(int lift) { return lift == 1 ? "" : "shown " + std::to_string(lift) + " times brighter"; }

} // namespace shadowlab::picture
