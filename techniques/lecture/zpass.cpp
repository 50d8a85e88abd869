// Shadow volumes, counted between the view point and the visible point: z-pass.
//
// The silhouette of an object, seen from the light source, is extended away from the light to a semi-infinite volume: the region
// that the object shadows. The line segment from the view point to a visible point crosses n_f front facing and n_b back facing
// faces of such volumes. Each front face leads into shadow, each back face out of it; if n_f = n_b the point is illuminated.
//
// The count starts at zero, as if the view point were outside of every volume. Where the view point is itself in shadow, the face by
// which its volume was entered is never crossed, and the result is wrong, often reversed: lit where it is dark. Z-fail corrects that.
//
// Lecture: "Z-Pass Shadow Volume Algorithm", "Shadow Volume Algorithm", "Silhouettes". Sources: Crow, "Shadow Algorithms for Computer
// Graphics", 1977; Heidmann, "Real Shadows, Real Time", 1991. Simplified: holes of casters are filled; a light with an area is its
// centre; all volumes are built anew for each picture.
// SPDX-License-Identifier: MIT
#include <map>

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/scene/query/facing.h"
#include "techniques/lecture/lecture.h"
#include "techniques/lecture/parts/lit_scene.h"
#include "techniques/lecture/words/zpass.h"

namespace shadowlab::lecture::zpass {

// --- For each object and light source compute the silhouette (and boundary if open) from the light source's viewpoint ---

/// For each polygon: is it front-facing, seen from the light? All in mesh space; the light is homogeneous, w = 0 for the sun.
// [anchor: zpass-facing]
std::vector<bool> frontFacing(const scene::Mesh& mesh, const dvec4& lightMesh) {
    std::vector<bool> front;
    for (const uvec3& triangle : mesh.triangles) {
        const dvec3 a(mesh.positionsMesh[triangle.x]), b(mesh.positionsMesh[triangle.y]),
            c(mesh.positionsMesh[triangle.z]);
        const dvec3 normalMesh = glm::cross(b - a, c - a);
        front.push_back(glm::dot(normalMesh, dvec3(lightMesh) - lightMesh.w * a) > 0); // N.L > 0
    }
    return front;
}

/// The edges between front-facing polygons and back-facing polygons, and the border of an open mesh: two vertices each, in the
/// order that a front-facing polygon has them.
// [anchor: zpass-silhouette]
std::vector<std::pair<std::uint32_t, std::uint32_t>> silhouette(const scene::MeshTopology& topology,
                                                                const std::vector<bool>& front) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const scene::Edge& edge : topology.edges) {
        const scene::EdgeUse& first = topology.uses[edge.firstUse];
        const bool isBoundary = edge.useCount == 1;
        const bool isSilhouette =
            edge.useCount == 2 && front[first.triangle] != front[topology.uses[edge.firstUse + 1].triangle];
        if (!isBoundary && !isSilhouette) continue;
        // The first polygon runs from a to b if its direction is positive. A back-facing one has the edge the other way around.
        if ((first.direction > 0) == front[first.triangle])
            edges.emplace_back(edge.a, edge.b);
        else
            edges.emplace_back(edge.b, edge.a);
    }
    return edges;
}

// --- Extend each silhouette (and boundary) to form a semi-infinite volume ---

/// Homogeneous points in mesh space. The sides are triangles, counter-clockwise seen from outside of the volume.
struct Volume {
    std::size_t object;
    std::vector<vec4> silhouette, sides;
};

/// The volume has sides only. The cap at its top is the object's own surface: no visible point lies behind it, so no line segment from
/// the view point crosses it. The cap at its bottom is at infinity, and the segment ends at the visible point.
// [anchor: zpass-sides]
Volume semiInfiniteVolume(const scene::Scene& scene, std::size_t object, const scene::MeshTopology& topology,
                          const scene::Light& light) {
    const scene::Mesh& mesh = *scene.objects[object].mesh;
    const dvec4 lightMesh = scene::lightMesh(scene.objects[object], light);
    const auto near = [&](std::uint32_t v) { return vec4(mesh.positionsMesh[v], 1); };
    // The direction away from the light, P - P_L, with w = 0: the point at infinity.
    const auto far = [&](std::uint32_t v) {
        return vec4(lightMesh.w * dvec3(mesh.positionsMesh[v]) - dvec3(lightMesh), 0);
    };
    Volume volume{object, {}, {}};
    for (const auto& [a, b] : silhouette(topology, frontFacing(mesh, lightMesh))) {
        volume.silhouette.insert(volume.silhouette.end(), {near(a), near(b)});
        volume.sides.insert(volume.sides.end(), {near(b), near(a), far(a), near(b), far(a), far(b)});
    }
    return volume;
}

// --- Count the front facing and back facing faces between view point and visible point ---

class ZPass final : public Technique {
public:
    /// Which polygons share which edges: found once for each mesh.
    Progress prepare(const scene::Snapshot& snapshot, Deadline) override {
        if (snapshot->revisions.geometry == prepared_) return {};
        topologies_.clear();
        for (const scene::Object& object : snapshot->objects)
            topologies_.try_emplace(object.mesh.get(), scene::buildTopology(*object.mesh));
        prepared_ = snapshot->revisions.geometry;
        return {};
    }

    // [anchor: zpass-passes]
    Progress render(Frame& frame) override {
        // Faces before the near plane are cut off and not counted. The camera's own near plane lies nearer to the eye than the
        // one that is fitted to the scene for finer depths, so it cuts off fewer.
        frame.useNearPlaneOfView();
        frame.pass(passInfo(kPasses, "lights-off"), [&] { scene_.lightsOff(frame); });
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
            const std::vector<Volume> volumes = volumesOf(frame.scene(), light);
            const auto pass = [&](std::string_view id, const std::function<void()>& draw) {
                frame.pass(passInfo(kPasses, id), draw, light);
            };
            pass("clear-stencil", [&] { glClear(GL_STENCIL_BUFFER_BIT); });
            pass("volumes-front", [&] { countFrontFaces(frame, volumes); });
            pass("volumes-back", [&] { countBackFaces(frame, volumes); });
            pass("light", [&] { scene_.lightOn(frame, light); });
            publishStages(frame, volumes, light);
        }
        return {};
    }

private:
    std::vector<Volume> volumesOf(const scene::Scene& scene, int light) const {
        std::vector<Volume> volumes;
        for (std::size_t object = 0; object < scene.objects.size(); ++object)
            if (scene.objects[object].castsShadow)
                volumes.push_back(semiInfiniteVolume(scene, object, topologies_.at(scene.objects[object].mesh.get()),
                                                     scene.light(light)));
        return volumes;
    }

    // [anchor: zpass-count]
    void countFrontFaces(const Frame& frame, const std::vector<Volume>& volumes) const { // n_f: into shadow
        countFaces(frame, volumes, GL_BACK, GL_INCR_WRAP);
    }
    void countBackFaces(const Frame& frame, const std::vector<Volume>& volumes) const { // n_b: out of it
        countFaces(frame, volumes, GL_FRONT, GL_DECR_WRAP);
    }
    void countFaces(const Frame& frame, const std::vector<Volume>& volumes, GLenum culled, GLenum change) const {
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); // fully transparent polygons: they only count
        glDepthMask(GL_FALSE);
        glEnable(GL_CULL_FACE);
        glCullFace(culled);
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_ALWAYS, 0, 0xff);
        // What becomes of the stencil where the stencil test fails, the depth test fails, both pass. WRAP: 0 - 1 is 255, and
        // 255 + 1 is 0 again, so that the order in which faces are counted does not matter.
        glStencilOp(GL_KEEP, GL_KEEP, change);
        volume_.use();
        drawSides(frame, volumes, volume_);
        glDisable(GL_CULL_FACE);
        glDepthMask(GL_TRUE);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }

    // [anchor: zpass-draw]
    static void drawSides(const Frame& frame, const std::vector<Volume>& volumes, const gl::Program& program) {
        for (const Volume& volume : volumes) {
            const scene::Object& object = frame.scene().objects[volume.object];
            glFrontFace(scene::isMirrored(object) ? GL_CW : GL_CCW);
            program.set("clipFromMesh", mat4(frame.eye().clipFromMesh(object)));
            drawPoints(GL_TRIANGLES, volume.sides);
        }
        glFrontFace(GL_CCW);
    }

    // --- The pictures of the lecture ---

    void publishStages(Frame& frame, const std::vector<Volume>& volumes, int light) const {
        const auto countFront = [&] { countFrontFaces(frame, volumes); };
        const auto countBoth = [&] {
            countFront();
            countBackFaces(frame, volumes);
        };
        scene_.publishStencil(frame, "stencil-front", light, countFront);
        scene_.publishStencil(frame, "stencil", light, countBoth);
        scene_.publishVisibility(frame, light, countBoth);
        const auto setColor = [&](const vec3& color, float alpha) {
            shownVolume_.set("color", vec4(color / frame.scene().exposure, alpha));
        };
        const vec3 plus = look::diverging()[6], minus = look::diverging()[2];
        const auto drawSigns = [&] {
            setTransparentState();
            glEnable(GL_CULL_FACE);
            shownVolume_.use();
            for (const GLenum culled : {GL_FRONT, GL_BACK}) {
                glCullFace(culled);
                setColor(culled == GL_BACK ? plus : minus, 0.3f);
                drawSides(frame, volumes, shownVolume_);
            }
        };
        const auto drawSilhouettes = [&] {
            glDisable(GL_DEPTH_TEST); // those behind the objects, too
            shownVolume_.use();
            setColor(look::kSilhouette, 1);
            for (const Volume& volume : volumes) {
                shownVolume_.set("clipFromMesh", mat4(frame.eye().clipFromMesh(frame.scene().objects[volume.object])));
                drawPoints(GL_LINES, volume.silhouette);
            }
        };
        if (frame.wants("volume-signs", light))
            frame.drawOverTarget("volume-signs", light, true, drawSigns,
                                 {.unit = "", .key = {{plus, "front face: +1"}, {minus, "back face: -1"}}});
        if (frame.wants("silhouettes", light))
            frame.drawOverTarget("silhouettes", light, true, drawSilhouettes,
                                 {.unit = "", .key = {{look::kSilhouette, "silhouette or boundary edge"}}});
    }

    std::map<const scene::Mesh*, scene::MeshTopology> topologies_;
    std::uint64_t prepared_ = 0; // the revision of the geometry that they are of
    LitScene scene_;
    gl::Program volume_{"lecture/volume.vert", "nothing.frag"};
    gl::Program shownVolume_{"lecture/volume.vert", "constant.frag"};
};

} // namespace shadowlab::lecture::zpass

namespace shadowlab::lecture {

const TechniqueInfo& zPass() {
    using enum scene::LightType;
    static const TechniqueInfo info = {
        .id = "lecture-zpass",
        .title = "Lecture: z-pass shadow volume",
        .paper = "Crow 1977, Shadow Algorithms for Computer Graphics; Heidmann 1991, Real Shadows, Real Time",
        .getsWrong = "any pixel, when the view point is in shadow or the near plane cuts a volume; soft shadows",
        .order = 130,
        .group = TechniqueGroup::lecture,
        .sister = "shadow-volume-zpass",
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(zpass::kPasses), std::end(zpass::kPasses)},
        .stages = {std::begin(zpass::kStages), std::end(zpass::kStages)},
        .pseudocode = zpass::kSteps,
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<zpass::ZPass>(); },
    };
    return info;
}

} // namespace shadowlab::lecture
