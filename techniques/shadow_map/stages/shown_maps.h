// The maps that a stage has shown, and where a point of the scene is in that picture.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <optional>

#include "techniques/shadow_map/fit/light_maps.h"
#include "techniques/technique.h"

namespace shadowlab::shadow_map {

class ShownMaps {
public:
    void keep(int light, const LightMaps& maps, const View& view) { kept_[light] = {maps, view.camera, view.size}; }
    /// Shares of the picture's width and height from its upper left corner; nothing where the maps do not hold the point, or were
    /// shown for another view.
    [[nodiscard]] std::optional<dvec2> share(int light, const dvec3& pointWorld, const View& view) const;
    /// Adds that place of the probe's point to what the probe tells of its map.
    void addPlace(Probe& probe, std::string_view stage, int light, const View& view) const;

private:
    struct Kept {
        LightMaps maps;
        scene::Camera eye;
        ivec2 viewSize{0};
    };
    std::map<int, Kept> kept_; ///< by light
};

} // namespace shadowlab::shadow_map
