// No shadows at all: every surface that faces a light is lit by it, whatever stands between.
//
// The yardstick for the others: they add one question, "is anything in the way?", to this picture and change nothing
// else. Blinn, "Models of Light Reflection for Computer Synthesized Pictures", 1977. Wrong on purpose: all cast
// shadows.
// SPDX-License-Identifier: MIT
#include "techniques/frame.h"
#include "techniques/shading_passes.h"

namespace shadowlab::unshadowed {

namespace {

const PassInfo kPasses[] = {
    {.id = "lights-off",
     .title = "Render the scene with all light sources turned off",
     .why = "Emission and ambient light are counted once, however many lights follow; the depth buffer now knows what "
            "is visible.",
     .glState = "depth test LESS, depth write on",
     .formula = "L = emission + ambient * diffuse",
     .anchors = "lights-off"},
    {.id = "light",
     .title = "Add one light",
     .why = "Only surfaces that face the light receive it: N.L > 0. Nothing asks whether something else is in the way.",
     .glState = "depth test EQUAL, blending ONE ONE, stencil lets each pixel be lit once",
     .perLight = true,
     .formula = "L = L + visibility * color * E * (diffuse / pi + specular * (s + 8) / (8 pi) * (n.h)^s)",
     .anchors = "shade-light irradiance"},
};

const StageInfo kStages[] = {
    {"lights-off", "Scene with lights off", StageKind::radiance, false},
    {"visibility", "Facing gate: surfaces turned toward the light", StageKind::visibility, true},
};

class Unshadowed final : public Technique {
public:
    Progress render(Frame& frame) override {
        const scene::Scene& scene = frame.scene();
        frame.drawFinished(FinishedScenes::withLights);
        frame.pass(passInfo(kPasses, "lights-off"),
                   [&] { passes_.lightsOff(frame, ShadingPasses::Depths::withLight); });
        if (frame.wants("lights-off")) frame.publishTarget("lights-off");
        const int lights = static_cast<int>(scene.lights.size());
        const bool allAtOnce = frame.drawsFinished() && lights > 1; // in the pass of the last one
        for (int light = 0; light < lights; ++light) {
            if (frame.wants("visibility", light))
                frame.drawStage("visibility", light, GL_RG32F, [&] {
                    glClear(GL_STENCIL_BUFFER_BIT);
                    gl::setVisibilityState();
                    draw(frame, visibility_, light, gl::ShadedAs::radiance);
                });
            frame.pass(
                passInfo(kPasses, "light"),
                [&] {
                    if (allAtOnce) {
                        if (light == lights - 1) drawWithAllLights(frame);
                        return;
                    }
                    glClear(GL_STENCIL_BUFFER_BIT);
                    const gl::ShadedAs shadedAs = passes_.beginLight(frame);
                    draw(frame, shade_, light, shadedAs);
                },
                light);
        }
        return {};
    }

private:
    static void draw(const Frame& frame, const gl::Program& program, int light, gl::ShadedAs shadedAs) {
        gl::useForLight(program, frame.scene(), frame.buffers(), frame.eye(), light, shadedAs);
        gl::drawSurfaces(program, frame.scene(), frame.buffers(), frame.eye());
    }

    void drawWithAllLights(const Frame& frame) const {
        gl::useForAllLights(allLights_, frame.scene(), frame.buffers(), frame.eye(), nullptr);
        gl::drawSurfaces(allLights_, frame.scene(), frame.buffers(), frame.eye());
    }

    ShadingPasses passes_;
    gl::Program shade_{"surface.vert", "shade_light.frag"};
    gl::Program allLights_{"surface.vert", "shade_lights.frag"};
    gl::Program visibility_{"surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}};
};

} // namespace

std::span<const TechniqueInfo> techniques() {
    using enum scene::LightType;
    static const TechniqueInfo info[] = {{
        .id = "unshadowed",
        .title = "No shadows",
        .paper = "Blinn 1977, Models of Light Reflection for Computer Synthesized Pictures",
        .getsWrong = "every cast shadow",
        .order = 0,
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<Unshadowed>(); },
    }};
    return info;
}

} // namespace shadowlab::unshadowed
