// Planar projected shadows, with three blanks to be filled in.
//
// The shadow of a caster on a plane is the caster itself, flattened onto the plane by a matrix that projects from the light. For
// each plane: its pixels are tagged in the stencil buffer, the flattened casters are drawn and marked there, and then the light
// is added where there is no mark.
//
// Source: Blinn, "Me and My (Fake) Shadow", 1988. Simplified: only objects that are flat as a whole receive shadows; casters with
// holes cast as if they had none; a light with an area is its centre.
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/frame.h"

namespace shadowlab::my_shadows {

namespace {

const PassInfo kPasses[] = {
    {.id = "lights-off",
     .title = "Render the scene with all light sources turned off",
     .why = "Emission and ambient light are counted once; the depth buffer now holds the visible point of every pixel.",
     .glState = "depth test LESS, depth write on"},
    {.id = "shadows",
     .title = "Flatten all casters onto every receiver, and mark where they fall",
     .why = "The projection matrix takes each vertex to the plane, along the line from the light.",
     .glState = "stencil: bit 7 is the tag of the receiver, bit 0 the mark of a shadow; depth test off",
     .perLight = true},
    {.id = "light",
     .title = "Add the light where there is no mark",
     .why = "What is not marked sees the light.",
     .glState = "depth EQUAL, stencil EQUAL 0, blending ONE ONE",
     .perLight = true},
};

const StageInfo kStages[] = {{"visibility", "Visibility of the light", StageKind::visibility, true}};

constexpr GLuint kTagBit = 0x80, kMarkBit = 0x01;

/// (N, D) of the plane that the object's triangles lie in, in view space: N.P + D = 0 for every point P of it. Nothing for an object
/// that is not flat.
std::optional<dvec4> planeOf(const scene::Object& object, const dmat4& viewFromWorld) {
    const scene::Mesh& mesh = *object.mesh;
    if (mesh.triangles.empty()) return std::nullopt;
    const uvec3 first = mesh.triangles.front();
    const dvec3 a(mesh.positionsMesh[first.x]), b(mesh.positionsMesh[first.y]), c(mesh.positionsMesh[first.z]);
    const dvec3 normalMesh = glm::normalize(glm::cross(b - a, c - a));
    for (const vec3& positionMesh : mesh.positionsMesh)
        // A millionth of the distance: what the rounding of vertices to floats makes of a plane.
        if (std::abs(glm::dot(normalMesh, dvec3(positionMesh) - a)) > 1e-6 * glm::length(dvec3(positionMesh) - a))
            return std::nullopt;
    const dmat4 viewFromMesh = viewFromWorld * scene::worldFromMesh(object);
    const dvec3 normalView = transformNormal(viewFromMesh, normalMesh);
    return dvec4(normalView, -glm::dot(normalView, transformPoint(viewFromMesh, a)));
}

/// The matrix that takes a point, in view space and homogeneous, to its shadow on the plane.
///
/// planeView is p = (N, D), and p.l > 0: the light is above it. lightView is l: w = 1 for a light with a place, and 0 for one from a
/// direction.
dmat4 shadowFromView(const dvec4& planeView, const dvec4& lightView) {
    // === BLANK 1: the projection matrix. The lecture derives where the line from the light through a point meets the plane;
    // written for homogeneous points this is linear, and so a matrix: v' = (p.l) v - (p.v) l. glm::outerProduct(l, p) is the
    // matrix that takes v to (p.v) l. As it is, every point stays where it is. When it is right, every caster has a shadow.
    (void)planeView;
    (void)lightView;
    return dmat4(1.0);
    // === END OF BLANK 1
}

class MyShadows final : public Technique {
public:
    Progress render(Frame& frame) override {
        frame.pass(passInfo(kPasses, "lights-off"),
                   [&] { gl::drawLightsOff(lightsOff_, frame.scene(), frame.buffers(), frame.eye()); });
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
            if (frame.wants("visibility", light))
                frame.drawStage("visibility", light, GL_RG32F, [&] {
                    markShadows(frame, light);
                    drawAllAsDark(frame);
                    gl::setVisibilityState();
                    drawLit(frame, visibility_, light);
                });
            frame.pass(
                passInfo(kPasses, "shadows"), [&] { markShadows(frame, light); }, light);
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
    void markShadows(const Frame& frame, int light) const {
        const scene::Scene& scene = frame.scene();
        const dvec4 lightView =
            frame.eye().viewFromWorld * scene::homogeneousPositionWorld(scene.lights[static_cast<std::size_t>(light)]);
        glClear(GL_STENCIL_BUFFER_BIT);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glDepthMask(GL_FALSE);
        glEnable(GL_STENCIL_TEST);
        for (std::size_t receiver = 0; receiver < scene.objects.size(); ++receiver) {
            std::optional<dvec4> planeView = planeOf(scene.objects[receiver], frame.eye().viewFromWorld);
            if (!planeView || !scene.objects[receiver].receivesShadow) continue;
            // Turned to the side that the light is on. A light in the plane does not shine on it.
            const double height = glm::dot(*planeView, lightView);
            if (std::abs(height) < 1e-9) continue;
            if (height < 0) planeView = -*planeView;
            tag(frame, receiver);
            for (const std::size_t caster : scene::allCasters(scene))
                if (caster != receiver) markShadowOf(frame, caster, *planeView, lightView);
            glStencilMask(kTagBit); // the next receiver has the tag for itself
            glClear(GL_STENCIL_BUFFER_BIT);
        }
        gl::setBaselineState();
    }

    /// Sets the tag in every pixel that shows the receiver.
    void tag(const Frame& frame, std::size_t receiver) const {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_EQUAL);
        glStencilMask(kTagBit);
        glStencilFunc(GL_ALWAYS, kTagBit, kTagBit);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        receiver_.use();
        gl::drawSurface(receiver_, frame.scene(), frame.buffers(), frame.eye(), receiver);
    }

    void markShadowOf(const Frame& frame, std::size_t caster, const dvec4& planeView, const dvec4& lightView) const {
        // The flattened caster lies in the plane: which of the two is nearer would be a matter of rounding.
        glDisable(GL_DEPTH_TEST);
        glStencilMask(kMarkBit);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        // === BLANK 2: the receiver's border. A shadow ends where its receiver does. As it is, it is drawn all over the plane that
        // the receiver lies in. glStencilFunc(GL_EQUAL, REFERENCE, MASK) lets a pixel pass where its stencil and REFERENCE are
        // equal in the bits of MASK; what REPLACE writes is REFERENCE. When it is right, no shadow spills over a table's edge.
        glStencilFunc(GL_ALWAYS, kMarkBit, kTagBit);
        // === END OF BLANK 2

        // Above the light, the line from the light through a point leads away from the plane: the weight of its shadow, w' = p.l - l.w
        // (p.v), is negative there, and nothing with a negative weight is ever drawn. That goes well as long as nobody divides by it.
        dvec4 abovePlane(0, 0, 0,
                         1); // a row, times a point of the caster in view space; what is negative is clipped away
        // === BLANK 3: below the plane. What lies there, p.v < 0, is not between the light and the plane, and still has a place in it:
        // clip by p.v. As it is, nothing is clipped. When it is right, a ball that is half sunk into the floor has no shadow on the
        // side of the light.
        // === END OF BLANK 3

        const dmat4 viewFromMesh = frame.eye().viewFromWorld * scene::worldFromMesh(frame.scene().objects[caster]);
        flatten_.use();
        flatten_.set("clipFromMesh",
                     mat4(frame.eye().clipFromView * shadowFromView(planeView, lightView) * viewFromMesh));
        flatten_.set("abovePlane", vec4(abovePlane * viewFromMesh));
        glEnable(GL_CLIP_DISTANCE0);
        const std::size_t triangles = frame.scene().objects[caster].mesh->triangles.size();
        frame.buffers().mesh(caster).draw(0, static_cast<std::uint32_t>(triangles));
        glDisable(GL_CLIP_DISTANCE0);
    }

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
    gl::Program receiver_{"position.vert", "nothing.frag"};
    gl::Program flatten_{"my_shadows/flatten.vert", "nothing.frag"};
};

} // namespace

std::span<const TechniqueInfo> techniques() {
    using enum scene::LightType;
    static const TechniqueInfo info[] = {{
        .id = "my-shadows",
        .title = "My shadows",
        .paper = "Blinn 1988, Me and My (Fake) Shadow",
        .getsWrong = "shadows on curved surfaces: there are none",
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<MyShadows>(); },
    }};
    return info;
}

} // namespace shadowlab::my_shadows
