// Volumes that are kept from frame to frame give the picture of volumes made for it, and an orbit of the camera builds none.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/film/orbit.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using KeptVolumesTest = testing::GlTest;

struct Drawn {
    image::Image picture;
    double rebuilt = -1, of = -1;
};

Drawn draw(picture::Session& session, picture::Slot& slot, const scene::Camera& camera) {
    View view;
    view.camera = camera;
    view.size = {160, 120};
    const picture::RenderedFrame frame = session.render(slot, view);
    Drawn drawn{picture::PictureEncoder().encode(slot.target.color, 1)};
    const auto counter = std::ranges::find(frame.result.counters, "volumes-rebuilt", &Counter::id);
    if (counter != frame.result.counters.end()) drawn.rebuilt = counter->built, drawn.of = counter->of;
    return drawn;
}

image::Image fresh(const scene::Scene& scene, const std::string& technique, const scene::Camera& camera) {
    picture::Session session(testing::snapshot(scene));
    picture::Slot slot = picture::Session::makeSlot(technique);
    return draw(session, slot, camera).picture;
}

TEST_F(KeptVolumesTest, AnOrbitRebuildsNoneAndMovesRebuildWhatMoved) {
    for (const std::string technique : {"shadow-volume-zfail", "shadow-volume-zpass"}) {
        scene::Scene scene = testing::simpleScene();
        scene.lights.push_back(testing::directionalLight({-0.5, -1, 0.25}));
        picture::Session session(testing::snapshot(scene));
        picture::Slot slot = picture::Session::makeSlot(technique);
        EXPECT_EQ(draw(session, slot, scene.camera).rebuilt, 8);
        for (const double degrees : {40.0, 80.0, 160.0}) {
            const scene::Camera camera = film::turned(scene.camera, degrees);
            const Drawn orbited = draw(session, slot, camera);
            EXPECT_EQ(orbited.rebuilt, 0);
            EXPECT_EQ(orbited.of, 8);
            EXPECT_EQ(orbited.picture, fresh(scene, technique, camera));
        }
        image::Image last = draw(session, slot, scene.camera).picture;
        const auto change = [&](double least, double most) {
            session.setScene(testing::snapshot(scene));
            const Drawn drawn = draw(session, slot, scene.camera);
            EXPECT_GE(drawn.rebuilt, least);
            EXPECT_LE(drawn.rebuilt, most);
            EXPECT_EQ(drawn.picture, fresh(scene, technique, scene.camera));
            EXPECT_NE(drawn.picture, last);
            last = drawn.picture;
        };
        scene.lights[0].positionWorld += dvec3(-1.5, 0.5, 1);
        scene.revisions.lights = scene::newRevision();
        change(2, 4);
        scene.objects[1].worldFromObject = testing::translation({0.5, 0.4, 0.3}) * scene.objects[1].worldFromObject;
        scene.revisions.transforms = scene::newRevision();
        change(0, 1);
        scene.objects[0].worldFromObject = testing::translation({0, -1, 0}) * scene.objects[0].worldFromObject;
        scene.revisions.transforms = scene::newRevision();
        change(0, 1); // all volumes must reach farther down, and do
    }
}

} // namespace
} // namespace shadowlab
