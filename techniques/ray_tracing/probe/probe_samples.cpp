// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/probe/pixel_probe.h"

#include "techniques/foundation/trace/area/area_visibility.h"
#include "techniques/probed/rays_probe.h"
#include "techniques/ray_tracing/probe/ray_shapes.h"

namespace shadowlab::ray_tracing {

namespace {

// More are too many for a drawing, and trees of glass take milliseconds each.
constexpr int kMostListed = 256;
constexpr int kMostLines = 16; ///< samples listed as facts

/// The end of a shadow ray: the point on the light, or the first hit on something that casts a shadow.
dvec3 shadowEnd(const SampleQuery& query, const TreeNode& node, const dvec3& toPlace, double time) {
    const trace::SceneTracer& tracer = query.surfaces.tracer();
    trace::Ray ray;
    ray.originCentred = node.positionCentred;
    ray.directionCentred = toPlace;
    ray.nearest = trace::kContact;
    ray.farthest = 1.0;
    std::uint32_t leftOut = node.point.primitive;
    for (;;) {
        const trace::SurfacePoint hit = query.scene.met(ray, leftOut, time);
        if (!hit) return node.positionCentred + toPlace;
        const dvec3 at = query.scene.positionCentred(hit, time);
        if (tracer.objectOf(hit).castsShadow) return at;
        // An object that casts no shadow does not block: continue from there.
        ray.nearest = glm::length(at - ray.originCentred) / glm::length(toPlace) + trace::kContact;
        leftOut = hit.primitive;
    }
}

void describeSurface(const SampleQuery& query, const RayTree& tree, double time, RaysProbe::Sample& sample) {
    const TreeNode& root = tree.root();
    const dvec3& originWorld = query.surfaces.tracer().world().originWorld;
    const auto wayOf = [&](int child) -> std::optional<dvec3> {
        if (child < 0 || tree.nodes()[static_cast<std::size_t>(child)].u == dvec3(0)) return std::nullopt;
        return tree.nodes()[static_cast<std::size_t>(child)].u;
    };
    sample.reflectedWorld = wayOf(root.reflection);
    sample.refractedWorld = wayOf(root.refraction);
    if (query.light < 0 || !scene::hasArea(query.surfaces.scene().light(query.light)))
        return;
    const LightAtNode& at = tree.lightsOf(root)[static_cast<std::size_t>(query.light)];
    if (at.toPlace == dvec3(0) || at.visibility < trace::Visibility::shadowed) return;
    sample.onLightWorld = originWorld + root.positionCentred + at.toPlace;
    sample.arrives = at.visibility == trace::Visibility::lit;
    sample.shadowEndWorld =
        sample.arrives ? *sample.onLightWorld : originWorld + shadowEnd(query, root, at.toPlace, time);
    sample.areaWeight = at.areaWeight;
}

std::string pairText(dvec2 pair) { return probeText(pair.x) + ", " + probeText(pair.y); }

void addFacts(const RaysProbe& rays, Probe& probe) {
    probe.facts.push_back(probeCount("samples of the pixel", static_cast<std::uint64_t>(rays.count)));
    probe.facts.push_back(probeFact("mean of their intensities", rays.mean()));
    if (const auto share = rays.sampledShare())
        probe.facts.push_back(probeFact("share of the light's area by their shadow rays", *share));
    for (int i = 0; i < std::min<int>(kMostLines, static_cast<int>(rays.samples.size())); ++i) {
        const RaysProbe::Sample& sample = rays.samples[static_cast<std::size_t>(i)];
        std::string text = "at (" + pairText(sample.place) + ") of the pixel";
        if (rays.shutter > 0) text += ", time " + probeText(sample.time);
        text += sample.meets ? ", meets " + sample.object : ", meets nothing";
        if (sample.onLightWorld) text += sample.arrives ? ", sees the light" : ", does not see the light";
        text += ", I = " + probeText(sample.intensity.r) + " " + probeText(sample.intensity.g) + " " +
                probeText(sample.intensity.b);
        probe.facts.push_back({"sample " + std::to_string(i + 1), text, ""});
    }
}

} // namespace

void describeSamples(const SampleQuery& query, const SampledSettings& settings, const trace::SurfacePoint& first,
                     Probe& probe) {
    const trace::SceneTracer& tracer = query.surfaces.tracer();
    const dvec3& originWorld = tracer.world().originWorld;
    const trace::EyeRays eyeRays = tracer.eyeRays(query.camera, query.size);
    const DielectricStack aroundEye = query.surfaces.mediaAround(eyeRays.eyeCentred());
    const scene::Bounds bounds = boundsOf(query.surfaces.scene());
    RaysProbe& rays = probe.add(RaysProbe{});
    rays.count = settings.pattern.count;
    rays.aperture = settings.aperture;
    rays.focus = settings.focus;
    rays.shutter = settings.shutter;
    for (const scene::Object& object : query.surfaces.scene().objects)
        if (object.velocityWorld != dvec3(0) && settings.shutter > 0)
            rays.movers.push_back({object.name, object.velocityWorld});
    if (first) {
        const scene::Material& material = query.surfaces.materialOf(first);
        rays.glossDegrees = settings.tree.gloss ? material.glossDegrees : 0;
        rays.translucencyDegrees = settings.tree.translucency ? material.translucencyDegrees : 0;
        if (query.light >= 0 && settings.tree.areaLights == AreaLights::sampled &&
            scene::hasArea(query.surfaces.scene().light(query.light)))
            rays.exactShare = trace::AreaVisibility(tracer, query.light).share(first);
    }
    RayTree tree;
    for (int i = 0; i < std::min(settings.pattern.count, kMostListed); ++i) {
        const SampleNumbers numbers(settings.pattern, query.pixel, static_cast<std::uint32_t>(i));
        const EyeSample eye = eyeSample(eyeRays, settings, query.pixel, numbers);
        const dvec3 u = glm::normalize(eye.ray.directionCentred);
        RaysProbe::Sample& sample = rays.samples.emplace_back();
        sample.place = eye.place - dvec2(query.pixel);
        if (settings.antialias) sample.subpixel = numbers.cell(Purpose::pixel);
        sample.time = eye.time;
        sample.fromWorld = originWorld + eye.ray.originCentred;
        const trace::SurfacePoint hit = query.scene.met(eye.ray, trace::kNoPrimitive, eye.time);
        sample.meets = static_cast<bool>(hit);
        if (!hit) {
            sample.toWorld = endBeyond(bounds, sample.fromWorld, u);
            sample.intensity = dvec3(query.surfaces.scene().background);
            continue;
        }
        sample.object = tracer.objectOf(hit).name;
        sample.toWorld = originWorld + query.scene.positionCentred(hit, eye.time);
        tree.trace({query.surfaces, query.scene, eye.time, &numbers, query.analytic}, settings.tree,
                   eye.ray.originCentred, u, hit, aroundEye);
        sample.intensity = tree.root().intensity;
        describeSurface(query, tree, eye.time, sample);
    }
    addFacts(rays, probe);
}

} // namespace shadowlab::ray_tracing
