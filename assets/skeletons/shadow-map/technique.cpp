// A shadow map, with five blanks to be filled in.
//
// The scene is drawn twice. First as the light sees it, depths alone: the map. Then as the eye sees it: each visible point is taken
// to where the light saw it, and is lit if the light saw nothing nearer there.
//
// Source: Williams, "Casting Curved Shadows on Curved Surfaces", 1978. Simplified: one map, so the
// casters have to be on one side of the light; one comparison for each pixel; a light with an area is its centre.
#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/frame.h"

namespace shadowlab::my_shadows {

namespace {

const PassInfo kPasses[] = {
    {.id = "map",
     .title = "Render the scene as the light sees it",
     .why = "The map keeps the depth of the first surface on the way of each ray of light.",
     .glState = "depth test LESS, depth write on, no colour",
     .perLight = true},
    {.id = "lights-off",
     .title = "Render the scene with all light sources turned off",
     .why = "Emission and ambient light are counted once; the depth buffer now holds the visible point of every pixel.",
     .glState = "depth test LESS, depth write on"},
    {.id = "light",
     .title = "Add the light where it sees the point",
     .why = "The point's own depth, as seen from the light, is compared with the one in the map.",
     .glState = "depth EQUAL, blending ONE ONE, stencil lets each pixel be lit once",
     .perLight = true},
};

const StageInfo kStages[] = {{"visibility", "Visibility of the light", StageKind::visibility, true}};

/// The ball around what casts shadows, which the map has to take in.
struct Ball {
    dvec3 centerWorld{0.0};
    double radius = 1;
};

/// Left out is what a lamp stands beside so closely that it would have to look to all sides, a wall or a table: of their shadows only
/// what falls into the map is seen.
Ball ballAround(const scene::Scene& scene, const std::vector<std::size_t>& casters, const scene::Light& light) {
    scene::Bounds all;
    for (const std::size_t caster : casters) {
        const scene::Bounds box = scene::boundsWorld(scene.objects[caster]);
        const dvec3 centerWorld = 0.5 * (box.lowerWorld + box.upperWorld);
        const bool isAround =
            light.type != scene::LightType::directional &&
            2 * glm::length(light.positionWorld - centerWorld) < glm::length(box.upperWorld - box.lowerWorld);
        if (!isAround) all.include(box);
    }
    if (all.isEmpty()) return {};
    // A hundredth more: what touches the border of the map has a texel beyond it.
    return {0.5 * (all.lowerWorld + all.upperWorld), 0.505 * glm::length(all.upperWorld - all.lowerWorld)};
}

/// The light's camera: from the world to its clip space, in which -1 to 1 is what the map holds.
dmat4 lightClipFromWorld(const scene::Light& light, const Ball& ball) {
    const bool isParallel = light.type == scene::LightType::directional;
    const dvec3 toLightWorld =
        isParallel ? -light.directionWorld : glm::normalize(light.positionWorld - ball.centerWorld);
    // Any direction will do that is not the one it looks in.
    const dvec3 upWorld = std::abs(toLightWorld.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
    if (isParallel) {
        // === BLANK 1: the camera of the sun. Its rays are parallel, so it looks from anywhere outside of the ball toward the
        // ball's centre (glm::lookAt(eye, center, up)), and its projection is orthographic: glm::ortho(left, right, bottom, top,
        // near, far), the last two counted from the eye. The whole ball has to fit. When it is right, casters in the sun have
        // shadows that are as wide as they are.
        (void)upWorld;
        return dmat4(1.0);
        // === END OF BLANK 1
    }
    // === BLANK 2: the camera of a lamp. It stands where the lamp is and looks at the ball's centre. glm::perspective(fovY, aspect,
    // near, far) has to take in the whole ball: a line from the lamp that touches the ball, the radius there, and the way to the
    // centre make a right triangle. Let near be as far out as the ball allows: depths are finest there. When it is right, shadows
    // grow with their distance from the lamp.
    return dmat4(1.0);
    // === END OF BLANK 2
}

class MyShadows final : public Technique {
public:
    params::ParamList params() override {
        return {params::integer("resolution", resolution_, 64, 4096, "texels", "Side of the map.")};
    }

    Progress render(Frame& frame) override {
        const scene::Scene& scene = frame.scene();
        const int lights = static_cast<int>(scene.lights.size());
        cameras_.clear();
        for (int light = 0; light < lights; ++light)
            frame.pass(
                passInfo(kPasses, "map"), [&] { drawMap(frame, light); }, light);
        frame.pass(passInfo(kPasses, "lights-off"),
                   [&] { gl::drawLightsOff(lightsOff_, scene, frame.buffers(), frame.eye()); });
        for (int light = 0; light < lights; ++light) {
            // In step mode, a pass that was not run has left no map.
            if (static_cast<std::size_t>(light) >= cameras_.size()) break;
            if (frame.wants("visibility", light))
                frame.drawStage("visibility", light, GL_RG32F, [&] {
                    glClear(GL_STENCIL_BUFFER_BIT);
                    gl::setVisibilityState();
                    drawReceivers(frame, visibility_, light);
                });
            frame.pass(
                passInfo(kPasses, "light"),
                [&] {
                    glClear(GL_STENCIL_BUFFER_BIT);
                    gl::setAddLightState();
                    drawReceivers(frame, shade_, light);
                },
                light);
        }
        return {};
    }

private:
    void drawMap(const Frame& frame, int light) {
        const scene::Scene& scene = frame.scene();
        const auto index = static_cast<std::size_t>(light);
        const scene::Light& source = scene.lights[index];
        const std::vector<std::size_t> casters = scene::usefulCasters(scene, source);
        cameras_.push_back(lightClipFromWorld(source, ballAround(scene, casters, source)));
        if (maps_.size() <= index) maps_.resize(index + 1);
        if (maps_[index].side() != resolution_) {
            maps_[index] = gl::DepthTextureArray(GL_DEPTH_COMPONENT24, resolution_, 1, "my shadows: map");
            maps_[index].sample(gl::DepthSampling::depths);
        }
        const gl::Framebuffer target(maps_[index], 0, "my shadows: map");
        target.bind();
        glDisable(GL_SCISSOR_TEST); // which a pass begins with is for its picture, not for the map
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_DEPTH_CLAMP); // what is nearer than the near plane casts, too
        // === BLANK 3: the bias. A texel holds one depth for all points that it covers; on a surface that is seen aslant some of them
        // lie behind it, and the surface shadows itself: acne. glPolygonOffset(factor, units) pushes depths away from the light
        // while GL_POLYGON_OFFSET_FILL is enabled: by `factor` times the slope, and `units` steps of the format. When it is
        // right, lit surfaces have no stripes, and shadows still begin where their casters stand.
        // === END OF BLANK 3
        for (const std::size_t caster : casters)
            gl::drawDepth(depth_, scene, frame.buffers(), caster,
                          cameras_.back() * scene::worldFromMesh(scene.objects[caster]));
    }

    void drawReceivers(const Frame& frame, const gl::Program& program, int light) const {
        const auto index = static_cast<std::size_t>(light);
        gl::useForLight(program, frame.scene(), frame.buffers(), frame.eye(), light);
        maps_[index].bind(gl::kFirstFreeUnit);
        program.set("depthMap", gl::kFirstFreeUnit);
        gl::drawSurfaces(program, frame.scene(), frame.buffers(), frame.eye(), [&](const scene::Object& object) {
            program.set("lightClipFromMesh", mat4(cameras_[index] * scene::worldFromMesh(object)));
            return true;
        });
    }

    int resolution_ = 2048;
    std::vector<dmat4> cameras_; // of each light: its clip space from the world
    std::vector<gl::DepthTextureArray> maps_;
    const std::vector<gl::Substitution> mine_{{"shadow_visibility.glsl", "my_shadows/visibility.glsl"}};
    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
    gl::Program shade_{"surface.vert", "shade_light.frag", {}, mine_};
    gl::Program visibility_{"surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}, mine_};
    gl::Program depth_{"position.vert", "nothing.frag"};
};

} // namespace

std::span<const TechniqueInfo> techniques() {
    using enum scene::LightType;
    static const TechniqueInfo info[] = {{
        .id = "my-shadows",
        .title = "My shadows",
        .paper = "Williams 1978, Casting Curved Shadows on Curved Surfaces",
        .getsWrong = "shadow edges are as coarse as its texels; lights among the casters",
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<MyShadows>(); },
    }};
    return info;
}

} // namespace shadowlab::my_shadows
