// SPDX-License-Identifier: MIT
#include "tests/relations/relation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace shadowlab::relations {

namespace {

// Away from edges: a pixel alone, where rounding leaves a crack between the faces of two volumes that share an edge. Over all
// pictures they are fewer (kCrackShare in relations_gl_test.cpp).
constexpr int kCracks = 1;
// Two levels: a float's last bit may be the difference between two of them, and a second one where passes add up.
constexpr int kLevels = 2;
// Of one picture. Edges that flip come in clumps, along one edge that lies between two rows of the rasteriser's grid; over all
// pictures of a relation the share is less (kShareOfAll in relations_gl_test.cpp).
constexpr double kShareOfOne = 0.001;

int difference(const image::Color8& a, const image::Color8& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b), std::abs(a.a - b.a)});
}

int largestDifference(const Picture& a, const Picture& b, ivec2 pixel) {
    int largest = difference(a.shown.at(pixel.x, pixel.y), b.shown.at(pixel.x, pixel.y));
    for (std::size_t light = 0; light < a.visibility.size(); ++light) {
        const auto &va = a.visibility[light], &vb = b.visibility[light];
        largest = std::max({largest, std::abs(va.grey(pixel.x, pixel.y) - vb.grey(pixel.x, pixel.y)),
                            std::abs(va.alpha(pixel.x, pixel.y) - vb.alpha(pixel.x, pixel.y))});
    }
    return largest;
}

} // namespace

int reachPx(const Picture& a, const Picture& b, ivec2 pixel, Gate gate) {
    constexpr float kTexels = 3.0f;
    constexpr float kFarthest = 32.0f; // where light grazes, texels are as long as one likes
    const int reach = 1 + a.smoothPx;
    if (gate != Gate::edgesAndTexels || a.texelPx.empty()) return reach;
    const std::size_t at = a.index(pixel.x, pixel.y);
    return reach + static_cast<int>(std::ceil(std::min(kFarthest, kTexels * std::max(a.texelPx[at], b.texelPx[at]))));
}

Comparison& Comparison::operator+=(const Comparison& other) {
    compared += other.compared, lit += other.lit, shadowed += other.shadowed;
    if (other.stray > 0 || (other.different > 0 && stray == 0)) where = other.where;
    different += other.different, stray += other.stray;
    gate = other.gate;
    return *this;
}

std::ostream& operator<<(std::ostream& stream, const Comparison& c) {
    stream << c.different << " of " << c.compared << " pixels differ, " << c.stray << " of them away from edges";
    if (c.different > 0) stream << " (one is " << c.where.x << "," << c.where.y << ")";
    return stream << "; " << c.lit << " lit, " << c.shadowed << " in shadow";
}

bool isNearEdge(const Picture& picture, ivec2 pixel, int reachPx) {
    const ivec2 first = glm::max(pixel - reachPx, ivec2(0)), last = glm::min(pixel + reachPx, picture.size - 1);
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            if (difference(picture.shown.at(x, y), picture.shown.at(pixel.x, pixel.y)) > kLevels) return true;
            for (const picture::VisibilityImage& visibility : picture.visibility)
                if (std::abs(visibility.grey(x, y) - visibility.grey(pixel.x, pixel.y)) > kLevels ||
                    visibility.alpha(x, y) != visibility.alpha(pixel.x, pixel.y))
                    return true;
        }
    return false;
}

void countLight(const Picture& picture, Comparison& comparison) {
    for (const picture::VisibilityImage& visibility : picture.visibility)
        for (std::size_t i = 0; i < visibility.greyAlpha.size(); i += 2)
            if (visibility.greyAlpha[i + 1] == 255)
                ++(visibility.greyAlpha[i] > 127 ? comparison.lit : comparison.shadowed);
}

Comparison compare(const Picture& expected, const Picture& actual, Gate gate) {
    Comparison result;
    result.gate = gate;
    countLight(expected, result);
    const int levels = gate == Gate::exact ? 0 : kLevels;
    for (int y = 0; y < expected.size.y; ++y)
        for (int x = 0; x < expected.size.x; ++x) {
            ++result.compared;
            if (largestDifference(expected, actual, {x, y}) <= levels) continue;
            ++result.different;
            const bool stray =
                gate == Gate::exact || !isNearEdge(expected, {x, y}, reachPx(expected, actual, {x, y}, gate));
            if (stray || result.stray == 0) result.where = {x, y};
            result.stray += stray;
        }
    return result;
}

bool mayDifferAtAllEdges(Gate gate, const Traits& traits) {
    return (gate == Gate::edgesAndTexels && traits.hasTexels) || (gate != Gate::exact && traits.solvesRoom);
}

std::string complaint(const Comparison& comparison, const Traits& traits) {
    std::ostringstream text;
    text << comparison;
    if (comparison.stray > (comparison.gate == Gate::exact ? 0 : kCracks)) return text.str();
    if (mayDifferAtAllEdges(comparison.gate, traits)) return "";
    if (static_cast<double>(comparison.different) > kShareOfOne * static_cast<double>(comparison.compared))
        return text.str();
    return "";
}

unsigned Choice::operator()(unsigned below) {
    // Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", 2014: short, and the same everywhere.
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<unsigned>((z ^ (z >> 31)) % below);
}

std::vector<Relation> allRelations() {
    std::vector<Relation> all;
    for (const auto& some : {motionRelations(), meshRelations(), frameRelations(), lightRelations(), casterRelations()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

} // namespace shadowlab::relations
