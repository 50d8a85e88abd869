// Pictures of scenes of which the eye sees a small part.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/picture/session.h"
#include "techniques/foundation/gl/read_back.h"
#include "tests/radiosity/room_row.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/light_shares.h"

namespace shadowlab {
namespace {

using RadiosityImportanceTest = testing::GlTest;

constexpr ivec2 kSize(64, 48);

/// Each room has a lamp near a wall, and walls of its own colour.
scene::Scene litRooms(int rooms) {
    scene::Scene scene = testing::roomRow(rooms);
    scene.background = scene.ambient = vec3(0);
    scene.materials[0].diffuse = vec3(0.7f);
    scene.materials[0].specular = vec3(0);
    for (int i = 0; i < rooms; ++i) {
        scene::Light lamp;
        lamp.positionWorld = testing::placeOfRoom(i) + dvec3(0.5, 1.6, 0.6);
        lamp.intensity = 3.0f + static_cast<float>(i);
        scene.lights.push_back(lamp);
    }
    scene.camera = testing::inRoom(0);
    return scene;
}

double rootMeanSquare(const std::vector<vec4>& picture, const std::vector<vec4>& reference) {
    EXPECT_EQ(picture.size(), reference.size());
    double squares = 0, sum = 0;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        squares += std::pow(static_cast<double>(picture[i].g) - static_cast<double>(reference[i].g), 2);
        sum += static_cast<double>(reference[i].g);
    }
    const double count = static_cast<double>(picture.size());
    EXPECT_GT(sum / count, 0.05) << "it is lit";
    return std::sqrt(squares * count) / sum;
}

// No light goes from room to room, so the picture of one of eight is that of this room alone.
TEST_F(RadiosityImportanceTest, ARoomOfManyIsAsRightAsThatRoomAlone) {
    const std::vector<std::string> gather = {"gather=pixels", "gather-samples=128"};
    const auto picture = [&](int rooms, const std::string& patches, const std::string& importance) {
        testing::TechniqueSlot radiosity("radiosity", testing::snapshot(litRooms(rooms)));
        return radiosity.radiance({"patches=" + patches, "importance=" + importance, gather[0], gather[1]}, kSize);
    };
    const std::vector<vec4> reference = picture(1, "3000", "false");
    const double alone = rootMeanSquare(picture(1, "300", "true"), reference), withImportance = rootMeanSquare(picture(8, "300", "true"), reference),
                 without = rootMeanSquare(picture(8, "300", "false"), reference);
    EXPECT_LT(withImportance, 1.3 * alone) << "of 300 patches up to 84 are in the other seven rooms, one or two for each wall, which makes edges up to a sixth longer";
    EXPECT_GT(without, 2 * withImportance) << "cut evenly, the room has an eighth of the patches";
}

// An eye that has come from elsewhere sees what one sees that was always there.
TEST_F(RadiosityImportanceTest, WhereTheEyeWasBeforeDoesNotMatter) {
    const std::vector<std::string> settings = {"patches=200", "gather-samples=16"};
    scene::Scene scene = litRooms(3);
    testing::TechniqueSlot radiosity("radiosity", testing::snapshot(scene));
    std::vector<std::vector<vec4>> found;
    for (const int room : {0, 2, 1, 0}) {
        scene.camera = testing::inRoom(room);
        radiosity.setScene(testing::snapshot(scene));
        found.push_back(radiosity.radiance(settings, kSize));
        testing::TechniqueSlot fresh("radiosity", testing::snapshot(scene));
        EXPECT_EQ(found.back(), fresh.radiance(settings, kSize)) << room;
    }
    EXPECT_EQ(found.front(), found.back());
    EXPECT_NE(found[0], found[1]);
    EXPECT_NE(radiosity.radiance({settings[0], settings[1], "importance=false"}, kSize), found[0]) << "another cut, from the next frame on";
}

// While patches for a new place are being prepared, the picture stays lit by those that there are.
TEST_F(RadiosityImportanceTest, ThePictureStaysLitWhileTheEyeGoesOn) {
    const scene::Snapshot scene = testing::snapshot(litRooms(3));
    picture::Session session(scene);
    picture::Slot slot = picture::Session::makeSlot("radiosity");
    View view;
    view.camera = scene->camera;
    view.size = kSize;
    ASSERT_TRUE(session.render(slot, view).converged);
    view.camera = testing::inRoom(2);
    FrameRequest slice;
    slice.deadline = Deadline::min();
    int pictures = 0;
    for (bool isDone = false; !isDone && pictures < 10000; ++pictures) {
        isDone = session.render(slot, view, slice).converged;
        double sum = 0;
        for (const vec4& texel : gl::readTexels(slot.target.color))
            sum += static_cast<double>(texel.g);
        EXPECT_GT(sum / (kSize.x * kSize.y), 0.05) << pictures;
    }
    EXPECT_GT(pictures, 3) << "the case is too easy: all was done at once";
}

} // namespace
} // namespace shadowlab
