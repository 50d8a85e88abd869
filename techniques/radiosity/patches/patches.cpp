// SPDX-License-Identifier: MIT
#include "techniques/radiosity/patches/patches.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::radiosity {

namespace {

/// The number of pieces of an edge. An edge that is too long only by rounding gets no extra piece.
int piecesOf(double length, double size) { return std::max(1, static_cast<int>(std::ceil(length / size - 1e-9))); }

struct Cuts {
    int u, v; ///< of a quad along its first and its second side; of a triangle the same number twice
};

Cuts cutsOf(const Polygon& p, double size) {
    const auto edge = [&](std::size_t i) { return glm::length(p[(i + 1) % p.count()] - p[i]); };
    if (p.count() == 4) return {piecesOf(std::max(edge(0), edge(2)), size), piecesOf(std::max(edge(1), edge(3)), size)};
    const int n = piecesOf(std::max({edge(0), edge(1), edge(2)}), size);
    return {n, n};
}

std::size_t countOf(const Cuts& cuts) { return static_cast<std::size_t>(cuts.u) * static_cast<std::size_t>(cuts.v); }

void addPatch(const Polygon& polygon, std::uint32_t face, std::vector<Patch>& patches) {
    if (hasNoArea(polygon)) return;
    const dvec3 vector = areaVector(polygon);
    const double area = glm::length(vector);
    patches.push_back({polygon, vector / area, centroid(polygon), area, face});
}

// [anchor: cut-into-patches]
void cutQuad(const Polygon& q, const Cuts& cuts, std::uint32_t face, std::vector<Patch>& patches) {
    const auto at = [&](int i, int j) {
        const double s = static_cast<double>(i) / cuts.u, t = static_cast<double>(j) / cuts.v;
        return glm::mix(glm::mix(q[0], q[1], s), glm::mix(q[3], q[2], s), t);
    };
    for (int j = 0; j < cuts.v; ++j)
        for (int i = 0; i < cuts.u; ++i)
            addPatch({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, face, patches);
}

void cutTriangle(const Polygon& t, int n, std::uint32_t face, std::vector<Patch>& patches) {
    const auto at = [&](int i, int j) {
        return t[0] + static_cast<double>(i) / n * (t[1] - t[0]) + static_cast<double>(j) / n * (t[2] - t[0]);
    };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i + j < n; ++i) {
            addPatch({at(i, j), at(i + 1, j), at(i, j + 1)}, face, patches);
            if (i + j + 1 < n) addPatch({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, face, patches);
        }
}

/// Halves or quarters of a patch. A polygon with the maximum number of corners is halved, because a cut next to it would add one
/// more.
std::vector<Polygon> partsOf(const Patch& patch) {
    const Polygon& p = patch.polygon;
    const auto middle = [&](std::size_t i) { return 0.5 * (p[i] + p[(i + 1) % p.count()]); };
    if (p.count() == 3)
        return {{p[0], middle(0), middle(2)},
                {middle(0), p[1], middle(1)},
                {middle(2), middle(1), p[2]},
                {middle(0), middle(1), middle(2)}};
    if (p.count() == 4) {
        const double lengthwise = glm::distance(middle(3), middle(1)), crosswise = glm::distance(middle(0), middle(2));
        if (lengthwise > 2 * crosswise) return {{p[0], middle(0), middle(2), p[3]}, {middle(0), p[1], p[2], middle(2)}};
        if (crosswise > 2 * lengthwise) return {{p[0], p[1], middle(1), middle(3)}, {middle(3), middle(1), p[2], p[3]}};
        const dvec3 centre = 0.5 * (middle(0) + middle(2));
        return {{p[0], middle(0), centre, middle(3)},
                {middle(0), p[1], middle(1), centre},
                {centre, middle(1), p[2], middle(2)},
                {middle(3), centre, middle(2), p[3]}};
    }
    if (p.count() == Polygon::kMostCorners) {
        constexpr std::size_t kHalf = Polygon::kMostCorners / 2;
        std::vector<Polygon> halves(2);
        for (std::size_t i = 0; i <= kHalf; ++i) {
            halves[0].add(p[i]);
            halves[1].add(p[(kHalf + i) % p.count()]);
        }
        return halves;
    }
    dvec3 longest(0.0);
    for (std::size_t i = 0; i < p.count(); ++i)
        if (const dvec3 edge = p[(i + 1) % p.count()] - p[i]; glm::length(edge) > glm::length(longest)) longest = edge;
    const dvec3 along = glm::normalize(longest), across = glm::cross(patch.normal, along);
    const double touching = kTouching * sizeOf(p);
    std::vector<Polygon> pieces;
    for (const dvec3& first : {across, -across})
        for (const dvec3& second : {along, -along})
            if (const Polygon piece =
                    partBefore({patch.centre, second}, partBefore({patch.centre, first}, p, touching), touching);
                !piece.isEmpty())
                pieces.push_back(piece);
    return pieces;
}

double longestEdge(const Polygon& p) {
    double longest = 0;
    for (std::size_t i = 0; i < p.count(); ++i)
        longest = std::max(longest, glm::distance(p[i], p[(i + 1) % p.count()]));
    return longest;
}

/// Calls visit(patch) for each piece that is small enough for where it lies.
template <typename Visit>
void cutGround(const Patch& piece, const Ground& ground, double size, const Visit& visit) {
    const std::vector<Polygon> parts = longestEdge(piece.polygon) > ground.sizeAt(piece.polygon, size) ? dividedPatch(piece)
                                                                                                        : std::vector{piece.polygon};
    if (parts.size() == 1) return visit(piece);
    for (const Polygon& part : parts)
        cutGround(pieceOf(piece, part), ground, size, visit);
}

/// Calls visit(polygon, size) for each part of a face that is cut evenly.
template <typename Visit>
void visitParts(const Faces& faces, std::uint32_t face, const FaceParts& parts, double size, const Visit& visit) {
    if (face >= parts.size() || parts[face].empty()) return visit(faces.all[face].polygon, size);
    for (const FacePart& part : parts[face])
        visit(part.polygon, std::ldexp(size, part.doublings));
}

} // namespace

Patch wholePatch(const Face& face, std::uint32_t number) {
    return {face.polygon, face.plane.normal, centroid(face.polygon), glm::length(areaVector(face.polygon)), number};
}

std::vector<Polygon> dividedPatch(const Patch& patch) {
    std::vector<Polygon> pieces = partsOf(patch);
    if (std::ranges::any_of(pieces, hasNoArea)) return {patch.polygon};
    return pieces;
}

Patch pieceOf(const Patch& patch, const Polygon& polygon) {
    return {polygon, patch.normal, centroid(polygon), glm::length(areaVector(polygon)), patch.face};
}

std::vector<Patch> cutIntoPatches(const Faces& faces, double size, const Ground& ground, const FaceParts& parts) {
    std::vector<Patch> patches;
    for (std::uint32_t f = 0; f < faces.all.size(); ++f) {
        if (ground.holds(f)) {
            cutGround(wholePatch(faces.all[f], f), ground, size, [&](const Patch& patch) { addPatch(patch.polygon, f, patches); });
            continue;
        }
        visitParts(faces, f, parts, size, [&](const Polygon& polygon, double sizeOfPart) {
            const Cuts cuts = cutsOf(polygon, sizeOfPart);
            if (polygon.count() == 4)
                cutQuad(polygon, cuts, f, patches);
            else
                cutTriangle(polygon, cuts.u, f, patches);
        });
    }
    return patches;
}

double sizeForBudget(const Faces& faces, std::size_t most, const Ground& ground, const FaceParts& parts) {
    double longest = 0;
    for (const Face& face : faces.all)
        longest = std::max(longest, longestEdge(face.polygon));
    const auto fits = [&](double size) {
        std::size_t count = 0;
        for (std::uint32_t f = 0; f < faces.all.size(); ++f) {
            if (ground.holds(f))
                cutGround(wholePatch(faces.all[f], f), ground, size, [&](const Patch&) { ++count; });
            else
                visitParts(faces, f, parts, size,
                           [&](const Polygon& polygon, double sizeOfPart) { count += countOf(cutsOf(polygon, sizeOfPart)); });
            if (count > most) return false;
        }
        return true;
    };
    double size = longest; // 0 where there are no faces
    for (const double step = std::exp2(-1.0 / 16); size > 0 && fits(size * step);)
        size *= step;
    return size;
}

} // namespace shadowlab::radiosity
