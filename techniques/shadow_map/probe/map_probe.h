// The comparison of one point with its map, step by step, and what of the map the plane of a drawing passes through.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "techniques/probe.h"
#include "techniques/probed/map_probe.h"
#include "techniques/shadow_map/bias/compared_depth.h"
#include "techniques/shadow_map/probe/texel_depths.h"

namespace shadowlab::shadow_map {

/// A point that is compared, and with what.
struct ComparedPoint {
    const scene::Scene& scene;
    const LightMaps& maps;
    int layer = 0;
    const ShadowMapParams& params;
    const FilterParams& filter;
    const TexelDepths& depths;
    const scene::Light& light;
    dvec3 pointWorld{0.0};
    std::array<dvec3, 3> cornersWorld{}; ///< of the triangle that the point lies on
    ivec2 fragment{0};                   ///< the pixel, rows counted from below: it may turn the samples
    double minReferenceDepth = 0;        ///< of the object that the point is on (light_maps.h)
};

/// What a filter reads for the point, and the visibility that follows.
struct FilterAnswer {
    std::vector<MapProbe::Tap> taps;
    std::optional<MapProbe::BlockerSearch> search{};
    std::optional<MapProbe::Moments> moments{};
    double visibility = 1;
};

/// The filters' own answers, as their entries in the table name them (filters/filters.cpp). softShadowAnswer: the comparisons are
/// those that the search leads to, none where it finds no blocker; momentAnswer: without coarser moments than the finest.
FilterAnswer hardAnswer(const ComparedPoint& point);
FilterAnswer fourTexelsAnswer(const ComparedPoint& point);
FilterAnswer squareAnswer(const ComparedPoint& point);
FilterAnswer discAnswer(const ComparedPoint& point);
FilterAnswer softShadowAnswer(const ComparedPoint& point);
FilterAnswer momentAnswer(const ComparedPoint& point);

/// All but what the filter reads and the drawing's cells. Nothing where the point is behind the light's camera.
std::optional<MapProbe> probeMap(const ComparedPoint& point);

/// The texels on both sides of the point that the plane passes through, and some of all that it does.
void addCells(MapProbe& probe, const ComparedPoint& point, const LightSection& section);

/// Metres along the light's axis that a depth at a place of the map stands for.
double metresOf(const LightMaps& maps, int layer, const dvec2& uv, double depth);

/// One layer of a point's map, and its comparison.
class ProbedLayer {
public:
    explicit ProbedLayer(const ComparedPoint& point);
    /// A comparison at that offset; its weight is set by the caller.
    [[nodiscard]] MapProbe::Tap tap(const dvec2& offsetUv) const { return tap(offsetUv, depthAt(offsetUv)); }
    [[nodiscard]] MapProbe::Tap tap(const dvec2& offsetUv, double compared) const;
    /// What a comparison at that offset from the point's place compares.
    [[nodiscard]] double depthAt(const dvec2& offsetUv) const { return comparison_.referenceDepth(place_, offsetUv); }
    [[nodiscard]] const ComparedPlace& place() const { return place_; }
    [[nodiscard]] const dmat4& lightRelativeFromClip() const { return lightRelativeFromClip_; }
    [[nodiscard]] const dmat4& clipFromLightRelative() const { return comparison_.lightClipFromLightRelative(); }
    [[nodiscard]] double resolution() const { return point_.params.resolution; }
    [[nodiscard]] ivec2 texelOf(const dvec2& uv) const { return ivec2(glm::floor(uv * resolution())); }

private:
    const ComparedPoint& point_;
    DepthComparison comparison_;
    dmat4 lightRelativeFromClip_;
    ComparedPlace place_;
};

} // namespace shadowlab::shadow_map
