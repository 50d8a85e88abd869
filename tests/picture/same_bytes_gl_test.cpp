// One scene, three contexts, the same bytes: EGL, OSMesa and a hidden window.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "app/context/context.h"
#include "app/picture/derived_stages.h"
#include "app/picture/session.h"
#include "tests/support/osmesa.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

std::vector<image::Image> picturesOn(context::Backend backend) {
    const auto context = context::createContext(backend);
    scene::Scene scene = testing::simpleScene();
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    picture::Session session(testing::snapshot(scene));
    const picture::PictureEncoder encoder;
    View view;
    view.camera = scene.camera;
    view.size = {400, 300};
    std::vector<image::Image> pictures;
    for (const RegisteredTechnique& technique : techniquesOf(TechniqueGroup::production)) {
        picture::Slot slot = picture::Session::makeSlot(technique.info->id);
        session.render(slot, view);
        pictures.push_back(encoder.encode(slot.target.color, scene.exposure));
    }
    return pictures;
}

image::Image outlineOn(context::Backend backend) {
    const auto context = context::createContext(backend);
    picture::Session session(testing::snapshot(testing::simpleScene()));
    View view;
    view.camera = session.snapshot()->camera;
    view.size = {400, 300};
    picture::Slot slot = picture::Session::makeSlot("shadow-map");
    const picture::RenderedFrame rendered = session.render(slot, view);
    return derivedPanel(session, slot, rendered, picture::PictureEncoder(), {{"shadow-outline", 0}, view, {}, nullptr})
        .picture;
}

TEST(SameBytes, OnEglAndOsMesa) {
    if (testing::mayLackOsmesa()) GTEST_SKIP() << testing::kNoOsmesa;
    const auto egl = picturesOn(context::Backend::egl), osmesa = picturesOn(context::Backend::osmesa);
    ASSERT_GE(egl.size(), 3u);
    EXPECT_NE(egl[0], egl[1]) << "with and without shadows must differ";
    for (std::size_t i = 0; i < egl.size(); ++i)
        EXPECT_TRUE(egl[i] == osmesa[i]) << techniquesOf(TechniqueGroup::production)[i].info->id;
    EXPECT_TRUE(outlineOn(context::Backend::egl) == outlineOn(context::Backend::osmesa));
}

TEST(SameBytes, OnAHiddenWindow) {
    if (!std::getenv("DISPLAY")) GTEST_SKIP() << "no display for a window; ./check runs this under Xvfb";
    const auto egl = picturesOn(context::Backend::egl), window = picturesOn(context::Backend::window);
    for (std::size_t i = 0; i < egl.size(); ++i)
        EXPECT_TRUE(egl[i] == window[i]) << techniquesOf(TechniqueGroup::production)[i].info->id;
    EXPECT_TRUE(outlineOn(context::Backend::egl) == outlineOn(context::Backend::window));
}

} // namespace
} // namespace shadowlab
