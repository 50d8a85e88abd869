// SPDX-License-Identifier: MIT
#include "techniques/foundation/math/perpendicular.h"
#include "techniques/ray_tracing/sampling/light_sampling.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

namespace shadowlab::ray_tracing {

namespace {

// A point whose height over the light's plane is below this share of its distance lies in the plane: some roundings of double.
constexpr double kInPlane = 1e-15;

// Newton's method doubles the number of correct digits with every step: from here the next step is exact to rounding.
constexpr double kNextIsLast = 1e-7;

// Where Newton's step would leave the bracket, the bracket is halved instead; so many halvings exhaust the digits of a double.
constexpr int kMostSteps = 60;

// Below this share of its maximum, the denominator of the tangent formula has too few digits.
constexpr double kFewDigits = 1e-4;

double angleBetween(const dvec3& a, const dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// The denominator for a spherical triangle, given unit vectors to its corners: 1 + cos + cos + cos of the angles between them.
/// Half of the solid angle has the tangent volume / (product of lengths * this) (A. van Oosterom and J. Strackee, "The Solid
/// Angle of a Plane Triangle", IEEE Transactions on Biomedical Engineering 1983).
double denominator(const dvec3& unitA, const dvec3& unitB, const dvec3& unitC) {
    return 1 + glm::dot(unitA, unitB) + glm::dot(unitB, unitC) + glm::dot(unitC, unitA);
}

/// The point on a line at distance w that splits the solid angle between y0 and y1 by `share`. Along the line, equal solid angles
/// are equal steps of y / sqrt(y^2 + w^2), or of one minus that, which keeps its digits far out.
double placeOnLine(double w, double y0, double y1, double share) {
    const double side = std::abs(y0) > std::abs(y1) ? -1 : 1; // so that the farther end has a positive y
    const auto complement = [w](double y) {
        const double d = std::hypot(y, w);
        return y > 0 ? w / d * (w / (d + y)) : 1 - y / d;
    };
    const double value = glm::mix(complement(side * y0), complement(side * y1), share);
    const double y = side * w * (1 - value) / std::sqrt(value * (2 - value));
    // If the root has no digits left (beyond 1e150 times the distance), interpolate linearly.
    return std::isfinite(y) ? std::clamp(y, y0, y1) : glm::mix(y0, y1, share);
}

} // namespace

LightSampler::LightSampler(const scene::Light& light, const dvec3& pointWorld) {
    const dvec3 toCentre = light.positionWorld - pointWorld;
    if (light.type == scene::LightType::rect && scene::edgesSpan(light)) setUpRect(light, toCentre);
    if (light.type == scene::LightType::sphere) setUpSphere(light.radius, toCentre);
}

void LightSampler::setUpRect(const scene::Light& light, const dvec3& toCentre) {
    const dvec3 corner = toCentre - 0.5 * (light.edgeUWorld + light.edgeVWorld);
    axisY_ = glm::normalize(light.edgeVWorld);
    axisZ_ = -scene::rectNormalWorld(light);
    axisX_ = glm::normalize(glm::cross(axisY_, axisZ_));
    if (glm::dot(axisX_, light.edgeUWorld) < 0) axisX_ = -axisX_;
    height_ = glm::dot(axisZ_, toCentre);
    if (!(height_ > kInPlane * glm::length(toCentre))) return;
    const double depth = glm::dot(axisX_, light.edgeUWorld);
    x0_ = glm::dot(axisX_, corner);
    x1_ = x0_ + depth;
    slope_ = glm::dot(axisY_, light.edgeUWorld) / depth;
    yAtZero_ = glm::dot(axisY_, corner) - slope_ * x0_;
    width_ = glm::length(light.edgeVWorld);
    angle_ = std::atan2(height_ * depth, x0_ * x1_ + height_ * height_);
    for (int i = 0; i < 2; ++i) {
        const dvec3 first(x0_, yAtZero_ + slope_ * x0_ + i * width_, height_);
        firstLengths_[i] = glm::length(first);
        firstUnits_[i] = first / firstLengths_[i];
    }
    const double begin = densityAt(x0_), middle = densityAt(xAt(0.5 * angle_)), end = densityAt(x1_);
    density_ = {begin, 4 * middle - 3 * begin - end, 2 * begin - 4 * middle + 2 * end};
    solidAngle_ = solidAngleBefore(x1_);
}

void LightSampler::setUpSphere(double radius, const dvec3& toCentre) {
    isSphere_ = true;
    distance_ = glm::length(toCentre);
    radius_ = radius;
    if (!(radius_ > 0 && distance_ > radius_)) return;
    axisZ_ = toCentre / distance_;
    axisX_ = perpendicularTo(axisZ_);
    axisY_ = glm::cross(axisZ_, axisX_);
    const double sine = radius_ / distance_;
    lowest_ = sine * sine / (1 + std::sqrt((1 - sine) * (1 + sine))); // 1 - cos, without cancellation
    solidAngle_ = glm::two_pi<double>() * lowest_;
}

LightSample LightSampler::sample(dvec2 random01) const {
    if (!(solidAngle_ > 0)) return {};
    return isSphere_ ? onSphere(random01) : onRect(random01);
}

/// The solid angle of the part of the light from x0 to x. Two formulas, because each is accurate where the other is not.
double LightSampler::solidAngleBefore(double x) const {
    const double y = yAtZero_ + slope_ * x;
    const dvec3 lower(x, y, height_), upper(x, y + width_, height_);
    const double lengthLower = glm::length(lower), lengthUpper = glm::length(upper);
    const dvec3 unitLower = lower / lengthLower, unitUpper = upper / lengthUpper;
    const double first = denominator(firstUnits_[0], unitLower, unitUpper);
    const double second = denominator(firstUnits_[0], unitUpper, firstUnits_[1]);
    if (first > kFewDigits && second > kFewDigits) {
        // Two triangles. Their volumes are computed without subtracting products, so the smallest solid angle keeps all its
        // digits; the two half angles are added like those of complex numbers.
        const double both = height_ / firstLengths_[0] * ((x - x0_) / lengthUpper) * width_;
        const double volume1 = both / lengthLower, volume2 = both / firstLengths_[1];
        return 2 * std::atan2(volume1 * second + volume2 * first, first * second - volume1 * volume2);
    }
    // Near the light's border, or nearly surrounded by it: 2 pi minus the exterior angles (A. Girard, 1629), from the inward
    // normals of the planes through the point and each side.
    const dvec3 left(height_, 0, -x0_), right(-height_, 0, x);
    const dvec3 bottom(-slope_ * height_, height_, -yAtZero_), top(slope_ * height_, -height_, yAtZero_ + width_);
    return glm::two_pi<double>() - angleBetween(left, bottom) - angleBetween(bottom, right) - angleBetween(right, top) -
           angleBetween(top, left);
}

/// The x of the line that is seen at that angle from the line of x0, in the plane perpendicular to y.
double LightSampler::xAt(double angle) const {
    const double sine = std::sin(angle);
    double x = 0;
    if (x0_ < 0 && x1_ > 0) { // above the light x is small: it must not be a difference of large numbers
        const double cosine = std::cos(angle);
        x = height_ * (x0_ * cosine + height_ * sine) / (height_ * cosine - x0_ * sine);
    } else {
        const double from = sine * std::sqrt(x0_ * x0_ + height_ * height_);
        const double to = std::sin(angle_ - angle) * std::sqrt(x1_ * x1_ + height_ * height_);
        x = x0_ + (x1_ - x0_) * from / (from + to);
    }
    return std::clamp(x, x0_, x1_);
}

/// Solid angle of the light per radian of that angle, at the line of x: between 0 and 2, however near or far the light is.
double LightSampler::densityAt(double x) const {
    const double y = yAtZero_ + slope_ * x, squared = x * x + height_ * height_;
    return (y + width_) / std::sqrt((y + width_) * (y + width_) + squared) - y / std::sqrt(y * y + squared);
}

/// A first guess, from a quadratic density.
double LightSampler::guessedAngle(double share) const {
    const double a = density_.x, b = density_.y, c = density_.z, whole = a + b / 2 + c / 3;
    double t = share;
    for (int step = 0; step < 2; ++step)
        t -= (t * (a + t * (b / 2 + t * c / 3)) - share * whole) / (a + t * (b + t * c));
    return t >= 0 && t <= 1 ? t * angle_ : share * angle_;
}

/// The x that splits off that share of the solid angle; solved for the angle.
double LightSampler::lineAt(double share) const {
    double lower = 0, upper = angle_, angle = guessedAngle(share);
    for (int step = 0; step < kMostSteps; ++step) {
        const double x = xAt(angle), excess = solidAngleBefore(x) - share * solidAngle_;
        (excess > 0 ? upper : lower) = angle;
        const double next = angle - excess / densityAt(x);
        const bool isWithin = next >= lower && next <= upper; // also false for NaN
        angle = isWithin ? next : 0.5 * (lower + upper);
        if (isWithin && std::abs(excess) <= kNextIsLast * solidAngle_) break;
    }
    return xAt(angle);
}

LightSample LightSampler::onRect(dvec2 random01) const {
    const double x = lineAt(random01.x), y0 = yAtZero_ + slope_ * x;
    const double y = placeOnLine(std::hypot(x, height_), y0, y0 + width_, random01.y);
    const dvec3 offset = x * axisX_ + y * axisY_ + height_ * axisZ_;
    const double d = glm::length(dvec3(x, y, height_));
    // A solid angle covers an area of d^2 times its size, divided by the cosine at the light, which is height / d.
    const double area = (x1_ - x0_) * width_;
    return {offset / d, offset, solidAngle_, solidAngle_ * d / area * d * (d / height_)};
}

LightSample LightSampler::onSphere(dvec2 random01) const {
    const double lower = random01.x * lowest_; // 1 - cos of the angle to the axis
    const double cosine = 1 - lower, sine = std::sqrt(lower * (2 - lower));
    const double turn = glm::two_pi<double>() * random01.y;
    const dvec3 toward = cosine * axisZ_ + sine * (std::cos(turn) * axisX_ + std::sin(turn) * axisY_);
    // The nearer of the two intersections with the sphere. Their product is the power of the point with respect to the sphere.
    const double aside = distance_ * sine, root = std::sqrt(std::max((radius_ - aside) * (radius_ + aside), 0.0));
    const double power = (distance_ - radius_) * (distance_ + radius_);
    const double length = power / (distance_ * cosine + root);
    // The disc: at distance power / distance along the axis, with the radius of the sphere times the cone's cosine.
    const double discDistance = power / distance_, ratio = discDistance / (radius_ * (1 - lowest_));
    const double weight = solidAngle_ * ratio * ratio / (glm::pi<double>() * cosine * cosine * cosine);
    return {toward, length * toward, solidAngle_, weight};
}

LightSample sampleLight(const scene::Light& light, const dvec3& pointWorld, dvec2 random01) {
    return LightSampler(light, pointWorld).sample(random01);
}

} // namespace shadowlab::ray_tracing
