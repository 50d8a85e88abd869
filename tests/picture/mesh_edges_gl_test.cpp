// The stage mesh-edges: lines of the right colour, where the edges are and nowhere else, and as many as are counted.
// SPDX-License-Identifier: MIT
#include "app/picture/stages/mesh_edges.h"

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/query/topology/mesh_topology.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using picture::Panel;

class MeshEdgesTest : public testing::GlTest {
protected:
    static constexpr ivec2 kSize{320, 240};

    /// On a white picture, so that nothing of the ground has the colour of a line.
    static Panel panelOf(const scene::Scene& scene) {
        gl::SceneBuffers buffers;
        const scene::Snapshot snapshot = testing::snapshot(scene);
        buffers.update(snapshot);
        View view;
        view.camera = scene.camera;
        view.size = kSize;
        return picture::meshEdgesPanel(image::Image(kSize.x, kSize.y, {255, 255, 255, 255}), *snapshot, buffers, view);
    }

    static image::Color8 encoded(const vec3& c) {
        return {image::srgbFromLinear(c.r), image::srgbFromLinear(c.g), image::srgbFromLinear(c.b), 255};
    }

    static int pixelsOf(const Panel& panel, const vec3& color) {
        int count = 0;
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x)
                count += panel.picture.at(x, y) == encoded(color);
        return count;
    }

    /// Where a point is seen, in pixels from the upper left corner.
    static dvec2 pixelOf(const scene::Camera& camera, const dvec3& positionWorld) {
        const dvec4 clip = scene::clipFromView(camera, static_cast<double>(kSize.x) / kSize.y) *
                           scene::viewFromWorld(camera) * dvec4(positionWorld, 1.0);
        return {(0.5 + 0.5 * clip.x / clip.w) * kSize.x, (0.5 - 0.5 * clip.y / clip.w) * kSize.y};
    }

    static double distanceToLine(const dvec2& p, const dvec2& a, const dvec2& b) {
        const double t = glm::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
        return glm::length(p - (a + t * (b - a)));
    }

    /// A camera at (2, 3, 6) that looks at the origin; no lights.
    static scene::Scene emptyScene() {
        scene::Scene scene = testing::floorScene();
        scene.objects.clear();
        scene.camera.positionWorld = {2, 3, 6};
        return scene;
    }
};

TEST_F(MeshEdgesTest, AClosedBoxHasNone) {
    scene::Scene scene = emptyScene();
    testing::addObject(scene, scene::makeBox({2, 2, 2}));
    const Panel panel = panelOf(scene);
    for (const vec3& color : {look::kBoundaryEdge, look::kMultipleEdge, look::kInconsistentEdge})
        EXPECT_EQ(pixelsOf(panel, color), 0);
    ASSERT_EQ(panel.display.key.size(), 1u);
    EXPECT_NE(panel.display.key[0].label.find("all meshes are closed"), std::string::npos);
}

TEST_F(MeshEdgesTest, AnOpenQuadHasFourAndTheyLieOnItsRim) {
    scene::Scene scene = emptyScene();
    testing::addObject(scene, scene::makeQuad({3, 2}));
    const Panel panel = panelOf(scene);
    ASSERT_EQ(panel.display.key.size(), 1u);
    EXPECT_EQ(panel.display.key[0].label, "boundary edges, one triangle: 4");

    const dvec2 corners[] = {pixelOf(scene.camera, {-1.5, 0, -1}), pixelOf(scene.camera, {1.5, 0, -1}),
                             pixelOf(scene.camera, {1.5, 0, 1}), pixelOf(scene.camera, {-1.5, 0, 1})};
    // A pixel of a line is at most half a pixel diagonal from it, and the radius is one.
    const double reach = look::lineRadius(kSize.y) + 0.71;
    int drawn = 0, close = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            double distance = 1e9;
            for (int i = 0; i < 4; ++i)
                distance = std::min(distance, distanceToLine({x + 0.5, y + 0.5}, corners[i], corners[(i + 1) % 4]));
            const bool isDrawn = panel.picture.at(x, y) == encoded(look::kBoundaryEdge);
            drawn += isDrawn;
            close += distance < 0.5;
            EXPECT_TRUE(!isDrawn || distance <= reach) << x << ' ' << y << ": " << distance;
            EXPECT_TRUE(isDrawn || distance >= 0.5) << x << ' ' << y << ": " << distance;
        }
    EXPECT_GE(close, 200);
    EXPECT_GE(drawn, 2 * close); // thick
}

TEST_F(MeshEdgesTest, HiddenOnesAreThinAndFaint) {
    scene::Scene scene = emptyScene();
    testing::addObject(scene, scene::makeQuad({3, 2})).name = "sheet";
    const int open = pixelsOf(panelOf(scene), look::kBoundaryEdge);
    testing::addObject(scene, scene::makeBox({12, 12, 0.5}), testing::translation({1, 1, 2.5})); // a wall before it
    const Panel panel = panelOf(scene);
    EXPECT_GE(open, 300);
    EXPECT_EQ(pixelsOf(panel, look::kBoundaryEdge), 0);
    const image::Color8 ground = panel.picture.at(0, 0);
    int faint = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x)
            faint += panel.picture.at(x, y) != ground;
    EXPECT_GE(faint, 300 / 2);
    EXPECT_LE(faint, open / 2);
    EXPECT_EQ(panel.display.key[0].label, "boundary edges, one triangle: 4 (sheet)"); // counted all the same
}

TEST_F(MeshEdgesTest, CountsAreThoseOfTheReportAndNameTheirObjects) {
    // Three pages at one spine, and two triangles of which one is turned over.
    const dvec3 a(0, -1, 0), b(0, 1, 0);
    const auto page = [&](const dvec3& tip) { return std::vector<dvec3>{a, b, tip}; };
    std::vector<dvec3> fan;
    for (const dvec3& tip : {dvec3(1, 0, 0), dvec3(-1, 0, 0), dvec3(0, 0, 1)})
        for (const dvec3& corner : page(tip))
            fan.push_back(corner);
    scene::Scene scene = emptyScene();
    testing::addObject(scene, testing::triangleSoup(fan), testing::translation({-1.5, 0, 0})).name = "fan";
    testing::addObject(scene, testing::triangleSoup({a, b, {1, 0, 0}, a, b, {-1, 0, 0}}),
                       testing::translation({1.5, 0, 0}))
        .name = "torn";
    std::uint64_t boundary = 0, multiple = 0, inconsistent = 0;
    for (const scene::Object& object : scene.objects) {
        const scene::MeshReport report = scene::reportMesh(*object.mesh, scene::buildTopology(*object.mesh));
        boundary += report.boundaryEdges;
        multiple += report.multipleEdges;
        inconsistent += report.inconsistentEdges;
    }
    EXPECT_EQ(boundary, 10u);
    EXPECT_EQ(multiple, 1u);
    EXPECT_EQ(inconsistent, 1u);
    const Panel panel = panelOf(scene);
    ASSERT_EQ(panel.display.key.size(), 3u);
    EXPECT_EQ(panel.display.key[0].label, "boundary edges, one triangle: 10 (fan 6, torn 4)");
    EXPECT_EQ(panel.display.key[1].label, "edges of more than two triangles: 1 (fan)");
    EXPECT_TRUE(panel.display.key[2].label.ends_with(": 1 (torn)"));
    for (const vec3& color : {look::kBoundaryEdge, look::kMultipleEdge, look::kInconsistentEdge})
        EXPECT_GE(pixelsOf(panel, color), 30);
}

TEST_F(MeshEdgesTest, SurfacesOfLightsAreNoMeshesOfTheUser) {
    scene::Scene scene = emptyScene();
    scene::Light light;
    light.name = "panel";
    light.type = scene::LightType::rect;
    scene.lights = {light};
    scene::addEmitterSurfaces(scene);
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(pixelsOf(panelOf(scene), look::kBoundaryEdge), 0);
}

} // namespace
} // namespace shadowlab
