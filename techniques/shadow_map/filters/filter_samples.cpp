// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/filters/filter_samples.h"

#include <cmath>

namespace shadowlab::shadow_map {

namespace {

// As sample_points.glsl writes them: a shader's constants are floats.
constexpr double kGoldenAngle = 2.39996323, kTurn = 6.2831853;
constexpr dvec2 kPlastic{0.7548776662, 0.5698402910};

/// pcg3d: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020.
dvec2 hash(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v += uvec3(v.y, v.z, v.x) * uvec3(v.z, v.x, v.y);
    v ^= v >> 16u;
    v += uvec3(v.y, v.z, v.x) * uvec3(v.z, v.x, v.y);
    return dvec2(v.x >> 8u, v.y >> 8u) / 16777216.0;
}

} // namespace

dvec2 sampleNoise(FilterParams::Noise noise, const ivec2& fragment, const ivec2& texel, int layer) {
    if (noise == FilterParams::Noise::none) return dvec2(0.0);
    const ivec2 seed = noise == FilterParams::Noise::pixel ? fragment : texel;
    return hash(uvec3(glm::uvec2(seed), static_cast<unsigned>(layer)));
}

dvec2 pointInDisc(int i, int count, const dvec2& chance) {
    const double angle = i * kGoldenAngle + kTurn * chance.x;
    return std::sqrt((i + 0.5) / count) * dvec2(std::cos(angle), std::sin(angle));
}

dvec2 pointInSquare(int i, const dvec2& chance) { return 2.0 * glm::fract(chance + (i + 1.0) * kPlastic) - 1.0; }

} // namespace shadowlab::shadow_map
