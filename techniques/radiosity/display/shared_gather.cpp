// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/shared_gather.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "techniques/foundation/math/morton.h"
#include "techniques/foundation/math/random_pair.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::radiosity {

namespace {

// At first every eighth pixel of every eighth row gathers, a 64th of all; in small pictures more, so that there are this many rows
// of them: a plane through pixels that lie farther apart would cut off the peaks of light.
constexpr int kWidestSpacing = 8, kLeastRows = 64;

// Pixels that are nearer to each other than this, on leaves and in corners, send fewer rays: where they are dense, many share theirs.
constexpr int kFullSpacing = 4;

constexpr std::int32_t kNone = -1;

// A record counts up to this error (in shares of its irradiance, by Ward's estimate), and the less the nearer to it. That is the error of
// one record alone; a plane through several lies much nearer. With 0.25 a fifth more rays were sent, and pictures were no better.
constexpr double kMostError = 0.35;

// Records of the lattice that a pixel looks at: so many before and behind, across and along. Where all pixels may gather, along few rays, more.
constexpr int kReach = 2, kReachOfPixels = 6;

// Ward's error of a record that is so many steps of the widest lattice away need not be larger than 1: closer to a corner than that, pixels
// would share nothing, and one would see the noise of each (the least radius of G. Ward and P. Heckbert, "Irradiance Gradients", Eurographics
// Workshop on Rendering 1992). Where all pixels may gather it is larger, as they have nothing else. In small pictures, where all pixels gather along all
// rays, it is two pixels, and nothing is shared.
constexpr double kLeastRangeSteps = 2, kLeastRangeStepsOfPixels = 3;

// Less weight than that of one record without error, and a pixel takes nothing over. Where small sources bring much of the light, so that rays also go to chosen points,
// records have more noise, and it must be that of two; of the narrow lattices even more, by the square of the share of rays that theirs send, once for these and once because a
// plane through records so close to each other has steep slopes. (One would see their noise as dashes along the corners of a room that a small lamp lights.)
constexpr double kLeastWeight = 1, kLeastWeightOfChosen = 2;

// A record farther from the pixel's plane than this share of its range lies on another surface.
constexpr double kOffThePlane = 0.05;

// So far a pixel looks, along its row and its column, for surfaces that rise before its own: a lamp under a ceiling, a wall in a corner. Its
// range is then about so many times the distance to them, whatever records around say that do not see them. What counts rises by more than
// 30 degrees (the sine): the flutes of a column rise by less, and would let most of its pixels gather.
constexpr int kLook = 2;
constexpr double kRangeOfNear = 4, kRises = 0.5;

// The range of a point whose rays meet nothing: farther than any scene reaches, metres.
constexpr double kSeesNothing = 1e30;

// Pieces of work of a thread.
constexpr std::size_t kPiece = 16;
std::size_t piecesOf(std::size_t count) { return (count + kPiece - 1) / kPiece; }

/// Work on one of `count` things, as work on a piece of them.
auto inPieces(std::size_t count, const auto& work) {
    return [count, &work](std::size_t piece) {
        for (std::size_t i = piece * kPiece; i < std::min(count, (piece + 1) * kPiece); ++i)
            work(i);
    };
}

/// The rays of a place of the lattice. Those of a tile of 8 x 8 places follow one another in one sequence, along Morton's curve, so that
/// the rays of some neighbours together fill the half sphere as evenly as those of one, and a plane through what they found has little
/// noise. Tiles have sequences of their own: else edges of light would show them.
GatherRays raysOf(ivec2 place, std::size_t count) {
    constexpr int kBits = 3, kTile = 1 << kBits;
    return {randomPair(pixelKey(place / kTile)), alongMortonCurve(place, kBits) * count, count};
}

/// R, metres: what chosen points bring, as much as it is of all, changes with the distance to them.
double rangeOf(const Gathered& sum) {
    const double all = std::max(luminance(sum.irradiance), 1e-300);
    const double ofOthers = 1 - std::min(1.0, sum.fromChosen / all);
    const double nearness = (sum.met > 0 ? ofOthers * sum.nearness / static_cast<double>(sum.met) : 0) + sum.nearnessOfChosen / all;
    return nearness > 1 / kSeesNothing ? 1 / nearness : kSeesNothing;
}

/// A linear function of the offset, v + dot(slope, offset), that fits weighted values best (least squares).
class PlaneFit {
public:
    void add(dvec2 offset, const dvec3& value, double weight) {
        weight_ += weight;
        offsets_ += weight * offset;
        xx_ += weight * offset.x * offset.x;
        xy_ += weight * offset.x * offset.y;
        yy_ += weight * offset.y * offset.y;
        values_ += weight * value;
        alongX_ += weight * offset.x * value;
        alongY_ += weight * offset.y * value;
    }
    /// The weight of as many values at the middle itself as would know it as exactly. Where all lie to one side it is small: there a plane
    /// goes on beyond them.
    [[nodiscard]] double weightAtMiddle() const {
        const double xx = xx_ + kLevel * weight_, yy = yy_ + kLevel * weight_;
        const double area = xx * yy - xy_ * xy_;
        if (!(area > 0)) return weight_;
        return weight_ - (yy * offsets_.x * offsets_.x - 2 * xy_ * offsets_.x * offsets_.y + xx * offsets_.y * offsets_.y) / area;
    }
    /// v, not below 0. Where all lie on a line, the slope across it is taken to be 0.
    [[nodiscard]] dvec3 atMiddle() const {
        if (!(weight_ > 0)) return dvec3(0);
        const double level = kLevel * weight_, xx = xx_ + level, yy = yy_ + level;
        const dvec3 cofactors(xx * yy - xy_ * xy_, xy_ * offsets_.y - offsets_.x * yy, offsets_.x * xy_ - xx * offsets_.y);
        const double determinant = weight_ * cofactors.x + offsets_.x * cofactors.y + offsets_.y * cofactors.z;
        return glm::max(dvec3(0), (cofactors.x * values_ + cofactors.y * alongX_ + cofactors.z * alongY_) / determinant);
    }

private:
    // Pulls slopes toward 0, by far less than values a lattice step apart hold them.
    static constexpr double kLevel = 1e-3;
    double weight_ = 0, xx_ = 0, xy_ = 0, yy_ = 0;
    dvec2 offsets_{0.0};
    dvec3 values_{0.0}, alongX_{0.0}, alongY_{0.0};
};

} // namespace

std::size_t SharedGather::indexOf(ivec2 pixel) const {
    return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(key_.seenFrom.size.x) + static_cast<std::size_t>(pixel.x);
}

int SharedGather::widestSpacing() const {
    const int rows = std::min(key_.seenFrom.size.x, key_.seenFrom.size.y);
    return static_cast<int>(std::bit_floor(static_cast<unsigned>(std::clamp(rows / kLeastRows, 1, kWidestSpacing)))); // halved, its places stay
}

bool SharedGather::advance(const GatherSolution& solution, const PixelLight& light, std::size_t rays, Deadline deadline) {
    if (GatherKey key{solution.version, light.seenFrom(), light.tracer().scene().lights, rays}; spacing_ == 0 || key != key_) {
        key_ = std::move(key);
        restart(light);
    }
    while (!open_.empty()) {
        const std::size_t first = records_.size() - gathering_.size(), pieces = piecesOf(gathering_.size());
        const auto gatherOne = [&](std::size_t i) { records_[first + i] = recordAt(solution, light, gathering_[i]); };
        nextPiece_ = trace::parallelUntil(deadline, nextPiece_, pieces, inPieces(gathering_.size(), gatherOne));
        if (nextPiece_ < pieces || !share(light, deadline)) return false;
        if (isWhole_) spacing_ = std::max(1, spacing_ / 2);
        isWhole_ = !isWhole_;
        chooseGathering();
    }
    return true;
}

void SharedGather::restart(const PixelLight& light) {
    const ivec2 size = key_.seenFrom.size;
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    irradianceFromBelow_.assign(pixels, vec4(0, 0, 0, 1));
    recordOf_.assign(pixels, kNone);
    records_.clear();
    open_.clear();
    open_.reserve(pixels);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            if (light.pointAt({x, y})) open_.emplace_back(x, y);
    spacing_ = widestSpacing();
    isWhole_ = true;
    chooseGathering();
    ++version_;
}

/// Of the open pixels those on the lattice, or on every other of its places.
void SharedGather::chooseGathering() {
    gathering_.clear();
    for (const ivec2 pixel : open_)
        if (pixel.x % spacing_ == 0 && pixel.y % spacing_ == 0 && (isWhole_ || (pixel.x + pixel.y) / spacing_ % 2 == 0)) {
            recordOf_[indexOf(pixel)] = static_cast<std::int32_t>(records_.size() + gathering_.size());
            gathering_.push_back(pixel);
        }
    records_.resize(records_.size() + gathering_.size());
    nextPiece_ = nextShared_ = 0;
}

SharedGather::Record SharedGather::recordAt(const GatherSolution& solution, const PixelLight& light, ivec2 pixel) const {
    const auto count = static_cast<std::size_t>(std::ceil(shareOfRays() * static_cast<double>(key_.rays)));
    const trace::SurfacePoint& point = light.pointAt(pixel);
    const Gathered sum = gather(solution, light, pixel, raysOf(pixel / spacing_, count));
    return {light.tracer().positionCentred(point), light.normalWorld(point), sum.irradiance / static_cast<double>(count), rangeOf(sum), sum.fromChosen > 0};
}

/// Open pixels take over what they may. Of one that has gathered itself that is at least its own. True: all have been asked.
bool SharedGather::share(const PixelLight& light, Deadline deadline) {
    const int lastRow = key_.seenFrom.size.y - 1;
    isDone_.resize(open_.size());
    const auto shareOne = [&](std::size_t i) {
        dvec3 irradiance(0);
        isDone_[i] = takeOver(light, open_[i], irradiance);
        if (isDone_[i]) irradianceFromBelow_[indexOf({open_[i].x, lastRow - open_[i].y})] = vec4(vec3(irradiance), 1.0f);
    };
    nextShared_ = trace::parallelUntil(deadline, nextShared_, piecesOf(open_.size()), inPieces(open_.size(), shareOne));
    if (nextShared_ < piecesOf(open_.size())) return false;
    std::size_t next = 0;
    std::erase_if(open_, [&](const ivec2&) { return isDone_[next++] != 0; });
    return true;
}

/// The share of all rays that a record of this lattice has sent.
double SharedGather::shareOfRays() const {
    const int full = std::min(kFullSpacing, widestSpacing());
    return static_cast<double>(std::min(spacing_, full)) / full;
}

/// The range of the point that a pixel shows is not larger, as far as its neighbours tell, metres (J. Krivanek, K. Bouatouch, S. Pattanaik and
/// J. Zara, "Making Radiance and Irradiance Caching Practical: Adaptive Caching and Neighbor Clamping", EGSR 2006).
double SharedGather::mostRange(const PixelLight& light, ivec2 pixel, const dvec3& positionCentred, const dvec3& normal) const {
    double least = kSeesNothing;
    for (int step = -kLook; step <= kLook; ++step)
        for (const ivec2 other : {pixel + ivec2(step, 0), pixel + ivec2(0, step)}) {
            if (step == 0 || other != glm::clamp(other, ivec2(0), key_.seenFrom.size - 1)) continue;
            const trace::SurfacePoint& point = light.pointAt(other);
            if (!point || point.primitive == light.pointAt(pixel).primitive) continue;
            const dvec3 way = light.tracer().positionCentred(point) - positionCentred;
            const double square = glm::dot(way, way), height = glm::dot(way, normal);
            if (height > 0 && height * height > kRises * kRises * square) least = std::min(least, square);
        }
    return least < kSeesNothing ? kRangeOfNear * std::sqrt(least) : kSeesNothing;
}

/// A plane through what pixels around have found, each by its weight: its value at this place. (A mean would be wrong wherever all of
/// them lie to one side.) False: they know too little of this place.
// [anchor: shared-gather]
bool SharedGather::takeOver(const PixelLight& light, ivec2 pixel, dvec3& irradiance) const {
    const trace::SurfacePoint& point = light.pointAt(pixel);
    const dvec3 positionCentred = light.tracer().positionCentred(point), normal = light.normalWorld(point);
    const double mostRange = this->mostRange(light, pixel, positionCentred, normal);
    const ivec2 last = (key_.seenFrom.size - 1) / spacing_;
    const bool isOfPixels = spacing_ == 1 && widestSpacing() > 1;
    const double leastRange = (isOfPixels ? kLeastRangeStepsOfPixels : kLeastRangeSteps) * widestSpacing(); // pixels
    const int reach = isOfPixels ? kReachOfPixels : kReach;
    const ivec2 from = glm::max(pixel / spacing_ - reach, 0), to = glm::min((pixel + spacing_ - 1) / spacing_ + reach, last);
    PlaneFit fit;
    double ofChosen = 0, ofAll = 0;
    for (int y = from.y; y <= to.y; ++y)
        for (int x = from.x; x <= to.x; ++x) {
            const ivec2 giver = spacing_ * ivec2(x, y);
            const std::int32_t number = recordOf_[indexOf(giver)];
            const dvec2 offset = dvec2(giver - pixel) / static_cast<double>(spacing_);
            const dvec2 tent = glm::max(dvec2(0), 1.0 - glm::abs(offset) / (reach + 0.5));
            if (number == kNone || tent.x * tent.y == 0) continue;
            const Record& record = records_[static_cast<std::size_t>(number)];
            const dvec3 way = record.positionCentred - positionCentred;
            const double range = std::min(record.range, mostRange);
            if (std::abs(glm::dot(way, normal)) > kOffThePlane * range) continue;
            const double distance = std::min(glm::length(way) / range, glm::length(dvec2(giver - pixel)) / leastRange);
            const double error = distance + std::sqrt(std::max(0.0, 1 - glm::dot(normal, record.normal)));
            const double weight = tent.x * tent.y * std::max(0.0, 1 - error / kMostError);
            fit.add(offset, record.irradiance, weight);
            ofAll += weight;
            if (record.hasChosen) ofChosen += weight;
        }
    irradiance = fit.atMiddle();
    const double leastWeight = glm::mix(kLeastWeight, kLeastWeightOfChosen / (shareOfRays() * shareOfRays()), ofAll > 0 ? ofChosen / ofAll : 0);
    return fit.weightAtMiddle() >= leastWeight || recordOf_[indexOf(pixel)] != kNone;
}

} // namespace shadowlab::radiosity
