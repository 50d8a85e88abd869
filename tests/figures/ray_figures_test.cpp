// The figures of spread rays: what is drawn against arithmetic of the test's own.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>

#include "app/figures/rays/light_section.h"
#include "techniques/probed/rays_probe.h"
#include "tests/figures/figure_of.h"

namespace shadowlab::figures {
namespace {

/// Does any triangle that casts a shadow lie between the two places? Each is tried alone.
bool isBetween(const scene::Scene& scene, const dvec3& fromWorld, const dvec3& toWorld) {
    const dvec3 way = toWorld - fromWorld;
    for (const scene::Object& object : scene.objects) {
        if (!object.castsShadow) continue;
        const dmat4 worldFromMesh = scene::worldFromMesh(object);
        for (const uvec3& triangle : object.mesh->triangles) {
            std::array<dvec3, 3> p{};
            for (int i = 0; i < 3; ++i)
                p[static_cast<std::size_t>(i)] =
                    transformPoint(worldFromMesh, dvec3(object.mesh->positionsMesh[triangle[i]])) - fromWorld;
            const dvec3 weights(glm::dot(way, glm::cross(p[1], p[2])), glm::dot(way, glm::cross(p[2], p[0])),
                                glm::dot(way, glm::cross(p[0], p[1])));
            if (!(glm::all(glm::greaterThan(weights, dvec3(0))) || glm::all(glm::lessThan(weights, dvec3(0)))))
                continue;
            const dvec3 met =
                (weights.x * p[0] + weights.y * p[1] + weights.z * p[2]) / (weights.x + weights.y + weights.z);
            const double share = glm::dot(met, way) / glm::dot(way, way);
            if (share > 1e-6 && share < 1 - 1e-6) return true;
        }
    }
    return false;
}

// A place is chosen in each subpixel once; discs stand at these places, and the swatch is the mean.
TEST(JitterFigureTest, ShowsTheSamplesWhereTheyAre) {
    int compared = 0;
    for (const char* samples : {"9", "16", "10"}) {
        const FigureOf asked("billiards", "ray-traced", {149, 456}, {{"samples", samples}, {"shutter", "0"}});
        const RaysProbe& rays = *asked.probe.find<RaysProbe>();
        double area = 0;
        for (const RaysProbe::Sample& sample : rays.samples) {
            const auto& [low, high] = *sample.subpixel;
            area += (high.x - low.x) * (high.y - low.y);
            EXPECT_TRUE(glm::all(glm::greaterThanEqual(sample.place, low)) &&
                        glm::all(glm::lessThanEqual(sample.place, high)));
            for (const RaysProbe::Sample& other : rays.samples) {
                if (&other == &sample) continue;
                EXPECT_NE((*other.subpixel)[0], low) << "two samples in one subpixel";
            }
        }
        EXPECT_NEAR(area, 1, 1e-12) << "subpixels fill the pixel";
        const Diagram drawn = asked.draw("jitter");
        double side = 0;
        dvec2 corner(0.0);
        for (const drawing::Mark& mark : drawn.drawing.marks())
            if (const auto* one = std::get_if<drawing::Rectangle>(&mark);
                one && one->size.x > side && one->size.x == one->size.y) {
                side = one->size.x;
                corner = one->corner;
            }
        const std::vector<drawing::Circle> discs = circlesOf(drawn, "sample");
        ASSERT_EQ(discs.size(), rays.samples.size());
        for (std::size_t i = 0; i < discs.size(); ++i, ++compared)
            EXPECT_LT(glm::length((discs[i].centre - corner) / side - rays.samples[i].place), 1e-9);
    }
    EXPECT_EQ(compared, 35);
}

// Every ray begins on the lens and passes the point of the object plane that the ray through the lens's middle passes. They are a
// pixel's width apart there, since each goes through another place of the pixel.
TEST(LensFigureTest, RaysMeetInTheObjectPlane) {
    int compared = 0, leaders = 0;
    for (const ivec2 pixel : {ivec2(768, 86), ivec2(230, 430), ivec2(640, 650)}) {
        const FigureOf asked("billiards", "ray-traced", pixel,
                             {{"samples", "16"}, {"aperture", "0.1"}, {"shutter", "0"}});
        const scene::Camera& camera = asked.view.camera;
        const dvec3 forward = glm::normalize(camera.targetWorld - camera.positionWorld);
        const double focus = glm::length(camera.targetWorld - camera.positionWorld);
        EXPECT_NEAR(asked.probe.find<RaysProbe>()->focus, focus, 1e-12);
        const dvec3 middle = scene::rayDirectionWorld(camera, dvec2(pixel) + 0.5, asked.view.size);
        const dvec3 meeting = camera.positionWorld + middle * (focus / glm::dot(middle, forward));
        const double pixelMetres = 2 * focus * std::tan(glm::radians(0.5 * camera.fovYDegrees)) / asked.view.size.y;
        for (const RaysProbe::Sample& sample : asked.probe.find<RaysProbe>()->samples) {
            EXPECT_LE(glm::length(sample.fromWorld - camera.positionWorld), 0.05 + 1e-9);
            EXPECT_NEAR(glm::dot(sample.fromWorld - camera.positionWorld, forward), 0, 1e-9);
            const dvec3 way = sample.toWorld - sample.fromWorld;
            const dvec3 at = sample.fromWorld + way * (focus / glm::dot(way, forward));
            EXPECT_LT(glm::length(at - meeting), 0.7072 * pixelMetres * 1.001);
            ++compared;
        }
        // In the drawing the lines pass the mark of the meeting point, as near as that is.
        const Diagram drawn = asked.draw("lens");
        ASSERT_EQ(circlesOf(drawn, "focus").size(), 1u);
        ASSERT_EQ(circlesOf(drawn, "hit").size(), 16u);
        // The point in the lens's middle is named from the left: nothing that leads to its name crosses a ray.
        const double eye = circlesOf(drawn, "eye").front().centre.x;
        for (const drawing::Mark& mark : drawn.drawing.marks())
            if (const auto* line = std::get_if<drawing::Line>(&mark); line && line->stroke.color == "#8c8c8c" && !line->stroke.isDashed) {
                if (line->points.front().x > eye) continue; // to a label elsewhere
                EXPECT_LT(std::max(line->points.front().x, line->points.back().x), eye);
                ++leaders;
            }
    }
    EXPECT_EQ(compared, 48);
    EXPECT_GE(leaders, 3 * 2) << "two pieces in each drawing";
}

// The rays lie on their side of the surface, around the ideal one: with a lobe of power n the mean of the cosines is
// (n + 1) / (n + 2), and 256 jittered samples come nearer to that than as many by chance, whose error is about 1 / n / 16.
TEST(GlossFigureTest, RaysAreSpreadAsTheMaterialSays) {
    struct Asked {
        const char* figure;
        ivec2 pixel;
        const char* letter;
        std::optional<dvec3> RaysProbe::Sample::*way;
    };
    for (const Asked& one : {Asked{"gloss", {576, 180}, "R", &RaysProbe::Sample::reflectedWorld},
                             Asked{"translucency", {870, 360}, "T", &RaysProbe::Sample::refractedWorld}}) {
        const FigureOf asked("billiards", "ray-traced", one.pixel, {{"samples", "256"}, {"shutter", "0"}});
        const double n = std::log(0.5) / std::log(std::cos(glm::radians(4.0)));
        dvec3 ideal(0.0);
        for (const Probe::Vector& vector : asked.probe.vectors)
            if (vector.label == one.letter) ideal = vector.directionWorld;
        double mean = 0;
        int count = 0;
        for (const RaysProbe::Sample& sample : asked.probe.find<RaysProbe>()->samples)
            if (sample.*one.way) {
                mean += glm::dot(*(sample.*one.way), ideal);
                ++count;
            }
        ASSERT_EQ(count, 256);
        EXPECT_NEAR(mean / count, (n + 1) / (n + 2), 4 / n / 16) << one.figure;
        EXPECT_TRUE(says(asked.draw(one.figure), "256")) << one.figure;
    }
}

// Whether a shadow ray arrives, against all triangles one by one; and the share that arrives against the exact one.
TEST(LampFigureTest, RaysArriveWhereNothingIsBetween) {
    int arrived = 0, blocked = 0;
    for (const ivec2 pixel : {ivec2(972, 662), ivec2(896, 633), ivec2(500, 600), ivec2(420, 560)})
        for (const int light : {1, 2}) {
            const FigureOf asked("room-with-lamps", "ray-traced", pixel, {{"samples", "16"}}, light);
            if (!asked.probe.find<RaysProbe>()->sampledShare()) continue;
            std::size_t arrives = 0, sent = 0;
            for (const RaysProbe::Sample& sample : asked.probe.find<RaysProbe>()->samples) {
                if (!sample.onLightWorld) continue;
                ++sent;
                arrives += sample.arrives;
                (sample.arrives ? arrived : blocked) += 1;
                EXPECT_EQ(sample.arrives, !isBetween(*asked.scene, sample.toWorld, *sample.onLightWorld));
                if (!sample.arrives) {
                    EXPECT_LT(glm::length(sample.shadowEndWorld - sample.toWorld),
                              glm::length(*sample.onLightWorld - sample.toWorld));
                }
            }
            const Diagram drawn = asked.draw("lamp");
            EXPECT_EQ(circlesOf(drawn, "seen").size(), arrives);
            EXPECT_EQ(circlesOf(drawn, "hidden").size(), sent - arrives);
            EXPECT_TRUE(says(drawn, std::to_string(arrives) + " of " + std::to_string(sent) + " arrive"));
            // Sixteen rays by chance: a standard deviation of an eighth at most, and jittered ones are better.
            EXPECT_NEAR(*asked.probe.find<RaysProbe>()->sampledShare(), *asked.probe.find<RaysProbe>()->exactShare, 0.25);
        }
    std::cout << arrived << " rays arrive, " << blocked << " are blocked\n";
    EXPECT_GT(arrived, 20);
    EXPECT_GT(blocked, 20);
}

/// By so many places on the light, each joined to the place by a line.
double shareByPlaces(const std::array<dvec2, 2>& light, dvec2 place, const std::vector<dvec2>& occluders, int count) {
    int seen = 0;
    const auto side = [](dvec2 a, dvec2 b, dvec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); };
    for (int i = 0; i < count; ++i) {
        const dvec2 at = glm::mix(light[0], light[1], (i + 0.5) / count);
        bool blocked = false;
        for (std::size_t k = 0; k + 1 < occluders.size() && !blocked; k += 2) {
            const dvec2 c = occluders[k], d = occluders[k + 1];
            blocked = side(place, at, c) * side(place, at, d) < 0 && side(c, d, place) * side(c, d, at) < 0;
        }
        seen += !blocked;
    }
    return static_cast<double>(seen) / count;
}

// Two occluders of which one is a closed outline, a rect and a sphere as lights.
TEST(PenumbraFigureTest, SharesAndAreasAreThoseOfTheSection) {
    const DrawingPlane plane{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<dvec2> occluders{{-1, 1},    {-0.2, 1.4}, {0.3, 0.5}, {0.9, 0.5},
                                       {0.9, 0.5}, {0.6, 1},    {0.6, 1},   {0.3, 0.5}};
    scene::Light rect;
    rect.type = scene::LightType::rect;
    rect.positionWorld = {0.2, 3, 0};
    rect.edgeUWorld = {1.2, 0, 0};
    rect.edgeVWorld = {0, 0, 0.5};
    scene::Light sphere;
    sphere.type = scene::LightType::sphere;
    sphere.positionWorld = {-0.3, 3, 0};
    sphere.radius = 0.4;
    int compared = 0, part = 0, none = 0, inArea = 0;
    for (const scene::Light& light : {rect, sphere}) {
        const SectionOfLight section(light, plane, occluders);
        const std::vector<LitArea> areas = shadowAreas(section, {{-3, 0}, {6, 2}}, 0.01);
        for (int i = 0; i < 60; ++i)
            for (int k = 0; k < 20; ++k) {
                const dvec2 place(-2.96 + 0.1 * i, 0.013 + 0.097 * k);
                const double share = section.share(place);
                // So many places know the share to one of them at each end of each of the four segments.
                EXPECT_NEAR(share, shareByPlaces(section.seenFrom(place), place, occluders, 400), 8.0 / 400);
                ++compared;
                part += share > 0.05 && share < 0.95;
                none += share <= 0;
                // Away from borders, by two scan lines, the areas say the same.
                const LitArea::Kind kind = kindAt(section, place);
                bool isAtBorder = false;
                for (int a = 0; a < 8; ++a)
                    isAtBorder = isAtBorder || kindAt(section, place + 0.03 * dvec2(std::cos(a * M_PI / 4),
                                                                                    std::sin(a * M_PI / 4))) != kind;
                if (isAtBorder) continue;
                LitArea::Kind drawn = LitArea::Kind::all;
                for (const LitArea& area : areas) {
                    bool within = false;
                    for (std::size_t v = 0; v < area.outline.size(); ++v) {
                        const dvec2 p = area.outline[v], q = area.outline[(v + 1) % area.outline.size()];
                        if ((p.y > place.y) != (q.y > place.y) &&
                            place.x < glm::mix(p.x, q.x, (place.y - p.y) / (q.y - p.y)))
                            within = !within;
                    }
                    if (within) drawn = area.kind;
                }
                EXPECT_EQ(drawn, kind) << place.x << ", " << place.y;
                inArea += drawn != LitArea::Kind::all;
            }
    }
    std::cout << compared << " places, " << part << " in penumbra, " << none << " in umbra\n";
    EXPECT_EQ(compared, 2400);
    EXPECT_GT(part, 100);
    EXPECT_GT(none, 20);
    EXPECT_GT(inArea, 200);
}

// The naive answer, one ray to the light's middle, knows no penumbra.
TEST(PenumbraFigureTest, AreasDifferFromThoseOfAPoint) {
    const FigureOf asked("room-with-lamps", "ray-traced", {371, 576}, {}, 2);
    const Diagram drawn = asked.draw("penumbra");
    for (const char* word : {"Extended Light Source", "Object: ball", "Umbra", "Penumbra"})
        EXPECT_TRUE(says(drawn, word)) << word;
    EXPECT_FALSE(says(drawn, "sees 0.0 %"));
    EXPECT_FALSE(says(drawn, "sees 100 %"));
}

TEST(ShutterFigureTest, RaysMeetTheBallWhereItIsAtTheirTime) {
    int met = 0, missed = 0;
    for (const ivec2 pixel : {ivec2(179, 446), ivec2(190, 440), ivec2(300, 432)}) {
        const FigureOf asked("billiards", "ray-traced", pixel, {{"samples", "64"}});
        const scene::Object& ball = *std::ranges::find(asked.scene->objects, "white ball", &scene::Object::name);
        for (const RaysProbe::Sample& sample : asked.probe.find<RaysProbe>()->samples) {
            // A ball of radius 0.057 at that time, by the distance of its centre from the ray. Its mesh has 96 segments: it
            // reaches out as far at its corners, and by (1 - cos(pi / 96)) less in between.
            const dvec3 centre = dvec3(-0.26, 0.057, 0.22) + sample.time * ball.velocityWorld;
            const dvec3 u = glm::normalize(sample.toWorld - sample.fromWorld);
            const double away = glm::length(glm::cross(centre - sample.fromWorld, u));
            if (std::abs(away - 0.057) < 0.057 * 0.002) continue;
            EXPECT_EQ(sample.object == "white ball", away < 0.057) << sample.time;
            (away < 0.057 ? met : missed) += 1;
        }
    }
    std::cout << met << " rays meet the ball, " << missed << " miss it\n";
    EXPECT_GT(met, 20);
    EXPECT_GT(missed, 20);
}

} // namespace
} // namespace shadowlab::figures
