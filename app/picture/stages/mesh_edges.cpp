// SPDX-License-Identifier: MIT
#include "app/picture/stages/mesh_edges.h"

#include <algorithm>
#include <array>
#include <map>

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/debug.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/gl/scene/surfaces.h"
#include "techniques/foundation/scene/query/topology/mesh_topology.h"
#include "techniques/foundation/scene/query/view/depth_fit.h"

namespace shadowlab::picture {

namespace {

using scene::EdgeKind;

/// One kind of edge. Later ones are drawn over earlier ones: the rarer, the later.
struct ShownKind {
    EdgeKind kind;
    vec3 colorLinear;
    const char* label;
};
const std::array kKinds = {ShownKind{EdgeKind::boundary, look::kBoundaryEdge, "boundary edges, one triangle: "},
                           ShownKind{EdgeKind::multiple, look::kMultipleEdge, "edges of more than two triangles: "},
                           ShownKind{EdgeKind::inconsistent, look::kInconsistentEdge,
                                     "edges whose two triangles are wound against each other: "}};

constexpr float kFaceShare = 0.35f; ///< of the picture's light: coloured lines stand out from white surfaces too
constexpr float kFaint = 0.45f;     ///< how much of its colour a hidden edge has

/// The edges of one mesh, by kind, as pairs of vertices.
using EdgeLines = std::array<std::vector<std::uint32_t>, kKinds.size()>;

EdgeLines linesOf(const scene::Mesh& mesh) {
    EdgeLines lines;
    const scene::MeshTopology topology = scene::buildTopology(mesh);
    for (const scene::Edge& edge : topology.edges)
        for (std::size_t kind = 0; kind < kKinds.size(); ++kind)
            if (scene::kindOf(topology, edge) == kKinds[kind].kind)
                lines[kind].insert(lines[kind].end(), {edge.a, edge.b});
    return lines;
}

void drawLines(const gl::MeshBuffers& mesh, const std::vector<std::uint32_t>& lines) {
    if (lines.empty()) return;
    const gl::VertexArrayHandle vertexArray = gl::VertexArrayHandle::create();
    glBindVertexArray(vertexArray.id());
    glBindBuffer(GL_ARRAY_BUFFER, mesh.positionBuffer());
    glEnableVertexAttribArray(gl::kPositionMesh);
    glVertexAttribPointer(gl::kPositionMesh, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    const gl::BufferHandle indices = gl::uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, lines);
    glDrawElements(GL_LINES, static_cast<GLsizei>(lines.size()), GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

/// What a pixel of the drawn lines says: r is the kind, counted from 1, or 0 where there is none; g is 255 where the edge
/// is in view, 0 where something hides it.
using EdgePixel = glm::u8vec4;

/// Lines of one pixel, row 0 on top.
std::vector<EdgePixel> drawEdges(const scene::Scene& scene, const gl::SceneBuffers& buffers, const View& view,
                                 const std::vector<const EdgeLines*>& linesOfObject) {
    const gl::DebugGroup group("mesh edges");
    const gl::Texture2D edges(GL_RGBA8, view.size, "mesh edges");
    const gl::Texture2D depth(GL_DEPTH24_STENCIL8, view.size, "mesh edges");
    const gl::Framebuffer framebuffer(&edges, &depth, "mesh edges");
    const gl::Program depthOnly("position.vert", "nothing.frag"), line("position.vert", "constant.frag");
    const double aspect = static_cast<double>(view.size.x) / view.size.y;
    const gl::EyeMatrices eye =
        gl::eyeMatrices(scene::withTightNear(view.camera, scene, buffers.bounds(), aspect), view.size);

    gl::setBaselineState();
    framebuffer.bind();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    // Surfaces go back by what their depth changes within one pixel, and four steps of the buffer for rounding: else they
    // would half bury the lines that lie on them.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1, 4);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    depthOnly.use();
    gl::drawSurfacesWithHoles(depthOnly, scene, buffers, eye);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_POLYGON_OFFSET_FILL);

    line.use();
    glDepthMask(GL_FALSE);
    for (const bool inView : {false, true})
        for (std::size_t kind = 0; kind < kKinds.size(); ++kind)
            for (std::size_t i = 0; i < scene.objects.size(); ++i) {
                if (!linesOfObject[i]) continue;
                glDepthFunc(inView ? GL_LEQUAL : GL_GREATER);
                line.set("color", vec4(static_cast<float>(kind + 1) / 255, inView ? 1 : 0, 0, 1));
                line.set("clipFromMesh", mat4(eye.clipFromMesh(scene.objects[i])));
                drawLines(buffers.mesh(i), (*linesOfObject[i])[kind]);
            }
    gl::check("mesh edges");
    return gl::readRows<EdgePixel>(edges, GL_UNSIGNED_BYTE);
}

vec3 linear(const image::Color8& color) {
    return {image::linearFromSrgb(color.r), image::linearFromSrgb(color.g), image::linearFromSrgb(color.b)};
}

void greyAndDarken(image::Image& picture) {
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const float luminance = glm::dot(linear(picture.at(x, y)), vec3(0.2126f, 0.7152f, 0.0722f)); // Rec. 709
            picture.set(x, y, image::encoded(vec3(kFaceShare * luminance)));
        }
}

/// Hidden edges one pixel wide, and over them a disc at every pixel of an edge in view.
void paint(image::Image& picture, const std::vector<EdgePixel>& edges) {
    const int radius = look::lineRadius(picture.height);
    const auto forEachPixel = [&](const auto& visit) {
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                const EdgePixel& pixel = edges[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                               static_cast<std::size_t>(x)];
                if (pixel.r > 0) visit(x, y, kKinds[pixel.r - 1].colorLinear, pixel.g > 0);
            }
    };
    forEachPixel([&](int x, int y, const vec3& color, bool inView) {
        if (!inView) picture.set(x, y, image::encoded(glm::mix(linear(picture.at(x, y)), color, kFaint)));
    });
    forEachPixel([&](int x, int y, const vec3& color, bool inView) {
        if (!inView) return;
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx)
                if (dx * dx + dy * dy <= radius * radius && picture.contains(x + dx, y + dy))
                    picture.set(x + dx, y + dy, image::encoded(color));
    });
}

/// "68 (lid 64, floor 4)", or "64 (lid)": how many edges there are, and whose, unless there is only one object.
std::string counts(const scene::Scene& scene, const std::vector<const EdgeLines*>& linesOfObject, std::size_t kind) {
    constexpr std::size_t kMostNamed = 3;
    std::size_t total = 0, having = 0;
    std::string named;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const std::size_t edges = linesOfObject[i] ? (*linesOfObject[i])[kind].size() / 2 : 0;
        total += edges;
        if (edges > 0 && having++ < kMostNamed)
            named += (named.empty() ? "" : ", ") + scene.objects[i].name + " " + std::to_string(edges);
    }
    if (having > kMostNamed) named += ", " + std::to_string(having - kMostNamed) + " more objects";
    const auto isMesh = [](const EdgeLines* lines) { return lines != nullptr; };
    if (total == 0 || std::ranges::count_if(linesOfObject, isMesh) < 2) return std::to_string(total);
    if (having == 1) named.erase(named.rfind(' ')); // its number is the total
    return std::to_string(total) + " (" + named + ")";
}

} // namespace

Panel meshEdgesPanel(image::Image picture, const scene::Scene& scene, const gl::SceneBuffers& buffers,
                     const View& view) {
    std::map<const scene::Mesh*, EdgeLines> linesOfMesh;
    std::vector<const EdgeLines*> linesOfObject; // none for the surface of a light, which is not a mesh of the user's
    for (const scene::Object& object : scene.objects) {
        if (object.emitterOfLight >= 0) {
            linesOfObject.push_back(nullptr);
            continue;
        }
        const auto [lines, isNew] = linesOfMesh.try_emplace(object.mesh.get());
        if (isNew) lines->second = linesOf(*object.mesh);
        linesOfObject.push_back(&lines->second);
    }

    Panel panel{std::move(picture), "", StageKind::swatches, {}};
    greyAndDarken(panel.picture);
    paint(panel.picture, drawEdges(scene, buffers, view, linesOfObject));
    for (std::size_t kind = 0; kind < kKinds.size(); ++kind)
        if (const std::string text = counts(scene, linesOfObject, kind); text != "0")
            panel.display.key.push_back({kKinds[kind].colorLinear, kKinds[kind].label + text});
    if (panel.display.key.empty())
        panel.display.key.push_back({vec3(kFaceShare), "no open or doubtful edges: all meshes are closed"});
    return panel;
}

} // namespace shadowlab::picture
