// Drawing the receivers with a light's map: asked only where the shadow of a caster can fall.
// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/filters/filter_uniforms.h"
#include "techniques/shadow_map/fit/near_plane.h"
#include "techniques/shadow_map/technique.h"

namespace shadowlab::shadow_map {

const gl::Program& ShadowMap::lightProgram(const DrawnMap& map, bool visibilityOnly) {
    if (map.decided) return visibilityOnly ? decidedVisibility_ : decidedShade_;
    if (!map.depth) return visibilityOnly ? unshadowedVisibility_ : unshadowed_;
    map.depth->sample(depthSampling(map.asked.filter, params_.bias.mode));
    const Programs& programs = programsFor(map);
    return visibilityOnly ? programs.visibility : programs.shade;
}

void ShadowMap::drawAsked(const Frame& frame, const gl::Program& asking, const gl::Program& plain, int light,
                          const DrawnMap& map) {
    // Streaks and mirror images lie outside of what the map is for.
    const bool outsideIsLit = params_.border == ShadowMapParams::Border::lit && params_.rejectBehind;
    if (!params_.cull || !map.depth || !outsideIsLit) {
        drawReceivers(frame, asking, light, map);
        return;
    }
    // The maps of the frame may be asked in the next one as well, those of single points of a light are asked once.
    const bool isOfFrame = map.maps == fitted_[static_cast<std::size_t>(light)];
    std::vector<Asking> own;
    std::vector<Asking>& ways = isOfFrame ? askings_[light] : own;
    if (ways.empty()) ways = askings(frame, map.maps);
    useForReceivers(frame, plain, light, map);
    useForReceivers(frame, asking, light, map);
    // Object by object, as gl::drawSurfaces does: of two surfaces at one depth the first drawn is the visible one. The stencil
    // lets each pixel be lit once: what was asked is not drawn again with the rest of its object.
    for (std::size_t object = 0; object < frame.scene().objects.size(); ++object) {
        const Asking& how = ways[object];
        const auto draw = [&](const gl::Program& program) {
            program.use();
            gl::drawSurface(program, frame.scene(), frame.buffers(), frame.eye(), object,
                            [&](const scene::Object&) { return setReceiver(frame, program, light, map, object); });
        };
        frame.scissorTo(how.where);
        if (how.asks) draw(asking);
        frame.scissorTo(std::nullopt);
        if (how.rest) draw(plain);
    }
}

std::vector<Asking> ShadowMap::askings(const Frame& frame, const LightMaps& maps) const {
    const dmat4 clipFromWorld = frame.eye().clipFromView * frame.eye().viewFromWorld;
    std::vector<Asking> ways;
    for (const scene::Bounds& box : bounds_)
        ways.push_back(askingOf(maps, box, clipFromWorld));
    return ways;
}

void ShadowMap::drawReceivers(const Frame& frame, const gl::Program& program, int light, const DrawnMap& map,
                              const std::function<void()>& setUniforms) {
    useForReceivers(frame, program, light, map);
    if (setUniforms) setUniforms();
    gl::drawSurfaces(program, frame.scene(), frame.buffers(), frame.eye(), [&](const scene::Object& object) {
        const auto index = static_cast<std::size_t>(&object - frame.scene().objects.data());
        return setReceiver(frame, program, light, map, index);
    });
}

void ShadowMap::useForReceivers(const Frame& frame, const gl::Program& program, int light, const DrawnMap& map) const {
    gl::useForLight(program, frame.scene(), frame.buffers(), frame.eye(), light);
    program.set("shadowMap", kMapUnit); // also where there is none: no unit holds textures of two kinds
    if (map.depth) {
        setReceiverUniforms(program, map.maps, params_, map.asked.filter);
        setFilterUniforms(program, map.asked.light, map.asked.filter, map.maps);
        program.set("outsideIsLit", params_.border == ShadowMapParams::Border::lit ? 1 : 0);
        map.depth->bind(kMapUnit);
    }
    program.set("moments", kMomentsUnit);
    if (map.moments) map.moments->bind(kMomentsUnit);
    if (map.exact) setExactUniforms(program, light, map);
    if (map.decided) {
        map.decided->bind(kDecidedUnit);
        program.set("decided", kDecidedUnit);
    }
}

bool ShadowMap::setReceiver(const Frame& frame, const gl::Program& program, int light, const DrawnMap& map,
                            std::size_t object) const {
    const dmat4 lightRelative = lightRelativeFromMesh(map.maps, frame.scene().objects[object]);
    program.set("lightRelativeFromMesh", mat4(lightRelative));
    if (params_.looksUpInWorld())
        program.set("worldFromMesh", mat4(scene::worldFromMesh(frame.scene().objects[object])));
    if (map.maps.layers() > 0) // where there is one map; of several the fragment chooses
        program.set("lightClipFromMesh", mat4(map.maps.lightClipFromLightRelative(0) * lightRelative));
    program.set("leastReference", static_cast<float>(leastReference(map.maps, bounds_[object])));
    if (map.exact) setObjectUniforms(frame, program, light, object);
    return true;
}

} // namespace shadowlab::shadow_map
