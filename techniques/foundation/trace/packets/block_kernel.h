// How a block of rays goes through the tree (block_rays.h says what a block is). Included by one file for each kind of
// processor; everything has internal linkage, so that each keeps its own.
//
// How wrong can a lane be? Let M be the largest coordinate of the triangle, or of the rays' ends, seen from the origin,
// e = 2^-53 and E = 2^-24. A corner is subtracted and sheared (the shear is at most 2): at most 3 M, wrong by 10 e M.
// The coefficients of an edge are differences of products of two: wrong by 150 e M^2. A ray's place is wrong by 4 e before
// it is turned to the block's own axes, and turning, by a basis of area 0.1 at least, adds 30 e of its distance from the
// middle: 560 e M^2. What a single ray sees differs by 100 e M^2 more, since its direction toward the light is itself
// rounded. kSideDouble is twice the sum. In float a coefficient, the ray's place, the product and the sums are rounded, at
// most five times E of the magnitudes, and adding or taking off the bound once more; kFloat has more. The value is a
// quotient by the determinant of the triangle: what double gets wrong in numerator and denominator, here and for a single
// ray (where coordinates seen from the point are up to 2 M), is 10,000 e of their magnitudes, a third of kValueDouble.
// SPDX-License-Identifier: MIT
#pragma once
#include <limits>

#include "techniques/foundation/trace/packets/block_lanes.h"
#include "techniques/foundation/trace/packets/block_rays.h"

namespace shadowlab::trace {
namespace {

constexpr double kFloat = 8 * 0x1p-24;
constexpr double kSideDouble = 0x1p-42, kValueDouble = 0x1p-38;
constexpr double kUnderflow = 1e-30; // float loses digits below 1e-38

/// Up to four triangles as the block sees them: three sides and a value, each c[0] + x c[1] + y c[2].
struct FourSeen {
    alignas(16) float sides[3][3][4];
    alignas(16) float values[3][4];
    alignas(16) float sideBounds[4], valueBounds[4];
    unsigned left;     ///< one bit for each that some ray may hit
    unsigned doubtful; ///< those whose plane goes through the origin, or nearly: their value says nothing
};

inline void see(const BvhLeaf& leaf, const BlockRays& rays, float least, FourSeen& seen) {
    Double4 x[3], y[3], k[3], m = all(rays.largest);
    const Double4 origin[3] = {all(rays.origin[rays.axes[0]]), all(rays.origin[rays.axes[1]]),
                               all(rays.origin[rays.axes[2]])};
    for (int c = 0; c < 3; ++c) {
        const Double4 i = fourOf(leaf.corners[c][rays.axes[0]]) - origin[0];
        const Double4 j = fourOf(leaf.corners[c][rays.axes[1]]) - origin[1];
        k[c] = (fourOf(leaf.corners[c][rays.axes[2]]) - origin[2]) * rays.sign;
        x[c] = i - k[c] * rays.shear[0];
        y[c] = j - k[c] * rays.shear[1];
        m = larger(m, larger(magnitude(i), larger(magnitude(j), magnitude(k[c]))));
    }
    const Double4 one = all(1.0);
    const Double4 radius[2] = {all(double(rays.radius[0])), all(double(rays.radius[1]))};
    Double4 side[3][3], determinant{};
    for (int e = 0; e < 3; ++e) { // the side opposite to corner e
        const int b = (e + 1) % 3, c = (e + 2) % 3;
        side[e][0] = x[b] * y[c] - y[b] * x[c];
        const Double4 perX = rays.parallel ? y[b] - y[c] : y[b] * k[c] - k[b] * y[c];
        const Double4 perY = rays.parallel ? x[c] - x[b] : k[b] * x[c] - x[b] * k[c];
        side[e][1] = perX * rays.basis[0][0] + perY * rays.basis[0][1];
        side[e][2] = perX * rays.basis[1][0] + perY * rays.basis[1][1];
        determinant += rays.parallel ? side[e][0] : side[e][0] * k[e];
    }
    const Double4 size = magnitude(determinant);
    const Double4 turn = choose(determinant < 0.0, -one, one);
    Double4 reach{};
    Mask4 out{};
    for (int e = 0; e < 3; ++e) {
        const Double4 spread = radius[0] * magnitude(side[e][1]) + radius[1] * magnitude(side[e][2]);
        reach = larger(reach, magnitude(side[e][0]) + spread);
    }
    const Double4 bound = kFloat * reach + (kSideDouble * m * m + kUnderflow);
    for (int e = 0; e < 3; ++e) {
        const Double4 spread = radius[0] * magnitude(side[e][1]) + radius[1] * magnitude(side[e][2]);
        out |= side[e][0] * turn + spread < -bound;
    }
    // Relative error of the determinant: within a quarter its sign, and what is divided by it, can be relied on.
    const Double4 wrong = kValueDouble * m * m;
    const Mask4 certain = (rays.parallel ? wrong : wrong * m) * 4.0 <= size;
    const unsigned there = (1u << leaf.count) - 1;
    seen.doubtful = ~bits(certain & (size > 0.0)) & there;
    seen.left = (~bits(out) & there) | seen.doubtful;
    if (!seen.left) return;

    const Double4 inverse = one / determinant;
    Double4 value[3];
    for (int n = 0; n < 3; ++n)
        value[n] = (rays.parallel ? side[0][n] * k[0] + side[1][n] * k[1] + side[2][n] * k[2]
                                  : side[0][n] + side[1][n] + side[2][n]) *
                   inverse;
    const Double4 spread = radius[0] * magnitude(value[1]) + radius[1] * magnitude(value[2]);
    const Double4 valueReach = magnitude(value[0]) + spread;
    const Double4 valueBound = kFloat * valueReach + kUnderflow +
                               wrong * magnitude(inverse) * (rays.parallel ? m + valueReach : one + valueReach * m);
    seen.left &= ~bits(value[0] + spread + valueBound < all(double(least))) | seen.doubtful;
    if (!seen.left) return;
    for (int e = 0; e < 3; ++e)
        for (int n = 0; n < 3; ++n)
            storeFloats(seen.sides[e][n], side[e][n] * turn);
    for (int n = 0; n < 3; ++n)
        storeFloats(seen.values[n], value[n]);
    storeFloats(seen.sideBounds, bound);
    storeFloats(seen.valueBounds, valueBound);
}

/// A linear function of the places of eight rays.
inline Float8 at(Float8 c0, Float8 cx, Float8 cy, Float8 x, Float8 y) { return (c0 + cx * x) + cy * y; }

inline void doubt(BlockAnswers& answers, int row, unsigned lanes, std::uint32_t primitive) {
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto ray = static_cast<std::uint32_t>(8 * row + __builtin_ctz(lanes));
        if (answers.doubtCount == BlockAnswers::kMostDoubts)
            answers.givenUp |= std::uint64_t{1} << ray;
        else
            answers.doubts[answers.doubtCount++] = {ray, primitive};
    }
}

/// Where the rays of each row are, one row in each lane: what no ray of a row can hit is found out for all rows at once.
struct Rows {
    Float8 x[2], y[2]; ///< least and largest
    explicit Rows(const BlockRays& rays) {
        const float* const places[2] = {rays.x, rays.y};
        Float8* const to[2] = {x, y};
        for (int a = 0; a < 2; ++a) {
            alignas(32) float turned[kBlockRays];
            for (int row = 0; row < kBlockSide; ++row)
                store(turned + 8 * row, -eightOf(places[a] + 8 * row));
            to[a][0] = smallestOfRows(places[a]);
            to[a][1] = -smallestOfRows(turned);
        }
    }
};

/// One of the four, in every lane.
struct OneSeen {
    Float8 sides[3][3], bound, values[3], error;
    OneSeen(const FourSeen& seen, int t) : bound(all(seen.sideBounds[t])), error(all(seen.valueBounds[t])) {
        for (int n = 0; n < 3; ++n) {
            for (int e = 0; e < 3; ++e)
                sides[e][n] = all(seen.sides[e][n][t]);
            values[n] = all(seen.values[n][t]);
        }
    }
    [[nodiscard]] Float8 side(int e, Float8 x, Float8 y) const {
        return at(sides[e][0], sides[e][1], sides[e][2], x, y);
    }
    [[nodiscard]] Float8 value(Float8 x, Float8 y) const { return at(values[0], values[1], values[2], x, y); }
    /// The largest that a function of x and y computes to in each row. Rounding keeps the order, so no lane of it computes
    /// to more.
    [[nodiscard]] static Float8 most(const Float8* c, const Rows& rows) {
        return (c[0] + larger(c[1] * rows.x[0], c[1] * rows.x[1])) + larger(c[2] * rows.y[0], c[2] * rows.y[1]);
    }
    [[nodiscard]] unsigned possibleRows(const Rows& rows) const {
        return ~bits((most(sides[0], rows) < -bound) | (most(sides[1], rows) < -bound) |
                     (most(sides[2], rows) < -bound)) &
               0xffu;
    }
    /// Lanes that do not certainly pass it by.
    [[nodiscard]] unsigned possible(Float8 x, Float8 y) const {
        return ~bits((side(0, x, y) < -bound) | (side(1, x, y) < -bound) | (side(2, x, y) < -bound));
    }
    [[nodiscard]] Mask8 inside(Float8 x, Float8 y) const {
        return (side(0, x, y) > bound) & (side(1, x, y) > bound) & (side(2, x, y) > bound);
    }
    /// The same if it is not known which side of the triangle faces the origin: sides of both signs are a miss.
    [[nodiscard]] unsigned possibleEitherWay(Float8 x, Float8 y) const {
        Mask8 below{}, above{};
        for (int e = 0; e < 3; ++e) {
            below |= side(e, x, y) < -bound;
            above |= side(e, x, y) > bound;
        }
        return ~bits(below & above);
    }
};

/// Children of a node that the bundle may touch before `farthest`; `enter` receives their nearest K.
class RayShaft {
public:
    RayShaft(const BlockRays& rays, float largest) : rays_(rays) {
        float reach = largest;
        for (int a = 0; a < 3; ++a) {
            origin_[a] = static_cast<float>(rays.origin[rays.axes[a]]);
            reach += origin_[a] < 0 ? -origin_[a] : origin_[a];
        }
        // Origin, difference, slope and product are rounded, each by 2^-24 of this or twice this: 32 of them are more.
        pad_ = static_cast<float>(32 * 0x1p-24) * reach;
        for (int a = 0; a < 2; ++a) {
            const auto shear = static_cast<float>(rays.shear[a]);
            slope_[a][0] = rays.parallel ? shear : shear - rays.span[a];
            slope_[a][1] = rays.parallel ? shear : shear + rays.span[a];
            offset_[a] = rays.parallel ? rays.span[a] : 0;
        }
    }
    unsigned touched(const BvhNode& node, float farthest, Float8& enter) const {
        const auto& main = node.planes[rays_.axes[2]];
        const Float8 lower = eightOf(main[0]) - all(origin_[2]), upper = eightOf(main[1]) - all(origin_[2]);
        const bool forward = rays_.sign > 0;
        enter = larger((forward ? lower : -upper) - all(pad_), all(rays_.nearest - pad_));
        const Float8 leave = smaller((forward ? upper : -lower) + all(pad_), all(farthest + pad_));
        Mask8 touched = enter <= leave;
        for (int a = 0; a < 2; ++a) {
            const auto& planes = node.planes[rays_.axes[a]];
            const Float8 low = eightOf(planes[0]) - all(origin_[a]) - all(pad_);
            const Float8 high = eightOf(planes[1]) - all(origin_[a]) + all(pad_);
            const Float8 from = smaller(enter * slope_[a][0], leave * slope_[a][0]) - all(offset_[a]);
            const Float8 to = larger(enter * slope_[a][1], leave * slope_[a][1]) + all(offset_[a]);
            touched = touched & (from <= high) & (low <= to);
        }
        return bits(touched) & ((1u << node.count) - 1);
    }

private:
    const BlockRays& rays_;
    float origin_[3], slope_[2][2], offset_[2], pad_;
};

// A block is worth its while where many of its rays meet the same triangles. Divergent rays, among triangles smaller than
// pixels, together visit more leaves than one ray does, and testing all 64 in a leaf costs as much as tracing some ten
// alone. So if a block has visited more leaves than this, the rest of its rays are traced alone. Found by trial on loose
// triangles (tests/speed/structure_bench.cpp): with 32 and 64 a hundred thousand are slower; without a limit ten thousand
// are, too.
constexpr int kMostLeaves = 128;

struct Waiting {
    std::int32_t child;
    float enter;
};

/// Calls atLeaf(leaf) for what the bundle may touch, nearest first; it returns up to which K there is still something to
/// find, or less than zero to end. False where the bundle has come to too many leaves; it has not seen all then.
template <typename AtLeaf>
inline bool walk(const BlockTreeView& tree, const BlockRays& rays, const AtLeaf& atLeaf) {
    const RayShaft shaft(rays, tree.largest);
    float farthest = rays.farthest;
    Waiting stack[7 * 64 + 8]; // seven siblings wait at every one of at most 64 levels
    int size = 0, leaves = 0;
    stack[size++] = {0, kNever};
    while (size > 0) {
        const Waiting next = stack[--size];
        if (next.enter > farthest) continue;
        if (next.child < 0) {
            if (++leaves > kMostLeaves) return false;
            farthest = atLeaf(tree.leaves[~next.child]);
            if (farthest == kNever) return true;
            continue;
        }
        const BvhNode& node = tree.nodes[next.child];
        Float8 enter8;
        alignas(32) float enter[kBvhWidth];
        const int first = size;
        unsigned touched = shaft.touched(node, farthest, enter8);
        store(enter, enter8);
        for (; touched != 0; touched &= touched - 1) {
            const int i = __builtin_ctz(touched);
            const float mine = enter[i];
            int place = size++;
            for (; place > first && stack[place - 1].enter < mine; --place)
                stack[place] = stack[place - 1];
            stack[place] = {node.children[i], mine};
        }
    }
    return true;
}

/// `kHoles`: some triangle may have holes. Instantiated twice, so that scenes without holes pay no test.
template <bool kHoles>
void nearestHits(const BlockTreeView& tree, const BlockRays& rays, BlockAnswers& answers) {
    for (int i = 0; i < kBlockRays; ++i) {
        answers.least[i] = answers.most[i] = rays.asked >> i & 1 ? kNever : -kNever;
        answers.primitives[i] = ~std::uint32_t{0};
    }
    answers.doubtCount = 0;
    answers.givenUp = 0;
    const Rows rows(rays);
    float least = kNever, farthest = rays.farthest; // value that every ray has already found; K that this means
    const bool finished = walk(tree, rays, [&](const BvhLeaf& leaf) {
        FourSeen seen;
        see(leaf, rays, least, seen);
        bool found = false;
        for (unsigned left = seen.left; left != 0; left &= left - 1) {
            const int t = __builtin_ctz(left);
            const OneSeen one(seen, t);
            const bool doubtful = seen.doubtful >> t & 1, perforated = kHoles && tree.perforated[leaf.primitives[t]];
            unsigned inRows = doubtful ? 0xffu : one.possibleRows(rows);
            for (; inRows != 0; inRows &= inRows - 1) {
                const int row = __builtin_ctz(inRows);
                const Float8 x = eightOf(rays.x + 8 * row), y = eightOf(rays.y + 8 * row);
                const auto asked = static_cast<unsigned>(rays.asked >> (8 * row)) & 0xffu;
                if (doubtful) {
                    doubt(answers, row, one.possibleEitherWay(x, y) & asked, leaf.primitives[t]);
                    continue;
                }
                unsigned possible = one.possible(x, y) & asked;
                if (!possible) continue;
                const Float8 low = eightOf(answers.least + 8 * row), high = eightOf(answers.most + 8 * row);
                const Float8 value = one.value(x, y), lowest = value - one.error, highest = value + one.error;
                possible &= ~bits((highest < low) | (lowest > all(rays.ceiling[1])));
                if (!possible) continue;
                const Mask8 sure =
                    one.inside(x, y) & (lowest > high) & (highest < all(rays.ceiling[0])); // never of rays not asked
                const unsigned certain = perforated ? 0 : bits(sure);
                if (possible & ~certain) doubt(answers, row, possible & ~certain, leaf.primitives[t]);
                if (!certain) continue;
                store(answers.least + 8 * row, choose(sure, lowest, low));
                store(answers.most + 8 * row, choose(sure, highest, high));
                replace(answers.primitives + 8 * row, sure, leaf.primitives[t]);
                found = true;
            }
        }
        if (found) {
            Float8 all8 = eightOf(answers.least);
            for (int row = 1; row < kBlockSide; ++row) {
                const Float8 more = eightOf(answers.least + 8 * row);
                all8 = smaller(more, all8);
            }
            least = lane(all8, 0);
            for (int i = 1; i < 8; ++i)
                least = lane(all8, i) < least ? lane(all8, i) : least;
            if (least > 0) farthest = 1 / least * (1 + 1e-6f);
        }
        return farthest;
    });
    if (!finished) answers.givenUp = rays.asked;
}

template <bool kHoles>
void blockedRays(const BlockTreeView& tree, const BlockRays& rays, const std::uint8_t* mayBlock,
                 const std::uint32_t* own, BlockAnswers& answers) {
    answers.doubtCount = 0;
    answers.givenUp = 0;
    answers.blocked = 0;
    float least = -kNever; // the lowest floor: what is certainly below it blocks no ray
    for (int i = 0; i < kBlockRays; ++i)
        if (rays.asked >> i & 1 && rays.floor[i] < least) least = rays.floor[i];
    const Rows rows(rays);
    const Float8 clearance = all(rays.floorError);
    const bool finished = walk(tree, rays, [&](const BvhLeaf& leaf) {
        FourSeen seen;
        see(leaf, rays, least - rays.floorError, seen);
        for (unsigned left = seen.left; left != 0; left &= left - 1) {
            const int t = __builtin_ctz(left);
            const std::uint32_t primitive = leaf.primitives[t];
            if (!mayBlock[primitive]) continue;
            const OneSeen one(seen, t);
            const bool doubtful = seen.doubtful >> t & 1, perforated = kHoles && tree.perforated[primitive];
            unsigned inRows = doubtful ? 0xffu : one.possibleRows(rows);
            for (; inRows != 0; inRows &= inRows - 1) {
                const int row = __builtin_ctz(inRows);
                const auto asked = static_cast<unsigned>((rays.asked & ~answers.blocked) >> (8 * row)) & 0xffu;
                const Float8 x = eightOf(rays.x + 8 * row), y = eightOf(rays.y + 8 * row);
                unsigned possible = (doubtful ? one.possibleEitherWay(x, y) : one.possible(x, y)) & asked;
                if (!possible) continue;
                possible &= ~equal(own + 8 * row, primitive);
                if (!possible) continue;
                unsigned certain = 0;
                if (!doubtful) {
                    const Float8 value = one.value(x, y), floor = eightOf(rays.floor + 8 * row);
                    possible &= ~bits(value + one.error < floor - clearance);
                    if (!perforated)
                        certain = possible & bits(one.inside(x, y) & (value - one.error > floor + clearance));
                }
                if (possible != certain) doubt(answers, row, possible & ~certain, primitive);
                answers.blocked |= static_cast<std::uint64_t>(certain) << (8 * row);
            }
        }
        return answers.blocked == rays.asked ? kNever : rays.farthest;
    });
    if (!finished) answers.givenUp = rays.asked & ~answers.blocked;
}

inline void nearestHits(const BlockTreeView& tree, const BlockRays& rays, BlockAnswers& answers) {
    tree.perforated ? nearestHits<true>(tree, rays, answers) : nearestHits<false>(tree, rays, answers);
}

inline void blockedRays(const BlockTreeView& tree, const BlockRays& rays, const std::uint8_t* mayBlock,
                        const std::uint32_t* own, BlockAnswers& answers) {
    tree.perforated ? blockedRays<true>(tree, rays, mayBlock, own, answers)
                    : blockedRays<false>(tree, rays, mayBlock, own, answers);
}

} // namespace
} // namespace shadowlab::trace
