// The light cameras of one frame: fitted to the casters that matter and to what the eye sees, and kept while nothing of that changes.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>

#include "techniques/frame.h"
#include "techniques/shadow_map/fit/fit.h"
#include "techniques/shadow_map/fit/shadowed_part.h"

namespace shadowlab::shadow_map {

/// What a map is needed for: the light, the casters whose shadow can fall on something, and the filter that will read it.
struct MapQuery {
    scene::Light light;
    std::vector<std::size_t> casters; ///< indices of objects
    FilterParams filter;
};

class MapFitter {
public:
    explicit MapFitter(const ShadowMapParams& params) : params_(params) {}

    /// Finds what does not depend on the eye: the objects' boxes, and the casters that matter for each light.
    void prepare(const scene::Snapshot& snapshot);
    /// Fits the maps of all lights to what the eye sees.
    void fitMaps(const Frame& frame);
    /// The fitted maps, one for each light.
    [[nodiscard]] const std::vector<LightMaps>& fitted() const { return fitted_; }
    [[nodiscard]] const LightMaps& fitted(int light) const { return fitted_[static_cast<std::size_t>(light)]; }

    [[nodiscard]] MapQuery query(const scene::Scene& scene, int light) const;
    [[nodiscard]] LightMaps fit(const scene::Scene& scene, const View& view, const MapQuery& query,
                                std::span<const scene::Bounds> receivers,
                                FitRequest::Cover cover = FitRequest::Cover::needed) const;
    /// The same for the receivers in view.
    [[nodiscard]] LightMaps fitToView(const scene::Scene& scene, const View& view, const MapQuery& query) const {
        return fit(scene, view, query, receiversInView(scene, view));
    }
    [[nodiscard]] std::vector<scene::Bounds> receiversInView(const scene::Scene& scene, const View& view) const;
    /// The casters that are drawn into one layer.
    [[nodiscard]] std::vector<std::size_t> castersOf(const scene::Scene& scene, const LightMaps& maps,
                                                     const MapQuery& query, int layer) const;
    /// Boxes around all objects, in the world.
    [[nodiscard]] std::span<const scene::Bounds> bounds() const { return bounds_; }
    [[nodiscard]] const std::vector<std::size_t>& usefulCasters(int light) const {
        return usefulCasters_[static_cast<std::size_t>(light)];
    }
    /// How each object is drawn with these maps; found once for the fitted maps of a light.
    const std::vector<ReceiverLookup>& lookups(const Frame& frame, int light, const LightMaps& maps);

private:
    /// All that the fit of a frame's maps depends on.
    struct FitCacheKey {
        scene::Snapshot snapshot;
        scene::Camera camera;
        ivec2 size{0};
        ShadowMapParams params;
        std::optional<dvec2> visibleDepth;
        std::vector<bool> mayLight; ///< by light
        friend bool operator==(const FitCacheKey&, const FitCacheKey&) = default;
    };
    /// Depths of the picture that was drawn last: cascades may be fitted to them.
    struct SeenDepth {
        scene::Camera camera;
        ivec2 size{0};
        dvec2 range{0.0}; ///< metres along the eye's axis
    };

    const ShadowMapParams& params_;
    scene::Snapshot preparedFor_;
    std::vector<scene::Bounds> bounds_;
    std::vector<std::vector<std::size_t>> usefulCasters_; ///< by light
    std::optional<SeenDepth> seen_;
    std::vector<LightMaps> fitted_;
    FitCacheKey fittedFor_;
    std::map<int, std::vector<ReceiverLookup>> lookups_; ///< by light, of the fitted maps
    std::vector<ReceiverLookup> otherLookups_;           ///< of the last maps that were not the fitted ones
};

} // namespace shadowlab::shadow_map
