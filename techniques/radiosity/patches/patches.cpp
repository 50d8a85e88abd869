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

} // namespace

Patch pieceOf(const Patch& patch, const Polygon& polygon) {
    return {polygon, patch.normal, centroid(polygon), glm::length(areaVector(polygon)), patch.face};
}

std::vector<Patch> cutIntoPatches(const Faces& faces, double size) {
    std::vector<Patch> patches;
    for (std::uint32_t f = 0; f < faces.all.size(); ++f) {
        const Polygon& polygon = faces.all[f].polygon;
        const Cuts cuts = cutsOf(polygon, size);
        if (polygon.count() == 4)
            cutQuad(polygon, cuts, f, patches);
        else
            cutTriangle(polygon, cuts.u, f, patches);
    }
    return patches;
}

double sizeForBudget(const Faces& faces, std::size_t most) {
    double longest = 0;
    for (const Face& face : faces.all)
        for (std::size_t i = 0; i < face.polygon.count(); ++i)
            longest = std::max(longest, glm::length(face.polygon[(i + 1) % face.polygon.count()] - face.polygon[i]));
    const auto fits = [&](double size) {
        std::size_t count = 0;
        for (const Face& face : faces.all)
            if ((count += countOf(cutsOf(face.polygon, size))) > most) return false;
        return true;
    };
    double size = longest; // 0 where there are no faces
    for (const double step = std::exp2(-1.0 / 16); size > 0 && fits(size * step);)
        size *= step;
    return size;
}

} // namespace shadowlab::radiosity
