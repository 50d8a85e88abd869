// One direction toward a light that has an area, all of its solid angle being equally likely.
//
// What a light of radiance L adds at a point is the integral of L V (n.w) over the directions w in which the light lies; V is 1
// where it is seen, else 0. With directions chosen by solid angle that is the mean of L Omega max(0, n.w) V. There is no distance
// in it to divide by: near a light, places chosen by area have weights of cos / d^2 without bound, which show as bright dots.
//
// Rects: C. Urena, M. Fajardo, A. King, "An Area-Preserving Parametrization for Spherical Rectangles", Computer Graphics Forum
// 2013: first a line across the light, so that the solid angle before it has the share random01.x; then a place on it, in closed
// form. Here the line is found by Newton's method instead of their formula for right angles, so it holds for parallelograms as
// well, and keeps its digits where the solid angle is small.
// Spheres: the cone of directions that meet it, by height: P. Shirley, C. Wang, K. Zimmerman, "Monte Carlo Techniques for Direct
// Lighting Calculations", ACM Transactions on Graphics 1996.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/light.h"

namespace shadowlab::ray_tracing {

struct LightSample {
    dvec3 towardWorld{0.0};          ///< unit
    dvec3 onLightCentredOffset{0.0}; ///< from the point to the place on the light's surface, metres
    /// Steradian of all the light as seen from the point. 0: nothing is seen of it, there is no sample.
    double solidAngle = 0;
    /// Of light area per solid angle, in that direction, area being what trace::AreaVisibility counts: of a rect its own, of a
    /// sphere that of the disc within the circle where tangents touch it. Scaled so that its mean is 1: the mean of
    /// areaWeight * V estimates the share of area that is seen; over the mean of areaWeight, with less noise.
    double areaWeight = 0;
};

/// All samples of one light from one point: what they have in common is worked out once.
class LightSampler {
public:
    /// Without a solid angle where the light has no area, and for points within a sphere, behind a rect, or, as far as rounding
    /// can tell, in its plane.
    LightSampler(const scene::Light& light, const dvec3& pointWorld);
    [[nodiscard]] double solidAngle() const { return solidAngle_; }
    /// `random01`: two numbers from 0 to 1, evenly distributed. Neighbouring numbers are neighbouring directions, but for the cut
    /// around a sphere: so numbers that are spread well spread directions well.
    [[nodiscard]] LightSample sample(dvec2 random01) const;

private:
    void setUpRect(const scene::Light& light, const dvec3& toCentre);
    void setUpSphere(double radius, const dvec3& toCentre);
    [[nodiscard]] double solidAngleBefore(double x) const;
    [[nodiscard]] double xAt(double angle) const;
    [[nodiscard]] double densityAt(double x) const;
    [[nodiscard]] double guessedAngle(double share) const;
    [[nodiscard]] double lineAt(double share) const;
    [[nodiscard]] LightSample onRect(dvec2 random01) const;
    [[nodiscard]] LightSample onSphere(dvec2 random01) const;

    bool isSphere_ = false;
    double solidAngle_ = 0;
    dvec3 axisX_{0.0}, axisY_{0.0},
        axisZ_{0.0}; ///< unit, with the point as origin; z: straight to the light's plane or centre
    // Of a rect: in the plane z = height, x from x0 to x1; on each such line y from yAtZero + slope * x, for a width.
    double height_ = 0, x0_ = 0, x1_ = 0, yAtZero_ = 0, slope_ = 0, width_ = 0;
    double angle_ = 0;      ///< between the lines of x0 and of x1, seen along y
    dvec3 firstUnits_[2]{}; ///< toward the corners at x0
    double firstLengths_[2]{};
    dvec3 density_{0.0}; ///< solid angle per radian of that angle, about a + b t + c t^2 at its share t
    // Of a sphere.
    double distance_ = 0, radius_ = 0;
    double lowest_ = 0; ///< 1 - cos of the cone's half angle
};

/// LightSampler's sample, where only one is asked for.
LightSample sampleLight(const scene::Light& light, const dvec3& pointWorld, dvec2 random01);

} // namespace shadowlab::ray_tracing
