// The drawing of two patches: its numbers against formulas computed here, its lines against the scene, and that it can be read.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include <glm/gtc/constants.hpp>

#include "app/context/assets.h"
#include "app/figures/panels.h"
#include "app/figures/pixel_diagram.h"
#include "app/figures/radiosity/patch_view.h"
#include "techniques/probed/patch_exchange.h"
#include "tests/figures/written.h"

namespace shadowlab::figures {
namespace {

/// A rectangle from the middle of which its sides lie `u` and `v` away; it faces along u x v.
PatchProbe rectangle(const dvec3& centreWorld, const dvec3& u, const dvec3& v, std::string object = "wall") {
    PatchProbe patch;
    patch.object = std::move(object);
    patch.cornersWorld = {centreWorld - u - v, centreWorld + u - v, centreWorld + u + v, centreWorld - u + v};
    patch.centreWorld = centreWorld;
    patch.normalWorld = glm::normalize(glm::cross(u, v));
    patch.area = 4 * glm::length(glm::cross(u, v));
    patch.emission = {0.5, 0.25, 0};
    patch.reflectance = {0.7, 0.6, 0.5};
    patch.radiosity = {3.5, 1.7, 0.0000875};
    return patch;
}

struct Arrangement {
    const char* name;
    PatchProbe j, k;
    bool showsBothFronts; ///< is there a place from which both are seen from their fronts?
};

std::vector<Arrangement> arrangements() {
    const PatchProbe floor = rectangle({0, 0, 0}, {0.5, 0, 0}, {0, 0, -0.5}, "floor");
    std::vector<Arrangement> all = {
        {"touching at an edge", floor, rectangle({0, 0.5, -0.5}, {0.5, 0, 0}, {0, 0.5, 0}), true},
        {"touching at a corner", floor, rectangle({1, 0.5, -0.5}, {0.5, 0, 0}, {0, 0.5, 0}), true},
        {"facing each other", floor, rectangle({0, 1, 0}, {0.5, 0, 0}, {0, 0, 0.5}), false},
        {"facing, a hair apart", floor, rectangle({0, 0.001, 0}, {0.5, 0, 0}, {0, 0, 0.5}), false},
        {"facing, aslant", floor, rectangle({3, 1, 1}, {0.5, 0, 0}, {0, 0, 0.5}), false},
        {"side by side", floor, rectangle({1, 0, 0}, {0.5, 0, 0}, {0, 0, -0.5}), true},
        {"back to back", floor, rectangle({0, -1, 0}, {0.5, 0, 0}, {0, 0, 0.5}), false},
        {"large and small", floor, rectangle({0.2, 0.5, 0.1}, {0.001, 0, 0}, {0, 0.0005, 0.001}), false},
        {"small and large", rectangle({0, 0.02, 0}, {0, 0.001, 0}, {0.001, 0, 0}, "bolt"),
         rectangle({0, 0, -9}, {20, 0, 0}, {0, 20, 0}), false},
        {"far apart", floor, rectangle({300, 400, 0}, {0, -0.5, 0}, {0, 0, 0.5}), true},
        {"slivers", rectangle({0, 0, 0}, {2, 0, 0}, {0, 0, -0.002}), rectangle({0, 1, -1}, {0.002, 0, 0}, {0, 2, 0}),
         true},
        {"millimetres", rectangle({0, 0, 0}, {1e-3, 0, 0}, {0, 0, -1e-3}),
         rectangle({0, 1e-3, -1e-3}, {1e-3, 0, 0}, {0, 1e-3, 0}), true},
        {"with a long name", floor,
         rectangle({0, 1, -2}, {0.5, 0, 0}, {0, 0.5, 0}, std::string(300, 'W') + " <wall> & \"more\""), true},
    };
    // The same room, turned and a long way off: no direction of the world is special but up.
    const double turn = 0.7;
    for (std::size_t i = 0; i < 5; ++i) {
        Arrangement turned = all[i];
        turned.name = "turned";
        const auto turnedBy = [&](const dvec3& v) {
            return dvec3(v.x, std::cos(turn) * v.y - std::sin(turn) * v.z, std::sin(turn) * v.y + std::cos(turn) * v.z);
        };
        for (PatchProbe* patch : {&turned.j, &turned.k}) {
            for (dvec3& corner : patch->cornersWorld)
                corner = dvec3(1e4, 0, -1e4) + turnedBy(corner);
            patch->centreWorld = dvec3(1e4, 0, -1e4) + turnedBy(patch->centreWorld);
            patch->normalWorld = turnedBy(patch->normalWorld);
        }
        all.push_back(turned);
    }
    return all;
}

Probe probeOf(const Arrangement& arrangement) {
    Probe probe;
    probe.geometry.push_back({"eye ray", {2, 3, 4}, arrangement.j.centreWorld, Probe::Role::eye});
    probe.add(PatchExchange{arrangement.j, arrangement.k, 0.0123, 0.0456});
    return probe;
}

std::string drawn(const Probe& probe) { return pixelDiagram(probe, scene::Scene{}, testFont()).document(); }

/// As words or a formula alone, or as a line of both.
bool says(const std::string& drawing, const std::string& text) {
    const std::vector<Written> pieces = written(drawing), lines = linesOf(pieces);
    return std::ranges::find(pieces, text, &Written::text) != pieces.end() || std::ranges::find(lines, text, &Written::text) != lines.end();
}

// Twelve positions of a small square above the floor, with angles and form factors that can be worked out by hand: the one at
// (d, h) sees the floor's middle under the angle atan(d / h), and faces it, turned by a given angle.
TEST(FormFactorDiagramTest, ItsNumbersAreThoseOfTheFormula) {
    const PatchProbe floor = rectangle({0, 0, 0}, {0.05, 0, 0}, {0, 0, -0.05}, "floor");
    int compared = 0;
    for (const double degreesJ : {0.0, 20.0, 45.0, 70.0})
        for (const double degreesK : {0.0, 30.0, 80.0}) {
            const double phiJ = glm::radians(degreesJ), phiK = glm::radians(degreesK), r = 2.5;
            const dvec3 wayWorld(std::sin(phiJ), std::cos(phiJ), 0);
            // Turned about z from the way back to the floor.
            const dvec3 faces(-std::sin(phiJ + phiK), -std::cos(phiJ + phiK), 0);
            const dvec3 u(0, 0, 0.1), v = 0.1 * glm::cross(faces, dvec3(0, 0, 1));
            Probe probe = probeOf({"", floor, rectangle(r * wayWorld, u, v), true});
            ASSERT_LT(glm::length(probe.find<PatchExchange>()->k->normalWorld - faces), 1e-12);
            const std::string drawing = drawn(probe);
            const auto angle = [](const char* name, double degrees) {
                return std::string("\u03c6") + name + " = " + std::to_string(degrees).substr(0, 4 - (degrees < 10)) +
                       "\u00b0";
            };
            EXPECT_TRUE(says(drawing, angle("j", degreesJ))) << angle("j", degreesJ);
            EXPECT_TRUE(says(drawing, angle("k", degreesK))) << angle("k", degreesK);
            EXPECT_TRUE(says(drawing, "r = 2.5 m"));
            EXPECT_TRUE(says(drawing, "Surface j, dAj = 0.01 m\u00b2"));
            EXPECT_TRUE(says(drawing, "Surface k, dAk = 0.04 m\u00b2"));
            const double factor = std::cos(phiJ) * std::cos(phiK) * 0.04 / (glm::pi<double>() * r * r);
            EXPECT_TRUE(says(drawing, "dAk = " + fourDigits(factor))) << fourDigits(factor);
            compared += 6;
        }
    EXPECT_EQ(compared, 72);
}

TEST(FormFactorDiagramTest, WhatJGetsAndSendsIsWrittenWithItsUnits) {
    const std::string drawing = drawn(probeOf(arrangements().front()));
    // F_jk B_k, in the colours of B_k; B / pi and B dA of j, whose area is 1 m^2.
    for (const char* text :
         {"0.04305", "0.02091", "1.076\u00b710\u207b\u2076", "1.114", "0.5411", "2.785\u00b710\u207b\u2075", "3.5",
          "8.75\u00b710\u207b\u2075", "W/m\u00b2", "W/(m\u00b2 sr)", "W/sr", "W", "0.0123 of the light of j reaches k",
          "0.0456 of the light of k reaches j"})
        EXPECT_TRUE(says(drawing, text)) << text;
    // Toward k, at 45 degrees: I dA cos phi.
    EXPECT_TRUE(says(drawing, fourDigits(3.5 / glm::pi<double>() * std::sqrt(0.5))));
    EXPECT_TRUE(says(drawing, "toward k"));
}

TEST(FormFactorDiagramTest, TowardTheEyeWhereThereIsNoLightForK) {
    for (const bool hasPartner : {true, false}) {
        Probe probe = probeOf(arrangements()[6]); // back to back
        if (!hasPartner) probe.find<PatchExchange>()->k.reset();
        const std::string drawing = drawn(probe);
        EXPECT_TRUE(says(drawing, "toward the eye"));
        EXPECT_TRUE(says(drawing, "\u03c6 = 56.1\u00b0")); // from (2, 3, 4) down to the floor: atan(sqrt(20) / 3)
        EXPECT_EQ(says(drawing, "Two pieces of surface"), hasPartner);
        EXPECT_EQ(drawing.find("nan"), std::string::npos);
    }
}

TEST(FormFactorDiagramTest, LabelsAreReadableAndCoverNoOtherWhereverThePatchesLie) {
    int compared = 0, drawings = 0;
    for (const Arrangement& arrangement : arrangements()) {
        const std::string drawing = drawn(probeOf(arrangement));
        ++drawings;
        EXPECT_EQ(drawing.find("nan"), std::string::npos) << arrangement.name;
        EXPECT_EQ(drawing.find("inf"), std::string::npos) << arrangement.name;
        const std::vector<Written> all = linesOf(written(drawing));
        // The figure's nine: N, phi and the surface's name of each, r; of the reflector N, phi, I, I dA cos phi, dA.
        EXPECT_GE(all.size(), 50u) << arrangement.name << ": labels are missing";
        for (const char* text : {"Nj", "Nk", "IdAjcos\u03c6", "dAj"})
            EXPECT_TRUE(says(drawing, text)) << arrangement.name << ": " << text;
        EXPECT_TRUE(std::ranges::any_of(all, [](const Written& one) { return one.text.starts_with("\u03c6 = "); }))
            << arrangement.name << ": the angle has its number";
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_GE(all[i].em, 24) << all[i].text << ": 1/45 of a slide of 1080 pixels";
            EXPECT_GE(all[i].box.corner.x, 0) << arrangement.name << ": " << all[i].text;
            EXPECT_LE(all[i].box.corner.x + all[i].box.size.x, 1920) << arrangement.name << ": " << all[i].text;
            EXPECT_LE(all[i].box.corner.y + all[i].box.size.y, 1080) << arrangement.name << ": " << all[i].text;
            for (std::size_t j = 0; j < i; ++j, ++compared)
                EXPECT_FALSE(all[i].box.overlaps(all[j].box))
                    << arrangement.name << ": " << all[i].text << " covers " << all[j].text;
        }
    }
    std::cout << drawings << " drawings, " << compared << " pairs of labels\n";
    EXPECT_GE(drawings, 18);
    EXPECT_GT(compared, 18'000);
}

// A view along a fixed direction, as drawings have it by default, hides one patch behind the other, or shows it from its side.
TEST(PatchViewTest, ShowsBothSurfacesFromTheirFrontsWhereItCanAndOneBesideTheOther) {
    int fronts = 0, hiddenByNaive = 0;
    for (const Arrangement& arrangement : arrangements()) {
        const PatchView view = patchView(arrangement.j, arrangement.k);
        EXPECT_NEAR(glm::dot(view.rightWorld, view.upWorld), 0, 1e-12);
        EXPECT_NEAR(glm::dot(view.rightWorld, view.towardViewerWorld), 0, 1e-12);
        EXPECT_GT(view.upWorld.y, 0) << "up in the scene is down in the drawing";
        const double frontJ = glm::dot(arrangement.j.normalWorld, view.towardViewerWorld);
        const double frontK = glm::dot(arrangement.k.normalWorld, view.towardViewerWorld);
        EXPECT_GT(std::min(std::abs(frontJ), std::abs(frontK)), 0.15) << arrangement.name << ": seen from its side";
        if (arrangement.showsBothFronts) {
            ++fronts;
            EXPECT_GT(frontJ, 0.15) << arrangement.name;
            EXPECT_GT(frontK, 0.15) << arrangement.name;
        }
        const dvec3 wayWorld = arrangement.k.centreWorld - arrangement.j.centreWorld;
        const auto hides = [&](const PatchView& seen) {
            return overlap(
                drawnCorners(arrangement.j, seen, seen.magnified[0], dvec2(0)),
                drawnCorners(arrangement.k, seen, seen.magnified[1], seen.of(seen.distanceShare * wayWorld)));
        };
        EXPECT_FALSE(hides(view)) << arrangement.name;
        // From the right and above.
        PatchView naive;
        naive.towardViewerWorld = glm::normalize(dvec3(1, 0.8, 1));
        naive.rightWorld = glm::normalize(glm::cross(dvec3(0, 1, 0), naive.towardViewerWorld));
        naive.upWorld = glm::cross(naive.towardViewerWorld, naive.rightWorld);
        hiddenByNaive += hides(naive);
    }
    EXPECT_GE(fronts, 7);
    EXPECT_GE(hiddenByNaive, 4) << "the arrangements are too easy";
}

TEST(PatchViewTest, SmallAndFarThingsAreSeenAndDirectionsStay) {
    int checked = 0;
    for (const Arrangement& arrangement : arrangements()) {
        const PatchView view = patchView(arrangement.j, arrangement.k);
        const auto radius = [](const PatchProbe& patch) {
            return glm::length(patch.cornersWorld[0] - patch.centreWorld);
        };
        const double j = view.magnified[0] * radius(arrangement.j), k = view.magnified[1] * radius(arrangement.k);
        const double r = view.distanceShare * glm::length(arrangement.k.centreWorld - arrangement.j.centreWorld);
        EXPECT_LT(r, 8 * (j + k)) << arrangement.name << ": nothing is seen of the surfaces";
        EXPECT_GT(std::min(j, k), 0.02 * std::max({j, k, r})) << arrangement.name << ": a point";
        EXPECT_LE(view.distanceShare, 1);
        ++checked;
    }
    EXPECT_GE(checked, 18);
    const auto& all = arrangements();
    const PatchView touching = patchView(all[0].j, all[0].k);
    EXPECT_EQ(touching.magnified, (std::array<double, 2>{1, 1})) << "what can be drawn as it is, is";
    EXPECT_EQ(touching.distanceShare, 1);
}

TEST(PatchViewTest, PolygonsThatShareARimDoNotOverlap) {
    const std::vector<dvec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const auto moved = [&](dvec2 by) {
        std::vector<dvec2> corners = square;
        for (dvec2& corner : corners)
            corner += by;
        return corners;
    };
    EXPECT_FALSE(overlap(square, moved({1, 0})));
    EXPECT_FALSE(overlap(square, moved({1, 1})));
    EXPECT_FALSE(overlap(square, moved({0, -3})));
    EXPECT_TRUE(overlap(square, moved({0.99, 0.99})));
    EXPECT_TRUE(overlap(square, square));
    const std::vector<dvec2> cross{{-1, 0.4}, {2, 0.4}, {2, 0.6}, {-1, 0.6}}; // no corner of either lies in the other
    EXPECT_TRUE(overlap(square, cross));
    EXPECT_TRUE(overlap(cross, square));
}

TEST(FourDigitsTest, AreShortAndNeverLoseThePowerOfTen) {
    EXPECT_EQ(fourDigits(0), "0");
    EXPECT_EQ(fourDigits(-0.0), "0");
    EXPECT_EQ(fourDigits(0.041234567), "0.04123");
    EXPECT_EQ(fourDigits(1234.56), "1235");
    EXPECT_EQ(fourDigits(-2.5), "\u22122.5");
    EXPECT_EQ(fourDigits(1.25e-10), "1.25\u00b710\u207b\u00b9\u2070");
    EXPECT_EQ(fourDigits(3e-5), "3\u00b710\u207b\u2075");
    EXPECT_EQ(fourDigits(1.5e20), "1.5\u00b710\u00b2\u2070");
    EXPECT_EQ(fourDigits(1e100), "1\u00b710\u00b9\u2070\u2070");
}

} // namespace
} // namespace shadowlab::figures
