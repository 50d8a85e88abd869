// What `probe` prints of a pixel, and drawings show: its tree of rays, its samples, what its eye ray passes, and the light that it
// sees.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/ray_tracing/params.h"
#include "techniques/ray_tracing/sampling/sampling_scene.h"
#include "techniques/ray_tracing/structures/structure_cache.h"
#include "techniques/technique.h"

namespace shadowlab::ray_tracing {

/// Which pixel is asked about, and what its rays are traced with.
struct PixelQuery {
    const trace::SceneTracer& tracer;
    const Surfaces& surfaces;
    const StructureCache& structures;
    const SamplingScene& sampling;
    const SamplingParams& params;
    TreeSettings tree;
    const View& view;
    ivec2 pixel{0};
    int light = kNoLight;  ///< whose shadow rays are drawn
    bool asksArea = false; ///< how much of that light's area is seen, too
};

/// All of the below for one pixel.
void describePixel(const PixelQuery& query, Probe& probe);

/// Adds a node for every ray of the tree, below each its shadow rays, parents before children. Surfaces are numbered S1,
/// S2 ... in the order of the tree, level by level; R1 and T1 are the rays that S1 sends on. The lines of the probe become
/// those of the rays that were followed, with the shadow rays of their ends to `light` (kNoLight: none); its vectors those
/// of the first surface.
void describeTree(const RayTree& tree, const Surfaces& surfaces, int light, Probe& probe);

struct SampleQuery {
    const Surfaces& surfaces;
    const trace::MovingScene& scene;
    const AnalyticLights* analytic; ///< nullptr: none
    const scene::Camera& camera;
    ivec2 size{0};
    ivec2 pixel{0};
    int light = kNoLight; ///< whose shadow rays are listed
};

/// Adds the first samples of the pixel, as SampledPicture takes them, to the probe: Probe::rays, and a fact for each of a few.
/// `first`: what the ray through the pixel's middle hits.
void describeSamples(const SampleQuery& query, const SampledSettings& settings, const trace::SurfacePoint& first,
                     Probe& probe);

/// Fills Probe::structure, if the structure has parts to show. `toHit`: the eye ray, up to the first surface.
void describeStructure(const trace::SceneTracer& tracer, const trace::Engine& engine, const trace::Ray& toHit,
                       Probe& probe);

} // namespace shadowlab::ray_tracing
