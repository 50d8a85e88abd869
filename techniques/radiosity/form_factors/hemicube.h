// Form factors by drawing: from the centre of a patch, all others with their numbers on the five faces of half a cube.
//
// M. Cohen and D. Greenberg, "The Hemi-Cube: A Radiosity Solution for Complex Environments", SIGGRAPH 1985. The depth buffer decides
// what is seen; the form factor to a patch is the sum of the delta form factors of its pixels (hemicube_pixels.h).
//
// What it simplifies, beside the exact exchange areas of visible_exchange.h:
//   - A patch's centre stands for all of it. Between two equal squares that share an edge that is wrong by 5 in a hundred, between others
//     that touch by more; neither more pixels nor smaller patches mend it.
//   - A pixel is seen or not: a patch errs by about the pixels along its outline, and one smaller than a pixel may be missed.
//   - Nearer than kNearestShare of the patch's own reach nothing is seen: things that float that low over its centre are cut
//     open. What touches the patch along its edges, or stands beyond them, is seen whole.
//   - The depth buffer has 24 bits: at distance d, things are told apart that are d^2 / (2^24 n) apart, n being the near plane;
//     what is seen from behind has to be 64 times that nearer to be in the way.
//   - Where patches meet that do not share their corners, a pixel on the seam may show nothing (T-vertices): one in some 400,000.
//   - Every patch blocks light, those of objects that cast no shadow, too; and nothing else does.
// Patches seen from behind block and receive nothing.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/gl/framebuffer.h"
#include "techniques/foundation/gl/program.h"
#include "techniques/radiosity/form_factors/hemicube_pixels.h"
#include "techniques/radiosity/patches/patches.h"

namespace shadowlab::radiosity {

/// A context of GL must be current in the constructor and in all that is called.
class Hemicube {
public:
    /// The near plane is at this share of the distance from a patch's centre to its nearest edge. The near planes of the five faces
    /// cut off what is nearer than sqrt(3) times that: all of it is over the patch itself.
    static constexpr double kNearestShare = 0.25;

    /// `side`: pixels along an edge of the upper face, even, at least 2. Throws Error (overLimit) when 3 of them are more than
    /// the driver's largest texture.
    explicit Hemicube(int side);

    /// What is seen from now on, and receives, by its place in the list. Must live as long.
    void setPatches(std::span<const Patch> patches);

    /// F_ij for all patches j, from the centre of patch i. In a closed room they sum to 1, for every pixel shows something.
    [[nodiscard]] std::vector<double> formFactors(const Patch& from) const;
    /// The same for a piece of surface at that position, of that unit normal. Nothing nearer than `nearest` metres is seen.
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
