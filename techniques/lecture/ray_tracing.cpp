// Ray tracing in the order of the lecture's pages: where secondary rays go, the ray casting procedure with its binary tree, then the
// pixel intensity. The passes at the end carry it out for each pixel. What a ray meets: parts/rays.cpp, with bounding volumes.
//
// A. Appel, "Some Techniques for Shading Machine Renderings of Solids", 1968: rays from the eye, and from there to lights.
// T. Whitted, "An Improved Illumination Model for Shaded Display", 1980: the tree of reflection and refraction rays.
// Simplified: one ray for each pixel; a light with an area is the point in its middle; k_r and k_t are the same at every angle; glass
// is closed, and has air around it; no light is thrown by mirrors and glass on other surfaces (caustics).
// SPDX-License-Identifier: MIT
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <tuple>
#include <utility>

#include "techniques/foundation/scene/query/shading.h"
#include "techniques/frame.h"
#include "techniques/lecture/lecture.h"
#include "techniques/lecture/parts/pixel_rows.h"
#include "techniques/lecture/parts/rays.h"
#include "techniques/lecture/words/ray_tracing.h"

namespace shadowlab::lecture {

// --- Secondary Rays -------------------------------------------------------------------------------------------------

// [anchor: lecture-secondary-rays]
dvec3 reflected(const dvec3& u, const dvec3& N) { return u - 2.0 * glm::dot(u, N) * N; }

// Snell's law: sin(refracted) = eta sin(incoming).
// [anchor: lecture-refraction]
std::optional<dvec3> refracted(const dvec3& u, const dvec3& N, double eta) {
    const double cosIncoming = -glm::dot(u, N);
    const double cosSquared = 1 - eta * eta * (1 - cosIncoming * cosIncoming);
    if (cosSquared <= 0) return std::nullopt;
    return eta * u + (eta * cosIncoming - std::sqrt(cosSquared)) * N;
}

namespace {

/// A surface of the binary ray-tracing tree, and the pixel ray or secondary ray that meets it.
struct Node {
    Ray ray;
    int level = 0;                    ///< the root's is 0
    std::optional<Surface> surface{}; ///< none: the ray intersects no surfaces
    double kR = 0, kT = 0;            ///< coefficients of reflection and of transparency
    std::unique_ptr<Node> reflection{}, refraction{};
};

// --- Ray Casting Procedure -------------------------------------------------------------------------------------------

// "1. Cast pixel ray from projection reference point through pixel center." The projection plane is 1 m before the eye.
// [anchor: lecture-pixel-ray]
Ray pixelRay(const View& view, ivec2 pixel) {
    const double halfHeight = std::tan(view.camera.fovYDegrees * glm::pi<double>() / 360.0), height = view.size.y;
    const dvec2 center = halfHeight / height * (2.0 * (dvec2(pixel) + 0.5) - dvec2(view.size));
    const dvec3 centerView(center.x, -center.y, -1.0); // row 0 is the uppermost
    const dmat3 worldFromView = glm::transpose(dmat3(scene::viewFromWorld(view.camera)));
    return {view.camera.positionWorld, glm::normalize(worldFromView * centerView),
            view.camera.near * glm::length(centerView)};
}

// "2. Each time a pixel ray intersects an object surface, it splits into two secondary rays: a reflection ray and a
// refraction ray. 3. Each intersected surface is added to a binary ray-tracing tree. 4. A pixel ray is terminated when the
// ray intersects no surfaces, intersects a light source that is not a reflecting surface, or the ray-tracing tree reaches
// maximum allowable depth." Without the last rule two mirrors that face each other would never come to an end.
// [anchor: lecture-tree]
void grow(const RayScene& rays, Node& node, int maximumDepth) {
    node.surface = rays.firstSurface(node.ray);
    if (!node.surface) return;
    const auto& [positionWorld, N, material, diffuse, triangle, distance, onFront] = *node.surface;
    node.kR = material->reflectivity;
    node.kT = material->transparency;
    if (node.kR == 0 && node.kT == 0) return; // opaque and dull, as light sources are

    const double eta = onFront ? 1 / material->ior : material->ior; // from air into glass, or out of it
    const std::optional<dvec3> T = refracted(node.ray.u, N, eta);
    if (!T) node.kR += std::exchange(node.kT, 0.0); // total reflection
    if (node.level == maximumDepth) return;
    const auto split = [&](const dvec3& u) {
        auto child = std::make_unique<Node>(Node{rayFrom(*node.surface, u), node.level + 1});
        grow(rays, *child, maximumDepth);
        return child;
    };
    if (node.kR > 0) node.reflection = split(reflected(node.ray.u, N));
    if (node.kT > 0) node.refraction = split(*T); // "No refraction ray for opaque object."
}

// --- Pixel Intensity Calculation -------------------------------------------------------------------------------------

// The shadow ray: the light is seen if nothing stands between. The side of the triangle that is turned away from the light
// does not see it (docs/conventions.md, the facing gate), nor does what is outside of a spot's cone.
// [anchor: lecture-shadow-ray]
bool seesLight(const RayScene& rays, const Surface& surface, int light) {
    const scene::Light& source = rays.scene().light(light);
    const int lightSide = rays.lightSide(*surface.triangle, light);
    if ((surface.onFront ? lightSide : -lightSide) <= 0 || !scene::lightShinesTo(source, surface.positionWorld))
        return false;
    if (!rays.objectOf(*surface.triangle).receivesShadow) return true;
    Ray shadowRay = rayFrom(surface, scene::towardLightWorld(source, surface.positionWorld));
    if (source.type != scene::LightType::directional)
        shadowRay.farthest = glm::distance(source.positionWorld, surface.positionWorld) - kContact;
    return !rays.isBlocked(shadowRay, light);
}

// "The ray-tracing tree is processed in bottom-up order": both branches are known before the node. A ray at the bottom of the
// tree has the background's intensity. A surface is lit as in every technique of this program (docs/conventions.md).
// [anchor: lecture-intensity]
dvec3 intensity(const RayScene& rays, const Node* node, const dvec2& attenuation) {
    const scene::Scene& scene = rays.scene();
    if (!node || !node->surface) return dvec3(scene.background);
    const dvec3 I_R = node->kR > 0 ? intensity(rays, node->reflection.get(), attenuation) : dvec3(0.0);
    const dvec3 I_T = node->kT > 0 ? intensity(rays, node->refraction.get(), attenuation) : dvec3(0.0);

    const Surface& surface = *node->surface;
    const dvec3 V = -node->ray.u, N = surface.N;
    dvec3 I = dvec3(rays.emissionAt(surface)) + dvec3(scene.ambient) * surface.diffuse;
    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        if (!seesLight(rays, surface, light)) continue;
        const scene::Light& source = scene.light(light);
        const dvec3 L = scene::towardLightWorld(source, surface.positionWorld);
        I += scene::irradiance(source, surface.positionWorld, N) * // intensity of the light * N.L / distance^2
             scene::reflectance(*surface.material, surface.diffuse, N, L, V); // diffuse, and specular by N.H
    }
    I += node->kR * I_R + node->kT * I_T;
    const double d = surface.distance; // "Pixel ray intensity is attenuated by the distance it travels."
    return I / (1 + attenuation.x * d + attenuation.y * d * d);
}

int levels(const Node& node) { // of the tree, the root's included
    return 1 + std::max(node.reflection ? levels(*node.reflection) : 0, node.refraction ? levels(*node.refraction) : 0);
}

// --- Passes ----------------------------------------------------------------------------------------------------------

class RayTracing final : public Technique {
public:
    params::ParamList params() override {
        const std::string left = "After d metres the share 1 / (1 + c1 d + c2 d^2) of a ray's intensity is left.";
        return {params::integer({"depth", "Maximum depth of the ray tree"}, depth_, 0, 16, "levels",
                                "Maximum allowable depth of the tree: levels below the pixel ray."),
                params::real({"c1", "Attenuation c1, linear"}, attenuation_.x, 0, 1000, "1/m", left),
                params::real({"c2", "Attenuation c2, quadratic"}, attenuation_.y, 0, 1000, "1/m^2", left)};
    }

    Progress prepare(const scene::Snapshot& snapshot, Deadline) override {
        if (snapshot != snapshot_) rays_ = RayScene(snapshot);
        snapshot_ = snapshot;
        return {};
    }

    Progress render(Frame& frame) override {
        beginOrGoOn(frame);
        const View& view = frame.view();
        bool finished = true; // each picture is computed by itself, and only if it is looked at
        const auto compute = [&](PixelRows& rows, const auto& texelOfRay) {
            finished &= rows.advance(frame.deadline(), [&](ivec2 pixel) { return texelOfRay(pixelRay(view, pixel)); });
        };
        frame.pass(passInfo(kRayPasses, "pixel-rays"), [&] {
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
            if (!frame.wants("distance")) return;
            compute(distance_, [&](const Ray& ray) {
                const auto surface = rays_.firstSurface(ray);
                return surface ? vec4(surface->distance, 1, 0, 0) : vec4(0.0f);
            });
        });
        for (int light = 0; light < static_cast<int>(visibility_.size()); ++light)
            frame.pass(
                passInfo(kRayPasses, "shadow-rays"),
                [&] {
                    if (!frame.wants("visibility", light)) return;
                    compute(visibility_[static_cast<std::size_t>(light)], [&](const Ray& ray) {
                        const auto surface = rays_.firstSurface(ray);
                        return surface ? vec4(seesLight(rays_, *surface, light), 1, 0, 0) : vec4(0.0f);
                    });
                },
                light);
        frame.pass(passInfo(kRayPasses, "tree"), [&] {
            if (!frame.wants("tree-depth")) return;
            compute(levels_, [&](const Ray& ray) {
                Node root{ray};
                grow(rays_, root, depth_);
                return root.surface ? vec4(levels(root), 1, 0, 0) : vec4(0.0f);
            });
        });
        frame.pass(passInfo(kRayPasses, "intensity"), [&] {
            compute(intensity_, [&](const Ray& ray) {
                Node root{ray};
                grow(rays_, root, depth_);
                return vec4(intensity(rays_, &root, attenuation_), 1);
            });
            intensity_.upload(frame.target().color);
        });
        publish(frame, "distance", kNoLight, distance_, "m from the eye");
        publish(frame, "tree-depth", kNoLight, levels_, "levels");
        for (int light = 0; light < static_cast<int>(visibility_.size()); ++light)
            publish(frame, "visibility", light, visibility_[static_cast<std::size_t>(light)], "");
        isFinished_ = finished;
        return {intensity_.done(), finished};
    }

private:
    /// While the picture stays the same, the next frame goes on where a deadline ended the last one, the next step with what is there.
    void beginOrGoOn(const Frame& frame) {
        const Asked asked{snapshot_, frame.view().camera, frame.view().size, depth_, attenuation_};
        const bool isOtherStep = std::exchange(stopsAfter_, frame.stopsAfter()) != frame.stopsAfter();
        if (asked == asked_ && (!isFinished_ || isOtherStep)) return;
        asked_ = asked;
        visibility_.assign(snapshot_->lights.size(), PixelRows());
        for (PixelRows* rows : {&distance_, &levels_, &intensity_})
            rows->restart(frame.view().size);
        for (PixelRows& rows : visibility_) rows.restart(frame.view().size);
    }

    static void publish(Frame& frame, std::string_view stage, int light, const PixelRows& rows, std::string unit) {
        if (frame.wants(stage, light)) frame.publish(stage, light, rows.asTexture(stage), rows.scale(std::move(unit)));
    }

    using Asked = std::tuple<scene::Snapshot, scene::Camera, ivec2, int, dvec2>;
    int depth_ = 4; // up to 2^5 rays for a pixel of glass, and each level doubles them
    dvec2 attenuation_{0.0};
    scene::Snapshot snapshot_;
    RayScene rays_;
    Asked asked_;
    std::optional<StageKey> stopsAfter_;
    bool isFinished_ = true;
    PixelRows distance_, levels_, intensity_;
    std::vector<PixelRows> visibility_; ///< per light
};

} // namespace

const TechniqueInfo& rayTracing() {
    using enum scene::LightType;
    static const TechniqueInfo info{
        .id = "lecture-ray-tracing",
        .title = "Lecture: ray tracing",
        .paper = "Appel 1968; Whitted 1980, An Improved Illumination Model for Shaded Display",
        .getsWrong = "soft shadows and jagged edges (one ray each); glass reflects alike at every angle; caustics",
        .order = 150,
        .group = TechniqueGroup::lecture,
        .sister = "ray-traced",
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kRayPasses), std::end(kRayPasses)},
        .stages = {std::begin(kRayStages), std::end(kRayStages)},
        .pseudocode = kRayCastingProcedure,
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<RayTracing>(); },
    };
    return info;
}

} // namespace shadowlab::lecture
