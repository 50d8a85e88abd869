// SPDX-License-Identifier: MIT
#include "app/course/explore/lamp_track.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/picture/labels.h"
#include "techniques/foundation/scene/query/outside_camera.h"

namespace shadowlab::course {

namespace {

using Json = nlohmann::json;

constexpr double kPlanWidth = 100;   ///< units of the plan
constexpr double kPlanMargin = 0.12; ///< of its larger side, around all that has to be seen in it
constexpr double kPlanStep = 0.25;   ///< units that outlines are rounded to

dvec2 fromAbove(const dvec3& pointWorld) { return {pointWorld.x, pointWorld.z}; }

double cross(const dvec2& a, const dvec2& b, const dvec2& c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// The convex hull, without points that lie on its sides. Source: Andrew, "Another efficient algorithm for convex hulls in two
/// dimensions", 1979.
std::vector<dvec2> hullOf(std::vector<dvec2> points) {
    const auto isLeft = [](const dvec2& a, const dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    std::ranges::sort(points, isLeft);
    const auto repeated = std::ranges::unique(points);
    points.erase(repeated.begin(), repeated.end());
    if (points.size() < 3) return points;
    std::vector<dvec2> hull;
    for (int half = 0; half < 2; ++half) {
        const std::size_t begin = hull.size();
        for (const dvec2& point : points) {
            while (hull.size() >= begin + 2 && cross(hull[hull.size() - 2], hull.back(), point) <= 0)
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back(); // the first of the other half
        std::ranges::reverse(points);
    }
    return hull;
}

/// Of a light, or where a lamp would be that shines as a directional one does.
dvec3 placeOf(const scene::Light& light, const scene::Camera& camera) {
    if (light.type != scene::LightType::directional) return light.positionWorld;
    return camera.targetWorld - light.directionWorld * glm::length(camera.positionWorld - camera.targetWorld);
}

/// In shares of the picture; none where it is not in it.
std::optional<dvec2> inPicture(const dvec3& pointWorld, const scene::Camera& camera, double aspect) {
    const dvec4 clip = scene::clipFromView(camera, aspect) * scene::viewFromWorld(camera) * dvec4(pointWorld, 1);
    if (clip.w <= 0 || std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w) return {};
    return dvec2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w);
}

class Plan {
public:
    Plan(const std::vector<dvec2>& seen) : lower_(seen.front()), upper_(seen.front()) {
        for (const dvec2& point : seen) {
            lower_ = glm::min(lower_, point);
            upper_ = glm::max(upper_, point);
        }
        const double margin = kPlanMargin * std::max({upper_.x - lower_.x, upper_.y - lower_.y, 1e-3});
        lower_ -= margin;
        upper_ += margin;
        // A long narrow plan is hard to hit: the shorter side is at least two thirds of the longer one.
        const dvec2 size = upper_ - lower_;
        const dvec2 least = glm::max(size, dvec2(std::max(size.x, size.y) * 2 / 3));
        lower_ -= (least - size) / 2.0;
        upper_ += (least - size) / 2.0;
        scale_ = kPlanWidth / (upper_.x - lower_.x);
    }
    [[nodiscard]] double height() const { return rounded((upper_.y - lower_.y) * scale_); }
    [[nodiscard]] dvec2 at(const dvec2& point) const {
        const dvec2 place = (point - lower_) * scale_;
        return {rounded(place.x), rounded(place.y)};
    }
    [[nodiscard]] Json json(const dvec2& point) const {
        const dvec2 place = at(point);
        return {place.x, place.y};
    }

private:
    static double rounded(double value) { return std::round(value / kPlanStep) * kPlanStep; }
    dvec2 lower_, upper_;
    double scale_ = 1;
};

Json objectsOf(const scene::Scene& scene, const Plan& plan) {
    Json objects = Json::array();
    for (const scene::Object& object : scene.objects) {
        if (object.emitterOfLight >= 0) continue;
        const dmat4 worldFromMesh = scene::worldFromMesh(object);
        std::vector<dvec2> points;
        for (const vec3& positionMesh : object.mesh->positionsMesh)
            points.push_back(plan.at(fromAbove(dvec3(worldFromMesh * dvec4(dvec3(positionMesh), 1)))));
        Json outline = Json::array();
        for (const dvec2& corner : hullOf(std::move(points)))
            outline.push_back({corner.x, corner.y});
        if (outline.size() > 1) objects.push_back({{"name", object.name}, {"outline", std::move(outline)}});
    }
    return objects;
}

std::string metres(const dvec3& point) {
    return "(" + picture::shortNumber(point.x) + ", " + picture::shortNumber(point.y) + ", " + picture::shortNumber(point.z) + ")";
}

} // namespace

Json lampTrack(const std::vector<ShownState>& states, double degrees, double aspect, int light) {
    const scene::Scene& scene = *states.front().scene;
    const scene::Camera& camera = states.front().camera;
    std::vector<dvec3> places;
    std::vector<scene::Light> lights;
    std::vector<std::vector<dvec3>> others; // of each position
    for (const ShownState& state : states) {
        lights.push_back(state.scene->light(light));
        places.push_back(placeOf(lights.back(), camera));
        std::vector<dvec3>& ofState = others.emplace_back();
        for (int other = 0; other < static_cast<int>(scene.lights.size()); ++other)
            if (other != light) ofState.push_back(placeOf(state.scene->light(other), camera));
    }
    std::vector<dvec2> seen{fromAbove(camera.positionWorld), fromAbove(camera.targetWorld)};
    for (const dvec3& place : places)
        seen.push_back(fromAbove(place));
    for (const std::vector<dvec3>& ofState : others)
        for (const dvec3& place : ofState)
            seen.push_back(fromAbove(place));
    if (const scene::Bounds things = scene::thingsBounds(scene); !things.isEmpty())
        seen.insert(seen.end(), {fromAbove(things.lowerWorld), fromAbove(things.upperWorld)});
    const Plan plan(seen);
    Json positions = Json::array();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double turned = i == 0 ? 0 : degrees * static_cast<double>(i) / static_cast<double>(places.size()); // and not -0
        const bool isSun = lights[i].type == scene::LightType::directional;
        const std::optional<dvec2> shown = isSun ? std::nullopt : inPicture(places[i], camera, aspect);
        positions.push_back({{"said", "turned by " + picture::shortNumber(turned) + " degrees, " +
                                          (isSun ? "shining along " + metres(lights[i].directionWorld) : "at " + metres(places[i]) + " m")},
                             {"at", {places[i].x, places[i].y, places[i].z}},
                             {"plan", plan.json(fromAbove(places[i]))},
                             {"others", Json::array()},
                             {"picture", shown ? Json{shown->x, shown->y} : Json()}});
        for (const dvec3& place : others[i])
            positions.back()["others"].push_back(plan.json(fromAbove(place)));
    }
    // The rims of what the eye sees, as long as the way to its target and a half.
    Json view = Json::array();
    const double depth = 1.5 * glm::length(camera.targetWorld - camera.positionWorld);
    const auto corners = scene::viewCorners(camera, aspect, depth);
    for (const auto& [upper, lower] : {std::pair{corners[0], corners[3]}, std::pair{corners[1], corners[2]}})
        view.push_back(plan.json(fromAbove((upper + lower) / 2.0)));
    Json names = Json::array();
    for (int other = 0; other < static_cast<int>(scene.lights.size()); ++other)
        if (other != light) names.push_back(scene.light(other).name);
    return {{"start", 0}, {"others", std::move(names)},
            {"closed", std::abs(degrees) == 360},
            {"positions", std::move(positions)},
            {"plan",
             {{"width", kPlanWidth}, {"height", plan.height()}, {"objects", objectsOf(scene, plan)},
              {"eye", plan.json(fromAbove(camera.positionWorld))}, {"view", std::move(view)}}}};
}

} // namespace shadowlab::course
