// SPDX-License-Identifier: MIT
#include "techniques/planar/technique.h"

#include <algorithm>
#include <chrono>
#include <map>

#include "techniques/foundation/trace/exact_visibility.h"

namespace shadowlab::planar {

namespace {

const PassInfo kPasses[] = {
    {"lights-off", "Render the scene with all light sources turned off",
     "Emission and ambient light are counted once; the depth buffer now holds the visible point of every pixel.",
     "depth test LESS, depth write on", false},
    {"tag-receivers", "Write the number of each receiver plane N·P + D = 0 into the stencil",
     "A shadow on a plane must end where the plane's surface ends, and where something stands before it.",
     "colour and depth writes off, depth EQUAL, stencil GREATER, REPLACE, write mask 0x3f", false, "stencil-tags"},
    {"clear-marks", "Clear the shadow marks", "Each light casts shadows of its own; the numbers of the planes stay.",
     "stencil write mask 0x80", true},
    {"shadows", "Project the casters onto each plane and mark where they fall",
     "The line from the light P_L through P meets the plane in P', with N·P' + D = 0: P' is in shadow. Only what lies "
     "between light and plane casts; a mark set twice is still one mark.",
     "colour and depth writes off, depth test off, clip distances at the light's height and at the plane, "
     "stencil EQUAL the plane's number, REPLACE, write mask 0x80",
     true, "shadow-marks"},
    {"light", "Render the scene again with the light turned on, only where there is no mark",
     "What is not marked is seen by the light; what is no plane can have no mark.",
     "depth EQUAL, stencil EQUAL 0 in the bits 0xc0, INVERT with write mask 0x40 (each pixel once), blending ONE ONE",
     true},
};

const StageInfo kStages[] = {
    {"receiver-planes", "Receiver planes N·P + D = 0", StageKind::radiance, false},
    {"stencil-tags", "Stencil: the number of the receiver plane", StageKind::swatches, false},
    {"flattened", "Flattened geometry before clipping, on the plane with the most shadow", StageKind::radiance, true},
    {"shadow-marks", "Stencil: shadow marks on the receiver planes", StageKind::swatches, true},
    {"lights-off", "Scene with lights off", StageKind::radiance, false},
    {"visibility", "Visibility of the light", StageKind::visibility, true},
};

void drawRuns(const gl::MeshBuffers& mesh, const std::vector<TriangleRun>& runs) {
    for (const TriangleRun& run : runs)
        mesh.draw(run.first, run.count);
}

} // namespace

params::ParamList Planar::params() {
    return {
        params::integer("receivers", params_.receivers, 0, kMostReceivers, "planes",
                        "At most so many planes receive shadows: the largest in the picture."),
        params::boolean("clip", params_.clip,
                        "Flatten only what lies between light and plane; false: anti-shadows of what lies beyond the "
                        "light or behind the plane (teaching)."),
        params::boolean("stencil", params_.stencil,
                        "Draw on the plane's own pixels, without depth; false: over everything that is not nearer, "
                        "spilling past the plane's edge (teaching)."),
        params::real(
            "offset", params_.offset, 0, 1000, "steps of depth",
            "Without stencil: how much nearer to the eye flattened faces are drawn; 0: they fight with the plane "
            "for depth (teaching)."),
        params::boolean(
            "cull", params_.cull,
            "Skip casters whose shadow cannot reach a plane, or lies out of view; the picture is the same."),
    };
}

Progress Planar::prepare(const scene::Snapshot& snapshot, Deadline deadline) {
    while (!receivers_.findNext(snapshot))
        if (std::chrono::steady_clock::now() >= deadline) return {0.3, false};
    while (!casters_.buildNext(snapshot))
        if (std::chrono::steady_clock::now() >= deadline) return {0.7, false};
    return {};
}

Progress Planar::render(Frame& frame) {
    const scene::Scene& scene = frame.scene();
    chosen_ = receivers_.choose(scene, frame.eye(), params_.receivers);

    frame.pass(passInfo(kPasses, "lights-off"),
               [&] { gl::drawLightsOff(lightsOff_, scene, frame.buffers(), frame.eye()); });
    if (frame.wants("lights-off")) frame.publishTarget("lights-off");
    frame.pass(passInfo(kPasses, "tag-receivers"), [&] { tagReceivers(frame); });
    frame.count("receivers", static_cast<double>(chosen_.size()), static_cast<double>(receivers_.all().size()),
                "planes");
    if (frame.wants("stencil-tags")) publishTags(frame);
    countServed(frame);

    std::map<int, int> mostShadowed; // per light: the number of the plane whose flattened geometry is shown
    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        const std::vector<PlaneOfLight> planes = planesOf(frame, light, params_.cull);
        for (const PlaneOfLight& plane : planes)
            frame.count("flattened", static_cast<double>(plane.casters.size()),
                        static_cast<double>(casters_.of(light).size()), "casters");
        frame.pass(
            passInfo(kPasses, "clear-marks"),
            [] {
                glStencilMask(kMarkBit);
                glClear(GL_STENCIL_BUFFER_BIT);
            },
            light);
        frame.pass(
            passInfo(kPasses, "shadows"), [&] { markShadows(frame, planes); }, light);
        if (frame.wants("shadow-marks", light)) publishMarks(frame, light);
        if (frame.wants("flattened", light)) mostShadowed[light] = mostMarkedTag(frame);
        if (frame.wants("visibility", light)) publishVisibility(frame, light);
        frame.pass(
            passInfo(kPasses, "light"),
            [&] {
                gl::setAddLightState();
                drawUnmarked(frame, shade_, light);
            },
            light);
    }

    // Pictures over the finished image.
    if (frame.wants("receiver-planes")) publishPlanes(frame);
    for (const auto& [light, tag] : mostShadowed)
        if (frame.wants("flattened", light)) publishFlattened(frame, light, tag);
    return {};
}

std::vector<PlaneOfLight> Planar::planesOf(const Frame& frame, int light, bool cull) const {
    const scene::Scene& scene = frame.scene();
    const gl::EyeMatrices& eye = frame.eye();
    const dvec4 lightWorld = scene::homogeneousPositionWorld(scene.lights[static_cast<std::size_t>(light)]);
    std::vector<PlaneOfLight> planes;
    for (const ChosenReceiver& receiver : chosen_) {
        const auto projection = projectOnto(receiver.planeView, eye.viewFromWorld * lightWorld);
        if (!projection) continue;
        // The eye is the origin of view space. Where it sees the side that the light does not, nothing is lit anyway.
        if (cull && projection->planeView.w <= 0) continue;
        PlaneOfLight plane{&receiver, *projection, {}};
        const bool mayBeAnywhere = !params_.clip || !params_.stencil; // naive drawing
        for (const Caster& caster : casters_.of(light)) {
            const dmat4 viewFromMesh = eye.viewFromWorld * scene::worldFromMesh(scene.objects[caster.object]);
            const double contact =
                contactHeight(*projection, eye, viewFromMesh, caster.farthestMesh, receiver.unevenness);
            if (!cull || mayBeAnywhere ||
                mayShadow(frame.buffers().bounds()[caster.object], eye, *projection, contact, receiver.frameView))
                plane.casters.push_back({&caster, viewFromMesh, contact});
        }
        planes.push_back(std::move(plane));
    }
    return planes;
}

void Planar::tagReceivers(const Frame& frame) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    tag_.use();
    std::vector<gl::QueryHandle> queries;
    for (const ChosenReceiver& receiver : chosen_) {
        // Of two planes at one depth the one drawn first is the visible one, and its number is the larger.
        glStencilFunc(GL_GREATER, receiver.tag, kTagBits);
        queries.push_back(gl::QueryHandle::create());
        glBeginQuery(GL_SAMPLES_PASSED, queries.back().id());
        drawReceiver(frame, tag_, receiver);
        glEndQuery(GL_SAMPLES_PASSED);
    }
    for (std::size_t i = 0; i < chosen_.size(); ++i)
        glGetQueryObjectiv(queries[i].id(), GL_QUERY_RESULT, &chosen_[i].pixels);
    // What is hidden needs no shadows; naive drawing would put them where they surprise everybody.
    if (params_.cull || !params_.stencil)
        std::erase_if(chosen_, [](const ChosenReceiver& receiver) { return receiver.pixels == 0; });
    std::ranges::stable_sort(chosen_, std::ranges::greater{}, &ChosenReceiver::pixels);
}

void Planar::drawReceiver(const Frame& frame, const gl::Program& program, const ChosenReceiver& one) {
    program.set("clipFromMesh", mat4(frame.eye().clipFromMesh(frame.scene().objects[one.receiver.object])));
    drawRuns(frame.buffers().mesh(one.receiver.object), one.receiver.face->runs);
}

void Planar::markShadows(const Frame& frame, const std::vector<PlaneOfLight>& planes) const {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glEnable(GL_STENCIL_TEST);
    glStencilMask(kMarkBit);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    if (params_.stencil) {
        glDisable(GL_DEPTH_TEST); // the shadow lies in the plane: any comparison would be of rounding
    } else {
        glDepthFunc(GL_LEQUAL);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(0, static_cast<float>(-params_.offset));
    }
    flatten_.use();
    for (const PlaneOfLight& plane : planes) {
        const GLint tagAndMark = static_cast<GLint>(kMarkBit) + plane.receiver->tag;
        glStencilFunc(params_.stencil ? GL_EQUAL : GL_ALWAYS, tagAndMark, kTagBits);
        if (params_.clip) {
            drawFlattened(frame, flatten_, plane, Part::between);
        } else {
            drawFlattened(frame, flatten_, plane, Part::wherever);
            drawFlattened(frame, flatten_, plane, Part::whereverTurnedOver);
        }
    }
}

void Planar::drawFlattened(const Frame& frame, const gl::Program& program, const PlaneOfLight& plane, Part part) const {
    glEnable(GL_CLIP_DISTANCE0);
    glEnable(GL_CLIP_DISTANCE1);
    const bool clipped = part != Part::wherever && part != Part::whereverTurnedOver;
    const dvec4 always(0, 0, 0, 1); // as a row: 1 everywhere, so nothing is clipped
    // The weight is negative beyond the light. With all signs turned over the same homogeneous points have a positive one.
    const bool beyond = part == Part::beyondLight || part == Part::whereverTurnedOver;
    program.set("sheet", beyond ? -1.0f : 1.0f);
    for (const auto& [caster, viewFromMesh, contact] : plane.casters) {
        // Most of the plane's own object lies in the plane or behind it, and unclipped it would cover all of the plane.
        if (part != Part::between && caster->object == plane.receiver->receiver.object) continue;
        dvec4 weightRow = plane.projection.weightRow(viewFromMesh),
              heightRow = plane.projection.heightRow(viewFromMesh);
        if (part == Part::beyondLight) weightRow = -weightRow;
        if (part == Part::behindPlane) heightRow = -heightRow;
        heightRow.w -= contact;
        program.set("clipFromMeshFlattened",
                    mat4(frame.eye().clipFromView * plane.projection.flattenedFromView * viewFromMesh));
        program.set("weightRow", vec4(clipped ? weightRow : always));
        program.set("heightRow", vec4(clipped ? heightRow : always));
        drawRuns(frame.buffers().mesh(caster->object), caster->blocking);
    }
}

void Planar::drawUnmarked(const Frame& frame, const gl::Program& program, int light) const {
    glStencilMask(kLitBit);
    glClear(GL_STENCIL_BUFFER_BIT);
    glStencilFunc(GL_EQUAL, 0, kLitBit | kMarkBit);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
    program.use();
    gl::setLight(program, frame.scene(), frame.buffers(), frame.eye(), light);
    gl::drawSurfaces(program, frame.scene(), frame.buffers(), frame.eye());
}

Probe Planar::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    const trace::ExactVisibility exact(snapshot);
    const auto hit = exact.eyeHit(view.camera, dvec2(pixel) + 0.5, view.size);
    if (!hit) return probe;
    const gl::EyeMatrices eye = gl::eyeMatrices(view.camera, view.size);
    for (const ChosenReceiver& one : receivers_.choose(*snapshot, eye, params_.receivers)) {
        if (one.receiver.object != hit->object || !contains(one.receiver.face->runs, hit->triangle)) continue;
        const dmat4 worldFromMesh = scene::worldFromMesh(snapshot->objects[hit->object]);
        probe.facts.push_back({"receiver plane", equation(planeOf(*one.receiver.face, worldFromMesh)), ""});
        probe.facts.push_back({"stencil number", std::to_string(one.tag), ""});
        return probe;
    }
    probe.facts.push_back({"receiver plane", "none: no shadow can fall here", ""});
    return probe;
}

std::string Planar::remark(const scene::MeshReport& report) const {
    const std::string holes = report.hasHoles ? "; holes cut by its alpha map are cast as solid" : "";
    if (report.triangles <= 2) return "flat: casts, and receives the shadows of others" + holes;
    return "casts as it is, open or closed; receives on its large flat faces only, and nothing where it is curved" +
           holes;
}

std::span<const TechniqueInfo> techniques() {
    using enum scene::LightType;
    static const TechniqueInfo info[] = {{
        .id = "planar",
        .title = "Planar projected shadows",
        .paper = "Blinn 1988, Me and My (Fake) Shadow",
        .getsWrong = "shadows on curved surfaces: there are none; soft shadows (a light is a point)",
        .order = 10,
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<Planar>(); },
    }};
    return info;
}

} // namespace shadowlab::planar
