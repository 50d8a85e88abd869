// Reads the built-in shapes: quad, box, sphere and torus, each with its own sizes.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/foundation/scene/json/scene_json.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

namespace {

constexpr int kFewestSegments = 3;  // the smallest closed ring
constexpr int kMostSegments = 4096; // finer than a pixel of any picture

std::string identity(std::string kind, std::initializer_list<double> numbers) {
    for (const double number : numbers)
        kind.append(1, ' ').append(numberText(number));
    return kind;
}

std::uint64_t product(int a, int b) { return static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b); }

/// A torus takes [around the axis, around the tube], or one number for the first, and half of it for the second.
ivec2 torusSegments(const JsonObject& keys) {
    const JsonValue* value = keys.find("segments");
    if (!value) return {64, 32};
    if (value->kind != JsonValue::Kind::array) {
        const int around = keys.integer("segments", kFewestSegments, kMostSegments);
        return {around, std::max(kFewestSegments, around / 2)};
    }
    const dvec2 both = keys.pair("segments", Range::between(kFewestSegments, kMostSegments));
    if (both != glm::floor(both)) keys.fail("segments", "are not whole; write whole numbers such as [64, 32]");
    return ivec2(both);
}

ShapeRequest readTorus(const JsonObject& keys, const Range& length) {
    const dvec2 radii = keys.pair("radii", length);
    if (!(radii.y < radii.x))
        keys.fail("radii", "are [major, minor] = [" + numberText(radii.x) + ", " + numberText(radii.y) +
                               "]; the minor radius must be smaller, else the torus cuts itself");
    const ivec2 segments = torusSegments(keys);
    return {identity("torus", {radii.x, radii.y, double(segments.x), double(segments.y)}),
            2 * product(segments.x, segments.y), [=] { return makeTorus(radii.x, radii.y, segments); }};
}

} // namespace

ShapeRequest readShape(const SceneReading& reading, const JsonObject& keys) {
    const std::string kind = keys.text("shape");
    const Range length = reading.length();
    if (kind == "quad") {
        const dvec2 size = keys.pair("size", length);
        return {identity(kind, {size.x, size.y}), 2, [=] { return makeQuad(size); }};
    }
    if (kind == "box") {
        const dvec3 size = keys.vector("size", length);
        return {identity(kind, {size.x, size.y, size.z}), 12, [=] { return makeBox(size); }};
    }
    if (kind == "sphere") {
        const double radius = keys.number("radius", length);
        const int segments = keys.integer("segments", kFewestSegments, kMostSegments, 64);
        const int bands = std::max(2, segments / 2);
        return {identity(kind, {radius, double(segments)}), 2 * product(segments, bands - 1),
                [=] { return makeSphere(radius, segments); }};
    }
    return readTorus(keys, length);
}

} // namespace shadowlab::scene
