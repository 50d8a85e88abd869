// What a whole frame cannot be quicker than, measured: programs that do only the work that every program of its kind has to do,
// beside the techniques.
//
//   ninja -C build/release floor_bench
//   build/release/tests/floor_bench SCENE [FOLDER_WITH_ITS_MESHES [TECHNIQUE...]]
//
// The floors leave out all that makes a picture right: no gate, no materials, no highlights, no exposure and encoding. A map is one for the
// sphere around all casters (objects of two triangles cast nothing), of 2048 x 2048 texels, looked up once in each pixel. Volumes are those of the
// techniques (drawn whole and to infinity they would take twice as long), extruded before the clock starts; they are counted, and what lies
// in one is darkened.
//
// Floors and techniques take turns, twelve frames at a time, the first light one degree further in each. Printed are the medians of a
// frame, and of the ratio of each technique to its floor in the same turn.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>

#include <glm/gtc/matrix_transform.hpp>

#include "app/context/assets.h"
#include "app/context/context.h"
#include "app/film/motion.h"
#include "app/lab/settings.h"
#include "app/picture/session.h"
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/shadow_volume/cull/casters.h"
#include "tests/speed/median.h"

namespace shadowlab {
namespace {

constexpr ivec2 kSize{1280, 720};
constexpr int kRounds = 9, kFrames = 12, kWarming = 4, kMapSide = 2048;

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

class Shader {
public:
    Shader(const std::string& vertex, const std::string& fragment) : id_(glCreateProgram()) {
        glAttachShader(id_, compiled(GL_VERTEX_SHADER, vertex));
        glAttachShader(id_, compiled(GL_FRAGMENT_SHADER, fragment));
        glLinkProgram(id_);
    }
    void use() const { glUseProgram(id_); }
    void set(const char* name, const mat4& m) const { glUniformMatrix4fv(at(name), 1, GL_FALSE, &m[0][0]); }
    void set(const char* name, const vec4& v) const { glUniform4fv(at(name), 1, &v[0]); }
    void set(const char* name, int i) const { glUniform1i(at(name), i); }

private:
    [[nodiscard]] GLint at(const char* name) const { return glGetUniformLocation(id_, name); }
    GLuint id_;
};

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

/// Of the sphere around all casters, as the light sees it.
dmat4 mapFromWorld(const scene::Scene& scene) {
    const std::vector<scene::Bounds> boxes = scene::objectBounds(scene);
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

/// One position of the light, and what the processor finds beforehand.
struct Moment {
    film::Moment shown;
    dmat4 mapFromWorld;
};

enum class Floor { plain, map, passing, failing };

class Floors {
public:
    /// Draws a whole frame and waits for it; milliseconds.
    double draw(Floor floor, const Moment& moment) {
        const scene::Scene& scene = *moment.shown.snapshot;
        const bool hasVolumes = floor == Floor::passing || floor == Floor::failing;
        if (hasVolumes) extrude(moment.shown.snapshot);
        const auto begin = std::chrono::steady_clock::now();
        buffers_.update(moment.shown.snapshot);
        const gl::EyeMatrices eye = gl::eyeMatrices(moment.shown.camera, kSize);
        const dmat4 clipFromWorld = eye.clipFromView * eye.viewFromWorld;
        gl::setBaselineState();
        if (floor == Floor::map) drawMap(scene, moment.mapFromWorld);
        framebuffer_.bind();
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        drawSurfaces(floor == Floor::map ? looking_ : plain_, scene, clipFromWorld, moment.mapFromWorld);
        if (hasVolumes) count(scene, clipFromWorld, floor == Floor::failing);
        if (hasVolumes) darken();
        glFinish();
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    }

private:
    void drawSurfaces(const Shader& shader, const scene::Scene& scene, const dmat4& clipFromWorld, const dmat4& mapFromWorld) {
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
    void drawMap(const scene::Scene& scene, const dmat4& mapFromWorld) {
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
    /// Of the first light, each to the plane behind all objects.
    void extrude(const scene::Snapshot& snapshot) {
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
    void count(const scene::Scene& scene, const dmat4& clipFromWorld, bool failing) {
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
    void darken() {
        framebuffer_.bind();
        glDisable(GL_DEPTH_TEST);
        glStencilFunc(GL_NOTEQUAL, 0, 0xff);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ZERO, GL_SRC_COLOR);
        darkening_.use();
        gl::drawFullscreenTriangle();
    }
    void drawObject(const scene::Object& object, std::size_t index) {
        if (object.mesh->outward) {
            glEnable(GL_CULL_FACE);
            glCullFace(scene::isMirrored(object) ? GL_FRONT : GL_BACK);
        }
        buffers_.mesh(index).draw(0, static_cast<std::uint32_t>(object.mesh->triangles.size()));
        glDisable(GL_CULL_FACE);
    }
    gl::SceneBuffers buffers_;
    gl::Texture2D color_{GL_RGBA8, kSize, "floor"}, depthStencil_{GL_DEPTH24_STENCIL8, kSize, "floor's depth"};
    gl::Framebuffer framebuffer_{&color_, &depthStencil_, "floor"}, withoutColor_{nullptr, &depthStencil_, "floor"};
    shadow_volume::Casters casters_;
    std::vector<std::pair<std::size_t, const shadow_volume::VolumeBuffers*>> volumes_; ///< of which object
    gl::DepthTextureArray map_{GL_DEPTH_COMPONENT24, kMapSide, 1, "floor's map"};
    gl::Framebuffer mapFramebuffer_{map_, 0, "floor's map"};
    Shader plain_{kSurfaceVertex, surfaceFragment("1.0")};
    Shader looking_{kSurfaceVertex, surfaceFragment("texture(map, vec4(positionMap.xy / positionMap.w, 0.0, positionMap.z / positionMap.w - 0.0005))")};
    Shader position_{kPositionVertex, "void main() {}"};
    Shader darkening_{kFullscreenVertex, "out vec4 color; void main() { color = vec4(vec3(0.3), 1.0); }"};
};

/// A technique, and the floor of its kind.
struct Entry {
    std::string technique;
    std::vector<std::string> settings;
    Floor floor;
    std::vector<picture::Slot> slots{};
    std::vector<double> techniqueMs{}, floorMs{}, ratios{}; ///< medians, of each turn
};

/// The techniques that have a floor of their kind; or those that are named, others beside the plain frame.
std::vector<Entry> chosen(const std::vector<std::string>& named) {
    std::vector<Entry> entries;
    entries.push_back({"unshadowed", {}, Floor::plain});
    entries.push_back({"shadow-map", {"shadow-map.filter=hard", "shadow-map.resolution=2048"}, Floor::map});
    entries.push_back({"ray-traced", {}, Floor::plain});
    entries.push_back({"shadow-volume-zpass", {}, Floor::passing});
    entries.push_back({"shadow-volume-zfail", {}, Floor::failing});
    entries.push_back({"shadow-volume", {}, Floor::passing});
    if (named.empty()) return entries;
    for (const std::string& name : named)
        if (std::ranges::find(entries, name, &Entry::technique) == entries.end()) entries.push_back({name, {}, Floor::plain});
    std::erase_if(entries, [&](const Entry& entry) { return std::ranges::find(named, entry.technique) == named.end(); });
    return entries;
}

int run(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "floor_bench SCENE [FOLDER_WITH_ITS_MESHES [TECHNIQUE...]]\n");
        return 2;
    }
    scene::LoadOptions options{.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}};
    if (argc > 2) options.allowed.emplace_back(argv[2]);
    const scene::Snapshot base = scene::loadScene(argv[1], options);
    std::vector<Entry> entries = chosen({argv + std::min(argc, 3), argv + argc});
    for (Entry& entry : entries) {
        entry.slots.push_back(picture::Session::makeSlot(entry.technique));
        lab::applySettings(entry.slots, entry.settings);
    }
    const film::Motion motion{.frames = 360, .orbitLightDegrees = 360.0, .orbitCameraDegrees = {}, .path = {}};
    picture::Session session(base);
    Floors floors;
    scene::Snapshot previous;
    for (int round = 0; round < kRounds; ++round) {
        std::vector<Moment> moments;
        for (int i = 0; i < kFrames; ++i) {
            film::Moment shown = film::momentAt(motion, base, kFrames * round + i, previous);
            previous = shown.snapshot;
            moments.push_back({shown, mapFromWorld(*shown.snapshot)});
        }
        for (std::size_t e = 0; e < entries.size(); ++e) {
            Entry& entry = entries[round % 2 ? entries.size() - 1 - e : e];
            std::vector<double> ours, floor;
            for (int i = 0; i < kFrames; ++i) {
                const double ms = floors.draw(entry.floor, moments[static_cast<std::size_t>(i)]);
                if (i >= kWarming) floor.push_back(ms);
            }
            gl::FinishedPicture finished;
            for (int i = 0; i < kFrames; ++i) {
                const film::Moment& shown = moments[static_cast<std::size_t>(i)].shown;
                session.setScene(shown.snapshot);
                View view;
                view.camera = shown.camera;
                view.size = kSize;
                FrameRequest request;
                request.finished = &finished;
                const double ms = session.render(entry.slots.front(), view, request).frameMs;
                if (i >= kWarming) ours.push_back(ms);
            }
            entry.techniqueMs.push_back(median(ours));
            entry.floorMs.push_back(median(floor));
            entry.ratios.push_back(entry.techniqueMs.back() / entry.floorMs.back());
        }
    }
    std::printf("%s, %d x %d, %s, light moving\n%-24s %9s %9s %7s\n", argv[1], kSize.x, kSize.y, context::glRenderer().c_str(),
                "technique", "frame ms", "floor ms", "ratio");
    for (const Entry& entry : entries)
        std::printf("%-24s %9.2f %9.2f %7.2f\n", entry.technique.c_str(), median(entry.techniqueMs), median(entry.floorMs), median(entry.ratios));
    return 0;
}

} // namespace
} // namespace shadowlab

int main(int argc, char** argv) {
    try {
        const auto context = shadowlab::context::createContext(shadowlab::context::Backend::automatic);
        return shadowlab::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "floor_bench: %s\n", error.what());
        return 1;
    }
}
