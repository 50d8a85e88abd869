// What casters do to visibility, and what rays say of it.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/judge/slot_errors.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/relations/relation.h"
#include "tests/support/scenes.h"

namespace shadowlab::relations {

namespace {

/// Any caster that casts no more: nothing is darker. Read the other way round, a caster more makes nothing brighter.
Comparison aCasterFewer(const Recipe& recipe, Painter& painter) {
    Choice choice(recipe);
    scene::Scene scene = sceneOf(recipe);
    const Picture before = painter.paint(scene);
    scene.objects[1 + choice(static_cast<unsigned>(scene.objects.size() - 1))].castsShadow = false;
    const Picture after = painter.paint(scene);
    Comparison result;
    result.gate = Gate::edgesAndTexels;
    countLight(before, result);
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            ++result.compared;
            bool darker = false;
            for (std::size_t light = 0; light < before.visibility.size(); ++light)
                darker = darker || before.visibility[light].grey(x, y) > after.visibility[light].grey(x, y) + 2;
            if (!darker) continue;
            ++result.different;
            const bool stray = !isNearEdge(before, {x, y}, reachPx(before, after, {x, y}, Gate::edgesAndTexels));
            if (stray || result.stray == 0) result.where = {x, y};
            result.stray += stray;
        }
    return result;
}

/// Above everything hangs a closed box with the only lamp in it.
Comparison aLampInABox(const Recipe& recipe, Painter& painter) {
    scene::Scene scene = sceneOf(recipe);
    const dvec3 place(0.5, 8, 0.25);
    scene.lights = {testing::pointLight(place)};
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation(place));
    scene::Scene open = scene;
    open.objects.back().castsShadow = false;
    Comparison result;
    result.gate = Gate::edges;               // a crack between two sides of a volume is no light that comes through
    countLight(painter.paint(open), result); // what the box keeps dark: the eye is in its shadow, too
    const Picture closed = painter.paint(scene);
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            ++result.compared;
            if (closed.visibility[0].grey(x, y) == 0) continue;
            ++result.different, ++result.stray;
            result.where = {x, y};
        }
    return result;
}

/// Rays decide each pixel's visibility in double. What is wrong outside ties is near the shadow's edge, or a fault. Who serves
/// flat faces alone is asked about boxes.
Comparison asRaysSay(const Recipe& recipe, Painter& painter) {
    Recipe served = recipe;
    if (!painter.traits().servesAll)
        for (SolidRecipe& solid : served.solids)
            solid.kind = SolidKind::box;
    const scene::Scene scene = sceneOf(served);
    const Picture picture = painter.paint(scene);
    picture::Session session(testing::snapshot(scene));
    View view;
    view.camera = scene.camera;
    view.size = picture.size;
    Comparison result;
    result.gate = Gate::edgesAndTexels;
    countLight(picture, result);
    std::optional<judge::Grid<float>> texelPx;
    if (!picture.texelPx.empty()) {
        texelPx.emplace(picture.size.x, picture.size.y);
        texelPx->values = picture.texelPx;
    }
    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        const judge::Truth& truth = session.truth(view, light);
        const auto boundary = judge::trueBoundary(truth);
        const judge::Judgement judged =
            judge::judge(truth, picture.visibility[static_cast<std::size_t>(light)].greyAlpha);
        result.compared += judged.counts.pixels;
        result.different += judged.counts.wrong();
        // A pixel on the line where two surfaces meet may be at fault for every light: one crack.
        const long core =
            judge::coreErrors(truth, judged, judge::distanceToBoundary(boundary, picture.size), texelPx);
        result.stray = std::max(result.stray, core);
        for (std::size_t i = 0; i < judged.verdicts.size(); ++i)
            if (judged.verdicts[i] == judge::Verdict::falseLit || judged.verdicts[i] == judge::Verdict::falseShadow)
                result.where = {static_cast<int>(i) % picture.size.x, static_cast<int>(i) / picture.size.x};
    }
    return result;
}

bool servesFlat(const Traits& traits) { return traits.servesFlat; }
bool seesFromShadow(const Traits& traits) { return traits.servesAll && traits.seesFromShadow; }
/// Radiosity's visibility is interpolated between points, and where these are follows from what stands where.
bool solvesNoRoom(const Traits& traits) { return !traits.solvesRoom; }

} // namespace

std::vector<Relation> casterRelations() {
    return {
        {"a-caster-fewer", "one caster fewer: nothing is darker", solvesNoRoom, aCasterFewer},
        {"a-lamp-in-a-box", "the only lamp in a closed box: all is dark outside", seesFromShadow, aLampInABox},
        {"as-rays-say", "visibility is what rays in double say", servesFlat, asRaysSay},
    };
}

} // namespace shadowlab::relations
