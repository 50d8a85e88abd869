// A picture of which every pixel is the mean of many samples, each a tree of rays that chance has spread: over the pixel, the
// lens, the time that the shutter is open, the area of lights, and the lobes of rough surfaces.
//
// R. L. Cook, T. Porter and L. Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984: the rays that are needed anyway for smooth
// edges give all of these at once, no ray is sent for one of them alone. The picture gets better sample by sample, and can be
// looked at in between. Pixels of which enough is known can be left alone (adaptive sampling).
//
// No GL here. What a sample of a pixel is depends on nothing but the two, so the bytes are the same for any number of threads,
// and wherever the work was interrupted.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/ray_tracing/tree/ray_tree.h"
#include "techniques/technique.h"

namespace shadowlab::ray_tracing {

struct SampledSettings {
    SamplePattern pattern;
    bool antialias = true; ///< rays pass anywhere through their pixel; false: through its middle
    double aperture = 0;   ///< diameter of the lens, metres; 0: a pinhole
    double focus = 0;      ///< distance of the plane in focus, metres along the camera's axis
    double shutter = 0;    ///< how long it is open; 0: everything as it stands
    bool adaptive = false; ///< leave pixels alone that are known well enough
    double tolerance = 1;  ///< adaptive: so well, standard error in steps of 8-bit grey
    TreeSettings tree;
};

/// Where a sample's ray begins and goes, and when.
struct EyeSample {
    dvec2 place{0.0}; ///< in the picture, pixels from its upper left corner
    trace::Ray ray;
    double time = 0;
};
EyeSample eyeSample(const trace::EyeRays& rays, const SampledSettings& settings, ivec2 pixel,
                    const SampleNumbers& numbers);

class SampledPicture {
public:
    /// Forgets everything.
    void restart(ivec2 size);

    /// Goes on until every pixel has what it shall have (true), or the time has come (false), but always a bit. The scene, the
    /// camera and the settings have to be those of the first call since restart().
    bool advance(const Surfaces& surfaces, const trace::MovingScene& scene, const AnalyticLights* analytic,
                 const scene::Camera& camera, const SampledSettings& settings, Deadline deadline);

    [[nodiscard]] ivec2 size() const { return size_; }
    /// Has every pixel at least one sample?
    [[nodiscard]] bool isComplete() const { return round_ > 0; }
    /// Share of all samples that is done, 0..1.
    [[nodiscard]] double done() const { return done_; }
    /// The mean; row 0 is at the bottom. Pixels without samples are black.
    [[nodiscard]] std::vector<vec3> radianceFromBelow() const;
    /// Of each pixel, row 0 at the top.
    [[nodiscard]] std::vector<std::uint32_t> samples() const;
    [[nodiscard]] double samplesInAll() const;

    /// Rays below eye rays, of all samples.
    [[nodiscard]] double secondaryRays() const { return secondaryRays_; }

private:
    struct Pixel {
        dvec3 sum{0.0};
        double mean = 0, squares = 0; ///< of the luminance; sum of squared distances from the mean (Welford 1962)
        std::uint32_t count = 0;
        bool isActive = true;
    };
    void add(Pixel& pixel, const dvec3& radiance) const;
    [[nodiscard]] double standardErrorGrey(const Pixel& pixel, double exposure) const;
    void chooseActive(const SampledSettings& settings, double exposure);

    ivec2 size_{0};
    std::vector<Pixel> pixels_; ///< row 0 at the top
    std::size_t nextBlock_ = 0; ///< in this round
    int round_ = 0;             ///< rounds that are done: each gives every active pixel one sample
    bool anyActive_ = true;
    double done_ = 0, secondaryRays_ = 0;
};

} // namespace shadowlab::ray_tracing
