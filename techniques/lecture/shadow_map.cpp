// The shadow map.
//
// An object is in shadow if the light source does not see it. So the scene is rendered twice: first as the light sees it, of which only
// the depth is kept, the shadow map; then as the eye sees it. Each point that the eye sees is transformed into the light's coordinates.
// If the map holds a smaller depth there than the point's own, something nearer to the light is in the way.
//
// The map is an image: it knows one depth for all points that a texel covers. Therefore shadows have steps as wide as its texels, and
// a surface would shadow itself where the one depth is less than that of a point beside it; the bias prevents that.
//
// Lecture: "Shadow Map Method", "Shadow rendering procedure using shadow map", "procedure SHADOWMAPPING". Source: Williams, "Casting
// Curved Shadows on Curved Surfaces", 1978. Simplified: one map for each light, so a lamp amidst its casters sees only those on one
// side; the nearest texel decides alone; a light with an area is its centre.
// SPDX-License-Identifier: MIT
#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/frame.h"
#include "techniques/lecture/lecture.h"
#include "techniques/lecture/words/shadow_map.h"

namespace shadowlab::lecture::shadow_map {

// --- The light's point of view ---

/// A ball around all casters: what the map has to take in.
struct Ball {
    dvec3 centerWorld{0.0};
    double radius = 1;
};

Ball ballAround(const scene::Scene& scene, const std::vector<std::size_t>& casters) {
    scene::Bounds box;
    for (const std::size_t caster : casters)
        box.include(scene::boundsWorld(scene.objects[caster]));
    if (box.isEmpty()) return {};
    // A hundredth larger: what touches the border of the map has a texel beyond it.
    return {0.5 * (box.lowerWorld + box.upperWorld), 0.505 * glm::length(box.upperWorld - box.lowerWorld)};
}

/// The light's camera. In its clip space, x, y and z from -1 to 1 are what the map holds.
// [anchor: map-camera]
dmat4 lightClipFromWorld(const scene::Light& light, const Ball& ball) {
    const bool isParallel = light.type == scene::LightType::directional;
    const dvec3 toLightWorld =
        isParallel ? -light.directionWorld : glm::normalize(light.positionWorld - ball.centerWorld);
    // Any direction will do that the camera does not look along.
    const dvec3 upWorld = std::abs(toLightWorld.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
    const double radius = ball.radius;
    if (isParallel) // The rays of the sun are parallel: an orthographic camera that stands anywhere outside of the ball.
        return glm::ortho(-radius, radius, -radius, radius, radius, 3 * radius) *
               glm::lookAt(ball.centerWorld + 2 * radius * toLightWorld, ball.centerWorld, upWorld);
    // The rays of a lamp meet in it: a perspective camera there. A ray that touches the ball, the ball's radius at that place and the
    // line from lamp to centre form a right triangle: sin(half the field of view) = radius / distance. Inside the ball the sine would
    // exceed 1; 0.95 keeps the field of view below 2 * 72 degrees.
    const double distance = glm::length(light.positionWorld - ball.centerWorld);
    const double fieldOfView = 2 * std::asin(std::min(radius / distance, 0.95));
    // Depths are finest with the near plane as far out as the ball allows.
    const double near = std::max(distance - radius, 0.01 * radius);
    return glm::perspective(fieldOfView, 1.0, near, distance + radius) *
           glm::lookAt(light.positionWorld, ball.centerWorld, upWorld);
}

// --- The procedure ---

/// Depth map D of one light, and the camera that it was rendered with.
struct DepthMap {
    dmat4 lightClipFromWorld{1.0};
    gl::DepthTextureArray d; // one layer
};

class ShadowMap final : public Technique {
public:
    params::ParamList params() override {
        return {params::integer({"resolution", "Map resolution"}, resolution_, 64, 4096, "texels",
                                "Side of the square depth map."),
                params::real("bias", bias_, 0, 16, "texels",
                             "By how much depth may change across a surface before it shadows itself; 0: acne.")};
    }

    Progress render(Frame& frame) override {
        const int lights = static_cast<int>(frame.scene().lights.size());
        maps_.resize(static_cast<std::size_t>(lights));
        // Render z-buffer from each light's point of view to depth map D; store D as texture map d(u,v).
        for (int light = 0; light < lights; ++light)
            frame.pass(
                passInfo(kPasses, "depth"), [&] { renderDepthMap(frame, light); }, light);
        // Render scene S from the eye's point of view into image A.
        frame.pass(passInfo(kPasses, "lights-off"),
                   [&] { gl::drawLightsOff(lightsOff_, frame.scene(), frame.buffers(), frame.eye()); });
        // For each pixel with texture coords (u,v): if d(u,v) < z(u,v) then the pixel is shadowed, else it is lit.
        for (int light = 0; light < lights; ++light) {
            publishStages(frame, light);
            const auto addLight = [&] {
                glClear(GL_STENCIL_BUFFER_BIT);
                gl::setAddLightState();
                gl::useForLight(shade_, frame.scene(), frame.buffers(), frame.eye(), light);
                drawReceivers(frame, shade_, light);
            };
            frame.pass(passInfo(kPasses, "light"), addLight, light);
        }
        return {};
    }

private:
    // [anchor: map-render]
    void renderDepthMap(const Frame& frame, int light) {
        DepthMap& map = maps_[static_cast<std::size_t>(light)];
        if (map.d.side() != resolution_)
            map.d = gl::DepthTextureArray(GL_DEPTH_COMPONENT24, resolution_, 1, "depth map D");
        map.d.sample(gl::DepthSampling::depths);
        const gl::Framebuffer target(map.d, 0, "depth map D");
        target.bind();
        glDisable(GL_SCISSOR_TEST); // a part of the picture may need any part of the map
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_DEPTH_CLAMP); // what is nearer than the near plane casts a shadow, too
        drawCasters(frame, light, map);
    }

    // [anchor: map-casters]
    void drawCasters(const Frame& frame, int light, DepthMap& map) const {
        const scene::Scene& scene = frame.scene();
        const scene::Light& source = scene.light(light);
        const std::vector<std::size_t> casters = scene::usefulCasters(scene, source);
        map.lightClipFromWorld = lightClipFromWorld(source, ballAround(scene, casters));
        // The bias. The map holds the depth at a texel's centre; a point of the same surface lies up to half a texel away from it
        // in u and in v. Its depth differs by at most half of both slopes, which is no more than the larger slope: factor 1 of
        // glPolygonOffset, which multiplies just that. A texel on a curved surface may cover a second, steeper facet: factor 2.
        // The second number counts the smallest steps that a depth can differ by: two, for rounding.
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(static_cast<float>(bias_), bias_ > 0 ? 2.0f : 0.0f);
        for (const std::size_t caster : casters)
            gl::drawDepth(depth_, scene, frame.buffers(), caster,
                          map.lightClipFromWorld * scene::worldFromMesh(scene.objects[caster]));
    }

    /// The scene as the eye sees it, each point with its place in the light's clip space: shaders/lecture/shadow_map.glsl.
    // [anchor: map-receivers]
    void drawReceivers(const Frame& frame, const gl::Program& program, int light) const {
        const DepthMap& map = maps_[static_cast<std::size_t>(light)];
        map.d.bind(gl::kFirstFreeUnit);
        program.set("depthMap", gl::kFirstFreeUnit);
        gl::drawSurfaces(program, frame.scene(), frame.buffers(), frame.eye(), [&](const scene::Object& object) {
            program.set("lightClipFromMesh", mat4(map.lightClipFromWorld * scene::worldFromMesh(object)));
            return true;
        });
    }

    // --- The pictures of the lecture ---

    void publishStages(Frame& frame, int light) const {
        if (frame.wants("light-depth", light)) publishDepthMap(frame, light);
        const Display depths{.minimum = 0, .maximum = 1, .unit = "light's depth, from near to far plane", .key = {}};
        const Display comparison{.unit = "",
                                 .key = {{look::kEqualDepth, "d = z: seen by the light"},
                                         {look::kOccluded, "d < z: something nearer is in the way"}}};
        const auto publish = [&](std::string_view stage, int shown, GLenum format, const Display& display) {
            if (!frame.wants(stage, light)) return;
            const auto draw = [&] {
                glDepthFunc(GL_EQUAL);
                onView_.use();
                onView_.set("shown", shown);
                onView_.set("equalColor", look::kEqualDepth);
                onView_.set("shadowedColor", look::kOccluded);
                drawReceivers(frame, onView_, light);
            };
            frame.drawStage(stage, light, format, draw, display);
        };
        publish("depth-on-view", 0, GL_RG32F, depths);
        publish("distance-on-view", 1, GL_RG32F, depths);
        publish("comparison", 2, GL_RGBA16F, comparison);
        if (!frame.wants("visibility", light)) return;
        frame.drawStage("visibility", light, GL_RG32F, [&] {
            glClear(GL_STENCIL_BUFFER_BIT);
            gl::setVisibilityState();
            gl::useForLight(visibility_, frame.scene(), frame.buffers(), frame.eye(), light);
            drawReceivers(frame, visibility_, light);
        });
    }

    void publishDepthMap(Frame& frame, int light) const {
        const ivec2 size(frame.view().size.y); // a square as high as the view
        gl::Texture2D picture(GL_RG32F, size, "light-depth");
        const gl::Framebuffer target(&picture, nullptr, "light-depth");
        gl::setBaselineState();
        glDisable(GL_DEPTH_TEST);
        target.bind();
        shownMap_.use();
        shownMap_.set("size", vec2(size));
        shownMap_.set("depthMap", gl::kFirstFreeUnit);
        maps_[static_cast<std::size_t>(light)].d.bind(gl::kFirstFreeUnit);
        gl::drawFullscreenTriangle();
        frame.publish("light-depth", light, std::move(picture),
                      {.minimum = 0, .maximum = 1, .unit = "depth, from near to far plane", .key = {}});
    }

    int resolution_ = 2048;
    double bias_ = 2;
    std::vector<DepthMap> maps_; // one for each light
    const std::vector<gl::Substitution> map_{{"shadow_visibility.glsl", "lecture/shadow_map.glsl"}};
    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
    gl::Program depth_{"position.vert", "nothing.frag"};
    gl::Program shade_{"surface.vert", "shade_light.frag", {}, map_};
    gl::Program visibility_{"surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}, map_};
    gl::Program onView_{"surface.vert", "lecture/map_on_view.frag"};
    gl::Program shownMap_{"fullscreen.vert", "lecture/map.frag"};
};

} // namespace shadowlab::lecture::shadow_map

namespace shadowlab::lecture {

const TechniqueInfo& shadowMap() {
    using enum scene::LightType;
    using namespace shadow_map;
    static const TechniqueInfo info = {
        .id = "lecture-shadow-map",
        .title = "Lecture: shadow map",
        .paper = "Williams 1978, Casting Curved Shadows on Curved Surfaces",
        .getsWrong = "shadow edges, in steps as wide as its texels; lamps amidst their casters; soft shadows",
        .order = 120,
        .group = TechniqueGroup::lecture,
        .sister = "shadow-map",
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .pseudocode = kProcedure,
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<ShadowMap>(); },
    };
    return info;
}

} // namespace shadowlab::lecture
