// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/face_counter.h"

#include "techniques/shadow_volume/stage_pictures.h"

namespace shadowlab::shadow_volume {

namespace {

/// Where a face that counts adds (+1) or takes (-1): only as far as the counter goes, unless it wraps.
void setStencilFunctions(GLenum adding, GLenum taking, const StencilRule& stencil) {
    glStencilMask(stencil.mask()); // of a count that needs more bits, the lower ones are stored: it wraps
    const GLenum test = stencil.wrap ? GL_ALWAYS : GL_NOTEQUAL;
    glStencilFuncSeparate(adding, test, static_cast<GLint>(stencil.mask()), stencil.mask());
    glStencilFuncSeparate(taking, test, 0, stencil.mask());
}

} // namespace

void FaceCounter::countPassing(const Frame& frame, int light, std::span<const CountedVolume> volumes,
                               const PassRule& rule, const StencilRule& stencil) const {
    setStencilFunctions(GL_FRONT, GL_BACK, stencil);
    glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
    glDepthFunc(GL_LESS);
    if (rule.corrected) glEnable(GL_DEPTH_CLAMP); // before the near plane is before every visible point
    extrude_.use();
    const dvec4 eyeWorld(frame.camera().positionWorld, 1.0);
    for (const CountedVolume& volume : volumes) {
        if (volume.way != Way::pass) continue;
        const CasterVolume& caster = *volume.seen.caster;
        drawSides(frame, caster, light);
        // From beyond its end one looks into a volume through the bottom.
        if (caster.endWorld && glm::dot(*caster.endWorld, eyeWorld) > 0) caster.buffers->drawBottomCap();
    }
    if (rule.corrected) {
        // No top cap lies before a visible point, but for what the near plane has cut off from the surfaces.
        const dmat4 clipFromWorld = frame.eye().clipFromView * frame.eye().viewFromWorld;
        glEnable(GL_CLIP_DISTANCE0);
        nearCap_.use();
        for (const CountedVolume& volume : volumes)
            if (volume.way == Way::pass && !scene::isBeyondNearPlane(volume.seen.caster->bounds, clipFromWorld))
                drawTopCap(frame, nearCap_, *volume.seen.caster);
        glDisable(GL_CLIP_DISTANCE0);
    }
    glDisable(GL_DEPTH_CLAMP);
}

void FaceCounter::countFailing(const Frame& frame, int light, std::span<const CountedVolume> volumes,
                               const FailRule& rule, const StencilRule& stencil) const {
    setStencilFunctions(GL_BACK, GL_FRONT, stencil);
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
    glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
    glDepthFunc(rule.lessOrEqual ? GL_LEQUAL : GL_LESS);
    // Sides and bottom caps may reach infinity: nothing may clip them there, so their depth is clamped.
    glEnable(GL_DEPTH_CLAMP);
    extrude_.use();
    for (const CountedVolume& volume : volumes) {
        if (volume.way != Way::fail) continue;
        drawSides(frame, *volume.seen.caster, light);
        if (rule.caps && volume.seen.bottomCap) volume.seen.caster->buffers->drawBottomCap();
    }
    // Top caps lie on the casters' surfaces and must get the very depths the surfaces got: same vertices, same order,
    // same program text, and no clamp, because the surfaces themselves were clipped at the near plane.
    glDisable(GL_DEPTH_CLAMP);
    if (!rule.caps) return;
    cap_.use();
    for (const CountedVolume& volume : volumes)
        if (volume.way == Way::fail && volume.seen.topCap) drawTopCap(frame, cap_, *volume.seen.caster);
}

void FaceCounter::drawSides(const Frame& frame, const CasterVolume& caster, int light) const {
    setExtrusion(extrude_, frame, caster, light);
    setFrontFace(frame.scene().objects[caster.object], false);
    caster.buffers->drawSides();
}

void FaceCounter::drawTopCap(const Frame& frame, const gl::Program& program, const CasterVolume& caster) const {
    const scene::Object& object = frame.scene().objects[caster.object];
    program.set("clipFromMesh", mat4(frame.eye().clipFromMesh(object)));
    setFrontFace(object, false);
    caster.buffers->drawTopCap();
    setFrontFace(object, true);
    caster.buffers->drawTopCapReversed();
}

} // namespace shadowlab::shadow_volume
