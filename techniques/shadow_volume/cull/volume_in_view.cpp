// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/cull/volume_in_view.h"

#include <algorithm>
#include <array>

namespace shadowlab::shadow_volume {

namespace {

/// The volume lies in the convex hull of the box's corners and their images at the end: the top cap among the former, the
/// bottom cap among the latter. An end at a distance is treated as an end at infinity, which is conservative.
std::array<dvec4, 16> hullWorld(const scene::Bounds& box, const scene::Light& light, const VolumeEnd& end) {
    const VolumeEnd straight{.planeWorld = end.planeWorld, .distance = std::nullopt};
    std::array<dvec4, 16> points;
    for (int i = 0; i < 8; ++i) {
        points[static_cast<std::size_t>(i)] = dvec4(box.corner(i), 1.0);
        points[static_cast<std::size_t>(8 + i)] = pushedWorld(box.corner(i), light, straight);
    }
    return points;
}

/// The box around homogeneous points; a point with w = 0 makes the box unbounded in its direction.
scene::Bounds boundsOf(std::span<const dvec4> points) {
    constexpr double kFarAway = 1e300;
    scene::Bounds box;
    for (const dvec4& point : points)
        if (point.w != 0) box.include(dvec3(point));
    for (const dvec4& point : points)
        for (int axis = 0; axis < 3 && point.w == 0; ++axis) {
            if (point[axis] < 0) box.lowerWorld[axis] = -kFarAway;
            if (point[axis] > 0) box.upperWorld[axis] = kFarAway;
        }
    return box;
}

scene::Bounds intersection(const scene::Bounds& a, const scene::Bounds& b) {
    return {glm::max(a.lowerWorld, b.lowerWorld), glm::min(a.upperWorld, b.upperWorld)};
}

scene::PicturePart common(const scene::PicturePart& a, const scene::PicturePart& b) {
    return {glm::max(a.lower, b.lower), glm::min(a.upper, b.upper)};
}

bool hasPoints(const scene::Bounds& box) { return glm::all(glm::lessThanEqual(box.lowerWorld, box.upperWorld)); }

/// The rectangle around the convex hull of these points in the picture; nothing if one of them is before the near plane.
std::optional<scene::PicturePart> partOf(std::span<const dvec4> pointsClip) {
    scene::PicturePart part = scene::kNowhere;
    for (const dvec4& clip : pointsClip) {
        if (clip.w <= 0 || clip.z <= -clip.w) return std::nullopt;
        const dvec2 ndc = dvec2(clip) / clip.w;
        part = around(part, {ndc, ndc});
    }
    return part;
}

/// The same for a box.
std::optional<scene::PicturePart> partOf(const scene::Bounds& box, const dmat4& clipFromWorld) {
    std::array<dvec4, 8> corners;
    for (int i = 0; i < 8; ++i)
        corners[static_cast<std::size_t>(i)] = clipFromWorld * dvec4(box.corner(i), 1.0);
    return partOf(corners);
}

// Boxes are made larger by this share of their size: rounding must not cut. Frame::scissorTo adds a pixel in the picture.
constexpr double kAroundBox = 1e-6;

} // namespace

VolumeInView volumeInView(const CasterVolume& caster, const scene::Light& light, const VolumeEnd& end,
                          const gl::EyeMatrices& eye) {
    const dmat4 clipFromWorld = eye.clipFromView * eye.viewFromWorld;
    std::array<dvec4, 16> points = hullWorld(caster.bounds, light, end);
    for (dvec4& point : points)
        point = clipFromWorld * point;
    const scene::PicturePart part = eye.part.value_or(scene::PicturePart{});
    const std::span<const dvec4> all(points);
    const bool any = scene::mayTouch(all, part);
    return {.caster = &caster,
            .end = end,
            .any = any,
            .topCap = scene::mayTouch(all.first(8), part),
            .bottomCap = end.distance ? any : scene::mayTouch(all.last(8), part),
            .part = partOf(all)};
}

void keepToReceivers(VolumeInView& volume, const scene::Light& light, std::span<const scene::Bounds> receivers,
                     const gl::EyeMatrices& eye) {
    const dmat4 clipFromWorld = eye.clipFromView * eye.viewFromWorld;
    const scene::Bounds hull = boundsOf(hullWorld(volume.caster->bounds, light, volume.end));
    scene::PicturePart all = scene::kNowhere;
    bool meets = false, known = true;
    for (const scene::Bounds& receiver : receivers) {
        const dvec3 margin(kAroundBox * glm::length(receiver.upperWorld - receiver.lowerWorld));
        const scene::Bounds met = intersection({receiver.lowerWorld - margin, receiver.upperWorld + margin}, hull);
        if (!hasPoints(met)) continue;
        meets = true;
        const std::optional<scene::PicturePart> part = partOf(met, clipFromWorld);
        known = known && part;
        if (!known) break;
        all = around(all, *part);
    }
    if (!meets) volume.any = false;
    if (!meets || !known) return;
    volume.part = volume.part ? common(*volume.part, all) : all;
}

} // namespace shadowlab::shadow_volume
