// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/tree/fresnel.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::ray_tracing {

namespace {

/// The squared cosine of the refracted ray's angle, by Snell's law; negative in total internal reflection.
double squaredCosBeyond(double cosIncident, double ratio) {
    return 1.0 - ratio * ratio * (1.0 - cosIncident * cosIncident);
}

} // namespace

dvec3 reflected(const dvec3& u, const dvec3& normalWorld) {
    return glm::normalize(u - 2.0 * glm::dot(u, normalWorld) * normalWorld);
}

std::optional<dvec3> refracted(const dvec3& u, const dvec3& normalWorld, double ratio) {
    if (ratio == 1.0) return u; // unbent, to the last bit
    const double cosIncident = -glm::dot(u, normalWorld);
    const double squared = squaredCosBeyond(cosIncident, ratio);
    if (!(squared > 0.0)) return std::nullopt;
    return glm::normalize(ratio * u + (ratio * cosIncident - std::sqrt(squared)) * normalWorld);
}

double fresnelReflectance(double cosIncident, double ratio) {
    if (ratio == 1.0) return 0.0; // the same medium on both sides
    const double squared = squaredCosBeyond(cosIncident, ratio);
    if (!(squared > 0.0)) return 1.0;
    const double cosBeyond = std::sqrt(squared);
    const double across = (ratio * cosIncident - cosBeyond) / (ratio * cosIncident + cosBeyond);
    const double along = (ratio * cosBeyond - cosIncident) / (ratio * cosBeyond + cosIncident);
    return 0.5 * (across * across + along * along);
}

double schlickReflectance(double cosIncident, double ratio) {
    if (ratio == 1.0) return 0.0;
    const double squared = squaredCosBeyond(cosIncident, ratio);
    if (!(squared > 0.0)) return 1.0;
    const double cosThinner = ratio > 1.0 ? std::sqrt(squared) : cosIncident;
    const double straight = (ratio - 1.0) / (ratio + 1.0);
    return straight * straight + (1.0 - straight * straight) * std::pow(1.0 - std::min(cosThinner, 1.0), 5.0);
}

Weights weightsOf(double reflectivity, double transparency, double cosIncident, double ratio, Fresnel kind) {
    if (transparency <= 0.0) return {reflectivity, 0.0, false};
    const double sum = reflectivity + transparency;
    if (ratio != 1.0 && !(squaredCosBeyond(cosIncident, ratio) > 0.0)) return {sum, 0.0, true};
    if (kind == Fresnel::constant) return {reflectivity, transparency, false};
    const double share =
        kind == Fresnel::exact ? fresnelReflectance(cosIncident, ratio) : schlickReflectance(cosIncident, ratio);
    return {sum * share, sum * (1.0 - share), false};
}

} // namespace shadowlab::ray_tracing
