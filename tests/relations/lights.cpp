// Light adds up, and is in proportion to what is sent.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "tests/relations/relation.h"
#include "tests/support/scenes.h"

namespace shadowlab::relations {

namespace {

// The target holds half floats, and one digit of theirs is 2^-10 of the number at most. Each light that is added rounds once.
constexpr float kRounding = 0x1p-10f;
// Below 2^-14 half floats have fewer digits: steps of 2^-24.
constexpr float kLeast = 0x1p-23f;

using Radiance = std::vector<vec4>;

// A room is solved to 1e-4 of its largest radiosity, and its light map has more points where the light is uneven: other lights,
// other points, and between them interpolation. One percent of the brightest pixel is at most two levels of 255.
constexpr float kOfRoom = 1e-2f;

/// Pixels in which they differ by more than so many roundings, or of a room by more than its light map allows.
Comparison compareRadiance(const Picture& expected, const Radiance& actual, double roundings, const Traits& traits) {
    Comparison result;
    countLight(expected, result);
    if (traits.solvesRoom) result.gate = Gate::edges; // beside a shadow more than that
    float brightest = 0;
    for (const vec4& texel : expected.radiance)
        brightest = std::max({brightest, texel.r, texel.g, texel.b});
    const float least = kLeast + (result.gate == Gate::exact ? 0 : kOfRoom * brightest);
    for (int y = 0; y < expected.size.y; ++y)
        for (int x = 0; x < expected.size.x; ++x) {
            const vec4 &a = expected.radiance[expected.index(x, y)], &b = actual[expected.index(x, y)];
            ++result.compared;
            bool differs = false;
            for (int channel = 0; channel < 3; ++channel)
                differs = differs || !(std::abs(a[channel] - b[channel]) <=
                                       static_cast<float>(roundings) * kRounding *
                                               std::max(std::abs(a[channel]), std::abs(b[channel])) +
                                           least);
            if (!differs) continue;
            ++result.different;
            result.where = {x, y};
            if (result.gate == Gate::exact ||
                !isNearEdge(expected, {x, y}, reachPx(expected, expected, {x, y}, result.gate)))
                ++result.stray;
        }
    return result;
}

/// With at least two lights.
scene::Scene severalLights(const Recipe& recipe) {
    scene::Scene scene = sceneOf(recipe);
    if (scene.lights.size() > 1) return scene;
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    scene.lights.back().intensity = 0.25;
    return scene;
}

Comparison inAnotherOrder(const Recipe& recipe, Painter& painter) {
    scene::Scene scene = severalLights(recipe);
    const Picture before = painter.paint(scene);
    std::reverse(scene.lights.begin(), scene.lights.end());
    return compareRadiance(before, painter.paint(scene).radiance, static_cast<double>(scene.lights.size()),
                           painter.traits());
}

Comparison inFourParts(const Recipe& recipe, Painter& painter) {
    const scene::Scene scene = sceneOf(recipe);
    scene::Scene parts = scene;
    parts.lights.clear();
    for (const scene::Light& light : scene.lights)
        for (int part = 0; part < 4; ++part) {
            parts.lights.push_back(light);
            parts.lights.back().intensity /= 4;
            parts.lights.back().name += "part" + std::to_string(part);
        }
    const Picture whole = painter.paint(scene);
    return compareRadiance(whole, painter.paint(parts).radiance, static_cast<double>(parts.lights.size()),
                           painter.traits());
}

Comparison oneByOne(const Recipe& recipe, Painter& painter) {
    const scene::Scene all = severalLights(recipe);
    const Picture together = painter.paint(all);
    scene::Scene dark = all;
    dark.lights.clear();
    const Radiance ambient = painter.paint(dark).radiance;
    Radiance sum = ambient;
    for (const scene::Light& light : all.lights) {
        scene::Scene alone = all;
        alone.lights = {light};
        const Radiance one = painter.paint(alone).radiance;
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += one[i] - ambient[i];
    }
    return compareRadiance(together, sum, 2.0 * static_cast<double>(all.lights.size()), painter.traits());
}

Comparison twiceAsBright(const Recipe& recipe, Painter& painter) {
    scene::Scene scene = sceneOf(recipe);
    scene.ambient = scene.background = vec3(0.0f);
    // So bright that what one surface reflects to another from afar has all digits of a half float: those below 2^-14 have fewer.
    for (scene::Light& light : scene.lights)
        light.intensity *= 64;
    const Picture once = painter.paint(scene);
    for (scene::Light& light : scene.lights)
        light.intensity *= 2;
    Radiance half = painter.paint(scene).radiance;
    for (vec4& texel : half)
        texel *= 0.5f;
    // Exact in the shader; but what a spot's soft edge adds may be so little that half floats have few digits of it, and of twice
    // as much they have one more. In a room nothing but the light changes, so no light map excuses a difference.
    return compareRadiance(once, half, static_cast<double>(scene.lights.size() - 1), Traits{});
}

Comparison switchedOff(const Recipe& recipe, Painter& painter) {
    const scene::Scene scene = severalLights(recipe);
    scene::Scene off = scene, without = scene;
    off.lights[0].intensity = 0;
    without.lights.erase(without.lights.begin());
    const Picture expected = painter.paint(without);
    Picture actual = painter.paint(off);
    actual.visibility.erase(actual.visibility.begin());
    return compare(expected, actual, Gate::exact);
}

/// Rays from a thousand kilometres away meet this scene parallel to a hundredth of a millimetre. A shadow map keeps floats of
/// the way from the light, and takes its bias from that way, too: two kilometres are two centimetres of it, less than a pixel,
/// and as little are the rays off.
Comparison aLampFarAway(const Recipe& recipe, Painter& painter) {
    const double distance = painter.traits().hasTexels ? 0x1p11 : 0x1p20;
    scene::Scene scene = sceneOf(recipe);
    scene.lights[0] = testing::directionalLight(-scene.lights[0].positionWorld - dvec3(1, 4, 2));
    scene.lights[0].intensity = 0.5;
    const Picture sun = painter.paint(scene);
    scene::Light lamp = testing::pointLight(-distance * scene.lights[0].directionWorld);
    lamp.intensity = scene.lights[0].intensity * distance * distance;
    scene.lights[0] = lamp;
    return compare(sun, painter.paint(scene), Gate::edgesAndTexels);
}

/// A shining ball of a millimetre, which sends as much as the lamp in its place.
Comparison aTinyBall(const Recipe& recipe, Painter& painter) {
    constexpr double kRadius = 0x1p-10;
    scene::Scene scene = sceneOf(recipe);
    const Picture lamps = painter.paint(scene);
    for (scene::Light& light : scene.lights) {
        if (light.type != scene::LightType::point) continue;
        light.type = scene::LightType::sphere;
        light.radius = kRadius;
        light.intensity /= M_PI * kRadius * kRadius;
    }
    return compare(lamps, painter.paint(scene), Gate::edgesAndTexels);
}

} // namespace

std::vector<Relation> lightRelations() {
    return {
        {"lights-in-another-order", "the same radiance but for one rounding a light", {}, inAnotherOrder},
        {"lights-in-four-parts", "each as four of a quarter: the same but for one rounding a light", {}, inFourParts},
        {"lights-one-by-one", "all together are the sum of each alone, ambient light counted once", {}, oneByOne},
        {"twice-as-bright", "lights twice as bright: twice the radiance", {}, twiceAsBright},
        {"switched-off", "a light of no intensity: as without it, to the byte", {}, switchedOff},
        {"a-lamp-far-away", "a lamp very far away: a sun", {}, aLampFarAway},
        {"a-tiny-ball", "a shining ball of a millimetre: a lamp", {}, aTinyBall},
    };
}

} // namespace shadowlab::relations
