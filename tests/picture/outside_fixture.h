// The picture from outside for tests: a session, two cameras, and what is seen in the picture that was drawn last.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/picture/outside/outside_view.h"
#include "app/picture/picture.h"
#include "techniques/registry.h"
#include "techniques/foundation/scene/query/outside_camera.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab::picture {

class OutsideViewTest : public testing::GlTest {
protected:
    static constexpr ivec2 kSize{720, 480};
    void SetUp() override {
        GlTest::SetUp();
        use(testing::simpleScene());
    }
    void TearDown() override {
        session.reset();
        GlTest::TearDown();
    }
    void use(const scene::Scene& scene) {
        session = std::make_unique<Session>(testing::snapshot(scene));
        eye.camera = scene.camera;
        eye.size = outside.size = kSize;
        outside.camera = scene::outsideCameraFor(scene, scene.camera, 1.5);
    }
    /// Rows from the top, as they are shown.
    image::Image picture(OutsideView& view, Slot& slot, int light = 0) {
        const auto stage = view.render(*session, slot, eye, outside, light, look);
        EXPECT_TRUE(stage);
        key = stage->display.key;
        labels = view.labels();
        return PictureEncoder().encode(*stage, StageKind::swatches, 1);
    }
    image::Image picture(const std::string& technique) {
        Slot slot = Session::makeSlot(technique);
        OutsideView view;
        return picture(view, slot);
    }
    /// Within two levels: half floats are rounded before they are encoded.
    static bool isColor(const image::Color8& pixel, const vec3& color) {
        return std::abs(pixel.r - image::srgbFromLinear(color.r)) <= 2 &&
               std::abs(pixel.g - image::srgbFromLinear(color.g)) <= 2 &&
               std::abs(pixel.b - image::srgbFromLinear(color.b)) <= 2;
    }
    static int pixelsOf(const image::Image& image, const vec3& color) {
        int count = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                count += isColor(image.at(x, y), color);
        return count;
    }
    static int differing(const image::Image& a, const image::Image& b) {
        int count = 0;
        for (std::size_t p = 0; p < a.rgba.size(); p += 4) {
            int largest = 0;
            for (std::size_t c = 0; c < 3; ++c)
                largest = std::max(largest, std::abs(a.rgba[p + c] - b.rgba[p + c]));
            count += largest > 2;
        }
        return count;
    }
    std::unique_ptr<Session> session;
    View eye, outside;
    OutsideLook look;
    std::vector<KeyEntry> key;       ///< of what found no room for a label
    std::vector<PlacedLabel> labels;

    /// What is seen in the picture, by its words: labelled, or in the key.
    [[nodiscard]] std::vector<KeyEntry> things() const {
        std::vector<KeyEntry> all = key;
        for (const PlacedLabel& label : labels)
            all.push_back({label.colorLinear, label.text});
        return all;
    }
    [[nodiscard]] bool shows(std::string_view words) const {
        return std::ranges::any_of(things(), [&](const KeyEntry& one) { return one.label.starts_with(words); });
    }
    [[nodiscard]] const PlacedLabel& labelled(std::string_view text) const {
        const auto found = std::ranges::find(labels, text, &PlacedLabel::text);
        EXPECT_NE(found, labels.end()) << text;
        return *found;
    }
    /// Pixels from the upper left corner.
    [[nodiscard]] dvec2 pixelOf(const dvec3& world) const {
        const dvec4 clip = scene::clipFromView(outside.camera, 1.5) * scene::viewFromWorld(outside.camera) * dvec4(world, 1.0);
        return {(0.5 + 0.5 * clip.x / clip.w) * kSize.x, (0.5 - 0.5 * clip.y / clip.w) * kSize.y};
    }
};

} // namespace shadowlab::picture
