// Showing what radiosity has found: pictures of values of patches, the stages, and what is told in words.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>

#include "techniques/frame.h"
#include "techniques/radiosity/display/surface_picture.h"
#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/lights/light_map.h"
#include "techniques/radiosity/params.h"
#include "techniques/radiosity/room/kept_room.h"

namespace shadowlab::radiosity {

/// What arrives everywhere, on the graphics card: irradiance.
struct ShownLight {
    SurfacePicture::Values values;
    std::optional<SurfacePicture::Lattices> map;
};

/// One frame, and all that there is to show.
struct Showing {
    Frame& frame;
    const KeptRoom& kept;
    const Sources& sources;
    const LightBalance& balance;
    const SurfacePicture& picture;
    const RadiosityParams& params;

    /// Radiosities of all patches, into what is bound.
    void draw(std::span<const dvec3> radiosity, bool interpolates) const;
    /// What arrives, reflected by every pixel's own material.
    void drawSmooth(const ShownLight& shown) const;
    /// What the finished picture is drawn with: the irradiance there is; `map`: with direct light from there, or nullptr.
    [[nodiscard]] ShownLight shown(const LightMap* map) const;
};

/// What is wanted of the stages. `map`: what direct light is shown by, or nullptr.
void publishStages(const Showing& showing, const LightMap* map);

} // namespace shadowlab::radiosity
