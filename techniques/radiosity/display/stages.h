// Display of a solution: pictures of the values of patches, the stages, and the notes of a frame.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>

#include "techniques/frame.h"
#include "techniques/radiosity/display/light_map.h"
#include "techniques/radiosity/display/pixel_picture.h"
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

/// What direct light is shown with, while it is known: pixels, a light map, or (neither) the patches alone.
struct DirectShown {
    const PixelPicture* pixels = nullptr;
    const LightMap* map = nullptr;
    bool isPreview = false; ///< of lights with an area the centres alone, or at first blocks of pixels
    bool isFirst = false;   ///< those blocks, and just found: to be shown before anything else is asked
};

/// A frame, and the results to be shown in it.
struct Showing {
    Frame& frame;
    const RoomCache& cache;
    const Sources& sources;
    const LightBalance& balance;
    const SurfacePicture& picture;
    const RadiosityParams& params;
    std::optional<double> patchError; ///< what having one value each costs those that face the eye, as a share of the light; nothing: not solved yet
    double caughtByLamps = 0;         ///< the share of what surfaces send that meets lamps if nothing else is in its way (lights/lamp_cover.h)

    /// Draws radiosities of all patches into the bound framebuffer.
    void draw(std::span<const dvec3> radiosity, bool interpolates) const;
    /// Draws the irradiance, reflected by every pixel's own material.
    void drawSmooth(const ShownLight& shown) const;
    /// The irradiance to be interpolated: without direct light where pixels have it, and with that of a light map beside it.
    [[nodiscard]] ShownLight shown(const DirectShown& direct) const;
};

/// Publishes the stages that the frame asks for.
void publishStages(const Showing& showing, const DirectShown& direct);

/// Publishes stage `matrix`: F_jk in row j and column k on a logarithmic scale, each pixel the mean of the entries that it
/// covers; on its right a bar for each row, as long as the row's sum.
void publishMatrix(Frame& frame, const PreparedExchange& exchange);

/// Publishes counters and notes: the number of patches, the quality of the form factors and what scaling changed, the progress of
/// the solver, where the power goes, and which properties of materials are left out.
void publishNotes(const Showing& showing);

} // namespace shadowlab::radiosity
