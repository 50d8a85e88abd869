// The true coverage of shadows: the share of each pixel's surface that a light reaches, from several points of the pixel.
//
// The truth at a pixel's centre (truth.h) is 0 or 1 where the light is a point. A picture without steps needs the share of the
// pixel: irregular z-buffers ask 32 points of each (C. Wyman, R. Hoetzlein and A. Lefohn, "Frustum-Traced Irregular Z-Buffers: Fast,
// Sub-Pixel Accurate Hard Shadows", IEEE TVCG 22, 2016). Here each point is an eye ray and an exact shadow ray, as the truth is.
// Definitions: docs/conventions.md.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <stop_token>
#include <vector>

#include "app/judge/truth.h"

namespace shadowlab::judge {

constexpr int kMostSubpixelPoints = 256;

/// So many points of a pixel, counted from its upper left corner, all within (0, 1): point i lies at ((i + 1/2) / N, (r + 1/2) / N), r
/// being the rank of i's radical inverse of base 2 among all of them. For powers of two these are Hammersley's points, moved to
/// the middles of their cells. Every row and every column of N x N cells has one point, so the share of an upright or a level edge
/// is wrong by at most 1 / (2 N). One point is the centre.
std::vector<dvec2> subpixelPoints(int count);

/// What a pixel's points show.
enum class PixelKind : std::uint8_t {
    none,    ///< no point shows a surface turned toward the light
    whole,   ///< one object, all points alike: all lit, or all in shadow
    edge,    ///< one object turned toward the light, some points lit and some in shadow
    outline, ///< more than that: several objects, or background, or a surface turned away
};

/// One entry per pixel, rows from the top.
struct Coverage {
    ivec2 size{0};
    int points = 0;
    /// 0..1: the mean of visibility over those points that show a surface turned toward the light. 0 where none does.
    std::vector<float> shares;
    std::vector<PixelKind> kinds;
};

/// The coverage of a picture. Every point of every pixel is traced: a shadow can be thinner than the distance between the centres
/// that would tell where to look. Throws trace::Stopped soon after `stop` was requested. The same for any number of threads.
Coverage trueCoverage(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size, int light, int points,
                      TruthOf of, const std::stop_token& stop = {});

/// For each pixel's centre of a picture, 1 where it shows a surface turned toward the light, else 0.
std::vector<std::uint8_t> facingCentres(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size,
                                        int light);

} // namespace shadowlab::judge
