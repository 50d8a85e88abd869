// Between two keys.
// SPDX-License-Identifier: MIT
#include "app/film/path.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::film {

namespace {

/// What does not change keeps its very bits: a share of it plus the rest of it may round to a neighbour.
template <typename Value>
Value mixed(const Value& from, const Value& to, double share) {
    if (from == to) return from;
    return static_cast<Value>(from * (1.0 - share) + to * share);
}

vec3 mixed(const vec3& from, const vec3& to, double share) { return vec3(mixed(dvec3(from), dvec3(to), share)); }

dvec3 mixedDirection(const dvec3& from, const dvec3& to, double share) {
    if (from == to) return from;
    return glm::normalize(mixed(glm::normalize(from), glm::normalize(to), share));
}

scene::Camera mixed(const scene::Camera& from, const scene::Camera& to, double share) {
    scene::Camera camera;
    camera.positionWorld = mixed(from.positionWorld, to.positionWorld, share);
    camera.targetWorld = mixed(from.targetWorld, to.targetWorld, share);
    camera.upWorld = mixedDirection(from.upWorld, to.upWorld, share);
    camera.fovYDegrees = mixed(from.fovYDegrees, to.fovYDegrees, share);
    camera.near = mixed(from.near, to.near, share);
    // There is no way from a number to infinity; the far plane is a hint, and the cautious one is the farther.
    const bool bothFinite = std::isfinite(from.far) && std::isfinite(to.far);
    camera.far = bothFinite ? mixed(from.far, to.far, share) : std::max(from.far, to.far);
    return camera;
}

scene::Light mixed(const scene::Light& from, const scene::Light& to, double share) {
    scene::Light light = from;
    light.positionWorld = mixed(from.positionWorld, to.positionWorld, share);
    light.directionWorld = mixedDirection(from.directionWorld, to.directionWorld, share);
    light.edgeUWorld = mixed(from.edgeUWorld, to.edgeUWorld, share);
    light.edgeVWorld = mixed(from.edgeVWorld, to.edgeVWorld, share);
    light.radius = mixed(from.radius, to.radius, share);
    light.coneDegrees = mixed(from.coneDegrees, to.coneDegrees, share);
    light.edgeDegrees = mixed(from.edgeDegrees, to.edgeDegrees, share);
    light.color = mixed(from.color, to.color, share);
    light.intensity = mixed(from.intensity, to.intensity, share);
    return light;
}

} // namespace

CameraAndLights Path::at(int frame) const {
    const auto after = std::ranges::upper_bound(keys_, frame, {}, &PathKey::frame);
    if (after == keys_.begin()) return keys_.front().state;
    const PathKey& from = *std::prev(after);
    if (after == keys_.end() || from.frame == frame) return from.state;
    const PathKey& to = *after;
    const double share = static_cast<double>(frame - from.frame) / (to.frame - from.frame);

    CameraAndLights state{mixed(from.state.camera, to.state.camera, share), {}};
    for (std::size_t i = 0; i < from.state.lights.size(); ++i)
        state.lights.push_back(mixed(from.state.lights[i], to.state.lights[i], share));
    return state;
}

} // namespace shadowlab::film
