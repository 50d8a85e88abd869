// Before a block of rays is traced, and after: from rays to points of a plane, and from the triangle that was hit to the
// point on it. In double, four at a time.
//
// Values that single rays compute as well are computed by the same operations in the same order, so they are the same to
// the last bit.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/packets/block_lanes.h"
#include "techniques/foundation/trace/packets/block_rays.h"

namespace shadowlab::trace {
namespace {

// A main axis must be one: x and y are at most this. The bounds of block_kernel.h are made for it.
constexpr double kSteepest = 2;
constexpr int kGroups = kBlockRays / 4;

inline double least(Double4 a) {
    double least = lane(a, 0);
    for (int i = 1; i < 4; ++i)
        least = lane(a, i) < least ? lane(a, i) : least;
    return least;
}
inline double most(Double4 a) { return -least(-a); }

inline double sum(Double4 a) { return (lane(a, 0) + lane(a, 1)) + (lane(a, 2) + lane(a, 3)); }

/// The plane's axes along the rows and columns of the block, wherever they run; those it has where there are none.
inline void setBasis(BlockRays& rays, const double* x, const double* y) {
    const double* const places[2] = {x, y};
    double along[2][2]; // from the left half to the right, from the upper half to the lower
    for (int a = 0; a < 2; ++a) {
        Double4 right{}, down{};
        for (int g = 0; g < kGroups; ++g) {
            const Double4 place = fourOf(places[a] + 4 * g);
            right = g % 2 ? right + place : right - place;
            down = g < kGroups / 2 ? down - place : down + place;
        }
        along[0][a] = sum(right);
        along[1][a] = sum(down);
    }
    for (auto& direction : along) {
        const double length = __builtin_sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
        for (double& part : direction)
            part /= length;
    }
    const double area = along[0][0] * along[1][1] - along[0][1] * along[1][0];
    const bool usable = __builtin_fabs(area) > 0.1; // else rounding would grow; false for what is no number, too
    for (int n = 0; n < 2; ++n)
        for (int a = 0; a < 2; ++a)
            rays.basis[n][a] = usable ? along[n][a] : n == a;
}

/// The plane's origin goes into the middle of the rays, so that float can tell them apart (of parallel rays it is where
/// `origin` is).
inline void place(BlockRays& rays, const double* x, const double* y) {
    const double* const places[2] = {x, y};
    double middle[2];
    for (int a = 0; a < 2; ++a) {
        Double4 low = fourOf(places[a]), high = low;
        for (int g = 1; g < kGroups; ++g) {
            low = smaller(low, fourOf(places[a] + 4 * g));
            high = larger(high, fourOf(places[a] + 4 * g));
        }
        const double from = least(low), to = most(high);
        middle[a] = rays.parallel ? 0 : 0.5 * (from + to);
        const double below = middle[a] - from, above = to - middle[a];
        rays.span[a] = static_cast<float>(below > above ? below : above);
        if (!rays.parallel) rays.shear[a] = middle[a];
    }
    setBasis(rays, x, y);
    const auto& b = rays.basis;
    const double inverse = 1 / (b[0][0] * b[1][1] - b[0][1] * b[1][0]);
    Double4 farX{}, farY{};
    for (int g = 0; g < kGroups; ++g) {
        const Double4 px = fourOf(x + 4 * g) - all(middle[0]), py = fourOf(y + 4 * g) - all(middle[1]);
        const Double4 alongX = px * (b[1][1] * inverse) - py * (b[1][0] * inverse);
        const Double4 alongY = py * (b[0][0] * inverse) - px * (b[0][1] * inverse);
        storeFloats(rays.x + 4 * g, alongX);
        storeFloats(rays.y + 4 * g, alongY);
        farX = larger(farX, magnitude(alongX));
        farY = larger(farY, magnitude(alongY));
    }
    // Rounding keeps the order: no float is beyond that of the farthest.
    rays.radius[0] = static_cast<float>(most(farX));
    rays.radius[1] = static_cast<float>(most(farY));
}

bool aimFan(const BlockFan& fan, BlockRays& rays, BlockVectors& directions, double depth[2]) {
    for (int axis = 0; axis < 3; ++axis)
        for (int row = 0; row < kBlockSide; ++row)
            for (int half = 0; half < kBlockSide; half += 4)
                store(directions.axis[axis] + kBlockSide * row + half,
                      (fourOf(fan.column[axis] + half) + all(fan.row[axis][row])) + all(fan.back[axis]));
    const int middle = kBlockSide / 2 * (kBlockSide + 1);
    double size[3];
    for (int axis = 0; axis < 3; ++axis)
        size[axis] = __builtin_fabs(directions.axis[axis][middle]);
    const int main = size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : (size[1] > size[2] ? 1 : 2);
    rays.axes[0] = (main + 1) % 3;
    rays.axes[1] = (main + 2) % 3;
    rays.axes[2] = main;
    rays.sign = directions.axis[main][middle] < 0 ? -1 : 1;

    alignas(32) double x[kBlockRays], y[kBlockRays];
    Double4 nearest = all(1e300), farthest = all(-1e300);
    unsigned forward = 0xf;
    for (int g = 0; g < kGroups; ++g) {
        const Double4 along = fourOf(directions.axis[main] + 4 * g) * rays.sign;
        const Double4 inverse = all(1.0) / along;
        const Double4 px = fourOf(directions.axis[rays.axes[0]] + 4 * g) * inverse;
        const Double4 py = fourOf(directions.axis[rays.axes[1]] + 4 * g) * inverse;
        forward &= bits((along > 0.0) & (magnitude(px) <= all(kSteepest)) & (magnitude(py) <= all(kSteepest)));
        nearest = smaller(nearest, along);
        farthest = larger(farthest, along);
        store(x + 4 * g, px);
        store(y + 4 * g, py);
    }
    if (forward != 0xf) return false; // a direction that is no number is not forward either
    place(rays, x, y);
    depth[0] = least(nearest);
    depth[1] = most(farthest);
    return true;
}

/// The corners of four triangles, side by side.
struct FourCorners {
    Double4 at[3][3]; ///< corner, axis
    FourCorners(const double* triangles, const std::uint32_t* primitives) {
        const double* const t[4] = {
            triangles + 9 * std::size_t{primitives[0]}, triangles + 9 * std::size_t{primitives[1]},
            triangles + 9 * std::size_t{primitives[2]}, triangles + 9 * std::size_t{primitives[3]}};
        const bool same = t[0] == t[1] && t[0] == t[2] && t[0] == t[3]; // neighbours often are on one
        for (int c = 0; c < 3; ++c)
            for (int axis = 0; axis < 3; ++axis) {
                const int i = 3 * c + axis;
                at[c][axis] = same ? all(t[0][i]) : four(t[0][i], t[1][i], t[2][i], t[3][i]);
            }
    }
};

void land(const double* triangles, const BlockRays& rays, const BlockVectors& directions, double nearest,
          BlockPoints& points) {
    const int kz = rays.axes[2];
    const bool backward = rays.sign < 0;
    const int kx = backward ? (kz + 2) % 3 : (kz + 1) % 3, ky = backward ? (kz + 1) % 3 : (kz + 2) % 3;
    points.eyeOnFront = points.open = 0;
    for (int g = 0; g < kGroups; ++g) {
        if (!(rays.asked >> (4 * g) & 0xfu)) continue;
        const FourCorners corners(triangles, points.primitives + 4 * g);
        const auto& corner = corners.at;
        Double4 seen[3][3]; // from the eye
        for (int c = 0; c < 3; ++c)
            for (int axis = 0; axis < 3; ++axis)
                seen[c][axis] = corner[c][axis] - all(rays.origin[axis]);
        Double4 d[3], size[3];
        for (int axis = 0; axis < 3; ++axis) {
            d[axis] = fourOf(directions.axis[axis] + 4 * g);
            size[axis] = magnitude(d[axis]);
        }
        const Double4 along = d[kz], reachPerT = magnitude(along);
        const Double4 shearX = d[kx] / along, shearY = d[ky] / along;
        Double4 x[3], y[3], largest{};
        for (int c = 0; c < 3; ++c) {
            x[c] = seen[c][kx] - shearX * seen[c][kz];
            y[c] = seen[c][ky] - shearY * seen[c][kz];
            for (int axis = 0; axis < 3; ++axis)
                largest = larger(largest, magnitude(seen[c][axis]));
        }
        const Double4 u = x[2] * y[1] - y[2] * x[1], v = x[0] * y[2] - y[0] * x[2], w = x[1] * y[0] - y[1] * x[0];
        const Double4 bound = all(70 * 0x1p-53) * largest * largest;
        const Double4 sum = u + v + w;
        const Double4 reach = all(rays.sign) * (u * seen[0][kz] + v * seen[1][kz] + w * seen[2][kz]) / sum;
        // In a block whose rays have different main axes, single rays would shear along another than this.
        const Mask4 sameAxis =
            kz == 0   ? (size[0] > size[1]) & (size[0] > size[2])
            : kz == 1 ? ~(size[0] > size[1]) & (size[1] > size[2])
                      : ~((size[0] > size[1]) & (size[0] > size[2])) & ~(~(size[0] > size[1]) & (size[1] > size[2]));
        const Mask4 inside = ((u > bound) & (v > bound) & (w > bound)) | ((u < -bound) & (v < -bound) & (w < -bound));
        points.open |= std::uint64_t{~bits(inside & sameAxis & (reach > all(nearest) * reachPerT)) & 0xfu} << (4 * g);

        store(points.weights[0] + 4 * g, u / sum);
        store(points.weights[1] + 4 * g, v / sum);
        Double4 ab[3], ac[3], side{};
        for (int axis = 0; axis < 3; ++axis) {
            ab[axis] = corner[1][axis] - corner[0][axis];
            ac[axis] = corner[2][axis] - corner[0][axis];
        }
        side = (ab[1] * ac[2] - ac[1] * ab[2]) * (all(rays.origin[0]) - corner[0][0]) +
               (ab[2] * ac[0] - ac[2] * ab[0]) * (all(rays.origin[1]) - corner[0][1]) +
               (ab[0] * ac[1] - ac[0] * ab[1]) * (all(rays.origin[2]) - corner[0][2]);
        points.eyeOnFront |= std::uint64_t{bits(side > 0.0)} << (4 * g);
    }
}

void positions(const double* triangles, const BlockPoints& points, BlockVectors& positions) {
    for (int g = 0; g < kGroups; ++g) {
        const Double4 a = fourOf(points.weights[0] + 4 * g), b = fourOf(points.weights[1] + 4 * g);
        const FourCorners corners(triangles, points.primitives + 4 * g);
        for (int axis = 0; axis < 3; ++axis) {
            const Double4 last = corners.at[2][axis];
            store(positions.axis[axis] + 4 * g,
                  last + a * (corners.at[0][axis] - last) + b * (corners.at[1][axis] - last));
        }
    }
}

std::uint64_t aimAtPoints(const BlockVectors& positions, double contact, BlockRays& rays) {
    alignas(32) double x[kBlockRays], y[kBlockRays];
    std::uint64_t forward = 0;
    Double4 nearest = all(1e300), farthest = all(-1e300), largest{}, highest{};
    for (int g = 0; g < kGroups; ++g) {
        Double4 p[3];
        for (int a = 0; a < 3; ++a) {
            p[a] = fourOf(positions.axis[rays.axes[a]] + 4 * g) - all(rays.origin[rays.axes[a]]);
            largest = larger(largest, magnitude(p[a]));
        }
        const Double4 depth = p[2] * rays.sign;
        const Double4 floor = rays.parallel ? depth : all(1.0) / depth;
        const Double4 px = rays.parallel ? p[0] - depth * rays.shear[0] : p[0] * floor;
        const Double4 py = rays.parallel ? p[1] - depth * rays.shear[1] : p[1] * floor;
        const Mask4 well = rays.parallel
                               ? magnitude(depth) < all(1e300)
                               : (depth > 0.0) & (magnitude(px) <= all(kSteepest)) & (magnitude(py) <= all(kSteepest));
        forward |= std::uint64_t{bits(well)} << (4 * g);
        nearest = smaller(nearest, depth);
        farthest = larger(farthest, depth);
        highest = larger(highest, magnitude(floor));
        store(x + 4 * g, px);
        store(y + 4 * g, py);
        storeFloats(rays.floor + 4 * g, floor);
    }
    if (forward != ~std::uint64_t{0}) return forward;
    place(rays, x, y);
    rays.largest = most(largest);
    rays.nearest = rays.parallel ? static_cast<float>(least(nearest)) : 0;
    rays.farthest = rays.parallel ? -kNever : static_cast<float>(most(farthest));
    rays.floorError = static_cast<float>(0x1p-23 * most(highest) + contact); // rounding of the floor, and contact
    return forward;
}

/// Area that the rays marked in a mask per row take up in the plane, as a rectangle.
inline float areaOf(const BlockRays& rays, const Mask8* marked) {
    const float* const places[2] = {rays.x, rays.y};
    float area = 1;
    for (const float* place : places) {
        Float8 low = all(-kNever), high = all(kNever);
        for (int row = 0; row < kBlockSide; ++row) {
            const Float8 here = eightOf(place + 8 * row);
            low = choose(marked[row] & (here < low), here, low);
            high = choose(marked[row] & (here > high), here, high);
        }
        float from = lane(low, 0), to = lane(high, 0);
        for (int i = 1; i < 8; ++i) {
            from = lane(low, i) < from ? lane(low, i) : from;
            to = lane(high, i) > to ? lane(high, i) : to;
        }
        area *= to - from;
    }
    return area;
}

std::uint64_t part(const BlockRays& rays) {
    const float* const places[2] = {rays.x, rays.y};
    // Of rays spread evenly both halves together take what the whole takes; a third of it is worth going twice.
    float best = 4 * rays.radius[0] * rays.radius[1] / 3;
    std::uint64_t heap = 0;
    for (const float* place : places) {
        Mask8 below[kBlockSide], above[kBlockSide];
        std::uint64_t rest = 0;
        for (int row = 0; row < kBlockSide; ++row) {
            below[row] = eightOf(place + 8 * row) < all(0.0f);
            above[row] = ~below[row];
            rest |= std::uint64_t{bits(below[row])} << (8 * row);
        }
        if (rest == 0 || rest == ~std::uint64_t{0}) continue;
        const float both = areaOf(rays, below) + areaOf(rays, above);
        if (both < best) {
            best = both;
            heap = rest;
        }
    }
    return heap;
}

} // namespace
} // namespace shadowlab::trace
