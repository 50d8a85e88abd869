// SPDX-License-Identifier: MIT
#include "techniques/frame.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/debug.h"
#include "techniques/foundation/scene/query/view/depth_fit.h"

namespace shadowlab {

Frame::Frame(const scene::Snapshot& snapshot, const View& view, const gl::SceneBuffers& buffers,
             const gl::Target& target, FrameRequest request)
    : snapshot_(snapshot), view_(view), camera_(scene::withTightNear(view.camera, *snapshot, buffers.bounds(),
                                                                     static_cast<double>(view.size.x) / view.size.y)),
      eye_(gl::eyeMatrices(camera_, view.size)), buffers_(buffers), target_(target), request_(std::move(request)) {
    eye_.part = scene::picturePart(view.region.corner, view.region.size, view.size);
}

bool Frame::drawFinished(FinishedScenes able) {
    // Stages and steps are made of radiance; a hole is cut where depth is written, which the shader of finished pixels does not do.
    const std::size_t lights = scene().lights.size();
    const std::size_t most = able == FinishedScenes::withOneLight ? 1 : gl::kMostLightsAtOnce;
    const bool isAble = able == FinishedScenes::any || (lights >= 1 && lights <= most && !buffers_.anyHoles());
    if (!request_.finished || !request_.stages.empty() || request_.stopAfter || !isAble) return false;
    makeFinished(request_.finished->color);
    finished_ = gl::Framebuffer(&request_.finished->color, &target_.depthStencil, "finished picture");
    return result_.isFinished = true;
}

void Frame::bindInShadowToo() {
    makeFinished(request_.finished->inShadow);
    finishedAndInShadow_ = gl::Framebuffer(request_.finished->color, request_.finished->inShadow, target_.depthStencil,
                                           "finished picture, and in shadow");
    finishedAndInShadow_.bind();
}

void Frame::bindHiddenLights() {
    if (!hiddenLights_) { // once in a frame, which binds it for each light
        makeFinished(request_.finished->inShadow);
        hiddenLights_ = gl::Framebuffer(&request_.finished->inShadow, &target_.depthStencil, "hidden lights");
    }
    hiddenLights_.bind();
}

/// Keeps the texture of the last frame where it has the size.
void Frame::makeFinished(gl::Texture2D& picture) const {
    if (!picture || picture.size() != target_.size())
        picture = gl::Texture2D(GL_RGBA8, target_.size(), "finished picture");
}

void Frame::useNearPlaneOfView() {
    camera_ = view_.camera;
    eye_.clipFromView = gl::eyeMatrices(camera_, view_.size).clipFromView;
}

void Frame::useFarPlane() {
    const double far = scene::farDepth(buffers_.bounds(), eye_.viewFromWorld, camera_.near);
    eye_.clipFromView[2][2] = -(far + camera_.near) / (far - camera_.near);
    eye_.clipFromView[3][2] = -2.0 * far * camera_.near / (far - camera_.near);
}

void Frame::drawWhatIsOutOfView() { eye_.part.reset(); }

void Frame::pass(const PassInfo& info, const std::function<void()>& draw, int light) {
    if (stopped_) return;
    const StageKey key{std::string(info.id), light};
    result_.passes.push_back(key);
    {
        const gl::DebugGroup group(info.title);
        gl::setBaselineState();
        (drawsFinished() ? finished_ : target_.framebuffer).bind();
        scissorTo(std::nullopt);
        if (request_.timePasses)
            timer_.time(key.id, draw);
        else
            draw();
    }
    gl::check(info.id);
    stopped_ = request_.stopAfter == key;
}

Region Frame::pixelsOf(const std::optional<scene::PicturePart>& part) const {
    const auto [corner, size] = drawnRegion(view_);
    if (!part) return {corner, size};
    // In pixels from the upper left. The rasteriser rounds: one pixel more on each side.
    const auto pixels = [&](const dvec2& ndc) {
        return (0.5 + dvec2(0.5, -0.5) * glm::clamp(ndc, -1.0, 1.0)) * dvec2(view_.size);
    };
    const dvec2 upperLeft = pixels({part->lower.x, part->upper.y}), lowerRight = pixels({part->upper.x, part->lower.y});
    const ivec2 first = glm::max(corner, ivec2(glm::floor(upperLeft)) - 1);
    const ivec2 last = glm::min(corner + size, ivec2(glm::ceil(lowerRight)) + 1);
    return {first, glm::max(last - first, ivec2(0))};
}

void Frame::scissorTo(const std::optional<scene::PicturePart>& part) const {
    if (!part && drawnRegion(view_).size == view_.size) {
        glDisable(GL_SCISSOR_TEST);
        return;
    }
    const auto [corner, size] = pixelsOf(part);
    glEnable(GL_SCISSOR_TEST);
    glScissor(corner.x, view_.size.y - corner.y - size.y, size.x, size.y); // GL counts rows from below
}

bool Frame::wants(std::string_view stage, int light) const {
    if (stopped_) return false;
    return std::ranges::any_of(request_.stages,
                               [&](const StageKey& key) { return key.id == stage && key.light == light; });
}

void Frame::publish(std::string_view stage, int light, gl::Texture2D texture, Display display) {
    gl::check(stage);
    result_.stages.push_back({{std::string(stage), light}, std::move(texture), std::move(display)});
}

void Frame::publishTarget(std::string_view stage, int light) { publish(stage, light, copyOfTarget(stage)); }

void Frame::drawStage(std::string_view stage, int light, GLenum format, const std::function<void()>& draw,
                      Display display) {
    gl::Texture2D texture(format, target_.size(), stage);
    drawInto(texture, target_.depthStencil, stage, true, draw);
    publish(stage, light, std::move(texture), std::move(display));
}

void Frame::drawStageOnCopy(std::string_view stage, int light, GLenum format, const std::function<void()>& draw) {
    const ivec2 size = target_.size();
    const gl::Texture2D depthStencil(target_.depthStencil.internalFormat(), size, stage);
    const gl::Framebuffer copy(nullptr, &depthStencil, stage);
    gl::setBaselineState(); // a scissor would cut the copy
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target_.withoutColor.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, copy.id());
    glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST);
    gl::Texture2D texture(format, size, stage);
    drawInto(texture, depthStencil, stage, true, draw);
    publish(stage, light, std::move(texture));
}

void Frame::drawOverTarget(std::string_view stage, int light, bool greyed, const std::function<void()>& draw,
                           Display display) {
    gl::Texture2D texture = greyed ? greyedTarget(stage) : copyOfTarget(stage);
    drawInto(texture, target_.depthStencil, stage, false, draw);
    publish(stage, light, std::move(texture), std::move(display));
}

gl::Texture2D Frame::copyOfTarget(std::string_view name) const {
    gl::Texture2D copy(target_.color.internalFormat(), target_.size(), name);
    const gl::Framebuffer destination(&copy, nullptr, name);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target_.framebuffer.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, destination.id());
    const ivec2 size = target_.size();
    glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return copy;
}

gl::Texture2D Frame::greyedTarget(std::string_view name) const {
    gl::Texture2D grey(target_.color.internalFormat(), target_.size(), name);
    const gl::Framebuffer destination(&grey, nullptr, name);
    const gl::Program& program = buffers_.greyed();
    gl::setBaselineState();
    glDisable(GL_DEPTH_TEST);
    destination.bind();
    program.use();
    program.set("source", 0);
    target_.color.bind(0);
    gl::drawFullscreenTriangle();
    return grey;
}

void Frame::drawInto(gl::Texture2D& texture, const gl::Texture2D& depthStencil, std::string_view stage, bool clear,
                     const std::function<void()>& draw) const {
    const gl::Framebuffer framebuffer(&texture, &depthStencil, stage);
    const gl::DebugGroup group(stage);
    gl::setBaselineState();
    framebuffer.bind();
    if (clear) glClear(GL_COLOR_BUFFER_BIT);
    scissorTo(std::nullopt);
    draw();
}

void Frame::count(std::string_view id, double built, double of, std::string_view unit) {
    const auto known = std::ranges::find(result_.counters, id, &Counter::id);
    if (known == result_.counters.end()) {
        result_.counters.push_back({std::string(id), built, of, std::string(unit)});
        return;
    }
    known->built += built;
    known->of += of;
}

void Frame::note(std::string label, std::string text, const vec3& colorLinear) {
    result_.notes.push_back({std::move(label), std::move(text), colorLinear});
}

Frame::Result Frame::takeResult() {
    result_.passMs = timer_.take();
    return std::move(result_);
}

bool publishes(const TechniqueInfo& info, std::string_view stage) {
    return std::ranges::find(info.stages, stage, &StageInfo::id) != info.stages.end();
}

std::string pseudocodeOf(const TechniqueInfo& info, const PassInfo& pass) {
    std::string lines;
    std::istringstream stream{std::string(info.pseudocode)};
    int number = 0;
    for (std::string line; std::getline(stream, line);)
        if (++number >= pass.pseudocodeLines.first && number <= pass.pseudocodeLines.last)
            lines += (lines.empty() ? "" : "\n") + line;
    return lines;
}

const PassInfo& passInfo(std::span<const PassInfo> passes, std::string_view id) {
    const auto found = std::ranges::find(passes, id, &PassInfo::id);
    if (found == passes.end()) throw std::logic_error("no pass is described under the id " + std::string(id));
    return *found;
}

} // namespace shadowlab
