// The same pixels in another frame.
// SPDX-License-Identifier: MIT
#include "tests/relations/relation.h"

namespace shadowlab::relations {

namespace {

Comparison aPartOfIt(const Recipe& recipe, Painter& painter) {
    Choice choice(recipe);
    Region region;
    for (int axis = 0; axis < 2; ++axis) {
        region.size[axis] = kSize[axis] / 4 + static_cast<int>(choice(static_cast<unsigned>(kSize[axis] / 2)));
        region.corner[axis] = static_cast<int>(choice(static_cast<unsigned>(kSize[axis] - region.size[axis] + 1)));
    }
    const scene::Scene scene = sceneOf(recipe);
    const auto cut = [&](const Picture& picture) {
        return rearranged(picture, region.size, [&](ivec2 p) { return p + region.corner; });
    };
    const Picture whole = cut(painter.paint(scene));
    return compare(whole, cut(painter.paint(scene, kSize, region)), Gate::exact);
}

Comparison resizedAndBack(const Recipe& recipe, Painter& painter) {
    Choice choice(recipe);
    const scene::Scene scene = sceneOf(recipe);
    const Picture before = painter.paint(scene);
    painter.paint(scene, ivec2(1 + choice(300), 1 + choice(300)));
    return compare(before, painter.paint(scene), Gate::exact);
}

} // namespace

std::vector<Relation> frameRelations() {
    return {
        {"a-part-of-it", "a rectangle drawn alone: the same bytes as in the whole picture", {}, aPartOfIt},
        {"resized-and-back", "drawn in another size in between: the same bytes", {}, resizedAndBack},
    };
}

} // namespace shadowlab::relations
