// SPDX-License-Identifier: MIT
#include "app/picture/outside/shape_painter.h"

#include <algorithm>

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/scene/scene_buffers.h"
#include "techniques/foundation/gl/scene/surfaces.h"

namespace shadowlab::picture {

namespace {

constexpr double kBeside =
    1.5; ///< of the picture's half size: segments are cut there, out of sight of their round ends
constexpr float kFaceAlpha = 0.3f;        ///< two or three layers stay distinguishable
constexpr float kHiddenFace = 0.4f;       ///< of that, where something hides the face
constexpr float kHiddenLine = 0.35f;      ///< alpha of a line where something hides it
constexpr float kLineRimWidth = 5.0f / 3; ///< of the line's own: one pixel on each side of three

/// The part of a segment on the inner side of a plane in clip coordinates. False when there is none.
bool cut(dvec4& a, dvec4& b, const dvec4& plane) {
    const double da = glm::dot(plane, a), db = glm::dot(plane, b);
    if (da < 0 && db < 0) return false;
    const dvec4 crossing = glm::mix(a, b, da / (da - db));
    if (da < 0) a = crossing;
    if (db < 0) b = crossing;
    return true;
}

} // namespace

/// The lines of one colour, on the graphics card.
struct ShapePainter::Lines {
    vec3 colorLinear;
    gl::BufferHandle buffer;
    gl::VertexArrayHandle vertexArray;
    GLsizei segments;

    Lines(const vec3& color, const std::vector<ScreenSegment>& screen)
        : colorLinear(color), buffer(gl::uploadBuffer(GL_ARRAY_BUFFER, screen)),
          vertexArray(gl::VertexArrayHandle::create()), segments(static_cast<GLsizei>(screen.size())) {
        glBindVertexArray(vertexArray.id());
        glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
        for (const GLuint end : {0u, 1u}) {
            const auto* offset = reinterpret_cast<const void*>(end * sizeof(vec3)); // NOLINT: what GL asks for
            glEnableVertexAttribArray(end);
            glVertexAttribPointer(end, 3, GL_FLOAT, GL_FALSE, sizeof(ScreenSegment), offset);
            glVertexAttribDivisor(end, 1);
        }
        glBindVertexArray(0);
    }
};

/// The faces of one colour, relative to the camera.
struct ShapePainter::Faces {
    vec3 colorLinear;
    gl::BufferHandle buffer;
    gl::VertexArrayHandle vertexArray;
    GLsizei vertices;

    Faces(const vec3& color, const std::vector<vec3>& positions)
        : colorLinear(color), buffer(gl::uploadBuffer(GL_ARRAY_BUFFER, positions)),
          vertexArray(gl::VertexArrayHandle::create()), vertices(static_cast<GLsizei>(positions.size())) {
        glBindVertexArray(vertexArray.id());
        glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
        glEnableVertexAttribArray(gl::kPositionMesh);
        glVertexAttribPointer(gl::kPositionMesh, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        glBindVertexArray(0);
    }
};

float lineWidth(int height) { return std::max(2.0f, static_cast<float>(height) / 240.0f); }

std::vector<ScreenSegment> projectSegments(std::span<const dvec3> pointsWorld, const scene::Camera& camera,
                                           ivec2 size) {
    const gl::EyeMatrices eye = gl::eyeMatrices(camera, size);
    const dmat4 clipFromEyeRelative = eye.clipFromView * dmat4(dmat3(eye.viewFromWorld));
    // Near, left, right, below, above.
    const dvec4 planes[] = {
        {0, 0, 1, 1}, {1, 0, 0, kBeside}, {-1, 0, 0, kBeside}, {0, 1, 0, kBeside}, {0, -1, 0, kBeside}};
    std::vector<ScreenSegment> segments;
    const auto screen = [&](const dvec4& clip) {
        return vec3((0.5 + 0.5 * clip.x / clip.w) * size.x, (0.5 + 0.5 * clip.y / clip.w) * size.y, clip.z / clip.w);
    };
    for (std::size_t i = 0; i + 1 < pointsWorld.size(); i += 2) {
        dvec4 a = clipFromEyeRelative * dvec4(pointsWorld[i] - camera.positionWorld, 1.0);
        dvec4 b = clipFromEyeRelative * dvec4(pointsWorld[i + 1] - camera.positionWorld, 1.0);
        if (std::ranges::all_of(planes, [&](const dvec4& plane) { return cut(a, b, plane); }))
            segments.push_back({screen(a), screen(b)});
    }
    return segments;
}

std::vector<std::array<dvec2, 3>> projectFaces(std::span<const dvec3> pointsWorld, const scene::Camera& camera, ivec2 size) {
    const gl::EyeMatrices eye = gl::eyeMatrices(camera, size);
    const dmat4 clipFromEyeRelative = eye.clipFromView * dmat4(dmat3(eye.viewFromWorld));
    const auto nearer = [](const dvec4& clip) { return clip.z + clip.w; }; // 0 on the near plane
    std::vector<std::array<dvec2, 3>> faces;
    for (std::size_t i = 0; i + 2 < pointsWorld.size(); i += 3) {
        std::vector<dvec2> corners; // of the part before the near plane: none, three or four
        for (std::size_t k = 0; k < 3; ++k) {
            const dvec4 a = clipFromEyeRelative * dvec4(pointsWorld[i + k] - camera.positionWorld, 1.0);
            const dvec4 b = clipFromEyeRelative * dvec4(pointsWorld[i + (k + 1) % 3] - camera.positionWorld, 1.0);
            const auto add = [&](const dvec4& clip) { corners.push_back((0.5 + 0.5 * dvec2(clip) / clip.w) * dvec2(size)); };
            if (nearer(a) >= 0) add(a);
            if ((nearer(a) >= 0) != (nearer(b) >= 0)) add(glm::mix(a, b, nearer(a) / (nearer(a) - nearer(b))));
        }
        for (std::size_t k = 2; k < corners.size(); ++k)
            faces.push_back({corners[0], corners[k - 1], corners[k]});
    }
    return faces;
}

void ShapePainter::drawOnPicture(const std::vector<ScreenSegment>& segments, const vec3& colorLinear, float width,
                                 ivec2 size) const {
    if (segments.empty()) return;
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_ALWAYS);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    const Lines lines(colorLinear, segments);
    line_.use();
    line_.set("pictureSize", vec2(size));
    line_.set("reach", 0.5f * width + 2.0f);
    for (const bool rim : {true, false}) {
        line_.set("halfWidth", 0.5f * width + (rim ? 1.0f : 0.0f));
        line_.set("color", rim ? vec4(look::kLineRim, look::kLineRimAlpha) : vec4(colorLinear, 1.0f));
        glBindVertexArray(lines.vertexArray.id());
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, lines.segments);
    }
    glBindVertexArray(0);
}

void ShapePainter::draw(std::span<const SceneShape* const> shapes, const scene::Camera& camera, ivec2 size,
                        bool onTop) const {
    std::vector<Lines> lines;
    std::vector<Faces> faces;
    for (const SceneShape* const one : shapes) {
        const SceneShape& shape = *one;
        if (shape.kind == SceneShape::Kind::lines) {
            const std::vector<ScreenSegment> segments = projectSegments(shape.pointsWorld, camera, size);
            if (!segments.empty()) lines.emplace_back(shape.colorLinear, segments);
        } else if (!shape.pointsWorld.empty()) {
            std::vector<vec3> eyeRelative;
            eyeRelative.reserve(shape.pointsWorld.size());
            for (const dvec3& pointWorld : shape.pointsWorld)
                eyeRelative.emplace_back(pointWorld - camera.positionWorld);
            faces.emplace_back(shape.colorLinear, eyeRelative);
        }
    }
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    // The picture's own alpha stays: it says that there is something to show.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    for (const bool hidden : {true, false}) {
        if (onTop && hidden) continue;
        glDepthFunc(onTop ? GL_ALWAYS : hidden ? GL_GREATER : GL_LEQUAL);
        drawFaces(faces, camera, size, hidden ? kHiddenFace : 1.0f);
        drawLines(lines, size, hidden);
    }
}

void ShapePainter::drawFaces(const std::vector<Faces>& all, const scene::Camera& camera, ivec2 size,
                             float share) const {
    if (all.empty()) return;
    const gl::EyeMatrices eye = gl::eyeMatrices(camera, size);
    face_.use();
    face_.set("clipFromMesh", mat4(eye.clipFromView * dmat4(dmat3(eye.viewFromWorld))));
    for (const Faces& faces : all) {
        face_.set("color", vec4(faces.colorLinear, kFaceAlpha * share));
        glBindVertexArray(faces.vertexArray.id());
        glDrawArrays(GL_TRIANGLES, 0, faces.vertices);
    }
    glBindVertexArray(0);
}

void ShapePainter::drawLines(const std::vector<Lines>& all, ivec2 size, bool hidden) const {
    if (all.empty()) return;
    const float half = 0.5f * lineWidth(size.y);
    line_.use();
    line_.set("pictureSize", vec2(size));
    line_.set("reach", kLineRimWidth * half + 1.0f); // the same for line and rim: then they have the same depths
    // All rims first: where lines cross, none cuts another in two.
    for (const bool rim : {true, false}) {
        if (hidden && rim) continue;
        line_.set("halfWidth", rim ? kLineRimWidth * half : half);
        for (const Lines& lines : all) {
            line_.set("color", rim ? vec4(look::kLineRim, look::kLineRimAlpha)
                                   : vec4(lines.colorLinear, hidden ? kHiddenLine : 1.0f));
            glBindVertexArray(lines.vertexArray.id());
            glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, lines.segments);
        }
    }
    glBindVertexArray(0);
}

} // namespace shadowlab::picture
