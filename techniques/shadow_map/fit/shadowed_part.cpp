// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/fit/shadowed_part.h"

#include <algorithm>
#include <array>

#include "techniques/foundation/scene/query/view/clip_polygon.h"

namespace shadowlab::shadow_map {

namespace {

dvec4 nearPlaneWorld(const dmat4& clipFromWorld) { return glm::transpose(clipFromWorld) * dvec4(0, 0, 1, 1); }

/// The sides of a map, the plane through the light, and the eye's near plane, in the world: positive inside.
std::array<dvec4, 6> planesAround(const LightMaps& maps, int layer, const dvec4& nearWorld) {
    dmat4 lightRelativeFromWorld(1.0);
    lightRelativeFromWorld[3] = dvec4(-maps.originWorld, 1.0);
    const dmat4 transposed = glm::transpose(maps.lightClipFromLightRelative(layer) * lightRelativeFromWorld);
    return {transposed * dvec4(1, 0, 0, 1),  transposed * dvec4(-1, 0, 0, 1), transposed * dvec4(0, 1, 0, 1),
            transposed * dvec4(0, -1, 0, 1), transposed * dvec4(0, 0, 0, 1),  nearWorld};
}

/// Most boxes lie inside of all planes, or beyond one of them, and need not be cut.
enum class Side { inside, between, beyond };

Side sideOf(const scene::Bounds& box, std::span<const dvec4> planes) {
    Side side = Side::inside;
    for (const dvec4& plane : planes) {
        int inside = 0;
        for (int i = 0; i < 8; ++i)
            inside += glm::dot(plane, dvec4(box.corner(i), 1.0)) >= 0 ? 1 : 0;
        if (inside == 0) return Side::beyond;
        if (inside < 8) side = Side::between;
    }
    return side;
}

/// Makes the part larger by what of the box lies inside of all planes, as the eye sees it. One of them is the eye's near plane.
void include(scene::PicturePart& part, const scene::Bounds& box, std::span<const dvec4> planesWorld,
             const dmat4& clipFromWorld) {
    const auto includeCorner = [&](const dvec4& cornerWorld) {
        const dvec4 clip = clipFromWorld * cornerWorld;
        part.lower = glm::min(part.lower, dvec2(clip) / clip.w);
        part.upper = glm::max(part.upper, dvec2(clip) / clip.w);
    };
    const Side side = sideOf(box, planesWorld);
    for (int corner = 0; corner < 8 && side == Side::inside; ++corner)
        includeCorner(dvec4(box.corner(corner), 1.0));
    for (int face = 0; face < 6 && side == Side::between; ++face) {
        std::vector<dvec4> polygon = scene::boxFaceWorld(box, face);
        for (const dvec4& plane : planesWorld)
            polygon = scene::clippedPolygon(polygon, plane);
        std::ranges::for_each(polygon, includeCorner);
    }
}

scene::PicturePart inPicture(const scene::PicturePart& part) {
    return {glm::max(part.lower, dvec2(-1)), glm::min(part.upper, dvec2(1))};
}

double area(const scene::PicturePart& part) {
    const dvec2 size = glm::max(part.upper - part.lower, dvec2(0));
    return size.x * size.y;
}

/// Does all of the box certainly lie in that part of the picture?
bool isWithin(const scene::Bounds& bounds, const scene::PicturePart& part, const dmat4& clipFromWorld) {
    for (int i = 0; i < 8; ++i) {
        const dvec4 clip = clipFromWorld * dvec4(bounds.corner(i), 1.0);
        if (clip.z <= -clip.w) return false; // before the near plane, or behind the eye
        const dvec2 place = dvec2(clip) / clip.w;
        if (!glm::all(glm::greaterThan(place, part.lower)) || !glm::all(glm::lessThan(place, part.upper))) return false;
    }
    return true;
}

} // namespace

std::optional<scene::PicturePart> shadowedPart(const LightMaps& maps, std::span<const scene::Bounds> receivers,
                                               const dmat4& clipFromWorld) {
    if (maps.layout == Layout::cube) return std::nullopt;
    const dvec4 nearWorld = nearPlaneWorld(clipFromWorld);
    scene::PicturePart part{dvec2(1), dvec2(-1)};
    for (const scene::Bounds& box : receivers) {
        // Of a box that the eye is in, or the light, the surfaces may be seen where none of the box's own sides are.
        const bool flat = glm::any(glm::equal(box.lowerWorld, box.upperWorld));
        const bool holdsLight = !maps.parallel && glm::all(glm::lessThanEqual(box.lowerWorld, maps.originWorld)) &&
                                glm::all(glm::greaterThanEqual(box.upperWorld, maps.originWorld));
        if (!flat && (holdsLight || !scene::isBeyondNearPlane(box, clipFromWorld))) return std::nullopt;
    }
    for (int layer = 0; layer < maps.layers(); ++layer) {
        const std::array<dvec4, 6> planes = planesAround(maps, layer, nearWorld);
        for (const scene::Bounds& box : receivers)
            include(part, box, planes, clipFromWorld);
    }
    return inPicture(part);
}

ReceiverLookup receiverLookup(const LightMaps& maps, const scene::Bounds& object, const dmat4& clipFromWorld) {
    const std::optional<scene::PicturePart> part = shadowedPart(maps, std::span(&object, 1), clipFromWorld);
    if (!part) return {};
    if (!glm::all(glm::lessThan(part->lower, part->upper))) return {.looksUp = false, .where = part, .rest = true};
    if (isWithin(object, *part, clipFromWorld)) return {.looksUp = true, .where = part, .rest = false};
    scene::PicturePart all{dvec2(1), dvec2(-1)};
    const dvec4 nearWorld = nearPlaneWorld(clipFromWorld);
    include(all, object, std::span(&nearWorld, 1), clipFromWorld);
    // A second time all of its vertices are transformed and all of its pixels tested: measured, with a software renderer, as
    // much as a map costs in half of them.
    if (area(*part) > 0.5 * area(inPicture(all))) return {};
    return {.looksUp = true, .where = part, .rest = true};
}

} // namespace shadowlab::shadow_map
