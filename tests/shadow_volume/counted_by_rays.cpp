// SPDX-License-Identifier: MIT
#include "tests/shadow_volume/counted_by_rays.h"

#include <memory>

#include "techniques/foundation/scene/query/facing.h"
#include "techniques/foundation/scene/query/topology/mesh_topology.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::testing {

namespace {

// In units of the way from the eye to the point, which is known to about 2^-50 of the coordinates: nearer is contact.
constexpr double kContact = 1e-9;

constexpr int kEvery = 4;

dvec3 cornerWorld(const scene::Object& object, std::uint32_t vertex) {
    return transformPoint(scene::worldFromMesh(object), dvec3(object.mesh->positionsMesh[vertex]));
}

/// The side that runs b -> a along the caster's edge, or the other way round.
void addSide(VolumeFaces& faces, dvec3 a, dvec3 b, const Far& far, int sign) {
    if (sign == 0) return;
    if (sign < 0) std::swap(a, b);
    faces.push_back({dvec4(b, 1), dvec4(a, 1), far(a)});
    faces.push_back({dvec4(b, 1), far(a), far(b)});
}

void addCaps(VolumeFaces& faces, const scene::Scene& scene, std::size_t o, std::uint32_t t, const Far& far, int sign) {
    if (sign == 0) return;
    const scene::Object& object = scene.objects[o];
    const uvec3 corners = object.mesh->triangles[t];
    const dvec3 a = cornerWorld(object, corners.x);
    dvec3 b = cornerWorld(object, corners.y), c = cornerWorld(object, corners.z);
    if (sign < 0) std::swap(b, c);
    faces.push_back({dvec4(a, 1), dvec4(b, 1), dvec4(c, 1), static_cast<std::uint32_t>(o), t});
    faces.push_back({far(a), far(c), far(b)});
}

/// +1 where the ray leaves through the face, -1 where it enters, 0 where it misses. `at`: of the way along the direction.
int crossing(const VolumeFace& face, const dvec3& origin, const dvec3& direction, double& at) {
    const auto seen = [&](const dvec4& corner) { return dvec3(corner) - corner.w * origin; };
    const dvec3 a = seen(face.a), b = seen(face.b), c = seen(face.c);
    const double u = glm::dot(direction, glm::cross(b, c)), v = glm::dot(direction, glm::cross(c, a));
    const double w = glm::dot(direction, glm::cross(a, b)), determinant = glm::dot(a, glm::cross(b, c));
    const bool leaves = determinant > 0;
    if (determinant == 0 || (leaves ? u < 0 || v < 0 || w < 0 : u > 0 || v > 0 || w > 0)) return 0;
    at = determinant / (u * face.a.w + v * face.b.w + w * face.c.w); // infinite where the face is
    return leaves ? 1 : -1;
}

template <typename Count>
RayCounts overPixels(const JudgedPicture& picture, const Count& count) {
    RayCounts sum;
    for (int y = 0; y < picture.size().y; y += kEvery)
        for (int x = 0; x < picture.size().x; x += kEvery) {
            using enum trace::Visibility;
            const trace::Visibility truth = picture.truth(x, y);
            if (truth != lit && truth != shadowed) continue;
            ++(truth == lit ? sum.lit : sum.shadowed);
            const bool dark = count(*picture.hit(x, y)) != 0;
            sum.wrong += dark == (truth == lit) && !picture.isTie(x, y);
        }
    return sum;
}

} // namespace

SideOf oneSign(const scene::Scene& scene, const scene::Light& light) {
    auto signs = std::make_shared<std::vector<std::vector<std::int8_t>>>();
    for (const scene::Object& object : scene.objects)
        signs->push_back(scene::facingSigns(object, light));
    return [signs](std::size_t object, std::uint32_t triangle, int) { return int{(*signs)[object][triangle]}; };
}

SideOf signsInFloat(const scene::Scene& scene, const scene::Light& light) {
    const vec4 toLight(scene::homogeneousPositionWorld(light));
    return [&scene, toLight](std::size_t object, std::uint32_t triangle, int use) {
        const scene::Object& source = scene.objects[object];
        const auto corner = [&](int i) { return vec3(cornerWorld(source, source.mesh->triangles[triangle][i % 3])); };
        const vec3 normal = glm::cross(corner(use + 1) - corner(use), corner(use + 2) - corner(use));
        return glm::dot(normal, vec3(toLight) - toLight.w * corner(use)) > 0 ? 1 : -1;
    };
}

Far awayFrom(const scene::Light& light) {
    const dvec4 lightWorld = scene::homogeneousPositionWorld(light);
    return [lightWorld](const dvec3& p) { return dvec4(p * lightWorld.w - dvec3(lightWorld), 0); };
}

VolumeFaces prisms(const scene::Scene& scene, const SideOf& sideOf, const Far& far) {
    VolumeFaces faces;
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const scene::Object& object = scene.objects[o];
        for (std::uint32_t t = 0; t < object.mesh->triangles.size(); ++t) {
            const uvec3 corners = object.mesh->triangles[t];
            addCaps(faces, scene, o, t, far, sideOf(o, t, kCaps));
            for (int e = 0; e < 3; ++e)
                addSide(faces, cornerWorld(object, corners[e]), cornerWorld(object, corners[(e + 1) % 3]), far,
                        sideOf(o, t, e));
        }
    }
    return faces;
}

VolumeFaces betweenTwoFaces(const scene::Scene& scene, const SideOf& sideOf, const Far& far) {
    VolumeFaces faces;
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const scene::Object& object = scene.objects[o];
        const auto facesLight = [&](std::uint32_t t) { return sideOf(o, t, kCaps) > 0; };
        for (std::uint32_t t = 0; t < object.mesh->triangles.size(); ++t)
            if (facesLight(t)) addCaps(faces, scene, o, t, far, 1);
        const scene::MeshTopology topology = scene::buildTopology(*object.mesh);
        for (const scene::Edge& edge : topology.edges) {
            const scene::EdgeUse* use = &topology.uses[edge.firstUse];
            if (edge.useCount != 2 || facesLight(use[0].triangle) == facesLight(use[1].triangle)) continue;
            const scene::EdgeUse& front = facesLight(use[0].triangle) ? use[0] : use[1];
            addSide(faces, cornerWorld(object, edge.a), cornerWorld(object, edge.b), far, front.direction);
        }
    }
    return faces;
}

RayCounts countedBehind(const JudgedPicture& picture, const VolumeFaces& faces) {
    const dvec3 eyeWorld = picture.snapshot()->camera.positionWorld;
    return overPixels(picture, [&](const trace::EyeHit& hit) {
        int count = 0;
        double at = 0;
        for (const VolumeFace& face : faces) {
            if (face.object == hit.object && face.triangle == hit.triangle) {
                --count; // the cap on the point itself: its depth is not less, so it fails and counts
                continue;
            }
            const int sign = crossing(face, hit.positionWorld, hit.positionWorld - eyeWorld, at);
            if (sign != 0 && !(at < kContact)) count += sign;
        }
        return count;
    });
}

RayCounts countedBefore(const JudgedPicture& picture, const VolumeFaces& faces, int start) {
    const dvec3 eyeWorld = picture.snapshot()->camera.positionWorld;
    return overPixels(picture, [&](const trace::EyeHit& hit) {
        int count = start;
        double at = 0;
        for (const VolumeFace& face : faces)
            if (const int sign = crossing(face, eyeWorld, hit.positionWorld - eyeWorld, at);
                sign != 0 && at > 0 && at < 1 - kContact)
                count -= sign;
        return count;
    });
}

} // namespace shadowlab::testing
