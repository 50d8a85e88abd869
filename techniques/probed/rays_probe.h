// The rays that distributed ray tracing sends for one pixel, and what chance made of each.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab {

/// The samples that a pixel is the mean of.
struct RaysProbe {
    /// Of the pixel: (0, 0) is its upper left corner, (1, 1) its lower right one.
    using InPixel = dvec2;
    struct Sample {
        InPixel place{0.5};
        /// Lower and upper corner of the subpixel that the place was chosen in; none where the pattern has no subpixels.
        std::optional<std::array<InPixel, 2>> subpixel{};
        dvec3 fromWorld{0.0}; ///< where the ray begins: a place on the lens, or the eye
        dvec3 toWorld{0.0};   ///< what it meets, at its time
        bool meets = false;   ///< else it goes on for ever, and `toWorld` is a place on its way
        std::string object{}; ///< that it meets
        double time = 0;      ///< 0 ... shutter
        dvec3 intensity{0.0}; ///< what it brings
        // At the surface that it meets; unit. None: no such ray was sent.
        std::optional<dvec3> reflectedWorld{}, refractedWorld{};
        // The shadow ray to the light that is asked about, if that has an area and lies before the surface.
        std::optional<dvec3> onLightWorld{}; ///< the place on it that was chosen
        dvec3 shadowEndWorld{0.0};           ///< the same, or what stands in the way
        bool arrives = false;
        double areaWeight = 0; ///< light area that the sample stands for; its mean over many is 1
    };
    /// What moves while the shutter is open.
    struct Mover {
        std::string object;
        dvec3 velocityWorld{0.0}; ///< metres per unit of shutter time
    };
    int count = 0;               ///< of the picture; `samples` are the first of them
    std::vector<Sample> samples; ///< at least one
    double aperture = 0;         ///< diameter of the lens, metres; 0: a pinhole
    double focus = 0;            ///< distance of the plane in focus, metres along the camera's axis
    double shutter = 0;          ///< units of time that it is open
    std::vector<Mover> movers;   ///< none: nothing moves
    /// Half angles of the lobes of the surface that the ray through the pixel's middle meets, as far as they are used, degrees.
    double glossDegrees = 0, translucencyDegrees = 0;
    /// Of the light's area as it is seen from there, in closed form; none without an area, or where it is not sampled.
    std::optional<double> exactShare{};

    /// The mean of what they bring.
    [[nodiscard]] dvec3 mean() const {
        dvec3 sum(0.0);
        for (const Sample& sample : samples)
            sum += sample.intensity;
        return sum / static_cast<double>(samples.size());
    }
    /// The share of the light's area that arrives by the samples; none where no shadow ray was sent.
    [[nodiscard]] std::optional<double> sampledShare() const {
        double arrives = 0, all = 0;
        for (const Sample& sample : samples) {
            if (!sample.onLightWorld) continue;
            all += sample.areaWeight;
            if (sample.arrives) arrives += sample.areaWeight;
        }
        return all > 0 ? std::optional(arrives / all) : std::nullopt;
    }
};

} // namespace shadowlab
