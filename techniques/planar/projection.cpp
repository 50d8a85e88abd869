// SPDX-License-Identifier: MIT
#include "techniques/planar/projection.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::planar {

namespace {

// A light lower than this share of its distance from the far end of the plane counts as in the plane: it would graze it at
// a three hundredth of a second of arc, and light it with a hundred millionth of its intensity.
constexpr double kGrazing = 1.0 / (1 << 26);

} // namespace

dvec4 Projection::weightRow(const dmat4& viewFromMesh) const {
    return dvec4(0, 0, 0, 1) - lightView.w / lightHeight * heightRow(viewFromMesh);
}

dvec4 planeOf(const FlatFace& face, const dmat4& spaceFromMesh) {
    const dvec3 normal = transformNormal(spaceFromMesh, face.normalMesh);
    return {normal, -glm::dot(normal, transformPoint(spaceFromMesh, face.pointMesh))};
}

double reachOf(const dvec4& lightView, const std::array<dvec3, 4>& frameView) {
    if (lightView.w <= 0) return 1;
    double reach = 0;
    for (const dvec3& corner : frameView)
        reach = std::max(reach, glm::length(dvec3(lightView) - corner));
    return reach;
}

std::optional<Projection> projectOnto(const dvec4& planeView, const dvec4& lightView, double reach) {
    Projection projection;
    projection.lightView = lightView;
    projection.lightHeight = glm::dot(planeView, lightView);
    if (std::abs(projection.lightHeight) <= kGrazing * reach) return std::nullopt;
    const double side = projection.lightHeight > 0 ? 1 : -1;
    projection.planeView = side * planeView;
    projection.lightHeight *= side;
    projection.flattenedFromView =
        dmat4(1.0) - glm::outerProduct(lightView, projection.planeView) / projection.lightHeight;
    return projection;
}

double contactHeight(const Projection& projection, const gl::EyeMatrices& eye, const dmat4& viewFromMesh,
                     const dvec3& farthestMesh, double unevenness) {
    constexpr double kFloats =
        1.0 / (1 << 21);               // four products and three sums on the graphics card, and one bit to spare
    constexpr double kDoubles = 1e-14; // some 50 roundings on the way to view space, of what is largest there
    const dvec4 terms = glm::abs(projection.heightRow(viewFromMesh)) * dvec4(farthestMesh, 1.0);
    const double reach = glm::length(dvec3(eye.viewFromWorld[3])) + glm::length(dvec3(viewFromMesh[3])) +
                         std::abs(projection.planeView.w) + terms.x + terms.y + terms.z;
    return unevenness + kFloats * (terms.x + terms.y + terms.z + terms.w) + kDoubles * reach;
}

bool mayShadow(const scene::Bounds& box, const gl::EyeMatrices& eye, const Projection& projection, double contact,
               const std::array<dvec3, 4>& frameView) {
    // A linear function that is negative at all eight corners is negative in the whole box, also for homogeneous points.
    dvec4 flattened[8];
    double highest = -1e300;
    for (int i = 0; i < 8; ++i) {
        const dvec4 corner = eye.viewFromWorld * dvec4(box.corner(i), 1.0);
        highest = std::max(highest, glm::dot(projection.planeView, corner));
        flattened[i] = projection.flattenedFromView * corner;
    }
    if (highest <= contact) return false; // below the plane, or part of it
    constexpr double kMargin = 1e-6;      // so that rounding does not cull what grazes a border
    const auto allOutside = [&](const dvec4& border) {
        return std::ranges::all_of(flattened, [&](const dvec4& point) {
            const dvec4 terms = glm::abs(border * point);
            return glm::dot(border, point) < -kMargin * (terms.x + terms.y + terms.z + terms.w);
        });
    };
    if (allOutside({0, 0, 0, 1})) return false; // beyond the light
    // The borders of the picture: left, right, bottom, top, near.
    for (const dvec4& border :
         {dvec4(1, 0, 0, 1), dvec4(-1, 0, 0, 1), dvec4(0, 1, 0, 1), dvec4(0, -1, 0, 1), dvec4(0, 0, 1, 1)})
        if (allOutside(border * eye.clipFromView)) return false;
    // The four edges of the frame: half spaces through them, their inside where the opposite corner is.
    for (std::size_t i = 0; i < 4; ++i) {
        // With a sheared object the frame is no rectangle, so the inward direction is made perpendicular to the edge.
        const dvec3 along = glm::normalize(frameView[(i + 1) % 4] - frameView[i]);
        const dvec3 across = frameView[(i + 3) % 4] - frameView[i];
        const dvec3 inward = glm::normalize(across - along * glm::dot(across, along));
        if (allOutside({inward, -glm::dot(inward, frameView[i])})) return false;
    }
    return true;
}

} // namespace shadowlab::planar
