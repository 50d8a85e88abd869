// SPDX-License-Identifier: MIT
#include "techniques/planar/flattening.h"

#include <algorithm>

namespace shadowlab::planar {

namespace {

constexpr scene::PicturePart kNowhere{dvec2(1.0), dvec2(-1.0)};

/// The part of the picture in which the shadow of a box can fall; all of it, where the shadow reaches to infinity or behind
/// the eye.
scene::PicturePart partOfShadow(const scene::Bounds& box, const gl::EyeMatrices& eye, const Projection& projection) {
    scene::PicturePart part = kNowhere;
    for (int i = 0; i < 8; ++i) {
        const dvec4 flattened = projection.flattenedFromView * (eye.viewFromWorld * dvec4(box.corner(i), 1.0));
        const dvec4 clip = eye.clipFromView * flattened;
        // Less than a thousandth of the weight of what it is made of: as good as infinitely far away.
        if (flattened.w < 1e-3 || clip.w < 1e-3 * std::abs(clip.z)) return {};
        part.lower = glm::min(part.lower, dvec2(clip) / clip.w);
        part.upper = glm::max(part.upper, dvec2(clip) / clip.w);
    }
    return part;
}

scene::PicturePart common(const scene::PicturePart& a, const scene::PicturePart& b) {
    return {glm::max(a.lower, b.lower), glm::min(a.upper, b.upper)};
}

/// Do light and receiver lie on one side of a face of the box, and the box on the other? Then nothing in it is between them.
/// So a floor casts nothing on what stands on it, and not even rounding can put a shadow where they touch.
bool isApart(const scene::Bounds& box, const std::array<dvec3, 4>& frameWorld, const dvec4& lightWorld,
             double contact) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            const double face = sign < 0 ? -box.lowerWorld[axis] : box.upperWorld[axis];
            const bool lightBeyond = sign * lightWorld[axis] >= lightWorld.w * (face - contact);
            if (lightBeyond && std::ranges::all_of(frameWorld, [&](const dvec3& corner) {
                    return sign * corner[axis] >= face - contact;
                }))
                return true;
        }
    return false;
}

void addCasters(LitPlane& plane, const std::vector<Caster>& casters, const gl::EyeMatrices& eye,
                const dvec4& lightWorld, const PlanarParams& params) {
    scene::PicturePart part = kNowhere;
    for (std::size_t i = 0; i < casters.size(); ++i) {
        const Caster& caster = casters[i];
        // Most of the plane's own object lies in the plane or behind it, and unclipped it would cover all of the plane.
        if (!params.clip && caster.object == plane.receiver->receiver.object) continue;
        const double contact = contactHeight(plane.projection, eye, eye.viewFromWorld * caster.worldFromCaster,
                                             caster.farthest, plane.receiver->unevenness);
        if (params.clip && isApart(caster.boundsWorld, plane.receiver->frameWorld, lightWorld, contact)) continue;
        const bool cull = params.cull && !params.mayBeAnywhere();
        if (cull && !mayShadow(caster.boundsWorld, eye, plane.projection, contact, plane.receiver->frameView)) continue;
        plane.contact = std::max(plane.contact, contact);
        ++plane.casters;
        if (caster.hasHoles)
            plane.cutOuts.push_back(i);
        else if (cull && params.once && caster.outward && !isWithin(lightWorld, caster))
            plane.frontsSuffice.add(caster);
        else
            plane.bothSides.add(caster);
        part = around(part, partOfShadow(caster.boundsWorld, eye, plane.projection));
    }
    plane.part = params.mayBeAnywhere() ? scene::PicturePart{} : common(part, plane.receiver->part);
}

} // namespace

scene::PicturePart around(const scene::PicturePart& a, const scene::PicturePart& b) {
    return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)};
}

std::vector<LitPlane> litPlanes(const std::vector<ChosenReceiver>& receivers, const std::vector<Caster>& casters,
                                const gl::EyeMatrices& eye, const dvec4& lightWorld, const PlanarParams& params,
                                bool countTurnedAway) {
    std::vector<LitPlane> planes;
    for (const ChosenReceiver& receiver : receivers) {
        LitPlane plane;
        plane.receiver = &receiver;
        const auto projection = projectOnto(receiver.planeView, eye.viewFromWorld * lightWorld, !params.clip);
        // The eye is the origin of view space. Where it sees the side that the light does not, nothing is lit.
        plane.turnedAway = !projection || projection->planeView.w <= 0;
        if (plane.turnedAway && countTurnedAway) {
            plane.part = receiver.part;
            planes.push_back(std::move(plane));
            continue;
        }
        if (!projection || (plane.turnedAway && params.cull && !params.mayBeAnywhere())) continue;
        plane.turnedAway = false;
        plane.projection = *projection;
        addCasters(plane, casters, eye, lightWorld, params);
        if (plane.casters > 0) planes.push_back(std::move(plane));
    }
    return planes;
}

} // namespace shadowlab::planar
