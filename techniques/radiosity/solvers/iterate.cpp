// SPDX-License-Identifier: MIT
#include "techniques/radiosity/solvers/iterate.h"

#include <algorithm>
#include <utility>

#include "techniques/radiosity/equations/bounces.h"
#include "techniques/radiosity/equations/gather.h"

namespace shadowlab::radiosity {

namespace {

constexpr double kMargin = 1.01; // for terms of second order, and the rounding of the bound itself

/// a / b, and 0 where a is 0: a colour without light has no error.
double ratio(double a, double b) { return a == 0 ? 0.0 : a / b; }

} // namespace

Iterate::Iterate(Problem problem)
    : problem_(std::move(problem)), reflects_(boundsOfSolvable(problem_)), radiosity_(problem_.areas.size(), dvec3(0)),
      residual_(problem_.emission) {
    for (std::size_t i = 0; i < size(); ++i) {
        reflectancePerArea_.push_back(problem_.reflectance[i] / problem_.areas[i]);
        totalArea_ += problem_.areas[i];
        largestResidual_ = glm::max(largestResidual_, residual_[i]);
    }
}

std::vector<dvec3> Iterate::reflected(std::span<const dvec3> x) const { return nextBounce(problem_, x); }

void Iterate::add(std::span<const dvec3> x, std::span<const dvec3> reflectedChange) {
    dvec3 largestChange(0), largestDifference(0);
    largestRadiosity_ = largestResidual_ = dvec3(0);
    for (std::size_t i = 0; i < size(); ++i) {
        const dvec3 difference = reflectedChange[i] - x[i];
        radiosity_[i] += x[i];
        residual_[i] += difference;
        largestChange = glm::max(largestChange, glm::abs(x[i]));
        largestDifference = glm::max(largestDifference, glm::abs(difference));
        largestRadiosity_ = glm::max(largestRadiosity_, glm::abs(radiosity_[i]));
        largestResidual_ = glm::max(largestResidual_, glm::abs(residual_[i]));
    }
    const dvec3& q = reflects_.ofLargest;
    drift_ += kMargin * (gatherRounding(size()) * q * largestChange +
                         kRoundingUnit * ((1.0 + q) * largestRadiosity_ + largestResidual_ + largestDifference));
    workSinceFresh_ += 1;
}

void Iterate::addAt(std::size_t i, const dvec3& x) {
    const std::span<const double> row = problem_.exchange.row(i);
    radiosity_[i] += x;
    residual_[i] -= x;
    const dvec3 differenceAt = glm::abs(residual_[i]);
    dvec3 largest(0);
    for (std::size_t j = 0; j < row.size(); ++j) {
        const dvec3 now = residual_[j] + reflectancePerArea_[j] * (row[j] * x);
        residual_[j] = now;
        largest = glm::max(largest, glm::max(now, -now)); // |r| as the larger of r and -r, without a branch
    }
    largestResidual_ = largest;
    largestRadiosity_ = glm::max(largestRadiosity_, glm::abs(radiosity_[i])); // an upper bound of the old and the new B
    // What patch j receives, rho_j F_ji x, is at most q |x| and goes through three roundings; the other terms are those of `add`.
    const dvec3& q = reflects_.ofLargest;
    drift_ += kMargin * kRoundingUnit *
              (3.0 * q * glm::abs(x) + (1.0 + q) * glm::abs(radiosity_[i]) + largestResidual_ + differenceAt);
    workSinceFresh_ += 1.0 / static_cast<double>(size());
}

dvec3 Iterate::correction(std::size_t i) const {
    const dvec3 own = 1.0 - problem_.reflectance[i] * (problem_.exchange(i, i) / problem_.areas[i]);
    return {ratio(residual_[i].x, own.x), ratio(residual_[i].y, own.y), ratio(residual_[i].z, own.z)};
}

dvec3 Iterate::freshDrift() const {
    const dvec3 gatheredError = gatherRounding(size()) * reflects_.ofLargest * largestRadiosity_;
    // |E + rho F B| = |B + r|
    return kMargin * (gatheredError + kRoundingUnit * (largestRadiosity_ + 2.0 * largestResidual_));
}

glm::bvec3 Iterate::needsFreshResidual() const {
    if (workSinceFresh_ < 1) return glm::bvec3(false);
    const glm::bvec3 isLarge = glm::greaterThan(drift_, largestResidual_ / 4.0);
    const glm::bvec3 isWorthIt = glm::greaterThan(drift_, 2.0 * freshDrift());
    return {isLarge.x && isWorthIt.x, isLarge.y && isWorthIt.y, isLarge.z && isWorthIt.z};
}

void Iterate::recomputeResidual() {
    // [anchor: residual]
    residual_ = reflected(radiosity_);
    largestRadiosity_ = largestResidual_ = dvec3(0);
    for (std::size_t i = 0; i < size(); ++i) {
        residual_[i] = (problem_.emission[i] + residual_[i]) - radiosity_[i];
        largestRadiosity_ = glm::max(largestRadiosity_, glm::abs(radiosity_[i]));
        largestResidual_ = glm::max(largestResidual_, glm::abs(residual_[i]));
    }
    drift_ = freshDrift();
    workSinceFresh_ = 0;
}

ErrorBound Iterate::errorBound() const { return errorBound(dvec3(1), dvec3(1), 0); }

ErrorBound Iterate::errorBoundWithResidual() const { return errorBound(reflects_.ofLargest, reflects_.ofPower, 1); }

ErrorBound Iterate::errorBound(const dvec3& factorLargest, const dvec3& factorPower, double inSum) const {
    // The sum below has only positive terms, with one rounding more than there are patches.
    const double sumMargin = 1 + 2 * (static_cast<double>(size()) + 2) * kRoundingUnit;
    dvec3 power(0);
    for (std::size_t i = 0; i < size(); ++i)
        power += problem_.areas[i] * glm::abs(residual_[i]);
    // B + r^ differs from B + r by the drift of r^, and is rounded itself.
    const dvec3 sumError = inSum * (drift_ + kRoundingUnit * (largestRadiosity_ + largestResidual_));
    ErrorBound bound;
    for (int c = 0; c < 3; ++c) {
        const double q = reflects_.ofLargest[c], qPower = reflects_.ofPower[c];
        bound.largest[c] = ratio(factorLargest[c] * (largestResidual_[c] + drift_[c]), 1 - q) + sumError[c];
        bound.largest[c] *= 1 + 4 * kRoundingUnit;
        // A bound of the largest error is also one of the power, and the only one where q' is 1 or more.
        bound.power[c] = totalArea_ * bound.largest[c];
        if (qPower < 1) {
            const double residualPower = power[c] + totalArea_ * drift_[c];
            const double byPower = ratio(factorPower[c] * residualPower, 1 - qPower) + totalArea_ * sumError[c];
            bound.power[c] = std::min(bound.power[c], byPower);
        }
        bound.power[c] *= sumMargin * sumMargin;
    }
    return bound;
}

} // namespace shadowlab::radiosity
