// My shadows: a technique to begin with. As it is, every surface that faces the light is lit.
//
// Whether something is in the way is asked in shaders/my_shadows/visibility.glsl, once for each light and pixel.
#include "techniques/frame.h"

namespace shadowlab::my_shadows {

namespace {

const PassInfo kPasses[] = {
    {.id = "lights-off",
     .title = "Render the scene with all light sources turned off",
     .why = "Emission and ambient light are counted once; the depth buffer now holds the visible point of every pixel.",
     .glState = "depth test LESS, depth write on"},
    {.id = "light",
     .title = "Add one light where it is not in shadow",
     .why = "Each visible point asks whether it sees the light.",
     .glState = "depth test EQUAL, blending ONE ONE, stencil lets each pixel be lit once",
     .perLight = true},
};

// The stage that every measurement reads.
const StageInfo kStages[] = {{"visibility", "Visibility of the light", StageKind::visibility, true}};

class MyShadows final : public Technique {
public:
    /// Each one becomes a slider, a --set and a line of `list parameters`.
    params::ParamList params() override {
        return {params::real("darkness", darkness_, 0, 1, "", "Share of the light that every surface loses.")};
    }

    Progress render(Frame& frame) override {
        frame.pass(passInfo(kPasses, "lights-off"),
                   [&] { gl::drawLightsOff(lightsOff_, frame.scene(), frame.buffers(), frame.eye()); });
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
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
    void drawReceivers(const Frame& frame, const gl::Program& program, int light) const {
        gl::useForLight(program, frame.scene(), frame.buffers(), frame.eye(), light);
        program.set("darkness", static_cast<float>(darkness_));
        gl::drawSurfaces(program, frame.scene(), frame.buffers(), frame.eye());
    }

    double darkness_ = 0;
    // The program's shaders shade; the one question that is left, shadowVisibility(), is answered by a file of this folder.
    const std::vector<gl::Substitution> mine_{{"shadow_visibility.glsl", "my_shadows/visibility.glsl"}};
    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
    gl::Program shade_{"surface.vert", "shade_light.frag", {}, mine_};
    gl::Program visibility_{"surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}, mine_};
};

} // namespace

std::span<const TechniqueInfo> techniques() {
    using enum scene::LightType;
    static const TechniqueInfo info[] = {{
        .id = "my-shadows",
        .title = "My shadows",
        .paper = "none",
        .getsWrong = "every cast shadow",
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<MyShadows>(); },
    }};
    return info;
}

} // namespace shadowlab::my_shadows
