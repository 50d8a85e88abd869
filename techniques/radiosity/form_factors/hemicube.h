// Form factors by drawing: from the centre of a patch, the numbers of all other patches on the five faces of half a cube.
//
// M. Cohen and D. Greenberg, "The Hemi-Cube: A Radiosity Solution for Complex Environments", SIGGRAPH 1985. The depth buffer
// decides what is visible; the form factor to a patch is the sum of the delta form factors of its pixels (hemicube_pixels.h).
//
// Simplifications, compared with the exact exchange areas of visible_exchange.h:
//   - The centre of a patch stands for all of it. Between two equal squares that share an edge this is wrong by 5 %, between other
//     touching patches by more; neither more pixels nor smaller patches help.
//   - A pixel is covered or not: a patch errs by about the pixels along its outline, and one smaller than a pixel may be missed.
//   - Nothing nearer than kNearestShare of the distance to the patch's nearest edge is seen: things that float lower than that over its
//     centre are cut open. What touches the patch along its edges, or stands beyond them, is seen whole.
//   - The depth buffer has 24 bits: at distance d it separates things that are d^2 / (2^24 n) apart, n being the near plane; the back
//     of a patch has to be nearer by 64 times that to hide another.
//   - Where neighbouring patches do not share their corners (T-vertices), a pixel on the seam may show nothing: one in some 400,000.
//   - Every patch blocks light, also those of objects that cast no shadow, and nothing but patches does.
// Patches seen from behind block light and receive none.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/gl/framebuffer.h"
#include "techniques/foundation/gl/program.h"
#include "techniques/radiosity/form_factors/hemicube_pixels.h"
#include "techniques/radiosity/patches/patches.h"

namespace shadowlab::radiosity {

/// A GL context must be current in the constructor and in all member functions.
class Hemicube {
public:
    /// The near plane lies at this share of the distance from a patch's centre to its nearest edge. The near planes of the five
    /// faces together cut off what is nearer than sqrt(3) times that, all of which lies above the patch itself.
    static constexpr double kNearestShare = 0.25;

    /// `side`: pixels along an edge of the upper face, even, at least 2. Throws Error (overLimit) where 3 * side exceeds the
    /// driver's largest texture.
    explicit Hemicube(int side);

    /// The patches to draw, numbered by their place in the list. They must live as long as they are drawn.
    void setPatches(std::span<const Patch> patches);

    /// F_ij for all patches j, from the centre of patch i. In a closed room they sum to 1, for every pixel shows a patch.
    [[nodiscard]] std::vector<double> formFactors(const Patch& from) const;
    /// The same from a point with that unit normal. Nothing nearer than `nearest` metres is seen.
    [[nodiscard]] std::vector<double> formFactors(const dvec3& positionCentred, const dvec3& normal,
                                                  double nearest) const;
    [[nodiscard]] int side() const { return side_; }

private:
    void draw(const dvec3& positionCentred, const dvec3& normal, double nearest) const;

    int side_;
    std::vector<double> deltas_; ///< of the picture's pixels
    gl::Program program_{"radiosity/hemicube.vert", "radiosity/hemicube.frag"};
    gl::Texture2D numbers_, depth_;
    gl::Framebuffer framebuffer_;
    gl::BufferHandle corners_, indices_;
    gl::VertexArrayHandle vertexArray_;
    std::span<const Patch> patches_;
    std::vector<std::uint32_t> firstCorner_; ///< of each patch
};

} // namespace shadowlab::radiosity
