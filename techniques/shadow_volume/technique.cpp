// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/technique.h"

#include <chrono>

#include "techniques/foundation/trace/exact_visibility.h"

namespace shadowlab::shadow_volume {

namespace {

const PassInfo kPasses[] = {
    {"lights-off", "Render the scene with all light sources turned off",
     "Emission and ambient light are counted once; the depth buffer now holds the visible point of every pixel.",
     "depth test LESS, depth write on", false},
    {"clear-stencil", "Clear the stencil buffer", "Each light counts from zero.", "stencil write mask 0xff", true},
    {"volumes", "Count the volume faces behind each visible point",
     "Back faces add one and front faces take one where they fail the depth test: what is left is not zero inside a "
     "volume.",
     "colour and depth writes off, depth LESS, stencil depth-fail INCR_WRAP (back) and DECR_WRAP (front), depth clamp "
     "for what reaches infinity",
     true},
    {"volumes-back", "Render all volume faces that face away from the viewer",
     "The stencil goes up by one for each point that fails the depth test.",
     "colour and depth writes off, cull FRONT, depth LESS, stencil depth-fail INCR_WRAP", true},
    {"volumes-front", "Render all volume faces that face toward the viewer",
     "The stencil goes down by one for each point that fails the depth test: faces in front and behind cancel.",
     "colour and depth writes off, cull BACK, depth LESS, stencil depth-fail DECR_WRAP", true},
    {"light", "Render the scene again with the light turned on, only where the stencil is zero",
     "As many faces entered as left: the point is outside every volume, so the light sees it.",
     "colour writes on, depth EQUAL, stencil EQUAL 0, blending ONE ONE", true},
};

const StageInfo kStages[] = {
    {"facing", "Faces by the sign of N·L", StageKind::swatches, true},
    {"lights-off", "Scene with lights off", StageKind::radiance, false},
    {"silhouettes", "Silhouettes seen from the light", StageKind::radiance, true},
    {"volume-signs", "Volume faces by the side they turn to the viewer", StageKind::radiance, true},
    {"volume-parts", "Volume faces by part: top cap, sides, bottom cap", StageKind::radiance, true},
    {"stencil-back", "Stencil after the back faces: +1 for each behind the point", StageKind::count, true},
    {"stencil", "Stencil after all faces: zero is lit", StageKind::count, true},
    {"visibility", "Visibility of the light", StageKind::visibility, true},
};

/// Depth-fail counting state (Bilodeau and Songy 1999, Carmack 2000; two-sided: core since OpenGL 2.0).
void setCountState(const ZFailParams& params) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glDepthFunc(params.depthTest == ZFailParams::DepthTest::less ? GL_LESS : GL_LEQUAL);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 0, 0xff);
    glStencilOpSeparate(GL_BACK, GL_KEEP, params.wrap ? GL_INCR_WRAP : GL_INCR, GL_KEEP);
    glStencilOpSeparate(GL_FRONT, GL_KEEP, params.wrap ? GL_DECR_WRAP : GL_DECR, GL_KEEP);
}

void cullFace(GLenum face) {
    glEnable(GL_CULL_FACE);
    glCullFace(face);
}

} // namespace

params::ParamList ZFail::params() {
    return {
        params::boolean(
            "two-sided", params_.twoSided,
            "Count back and front faces in one pass; false: the lecture's steps 4 and 5, one after the other."),
        params::boolean("cull", params_.cull,
                        "Skip volumes that cannot reach the view, or in which nothing lies; the picture is the same."),
        params::boolean("wrap", params_.wrap,
                        "Let the stencil wrap around; false: it sticks at 0 and 255, and counts get lost (teaching)."),
        params::boolean("caps", params_.caps, "Close the volumes with caps; false: depth fail miscounts (teaching)."),
        params::choice("depth-test", params_.depthTest, {"less", "lequal"},
                       "Depth test of the volume faces; lequal: top caps fight with their own surface (teaching)."),
    };
}

Progress ZFail::prepare(const scene::Snapshot& snapshot, Deadline deadline) {
    while (!casters_.buildNext(snapshot))
        if (std::chrono::steady_clock::now() >= deadline) return {0.5, false};
    return {};
}

Progress ZFail::render(Frame& frame) {
    const scene::Scene& scene = frame.scene();
    frame.pass(passInfo(kPasses, "lights-off"),
               [&] { gl::drawLightsOff(lightsOff_, scene, frame.buffers(), frame.eye()); });
    if (frame.wants("lights-off")) frame.publishTarget("lights-off");

    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        const std::vector<CasterVolume>& casters = casters_.upload(frame.snapshot(), light);
        drawn_.clear();
        for (const CasterVolume& caster : casters)
            if (!params_.cull ||
                (caster.useful &&
                 volumeMayBeInView(caster.bounds, scene.lights[static_cast<std::size_t>(light)], frame.eye())))
                drawn_.push_back(&caster);
        frame.count("volumes", static_cast<double>(drawn_.size()), static_cast<double>(casters.size()), "casters");

        publishVisibility(frame, light);
        publishStencilStages(frame, light);
        countVolumes(frame, light);
        frame.pass(
            passInfo(kPasses, "light"),
            [&] {
                gl::setAddLightState();
                drawLit(frame, shade_, light);
            },
            light);
    }

    // Pictures over the finished image.
    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        std::vector<const CasterVolume*> casters;
        for (const CasterVolume& caster : casters_.upload(frame.snapshot(), light))
            if (caster.useful || !params_.cull) casters.push_back(&caster);
        if (frame.wants("facing", light)) pictures_.publishFacing(frame, light);
        if (frame.wants("silhouettes", light)) pictures_.publishSilhouettes(frame, light, casters);
        if (frame.wants("volume-signs", light)) pictures_.publishFaces(frame, light, casters, false);
        if (frame.wants("volume-parts", light)) pictures_.publishFaces(frame, light, casters, true);
    }
    return {};
}

void ZFail::countVolumes(Frame& frame, int light) {
    frame.pass(
        passInfo(kPasses, "clear-stencil"), [] { glClear(GL_STENCIL_BUFFER_BIT); }, light);
    if (params_.twoSided) {
        frame.pass(
            passInfo(kPasses, "volumes"),
            [&] {
                setCountState(params_);
                drawVolumes(frame, light);
            },
            light);
        return;
    }
    frame.pass(
        passInfo(kPasses, "volumes-back"),
        [&] {
            setCountState(params_);
            cullFace(GL_FRONT);
            drawVolumes(frame, light);
        },
        light);
    frame.pass(
        passInfo(kPasses, "volumes-front"),
        [&] {
            setCountState(params_);
            cullFace(GL_BACK);
            drawVolumes(frame, light);
        },
        light);
}

void ZFail::drawVolumes(const Frame& frame, int light) const {
    // Sides and bottom caps reach infinity: nothing may clip them there, so their depth is clamped.
    glEnable(GL_DEPTH_CLAMP);
    extrude_.use();
    for (const CasterVolume* caster : drawn_) {
        setExtrusion(extrude_, frame, *caster, light);
        setFrontFace(frame.scene().objects[caster->object], false);
        caster->buffers->drawSides();
        if (params_.caps) caster->buffers->drawBottomCap();
    }
    // Top caps lie on the casters' surfaces and must get the very depths the surfaces got: same vertices, same order,
    // same program text, and no clamp, because the surfaces themselves were clipped at the near plane.
    glDisable(GL_DEPTH_CLAMP);
    if (!params_.caps) return;
    cap_.use();
    for (const CasterVolume* caster : drawn_) {
        const scene::Object& object = frame.scene().objects[caster->object];
        cap_.set("clipFromMesh", mat4(frame.eye().clipFromMesh(object)));
        setFrontFace(object, false);
        caster->buffers->drawTopCap();
        setFrontFace(object, true);
        caster->buffers->drawTopCapReversed();
    }
}

void ZFail::drawLit(Frame& frame, const gl::Program& program, int light) const {
    program.use();
    gl::setLight(program, frame.scene(), frame.buffers(), frame.eye(), light);
    gl::drawSurfaces(program, frame.scene(), frame.buffers(), frame.eye(), [](const scene::Object& object) {
        glStencilFunc(object.receivesShadow ? GL_EQUAL : GL_ALWAYS, 0,
                      0xff); // what receives no shadow ignores the count
        return true;
    });
}

void ZFail::publishVisibility(Frame& frame, int light) {
    if (!frame.wants("visibility", light)) return;
    countVolumes(frame, light);
    frame.drawStage("visibility", light, GL_RG32F, [&] {
        // Every surface first, as if in shadow; then those the light reaches.
        glDepthFunc(GL_EQUAL);
        glDepthMask(GL_FALSE);
        glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
        visibility_.use();
        gl::drawSurfaces(visibility_, frame.scene(), frame.buffers(), frame.eye());
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        gl::setVisibilityState();
        drawLit(frame, visibility_, light);
    });
}

void ZFail::publishStencilStages(Frame& frame, int light) {
    if (frame.wants("stencil-back", light)) {
        frame.pass(
            passInfo(kPasses, "volumes-back"),
            [&] {
                glClear(GL_STENCIL_BUFFER_BIT);
                setCountState(params_);
                cullFace(GL_FRONT);
                drawVolumes(frame, light);
            },
            light);
        pictures_.publishCount(frame, "stencil-back", light, false);
    }
    if (frame.wants("stencil", light)) {
        countVolumes(frame, light);
        pictures_.publishCount(frame, "stencil", light, true);
    }
}

Probe ZFail::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    const trace::ExactVisibility exact(snapshot);
    const auto hit = exact.eyeHit(view.camera, dvec2(pixel) + 0.5, view.size);
    if (!hit || light < 0 || light >= static_cast<int>(snapshot->lights.size())) return probe;
    const int crossed = exact.crossings(*hit, light);
    probe.facts.push_back({"casting triangles between the point and the light", std::to_string(crossed), ""});
    return probe;
}

std::string ZFail::remark(const scene::MeshReport& report) const {
    if (report.isClosed()) return "closed: every silhouette edge separates two faces";
    return "not closed (" + std::to_string(report.boundaryEdges) + " boundary, " +
           std::to_string(report.multipleEdges) + " multiple, " + std::to_string(report.inconsistentEdges) +
           " inconsistently wound edges): handled exactly by signed edge counts";
}

std::span<const TechniqueInfo> techniques() {
    using enum scene::LightType;
    static const TechniqueInfo info[] = {{
        .id = "shadow-volume-zfail",
        .title = "Shadow volume (z-fail)",
        .paper = "Crow 1977, Shadow Algorithms for Computer Graphics; Everitt and Kilgard 2002, Practical and Robust "
                 "Stenciled Shadow Volumes",
        .getsWrong =
            "soft shadows (a light is a point); points behind exactly 256 casting triangles; isolated pixels at cracks",
        .order = 40,
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<ZFail>(); },
    }};
    return info;
}

} // namespace shadowlab::shadow_volume
