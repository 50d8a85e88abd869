// SPDX-License-Identifier: MIT
#include "tests/speed/floors.h"

#include <stdexcept>

#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/gl/baseline.h"

namespace shadowlab::speed {

namespace {

constexpr int kMapSide = 2048;

GLuint compiled(GLenum kind, const std::string& body) {
    const GLuint shader = glCreateShader(kind);
    const std::string text = "#version 330 core\n" + body;
    const char* const source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok) throw std::runtime_error("a floor's shader does not compile:\n" + text);
    return shader;
}

const char* const kSurfaceVertex = R"(
layout(location = 0) in vec3 positionMesh;
layout(location = 1) in vec3 normalMesh;
uniform mat4 clipFromMesh, worldFromMesh, mapFromMesh;
out vec3 positionWorld, normalWorld;
out vec4 positionMap;
void main() {
    gl_Position = clipFromMesh * vec4(positionMesh, 1.0);
    positionWorld = (worldFromMesh * vec4(positionMesh, 1.0)).xyz;
    normalWorld = mat3(worldFromMesh) * normalMesh;
    positionMap = mapFromMesh * vec4(positionMesh, 1.0);
})";
// light.w is 0 for a sun, whose xyz is the way toward it.
std::string surfaceFragment(const std::string& visibility) {
    return R"(
in vec3 positionWorld, normalWorld;
in vec4 positionMap;
uniform vec4 light;
uniform sampler2DArrayShadow map;
out vec4 color;
void main() {
    vec3 toLight = normalize(light.xyz - light.w * positionWorld);
    color = vec4(vec3(0.2 + 0.8 * )" + visibility + R"( * max(dot(normalize(normalWorld), toLight), 0.0)), 1.0);
})";
}
const char* const kPositionVertex = R"(
layout(location = 0) in vec4 position;
uniform mat4 clipFromMesh;
void main() { gl_Position = clipFromMesh * position; })";
const char* const kFullscreenVertex = "void main() { gl_Position = vec4(4.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0, 0.0, 1.0); }";

bool casts(const scene::Object& object) { return object.castsShadow && object.mesh->triangles.size() > 2; }

/// Of the sphere around all casters, as the light sees it. `boxes`: of the objects.
dmat4 mapFromWorld(const scene::Scene& scene, const std::vector<scene::Bounds>& boxes) {
    scene::Bounds bounds;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (casts(scene.objects[i])) bounds.include(boxes[i]);
    const scene::Light& light = scene.lights[0];
    const dvec3 middle = 0.5 * (bounds.lowerWorld + bounds.upperWorld);
    const double radius = 0.5 * glm::length(bounds.upperWorld - bounds.lowerWorld);
    const bool isSun = light.type == scene::LightType::directional;
    const dvec3 from = isSun ? middle - 2 * radius * light.directionWorld : light.positionWorld;
    const dvec3 up = std::abs(glm::normalize(middle - from).y) > 0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const double distance = glm::length(middle - from);
    const dmat4 view = glm::lookAt(from, middle, up);
    if (isSun) return glm::ortho(-radius, radius, -radius, radius, radius, 3 * radius) * view;
    const double half = std::asin(std::min(radius / distance, 0.95));
    return glm::perspective(2 * half, 1.0, std::max(distance - radius, 0.1 * distance), distance + radius) * view;
}

} // namespace

Shader::Shader(const std::string& vertex, const std::string& fragment) : id_(glCreateProgram()) {
    glAttachShader(id_, compiled(GL_VERTEX_SHADER, vertex));
    glAttachShader(id_, compiled(GL_FRAGMENT_SHADER, fragment));
    glLinkProgram(id_);
}

Floors::Floors(ivec2 size)
    : size_(size), color_(GL_RGBA8, size, "floor"), depthStencil_(GL_DEPTH24_STENCIL8, size, "floor's depth"),
      framebuffer_(&color_, &depthStencil_, "floor"), withoutColor_(nullptr, &depthStencil_, "floor"),
      map_(GL_DEPTH_COMPONENT24, kMapSide, 1, "floor's map"), mapFramebuffer_(map_, 0, "floor's map"),
      plain_(kSurfaceVertex, surfaceFragment("1.0")),
      looking_(kSurfaceVertex,
               surfaceFragment("texture(map, vec4(positionMap.xy / positionMap.w, 0.0, positionMap.z / positionMap.w - 0.0005))")),
      position_(kPositionVertex, "void main() {}"),
      darkening_(kFullscreenVertex, "out vec4 color; void main() { color = vec4(vec3(0.3), 1.0); }") {}

void Floors::extrude(const scene::Snapshot& snapshot) {
    while (!casters_.buildNext(snapshot)) {}
    volumes_.clear();
    const std::vector<shadow_volume::CasterVolume>& casters = casters_.upload(0);
    for (std::size_t i = 0; i < casters.size(); ++i) {
        if (!casters[i].useful) continue;
        const shadow_volume::VolumeEnd end{.planeWorld = casters[i].endWorld, .distance = {}};
        const auto extrusion = shadow_volume::extrusionOf(snapshot->objects[casters[i].object], snapshot->lights[0], end);
        volumes_.push_back({casters[i].object, &casters_.extrude(0, i, extrusion)});
    }
}

void Floors::draw(Floor floor, const scene::Snapshot& snapshot, const scene::Camera& camera, const Columns& columns) {
    const bool hasVolumes = floor == Floor::passing || floor == Floor::failing;
    buffers_.update(snapshot);
    const gl::EyeMatrices eye = gl::eyeMatrices(camera, size_);
    const dmat4 clipFromWorld = eye.clipFromView * eye.viewFromWorld, map = mapFromWorld(*snapshot, buffers_.bounds());
    gl::setBaselineState();
    if (floor == Floor::map) drawMap(*snapshot, map);
    framebuffer_.bind();
    glEnable(GL_SCISSOR_TEST);
    glScissor(columns.first, 0, columns.count, size_.y);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    drawSurfaces(floor == Floor::map ? looking_ : plain_, *snapshot, clipFromWorld, map);
    if (hasVolumes) count(*snapshot, clipFromWorld, floor == Floor::failing);
    if (hasVolumes) darken();
    glDisable(GL_SCISSOR_TEST);
}

void Floors::drawSurfaces(const Shader& shader, const scene::Scene& scene, const dmat4& clipFromWorld, const dmat4& mapFromWorld) {
    shader.use();
    const scene::Light& light = scene.lights[0];
    const bool isSun = light.type == scene::LightType::directional;
    shader.set("light", vec4(isSun ? -light.directionWorld : light.positionWorld, isSun ? 0 : 1));
    shader.set("map", 0);
    const dmat4 texture = glm::translate(dmat4(1), dvec3(0.5)) * glm::scale(dmat4(1), dvec3(0.5));
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const dmat4 worldFromMesh = scene::worldFromMesh(scene.objects[i]);
        shader.set("clipFromMesh", mat4(clipFromWorld * worldFromMesh));
        shader.set("worldFromMesh", mat4(worldFromMesh));
        shader.set("mapFromMesh", mat4(texture * mapFromWorld * worldFromMesh));
        drawObject(scene.objects[i], i);
    }
}

void Floors::drawMap(const scene::Scene& scene, const dmat4& mapFromWorld) {
    mapFramebuffer_.bind();
    glClear(GL_DEPTH_BUFFER_BIT);
    position_.use();
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (!casts(scene.objects[i])) continue;
        position_.set("clipFromMesh", mat4(mapFromWorld * scene::worldFromMesh(scene.objects[i])));
        drawObject(scene.objects[i], i);
    }
    map_.bind(0);
}

void Floors::count(const scene::Scene& scene, const dmat4& clipFromWorld, bool failing) {
    withoutColor_.bind();
    glDepthMask(GL_FALSE);
    glEnable(GL_STENCIL_TEST);
    glEnable(GL_DEPTH_CLAMP);
    glStencilFunc(GL_ALWAYS, 0, 0xff);
    glStencilOpSeparate(failing ? GL_BACK : GL_FRONT, GL_KEEP, failing ? GL_INCR_WRAP : GL_KEEP, failing ? GL_KEEP : GL_INCR_WRAP);
    glStencilOpSeparate(failing ? GL_FRONT : GL_BACK, GL_KEEP, failing ? GL_DECR_WRAP : GL_KEEP, failing ? GL_KEEP : GL_DECR_WRAP);
    position_.use();
    for (const auto& [index, volume] : volumes_) {
        const scene::Object& object = scene.objects[index];
        position_.set("clipFromMesh", mat4(clipFromWorld * scene::worldFromMesh(object)));
        shadow_volume::setFrontFace(object, false);
        volume->drawSides();
        if (!failing) continue;
        volume->drawBottomCap();
        volume->drawTopCap();
        shadow_volume::setFrontFace(object, true);
        volume->drawTopCapReversed();
    }
    glFrontFace(GL_CCW);
    glDisable(GL_DEPTH_CLAMP);
}

void Floors::darken() {
    framebuffer_.bind();
    glDisable(GL_DEPTH_TEST);
    glStencilFunc(GL_NOTEQUAL, 0, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    darkening_.use();
    gl::drawFullscreenTriangle();
}

void Floors::drawObject(const scene::Object& object, std::size_t index) {
    if (object.mesh->outward) {
        glEnable(GL_CULL_FACE);
        glCullFace(scene::isMirrored(object) ? GL_FRONT : GL_BACK);
    }
    buffers_.mesh(index).draw(0, static_cast<std::uint32_t>(object.mesh->triangles.size()));
    glDisable(GL_CULL_FACE);
}

} // namespace shadowlab::speed
