// SPDX-License-Identifier: MIT
#include "tests/planar/on_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/judge/truth.h"
#include "techniques/foundation/gl/scene/id_buffer.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/view/depth_fit.h"
#include "techniques/planar/receivers/receivers.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab::testing {

namespace {

constexpr ivec2 kSize = kPlanarSize;

/// docs/conventions.md: two steps of the rasteriser's grid, of which one renderer has 256 to a pixel, the other 16.
double tieRadiusPx() {
    GLint bits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
    return judge::tieRadius(bits);
}

/// Is there such a point in sixteen directions on four circles within the tie radius?
bool isAnyNear(dvec2 centre, const auto& condition) {
    const double tiePx = tieRadiusPx();
    for (int ring = 1; ring <= 4; ++ring)
        for (int i = 0; i < 16; ++i) {
            const double angle = 2 * M_PI * i / 16, radius = tiePx * ring / 4;
            if (condition(centre + radius * dvec2(std::cos(angle), std::sin(angle)))) return true;
        }
    return false;
}

bool isTie(const trace::ExactVisibility& judge, const scene::Camera& camera, dvec2 centre, int light,
           trace::Visibility truth) {
    return isAnyNear(centre, [&](dvec2 there) { return judge.at(camera, there, kSize, light) != truth; });
}

/// Where a caster stands on its plane, its edge and that of its flattened image are one line, which the rasteriser rounds
/// twice. No truth changes there where both surfaces are lit, so it is no tie; but which of the two the rasteriser shows is
/// not defined.
bool isAtContact(const trace::ExactVisibility& judge, const scene::Camera& camera, dvec2 centre,
                 const trace::EyeHit& hit) {
    constexpr double kTouching =
        1e-3; // of the distance: some steps of the tie radius on surfaces that are seen at an angle
    return isAnyNear(centre, [&](dvec2 there) {
        const auto other = judge.eyeHit(camera, there, kSize);
        return other && std::abs(other->distance - hit.distance) < kTouching * hit.distance &&
               glm::dot(other->geometricNormalWorld, hit.geometricNormalWorld) < 0.9999;
    });
}

/// Which triangle the rasteriser shows, found when first asked for: only wrong pixels are.
class RasterisedTriangles {
public:
    explicit RasterisedTriangles(scene::Snapshot snapshot) : snapshot_(std::move(snapshot)) {}
    /// Another one than the eye ray met. At the border of a hole or where two surfaces pass through each other neither is
    /// wrong.
    bool differs(int x, int y, const trace::EyeHit& hit) {
        if (ids_.empty()) {
            View view;
            view.camera = snapshot_->camera;
            view.size = kSize;
            ids_ = picture::Session(snapshot_).rasterise(view).primitives;
        }
        std::uint32_t index = hit.triangle;
        for (std::uint32_t object = 0; object < hit.object; ++object)
            index += static_cast<std::uint32_t>(snapshot_->objects[object].mesh->triangles.size());
        const std::uint32_t drawn = ids_[static_cast<std::size_t>(y * kSize.x + x)];
        return drawn != gl::IdBuffer::kNone && drawn != index;
    }

private:
    scene::Snapshot snapshot_;
    std::vector<std::uint32_t> ids_;
};

} // namespace

scene::Scene floorUnder(const dvec3& lightWorld) {
    scene::Scene scene = floorScene();
    scene.lights.push_back(pointLight(lightWorld));
    return scene;
}

scene::Object& addBox(scene::Scene& scene, const dvec3& size, const dvec3& middle) {
    return addObject(scene, scene::makeBox(size), translation(middle));
}

OnPlanes& OnPlanes::operator+=(const OnPlanes& o) {
    lit += o.lit, shadowed += o.shadowed, falseLit += o.falseLit, falseShadow += o.falseShadow, ties += o.ties;
    contacts += o.contacts;
    elsewhere += o.elsewhere, elsewhereShadowed += o.elsewhereShadowed;
    return *this;
}

std::ostream& operator<<(std::ostream& stream, const OnPlanes& c) {
    return stream << c.lit << " lit, " << c.shadowed << " shadowed, " << c.falseLit << " false lit, " << c.falseShadow
                  << " false shadow, " << c.ties << " ties, " << c.contacts << " at contacts, " << c.elsewhere
                  << " elsewhere, " << c.elsewhereShadowed << " of them dark" << c.firstWrong;
}

OnPlanes onPlanes(const scene::Scene& scene, const std::vector<std::string>& settings, int light,
                  const scene::Scene* judged) {
    const scene::Snapshot snapshot = testing::snapshot(scene);
    const picture::VisibilityImage image = testing::renderVisibility(snapshot, "planar", settings, kSize, light);
    planar::Receivers receivers;
    while (!receivers.findNext(snapshot)) {
    }
    const double aspect = static_cast<double>(kSize.x) / kSize.y;
    const scene::Camera camera = scene::withTightNear(scene.camera, scene, scene::objectBounds(scene), aspect);
    const auto planes = receivers.inView(scene, gl::eyeMatrices(camera, kSize), scene::objectBounds(scene));
    const trace::ExactVisibility judge(judged ? testing::snapshot(*judged) : snapshot);
    RasterisedTriangles seen(snapshot);
    OnPlanes result;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const dvec2 centre(x + 0.5, y + 0.5);
            const auto hit = judge.eyeHit(scene.camera, centre, kSize);
            if (!hit) continue;
            const bool onPlane = std::ranges::any_of(planes, [&](const planar::ChosenReceiver& one) {
                return one.receiver.object == hit->object && planar::contains(one.receiver.face->runs, hit->triangle);
            });
            const trace::Visibility truth = judge.visibility(*hit, scene.camera, light);
            const bool lit = image.grey(x, y) > 127;
            if (!onPlane) {
                ++result.elsewhere;
                const bool gateOpen = truth == trace::Visibility::lit || truth == trace::Visibility::shadowed;
                if (gateOpen && !lit && !isTie(judge, scene.camera, centre, light, truth) && !seen.differs(x, y, *hit))
                    ++result.elsewhereShadowed;
                continue;
            }
            result.lit += truth == trace::Visibility::lit;
            result.shadowed += truth == trace::Visibility::shadowed;
            if (lit == (truth == trace::Visibility::lit)) continue;
            if (isTie(judge, scene.camera, centre, light, truth) || seen.differs(x, y, *hit))
                ++result.ties;
            else if (isAtContact(judge, scene.camera, centre, *hit))
                ++result.contacts;
            else {
                ++(lit ? result.falseLit : result.falseShadow);
                if (result.firstWrong.empty())
                    result.firstWrong = "; wrong at " + std::to_string(x) + ", " + std::to_string(y) + " on " +
                                        scene.objects[hit->object].name;
            }
        }
    return result;
}

void expectExactOnPlanes(const scene::Scene& scene, int least, int light) {
    const OnPlanes sum = onPlanes(scene, {}, light);
    EXPECT_GE(sum.lit, least) << sum;
    EXPECT_GE(sum.shadowed, least) << sum;
    EXPECT_EQ(sum.wrong(), 0) << sum;
    EXPECT_LE(sum.contacts, 1) << sum;
    EXPECT_EQ(sum.elsewhereShadowed, 0) << sum;
}

} // namespace shadowlab::testing
