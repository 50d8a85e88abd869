// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/path_light.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/math/radical_inverse.h"
#include "techniques/foundation/math/random_pair.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/radiosity/display/aimed_rays.h"
#include "techniques/radiosity/lights/lamps_between.h"

namespace shadowlab::radiosity {

namespace {

// So many paths leave all emitters together. If a fifth of them gets out of a gap, that is some two hundred for each of 600 patches: each of these is right to
// some hundredths, and what all of them send on to some thousandths.
constexpr int kPieces = 128, kPathsInPiece = 4096, kPaths = kPieces * kPathsInPiece;

// So many pieces are done before what they found is added up: each has a list of its own.
constexpr std::size_t kTogether = 8;

// Cells are so many in all that a dozen paths meet each; of one patch no more than lets them be some millimetres wide.
constexpr double kCells = 1e5;
constexpr std::size_t kMostOnSide = 48, kLeastOnSide = 4;

// Of the square of the side of a cell of simplified meshes, this share is what its triangles measure when they are cut once.
constexpr double kLeastOfCell = 0.25;

/// The surface of a ball over that of its mesh, whose flat faces lie within it: as much more they must send, to send what the ball does.
double meshFactor(const scene::Light& lamp, const scene::Object& surface) {
    return lamp.type == scene::LightType::sphere ? 4 * glm::pi<double>() * lamp.radius * lamp.radius / surfaceArea(surface) : 1;
}

} // namespace

bool Followed::any() const { return std::ranges::find(patches, 1) != patches.end(); }

PathLightBuilder::PathLightBuilder(const Room& room, const SurfaceCells& cells, const scene::Snapshot& drawn, const Followed& followed)
    : room_(room), cells_(cells), followed_(followed), drawn_(drawn), pieces_(kPieces) {}

bool PathLightBuilder::advance(std::chrono::steady_clock::time_point deadline) {
    if (!tracer_.advance(drawn_, deadline)) return false;
    if (!isPrepared_) {
        findEmitters();
        prepareCells();
        isPrepared_ = true;
    }
    if (emitters_.empty()) nextPiece_ = kPieces;
    while (nextPiece_ < kPieces) {
        const std::size_t first = nextPiece_, end = std::min(first + kTogether, std::size_t{kPieces});
        nextPiece_ = trace::parallelUntil(deadline, first, end, [&](std::size_t piece) { follow(piece); });
        for (std::size_t piece = first; piece < nextPiece_; ++piece)
            merge(piece);
        if (nextPiece_ < end) return false;
    }
    return true;
}

/// The sides of triangles that emit, and are followed; of lights their fronts.
void PathLightBuilder::findEmitters() {
    std::map<int, double> factors; // of lights
    for (std::uint32_t t = 0; t < tracer_.bvh().triangles.size(); ++t)
        for (const bool isFront : {true, false}) {
            const trace::SurfacePoint middle{t, isFront, dvec2(1.0 / 3)};
            const int light = tracer_.objectOf(middle).emitterOfLight;
            if (light >= 0) {
                const scene::Light& source = drawn_->light(light);
                if (!isFront || followed_.lights[static_cast<std::size_t>(light)] == 0) continue;
                if (!factors.contains(light)) factors[light] = meshFactor(source, tracer_.objectOf(middle));
                add(middle, factors[light] * glm::pi<double>() * source.intensity * dvec3(source.color), false, true);
            } else if (const auto patch = patchOf(middle, cells_, tracer_); patch && followed_.hasPatch(*patch)) {
                const Patch& of = room_.patches()[*patch];
                add(middle, emittedAt(tracer_, middle), room_.isSimplified(room_.faceOf(of).object), false);
            }
        }
}

void PathLightBuilder::add(const trace::SurfacePoint& middle, const dvec3& radiosity, bool isSimplified, bool isLight) {
    const dvec3 watts = 0.5 * glm::length(trace::frontOf(tracer_.bvh().triangles[middle.primitive])) * radiosity;
    const double before = emitters_.empty() ? 0 : emitters_.back().upTo;
    if (luminance(watts) > 0) emitters_.push_back({middle, watts, isSimplified, isLight, before + luminance(watts)});
}

void PathLightBuilder::prepareCells() {
    const std::vector<Patch>& patches = room_.patches();
    const auto followed = static_cast<double>(std::ranges::count(followed_.patches, 1));
    const auto side = std::clamp(static_cast<std::size_t>(std::sqrt(kCells / std::max(followed, 1.0))), kLeastOnSide, kMostOnSide);
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const bool hasCells = followed_.hasPatch(i) && !room_.isSimplified(room_.faceOf(patches[i]).object);
        found_.firstCell.push_back(count);
        found_.cells.push_back(hasCells ? std::optional(PatchCells(patches[i].polygon, side)) : std::nullopt);
        if (hasCells) count += static_cast<std::uint32_t>(found_.cells.back()->count());
    }
    found_.irradiance.resize(patches.size());
    found_.ofCells.resize(count);
}

void PathLightBuilder::follow(std::size_t piece) {
    Arriving& arriving = pieces_[piece];
    arriving.atPatches.resize(room_.patches().size());
    arriving.atCells.resize(found_.ofCells.size());
    const dvec3 roomFromDrawn = tracer_.world().originWorld - room_.world().originWorld;
    const auto isLamp = [&](const trace::SurfacePoint& point) { return tracer_.objectOf(point).emitterOfLight >= 0; };
    for (int i = 0; i < kPathsInPiece; ++i) {
        const int path = static_cast<int>(piece) * kPathsInPiece + i;
        const double which = (path + 0.5) / kPaths * emitters_.back().upTo;
        const Emitter& emitter = *std::ranges::upper_bound(emitters_, which, {}, &Emitter::upTo);
        dvec3 watts = emitter.watts * (emitters_.back().upTo / (luminance(emitter.watts) * kPaths));
        trace::SurfacePoint from = placeOn(emitter.middle, {radicalInverse(path, 2), radicalInverse(path, 3)});
        dvec2 unit{radicalInverse(path, 5), radicalInverse(path, 7)};
        std::uint64_t key = static_cast<std::uint64_t>(path) << 32u;
        for (bool isReflected = false;; isReflected = true) {
            const dvec3 direction = diffuseDirection(tracer_, from, unit);
            trace::SurfacePoint met = tracer_.nextPoint(from, direction);
            while (met && emitter.isLight && !isReflected && isLamp(met)) // lamps cast no shadow, but take in what surfaces reflect
                met = tracer_.nextPoint(met, direction);
            if (!met || isLamp(met)) break;
            const auto patch = patchOf(met, cells_, tracer_);
            if (!patch || *patch >= room_.patches().size()) break;
            if (isReflected || emitter.isSimplified) arriving.atPatches[*patch] += watts;
            if (!followed_.hasPatch(*patch)) break;
            if (const auto& cells = found_.cells[*patch]; cells && (isReflected || !emitter.isLight))
                arriving.atCells[found_.firstCell[*patch] + cells->at(tracer_.positionCentred(met) + roomFromDrawn)] += vec3(watts);
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

/// Always in the same order, so that sums are the same to the last bit.
void PathLightBuilder::merge(std::size_t piece) {
    const Arriving arriving = std::move(pieces_[piece]);
    for (std::size_t i = 0; i < found_.irradiance.size(); ++i)
        found_.irradiance[i] += arriving.atPatches[i];
    for (std::size_t c = 0; c < found_.ofCells.size(); ++c)
        found_.ofCells[c] += arriving.atCells[c];
}

/// From what arrives at each patch, W. A simplified mesh lies beside what is drawn, by up to a cell of its own, so a small patch may be the nearest to a surface of many times
/// its area: what arrives there is shared by all of its face, and if that is small, too, by all of the object.
std::vector<dvec3> PathLightBuilder::irradianceOf(const std::vector<dvec3>& watts) const {
    struct Shared {
        dvec3 watts{0.0};
        double area = 0;
        void add(const dvec3& more, double areaThere) { watts += more, area += areaThere; }
        [[nodiscard]] dvec3 irradiance() const { return watts / area; }
    };
    const std::vector<Patch>& patches = room_.patches();
    const auto areaOf = [&](const Patch& patch) { return patch.area * room_.areaFactor(patch); };
    std::map<std::size_t, Shared> faces, objects;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        faces[patches[i].face].add(watts[i], areaOf(patches[i]));
        objects[room_.faceOf(patches[i]).object].add(watts[i], areaOf(patches[i]));
    }
    const double least = kLeastOfCell * room_.simple().cellMetres * room_.simple().cellMetres;
    std::vector<dvec3> irradiance(patches.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const std::uint32_t object = room_.faceOf(patches[i]).object;
        const Shared own{watts[i], areaOf(patches[i])}, &face = faces[patches[i].face];
        const bool isLarge = !room_.isSimplified(object) || own.area >= least;
        irradiance[i] = (isLarge ? own : face.area >= least ? face : objects[object]).irradiance();
    }
    return irradiance;
}

PathLight PathLightBuilder::take() {
    found_.irradiance = irradianceOf(found_.irradiance);
    for (std::size_t i = 0; i < found_.cells.size(); ++i) {
        const Patch& patch = room_.patches()[i];
        if (!found_.cells[i]) continue;
        const std::vector<double> areas = found_.cells[i]->areasIn(patch.polygon);
        for (std::size_t c = 0; c < areas.size(); ++c) {
            vec3& ofCell = found_.ofCells[found_.firstCell[i] + c];
            ofCell = areas[c] > 0 ? vec3(dvec3(ofCell) / areas[c]) : vec3(0);
        }
    }
    return std::move(found_);
}

dvec3 PathLight::at(std::uint32_t patch, const dvec3& positionCentred) const {
    return dvec3(ofCells[firstCell[patch] + cells[patch]->at(positionCentred)]);
}

} // namespace shadowlab::radiosity
