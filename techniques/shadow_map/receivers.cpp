// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/receivers.h"

#include "techniques/shadow_map/filters/filters.h"

namespace shadowlab::shadow_map {

namespace {

/// How a point finds its map among several.
const char* layerShader(Layout layout, bool inWorld) {
    switch (layout) {
    case Layout::cube: return "shadow_map/layers/layer_cube.glsl";
    case Layout::cascades: return "shadow_map/layers/layer_cascades.glsl";
    case Layout::one: break;
    }
    return inWorld ? "shadow_map/layers/layer_one_world.glsl" : "shadow_map/layers/layer_one.glsl";
}

} // namespace

Receivers::Programs Receivers::makePrograms(const Choice& choice) {
    // Each include is of a file that exists, the simplest of its kind, and the chosen file takes its place.
    const std::vector<gl::Substitution> chosen = {
        {"shadow_visibility.glsl", "shadow_map/visibility.glsl"},
        {"shadow_map/point_light.glsl", choice.inWorld ? "shadow_map/point_world.glsl" : "shadow_map/point_light.glsl"},
        {"shadow_map/layers/layer_one.glsl", layerShader(choice.layout, choice.inWorld)},
        {"shadow_map/bias/bias_none.glsl", std::string(biasInfo(choice.bias).shader)},
        {"shadow_map/filters/filter_hard.glsl", std::string(filterInfo(choice.filter).shader)}};
    std::vector<std::string> defines;
    if (biasInfo(choice.bias).comparesWithOneDepth) defines.emplace_back("ONE_DEPTH");
    std::vector<std::string> visibilityDefines = defines;
    visibilityDefines.emplace_back("VISIBILITY_ONLY");
    return {gl::Program("surface.vert", "shade_light.frag", defines, chosen),
            gl::Program("surface.vert", "shade_light.frag", visibilityDefines, chosen),
            gl::Program("surface.vert", "shadow_map/project.frag", {}, chosen),
            gl::Program("surface.vert", "shadow_map/texel_size.frag", {}, chosen),
            gl::Program("surface.vert", "shadow_map/layers.frag", {}, chosen),
            gl::Program("surface.vert", "shadow_map/penumbra.frag", {}, chosen),
            gl::Program("surface.vert", "shadow_map/kernel.frag", {}, chosen),
            gl::Program("surface.vert", "shadow_map/decide.frag", {}, {chosen[1], chosen[2]})};
}

const Receivers::Programs& Receivers::programsFor(const LightShadowMap& map) {
    const Choice choice{map.maps.layout, params_.bias.mode, map.query.filter.kind, params_.looksUpInWorld()};
    const auto known = programs_.find(choice);
    return known != programs_.end() ? known->second : programs_.emplace(choice, makePrograms(choice)).first->second;
}

const gl::Program& Receivers::lightProgram(const LightShadowMap& map, bool visibilityOnly) {
    if (map.decided) return visibilityOnly ? decidedVisibility_ : decidedShade_;
    if (!map.depth) return visibilityOnly ? unshadowedVisibility_ : unshadowed_;
    map.depth->sample(depthSampling(map.query.filter, biasInfo(params_.bias.mode).comparesWithOneDepth));
    const Programs& programs = programsFor(map);
    return visibilityOnly ? programs.visibility : programs.shade;
}

void Receivers::drawWhereNeeded(const Frame& frame, const gl::Program& lookup, const gl::Program& plain, int light,
                                const LightShadowMap& map, const OwnUniforms& own) {
    // Outside of the map there is no shadow, unless its border or its mirror image is to be seen there.
    const bool outsideIsLit = params_.border == ShadowMapParams::Border::lit && params_.rejectBehind;
    if (!params_.cull || !map.depth || !outsideIsLit) {
        draw(frame, lookup, light, map, own);
        return;
    }
    const std::vector<ReceiverLookup>& lookups = fitter_.lookups(frame, light, map.maps);
    use(frame, plain, light, map, own);
    use(frame, lookup, light, map, own);
    // Object by object, as gl::drawSurfaces does: of two surfaces at one depth the first drawn is the visible one. The stencil
    // lets each pixel be lit only once, so the second drawing of an object leaves out the pixels of the first.
    for (std::size_t object = 0; object < frame.scene().objects.size(); ++object) {
        const ReceiverLookup& how = lookups[object];
        const auto drawObject = [&](const gl::Program& program) {
            program.use();
            gl::drawSurface(program, frame.scene(), frame.buffers(), frame.eye(), object, [&](const scene::Object&) {
                setObject(frame, program, map, object, own);
                return true;
            });
        };
        frame.scissorTo(how.where);
        if (how.looksUp) drawObject(lookup);
        frame.scissorTo(std::nullopt);
        if (how.rest) drawObject(plain);
    }
}

void Receivers::draw(const Frame& frame, const gl::Program& program, int light, const LightShadowMap& map,
                     const OwnUniforms& own) {
    use(frame, program, light, map, own);
    for (std::size_t object = 0; object < frame.scene().objects.size(); ++object)
        gl::drawSurface(program, frame.scene(), frame.buffers(), frame.eye(), object, [&](const scene::Object&) {
            setObject(frame, program, map, object, own);
            return true;
        });
}

void Receivers::use(const Frame& frame, const gl::Program& program, int light, const LightShadowMap& map,
                    const OwnUniforms& own) const {
    gl::useForLight(program, frame.scene(), frame.buffers(), frame.eye(), light, own.shadedAs);
    program.set("shadowMap", kMapUnit); // also where there is none: no unit holds textures of two kinds
    if (map.depth) {
        setReceiverUniforms(program, map.maps, params_, map.query.filter);
        setFilterUniforms(program, map.query.light, map.query.filter, map.maps);
        program.set("outsideIsLit", params_.border == ShadowMapParams::Border::lit ? 1 : 0);
        map.depth->bind(kMapUnit);
    }
    program.set("moments", kMomentsUnit);
    if (map.moments) map.moments->bind(kMomentsUnit);
    if (map.decided) {
        map.decided->bind(kDecidedUnit);
        program.set("decided", kDecidedUnit);
    }
    if (own.once) own.once(program);
}

void Receivers::setObject(const Frame& frame, const gl::Program& program, const LightShadowMap& map, std::size_t object,
                          const OwnUniforms& own) const {
    const dmat4 lightRelative = lightRelativeFromMesh(map.maps, frame.scene().objects[object]);
    program.set("lightRelativeFromMesh", mat4(lightRelative));
    if (params_.looksUpInWorld())
        program.set("worldFromMesh", mat4(scene::worldFromMesh(frame.scene().objects[object])));
    if (map.maps.layers() > 0) // where there is one map; of several the fragment chooses
        program.set("lightClipFromMesh", mat4(map.maps.lightClipFromLightRelative(0) * lightRelative));
    program.set("minReferenceDepth", static_cast<float>(minReferenceDepth(map.maps, fitter_.bounds()[object])));
    if (own.perObject) own.perObject(program, object);
}

} // namespace shadowlab::shadow_map
