// The fixture of the contract tests: every registered technique, drawn small, on a scene with two lights.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/lab/settings.h"
#include "app/picture/picture.h"
#include "techniques/foundation/gl/read_back.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/levels_apart.h"
#include "tests/support/scenes.h"

namespace shadowlab::testing {

inline constexpr ivec2 kSize{96, 64};

inline std::vector<std::string> ids() {
    std::vector<std::string> all;
    for (const RegisteredTechnique& technique : registeredTechniques())
        all.emplace_back(technique.info->id);
    return all;
}

class Contract : public GlTest, public ::testing::WithParamInterface<std::string> {
protected:
    static View viewOf(const scene::Snapshot& snapshot, ivec2 size = kSize) {
        View view;
        view.camera = snapshot->camera;
        view.size = size;
        return view;
    }
    image::Image picture(picture::Session& session, picture::Slot& slot, ivec2 size = kSize) {
        session.render(slot, viewOf(session.snapshot(), size));
        return picture::PictureEncoder().encode(slot.target.color, session.snapshot()->exposure);
    }
    image::Image picture(const scene::Scene& scene, const std::vector<std::string>& settings = {}, ivec2 size = kSize) {
        picture::Session session(snapshot(scene));
        std::vector<picture::Slot> slots;
        slots.push_back(picture::Session::makeSlot(GetParam()));
        std::vector<std::string> full;
        for (const std::string& setting : settings)
            full.push_back(GetParam() + "." + setting);
        lab::applySettings(slots, full);
        return picture(session, slots[0], size);
    }
    void expectNoNaN(const picture::Slot& slot) {
        for (const vec4& texel : gl::readTexels(slot.target.color))
            ASSERT_TRUE(std::isfinite(texel.r) && std::isfinite(texel.g) && std::isfinite(texel.b));
    }
};

inline scene::Scene twoLights() {
    scene::Scene scene = simpleScene();
    scene.lights[0].intensity = 20; // bright, and below clipping
    scene.lights.push_back(directionalLight({0.5, -1, 0.25}));
    scene.lights.back().intensity = 0.6;
    return scene;
}

/// "shadow-map" as GoogleTest allows it in a name.
inline std::string testName(const ::testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::ranges::replace(name, '-', '_');
    return name;
}

} // namespace shadowlab::testing
