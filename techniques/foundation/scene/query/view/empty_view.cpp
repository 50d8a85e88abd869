// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/view/empty_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/query/rough_number.h"
#include "techniques/foundation/scene/query/view/clip_polygon.h"

namespace shadowlab::scene {

namespace {

/// Of an object, or of a triangle: the last that holds is closest to being seen.
enum class Unseen { behind, beside, tooNear, tooSmall };
constexpr std::size_t kReasons = 4;

// In clip coordinates of a perspective projection w is the depth.
const std::array kSides{dvec4(1, 0, 0, 1), dvec4(-1, 0, 0, 1), dvec4(0, 1, 0, 1), dvec4(0, -1, 0, 1)};
const dvec4 kBeforeEye(0, 0, 0, 1), kBeyondNear(0, 0, 1, 1);

/// What is found out about all objects on the way.
struct Found {
    std::array<std::size_t, kReasons> objects{};                   ///< how many for each reason
    double farthestTooNear = 0;                                    ///< metres along the axis, within the field of view
    double largest = 0;                                            ///< pixels, of what is too small
    double nearestSmall = std::numeric_limits<double>::infinity(); ///< metres along the axis
};

class View {
public:
    View(const Camera& camera, ivec2 size)
        : size_(size),
          clipFromWorld_(clipFromView(camera, static_cast<double>(size.x) / size.y) * viewFromWorld(camera)) {}

    /// Nothing where a triangle of the object is seen.
    std::optional<Unseen> reasonOf(const Object& object) {
        const dmat4 clipFromMesh = clipFromWorld_ * worldFromMesh(object);
        std::vector<dvec4> corners;
        corners.reserve(object.mesh->positionsMesh.size());
        for (const vec3& position : object.mesh->positionsMesh)
            corners.push_back(clipFromMesh * dvec4(dvec3(position), 1.0));
        Unseen best = Unseen::behind;
        for (const uvec3& t : object.mesh->triangles) {
            const std::optional<Unseen> reason = reasonOf({corners[t.x], corners[t.y], corners[t.z]});
            if (!reason) return std::nullopt;
            best = std::max(best, *reason);
        }
        return best;
    }

    Found found;

private:
    std::optional<Unseen> reasonOf(const std::array<dvec4, 3>& triangle) {
        if (std::ranges::all_of(triangle, [](const dvec4& c) { return c.w <= 0; })) return Unseen::behind;
        for (const dvec4& side : kSides) // most of what is out of view lies beyond one side
            if (std::ranges::all_of(triangle, [&](const dvec4& c) { return glm::dot(side, c) < 0; }))
                return Unseen::beside;
        std::vector<dvec4> polygon = clippedPolygon({triangle.begin(), triangle.end()}, kBeforeEye);
        for (const dvec4& side : kSides)
            polygon = clippedPolygon(polygon, side);
        if (polygon.empty()) return Unseen::beside;
        const std::vector<dvec4> drawn = clippedPolygon(polygon, kBeyondNear);
        if (drawn.empty()) {
            for (const dvec4& corner : polygon)
                found.farthestTooNear = std::max(found.farthestTooNear, corner.w);
            return Unseen::tooNear;
        }
        if (coversACentre(drawn)) return std::nullopt;
        for (const dvec4& corner : drawn)
            found.nearestSmall = std::min(found.nearestSmall, corner.w);
        return Unseen::tooSmall;
    }

    bool coversACentre(const std::vector<dvec4>& polygonClip) {
        std::vector<dvec2> pixels;
        dvec2 lower(1e300), upper(-1e300);
        for (const dvec4& corner : polygonClip) {
            pixels.push_back((0.5 + dvec2(0.5, -0.5) * dvec2(corner) / corner.w) * dvec2(size_));
            lower = glm::min(lower, pixels.back());
            upper = glm::max(upper, pixels.back());
        }
        found.largest = std::max({found.largest, upper.x - lower.x, upper.y - lower.y});
        const dvec2 first = glm::max(glm::ceil(lower - 0.5), dvec2(0)),
                    last = glm::min(glm::floor(upper - 0.5), dvec2(size_ - 1));
        for (double y = first.y; y <= last.y; ++y)
            for (double x = first.x; x <= last.x; ++x)
                if (isInside(pixels, {x + 0.5, y + 0.5})) return true;
        return false;
    }

    /// On one side of all edges of the convex polygon.
    static bool isInside(const std::vector<dvec2>& polygon, const dvec2& point) {
        bool left = false, right = false;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const dvec2 edge = polygon[(i + 1) % polygon.size()] - polygon[i], way = point - polygon[i];
            const double side = edge.x * way.y - edge.y * way.x;
            left = left || side > 0;
            right = right || side < 0;
        }
        return left != right;
    }

    ivec2 size_;
    dmat4 clipFromWorld_;
};

Bounds boundsOf(const Scene& scene) {
    Bounds all;
    for (const Object& object : scene.objects)
        all.include(boundsWorld(object));
    return all;
}

/// "all 3 objects lie behind the camera", or how many for each reason.
std::string whereTheyAre(const Found& found, std::size_t count, const Camera& camera) {
    const std::array<std::string, kReasons> one{"lies behind the camera", "lies outside of its field of view",
                                                "is nearer than its near plane, " + numberText(camera.near) + " m",
                                                "is too small to cover a pixel's centre"};
    const std::array<std::string, kReasons> many{"lie behind the camera", "lie outside of its field of view",
                                                 "are nearer than its near plane, " + numberText(camera.near) + " m",
                                                 "are too small to cover a pixel's centre"};
    std::string text;
    for (std::size_t reason = 0; reason < kReasons; ++reason) {
        const std::size_t objects = found.objects[reason];
        if (objects == 0) continue;
        if (objects == count)
            return count == 1 ? "the only object " + one[reason]
                              : "all " + std::to_string(count) + " objects " + many[reason];
        text +=
            (text.empty() ? "" : ", ") + std::to_string(objects) + " " + (objects == 1 ? one[reason] : many[reason]);
    }
    return "of " + std::to_string(count) + " objects " + text;
}

std::string remedy(const Found& found, const Scene& scene, const Camera& camera) {
    const Bounds all = boundsOf(scene);
    const dvec3 middle = 0.5 * (all.lowerWorld + all.upperWorld);
    const double size = glm::length(all.upperWorld - all.lowerWorld);
    const auto has = [&](Unseen reason) { return found.objects[static_cast<std::size_t>(reason)] > 0; };
    if (has(Unseen::tooNear)) // with some room before the farthest part
        return "set the camera's \"near\" to less than " + roughNumber(found.farthestTooNear) + ", for example to " +
               roughNumber(0.1 * found.farthestTooNear);
    if (has(Unseen::tooSmall)) {
        constexpr double kPixels = 100; // to be looked at
        const double times = kPixels / std::max(found.largest, 1e-6);
        return "the largest triangle is " + roughNumber(found.largest) + " pixels across, " +
               roughNumber(found.nearestSmall) + " m away; go " + roughNumber(times) + " times nearer to " +
               roughPlace(middle, size) + ", or choose a smaller \"fovYDegrees\"";
    }
    const dvec3 toMiddle = middle - camera.positionWorld, ahead = camera.targetWorld - camera.positionWorld;
    const double lengths = glm::length(toMiddle) * glm::length(ahead);
    const double degrees =
        lengths > 0 ? glm::degrees(std::acos(glm::clamp(glm::dot(toMiddle, ahead) / lengths, -1.0, 1.0))) : 0;
    return "turn it: the middle of the scene is " + roughNumber(degrees) +
           " degrees off its line of sight, at \"target\": " + roughPlace(middle, size) +
           (has(Unseen::beside) ? ", or choose a larger \"fovYDegrees\"" : "");
}

} // namespace

std::string whyNothingIsSeen(const Scene& scene, const Camera& camera, ivec2 size) {
    if (scene.objects.empty()) return "the scene has no objects; add some under \"objects\"";
    View view(camera, size);
    for (const Object& object : scene.objects) {
        const std::optional<Unseen> reason = view.reasonOf(object);
        if (!reason) return {};
        ++view.found.objects[static_cast<std::size_t>(*reason)];
    }
    return whereTheyAre(view.found, scene.objects.size(), camera) + "; " + remedy(view.found, scene, camera);
}

} // namespace shadowlab::scene
