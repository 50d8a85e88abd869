// A random direction toward a light with an area, uniform in its solid angle.
//
// The radiance that a light of radiance L adds at a point is the integral of L V (n.w) over the directions w toward the light; V
// is 1 where it is visible, else 0. With directions uniform in solid angle, that is the mean of L Omega max(0, n.w) V. Samples
// uniform in area would have weights of cos / d^2, unbounded near a light, which show as bright dots.
//
// Rects: C. Urena, M. Fajardo, A. King, "An Area-Preserving Parametrization for Spherical Rectangles", Computer Graphics Forum
// 2013: first a line across the light that splits off the share random01.x of the solid angle; then a point on it, in closed
// form. Here the line is found by Newton's method instead of their formula for right angles, so it also works for parallelograms,
// and keeps its digits where the solid angle is small. Spheres: the cone of directions that hit it, uniform in height: P.
// Shirley, C. Wang, K. Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", ACM Transactions on Graphics 1996.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/light.h"

namespace shadowlab::ray_tracing {

struct LightSample {
    dvec3 towardWorld{0.0};          ///< unit
    dvec3 onLightCentredOffset{0.0}; ///< from the point to the place on the light's surface, metres
    /// The solid angle of the whole light from the point, steradians. 0: it is not visible, and there is no sample.
    double solidAngle = 0;
    /// Light area per solid angle in that direction, the area being that of trace::AreaVisibility: the rect itself, or for a
    /// sphere the disc within the circle of tangents. Scaled to a mean of 1: the mean of areaWeight * V estimates the visible
    /// share of the area; divided by the mean of areaWeight it has less noise.
    double areaWeight = 0;
};

/// Samples one light from one point; what all samples have in common is computed once.
class LightSampler {
public:
    /// The solid angle is 0 where the light has no area, and for points inside a sphere, behind a rect, or, within rounding, in
    /// its plane.
    LightSampler(const scene::Light& light, const dvec3& pointWorld);
    [[nodiscard]] double solidAngle() const { return solidAngle_; }
    /// `random01`: two uniform numbers from 0 to 1. Neighbouring numbers give neighbouring directions (but for the cut around a
    /// sphere), so well-distributed numbers give well-distributed directions.
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
    // Rect: in the plane z = height, x from x0 to x1; on each such line y from yAtZero + slope * x, over a length of width.
    double height_ = 0, x0_ = 0, x1_ = 0, yAtZero_ = 0, slope_ = 0, width_ = 0;
    double angle_ = 0;      ///< between the lines of x0 and x1, seen along y
    dvec3 firstUnits_[2]{}; ///< toward the corners at x0
    double firstLengths_[2]{};
    dvec3 density_{0.0}; ///< solid angle per radian of that angle, approximated by a + b t + c t^2, t in 0..1
    // Sphere.
    double distance_ = 0, radius_ = 0;
    double lowest_ = 0; ///< 1 - cos of the cone's half angle
};

/// A single sample of LightSampler.
LightSample sampleLight(const scene::Light& light, const dvec3& pointWorld, dvec2 random01);

} // namespace shadowlab::ray_tracing
