// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/exact/exact_pass.h"

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/debug.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/query/facing.h"

namespace shadowlab::shadow_map {

namespace {

// A texel reaches half its width to each side of its centre. A tenth more is for rounding: positions in the shader are
// good to a thousandth of a texel, of maps with many texels far from their light to some hundredths.
constexpr float kReachTexels = 0.6f;

template <typename Visit>
void forEachTriangleWithHoles(const scene::Scene& scene, const scene::Object& object, const Visit& visit) {
    for (std::size_t p = 0; p < object.mesh->parts.size(); ++p) {
        if (!scene::maskOfPart(scene, object, p)) continue;
        const scene::MeshPart& part = object.mesh->parts[p];
        for (std::uint32_t t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t)
            visit(object.mesh->triangles[t]);
    }
}

/// Calls found(a, b) with the welded vertices of each edge at which the surface does not simply go on as the light sees it: it does
/// so only between two triangles that lie to either side of the edge. `facing` is one sign per triangle (scene/query/facing.h).
void forEachLooseEdge(const scene::MeshTopology& topology, std::span<const std::int8_t> facing,
                      const std::function<void(std::uint32_t a, std::uint32_t b)>& found) {
    for (const scene::Edge& edge : topology.edges) {
        // A triangle that runs a -> b and faces the light lies to the left of the edge; turn over one, and it is the right.
        int left = 0, right = 0;
        for (std::uint32_t u = edge.firstUse; u < edge.firstUse + edge.useCount; ++u) {
            const int side = topology.uses[u].direction * facing[topology.uses[u].triangle];
            left += side > 0;
            right += side < 0;
        }
        const bool goesOn = edge.useCount == 2 && left == 1 && right == 1;
        if (!goesOn) found(edge.a, edge.b);
    }
}

LooseEdges upload(const std::vector<vec3>& points) {
    LooseEdges edges{gl::VertexArrayHandle::create(), gl::uploadBuffer(GL_ARRAY_BUFFER, points),
                     static_cast<int>(points.size() / 2)};
    glBindVertexArray(edges.vertexArray.id());
    glBindBuffer(GL_ARRAY_BUFFER, edges.points.id());
    for (GLuint end = 0; end < 2; ++end) {
        glEnableVertexAttribArray(end);
        glVertexAttribPointer(end, 3, GL_FLOAT, GL_FALSE, 2 * sizeof(vec3),
                              reinterpret_cast<const void*>(end * sizeof(vec3)));
        glVertexAttribDivisor(end, 1);
    }
    return edges;
}

} // namespace

bool ExactPass::prepare(const scene::Snapshot& snapshot, Deadline deadline) {
    if (!tracer_.advance(snapshot, deadline)) return false;
    const std::pair revisions(snapshot->revisions.geometry, snapshot->revisions.transforms);
    if (crossedRevisions_ == revisions) return true;
    std::vector<std::uint8_t> casting;
    for (const scene::Object& object : snapshot->objects)
        casting.push_back(object.castsShadow ? 1 : 0);
    crossings_ = surfaceCrossings(tracer_.bvh(), tracer_.world(), casting);
    topologies_.forgetUnused();
    crossedRevisions_ = revisions;
    return true;
}

void ExactPass::bindWalk(const gl::Program& program, int light, int positionUnit, int triangleUnit) const {
    edges_.at(light).positions.bind(positionUnit);
    triangles_.bind(triangleUnit);
    program.set("positionsLightRelative", positionUnit);
    program.set("triangles", triangleUnit);
}

void ExactPass::findEdges(const scene::Scene& scene, int light, const LightMaps& maps,
                          std::span<const std::size_t> casters) {
    const std::pair revisions(scene.revisions.geometry, scene.revisions.materials);
    if (walkedRevisions_ != revisions) triangles_ = walkTriangles(scene, topologies_);
    walkedRevisions_ = revisions;
    const scene::Light& source = scene.light(light);
    CachedEdges& cached = edges_[light];
    EdgesCacheKey key{scene.revisions.geometry, scene.revisions.transforms,      scene.revisions.materials, source,
                      maps.originWorld,         {casters.begin(), casters.end()}};
    if (cached.foundFor == key) return;
    std::vector<vec3> points;
    for (const std::size_t caster : casters) {
        const scene::Object& object = scene.objects[caster];
        const dmat4 lightRelative = lightRelativeFromMesh(maps, object);
        const auto add = [&](std::uint32_t vertex) {
            points.emplace_back(transformPoint(lightRelative, dvec3(object.mesh->positionsMesh[vertex])));
        };
        const auto addEdge = [&](std::uint32_t a, std::uint32_t b) {
            add(a);
            add(b);
        };
        forEachLooseEdge(topologies_.of(object.mesh), scene::facingSigns(object, source), addEdge);
        forEachTriangleWithHoles(scene, object, [&](const uvec3& corners) {
            for (int i = 0; i < 3; ++i)
                addEdge(corners[i], corners[(i + 1) % 3]);
        });
    }
    const dvec3 lightRelativeFromCentred = tracer_.world().originWorld - maps.originWorld;
    for (const Crossing& crossing : crossings_)
        for (const dvec3& end : {crossing.aCentred, crossing.bCentred})
            points.emplace_back(end + lightRelativeFromCentred);
    cached.edges = upload(points);
    cached.positions = walkPositions(scene, maps);
    cached.foundFor = std::move(key);
}

void ExactPass::drawEdges(const Frame& frame, const LightMaps& maps, int light, int layer,
                          std::span<const std::size_t> casters, const gl::DepthTextureArray& edgeDepths) const {
    const LooseEdges& edges = edges_.at(light).edges;
    const gl::Framebuffer framebuffer(edgeDepths, layer, "loose edges");
    framebuffer.bind();
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_CLAMP); // an edge may begin before the near plane, and is the nearer for it
    looseEdge_.use();
    looseEdge_.set("lightClipFromEdges", mat4(maps.lightClipFromLightRelative(layer)));
    looseEdge_.set("resolution", static_cast<float>(edgeDepths.side()));
    looseEdge_.set("reach", kReachTexels);
    glBindVertexArray(edges.vertexArray.id());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, edges.count);

    // A surface with holes may end anywhere. At its texel's centre it may be farther away than elsewhere in the texel: by
    // half its slope in both directions, of which the offset takes the larger.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1.5f, -4.0f);
    whole_.use();
    for (const std::size_t caster : casters) {
        const scene::Object& object = frame.scene().objects[caster];
        whole_.set("clipFromMesh", mat4(maps.lightClipFromLightRelative(layer) * lightRelativeFromMesh(maps, object)));
        for (std::size_t p = 0; p < object.mesh->parts.size(); ++p)
            if (scene::maskOfPart(frame.scene(), object, p))
                frame.buffers().mesh(caster).draw(object.mesh->parts[p].firstTriangle,
                                                  object.mesh->parts[p].triangleCount);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
}

const Decisions& ExactPass::decide(Frame& frame, int light, const std::function<void()>& draw) {
    Decisions& decisions = decisions_[light];
    const View& view = frame.view();
    decisions.visibility = gl::Texture2D(GL_R8, view.size, "decided");
    {
        const gl::Framebuffer framebuffer(&decisions.visibility, &frame.target().depthStencil, "decided");
        framebuffer.bind();
        glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        gl::setVisibilityState();
        draw();
        const auto [corner, size] = drawnRegion(view);
        const int bottom = view.size.y - corner.y - size.y; // GL counts rows from below
        decisions.byMap.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.id());
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(corner.x, bottom, size.x, size.y, GL_RED, GL_UNSIGNED_BYTE, decisions.byMap.data());
        gl::check("reading what the map decided");
        const auto place = [&](ivec2 pixel) {
            const ivec2 inRegion(pixel.x - corner.x, view.size.y - 1 - pixel.y - bottom);
            return static_cast<std::size_t>(inRegion.y) * static_cast<std::size_t>(size.x) +
                   static_cast<std::size_t>(inRegion.x);
        };
        std::vector<ivec2> undecided;
        for (int y = corner.y; y < corner.y + size.y; ++y)
            for (int x = corner.x; x < corner.x + size.x; ++x)
                if (const std::uint8_t answer = decisions.byMap[place({x, y})]; answer != 0 && answer != 255)
                    undecided.emplace_back(x, y);
        trace::sortByBlock(undecided);
        const std::vector<trace::Visibility> traced =
            rays_.visibilities(undecided, tracer_, view.camera, view.size, light);
        std::vector<std::uint8_t> final = decisions.byMap;
        for (std::size_t i = 0; i < undecided.size(); ++i)
            final[place(undecided[i])] = traced[i] == trace::Visibility::lit ? 255 : 0;
        decisions.traced = undecided.size();
        glBindTexture(GL_TEXTURE_2D, decisions.visibility.id());
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexSubImage2D(GL_TEXTURE_2D, 0, corner.x, bottom, size.x, size.y, GL_RED, GL_UNSIGNED_BYTE, final.data());
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
        frame.count("traced-pixels", static_cast<double>(undecided.size()), static_cast<double>(final.size()),
                    "pixels");
    }
    return decisions;
}

void ExactPass::publishTraced(Frame& frame, int light) const {
    const Decisions& decisions = decisions_.at(light);
    const auto [corner, size] = drawnRegion(frame.view());
    const vec3 lit = look::kLit, dark = look::kShadowed, traced = look::kOccluded;
    std::vector<vec4> texels;
    for (const std::uint8_t answer : decisions.byMap)
        texels.emplace_back(answer == 255 ? lit : answer == 0 ? dark : traced, 1.0f);
    gl::Texture2D texture(GL_RGBA16F, frame.view().size, "traced");
    glTexSubImage2D(GL_TEXTURE_2D, 0, corner.x, frame.view().size.y - corner.y - size.y, size.x, size.y, GL_RGBA,
                    GL_FLOAT, texels.data());
    frame.publish("traced", light, std::move(texture),
                  {.unit = "",
                   .key = {{lit, "the map is certain: lit"},
                           {dark, "the map is certain: in shadow, or facing away"},
                           {traced, "decided by a ray"}}});
}

} // namespace shadowlab::shadow_map
