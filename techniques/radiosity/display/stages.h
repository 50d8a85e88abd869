// Showing what radiosity has found: pictures of values of patches, the stages, and what is told in words.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>

#include "techniques/frame.h"
#include "techniques/radiosity/display/light_map.h"
#include "techniques/radiosity/display/surface_picture.h"
#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/params.h"
#include "techniques/radiosity/room_cache.h"

namespace shadowlab::radiosity {

/// What arrives everywhere, on the graphics card: irradiance.
struct ShownLight {
    SurfacePicture::Values values;
    std::optional<SurfacePicture::Lattices> map;
};

/// One frame, and all that there is to show.
struct Showing {
    Frame& frame;
    const RoomCache& cache;
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

/// Publishes stage `matrix`: F_jk in row j and column k, each pixel the mean of the numbers that it covers, on a logarithmic scale; to its
/// right a bar for each row, as long as the row's sum.
void publishMatrix(Frame& frame, const PreparedExchange& exchange);

/// Counters and notes: how many patches, how good the form factors are and what scaling changed, how far solving has come, where
/// the power goes, and what of the materials is left out.
void publishNotes(const Showing& showing);

} // namespace shadowlab::radiosity
