// The built-in shapes. Every position comes from one formula, in double, and is rounded to float once, so that positions
// that coincide have equal bits, and a closed shape is closed to the last bit.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/shapes.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

namespace shadowlab::scene {

namespace {

/// Adding zero turns -0 into +0: the two are equal, but their bits are not.
vec3 rounded(const dvec3& v) { return vec3(v) + vec3(0.0f); }

void addVertex(Mesh& mesh, const dvec3& position, const dvec3& normal) {
    mesh.positionsMesh.push_back(rounded(position));
    mesh.normalsMesh.push_back(rounded(glm::normalize(normal)));
}

/// Two triangles for the corners a, b, c, d, counter-clockwise seen from the front.
void addQuad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.emplace_back(a, b, c);
    mesh.triangles.emplace_back(a, c, d);
}

/// A flat face spanned by two half edges around `centre`, facing cross(halfU, halfV).
void addFace(Mesh& mesh, const dvec3& centre, const dvec3& halfU, const dvec3& halfV) {
    const auto first = static_cast<std::uint32_t>(mesh.positionsMesh.size());
    const dvec3 normal = glm::cross(glm::normalize(halfU), glm::normalize(halfV));
    addVertex(mesh, centre - halfU - halfV, normal);
    addVertex(mesh, centre + halfU - halfV, normal);
    addVertex(mesh, centre + halfU + halfV, normal);
    addVertex(mesh, centre - halfU + halfV, normal);
    addQuad(mesh, first, first + 1, first + 2, first + 3);
}

/// Lays the whole image on the rectangle that was added last: its right and upper sides toward these axes.
void layImageOnFace(Mesh& mesh, const dvec3& centre, const dvec3& rightward, const dvec3& upward) {
    for (std::size_t i = mesh.positionsMesh.size() - 4; i < mesh.positionsMesh.size(); ++i) {
        const dvec3 offset = dvec3(mesh.positionsMesh[i]) - centre;
        mesh.texcoords.emplace_back(glm::dot(offset, rightward) > 0.0 ? 1.0f : 0.0f,
                                    glm::dot(offset, upward) > 0.0 ? 1.0f : 0.0f);
    }
}

/// Copies a vertex at the seam of the image, with the other texture coordinate. Returns the index of the copy.
std::uint32_t addCopy(Mesh& mesh, std::uint32_t index, const vec2& texcoord) {
    const vec3 position = mesh.positionsMesh[index], normal = mesh.normalsMesh[index]; // copies: the vectors grow
    mesh.positionsMesh.push_back(position);
    mesh.normalsMesh.push_back(normal);
    mesh.texcoords.push_back(texcoord);
    return static_cast<std::uint32_t>(mesh.positionsMesh.size() - 1);
}

Mesh finished(Mesh mesh) {
    mesh.parts = {MeshPart{"", 0, static_cast<std::uint32_t>(mesh.triangles.size()), !mesh.texcoords.empty()}};
    return mesh;
}

/// (cos, sin) of i/n of a full turn, exact at quarter turns and exactly symmetric about the axes and diagonals.
dvec2 onUnitCircle(int i, int n) {
    const int quarter = 4 * i / n;
    const int rest = 4 * i % n; // the angle within the quarter is rest/n of a right angle
    const double angle = glm::half_pi<double>() * rest / n;
    const double toNext = glm::half_pi<double>() * (n - rest) / n;
    // cos and sin are taken of the smaller of the two angles to an axis.
    const dvec2 p = 2 * rest <= n ? dvec2(std::cos(angle), std::sin(angle)) : dvec2(std::sin(toNext), std::cos(toNext));
    switch (quarter % 4) {
    case 0: return p;
    case 1: return {-p.y, p.x};
    case 2: return -p;
    default: return {p.y, -p.x};
    }
}

} // namespace

Mesh makeQuad(dvec2 size) {
    Mesh mesh;
    addFace(mesh, dvec3(0.0), dvec3(0.0, 0.0, 0.5 * size.y), dvec3(0.5 * size.x, 0.0, 0.0)); // z cross x = +y
    layImageOnFace(mesh, dvec3(0.0), {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0});
    return finished(std::move(mesh));
}

Mesh makeParallelogram(const dvec3& edgeU, const dvec3& edgeV) {
    Mesh mesh;
    addFace(mesh, dvec3(0.0), 0.5 * edgeU, 0.5 * edgeV);
    return finished(std::move(mesh));
}

Mesh makeBox(dvec3 size) {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 out(0.0), u(0.0), v(0.0); // half edges; out, u, v are a right-handed triple
        out[axis] = 0.5 * size[axis];
        u[(axis + 1) % 3] = 0.5 * size[(axis + 1) % 3];
        v[(axis + 2) % 3] = 0.5 * size[(axis + 2) % 3];
        for (const double side : {1.0, -1.0}) {
            addFace(mesh, side * out, side > 0 ? u : v, side > 0 ? v : u);
            const dvec3 upward = axis == 1 ? dvec3(0.0, 0.0, -side) : dvec3(0.0, 1.0, 0.0);
            layImageOnFace(mesh, side * out, glm::cross(upward, side * out), upward);
        }
    }
    return finished(std::move(mesh));
}

Mesh makeSphere(double radius, int segments) {
    Mesh mesh;
    const int bands = std::max(2, segments / 2); // from pole to pole; one band would be flat
    const auto n = static_cast<std::uint32_t>(segments);
    const auto add = [&](const dvec3& direction, double u, double v) {
        addVertex(mesh, radius * direction, direction);
        mesh.texcoords.emplace_back(u, v);
    };

    // Vertices: north pole, then the rings from north to south, then the south pole.
    add({0.0, 1.0, 0.0}, 0.5 / segments, 1.0);
    for (int band = 1; band < bands; ++band) {
        const dvec2 polar = onUnitCircle(band, 2 * bands); // (height, distance from the axis)
        for (int i = 0; i < segments; ++i) {
            const dvec2 around = onUnitCircle(i, segments);
            // Turns counter-clockwise seen from +y.
            add({polar.y * around.x, polar.x, -polar.y * around.y}, double(i) / segments, 1.0 - double(band) / bands);
        }
    }
    add({0.0, -1.0, 0.0}, 0.5 / segments, 0.0);
    const auto southPole = static_cast<std::uint32_t>(mesh.positionsMesh.size() - 1);

    // Copies at the same places, for the image: where its right end meets its left one, and the poles for each triangle
    // that ends there, whose tip lies in the middle of its piece of the image.
    const auto firstOfRing = [n](std::uint32_t ring) { return 1 + ring * n; };
    const auto lastRing = static_cast<std::uint32_t>(bands - 2);
    const auto seam = static_cast<std::uint32_t>(mesh.positionsMesh.size());
    for (std::uint32_t ring = 0; ring <= lastRing; ++ring)
        addCopy(mesh, firstOfRing(ring), {1.0f, mesh.texcoords[firstOfRing(ring)].y});
    const auto poleAt = [&](std::uint32_t pole, std::uint32_t i) {
        return i == 0 ? pole : addCopy(mesh, pole, {(i + 0.5) / segments, mesh.texcoords[pole].y});
    };

    // Triangles: a fan at each pole, quads between the rings.
    const auto ringVertex = [=](std::uint32_t ring, std::uint32_t i) {
        return i == n ? seam + ring : firstOfRing(ring) + i;
    };
    for (std::uint32_t i = 0; i < n; ++i)
        mesh.triangles.emplace_back(poleAt(0, i), ringVertex(0, i), ringVertex(0, i + 1));
    for (std::uint32_t ring = 0; ring < lastRing; ++ring)
        for (std::uint32_t i = 0; i < n; ++i)
            addQuad(mesh, ringVertex(ring, i), ringVertex(ring + 1, i), ringVertex(ring + 1, i + 1),
                    ringVertex(ring, i + 1));
    for (std::uint32_t i = 0; i < n; ++i)
        mesh.triangles.emplace_back(ringVertex(lastRing, i), poleAt(southPole, i), ringVertex(lastRing, i + 1));
    return finished(std::move(mesh));
}

Mesh makeTorus(double majorRadius, double minorRadius, ivec2 segments) {
    Mesh mesh;
    // One row and one column more than there are places: the last are the first once more, at the image's other end.
    for (int i = 0; i <= segments.x; ++i) {
        const dvec2 around = onUnitCircle(i % segments.x, segments.x);
        const dvec3 outward(around.x, 0.0, -around.y); // from the axis; turns counter-clockwise seen from +y
        for (int j = 0; j <= segments.y; ++j) {
            const dvec2 tube = onUnitCircle(j % segments.y, segments.y);
            const dvec3 normal = tube.x * outward + dvec3(0.0, tube.y, 0.0);
            addVertex(mesh, (majorRadius + minorRadius * tube.x) * outward + dvec3(0.0, minorRadius * tube.y, 0.0),
                      normal);
            mesh.texcoords.emplace_back(double(i) / segments.x, double(j) / segments.y);
        }
    }
    const auto vertex = [rowLength = segments.y + 1](int i, int j) {
        return static_cast<std::uint32_t>(i * rowLength + j);
    };
    for (int i = 0; i < segments.x; ++i)
        for (int j = 0; j < segments.y; ++j)
            addQuad(mesh, vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    return finished(std::move(mesh));
}

} // namespace shadowlab::scene
