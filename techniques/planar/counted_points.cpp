// Soft shadows: the shadows of many points of an area light are counted in each pixel. The share of points in shadow is the
// share of the light that the pixel does not see.
//
// Heckbert and Herf average shaded pictures. Here only the shadows are added, one for each point that a pixel does not see,
// in floats, which count to 16 million without rounding. So every pixel is shaded only once.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <numeric>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/planar/technique.h"

namespace shadowlab::planar {

namespace {

/// The points in an order in which any first few are spread over the whole light, by multiples of the golden section (Weyl
/// 1916). So a picture drawn from the first few is already a fair approximation.
std::vector<dvec3> scattered(const std::vector<dvec3>& points) {
    constexpr double kGolden = 0.6180339887498949;
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [](std::size_t i) { return glm::fract(static_cast<double>(i) * kGolden); });
    std::vector<dvec3> result(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        result[i] = points[order[i]];
    return result;
}

} // namespace

bool Planar::isSampled(const scene::Light& light) const {
    return params_.lightPoints.count > 1 && scene::hasArea(light) && params_.once;
}

/// True when all points have been drawn.
bool Planar::countPoints(const Frame& frame, int light) {
    CountedPoints& counted = counted_[light];
    if (counted.key != key_) {
        const scene::Light& source = frame.scene().light(light);
        counted.key = key_;
        counted.pointsWorld = scattered(scene::pointsOfLight(source, light, params_.lightPoints));
        counted.drawn = 0;
        counted.counts = gl::Texture2D(GL_R32F, frame.target().size(), "shadows of points of the light");
    }
    const gl::Framebuffer counting(&counted.counts, &frame.target().depthStencil, "shadows of points of the light");
    counting.bind();
    if (counted.drawn == 0) {
        glDisable(GL_SCISSOR_TEST);
        glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    // With a deadline the points are drawn a few at a time, and the clock is read after glFinish: GL commands return before
    // they are executed.
    constexpr std::size_t kAtATime = 4;
    while (counted.drawn < counted.pointsWorld.size()) {
        countOnePoint(frame, light, counted.pointsWorld[counted.drawn++], counting);
        if (frame.deadline() == Deadline::max() || counted.drawn % kAtATime != 0) continue;
        glFinish();
        if (std::chrono::steady_clock::now() >= frame.deadline()) break;
    }
    return counted.drawn == counted.pointsWorld.size();
}

void Planar::countOnePoint(const Frame& frame, int light, const dvec3& pointWorld,
                           const gl::Framebuffer& counting) const {
    const std::vector<LitPlane> planes = litPlanes(frame.scene(), chosen_, casters_, frame.eye(),
                                                   dvec4(pointWorld, 1.0), frame.scene().light(light), params_, true);
    if (planes.empty()) return;
    gl::setBaselineState();
    counting.bind();
    frame.scissorTo(std::nullopt);
    markShadows(frame, planes);

    // Adds one in each marked pixel, and clears the marks.
    scene::PicturePart part = planes.front().part;
    for (const LitPlane& plane : planes)
        part = around(part, plane.part);
    gl::setBaselineState();
    frame.scissorTo(part);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    // [anchor: count-marks]
    glStencilMask(kMarkBit);
    glStencilFunc(GL_EQUAL, static_cast<GLint>(kMarkBit), kMarkBit);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    addPoint_.use();
    addPoint_.set("color", vec4(1, 0, 0, 0));
    gl::drawFullscreenTriangle();
}

} // namespace shadowlab::planar
