// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/hemicube.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/debug.h"
#include "techniques/foundation/gl/scene/scene_buffers.h"

namespace shadowlab::radiosity {

namespace {

/// Marks what is not a patch's front; the shader uses the same value.
constexpr std::uint32_t kNone = ~std::uint32_t{0};

struct Corner {
    vec3 positionCentred;
    std::uint32_t patch;
};

/// The distance from the centre of a patch to the line through its nearest edge, metres.
double reachOf(const Patch& patch) {
    double reach = std::sqrt(patch.area);
    for (std::size_t i = 0; i < patch.polygon.count(); ++i) {
        const dvec3& from = patch.polygon[i];
        const dvec3 along = patch.polygon[(i + 1) % patch.polygon.count()] - from;
        const double length = glm::length(along);
        if (length > 0) reach = std::min(reach, glm::length(glm::cross(along, patch.centre - from)) / length);
    }
    return reach;
}

/// From world axes to hemicube space. The x axis may have any angle about the normal; along the walls of a room it would be
/// worst, because an edge parallel to a row of pixels falls to one side or the other in the whole row at once. Turned by half a
/// radian, the edges of such rooms cross the rows, and the largest errors are half as large.
dmat3 hemicubeFromCentred(const dvec3& normal) {
    constexpr double kTurn = 0.5; // radians
    const dvec3 size = glm::abs(normal);
    const dvec3 axis = size.x <= size.y && size.x <= size.z ? dvec3(1, 0, 0)
                       : size.y <= size.z                   ? dvec3(0, 1, 0)
                                                            : dvec3(0, 0, 1);
    const dvec3 u = glm::normalize(axis - glm::dot(axis, normal) * normal), v = glm::cross(normal, u);
    const dvec3 x = std::cos(kTurn) * u + std::sin(kTurn) * v;
    return glm::transpose(dmat3(x, glm::cross(normal, x), normal));
}

/// The projection of one face, for positions relative to the centre. Across the face both coordinates go from -1 to 1, but on a
/// side face y starts at 0. The far plane is at infinity, so it cuts nothing.
mat4 clipFromRelative(const HemicubeFace& face, const dmat3& hemicubeFromRelative, double nearest) {
    const bool isSide = face.rows == 1;
    const dvec3 up = isSide ? 2.0 * face.up - face.forward : face.up;
    const auto row = [&](const dvec3& v, double constant) { return dvec4(v * hemicubeFromRelative, constant); };
    return mat4(
        glm::transpose(dmat4(row(face.right(), 0), row(up, 0), row(face.forward, -2 * nearest), row(face.forward, 0))));
}

} // namespace

Hemicube::Hemicube(int side) : side_(side) {
    if (side < 2 || side % 2 != 0) throw std::logic_error("the side of a hemicube is even, and 2 pixels at least");
    numbers_ = gl::Texture2D(GL_R32UI, hemicubePicture(side), "hemicube");
    depth_ = gl::Texture2D(GL_DEPTH24_STENCIL8, hemicubePicture(side), "hemicube depth");
    framebuffer_ = gl::Framebuffer(&numbers_, &depth_, "hemicube");
    deltas_ = deltaFormFactors(side);
}

void Hemicube::setPatches(std::span<const Patch> patches) {
    std::vector<Corner> corners;
    patches_ = patches;
    firstCorner_.clear();
    for (std::uint32_t i = 0; i < patches.size(); ++i) {
        firstCorner_.push_back(static_cast<std::uint32_t>(corners.size()));
        for (const dvec3& corner : patches[i].polygon.corners())
            corners.push_back({vec3(corner), i});
    }
    vertexArray_ = gl::VertexArrayHandle::create();
    glBindVertexArray(vertexArray_.id());
    corners_ = gl::uploadBuffer(GL_ARRAY_BUFFER, corners);
    indices_ = gl::BufferHandle::create();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), offset(offsetof(Corner, positionCentred)));
    glVertexAttribIPointer(1, 1, GL_UNSIGNED_INT, sizeof(Corner), offset(offsetof(Corner, patch)));
    for (const GLuint attribute : {0u, 1u})
        glEnableVertexAttribArray(attribute);
    glBindVertexArray(0);
    gl::check("corners of patches");
}

std::vector<double> Hemicube::formFactors(const Patch& from) const {
    return formFactors(from.centre, from.normal, kNearestShare * reachOf(from));
}

void Hemicube::draw(const dvec3& positionCentred, const dvec3& normal, double nearest) const {
    // Patches behind the plane of this one are not seen from it. Fronts are drawn first, then backs.
    const Plane plane{positionCentred, normal};
    std::vector<std::uint32_t> indices, backs;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        const Patch& patch = patches_[i];
        if (isBehind(plane, patch.polygon, 0)) continue;
        const bool isFront = patch.plane().height(positionCentred) > 0;
        for (std::uint32_t k = 2; k < patch.polygon.count(); ++k) // a fan of triangles: patches are convex
            for (const std::uint32_t corner : {0u, k - 1, k})
                (isFront ? indices : backs).push_back(firstCorner_[i] + corner);
    }
    const auto fronts = static_cast<GLsizei>(indices.size());
    indices.insert(indices.end(), backs.begin(), backs.end());

    gl::setBaselineState();
    // Along the outline of a block a front and a back meet at equal depths but for the rasteriser's rounding. Backs are moved
    // away, by the change of their depth in a pixel and 64 steps of the depth buffer: of 3000 pictures of two blocks in a room,
    // 300 lost a pixel to a back without an offset, 2 with 16 steps, none with 64.
    glPolygonOffset(1, 64);
    framebuffer_.bind();
    const GLuint none[4] = {kNone, kNone, kNone, kNone};
    glClearBufferuiv(GL_COLOR, 0, none);
    glClear(GL_DEPTH_BUFFER_BIT);
    glBindVertexArray(vertexArray_.id());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                 indices.data(), GL_STREAM_DRAW);
    program_.use();
    // Corners and centre are rounded alike, so that an axis-parallel plane through both still holds both. Rounding moves them by
    // some 2^-24 of the scene's size; subtracting them first loses nothing more.
    program_.set("centreCentred", vec3(positionCentred));
    const dmat3 turn = hemicubeFromCentred(normal);
    for (const bool isBack : {false, true}) {
        program_.set("fromBehind", isBack ? 1 : 0);
        if (isBack) glEnable(GL_POLYGON_OFFSET_FILL);
        for (const HemicubeFace& face : kHemicubeFaces) {
            glViewport(0, face.firstRow * side_ / 2, side_, face.rows * side_ / 2);
            program_.set("clipFromRelative", clipFromRelative(face, turn, nearest));
            glDrawElements(GL_TRIANGLES, isBack ? static_cast<GLsizei>(backs.size()) : fronts, GL_UNSIGNED_INT,
                           reinterpret_cast<const void*>(isBack ? std::size_t(fronts) * sizeof(std::uint32_t) : 0));
        }
    }
    glBindVertexArray(0);
    gl::check("hemicube");
}

std::vector<double> Hemicube::formFactors(const dvec3& positionCentred, const dvec3& normal, double nearest) const {
    draw(positionCentred, normal, nearest);
    std::vector<std::uint32_t> seen(deltas_.size());
    const ivec2 picture = hemicubePicture(side_);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, picture.x, picture.y, GL_RED_INTEGER, GL_UNSIGNED_INT, seen.data());
    gl::check("reading a hemicube");
    std::vector<double> factors(patches_.size(), 0.0);
    for (std::size_t pixel = 0; pixel < seen.size(); ++pixel)
        if (seen[pixel] < factors.size()) factors[seen[pixel]] += deltas_[pixel];
    return factors;
}

} // namespace shadowlab::radiosity
