// Shadow volumes, counted behind the visible point (z-fail), with five blanks to be filled in.
//
// A shadow volume is the space that a caster hides from the light: its triangles that face the light (the top cap), the same at
// infinity (the bottom cap), and between them the extruded silhouette (the sides). On the way from a visible point to infinity,
// faces that leave a volume add one and faces that enter one take one: what is left is not zero inside.
//
// Sources: Crow, "Shadow Algorithms for Computer Graphics", 1977; Everitt and Kilgard, "Practical and Robust Stenciled Shadow
// Volumes", 2002. Simplified: an open mesh casts where its front faces the light; casters with holes cast as if they had none;
// volumes are built anew for each picture; a light with an area is its centre.
#include <map>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/foundation/scene/query/facing.h"
#include "techniques/frame.h"

namespace shadowlab::my_shadows {

namespace {

const PassInfo kPasses[] = {
    {.id = "lights-off",
     .title = "Render the scene with all light sources turned off",
     .why = "Emission and ambient light are counted once; the depth buffer now holds the visible point of every pixel.",
     .glState = "depth test LESS, depth write on"},
    {.id = "volumes",
     .title = "Count the volume faces behind each visible point",
     .why = "Where a face fails the depth test it lies behind the point.",
     .glState = "colour and depth writes off, depth LESS, depth clamp, stencil counts where the depth test fails",
     .perLight = true},
    {.id = "light",
     .title = "Add the light where the stencil is zero",
     .why = "As many faces entered as left: the point is outside every volume.",
     .glState = "depth EQUAL, stencil EQUAL 0, blending ONE ONE",
     .perLight = true},
};

const StageInfo kStages[] = {{"visibility", "Visibility of the light", StageKind::visibility, true}};

/// Does the triangle's front face the light? Corners are counter-clockwise seen from the front. The light is homogeneous: w = 1 and
/// its place, or w = 0 and the direction toward it.
bool facesLight(const dvec3& a, const dvec3& b, const dvec3& c, const dvec4& light) {
    // === BLANK 1: N.L > 0. N is the triangle's normal, glm::cross of two edges; L leads from a corner to the light, which for both
    // kinds of light is light.xyz - light.w * corner. As it is, nothing faces the light, and there are no volumes. When it is
    // right, the caps are made of the lit side of each caster.
    (void)a, (void)b, (void)c, (void)light;
    return false;
    // === END OF BLANK 1
}

/// Index lists over 2 n vertices: v is vertex v of the mesh, and v + n the same, pushed to infinity.
struct Volume {
    std::vector<std::uint32_t> topCap, sides, bottomCap; // counter-clockwise seen from outside
};

Volume buildVolume(const scene::Mesh& mesh, const scene::MeshTopology& topology, const dvec4& lightMesh) {
    const auto far = static_cast<std::uint32_t>(mesh.positionsMesh.size());
    Volume volume;
    std::vector<bool> isFacing;
    for (const uvec3& corners : mesh.triangles) {
        const auto corner = [&](int i) { return dvec3(mesh.positionsMesh[corners[i]]); };
        isFacing.push_back(facesLight(corner(0), corner(1), corner(2), lightMesh));
        if (!isFacing.back()) continue;
        volume.topCap.insert(volume.topCap.end(), {corners.x, corners.y, corners.z});
        // Seen from the other side: the other way around.
        volume.bottomCap.insert(volume.bottomCap.end(), {corners.x + far, corners.z + far, corners.y + far});
    }
    for (const scene::Edge& edge : topology.edges) {
        // +1 if the side of the volume hangs on a triangle in which the edge runs from a to b, -1 if from b to a, 0: no side.
        int side = 0;
        for (std::uint32_t i = 0; i < edge.useCount; ++i) {
            const scene::EdgeUse& use = topology.uses[edge.firstUse + i];
            // === BLANK 2: the silhouette. An edge belongs to it if one of its triangles faces the light and the other does not. Here
            // each triangle at the edge has its turn: use.triangle is its index, use.direction is +1 or -1 as above. In a closed
            // mesh the directions of the two are opposite, so that those of two facing triangles cancel. When it is right, the
            // shadow of a ball is round, and its volume has no walls inside.
            (void)use;
            // === END OF BLANK 2
        }
        if (side == 0) continue;
        const std::uint32_t a = side > 0 ? edge.a : edge.b, b = side > 0 ? edge.b : edge.a;
        volume.sides.insert(volume.sides.end(), {b, a, a + far, b, a + far, b + far});
    }
    return volume;
}

class MyShadows final : public Technique {
public:
    /// Which triangles meet at which edges: found once for each mesh.
    Progress prepare(const scene::Snapshot& snapshot, Deadline) override {
        if (snapshot->revisions.geometry == prepared_) return {};
        topologies_.clear();
        for (const scene::Object& object : snapshot->objects)
            if (object.castsShadow && !topologies_.contains(object.mesh.get()))
                topologies_.emplace(object.mesh.get(), scene::buildTopology(*object.mesh));
        prepared_ = snapshot->revisions.geometry;
        return {};
    }

    Progress render(Frame& frame) override {
        frame.pass(passInfo(kPasses, "lights-off"),
                   [&] { gl::drawLightsOff(lightsOff_, frame.scene(), frame.buffers(), frame.eye()); });
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
            if (frame.wants("visibility", light))
                frame.drawStage("visibility", light, GL_RG32F, [&] {
                    countVolumes(frame, light);
                    drawAllAsDark(frame);
                    gl::setVisibilityState();
                    drawLit(frame, visibility_, light);
                });
            frame.pass(
                passInfo(kPasses, "volumes"), [&] { countVolumes(frame, light); }, light);
            frame.pass(
                passInfo(kPasses, "light"),
                [&] {
                    gl::setAddLightState();
                    drawLit(frame, shade_, light);
                },
                light);
        }
        return {};
    }

private:
    void countVolumes(const Frame& frame, int light) const {
        const scene::Scene& scene = frame.scene();
        const scene::Light& source = scene.lights[static_cast<std::size_t>(light)];
        glClear(GL_STENCIL_BUFFER_BIT);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glDepthMask(GL_FALSE);
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_ALWAYS, 0, 0xff);
        // === BLANK 3: the count. glStencilOpSeparate(GL_FRONT or GL_BACK, stencil fails, depth fails, depth passes) says what
        // becomes of the stencil. Z-fail counts faces behind the point: those that face away from the eye, where one leaves a
        // volume, add one; those that face the eye take one. It may go below zero on the way: GL_INCR_WRAP and GL_DECR_WRAP.
        // When it is right, the scene also has its shadows where the eye itself is in one.
        glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_KEEP);
        glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_KEEP);
        // === END OF BLANK 3
        for (const std::size_t caster : scene::usefulCasters(scene, source)) {
            const scene::Object& object = scene.objects[caster];
            const dvec4 lightMesh = scene::lightMesh(object, source);
            const Volume volume = buildVolume(*object.mesh, topologies_.at(object.mesh.get()), lightMesh);
            glFrontFace(scene::isMirrored(object) ? GL_CW : GL_CCW);
            const Buffers buffers(*object.mesh);

            // Sides and bottom cap reach infinity. Their depth is clamped there, or the far plane would cut the volume open.
            extrude_.use();
            extrude_.set("clipFromMesh", mat4(frame.eye().clipFromMesh(object)));
            extrude_.set("lightMesh", vec4(lightMesh));
            glEnable(GL_DEPTH_CLAMP);
            buffers.draw(volume.sides);
            // === BLANK 4: the bottom cap. Z-fail looks from the point to infinity, and a volume that is open there is left without
            // having been counted. buffers.draw(volume.bottomCap) closes it. When it is right, shadows do not depend on where the
            // eye looks.
            // === END OF BLANK 4
            glDisable(GL_DEPTH_CLAMP);

            // The top cap lies on the caster's own surface: drawn by the same expression, it has the same depths, and fails LESS.
            cap_.use();
            cap_.set("clipFromMesh", mat4(frame.eye().clipFromMesh(object)));
            buffers.draw(volume.topCap);
        }
        gl::setBaselineState();
    }

    /// The 2 n vertices of a mesh; an index list is drawn as triangles.
    class Buffers {
    public:
        explicit Buffers(const scene::Mesh& mesh) {
            std::vector<vec4> vertices; // position, and whether it is pushed
            for (const float extrudable : {0.0f, 1.0f})
                for (const vec3& positionMesh : mesh.positionsMesh)
                    vertices.emplace_back(positionMesh, extrudable);
            vertices_ = gl::uploadBuffer(GL_ARRAY_BUFFER, vertices);
        }
        void draw(const std::vector<std::uint32_t>& indices) const {
            if (indices.empty()) return;
            const gl::VertexArrayHandle array = gl::VertexArrayHandle::create();
            glBindVertexArray(array.id());
            glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
            glEnableVertexAttribArray(gl::kPositionMesh);
            glVertexAttribPointer(gl::kPositionMesh, 3, GL_FLOAT, GL_FALSE, sizeof(vec4), nullptr);
            glEnableVertexAttribArray(gl::kExtrudable);
            glVertexAttribPointer(gl::kExtrudable, 1, GL_FLOAT, GL_FALSE, sizeof(vec4),
                                  reinterpret_cast<const void*>(sizeof(vec3)));
            const gl::BufferHandle elements = gl::uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
            glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
            glBindVertexArray(0);
        }

    private:
        gl::BufferHandle vertices_;
    };

    /// Of a visibility picture: every surface, as if no light reached it.
    void drawAllAsDark(const Frame& frame) const {
        glDepthFunc(GL_EQUAL);
        glDepthMask(GL_FALSE);
        glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE); // green: there is a surface
        visibility_.use();
        gl::drawSurfaces(visibility_, frame.scene(), frame.buffers(), frame.eye());
        gl::setBaselineState();
    }

    static void drawLit(const Frame& frame, const gl::Program& program, int light) {
        gl::useForLight(program, frame.scene(), frame.buffers(), frame.eye(), light);
        gl::drawSurfaces(program, frame.scene(), frame.buffers(), frame.eye());
    }

    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
    gl::Program shade_{"surface.vert", "shade_light.frag"};
    gl::Program visibility_{"surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}};
    gl::Program extrude_{"my_shadows/extrude.vert", "nothing.frag"};
    gl::Program cap_{"position.vert", "nothing.frag"};
    std::map<const scene::Mesh*, scene::MeshTopology> topologies_;
    std::uint64_t prepared_ = 0; // revision of the geometry that they are of; no scene has 0
};

} // namespace

std::span<const TechniqueInfo> techniques() {
    using enum scene::LightType;
    static const TechniqueInfo info[] = {{
        .id = "my-shadows",
        .title = "My shadows",
        .paper = "Crow 1977; Everitt and Kilgard 2002, Practical and Robust Stenciled Shadow Volumes",
        .getsWrong = "open meshes that turn their back to the light; soft shadows",
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<MyShadows>(); },
    }};
    return info;
}

} // namespace shadowlab::my_shadows
