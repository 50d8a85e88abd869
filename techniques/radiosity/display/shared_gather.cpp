// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/shared_gather.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::radiosity {

namespace {

// Every fourth pixel of every fourth row gathers: a sixteenth of all.
constexpr int kSpacing = 4;

// A record counts up to this error (in shares of its irradiance, by Ward's estimate), and the less the nearer to it.
constexpr double kMostError = 0.25;

// Records of the lattice that a pixel looks at: so many before and behind, across and along.
constexpr int kReach = 2;

// Less weight than that of one record without error, and a pixel gathers by itself.
constexpr double kLeastWeight = 1.0;

// A record farther from the pixel's plane than this share of its range lies on another surface.
constexpr double kOffThePlane = 0.05;

// The range of a point whose rays meet nothing: farther than any scene reaches, metres.
constexpr double kSeesNothing = 1e30;

// Pieces of work of a thread.
constexpr std::size_t kPiece = 16;

/// R, metres: what emitters bring, as much as it is of all, changes with the distance to them.
double rangeOf(const Gathered& sum) {
    const double all = std::max(luminance(sum.irradiance), 1e-300);
    const double ofOthers = 1 - std::min(1.0, sum.fromEmitters / all);
    const double nearness = (sum.met > 0 ? ofOthers * sum.nearness / static_cast<double>(sum.met) : 0) + sum.nearnessOfEmitters / all;
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
    [[nodiscard]] double weight() const { return weight_; }
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

/// The pixel that gathers for a cell of the lattice: its middle.
ivec2 SharedGather::latticePixel(ivec2 cell) const { return glm::min(kSpacing * cell + kSpacing / 2, key_.seenFrom.size - 1); }

ivec2 SharedGather::cells() const { return (key_.seenFrom.size + kSpacing - 1) / kSpacing; }

vec4& SharedGather::pixelFromBelow(ivec2 pixel) {
    const ivec2 size = key_.seenFrom.size;
    return irradianceFromBelow_[static_cast<std::size_t>(size.y - 1 - pixel.y) * static_cast<std::size_t>(size.x) +
                                static_cast<std::size_t>(pixel.x)];
}

bool SharedGather::advance(const GatherSolution& solution, const PixelLight& light, std::size_t rays, Deadline deadline) {
    if (GatherKey key{solution.version, light.seenFrom(), light.tracer().scene().lights, rays}; records_.empty() || key != key_) {
        key_ = std::move(key);
        records_.assign(static_cast<std::size_t>(cells().x) * static_cast<std::size_t>(cells().y), {});
        irradianceFromBelow_.assign(static_cast<std::size_t>(light.size().x) * static_cast<std::size_t>(light.size().y), vec4(0, 0, 0, 1));
        nextRecord_ = nextAlone_ = 0;
        isShared_ = false;
        alone_.clear();
        ++version_;
    }
    const auto pieces = [](std::size_t count) { return (count + kPiece - 1) / kPiece; };
    const auto inPieces = [](std::size_t count, const auto& work) {
        return [count, &work](std::size_t piece) {
            for (std::size_t i = piece * kPiece; i < std::min(count, (piece + 1) * kPiece); ++i)
                work(i);
        };
    };
    const auto gatherRecord = [&](std::size_t i) {
        const ivec2 cell(static_cast<int>(i) % cells().x, static_cast<int>(i) / cells().x);
        records_[i] = recordAt(solution, light, latticePixel(cell), key_.rays);
    };
    nextRecord_ = trace::parallelUntil(deadline, nextRecord_, pieces(records_.size()), inPieces(records_.size(), gatherRecord));
    if (nextRecord_ < pieces(records_.size())) return false;
    if (!isShared_) share(light);
    isShared_ = true;
    const auto gatherAlone = [&](std::size_t i) {
        const Record record = recordAt(solution, light, alone_[i], (key_.rays + 1) / 2);
        pixelFromBelow(alone_[i]) = vec4(vec3(record.irradiance), 1.0f);
    };
    nextAlone_ = trace::parallelUntil(deadline, nextAlone_, pieces(alone_.size()), inPieces(alone_.size(), gatherAlone));
    return nextAlone_ == pieces(alone_.size());
}

SharedGather::Record SharedGather::recordAt(const GatherSolution& solution, const PixelLight& light, ivec2 pixel,
                                            std::size_t count) const {
    const trace::SurfacePoint& point = light.pointAt(pixel);
    if (!point) return {};
    const Gathered sum = gather(solution, light, pixel, 0, count);
    return {true, light.tracer().positionCentred(point), light.normalWorld(point), sum.irradiance / static_cast<double>(count),
            rangeOf(sum)};
}

void SharedGather::share(const PixelLight& light) {
    const auto height = static_cast<std::size_t>(light.size().y);
    std::vector<std::vector<ivec2>> aloneInRow(height);
    trace::parallelFor(height, [&](std::size_t row) {
        for (int x = 0; x < light.size().x; ++x) {
            const ivec2 pixel(x, static_cast<int>(row));
            if (!light.pointAt(pixel)) continue;
            if (dvec3 irradiance(0); takeOver(light, pixel, irradiance))
                pixelFromBelow(pixel) = vec4(vec3(irradiance), 1.0f);
            else
                aloneInRow[row].push_back(pixel);
        }
    });
    for (const std::vector<ivec2>& row : aloneInRow)
        alone_.insert(alone_.end(), row.begin(), row.end());
}

/// A plane through what pixels around have found, each by its weight: its value at this place. (A mean would be wrong wherever all of
/// them lie to one side.) False: they know too little of this place.
// [anchor: shared-gather]
bool SharedGather::takeOver(const PixelLight& light, ivec2 pixel, dvec3& irradiance) const {
    const trace::SurfacePoint& point = light.pointAt(pixel);
    const dvec3 positionCentred = light.tracer().positionCentred(point), normal = light.normalWorld(point);
    const ivec2 here = pixel / kSpacing;
    PlaneFit fit;
    for (int y = std::max(0, here.y - kReach); y <= std::min(cells().y - 1, here.y + kReach); ++y)
        for (int x = std::max(0, here.x - kReach); x <= std::min(cells().x - 1, here.x + kReach); ++x) {
            const Record& record = records_[static_cast<std::size_t>(y * cells().x + x)];
            if (!record.isThere) continue;
            const dvec3 way = record.positionCentred - positionCentred;
            if (std::abs(glm::dot(way, normal)) > kOffThePlane * record.range) continue;
            const double error = glm::length(way) / record.range + std::sqrt(std::max(0.0, 1 - glm::dot(normal, record.normal)));
            const dvec2 offset = dvec2(latticePixel({x, y}) - pixel) / static_cast<double>(kSpacing);
            const dvec2 tent = glm::max(dvec2(0), 1.0 - glm::abs(offset) / (kReach + 0.5));
            fit.add(offset, record.irradiance, tent.x * tent.y * std::max(0.0, 1 - error / kMostError));
        }
    irradiance = fit.atMiddle();
    return fit.weight() >= kLeastWeight;
}

} // namespace shadowlab::radiosity
