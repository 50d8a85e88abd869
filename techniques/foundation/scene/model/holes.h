// Holes in surfaces: an image that cuts them (lace, leaves, wire mesh painted on a few triangles instead of modelled), and the parts
// of a scene's objects that have such an image.
//
// This is the one definition of where a hole is, to the texel, for rays and for the graphics card (shaders/cut_holes.glsl uses the
// same formula): the nearest texel of the image, which repeats without end and has its lowest row at v = 0; a hole where alpha is
// less than one half. Nothing is interpolated: a point is in the hole or on the surface.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "techniques/foundation/image/picture_file.h"
#include "techniques/foundation/math/types.h"
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// Which number of a texel says whether it is solid: options -imfchan and -mm of MTL files.
struct MaskChoice {
    enum class Channel { alphaOrBrightness, red, green, blue, alpha, brightness } channel = Channel::alphaOrBrightness;
    double base = 0.0, gain = 1.0; ///< the number becomes base + gain times it, of 0 to 1
    friend auto operator<=>(const MaskChoice&, const MaskChoice&) = default;
};

class AlphaMask {
public:
    /// Where nothing else is chosen: the image's alpha if it has any, else its brightness (0.2126 R + 0.7152 G + 0.0722 B of the
    /// stored numbers).
    explicit AlphaMask(const image::PictureFile& picture, const MaskChoice& choice = {});

    /// `place`: see ImagePlacement.
    [[nodiscard]] bool isHole(const dvec2& place, bool clamped) const;
    [[nodiscard]] ivec2 size() const { return size_; }
    /// One byte per texel, 255 solid and 0 hole, rows from the bottom: as OpenGL counts them.
    [[nodiscard]] const std::vector<std::uint8_t>& texels() const { return texels_; }

private:
    ivec2 size_;
    std::vector<std::uint8_t> texels_;
};

/// The mask that cuts holes into a part of the object's mesh; nullptr: the part is whole.
const AlphaMask* maskOfPart(const Scene& scene, const Object& object, std::size_t part);

/// True if any part of the object has holes.
bool hasHoles(const Scene& scene, const Object& object);

/// True if a point of a triangle of the object, given by the weights of the corners, lies in a hole.
bool isInHole(const Scene& scene, const Object& object, std::uint32_t triangle, const dvec3& barycentric);

/// The note for a part of a mesh that gets no holes although its material has a mask; empty: none needed.
std::string noteOnWholePart(const Material& material, const MeshPart& part);

} // namespace shadowlab::scene
