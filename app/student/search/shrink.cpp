// SPDX-License-Identifier: MIT
#include "app/student/search/shrink.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace shadowlab::student {

namespace {

/// To multiples of a step. Steps are one over a whole number: so the results are the numbers that are read from "0.1", "0.35".
dvec3 rounded(const dvec3& v, double perMetre) { return glm::round(v * perMetre) / perMetre; }

/// Four corners of a body, far from each other, and the triangles between them. Nothing where it has no more than four triangles, or is flat.
std::optional<SearchObject> tetrahedronIn(const SearchObject& body) {
    constexpr std::size_t kTriangles = 4;
    if (body.triangles.size() <= kTriangles) return std::nullopt;
    const auto farthest = [&](auto&& away) { return *std::ranges::max_element(body.cornersWorld, {}, away); };
    const dvec3 a = body.cornersWorld.front();
    const dvec3 b = farthest([&](const dvec3& p) { return glm::distance(p, a); });
    const dvec3 c = farthest([&](const dvec3& p) { return glm::length(glm::cross(b - a, p - a)); });
    const dvec3 normal = glm::cross(b - a, c - a);
    const dvec3 d = farthest([&](const dvec3& p) { return std::abs(glm::dot(normal, p - a)); });
    const double side = glm::dot(normal, d - a);
    if (side == 0) return std::nullopt;
    SearchObject simple = body;
    simple.cornersWorld = {a, b, c, d};
    simple.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    if (side < 0)
        for (uvec3& triangle : simple.triangles)
            std::swap(triangle.y, triangle.z);
    return simple;
}

class Shrinker {
public:
    Shrinker(const SearchScene& scene, const std::function<bool(const SearchScene&)>& stillFails, const std::function<bool()>& mayGoOn)
        : best_(scene), stillFails_(stillFails), mayGoOn_(mayGoOn) {}

    Shrunk run() {
        for (bool smaller = true; smaller && mayGoOn_();) {
            smaller = removeLights();
            smaller |= removeObjects();
            for (std::size_t object = 0; object < best_.objects.size(); ++object)
                if (!best_.objects[object].isWhole) smaller |= simplify(object) || removeTriangles(object);
        }
        tidyNumbers();
        return {best_, attempts_};
    }

private:
    /// Keeps a scene that still fails.
    bool take(SearchScene scene) {
        if (!mayGoOn_()) return false;
        ++attempts_;
        scene = tidied(std::move(scene));
        if (!stillFails_(scene)) return false;
        best_ = std::move(scene);
        return true;
    }

    bool removeLights() {
        bool any = false;
        for (std::size_t light = 0; light < best_.lights.size();) {
            SearchScene scene = best_;
            scene.lights.erase(scene.lights.begin() + static_cast<std::ptrdiff_t>(light));
            if (take(std::move(scene))) any = true;
            else ++light;
        }
        return any;
    }

    bool removeObjects() {
        bool any = false;
        for (std::size_t object = best_.objects.size(); object-- > 0;) {
            SearchScene scene = best_;
            scene.objects.erase(scene.objects.begin() + static_cast<std::ptrdiff_t>(object));
            any |= take(std::move(scene));
        }
        return any;
    }

    /// Puts a tetrahedron in place of a larger body: closed bodies may fail where nothing can be taken off them.
    bool simplify(std::size_t object) {
        const std::optional<SearchObject> simple = tetrahedronIn(best_.objects[object]);
        if (!simple) return false;
        SearchScene scene = best_;
        scene.objects[object] = *simple;
        return take(std::move(scene));
    }

    /// First half of them, then quarters, and at last one by one.
    bool removeTriangles(std::size_t object) {
        bool any = false;
        for (std::size_t chunk = (best_.objects[object].triangles.size() + 1) / 2; chunk > 0; chunk = chunk == 1 ? 0 : (chunk + 1) / 2) {
            for (std::size_t first = 0; object < best_.objects.size() && first < best_.objects[object].triangles.size();) {
                SearchScene scene = best_;
                std::vector<uvec3>& triangles = scene.objects[object].triangles;
                const auto begin = triangles.begin() + static_cast<std::ptrdiff_t>(first);
                triangles.erase(begin, begin + static_cast<std::ptrdiff_t>(std::min(chunk, triangles.size() - first)));
                if (triangles.empty() || !take(std::move(scene))) first += chunk;
                else any = true;
            }
        }
        return any;
    }

    /// Tries to change a scene by `change`, from the roundest numbers to finer ones.
    bool tryRound(const std::function<void(SearchScene&, double perMetre)>& change) {
        for (const double perMetre : {1.0, 2.0, 4.0, 10.0, 20.0}) {
            SearchScene scene = best_;
            change(scene, perMetre);
            if (take(std::move(scene))) return true;
        }
        return false;
    }

    void tidyNumbers() {
        SearchScene plain = best_;
        plain.fovYDegrees = 45;
        if (best_.fovYDegrees != 45) take(std::move(plain));
        for (std::size_t object = 0; object < best_.objects.size(); ++object)
            if (best_.objects[object].isMirrored) {
                SearchScene scene = best_;
                scene.objects[object].isMirrored = false;
                take(std::move(scene));
            }
        tryRound([](SearchScene& scene, double perMetre) {
            scene.eyeWorld = rounded(scene.eyeWorld, perMetre);
            scene.targetWorld = rounded(scene.targetWorld, perMetre);
        });
        for (std::size_t light = 0; light < best_.lights.size(); ++light)
            tryRound([light](SearchScene& scene, double perMetre) {
                scene.lights[light].place = rounded(scene.lights[light].place, perMetre);
            });
        for (std::size_t object = 0; object < best_.objects.size(); ++object) {
            const bool whole = tryRound([object](SearchScene& scene, double perMetre) {
                for (dvec3& corner : scene.objects[object].cornersWorld)
                    corner = rounded(corner, perMetre);
            });
            if (whole) continue;
            for (std::size_t corner = 0; object < best_.objects.size() && corner < best_.objects[object].cornersWorld.size(); ++corner)
                tryRound([object, corner](SearchScene& scene, double perMetre) {
                    dvec3& place = scene.objects[object].cornersWorld[corner];
                    place = rounded(place, perMetre);
                });
        }
    }

    SearchScene best_;
    const std::function<bool(const SearchScene&)>& stillFails_;
    const std::function<bool()>& mayGoOn_;
    int attempts_ = 0;
};

} // namespace

Shrunk shrink(const SearchScene& scene, const std::function<bool(const SearchScene&)>& stillFails, const std::function<bool()>& mayGoOn) {
    return Shrinker(scene, stillFails, mayGoOn).run();
}

} // namespace shadowlab::student
