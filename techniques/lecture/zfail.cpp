// Shadow volumes in the stencil buffer, counted behind the visible point: z-fail.
//
// A shadow volume is an enclosed region of space, formed by extruding the outline of an object away from the light source. From
// each visible point a ray runs to infinity, away from the view point. It crosses n_f volume faces that face the viewer and n_b that
// face away. If n_f = n_b the ray leaves no volume that it has not entered: the point is illuminated, otherwise it is in shadow. The
// ray never comes near the view point, so the result is right wherever the viewer is.
//
// Lecture: "Z-Fail Shadow Volume Algorithm", "Generate Shadow Volume Faces", "Shadow Volume Using Stencil Buffer".
// Sources: Crow, "Shadow Algorithms for Computer Graphics", 1977; Everitt and Kilgard, "Practical and Robust Stenciled Shadow
// Volumes", 2002. Simplified: every caster is closed, so that each edge has two polygons; its holes cast as if they were filled; a
// light with an area is its centre; all volumes are built anew for each picture.
// SPDX-License-Identifier: MIT
#include <map>

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/foundation/scene/query/facing.h"
#include "techniques/lecture/lecture.h"
#include "techniques/lecture/parts/lit_scene.h"
#include "techniques/lecture/words/zfail.h"

namespace shadowlab::lecture::zfail {

// --- Generate shadow volume faces. In mesh space; P_L is homogeneous: w = 1 and a place, or w = 0 and the way to the sun. ---

/// Orientation of a polygon surface with respect to the light source. Corners are counter-clockwise seen from outside.
// [anchor: zfail-facing]
bool facesLight(const dvec3& aMesh, const dvec3& bMesh, const dvec3& cMesh, const dvec4& lightMesh) {
    const dvec3 normalMesh = glm::cross(bMesh - aMesh, cMesh - aMesh); // N; its length does not change the sign
    const dvec3 toLightMesh = dvec3(lightMesh) - lightMesh.w * aMesh;  // L = P_L - P
    return glm::dot(normalMesh, toLightMesh) > 0;                      // N.L > 0: front facing
}

/// Two vertices, in the order in which they follow each other in the polygon that faces the light.
struct OutlineEdge {
    std::uint32_t a, b;
};

/// Determine object outlines with respect to light source. `facing`: of each polygon, does it face toward the light?
// [anchor: zfail-outline]
std::vector<OutlineEdge> outlineOf(const scene::MeshTopology& topology, const std::vector<bool>& facing) {
    std::vector<OutlineEdge> outline;
    for (const scene::Edge& edge : topology.edges) {
        // 1. Find the two polygon surfaces that share this edge. (At the border of an open mesh there is only one.)
        if (edge.useCount != 2) continue;
        const scene::EdgeUse& first = topology.uses[edge.firstUse];
        const scene::EdgeUse& second = topology.uses[edge.firstUse + 1];
        // 2. Determine the orientations of these two surfaces with respect to the light source.
        const bool firstFaces = facing[first.triangle], secondFaces = facing[second.triangle];
        // 3. If one is facing toward the light and the other is facing away from the light, this edge is an outline.
        if (firstFaces == secondFaces) continue;
        const bool fromAToB = (firstFaces ? first : second).direction > 0;
        outline.push_back(fromAToB ? OutlineEdge{edge.a, edge.b} : OutlineEdge{edge.b, edge.a});
    }
    return outline;
}

/// Extrude a point away from light source: P' = P + d (P - P_L) / |P - P_L|, with d in metres. For d = 0 it is extruded without
/// end: the direction P - P_L with w = 0 is the point at infinity.
// [anchor: zfail-extrude]
vec4 extruded(const dvec3& positionMesh, const dvec4& lightMesh, const dmat4& worldFromMesh, double distance) {
    const dvec3 awayMesh = lightMesh.w * positionMesh - dvec3(lightMesh); // P - P_L
    if (distance == 0) return vec4(awayMesh, 0);
    const double metres = glm::length(transformDirection(worldFromMesh, awayMesh)); // a mesh may be scaled
    return vec4(positionMesh + distance / metres * awayMesh, 1);
}

/// Triangles, three vertices each, in mesh space and homogeneous; counter-clockwise seen from outside of the volume.
struct Volume {
    std::size_t object;
    std::vector<vec4> topCap, bottomCap, sides;
};

/// Shadow volume generation algorithm.
// [anchor: zfail-volume]
Volume shadowVolume(const scene::Scene& scene, std::size_t object, const scene::MeshTopology& topology,
                    const scene::Light& light, double distance) {
    const scene::Mesh& mesh = *scene.objects[object].mesh;
    const dvec4 lightMesh = scene::lightMesh(scene.objects[object], light);
    const dmat4 worldFromMesh = scene::worldFromMesh(scene.objects[object]);
    const auto front = [&](std::uint32_t v) { return vec4(mesh.positionsMesh[v], 1); };
    const auto back = [&](std::uint32_t v) {
        return extruded(mesh.positionsMesh[v], lightMesh, worldFromMesh, distance);
    };
    std::vector<bool> facing;
    Volume volume{object, {}, {}, {}};
    for (const uvec3& t : mesh.triangles) {
        facing.push_back(
            facesLight(mesh.positionsMesh[t.x], mesh.positionsMesh[t.y], mesh.positionsMesh[t.z], lightMesh));
        if (facing.back()) // 1. All polygon surfaces that face toward the light source form the top cap.
            volume.topCap.insert(volume.topCap.end(), {front(t.x), front(t.y), front(t.z)});
        else // 2. Of those that face away, extrude the vertices; the new extruded polygons form the bottom cap.
            volume.bottomCap.insert(volume.bottomCap.end(), {back(t.x), back(t.y), back(t.z)});
    }
    // 3. Find all polygon edges that are outlines and extrude these into quadrilaterals: the side of the volume.
    for (const auto& [a, b] : outlineOf(topology, facing))
        volume.sides.insert(volume.sides.end(), {front(b), front(a), back(a), front(b), back(a), back(b)});
    return volume;
}

// --- Shadow volume using stencil buffer ---

class ZFail final : public Technique {
public:
    params::ParamList params() override {
        return {params::real({"extrusion", "Extrusion distance d"}, distance_, 0, 1000, "m", "0: to infinity.")};
    }

    /// Which polygons share which edges: found once for each mesh.
    Progress prepare(const scene::Snapshot& snapshot, Deadline) override {
        if (snapshot->revisions.geometry == prepared_) return {};
        topologies_.clear();
        for (const scene::Object& object : snapshot->objects)
            topologies_.try_emplace(object.mesh.get(), scene::buildTopology(*object.mesh));
        prepared_ = snapshot->revisions.geometry;
        return {};
    }

    // [anchor: zfail-passes]
    Progress render(Frame& frame) override {
        frame.pass(passInfo(kPasses, "lights-off"), [&] { scene_.lightsOff(frame); });        // step 1
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) { // step 8
            const std::vector<Volume> volumes = volumesOf(frame.scene(), light);
            const auto pass = [&](std::string_view id, const std::function<void()>& draw) {
                frame.pass(passInfo(kPasses, id), draw, light);
            };
            pass("clear-stencil", [&] { glClear(GL_STENCIL_BUFFER_BIT); });   // step 2
            pass("volumes-back", [&] { countFacesAway(frame, volumes); });    // steps 3 and 4
            pass("volumes-front", [&] { countFacesToward(frame, volumes); }); // step 5
            pass("light", [&] { scene_.lightOn(frame, light); });             // steps 6 and 7
            publishStages(frame, volumes, light);
        }
        return {};
    }

private:
    /// Left out is what shadows nothing, as a floor with nothing below it: scene::usefulCasters.
    std::vector<Volume> volumesOf(const scene::Scene& scene, int light) const {
        const scene::Light& source = scene.light(light);
        std::vector<Volume> volumes;
        for (const std::size_t caster : scene::usefulCasters(scene, source))
            volumes.push_back(
                shadowVolume(scene, caster, topologies_.at(scene.objects[caster].mesh.get()), source, distance_));
        return volumes;
    }

    // [anchor: zfail-count]
    void countFacesAway(const Frame& frame, const std::vector<Volume>& volumes) const { // step 4
        countFaces(frame, volumes, GL_FRONT, GL_INCR_WRAP);
    }
    void countFacesToward(const Frame& frame, const std::vector<Volume>& volumes) const { // step 5
        countFaces(frame, volumes, GL_BACK, GL_DECR_WRAP); // WRAP: 0 - 1 is 255, and 255 + 1 is 0 again
    }
    void countFaces(const Frame& frame, const std::vector<Volume>& volumes, GLenum culled, GLenum change) const {
        glEnable(GL_CULL_FACE);
        glCullFace(culled);
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_ALWAYS, 0, 0xff);
        glStencilOp(GL_KEEP, change, GL_KEEP); // where the stencil test fails, the depth test fails, both pass
        drawVolumes(frame, volumes);
        glDisable(GL_CULL_FACE);
    }

    // [anchor: zfail-draw]
    void drawVolumes(const Frame& frame, const std::vector<Volume>& volumes) const {
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); // step 3
        glDepthMask(GL_FALSE);
        for (const Volume& volume : volumes) {
            useFor(frame, volume.object, volume_);
            // The top cap has to have exactly the depths of the caster's surface, so that it fails the test LESS: no clamping yet.
            drawPoints(GL_TRIANGLES, volume.topCap);
            glEnable(GL_DEPTH_CLAMP); // keeps faces that lie beyond the far plane
            drawPoints(GL_TRIANGLES, volume.bottomCap);
            drawPoints(GL_TRIANGLES, volume.sides);
            glDisable(GL_DEPTH_CLAMP);
        }
        glFrontFace(GL_CCW);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE); // step 6
        glDepthMask(GL_TRUE);
    }

    static void useFor(const Frame& frame, std::size_t index, const gl::Program& program) {
        const scene::Object& object = frame.scene().objects[index];
        program.use();
        program.set("clipFromMesh", mat4(frame.eye().clipFromMesh(object)));
        glFrontFace(scene::isMirrored(object) ? GL_CW : GL_CCW);
    }

    // --- The pictures of the lecture ---

    void publishStages(Frame& frame, const std::vector<Volume>& volumes, int light) const {
        const auto countAway = [&] { countFacesAway(frame, volumes); };
        const auto countBoth = [&] {
            countAway();
            countFacesToward(frame, volumes);
        };
        scene_.publishStencil(frame, "stencil-back", light, countAway);
        scene_.publishStencil(frame, "stencil", light, countBoth);
        scene_.publishVisibility(frame, light, countBoth);
        if (!frame.wants("volume-parts", light)) return;
        const auto draw = [&] {
            setTransparentState();
            for (const Volume& volume : volumes) {
                useFor(frame, volume.object, shownVolume_);
                const auto part = [&](const std::vector<vec4>& homogeneousMesh, const vec3& color) {
                    shownVolume_.set("color", vec4(color / frame.scene().exposure, 0.3f));
                    drawPoints(GL_TRIANGLES, homogeneousMesh);
                };
                part(volume.bottomCap, look::kBottomCap);
                part(volume.sides, look::kVolumeSide);
                part(volume.topCap, look::kTopCap);
            }
        };
        const std::vector<KeyEntry> key = {
            {look::kTopCap, "top cap"}, {look::kVolumeSide, "side"}, {look::kBottomCap, "bottom cap"}};
        frame.drawOverTarget("volume-parts", light, true, draw, {.unit = "", .key = key});
    }

    double distance_ = 0;
    std::map<const scene::Mesh*, scene::MeshTopology> topologies_;
    std::uint64_t prepared_ = 0; // the revision of the geometry that they are of
    LitScene scene_;
    gl::Program volume_{"lecture/volume.vert", "nothing.frag"};
    gl::Program shownVolume_{"lecture/volume.vert", "constant.frag"};
};

} // namespace shadowlab::lecture::zfail

namespace shadowlab::lecture {

const TechniqueInfo& zFail() {
    using enum scene::LightType;
    static const TechniqueInfo info = {
        .id = "lecture-zfail",
        .title = "Lecture: z-fail shadow volume",
        .paper = "Crow 1977; Everitt and Kilgard 2002, Practical and Robust Stenciled Shadow Volumes",
        .getsWrong = "casters that are not closed; soft shadows (a light is a point)",
        .order = 140,
        .group = TechniqueGroup::lecture,
        .sister = "shadow-volume-zfail",
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(zfail::kPasses), std::end(zfail::kPasses)},
        .stages = {std::begin(zfail::kStages), std::end(zfail::kStages)},
        .pseudocode = zfail::kSteps,
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<zfail::ZFail>(); },
    };
    return info;
}

} // namespace shadowlab::lecture
