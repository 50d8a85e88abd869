// Display of a solution: pictures of the values of patches, the stages, and the notes of a frame.
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

/// The irradiance of all surfaces, on the graphics card.
struct ShownLight {
    SurfacePicture::Values values;
    std::optional<SurfacePicture::Lattices> map;
};

/// A frame, and the results to be shown in it.
struct Showing {
    Frame& frame;
    const RoomCache& cache;
    const Sources& sources;
    const LightBalance& balance;
    const SurfacePicture& picture;
    const RadiosityParams& params;

    /// Draws radiosities of all patches into the bound framebuffer.
    void draw(std::span<const dvec3> radiosity, bool interpolates) const;
    /// Draws the irradiance, reflected by every pixel's own material.
    void drawSmooth(const ShownLight& shown) const;
    /// The irradiance for the finished picture. `map`: the direct light, or nullptr: it is interpolated like the rest.
    [[nodiscard]] ShownLight shown(const LightMap* map) const;
};

/// Publishes the stages that the frame asks for. `map`: the light map that direct light is shown with, or nullptr.
void publishStages(const Showing& showing, const LightMap* map);

/// Publishes stage `matrix`: F_jk in row j and column k on a logarithmic scale, each pixel the mean of the entries that it
/// covers; on its right a bar for each row, as long as the row's sum.
void publishMatrix(Frame& frame, const PreparedExchange& exchange);

/// Publishes counters and notes: the number of patches, the quality of the form factors and what scaling changed, the progress of
/// the solver, where the power goes, and which properties of materials are left out.
void publishNotes(const Showing& showing);

} // namespace shadowlab::radiosity
