// A picture in which every pixel is the mean of many samples, each a tree of rays that is spread at random: over the pixel, the
// lens, the time of the shutter, the area of lights, and the lobes of rough surfaces.
//
// R. L. Cook, T. Porter and L. Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984: the rays that antialiasing needs anyway give
// all of these effects at once; none needs rays of its own. The picture improves sample by sample, and can be shown in between.
// Pixels that have converged may be left alone (adaptive sampling).
//
// No GL here. A sample depends only on the pixel and its number, so the bytes are the same for any number of threads, and
// wherever the work was interrupted.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/ray_tracing/tree/ray_tree.h"
#include "techniques/technique.h"

namespace shadowlab::ray_tracing {

struct SampledSettings {
    SamplePattern pattern;
    bool antialias = true; ///< rays pass through random points of their pixel; false: through its centre
    double aperture = 0;   ///< diameter of the lens, metres; 0: a pinhole
    double focus = 0;      ///< distance of the plane in focus, metres along the camera's axis
    double shutter = 0;    ///< how long it is open; 0: nothing moves
    bool adaptive = false; ///< stop sampling pixels that have converged
    double tolerance = 1;  ///< adaptive: the standard error of a converged pixel, in steps of 8-bit grey
    TreeSettings tree;
};

/// A sample's ray, and its time.
struct EyeSample {
    dvec2 place{0.0}; ///< in the picture, pixels from its upper left corner
    trace::Ray ray;
    double time = 0;
};
EyeSample eyeSample(const trace::EyeRays& rays, const SampledSettings& settings, ivec2 pixel,
                    const SampleNumbers& numbers);

class SampledPicture {
public:
    /// Clears everything.
    void restart(ivec2 size);

    /// Continues until every pixel has all its samples (true) or the deadline has passed (false), but always does some work. The
    /// scene, the camera and the settings must be those of the first call since restart().
    bool advance(const Surfaces& surfaces, const trace::MovingScene& scene, const AnalyticLights* analytic,
                 const scene::Camera& camera, const SampledSettings& settings, Deadline deadline);

    [[nodiscard]] ivec2 size() const { return size_; }
    /// Has every pixel at least one sample?
    [[nodiscard]] bool isComplete() const { return round_ > 0; }
    /// The share of all samples that is done, 0..1.
    [[nodiscard]] double done() const { return done_; }
    /// The mean; row 0 is at the bottom. Pixels without samples are black.
    [[nodiscard]] std::vector<vec3> radianceFromBelow() const;
    /// How many samples each pixel has, row 0 at the top.
    [[nodiscard]] std::vector<std::uint32_t> samples() const;
    [[nodiscard]] double samplesInAll() const;

    /// How many rays were traced below the eye rays, for all samples.
    [[nodiscard]] double secondaryRays() const { return secondaryRays_; }

private:
    struct Pixel {
        dvec3 sum{0.0};
        double mean = 0, squares = 0; ///< of the luminance; sum of squared deviations from the mean (Welford 1962)
        std::uint32_t count = 0;
        bool isActive = true;
    };
    void add(Pixel& pixel, const dvec3& radiance) const;
    [[nodiscard]] double standardErrorGrey(const Pixel& pixel, double exposure) const;
    void chooseActive(const SampledSettings& settings, double exposure);

    ivec2 size_{0};
    std::vector<Pixel> pixels_; ///< row 0 at the top
    std::size_t nextBlock_ = 0; ///< in this round
    int round_ = 0;             ///< finished rounds: each gives every active pixel one sample
    bool anyActive_ = true;
    double done_ = 0, secondaryRays_ = 0;
};

} // namespace shadowlab::ray_tracing
