// How a volume's sketch is drawn: what is farther away first, and what lies beyond a floor under it.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/figures/inks.h"
#include "app/figures/panels.h"
#include "app/figures/volume/volume_sketch.h"
#include "techniques/foundation/base/look.h"
#include "techniques/foundation/scene/query/view/clip_polygon.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::figures {

namespace {

constexpr std::size_t kMostLines = 48; ///< between quadrilaterals: of more nothing else is seen
constexpr const char* kReceiver = "#e4e4e4";
constexpr const char* kShadow = "#4a4a4a";
constexpr const char* kCurve = "#1a1a1a";

std::string sideColor() { return drawing::colorText(look::kVolumeSide); }

} // namespace

bool VolumeSketch::showsOutside(const Strip& strip) const {
    // Outside an outline edge runs b, a, a', b' counter-clockwise; a mirrored caster's the other way round.
    return view_->showsFront({strip.fromWorld[1], strip.fromWorld[0], strip.toWorld[0]}) !=
           scene::isMirrored(*solid_.object);
}

void VolumeSketch::drawReceivers(drawing::Drawing& drawing) const {
    struct Part {
        double depth;
        std::vector<dvec3> corners;
        double light;
    };
    std::vector<Part> flat, standing; // large ones, which are cut off, lie below what stands on them
    for (std::size_t o = 0; o < scene_.objects.size(); ++o) {
        if (o == solid_.caster->object) continue;
        const scene::Bounds box = scene::boundsWorld(scene_.objects[o]);
        const bool meets = glm::all(glm::lessThan(box.lowerWorld, shownWorld_.upperWorld)) &&
                           glm::all(glm::greaterThan(box.upperWorld, shownWorld_.lowerWorld));
        if (!meets) continue;
        const bool isLarge = glm::length(box.upperWorld - box.lowerWorld) >
                             0.6 * glm::length(shownWorld_.upperWorld - shownWorld_.lowerWorld);
        for (const Triangle& triangle : others_) {
            if (triangle.object != o) continue;
            std::vector<dvec4> polygon;
            for (const dvec3& corner : triangle.cornersWorld)
                polygon.emplace_back(corner, 1.0);
            for (int axis = 0; isLarge && axis < 3; ++axis)
                for (const double side : {1.0, -1.0}) {
                    dvec4 plane(0.0);
                    plane[axis] = side;
                    plane.w = side > 0 ? -shownWorld_.lowerWorld[axis] : shownWorld_.upperWorld[axis];
                    polygon = scene::clippedPolygon(polygon, plane);
                }
            if (polygon.size() < 3) continue;
            Part part{0, {}, 0};
            for (const dvec4& corner : polygon) {
                part.corners.emplace_back(corner);
                part.depth += view_->depth(dvec3(corner)) / static_cast<double>(polygon.size());
            }
            const CasterSolid::Corners& c = triangle.cornersWorld;
            const dvec3 normal = glm::normalize(glm::cross(c[1] - c[0], c[2] - c[0]));
            part.light = std::abs(normal.y);
            (isLarge ? flat : standing).push_back(std::move(part));
        }
    }
    drawBeyond(drawing);
    for (std::vector<Part>* parts : {&flat, &standing}) {
        std::ranges::stable_sort(*parts, std::greater<>(), &Part::depth);
        for (const Part& part : *parts) {
            std::vector<dvec2> triangles;
            for (std::size_t i = 2; i < part.corners.size(); ++i)
                for (const dvec3& corner : {part.corners[0], part.corners[i - 1], part.corners[i]})
                    triangles.push_back((*view_)(corner));
            const std::string color = part.light > 0.7 ? kReceiver : part.light > 0.3 ? "#d2d2d2" : "#c4c4c4";
            drawing.surface(triangles, color, parts == &flat ? 0.6 : 1);
        }
    }
    std::vector<dvec2> shadow;
    for (const dvec3& place : shadowWorld_)
        shadow.push_back((*view_)(place));
    drawing.surface(shadow, kShadow, 0.55);
}

/// What of the sides is past what they meet first, and the end of it.
void VolumeSketch::drawBeyond(drawing::Drawing& drawing) const {
    if (curveWorld_.empty()) return;
    drawing.beginClip(area_.corner, area_.size);
    drawBottom(drawing, 0.8);
    std::vector<dvec2> beyond, lines;
    for (const Strip& strip : strips_) {
        if (!strip.hits[0] || !strip.hits[1]) continue;
        const dvec2 a = (*view_)(strip.hits[0]->placeWorld), b = (*view_)(strip.hits[1]->placeWorld),
                    c = (*view_)(strip.toWorld[1]), d = (*view_)(strip.toWorld[0]);
        beyond.insert(beyond.end(), {a, b, c, a, c, d});
    }
    drawing.surface(beyond, sideColor(), 0.35);
    drawing.endClip();
}

void VolumeSketch::drawBottom(drawing::Drawing& drawing, double opacity) const {
    const auto n = static_cast<std::uint32_t>(solid_.verticesWorld.size());
    std::vector<dvec2> bottom, rim;
    for (const std::uint32_t index : solid_.caster->bottomCap)
        bottom.push_back((*view_)(drawnEnd(index % n)));
    for (const Strip& strip : strips_)
        rim.insert(rim.end(), {(*view_)(strip.toWorld[0]), (*view_)(strip.toWorld[1])});
    if (isCutOff_) return;
    drawing.surface(bottom, drawing::colorText(look::kBottomCap), opacity);
    drawing.segments(rim, {drawing::colorText(look::kBottomCap), 2.5, false});
}

void VolumeSketch::drawStrips(drawing::Drawing& drawing, bool front, double opacity) const {
    std::vector<dvec2> before, lines;
    std::size_t border = 0;
    const std::size_t every = 1 + solid_.caster->outline.size() / kMostLines;
    for (const Strip& strip : strips_) {
        if (showsOutside(strip) != front) continue;
        std::array<dvec2, 2> from{}, to{};
        for (std::size_t end = 0; end < 2; ++end) {
            from[end] = (*view_)(strip.fromWorld[end]);
            to[end] = (*view_)(strip.hits[end] ? strip.hits[end]->placeWorld : strip.toWorld[end]);
        }
        before.insert(before.end(), {from[0], from[1], to[1], from[0], to[1], to[0]});
        if (strip.isBorder && border++ % every == 0) lines.insert(lines.end(), {from[0], to[0]});
    }
    drawing.surface(before, sideColor(), opacity);
    drawing.segments(lines, {paleColor(look::kVolumeSide, 0.25), 1.5, false});
}

void VolumeSketch::drawVolume(drawing::Drawing& drawing, drawing::Labels& labels, double paleness, double opacity) const {
    if (curveWorld_.empty()) drawBottom(drawing, opacity);
    drawStrips(drawing, false, 0.7 * opacity);
    std::vector<std::size_t> all(solid_.triangles());
    for (std::size_t t = 0; t < all.size(); ++t)
        all[t] = t;
    drawTriangles(drawing, *view_, solid_, all, capColors(paleness));
    drawStrips(drawing, true, opacity);
    std::vector<dvec2> curve, outline;
    for (const dvec3& place : curveWorld_)
        curve.push_back((*view_)(place));
    for (const Strip& strip : strips_)
        outline.insert(outline.end(), {(*view_)(strip.fromWorld[0]), (*view_)(strip.fromWorld[1])});
    drawing.segments(curve, {kCurve, 5, false});
    drawing.segments(outline, {drawing::colorText(look::kSilhouette), 6, false});
    for (const std::vector<dvec2>* lines : {&curve, &outline})
        for (std::size_t i = 0; i + 1 < lines->size(); i += 2)
            labels.avoid((*lines)[i], (*lines)[i + 1]);
}

void VolumeSketch::drawLight(drawing::Drawing& drawing, drawing::Labels& labels, bool withRays) const {
    const dvec2 light = (*view_)(lightWorld_);
    if (withRays) {
        // The two rays between which the caster lies, as it is seen.
        std::array<const dvec3*, 2> borders{};
        for (const Strip& strip : strips_)
            for (std::size_t side = 0; side < 2; ++side) {
                const auto turn = [&](const dvec3& place) {
                    const dvec2 way = (*view_)(place)-light, axis = (*view_)(solid_.verticesWorld.front()) - light;
                    return (axis.x * way.y - axis.y * way.x) / glm::length(way) * (side ? -1 : 1);
                };
                if (!borders[side] || turn(strip.fromWorld[0]) > turn(*borders[side]))
                    borders[side] = strip.fromWorld.data();
            }
        for (const dvec3* border : borders)
            if (border) {
                const dvec2 from = lightIsNear_ ? light : light + (*view_)(*border) - (*view_)(solid_.centre(0));
                drawing.line(lightIsNear_ ? light : from, (*view_)(*border), {ink::kLight, 2, true});
                labels.avoid(from, (*view_)(*border));
            }
    }
    drawLightSign(drawing, labels, *view_, lightWorld_, " light source");
}

void VolumeSketch::nameParts(drawing::Drawing& drawing, drawing::Labels& labels) const {
    const VolumeProbe::Caster& caster = *solid_.caster;
    const auto n = static_cast<std::uint32_t>(solid_.verticesWorld.size());
    const drawing::TextStyle style{.size = kHeading, .isBold = true};
    // The top cap by its highest corner, which no side hides.
    const auto onSheet = [&](std::uint32_t index) {
        return (*view_)(index < n ? solid_.verticesWorld[index] : drawnEnd(index - n));
    };
    const auto higher = [&](std::uint32_t a, std::uint32_t b) { return onSheet(a).y < onSheet(b).y; };
    if (!caster.topCap.empty())
        labels.place(drawing, onSheet(*std::ranges::min_element(caster.topCap, higher)), "top cap", style, 12);
    if (!isCutOff_ && curveWorld_.empty() && !caster.bottomCap.empty())
        labels.place(drawing, onSheet(*std::ranges::max_element(caster.bottomCap, higher)), "bottom cap", style, 12);
    // A side where it is seen widest, half way down.
    const Strip* widest = nullptr;
    double most = 0;
    for (const Strip& strip : strips_) {
        const double width = glm::length((*view_)(strip.fromWorld[1]) - (*view_)(strip.fromWorld[0]));
        if (!showsOutside(strip) || width <= most) continue;
        most = width;
        widest = &strip;
    }
    if (widest) {
        const dvec3 end = widest->hits[0] ? widest->hits[0]->placeWorld : widest->toWorld[0];
        labels.place(drawing, (*view_)(glm::mix(widest->fromWorld[0], end, 0.5)), "side", style, 60);
    }
    if (!curveWorld_.empty()) {
        const dvec3 lowest =
            *std::ranges::max_element(curveWorld_, {}, [&](const dvec3& place) { return (*view_)(place).y; });
        labels.place(drawing, (*view_)(lowest), "intersection with " + receiver_, style, 14);
    }
    if (!strips_.empty()) {
        const auto leftmost =
            std::ranges::min_element(strips_, {}, [&](const Strip& strip) { return (*view_)(strip.fromWorld[0]).x; });
        labels.place(drawing, (*view_)(leftmost->fromWorld[0]), "object outline", style, 14);
    }
}

} // namespace shadowlab::figures
