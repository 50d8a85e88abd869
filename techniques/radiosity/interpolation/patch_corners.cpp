// SPDX-License-Identifier: MIT
#include "techniques/radiosity/interpolation/patch_corners.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "techniques/foundation/base/disjoint_sets.h"

namespace shadowlab::radiosity {

namespace {

/// For each piece of border, the representative of its corner: the first of the pieces that begin at the same point and are
/// connected by walking from patch to patch about that point across continuous borders.
std::vector<std::uint32_t> roundEachPoint(const PatchBorders& borders) {
    DisjointSets joined(borders.pieces.size());
    for (std::uint32_t piece = 0; piece < borders.pieces.size(); ++piece)
        if (const std::uint32_t across = borders.pieces[piece].across; across != PatchBorders::kNone)
            joined.join(piece, borders.after(across)); // both begin at the end of `across`
    return joined.names();
}

struct LinearFit {
    std::vector<double> weights; ///< of each position
    bool isPlane = false;        ///< do the positions span a plane?
};

/// Least squares: the linear function on a plane that best fits values at some positions; its value at a corner is a weighted sum
/// of them, whose weights are returned. Positions are weighted by the inverse square of their distance. In a direction in which
/// all positions agree the function is constant.
LinearFit linearFit(const dvec3& cornerCentred, const dvec3& normal, std::span<const dvec3> positionsCentred) {
    const dvec3 aside = std::abs(normal.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0); // not parallel to the normal
    const dvec3 u = glm::normalize(glm::cross(normal, aside)), v = glm::cross(normal, u);
    std::vector<dvec2> offsets; // from the corner, in the plane
    std::vector<double> nearness;
    double sum = 0;
    dvec2 mean(0.0);
    for (const dvec3& position : positionsCentred) {
        const dvec3 offset = position - cornerCentred;
        offsets.emplace_back(glm::dot(u, offset), glm::dot(v, offset));
        nearness.push_back(1 / glm::dot(offset, offset));
        sum += nearness.back();
        mean += nearness.back() * offsets.back();
    }
    mean /= sum;
    double uu = 0, uv = 0, vv = 0;
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        const dvec2 off = offsets[i] - mean;
        uu += nearness[i] * off.x * off.x;
        uv += nearness[i] * off.x * off.y;
        vv += nearness[i] * off.y * off.y;
    }
    const double half = (uu + vv) / 2, root = std::hypot((uu - vv) / 2, uv); // eigenvalues: half + root, half - root
    LinearFit fit;
    // Patches a thousand times as long as wide still span a plane; rounding errors do not.
    fit.isPlane = half - root > 1e-8 * (half + root);
    dvec2 slope(0.0);
    if (fit.isPlane)
        slope = dvec2(vv * mean.x - uv * mean.y, uu * mean.y - uv * mean.x) / (uu * vv - uv * uv);
    else if (half + root > 0)
        slope = dvec2(uu * mean.x + uv * mean.y, uv * mean.x + vv * mean.y) / ((half + root) * (half + root));
    for (std::size_t i = 0; i < offsets.size(); ++i)
        fit.weights.push_back(nearness[i] * (1 / sum - glm::dot(offsets[i] - mean, slope)));
    return fit;
}

/// The patches that determine the value at a corner.
struct Around {
    std::vector<std::uint32_t> patches; ///< those at the corner first, each once
    dvec3 normal{0.0};                  ///< of the surface there
    bool isInside = true;               ///< surrounded by patches on all sides
};

/// All corners, from the pieces of border that begin there.
std::vector<Around> cornersOf(const std::vector<Patch>& patches, const PatchBorders& borders,
                              const std::vector<std::uint32_t>& cornerOfPiece, std::size_t count) {
    std::vector<Around> corners(count);
    for (std::uint32_t i = 0; i < patches.size(); ++i)
        for (std::uint32_t piece = borders.first[i]; piece < borders.first[i + 1]; ++piece) {
            const std::uint32_t after = borders.after(piece);
            const bool isOpen = borders.pieces[piece].across == PatchBorders::kNone;
            Around& here = corners[cornerOfPiece[piece]];
            here.patches.push_back(i);
            here.normal += patches[i].normal;
            here.isInside = here.isInside && !isOpen;
            if (isOpen) corners[cornerOfPiece[after]].isInside = false;
        }
    return corners;
}

/// Adds the neighbours of all listed patches.
void widen(std::vector<std::uint32_t>& patches, const std::vector<std::vector<std::uint32_t>>& neighbours) {
    for (std::size_t i = 0, count = patches.size(); i < count; ++i)
        for (const std::uint32_t next : neighbours[patches[i]])
            if (std::ranges::find(patches, next) == patches.end()) patches.push_back(next);
}

} // namespace

PatchCorners patchCorners(const Faces& faces, const std::vector<Patch>& patches) {
    // The corner of a triangle has one patch; a first ring adds its only neighbour, a second one two more, which no longer lie in
    // a line.
    constexpr int kMostRings = 3;
    PatchCorners corners{patchBorders(faces, patches), {}, {}, {}};
    const PatchBorders& borders = corners.borders;
    const std::vector<std::uint32_t> leaders = roundEachPoint(borders);
    std::uint32_t count = 0;
    for (std::uint32_t piece = 0; piece < leaders.size(); ++piece)
        corners.cornerOfPiece.push_back(leaders[piece] == piece ? count++ : corners.cornerOfPiece[leaders[piece]]);
    std::vector<dvec3> placesCentred(count);
    for (std::uint32_t piece = 0; piece < leaders.size(); ++piece)
        placesCentred[corners.cornerOfPiece[piece]] = borders.pointsCentred[borders.pieces[piece].point];
    std::vector<std::vector<std::uint32_t>> neighbours; // without neighbours around the end of a wall
    for (std::uint32_t i = 0; i < patches.size(); ++i) {
        neighbours.push_back(borders.neighbours(i));
        std::erase_if(neighbours[i], [&](std::uint32_t j) {
            return std::ranges::binary_search(borders.parted, std::pair(std::min(i, j), std::max(i, j)));
        });
    }

    std::vector<Around> all = cornersOf(patches, borders, corners.cornerOfPiece, count);
    for (std::uint32_t k = 0; k < count; ++k) {
        Around& here = all[k];
        const bool hasNormal = glm::length(here.normal) > 1e-9; // at the tip of a needle normals may cancel
        const dvec3 normal = hasNormal ? glm::normalize(here.normal) : patches[here.patches.front()].normal;
        LinearFit fit;
        for (int ring = here.isInside ? 0 : 1; ring <= kMostRings && !fit.isPlane; ++ring) {
            if (ring > 0) widen(here.patches, neighbours);
            std::vector<dvec3> centresCentred;
            for (const std::uint32_t patch : here.patches)
                centresCentred.push_back(patches[patch].centre);
            fit = linearFit(placesCentred[k], normal, centresCentred);
        }
        corners.first.push_back(static_cast<std::uint32_t>(corners.weights.size()));
        for (std::size_t i = 0; i < here.patches.size(); ++i)
            corners.weights.push_back({here.patches[i], fit.weights[i]});
    }
    corners.first.push_back(static_cast<std::uint32_t>(corners.weights.size()));
    return corners;
}

std::vector<dvec3> PatchCorners::values(std::span<const dvec3> ofPatches) const {
    std::vector<dvec3> values;
    for (std::size_t k = 0; k < count(); ++k) {
        dvec3 sum(0.0), least(std::numeric_limits<double>::infinity()), most(-least);
        for (std::uint32_t i = first[k]; i < first[k + 1]; ++i) {
            const dvec3& value = ofPatches[weights[i].patch];
            sum += weights[i].weight * value;
            least = glm::min(least, value);
            most = glm::max(most, value);
        }
        const dvec3 differ = most - least;
        values.push_back(glm::clamp(sum, glm::max(dvec3(0.0), least - differ), most + differ));
    }
    return values;
}

} // namespace shadowlab::radiosity
