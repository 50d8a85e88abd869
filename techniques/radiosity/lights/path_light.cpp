// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/path_light.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/math/perpendicular.h"
#include "techniques/foundation/math/radical_inverse.h"
#include "techniques/foundation/math/random_pair.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/radiosity/display/aimed_rays.h"
#include "techniques/radiosity/room/sample_hemisphere.h"

namespace shadowlab::radiosity {

namespace {

// So many paths leave all emitters together. If a fifth of them gets out of a gap, that is some two hundred for each of 600 patches: each of these is right to
// some hundredths, and what all of them send on to some thousandths.
constexpr int kPieces = 256, kPathsInPiece = 2048, kPaths = kPieces * kPathsInPiece;

/// Uniform in the triangle: the unit square, folded along its diagonal.
dvec2 weightsAt(dvec2 square) {
    if (square.x + square.y > 1) square = 1.0 - square;
    return square;
}

} // namespace

bool Followed::any() const { return std::ranges::find(patches, 1) != patches.end(); }

PathLightBuilder::PathLightBuilder(const Room& room, const SurfaceCells& cells, const scene::Snapshot& drawn, const Followed& followed)
    : room_(room), cells_(cells), followed_(followed), drawn_(drawn), watts_(kPieces) {}

bool PathLightBuilder::advance(std::chrono::steady_clock::time_point deadline) {
    if (!tracer_.advance(drawn_, deadline)) return false;
    if (!hasEmitters_) findEmitters();
    hasEmitters_ = true;
    if (emitters_.empty()) return true;
    nextPiece_ = trace::parallelUntil(deadline, nextPiece_, kPieces, [&](std::size_t piece) { follow(piece); });
    return nextPiece_ == kPieces;
}

/// The sides of triangles that emit, and are followed; of lights their fronts.
void PathLightBuilder::findEmitters() {
    for (std::uint32_t t = 0; t < tracer_.bvh().triangles.size(); ++t)
        for (const bool isFront : {true, false}) {
            const trace::SurfacePoint middle{t, isFront, dvec2(1.0 / 3)};
            const int light = tracer_.objectOf(middle).emitterOfLight;
            if (light >= 0) {
                const scene::Light& source = drawn_->light(light);
                if (isFront && followed_.lights[static_cast<std::size_t>(light)] != 0)
                    add(middle, glm::pi<double>() * source.intensity * dvec3(source.color), false);
            } else if (const auto patch = patchOf(middle, cells_, tracer_); patch && followed_.hasPatch(*patch)) {
                const Patch& of = room_.patches()[*patch];
                add(middle, room_.emissionOf(of), room_.isSimplified(room_.faceOf(of).object));
            }
        }
}

void PathLightBuilder::add(const trace::SurfacePoint& middle, const dvec3& radiosity, bool isSimplified) {
    const dvec3 watts = 0.5 * glm::length(trace::frontOf(tracer_.bvh().triangles[middle.primitive])) * radiosity;
    const double before = emitters_.empty() ? 0 : emitters_.back().upTo;
    if (luminance(watts) > 0) emitters_.push_back({middle, watts, isSimplified, before + luminance(watts)});
}

void PathLightBuilder::follow(std::size_t piece) {
    std::vector<dvec3>& arriving = watts_[piece];
    arriving.resize(room_.patches().size());
    for (int i = 0; i < kPathsInPiece; ++i) {
        const int path = static_cast<int>(piece) * kPathsInPiece + i;
        const double which = (path + 0.5) / kPaths * emitters_.back().upTo;
        const Emitter& emitter = *std::ranges::upper_bound(emitters_, which, {}, &Emitter::upTo);
        dvec3 watts = emitter.watts * (emitters_.back().upTo / (luminance(emitter.watts) * kPaths));
        trace::SurfacePoint from{emitter.middle.primitive, emitter.middle.eyeOnFront, weightsAt({radicalInverse(path, 2), radicalInverse(path, 3)})};
        dvec2 unit{radicalInverse(path, 5), radicalInverse(path, 7)};
        std::uint64_t key = static_cast<std::uint64_t>(path) << 32u;
        for (bool counts = emitter.isSimplified;; counts = true) {
            const dvec3 normal = geometricNormal(tracer_, from), tangent = perpendicularTo(normal);
            const trace::SurfacePoint met = tracer_.nextPoint(from, cosineDirection({tangent, glm::cross(normal, tangent)}, normal, unit));
            if (!met || tracer_.objectOf(met).emitterOfLight >= 0) break;
            const auto patch = patchOf(met, cells_, tracer_);
            if (!patch || *patch >= room_.patches().size()) break;
            if (counts) arriving[*patch] += watts;
            if (!followed_.hasPatch(*patch)) break;
            // Russian roulette (J. Arvo and D. Kirk, "Particle Transport and Image Synthesis", SIGGRAPH 1990): what goes on is as bright as before.
            const dvec3 reflectance = reflectanceAt(tracer_, met);
            const double goesOn = std::max({reflectance.r, reflectance.g, reflectance.b});
            if (!(randomPair(key++).x < goesOn)) break;
            watts *= reflectance / goesOn;
            from = met;
            unit = randomPair(key++);
        }
    }
}

std::vector<dvec3> PathLightBuilder::take() const {
    std::vector<dvec3> irradiance(room_.patches().size());
    for (const std::vector<dvec3>& ofPiece : watts_)
        for (std::size_t i = 0; i < ofPiece.size(); ++i)
            irradiance[i] += ofPiece[i];
    for (std::size_t i = 0; i < irradiance.size(); ++i)
        irradiance[i] /= room_.patches()[i].area * room_.areaFactor(room_.patches()[i]);
    return irradiance;
}

} // namespace shadowlab::radiosity
