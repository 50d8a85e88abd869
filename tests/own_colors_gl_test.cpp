// Surfaces that have not the same colour all over: images and colours of vertices, in every technique.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/foundation/scene/query/shading.h"
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "tests/support/colored.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/levels_apart.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

constexpr ivec2 kSize{160, 120};

class OwnColors : public testing::GlTest {
protected:
    scene::Snapshot snapshot_ = testing::snapshot(testing::coloredScene());
    View view_{.camera = snapshot_->camera, .size = kSize};
};

// Against diffuseAt(), the definition. A pixel at whose corner another triangle is seen may have been drawn as that one.
TEST_F(OwnColors, AreThoseOfTheirDefinitionOnTheCard) {
    picture::Session session(snapshot_);
    picture::Slot slot = picture::Session::makeSlot("unshadowed");
    session.render(slot, view_);
    const std::vector<vec4> texels = gl::readTexels(slot.target.color);
    const scene::Scene& scene = *snapshot_;
    const trace::ExactVisibility judge(snapshot_);
    int compared = 0;
    double differentHues = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const auto hit = judge.eyeHit(scene.camera, dvec2(x, y) + 0.5, kSize);
            const auto next = judge.eyeHit(scene.camera, dvec2(x, y) + dvec2(0.51, 0.51), kSize);
            if (!hit || !next || next->object != hit->object || next->triangle != hit->triangle) continue;
            const scene::Object& object = scene.objects[hit->object];
            const uvec3 corners = object.mesh->triangles[hit->triangle];
            dvec3 normal(0);
            for (int corner = 0; corner < 3; ++corner)
                normal += hit->barycentric[corner] * dvec3(object.mesh->normalsMesh[corners[corner]]);
            normal = glm::normalize(normal);
            const dvec3 toEye = glm::normalize(scene.camera.positionWorld - hit->positionWorld);
            const auto position = [&](int corner) { return dvec3(object.mesh->positionsMesh[corners[corner]]); };
            const dvec3 front = glm::cross(position(1) - position(0), position(2) - position(0)); // no object is turned
            if (glm::dot(front, toEye) < 0) normal = -normal;
            const dvec3 diffuse(scene::diffuseAt(scene, object, hit->triangle, hit->barycentric));
            dvec3 arriving = glm::pi<double>() * dvec3(scene.ambient); // reflected as diffuse / pi
            if (judge.visibility(*hit, scene.camera, 0) != trace::Visibility::turnedAway)
                arriving += scene::irradiance(scene.lights[0], hit->positionWorld, normal);
            ++compared;
            differentHues += std::abs(diffuse.r - diffuse.b) > 0.2;
            const vec4 drawn = texels[static_cast<std::size_t>(y * kSize.x + x)];
            // A driver may interpolate the image with weights of eight bits, one for each axis: 1/256 each of what neighbouring texels
            // differ by, at most 1. The rest is half floats, 1/2048 for each addition, and float arithmetic.
            for (int c = 0; c < 3; ++c) {
                const double expected = diffuse[c] * arriving[c] / glm::pi<double>();
                ASSERT_NEAR(drawn[c], expected, 1e-3 + 2e-3 * expected + 2.0 / 256 * arriving[c] / glm::pi<double>()) << x << "," << y;
            }
        }
    EXPECT_GT(compared, 3000);
    EXPECT_GT(differentHues, 1500) << "or the scene is too grey to tell anything";
}

// Where both are certainly lit, or certainly in shadow, a technique's pixel is that of rays. Few are not: along the outlines.
TEST_F(OwnColors, AreTheSameInEveryTechnique) {
    picture::Session session(snapshot_);
    picture::PictureEncoder encoder;
    const auto pictureOf = [&](const std::string& technique, bool finished) {
        picture::Slot slot = picture::Session::makeSlot(technique);
        gl::FinishedPicture picture;
        FrameRequest request;
        if (finished) request.finished = &picture;
        const picture::RenderedFrame rendered = session.render(slot, view_, request);
        return rendered.result.isFinished ? picture::PictureEncoder::read(picture.color)
                                          : encoder.encode(slot.target.color, snapshot_->exposure);
    };
    const image::Image expected = pictureOf("ray-traced", false);
    for (const std::string technique : {"ray-traced", "shadow-volume-zpass", "shadow-volume-zfail", "shadow-volume", "shadow-map",
                                        "shadow-map-exact", "shadow-map-alias-free", "planar", "lecture-ray-tracing"})
        for (const bool finished : {false, true}) {
            const image::Image drawn = pictureOf(technique, finished);
            int other = 0;
            // Two levels of 255: weights of eight bits make one of a bright colour, and two roads to a picture are one apart.
            for (int y = 0; y < kSize.y; ++y)
                for (int x = 0; x < kSize.x; ++x)
                    other += testing::levelsApart(drawn.at(x, y), expected.at(x, y)) > 2;
            // The planar technique casts shadows on planes alone, and a map has steps; neither reaches a fourteenth of the picture.
            EXPECT_LT(other, kSize.x * kSize.y / 14) << technique << (finished ? ", finished" : "");
        }
}

} // namespace
} // namespace shadowlab
