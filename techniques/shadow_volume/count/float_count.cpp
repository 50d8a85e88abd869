// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/count/float_count.h"

#include "techniques/foundation/gl/debug.h"

namespace shadowlab::shadow_volume {

void FloatCount::clear(const Frame& frame, int start) {
    const gl::Target& target = frame.target();
    if (!counts_ || counts_.size() != target.size()) counts_ = gl::Texture2D(GL_R32F, target.size(), "counts");
    // Made again each time, because the target's depth may by now be another texture with the same GL name.
    framebuffer_ = gl::Framebuffer(&counts_, &target.depthStencil, "counts");
    framebuffer_.bind();
    const float value[4] = {static_cast<float>(start), 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, value);
}

void FloatCount::count(const Frame& frame, const FaceCounter& counter, int light,
                       std::span<const CountedVolume> volumes, const CountRules& rules, bool allAdd) const {
    framebuffer_.bind();
    counter.countIntoColor(frame, light, volumes, rules, allAdd);
}

void FloatCount::writeStencil(const Frame& frame) const {
    frame.target().withoutColor.bind();
    frame.scissorTo(std::nullopt);
    glDisable(GL_CULL_FACE);
    glEnable(GL_STENCIL_TEST);
    glStencilMask(0xff);
    glClearStencil(0);
    glClear(GL_STENCIL_BUFFER_BIT);
    glDepthFunc(GL_ALWAYS);
    glStencilFunc(GL_ALWAYS, 1, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    notZero_.use();
    notZero_.set("counts", 0);
    counts_.bind(0);
    gl::drawFullscreenTriangle();
}

std::vector<float> FloatCount::read() const {
    std::vector<float> counts(static_cast<std::size_t>(counts_.size().x) * static_cast<std::size_t>(counts_.size().y));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    glReadPixels(0, 0, counts_.size().x, counts_.size().y, GL_RED, GL_FLOAT, counts.data());
    gl::check("reading the counts");
    return counts;
}

} // namespace shadowlab::shadow_volume
