// Planar shadows: the lecture's direct projection method.
//
// The shadow of an object on a plane is the object itself, projected onto the plane from the light source. The projection is a
// matrix: each object is drawn once more, flattened, and marks its shadow in the stencil buffer. Then the light is added where there is
// no mark. What is not flat is no projection plane, so it receives no shadow.
//
// Lecture: "Direct Projection Method". Source: Blinn, "Me and My (Fake) Shadow", 1988. Simplified: an object with more
// than 64 flat sides counts as curved; an object casts no shadow on itself; a light with an area is its centre.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/lecture/lecture.h"
#include "techniques/lecture/parts/lit_scene.h"
#include "techniques/lecture/words/planar.h"

namespace shadowlab::lecture::direct_projection {

// --- The projection ---

/// The matrix that takes a point P to its shadow P' on the plane N.P + D = 0, from the light source P_L.
///
/// P' lies on the line from the light through P, and in the plane:   P' = P_L + t (P - P_L),   N.P' + D = 0.
/// So t = (N.P_L + D) / ((N.P_L + D) - (N.P + D)), and with that     P' = ((N.P_L + D) P - (N.P + D) P_L) / w',
///                                                                   w' = (N.P_L + D) - (N.P + D).
/// Written for homogeneous points, with p = (N, D) and l = P_L, the numerator is (p.l) P - (p.P) l: linear in P, and so a matrix,
/// p.l times the identity less the matrix that takes P to (p.P) l. Its last row is w'. A light from a direction has l.w = 0.
// [anchor: projection-matrix]
dmat4 shadowFromView(const dvec4& planeView, const dvec4& lightView) {
    return glm::dot(planeView, lightView) * dmat4(1.0) - glm::outerProduct(lightView, planeView);
}

/// A flat part of an object: triangles that lie in one plane, a point A of it, and its normal N, in mesh space.
struct Plane {
    dvec3 pointMesh, normalMesh;
    std::vector<std::uint32_t> triangles;

    /// (N, D), so that N.P + D = 0 for every point P of the plane: D = -N.A.
    // [anchor: projection-equation]
    [[nodiscard]] dvec4 in(const dmat4& viewFromMesh) const {
        const dvec3 normalView = transformNormal(viewFromMesh, normalMesh);
        return dvec4(normalView, -glm::dot(normalView, transformPoint(viewFromMesh, pointMesh)));
    }
};

/// The projection planes of an object: its flat sides. What has more of them than a table with four legs counts as curved.
// [anchor: projection-plane]
std::vector<Plane> planesOf(const scene::Mesh& mesh) {
    constexpr std::size_t kMost = 64;
    std::vector<Plane> planes;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto corner = [&](int c) { return dvec3(mesh.positionsMesh[mesh.triangles[i][c]]); };
        const auto holds = [&](const Plane& plane) {
            for (int c = 0; c < 3; ++c) {
                const dvec3 fromPoint = corner(c) - plane.pointMesh;
                // A millionth of the distance is what the rounding of vertices to floats makes of a plane.
                if (std::abs(glm::dot(plane.normalMesh, fromPoint)) > 1e-6 * glm::length(fromPoint)) return false;
            }
            return true;
        };
        auto plane = std::ranges::find_if(planes, holds);
        if (plane == planes.end()) {
            if (planes.size() == kMost) return {};
            const dvec3 across = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
            plane = planes.insert(planes.end(), {corner(0), glm::normalize(across), {}});
        }
        plane->triangles.push_back(i);
    }
    return planes;
}

// --- The passes ---

// Bits of the stencil: the plane is seen in this pixel, and it is in shadow there.
constexpr GLuint kPlaneBit = 0x80, kShadowBit = 0x01;

/// A projection plane of an object and the light, both in view space; the light is above it: N.P_L + D > 0.
struct LitPlane {
    std::size_t object;
    std::vector<std::uint32_t> triangles;
    dvec4 planeView, lightView;
};

class Planar final : public Technique {
public:
    // [anchor: projection-passes]
    Progress render(Frame& frame) override {
        frame.pass(passInfo(kPasses, "lights-off"), [&] { scene_.lightsOff(frame); });
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
            scene_.publishVisibility(frame, light, [&] { markShadows(frame, light); });
            const auto pass = [&](std::string_view id, const std::function<void()>& draw) {
                frame.pass(passInfo(kPasses, id), draw, light);
            };
            pass("shadows", [&] { markShadows(frame, light); });
            pass("light", [&] { scene_.lightOn(frame, light); });
            publishFlattened(frame, light);
        }
        return {};
    }

private:
    void markShadows(const Frame& frame, int light) const {
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glDepthMask(GL_FALSE);
        projectObjects(frame, light, flatten_);
        glDepthMask(GL_TRUE);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }

    // [anchor: projection-mark]
    void projectObjects(const Frame& frame, int light, const gl::Program& program) const {
        glClear(GL_STENCIL_BUFFER_BIT);
        glEnable(GL_STENCIL_TEST);
        forEachPlane(frame, light, [&](const LitPlane& plane) {
            tagPlane(frame, plane);
            // A shadow ends where its plane does. The stencil test compares kPlaneBit alone (the mask): only pixels that show the
            // plane pass, and GL_REPLACE, set by tagPlane, writes kShadowBit there.
            glStencilFunc(GL_EQUAL, kPlaneBit | kShadowBit, kPlaneBit);
            glStencilMask(kShadowBit);
            drawFlattened(frame, plane, program);
            glStencilMask(kPlaneBit); // the next plane has this bit for itself
            glClear(GL_STENCIL_BUFFER_BIT);
            glStencilMask(0xff);
        });
        glEnable(GL_DEPTH_TEST);
    }

    /// Calls `draw` with each projection plane of each object.
    static void forEachPlane(const Frame& frame, int light, const std::function<void(const LitPlane&)>& draw) {
        const scene::Scene& scene = frame.scene();
        const dmat4& viewFromWorld = frame.eye().viewFromWorld;
        const dvec4 lightView =
            viewFromWorld * scene::homogeneousPositionWorld(scene.light(light));
        for (std::size_t object = 0; object < scene.objects.size(); ++object) {
            if (!scene.objects[object].receivesShadow) continue;
            for (const Plane& plane : planesOf(*scene.objects[object].mesh)) {
                const dvec4 planeView = plane.in(viewFromWorld * scene::worldFromMesh(scene.objects[object]));
                const double heightOfLight = glm::dot(planeView, lightView); // N.P_L + D
                const double heightOfEye = planeView.w;                      // in view space the eye is at the origin
                if (heightOfLight * heightOfEye <= 0) continue; // the side that is seen is turned away from the light
                draw({object, plane.triangles, heightOfLight > 0 ? planeView : -planeView, lightView});
            }
        }
    }

    /// Sets kPlaneBit in every pixel that shows the plane.
    // [anchor: projection-tag]
    void tagPlane(const Frame& frame, const LitPlane& plane) const {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_EQUAL);
        glStencilMask(kPlaneBit);
        glStencilFunc(GL_ALWAYS, kPlaneBit, kPlaneBit);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        plane_.use();
        plane_.set("clipFromMesh", mat4(frame.eye().clipFromMesh(frame.scene().objects[plane.object])));
        for (const std::uint32_t triangle : plane.triangles)
            gl::drawTriangles(frame.scene(), frame.buffers(), frame.eye(), plane.object, triangle, 1);
    }

    /// All casters but the plane's own object, flattened onto the plane.
    // [anchor: projection-draw]
    static void drawFlattened(const Frame& frame, const LitPlane& plane, const gl::Program& program) {
        program.use();
        // Flattened objects have the plane's own depth. A depth test would be decided by rounding, so it is off.
        glDisable(GL_DEPTH_TEST);
        // An object below the plane, N.P + D < 0, does not stand between light and plane: it is clipped away. So is, since
        // w' < 0, what lies above the light.
        glEnable(GL_CLIP_DISTANCE0);
        for (const std::size_t caster : scene::allCasters(frame.scene())) {
            if (caster == plane.object) continue;
            const scene::Object& object = frame.scene().objects[caster];
            const dmat4 viewFromMesh = frame.eye().viewFromWorld * scene::worldFromMesh(object);
            const dmat4 clipFromMesh =
                frame.eye().clipFromView * shadowFromView(plane.planeView, plane.lightView) * viewFromMesh;
            program.set("clipFromMesh", mat4(clipFromMesh));
            program.set("abovePlaneMesh", vec4(plane.planeView * viewFromMesh));
            frame.buffers().mesh(caster).draw(0, static_cast<std::uint32_t>(object.mesh->triangles.size()));
        }
        glDisable(GL_CLIP_DISTANCE0);
    }

    void publishFlattened(Frame& frame, int light) const {
        if (!frame.wants("flattened", light)) return;
        const auto draw = [&] {
            setTransparentState();
            shownFlattened_.use();
            shownFlattened_.set("color", vec4(look::kOccluded / frame.scene().exposure, 0.4f));
            projectObjects(frame, light, shownFlattened_);
        };
        frame.drawOverTarget("flattened", light, true, draw,
                             {.unit = "", .key = {{look::kOccluded, "projected object"}}});
    }

    LitScene scene_;
    gl::Program plane_{"position.vert", "constant.frag"}; // all zero: transparent where colours are written
    gl::Program flatten_{"lecture/project.vert", "nothing.frag"};
    gl::Program shownFlattened_{"lecture/project.vert", "constant.frag"};
};

} // namespace shadowlab::lecture::direct_projection

namespace shadowlab::lecture {

const TechniqueInfo& planar() {
    using enum scene::LightType;
    using namespace direct_projection;
    static const TechniqueInfo info = {
        .id = "lecture-planar",
        .title = "Lecture: direct projection",
        .paper = "Blinn 1988, Me and My (Fake) Shadow",
        .getsWrong = "shadows on curved objects, and on an object itself: there are none",
        .order = 110,
        .group = TechniqueGroup::lecture,
        .sister = "planar",
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .pseudocode = kSteps,
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<Planar>(); },
    };
    return info;
}

} // namespace shadowlab::lecture
