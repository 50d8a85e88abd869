// A technique that exists only for the tests: the scene in plain white where a surface is, with one knob.
// It lives in a folder of its own, has a shader of its own, and no other file knows of it.
// SPDX-License-Identifier: MIT
#include "techniques/frame.h"

namespace shadowlab::inverted {

namespace {

const PassInfo kPasses[] = {
    {"paint", "Paint every surface", "The smallest technique there can be.", "depth test LESS", false}};
const StageInfo kStages[] = {{"visibility", "Nothing is lit", StageKind::visibility, true}};

class Inverted final : public Technique {
public:
    params::ParamList params() override {
        return {params::real("brightness", brightness_, 0, 1, "", "Radiance of every surface.")};
    }
    Progress render(Frame& frame) override {
        frame.pass(kPasses[0], [&] {
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
            paint_.use();
            paint_.set("brightness", static_cast<float>(brightness_));
            gl::drawSurfaces(paint_, frame.scene(), frame.buffers(), frame.eye());
        });
        for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light)
            if (frame.wants("visibility", light))
                frame.drawStage("visibility", light, GL_RG32F, [&] {
                    glDepthFunc(GL_EQUAL);
                    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
                    paint_.use();
                    paint_.set("brightness", 1.0f);
                    gl::drawSurfaces(paint_, frame.scene(), frame.buffers(), frame.eye());
                });
        return {};
    }

private:
    double brightness_ = 0.5;
    gl::Program paint_{"surface.vert", "inverted/paint.frag"};
};

} // namespace

std::span<const TechniqueInfo> techniques() {
    static const TechniqueInfo info[] = {{
        .id = "inverted",
        .title = "One more technique",
        .paper = "none",
        .getsWrong = "everything",
        .order = 1000,
        .lightTypes = {scene::LightType::point},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<Inverted>(); },
    }};
    return info;
}

} // namespace shadowlab::inverted
