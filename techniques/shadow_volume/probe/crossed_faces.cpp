// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/probe/crossed_faces.h"

#include <algorithm>
#include <limits>
#include <span>

namespace shadowlab::shadow_volume {

namespace {

// Directions of the infinitesimal shift (simulation of simplicity): any that are parallel to nothing in a typical scene.
constexpr dvec3 kAsideWorld{0.5413, 0.3117, 0.7809}, kFurtherAsideWorld{-0.2903, 0.8747, 0.3881};

/// The line, with the eye as the origin, against homogeneous points. There is no division by w, so points at infinity need
/// no special case.
struct Walk {
    const EyeLine& line;

    [[nodiscard]] dvec3 fromEye(const dvec4& cornerWorld) const {
        return dvec3(cornerWorld) - line.eyeWorld * cornerWorld.w;
    }
    /// On which side the line passes the edge from p to q; exactly the opposite for the edge from q to p.
    [[nodiscard]] bool isLeftOf(const dvec3& p, const dvec3& q) const {
        const dvec3 normal = glm::cross(p, q);
        for (const dvec3& direction : {line.directionWorld, kAsideWorld, kFurtherAsideWorld})
            if (const double side = glm::dot(direction, normal); side != 0) return side > 0;
        return false;
    }
    /// Metres to where the line meets the face, which it passes within its three edges; negative behind the eye.
    [[nodiscard]] double distance(const std::array<dvec3, 3>& p, const std::array<dvec4, 3>& cornersWorld) const {
        dvec3 place(0.0);
        double weight = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double share = glm::dot(line.directionWorld, glm::cross(p[(i + 1) % 3], p[(i + 2) % 3]));
            place += share * p[i];
            weight += share * cornersWorld[i].w;
        }
        const double along = glm::dot(place, line.directionWorld);
        if (weight != 0) return along / weight;
        // All corners are at infinity: the shares' sign is that of the side the line passes on.
        const bool forward = (along > 0) == isForward(p);
        return forward ? std::numeric_limits<double>::infinity() : -1;
    }

private:
    [[nodiscard]] bool isForward(const std::array<dvec3, 3>& p) const {
        return glm::dot(line.directionWorld, glm::cross(p[1], p[2])) +
                   glm::dot(line.directionWorld, glm::cross(p[2], p[0])) +
                   glm::dot(line.directionWorld, glm::cross(p[0], p[1])) >
               0;
    }
};

bool sameCorners(const uvec3& t, const std::uint32_t* corners, std::uint32_t shift) {
    std::array<std::uint32_t, 3> a{t.x, t.y, t.z}, b{corners[0] - shift, corners[1] - shift, corners[2] - shift};
    std::ranges::sort(a);
    std::ranges::sort(b);
    return a == b;
}

} // namespace

std::vector<CrossedFace> crossedFaces(const scene::Scene& scene, const CasterVolume& caster, const VolumeEnd& end,
                                      const scene::Light& light, const EyeLine& line) {
    const scene::Object& object = scene.objects[caster.object];
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    const bool mirrored = scene::isMirrored(object);
    const std::vector<vec3>& positionsMesh = object.mesh->positionsMesh;
    std::vector<dvec4> cornersWorld;
    cornersWorld.reserve(2 * positionsMesh.size());
    for (const vec3& positionMesh : positionsMesh)
        cornersWorld.emplace_back(transformPoint(worldFromMesh, dvec3(positionMesh)), 1.0);
    for (std::size_t v = 0; v < positionsMesh.size(); ++v)
        cornersWorld.push_back(pushedWorld(dvec3(cornersWorld[v]), light, end));

    const Walk walk{line};
    std::vector<dvec3> fromEye;
    fromEye.reserve(cornersWorld.size());
    for (const dvec4& corner : cornersWorld)
        fromEye.push_back(walk.fromEye(corner));

    std::vector<CrossedFace> crossed;
    const auto cross = [&](CrossedFace::Part part, std::span<const std::uint32_t> list) {
        for (std::size_t i = 0; i + 2 < list.size(); i += 3) {
            const std::array<dvec3, 3> p{fromEye[list[i]], fromEye[list[i + 1]], fromEye[list[i + 2]]};
            const bool left = walk.isLeftOf(p[0], p[1]);
            if (walk.isLeftOf(p[1], p[2]) != left || walk.isLeftOf(p[2], p[0]) != left) continue;
            CrossedFace face{
                .part = part,
                .triangle = i / 3,
                .cornersWorld = {cornersWorld[list[i]], cornersWorld[list[i + 1]], cornersWorld[list[i + 2]]}};
            face.distance = walk.distance(p, face.cornersWorld);
            if (face.distance <= 0) continue;
            // Counter-clockwise from outside the volume, but for the reversed cap; all the other way round in a mirror.
            const bool counterClockwise = !left;
            face.facesEye = (counterClockwise != (part == CrossedFace::Part::topCapReversed)) != mirrored;
            crossed.push_back(face);
        }
    };
    // Of a direction at infinity all far vertices are one point: half of the sides are nothing, and so is the cap there.
    const bool toOnePoint = !end.planeWorld && !end.distance && scene::homogeneousPositionWorld(light).w == 0;
    const std::span sides(caster.volume.sides);
    cross(CrossedFace::Part::side, toOnePoint ? sides.first(sides.size() / 2) : sides);
    if (!toOnePoint) cross(CrossedFace::Part::bottomCap, caster.volume.bottomCap);
    cross(CrossedFace::Part::topCap, caster.volume.topCap);
    cross(CrossedFace::Part::topCapReversed, caster.volume.topCapReversed);
    return crossed;
}

const SilhouetteEdge& edgeOfSide(const CasterVolume& caster, std::size_t triangle) {
    // The first halves of all quads, then the second ones, each edge as often as it is extruded.
    std::size_t quad = triangle % (caster.volume.sides.size() / 6);
    for (const SilhouetteEdge& edge : caster.silhouette) {
        if (quad < edge.multiplicity) return edge;
        quad -= edge.multiplicity;
    }
    return caster.silhouette.back();
}

std::uint32_t triangleOfCap(const CasterVolume& caster, CrossedFace::Part part, std::size_t triangle) {
    const scene::Mesh& mesh = *caster.mesh->mesh;
    const bool bottom = part == CrossedFace::Part::bottomCap;
    const std::vector<std::uint32_t>& list = bottom                              ? caster.volume.bottomCap
                                             : part == CrossedFace::Part::topCap ? caster.volume.topCap
                                                                                 : caster.volume.topCapReversed;
    const auto shift = static_cast<std::uint32_t>(bottom ? mesh.positionsMesh.size() : 0);
    // Triangles stand in a cap in the mesh's order: of two with the same corners the one that is as far along.
    std::size_t sameBefore = 0;
    for (std::size_t i = 0; i < triangle; ++i) {
        const uvec3 other{list[3 * i] - shift, list[3 * i + 1] - shift, list[3 * i + 2] - shift};
        sameBefore += sameCorners(other, &list[3 * triangle], shift);
    }
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const bool thatSide = bottom || (part == CrossedFace::Part::topCap) == (caster.facing[t] > 0);
        if (!thatSide || (!bottom && caster.facing[t] == 0)) continue;
        if (sameCorners(mesh.triangles[t], &list[3 * triangle], shift) && sameBefore-- == 0) return t;
    }
    return 0;
}

} // namespace shadowlab::shadow_volume
