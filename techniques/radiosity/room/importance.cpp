// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/importance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/math/perpendicular.h"
#include "techniques/foundation/math/random_pair.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/radiosity/patches/polygon_samples.h"
#include "techniques/radiosity/room/sample_hemisphere.h"

namespace shadowlab::radiosity {

namespace {

// They meet each of the larger surfaces of a room some hundred times, which tells a sixteenth from one, in a few milliseconds.
constexpr int kPaths = 4096, kPathsOfPiece = 64;

// What a pixel gathers has been reflected once more than it is followed here. In a room whose walls reflect half, later surfaces together have an eighth.
constexpr std::size_t kReflections = 3;

// A patch with edges of length h is wrong by h^2 of what changes on it, and there are 1 / h^2 of them on an area. The sum of what is wrong, each part
// times its importance i, is least where i h^4 is everywhere the same: edges are doubled where there is a sixteenth of the importance.
constexpr double kForTwice = 16;
// Eight times: then a wall of a room is one patch.
constexpr int kMostDoublings = 3;

// A face is divided where its parts matter differently. Of so few points it cannot be told.
constexpr std::size_t kTellingPoints = 32;

// A part that no path has met counts as met by so much of one: where a quarter is expected, four of five times none comes.
constexpr double kUnmet = 0.25;

// Where less of the area matters little than this share, few patches are gained, and all are cut evenly.
constexpr double kWorthwhile = 1.0 / 3;

/// Where a path meets a surface, and with what it arrives there.
struct Arrival {
    std::uint32_t face = kNoFace;
    dvec3 positionCentred{0.0};
    double weight = 0;
};
using Path = std::array<Arrival, kReflections>;

/// Around all sides but those of a ground.
trace::CentredBox boxWithout(const Ground& ground, const Sides& sides) {
    trace::CentredBox box;
    for (std::uint32_t f = 0; f < sides.exchanging; ++f)
        if (!ground.holds(f)) box = around(box, boxOf(sides.faces.all[f].polygon));
    return box;
}

std::uint32_t sideOf(const Sides& sides, const trace::SurfacePoint& point) {
    return (point.eyeOnFront ? sides.faces.ofTriangle : sides.backOfTriangle)[point.primitive];
}

dvec3 directionOnSphere(const dvec2& unit) {
    const double z = 1 - 2 * unit.x, radius = std::sqrt(std::max(0.0, 1 - z * z)), turn = glm::two_pi<double>() * unit.y;
    return {radius * std::cos(turn), radius * std::sin(turn), z};
}

Path pathOf(int number, const trace::SceneTracer& tracer, const Sides& sides, const trace::EyeRays& eyeRays, const Eye& eye) {
    const auto x = hammersley4(number / 2, kPaths / 2);
    const bool isThroughPicture = number % 2 == 0;
    trace::SurfacePoint at = isThroughPicture ? tracer.eyePoint(eyeRays, dvec2(x[0], x[1]) * dvec2(eye.pictureSize))
                                              : tracer.nextPoint(eyeRays.eyeCentred(), trace::kNoPrimitive, directionOnSphere({x[0], x[1]}));
    Path path;
    double weight = 1;
    for (std::size_t i = 0; i < path.size() && at; ++i) {
        const std::uint32_t side = sideOf(sides, at);
        if (side == kNoFace) break; // the inside of a closed body
        const Face& face = sides.faces.all[side];
        weight *= luminance(dvec3(tracer.scene().materials[face.material].diffuse));
        const dvec2 unit = i == 0 ? dvec2(x[2], x[3]) : randomPair(static_cast<std::uint64_t>(number) * kReflections + i);
        const dvec3 &normal = face.plane.normal, tangent = perpendicularTo(normal);
        at = tracer.nextPoint(at, cosineDirection({tangent, glm::cross(normal, tangent)}, normal, unit));
        if (at) path[i] = {sideOf(sides, at), tracer.positionCentred(at), weight};
    }
    return path;
}

/// Of each side that exchanges light.
std::vector<std::vector<Arrival>> arrivals(const trace::SceneTracer& tracer, const Sides& sides, const Eye& eye) {
    const trace::EyeRays eyeRays = tracer.eyeRays(eye.camera, eye.pictureSize);
    std::vector<Path> paths(kPaths);
    trace::parallelFor(kPaths / kPathsOfPiece, [&](std::size_t piece) {
        for (std::size_t i = piece * kPathsOfPiece; i < (piece + 1) * kPathsOfPiece; ++i)
            paths[i] = pathOf(static_cast<int>(i), tracer, sides, eyeRays, eye);
    });
    std::vector<std::vector<Arrival>> found(sides.exchanging);
    for (const Path& path : paths)
        for (const Arrival& arrival : path)
            if (arrival.face < sides.exchanging) found[arrival.face].push_back(arrival);
    return found;
}

double weightOf(const std::vector<Arrival>& arrivals) {
    return std::accumulate(arrivals.begin(), arrivals.end(), 0.0, [](double sum, const Arrival& a) { return sum + a.weight; });
}

/// What matters in the middle, per area: half of all importance is where there is more of it.
double middleDensity(const Sides& sides, const std::vector<std::vector<Arrival>>& arrivals) {
    std::vector<std::pair<double, double>> ofFaces; // density and weight
    double all = 0;
    for (std::size_t f = 0; f < arrivals.size(); ++f) {
        const double weight = weightOf(arrivals[f]);
        if (weight > 0) ofFaces.emplace_back(weight / glm::length(areaVector(sides.faces.all[f].polygon)), weight);
        all += weight;
    }
    std::ranges::sort(ofFaces);
    double sum = 0;
    for (const auto& [density, weight] : ofFaces)
        if ((sum += weight) >= all / 2) return density;
    return 0;
}

/// Divides a face until all of a part matters alike, as far as can be told.
class Divider {
public:
    Divider(double middle, double ofOnePath) : middle_(middle), ofOnePath_(ofOnePath) {}

    void divide(const Patch& part, const std::vector<Arrival>& arrivals, std::vector<FacePart>& parts) const {
        const int doublings = doublingsOf(part, arrivals);
        const std::vector<Polygon> polygons = arrivals.size() < kTellingPoints ? std::vector<Polygon>{} : dividedPatch(part);
        std::vector<Patch> pieces;
        std::vector<std::vector<Arrival>> within(polygons.size());
        for (const Polygon& polygon : polygons)
            pieces.push_back(pieceOf(part, polygon));
        for (const Arrival& arrival : arrivals)
            for (std::size_t i = 0; i < pieces.size(); ++i)
                if (i + 1 == pieces.size() || holds(pieces[i].polygon, arrival.positionCentred, part.normal)) {
                    within[i].push_back(arrival);
                    break;
                }
        bool isAlike = true;
        for (std::size_t i = 0; i < pieces.size(); ++i)
            isAlike = isAlike && doublingsOf(pieces[i], within[i]) == doublings;
        if (isAlike || pieces.size() < 2) {
            parts.push_back({part.polygon, doublings});
            return;
        }
        for (std::size_t i = 0; i < pieces.size(); ++i)
            divide(pieces[i], within[i], parts);
    }

private:
    [[nodiscard]] int doublingsOf(const Patch& part, const std::vector<Arrival>& arrivals) const {
        const double density = (arrivals.empty() ? kUnmet * ofOnePath_ : weightOf(arrivals)) / part.area;
        int doublings = 0;
        for (double most = middle_ / kForTwice; doublings < kMostDoublings && density < most; most /= kForTwice)
            ++doublings;
        return doublings;
    }

    double middle_, ofOnePath_;
};

} // namespace

Importance::Importance(const trace::SceneTracer& tracer, const Sides& sides, const Ground& ground, const Eye& eye) {
    const std::vector<std::vector<Arrival>> found = arrivals(tracer, sides, inSteps(eye, boxWithout(ground, sides), tracer));
    double weight = 0;
    std::size_t count = 0;
    for (const std::vector<Arrival>& ofFace : found) {
        weight += weightOf(ofFace);
        count += ofFace.size();
    }
    if (count < kTellingPoints || weight == 0) return; // the eye sees next to nothing, or nothing that reflects
    const Divider divider(middleDensity(sides, found), weight / static_cast<double>(count));
    FaceParts parts(sides.exchanging);
    double area = 0, coarse = 0;
    for (std::uint32_t f = 0; f < sides.exchanging; ++f) {
        if (ground.holds(f)) continue;
        divider.divide(wholePatch(sides.faces.all[f], f), found[f], parts[f]);
        for (const FacePart& part : parts[f]) {
            const double ofPart = glm::length(areaVector(part.polygon));
            area += ofPart;
            coarse += part.doublings > 0 ? ofPart : 0;
        }
    }
    if (coarse < kWorthwhile * area) return;
    parts_ = std::move(parts);
    shareOfCoarse_ = coarse / area;
}

bool Importance::cutsLike(const Importance& other) const {
    const auto isSame = [](const FacePart& a, const FacePart& b) { return a.doublings == b.doublings; };
    return std::ranges::equal(parts_, other.parts_, [&](const auto& a, const auto& b) { return std::ranges::equal(a, b, isSame); });
}

} // namespace shadowlab::radiosity
