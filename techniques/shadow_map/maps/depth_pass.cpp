// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/maps/depth_pass.h"

namespace shadowlab::shadow_map {

namespace {

constexpr int kFirstUnit = gl::kFirstFreeUnit, kSecondUnit = kFirstUnit + 1, kPushedUnit = kFirstUnit + 2;

/// Two depths that differ by less belong to one surface: four steps of the format.
float depthEpsilon(GLenum format) { return format == GL_DEPTH_COMPONENT16 ? 4.0f / (1 << 16) : 4.0f / (1 << 24); }

/// Does the light see a front face wherever it sees the object? Then half of its triangles need not be drawn.
bool mayLeaveOutBackFaces(const Frame& frame, const LightMaps& maps, std::size_t object) {
    const scene::Bounds& box = frame.buffers().bounds()[object];
    const bool lightIsOutside = maps.parallel || glm::any(glm::lessThan(maps.originWorld, box.lowerWorld)) ||
                                glm::any(glm::greaterThan(maps.originWorld, box.upperWorld));
    return frame.scene().objects[object].mesh->outward && !frame.buffers().hasHoles(object) && lightIsOutside;
}

void pushBack(const DepthRules& rules, double slopeFactor) {
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(static_cast<float>(slopeFactor), static_cast<float>(rules.units));
}

} // namespace

DepthRules depthRules(const ShadowMapParams& params, const FilterParams& filter) {
    DepthRules rules;
    const BiasInfo& bias = biasInfo(params.bias.mode);
    rules.depthClamp = params.depthClamp;
    if (bias.slopeFactor) rules.slopeFactor = bias.slopeFactor(params.bias, filter.comparedRadius());
    if (bias.reads("rounding-bias")) rules.units = 2 * params.bias.rounding;
    rules.dual = bias.isDualDepth;
    return rules;
}

// [anchor: draw-map]
void DepthPass::draw(const Frame& frame, const LightMaps& maps, int layer, std::span<const std::size_t> casters,
                     const gl::DepthTextureArray& depth, GLenum format, const DepthRules& rules) const {
    glDisable(GL_SCISSOR_TEST); // the map is whole, whatever part of the picture is drawn
    if (rules.depthClamp) glEnable(GL_DEPTH_CLAMP);
    if (rules.dual) {
        drawDual(frame, maps, layer, casters, depth, format, rules);
        return;
    }
    const gl::Framebuffer framebuffer(depth, layer, "shadow map layer");
    framebuffer.bind();
    glClear(GL_DEPTH_BUFFER_BIT);
    pushBack(rules, rules.slopeFactor);
    drawCasters(depth_, frame, maps, layer, casters);
}

void DepthPass::drawWithIds(const Frame& frame, const LightMaps& maps, int layer, std::span<const std::size_t> casters,
                            const gl::DepthTextureArray& depth, const gl::IdTextureArray& ids,
                            const DepthRules& rules) const {
    glDisable(GL_SCISSOR_TEST);
    if (rules.depthClamp) glEnable(GL_DEPTH_CLAMP);
    const gl::Framebuffer framebuffer(ids, depth, layer, "shadow map layer with triangles");
    framebuffer.bind();
    glClear(GL_DEPTH_BUFFER_BIT);
    const GLuint nothing[4] = {kNothing, kNothing, kNothing, kNothing};
    glClearBufferuiv(GL_COLOR, 0, nothing);
    drawCasters(ids_, frame, maps, layer, casters);
}

// [anchor: draw-casters]
void DepthPass::drawCasters(const gl::Program& program, const Frame& frame, const LightMaps& maps, int layer,
                            std::span<const std::size_t> casters) const {
    for (const std::size_t caster : casters) {
        if (&program != &secondDepth_ && mayLeaveOutBackFaces(frame, maps, caster)) {
            glEnable(GL_CULL_FACE);
            glCullFace(scene::isMirrored(frame.scene().objects[caster]) ? GL_FRONT : GL_BACK);
        }
        gl::drawDepth(program, frame.scene(), frame.buffers(), caster,
                      maps.lightClipFromLightRelative(layer) *
                          lightRelativeFromMesh(maps, frame.scene().objects[caster]));
        glDisable(GL_CULL_FACE);
    }
}

void DepthPass::drawDual(const Frame& frame, const LightMaps& maps, int layer, std::span<const std::size_t> casters,
                         const gl::DepthTextureArray& depth, GLenum format, const DepthRules& rules) const {
    const auto drawInto = [&](const gl::DepthTextureArray& texture, int textureLayer, const gl::Program& program) {
        const gl::Framebuffer framebuffer(texture, textureLayer, "dual depth layer");
        framebuffer.bind();
        glClear(GL_DEPTH_BUFFER_BIT);
        drawCasters(program, frame, maps, layer, casters);
    };
    const gl::DepthTextureArray first(format, depth.side(), 1, "first depth"),
        second(format, depth.side(), 1, "second depth"), pushed(format, depth.side(), 1, "pushed depth");
    for (const gl::DepthTextureArray* texture : {&first, &second, &pushed})
        texture->sample(gl::DepthSampling::depths);
    drawInto(first, 0, depth_);
    pushBack(rules, rules.slopeFactor);
    drawInto(pushed, 0, depth_);
    glDisable(GL_POLYGON_OFFSET_FILL);
    first.bind(kFirstUnit);
    for (const gl::Program* program : {&secondDepth_, &secondDepth_.alphaTested()}) {
        program->use();
        program->set("firstDepth", kFirstUnit);
        program->set("depthEpsilon", depthEpsilon(format));
    }
    drawInto(second, 0, secondDepth_);

    const gl::Framebuffer framebuffer(depth, layer, "shadow map layer");
    framebuffer.bind();
    glDepthFunc(GL_ALWAYS);
    dualDepth_.use();
    second.bind(kSecondUnit);
    pushed.bind(kPushedUnit);
    dualDepth_.set("firstDepth", kFirstUnit);
    dualDepth_.set("secondDepth", kSecondUnit);
    dualDepth_.set("pushedDepth", kPushedUnit);
    gl::drawFullscreenTriangle();
    glDepthFunc(GL_LESS);
}

} // namespace shadowlab::shadow_map
