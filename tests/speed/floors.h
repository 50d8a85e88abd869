// Floors: programs that do only the work that every program of their kind has to do, to hold whole frames against.
//
// They leave out all that makes a picture right: no gate, no materials, no highlights, no exposure and encoding. A map is one for the
// sphere around all casters (objects of two triangles cast nothing), of 2048 x 2048 texels, looked up once in each pixel. Volumes are those of
// the techniques (drawn whole and to infinity they would take twice as long), extruded beforehand; they are counted, and what lies
// in one is darkened.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/gl/framebuffer.h"
#include "techniques/foundation/gl/scene/surfaces.h"
#include "techniques/shadow_volume/cull/casters.h"

namespace shadowlab::speed {

enum class Floor { plain, map, passing, failing };

/// A linked program of two shaders, given without their first line. Throws std::runtime_error where one does not compile.
class Shader {
public:
    Shader(const std::string& vertex, const std::string& fragment);
    void use() const { glUseProgram(id_); }
    void set(const char* name, const mat4& m) const { glUniformMatrix4fv(at(name), 1, GL_FALSE, &m[0][0]); }
    void set(const char* name, const vec4& v) const { glUniform4fv(at(name), 1, &v[0]); }
    void set(const char* name, int i) const { glUniform1i(at(name), i); }

private:
    [[nodiscard]] GLint at(const char* name) const { return glGetUniformLocation(id_, name); }
    GLuint id_;
};

/// Columns of the picture, counted from the left.
struct Columns {
    int first = 0, count = 0;
};

class Floors {
public:
    explicit Floors(ivec2 size);

    /// Finds and extrudes the volumes of the first light, each to the plane behind all objects.
    void extrude(const scene::Snapshot& snapshot);

    /// Draws a frame, or some columns of it, with the first light. `passing` and `failing` count what was extruded last.
    void draw(Floor floor, const scene::Snapshot& snapshot, const scene::Camera& camera, const Columns& columns);

private:
    void drawSurfaces(const Shader& shader, const scene::Scene& scene, const dmat4& clipFromWorld, const dmat4& mapFromWorld);
    void drawMap(const scene::Scene& scene, const dmat4& mapFromWorld);
    void count(const scene::Scene& scene, const dmat4& clipFromWorld, bool failing);
    void darken();
    void drawObject(const scene::Object& object, std::size_t index);

    ivec2 size_;
    gl::SceneBuffers buffers_;
    gl::Texture2D color_, depthStencil_;
    gl::Framebuffer framebuffer_, withoutColor_;
    shadow_volume::Casters casters_;
    std::vector<std::pair<std::size_t, const shadow_volume::VolumeBuffers*>> volumes_; ///< of which object
    gl::DepthTextureArray map_;
    gl::Framebuffer mapFramebuffer_;
    Shader plain_, looking_, position_, darkening_;
};

} // namespace shadowlab::speed
