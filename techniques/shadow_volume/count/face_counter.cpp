// SPDX-License-Identifier: MIT
#include "techniques/probed/volume_probe.h"
#include "techniques/shadow_volume/count/face_counter.h"

namespace shadowlab::shadow_volume {

namespace {

/// For faces that add one and faces that subtract one. A counter that does not wrap stops at the ends of its range.
void setStencilFunctions(GLenum adding, GLenum taking, const StencilRule& stencil) {
    glStencilMask(stencil.mask()); // only the lower bits of the count are stored, so it wraps
    const GLenum test = stencil.wrap ? GL_ALWAYS : GL_NOTEQUAL;
    glStencilFuncSeparate(adding, test, static_cast<GLint>(stencil.mask()), stencil.mask());
    glStencilFuncSeparate(taking, test, 0, stencil.mask());
}

} // namespace

FaceCounter::Programs::Programs(const std::string& fragment)
    : extrude("shadow_volume/extrude.vert", fragment), extruded("shadow_volume/extruded.vert", fragment),
      cap("position.vert", fragment), nearCap("shadow_volume/near_cap.vert", fragment) {}

void FaceCounter::countIntoStencil(const Frame& frame, int light, std::span<const CountedVolume> volumes,
                                   const CountRules& rules, const StencilRule& stencil) const {
    // [anchor: count-passing]
    setStencilFunctions(GL_FRONT, GL_BACK, stencil);
    glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
    glDepthFunc(GL_LESS);
    drawPassing(frame, light, volumes, rules.pass, forStencil_);

    // [anchor: count-failing]
    setStencilFunctions(GL_BACK, GL_FRONT, stencil);
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
    glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
    glDepthFunc(rules.fail.lessOrEqual ? GL_LEQUAL : GL_LESS);
    drawFailing(frame, light, volumes, rules.fail, forStencil_);
}

void FaceCounter::countIntoColor(const Frame& frame, int light, std::span<const CountedVolume> volumes,
                                 const CountRules& rules, bool allAdd) const {
    const auto setSigns = [&](float front, float back) {
        for (const gl::Program* program :
             {&forColor_.extrude, &forColor_.extruded, &forColor_.cap, &forColor_.nearCap}) {
            program->use();
            program->set("front", front);
            program->set("back", back);
        }
    };
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    setSigns(1, allAdd ? 1.0f : -1.0f);
    glDepthFunc(GL_LESS);
    drawPassing(frame, light, volumes, rules.pass, forColor_);
    // Colour is written where the depth test passes, so the test is the opposite of the one whose failures count.
    setSigns(allAdd ? 1.0f : -1.0f, 1);
    glDepthFunc(rules.fail.lessOrEqual ? GL_GREATER : GL_GEQUAL);
    drawFailing(frame, light, volumes, rules.fail, forColor_);
    glDisable(GL_BLEND);
}

void FaceCounter::drawPassing(const Frame& frame, int light, std::span<const CountedVolume> volumes,
                              const PassRule& rule, const Programs& programs) const {
    if (rule.corrected) glEnable(GL_DEPTH_CLAMP); // faces before the near plane are kept: they are before every visible point
    const dvec4 eyeWorld(frame.camera().positionWorld, 1.0);
    for (const CountedVolume& volume : volumes) {
        if (volume.method != CountMethod::zPass) continue;
        // An eye beyond the end plane looks into the volume through its bottom cap. An end at a distance is no plane and
        // may be seen from anywhere.
        const VolumeEnd& end = volume.seen.end;
        drawExtruded(frame, volume, light, end.distance || (end.planeWorld && glm::dot(*end.planeWorld, eyeWorld) > 0),
                     programs);
    }
    if (rule.corrected) {
        // A top cap lies on a surface, so it is never before a visible point, except for the part of the surface that the
        // near plane has cut off.
        const dmat4 clipFromWorld = frame.eye().clipFromView * frame.eye().viewFromWorld;
        glEnable(GL_CLIP_DISTANCE0);
        programs.nearCap.use();
        for (const CountedVolume& volume : volumes)
            if (volume.method == CountMethod::zPass &&
                !scene::isBeyondNearPlane(volume.seen.caster->bounds, clipFromWorld)) {
                frame.scissorTo(volume.seen.part);
                drawTopCap(frame, programs.nearCap, *volume.seen.caster);
            }
        glDisable(GL_CLIP_DISTANCE0);
    }
    glDisable(GL_DEPTH_CLAMP);
}

void FaceCounter::drawFailing(const Frame& frame, int light, std::span<const CountedVolume> volumes,
                              const FailRule& rule, const Programs& programs) const {
    // Sides and bottom caps may reach infinity. Depth clamp keeps the far plane from clipping them.
    if (rule.clamp) glEnable(GL_DEPTH_CLAMP);
    for (const CountedVolume& volume : volumes)
        if (volume.method == CountMethod::zFail)
            drawExtruded(frame, volume, light, rule.caps && volume.seen.bottomCap, programs);
    // Top caps lie on the casters' surfaces and must get exactly their depths. So they use the same vertices in the same
    // order and the same expression for the position; and no clamp, because the surfaces were clipped at the near plane.
    glDisable(GL_DEPTH_CLAMP);
    if (!rule.caps) return;
    programs.cap.use();
    for (const CountedVolume& volume : volumes)
        if (volume.method == CountMethod::zFail && volume.seen.topCap) {
            frame.scissorTo(volume.seen.part);
            drawTopCap(frame, programs.cap, *volume.seen.caster);
        }
}

void FaceCounter::drawExtruded(const Frame& frame, const CountedVolume& volume, int light, bool bottomCap,
                               const Programs& programs) const {
    const CasterVolume& caster = *volume.seen.caster;
    const scene::Object& object = frame.scene().objects[caster.object];
    const gl::Program& program = volume.extruded ? programs.extruded : programs.extrude;
    program.use();
    program.set("clipFromMesh", mat4(frame.eye().clipFromMesh(object)));
    const scene::Light& source = frame.scene().light(light);
    if (!volume.extruded) setExtrusion(program, extrusionOf(object, source, volume.seen.end));
    setFrontFace(object, false);
    frame.scissorTo(volume.seen.part);
    const VolumeBuffers& buffers = volume.extruded ? *volume.extruded : *caster.buffers;
    // With a directional light all sides meet in one point at infinity.
    const VolumeEnd& end = volume.seen.end;
    const bool atInfinity = !end.planeWorld && !end.distance;
    buffers.drawSides(atInfinity && source.type == scene::LightType::directional);
    if (bottomCap) buffers.drawBottomCap();
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
