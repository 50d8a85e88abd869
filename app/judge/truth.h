// The truth of a picture: for each pixel, what the light's visibility is by definition, and whether it is a tie.
//
// An eye ray and a shadow ray through the pixel's centre, on the triangles that the techniques draw; independent
// of any rasteriser. Definitions: docs/conventions.md. The rasterised picture is used for one thing only: where it shows another
// triangle than the eye ray found, and the visibility there differs, neither is wrong, and the pixel is a tie.
//
// For techniques that sample the area of a light (Technique::samplesArea) the truth is the share of it that is seen.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <stop_token>
#include <vector>

#include "techniques/foundation/scene/model/camera.h"
#include "techniques/foundation/trace/scene_tracer.h"

namespace shadowlab::judge {

/// What of a light the truth is about.
enum class TruthOf {
    centre, ///< does the point see the light's centre? For techniques that model a point light
    area,   ///< how much of the light's area does it see? For those that sample it
};

/// How the rasteriser sees the picture.
struct Rasterised {
    double tieRadiusPx = 1.0 / 64.0;       ///< see tieRadius()
    std::vector<std::uint32_t> primitives; ///< drawn per pixel (gl::IdBuffer), rows from the top; empty: not used
};

/// Nearer than this to an edge, in pixels, rounding decides on which side of it a pixel's centre falls: two steps of
/// the grid that vertices are rounded to (GL_SUBPIXEL_BITS), and no less than 1/64.
double tieRadius(int subpixelBits);

/// One entry per pixel, rows from the top.
struct Truth {
    ivec2 size{0};
    std::vector<trace::Visibility> visibility;
    std::vector<std::uint32_t> objects; ///< index of the object that is seen; ~0u: none
    std::vector<std::uint8_t> ties;     ///< 1: the truth changes within the tie radius
    /// Of a truth about the area: which share of it is seen; `visibility` then is lit where that is more than one half. Empty:
    /// the truth is about the centre.
    std::vector<float> shares;

    /// What visibility should be, 0 to 1.
    [[nodiscard]] double share(std::size_t pixel) const {
        if (!shares.empty()) return static_cast<double>(shares[pixel]);
        return visibility[pixel] == trace::Visibility::lit ? 1.0 : 0.0;
    }
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
    }
};

/// What the pixel centres see, without ties: enough to tell what changes from frame to frame. Both this and exactTruth()
/// throw trace::Stopped soon after `stop` was requested, some tens of microseconds of work later; of an area, some
/// milliseconds.
Truth truthAtCentres(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size, int light,
                     const std::stop_token& stop = {}, TruthOf of = TruthOf::centre);

/// Which of these pixels are ties; for a few pixels, where the others are not needed.
std::vector<std::uint8_t> tiesAmong(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size,
                                    int light, double tieRadiusPx, const std::vector<ivec2>& pixels,
                                    TruthOf of = TruthOf::centre);

/// With ties: sixteen points around each centre are traced as well.
Truth exactTruth(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size, int light,
                 const Rasterised& rasterised, const std::stop_token& stop = {}, TruthOf of = TruthOf::centre);

} // namespace shadowlab::judge
