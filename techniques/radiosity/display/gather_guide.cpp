// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/gather_guide.h"

#include <algorithm>

#include <glm/gtc/constants.hpp>

#include "techniques/radiosity/patches/polygon_samples.h"

namespace shadowlab::radiosity {

namespace {

// What a ray in any direction brings has a variance. In units of the square of its mean, light is uneven above this. Half of the rays would find all of the
// light by choice, if patches were points: with variance 1 both kinds together are no better than one. Rays to chosen points also cost more, as many
// of them end before: at 1 the room with lamps took an eighth longer, and from 2 to 4 noise in a room with the sun on its floor grew by a twentieth.
constexpr double kUneven = 2;

// A patch that sees more than this share of its view outside stands under the open sky. The side of a box on a ground sees half of it.
constexpr double kOpenSky = 0.4;

// At least so many points of a patch are chosen alike everywhere: the lines by which its cells are known may have missed some of its light.
constexpr double kAlike = 0.2;

// Seen along its own plane, a surface is no smaller than this cosine makes it.
constexpr double kLeastCosine = 1e-9;

/// That variance, for a patch of that area: `exchange` S_ij, `sent` the luminance of each radiosity, and `sky` that of what comes from where it sees no surface.
double relativeVariance(std::span<const double> exchange, double area, std::span<const double> sent, double sky, double shareOfSky) {
    double mean = shareOfSky * sky, meanSquare = shareOfSky * sky * sky;
    for (std::size_t j = 0; j < sent.size(); ++j) {
        mean += exchange[j] / area * sent[j];
        meanSquare += exchange[j] / area * sent[j] * sent[j];
    }
    return mean > 0 ? meanSquare / (mean * mean) - 1 : 0;
}

/// The simplified objects that send more than others do, as no light is uneven by those that do not. `sent`: luminance of each of Room::patches().
std::vector<std::uint32_t> brightMeshes(const Room& room, std::span<const double> sent) {
    std::vector<double> ofObject(room.simple().scene->objects.size()), areas(ofObject.size());
    double all = 0, allAreas = 0;
    for (std::size_t j = 0; j < sent.size(); ++j) {
        const Patch& patch = room.patches()[j];
        const std::uint32_t object = room.faceOf(patch).object;
        ofObject[object] += patch.area * sent[j], all += patch.area * sent[j];
        areas[object] += patch.area, allAreas += patch.area;
    }
    std::vector<std::uint32_t> bright;
    for (std::uint32_t object = 0; object < ofObject.size(); ++object)
        if (room.isSimplified(object) && ofObject[object] * allAreas > kUneven * all * areas[object]) bright.push_back(object);
    return bright;
}

/// Of ascending sums up to 1, what that place adds.
double stepOf(std::span<const float> upTo, std::size_t place) {
    return static_cast<double>(upTo[place]) - (place > 0 ? static_cast<double>(upTo[place - 1]) : 0);
}

/// Of ascending sums up to 1, the place of the first above `which`, and how far `which` goes beyond the sum before it, as a share of the step.
std::pair<std::uint32_t, double> chosenOf(std::span<const float> upTo, double which) {
    const auto above = std::ranges::upper_bound(upTo, static_cast<float>(which)); // rounded to 1 it is the end: then the last that has a share
    const auto found = above == upTo.end() ? std::ranges::lower_bound(upTo, upTo.back()) : above;
    const auto place = static_cast<std::uint32_t>(found - upTo.begin());
    const double step = stepOf(upTo, place);
    return {place, glm::clamp((which - static_cast<double>(*found)) / step + 1, 0.0, 1.0)};
}

} // namespace

double densityOfDirection(double density, double distance, double cosineThere) {
    return density * distance * distance / std::max(cosineThere, kLeastCosine);
}

GatherGuide::GatherGuide(const RoomCache& cache, const Sources& sources, std::span<const dvec3> radiosity, const dvec3& outside)
    : room_(&cache.room()), targets_(sources.size(), kNone), upTo_(room_->patches().size()) {
    const ExchangeMatrix& exchange = cache.exchange().matrix;
    const auto count = static_cast<std::uint32_t>(upTo_.size());
    std::vector<double> sent(count), emitted(count);
    for (std::uint32_t j = 0; j < count; ++j) {
        sent[j] = luminance(radiosity[j]);
        emitted[j] = luminance(sources.emission[j]);
    }
    for (const std::uint32_t object : brightMeshes(*room_, sent))
        addMesh(cache, object, sent);
    const std::size_t targets = meshes_.empty() ? count : meshes_.back().first + meshes_.back().aim->groups();
    for (std::uint32_t j = 0; j < count; ++j) {
        const std::uint32_t object = room_->faceOf(room_->patches()[j]).object;
        const auto mesh = std::ranges::find(meshes_, object, &Mesh::object);
        if (mesh != meshes_.end()) targets_[j] = mesh->first;
        if (!room_->isSimplified(object)) targets_[j] = j;
        spreads_.push_back(targets_[j] == j ? spreadOf(cache, sources, j, sent[j]) : std::nullopt);
    }
    const double sky = glm::pi<double>() * luminance(outside);
    forRows(count, [&](std::size_t i) {
        const Patch& patch = room_->patches()[i];
        const std::span<const double> row = exchange.row(i), from = isOpen(static_cast<std::uint32_t>(i)) ? emitted : sent;
        if (relativeVariance(row, patch.area, from, sky, room_->surroundings()[i]) <= kUneven) return;
        std::vector<double> sums(targets);
        for (std::size_t j = 0; j < count; ++j)
            if (targets_[j] != kNone) sums[targets_[j]] += row[j] * from[j];
        for (const Mesh& mesh : meshes_)
            shareOut(static_cast<std::uint32_t>(i), mesh, std::span(sums).subspan(mesh.first, mesh.aim->groups()));
        for (std::size_t j = 1; j < sums.size(); ++j)
            sums[j] += sums[j - 1];
        if (!(sums.back() > 0)) return;
        upTo_[i].resize(sums.size());
        std::ranges::transform(sums, upTo_[i].begin(), [&](double one) { return static_cast<float>(one / sums.back()); });
    });
}

/// `sent`: the luminance of each of Room::patches().
void GatherGuide::addMesh(const RoomCache& cache, std::uint32_t object, std::span<const double> sent) {
    const auto first = meshes_.empty() ? sent.size() : meshes_.back().first + meshes_.back().aim->groups();
    Mesh mesh{object, &cache.aimOf(object), static_cast<std::uint32_t>(first)};
    double all = 0, area = 0;
    for (std::size_t j = 0; j < sent.size(); ++j)
        if (const Patch& patch = room_->patches()[j]; room_->faceOf(patch).object == object) all += patch.area * sent[j], area += patch.area;
    mesh.reflected = std::max(all - mesh.aim->emitted(), 0.0) / area;
    meshes_.push_back(mesh);
}

/// Gives each group its part of what comes from the whole mesh, which is in the first of them.
void GatherGuide::shareOut(std::uint32_t at, const Mesh& mesh, std::span<double> targets) const {
    const Patch& patch = room_->patches()[at];
    const Receiver receiver{room_->world().originWorld + patch.centre, patch.normal, patch.area};
    const double all = targets.front();
    double sum = 0;
    for (std::size_t g = 0; g < targets.size(); ++g)
        sum += targets[g] = mesh.aim->likely(g, receiver, mesh.reflected);
    for (double& target : targets) target *= sum > 0 ? all / sum : 0;
}

/// Whose group that is; none: it is a patch.
const GatherGuide::Mesh* GatherGuide::meshOf(std::uint32_t target) const {
    if (target < room_->patches().size()) return nullptr;
    return &*std::prev(std::ranges::upper_bound(meshes_, target, {}, &Mesh::first));
}

/// `sent`: the luminance of all that the patch sends.
std::optional<GatherGuide::Spread> GatherGuide::spreadOf(const RoomCache& cache, const Sources& sources, std::uint32_t patch, double sent) {
    const Patch& of = cache.room().patches()[patch];
    Spread spread{PatchCells(of.polygon), {}, 0};
    std::array<double, PatchCells::kCount> ofCells{};
    double all = 0, most = 0;
    for (const DirectLight* light : cache.lights())
        for (std::size_t c = 0; c < ofCells.size(); ++c)
            ofCells[c] += luminance(sources.reflectance[patch] * light->irradiance[patch]) * static_cast<double>(light->cells[patch][c]);
    if (const PathLight& paths = cache.pathLight(); paths.hasCells(patch)) {
        const PatchCells& fine = *paths.cells[patch];
        for (std::size_t c = 0; c < fine.count(); ++c)
            ofCells[spread.cells.at(fine.pointIn(c, dvec2(0.5)))] += luminance(sources.reflectance[patch] * dvec3(paths.ofCells[paths.firstCell[patch] + c])) * fine.area() / of.area;
    }
    for (const double one : ofCells)
        all += one, most = std::max(most, one);
    // Where no cell has twice its share, choosing by them gains less than a point to a cell is worth.
    if (!(most * PatchCells::kCount > 2 * all)) return std::nullopt;
    spread.share = std::min(1 - kAlike, all / sent);
    double sum = 0;
    for (std::size_t c = 0; c < ofCells.size(); ++c)
        spread.upTo[c] = static_cast<float>((sum += ofCells[c]) / all);
    return spread;
}

bool GatherGuide::isOpen(std::uint32_t at) const { return room_->surroundings()[at] > kOpenSky; }

const GatherGuide::Spread* GatherGuide::spread(std::uint32_t at, std::uint32_t patch) const {
    return spreads_[patch] && !isOpen(at) ? &*spreads_[patch] : nullptr;
}

double GatherGuide::share(std::uint32_t at, std::uint32_t target) const { return stepOf(upTo_[at], target); }

double GatherGuide::densityOfPoint(std::uint32_t at, std::uint32_t patch, const dvec3& positionWorld) const {
    const double alike = 1 / room_->patches()[patch].area;
    const Spread* by = spread(at, patch);
    const double within = by ? (1 - by->share) * alike + by->share * stepOf(by->upTo, by->cells.at(positionWorld - room_->world().originWorld)) / by->cells.area() : alike;
    return share(at, patch) * within;
}

std::optional<GatherGuide::Way> GatherGuide::choose(std::uint32_t at, const dvec3& fromWorld, double which, const dvec2& where) const {
    const auto [target, rest] = chosenOf(upTo_[at], which);
    if (const Mesh* mesh = meshOf(target)) {
        const auto way = mesh->aim->choose(target - mesh->first, fromWorld, rest, where);
        if (!way) return std::nullopt;
        return Way{way->direction, share(at, target) * way->density, way->distance, mesh->aim->usesSpheres() ? std::optional(mesh->object) : std::nullopt};
    }
    const Patch& patch = room_->patches()[target];
    const Spread* by = spread(at, target);
    const dvec3 point = room_->world().originWorld + (by && rest < by->share ? by->cells.pointIn(chosenOf(by->upTo, rest / by->share).first, where)
                                                                              : evenPlaceIn(patch.polygon, where.x, where.y));
    const double distance = glm::distance(point, fromWorld);
    const bool isBeside = by && !holds(patch.polygon, point - room_->world().originWorld, patch.normal);
    if (isBeside || !(distance > kContactDistance)) return std::nullopt;
    const dvec3 direction = (point - fromWorld) / distance;
    const double cosineThere = -glm::dot(direction, patch.normal);
    if (cosineThere <= 0) return std::nullopt;
    return Way{direction, densityOfDirection(densityOfPoint(at, target, point), distance, cosineThere), distance, std::nullopt};
}

double GatherGuide::density(std::uint32_t at, const dvec3& fromWorld, const dvec3& direction, const Found& found) const {
    const std::uint32_t target = targets_[found.patch];
    if (target == kNone) return 0;
    if (const Mesh* mesh = meshOf(target)) {
        const std::uint32_t group = mesh->aim->groupOf(found.triangleInMesh);
        return share(at, mesh->first + group) * mesh->aim->density(group, fromWorld, direction, found.distance, found.cosineThere);
    }
    return densityOfDirection(densityOfPoint(at, target, fromWorld + found.distance * direction), found.distance, found.cosineThere);
}

} // namespace shadowlab::radiosity
