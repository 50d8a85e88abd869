// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/probe/stage_pictures.h"

#include <algorithm>
#include <cstdlib>

#include "techniques/foundation/base/look.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::shadow_volume {

namespace {

/// A display colour as the radiance that exposure turns into it.
vec4 unexposed(const Frame& frame, const vec3& color, float alpha) { return {color / frame.scene().exposure, alpha}; }

/// How far a caster's volume reaches in a picture: a good half of the caster's own size, so that the bottom cap lies apart
/// from it and still in view. Metres.
double shownDistance(const CasterVolume& caster) {
    constexpr double kOfSize = 0.6;
    return kOfSize * glm::length(caster.bounds.upperWorld - caster.bounds.lowerWorld);
}

/// Names the kinds of edges that occur.
std::vector<KeyEntry> edgeKey(std::span<const CasterVolume* const> casters) {
    bool ordinary = false, boundary = false, multiple = false;
    for (const CasterVolume* caster : casters)
        for (const SilhouetteEdge& edge : caster->silhouette)
            (edge.triangles == 1 ? boundary : edge.triangles == 2 ? ordinary : multiple) = true;
    std::vector<KeyEntry> key;
    if (ordinary) key.push_back({look::kSilhouette, "silhouette edge"});
    if (boundary) key.push_back({look::kBoundaryEdge, "boundary of an open mesh"});
    if (multiple) key.push_back({look::kMultipleEdge, "edge of more than two faces"});
    return key;
}

/// Depth and stencil of each pixel, rows from below, as one word: 24 bits of depth, then the count.
std::vector<std::uint32_t> depthStencilWords(const Frame& frame) {
    const ivec2 size = frame.target().size();
    std::vector<std::uint32_t> words(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.target().framebuffer.id());
    glReadPixels(0, 0, size.x, size.y, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, words.data());
    return words;
}

} // namespace

void StagePictures::publishFacing(Frame& frame, int light) const {
    frame.drawStage(
        "facing", light, GL_RGBA16F,
        [&] {
            glDepthFunc(GL_EQUAL);
            gl::useForLight(facing_, frame.scene(), frame.buffers(), frame.eye(), light);
            facing_.set("towardColor", look::kTowardLight);
            facing_.set("awayColor", look::kAwayFromLight);
            gl::drawSurfaces(facing_, frame.scene(), frame.buffers(), frame.eye());
        },
        {.unit = "",
         .key = {{look::kTowardLight, "N·L > 0: faces the light"}, {look::kAwayFromLight, "N·L ≤ 0: faces away"}}});
}

void StagePictures::publishCountMethods(Frame& frame, int light, std::span<const CasterVolume* const> casters,
                                        const std::function<CountMethod(const CasterVolume&)>& countMethodOf) const {
    const auto colorOf = [&](const scene::Object& object) -> const vec3* {
        for (const CasterVolume* caster : casters)
            if (&frame.scene().objects[caster->object] == &object)
                return countMethodOf(*caster) == CountMethod::zPass ? &look::kDepthPass : &look::kDepthFail;
        return nullptr;
    };
    frame.drawOverTarget("ways", light, true,
                         [&] {
                             constexpr float kAlpha = 0.6f; // the caster's shading stays to be seen
                             glDepthFunc(GL_EQUAL);
                             glDepthMask(GL_FALSE);
                             glEnable(GL_BLEND);
                             glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
                             tint_.use();
                             gl::drawSurfaces(tint_, frame.scene(), frame.buffers(), frame.eye(),
                                              [&](const scene::Object& object) {
                                                  const vec3* color = colorOf(object);
                                                  if (color) tint_.set("color", unexposed(frame, *color, kAlpha));
                                                  return color != nullptr;
                                              });
                         },
                         {.unit = "",
                          .key = {{look::kDepthPass, "counted with depth pass: the eye is certainly not in its volume"},
                                  {look::kDepthFail, "counted with depth fail: it may be"}}});
}

void StagePictures::publishSilhouettes(Frame& frame, int light, std::span<const CasterVolume* const> casters) const {
    const ivec2 size = frame.target().size();
    // OpenGL core guarantees lines of one pixel only. A thick line is drawn as the same line at every offset within a disc.
    const int radius = look::lineRadius(size.y);
    const auto drawThick = [&](const vec3& color, const auto& drawLines) {
        edges_.set("color", unexposed(frame, color, 1));
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx) {
                if (dx * dx + dy * dy > radius * radius) continue;
                glViewport(dx, dy, size.x, size.y);
                drawLines();
            }
        glViewport(0, 0, size.x, size.y);
    };
    frame.drawOverTarget(
        "silhouettes", light, true,
        [&] {
            glDepthFunc(GL_LEQUAL);
            glDepthMask(GL_FALSE);
            edges_.use();
            edges_.set("pullClip", static_cast<float>(2.0 * frame.camera().near * 0.003)); // 0.3 % nearer
            for (const CasterVolume* caster : casters) {
                edges_.set("clipFromMesh", mat4(frame.eye().clipFromMesh(frame.scene().objects[caster->object])));
                drawThick(look::kSilhouette, [&] { caster->buffers->drawSilhouette(); });
                drawThick(look::kBoundaryEdge, [&] { caster->buffers->drawBoundary(); });
                drawThick(look::kMultipleEdge, [&] { caster->buffers->drawMultiple(); });
            }
        },
        {.unit = "", .key = edgeKey(casters)});
}

void StagePictures::publishFaces(Frame& frame, int light, std::span<const CasterVolume* const> casters, bool byPart,
                                 const ShownVolume& shown) const {
    // Coloured by sign, many faces overlap, so faces behind a surface are not drawn; coloured by part, they show through
    // it. Top caps lie on the surfaces of their casters, which should stay recognisable.
    const float sideAlpha = byPart ? 0.3f : 0.34f, capAlpha = byPart ? 0.2f : 0.0f, hiddenShare = byPart ? 0.4f : 0.0f;
    const vec3 plus = look::diverging()[6], minus = look::diverging()[2];
    const vec3 top = look::kTopCap, side = look::kVolumeSide, bottom = look::kBottomCap;
    const std::vector<KeyEntry> parts = {
        {top, "top cap"},
        {side, "side"},
        {bottom, shown.distance ? "bottom cap" : "bottom cap (drawn near; it is far away)"}};
    const std::vector<KeyEntry> signs = {{plus, "faces the viewer (front)"},
                                         {minus, "faces away from the viewer (back)"}};

    const auto drawCaster = [&](const CasterVolume& caster, float share) {
        const scene::Object& object = frame.scene().objects[caster.object];
        const scene::Light& source = frame.scene().light(light);
        // The volume that is counted may end far away. The one shown here is the short one of the lecture.
        std::vector<SilhouetteEdge> silhouette;
        const Volume volume = buildShown(object, source, caster, shown, silhouette);
        const VolumeBuffers buffers(volume, silhouette, [&] { caster.mesh->vertices->bindAttributes(); });
        faces_.set("clipFromMesh", mat4(frame.eye().clipFromMesh(object)));
        const VolumeEnd end{.planeWorld = {}, .distance = shown.distance.value_or(shownDistance(caster))};
        setExtrusion(faces_, extrusionOf(object, source, end));
        const auto choose = [&](const vec3& partColor, float alpha) {
            faces_.set("frontColor", unexposed(frame, byPart ? partColor : plus, alpha * share));
            faces_.set("backColor", unexposed(frame, byPart ? partColor : minus, alpha * share));
        };
        setFrontFace(object, false);
        choose(bottom, sideAlpha);
        buffers.drawBottomCap();
        choose(side, sideAlpha);
        buffers.drawSides();
        choose(top, capAlpha);
        buffers.drawTopCap();
        setFrontFace(object, true);
        buffers.drawTopCapReversed();
    };
    const auto draw = [&] {
        glDepthMask(GL_FALSE);
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        faces_.use();
        for (const bool hidden : {true, false}) {
            glDepthFunc(hidden ? GL_GREATER : GL_LEQUAL); // the top cap lies exactly on the caster's surface
            for (const CasterVolume* caster : casters)
                drawCaster(*caster, hidden ? hiddenShare : 1.0f);
        }
    };
    frame.drawOverTarget(byPart ? "volume-parts" : "volume-signs", light, true, draw,
                         {.unit = "", .key = byPart ? parts : signs});
}

void StagePictures::publishCount(Frame& frame, std::string_view stage, int light, bool bothSigns) const {
    std::vector<float> counts;
    for (const std::uint32_t word : depthStencilWords(frame)) {
        const int stored = static_cast<int>(word & 0xff);
        const int count = bothSigns && stored > 127 ? stored - 256 : stored; // the stencil wraps: 255 is -1
        counts.push_back(static_cast<float>(count));
    }
    publishCount(frame, stage, light, counts);
}

void StagePictures::publishCount(Frame& frame, std::string_view stage, int light,
                                 const std::vector<float>& counts) const {
    const std::vector<std::uint32_t> words = depthStencilWords(frame);
    std::vector<vec2> texels;
    texels.reserve(words.size());
    float largest = 1;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool surface = (words[i] >> 8) < 0xffffff;
        texels.emplace_back(counts[i], surface ? 1.0f : 0.0f);
        if (surface) largest = std::max(largest, std::abs(counts[i]));
    }
    const ivec2 size = frame.target().size();
    gl::Texture2D texture(GL_RG32F, size, stage);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RG, GL_FLOAT, texels.data());
    frame.publish(stage, light, std::move(texture),
                  {.minimum = -static_cast<double>(largest),
                   .maximum = static_cast<double>(largest),
                   .unit = "faces counted",
                   .key = {}});
}

} // namespace shadowlab::shadow_volume
