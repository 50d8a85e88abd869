// The colour of a surface where it is not the same all over: the material's, times that of an image laid on it, times that of its
// vertices, interpolated between them.
//
// This is the one definition for rays and for the graphics card (shaders/material.glsl uses the same formula). Simplified: of the image,
// the four texels about the point are interpolated, whatever part of it a pixel covers; there are no smaller copies of it for what is
// far away. More samples for a pixel (--supersample) smooth it there.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/foundation/image/image.h"
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// Option -mm of MTL files: each number of the image becomes base + gain times it.
struct ImageGain {
    double base = 0.0, gain = 1.0;
    friend auto operator<=>(const ImageGain&, const ImageGain&) = default;
};

class ColorImage {
public:
    /// Colours as they stand in a file, sRGB-encoded; alpha changes nothing, but see isPartlyTransparent().
    explicit ColorImage(const image::Image& image, const ImageGain& gain = {});

    /// Linear RGB, interpolated between the centres of texels. `place`: see ImagePlacement.
    [[nodiscard]] vec3 at(const dvec2& place, bool clamped) const;
    [[nodiscard]] ivec2 size() const { return size_; }
    /// Has the file texels with an alpha below 255? Here they are as opaque as the others.
    [[nodiscard]] bool isPartlyTransparent() const { return isPartlyTransparent_; }
    /// Four bytes per texel, r, g, b and 255, sRGB-encoded, rows from the bottom: as OpenGL counts them.
    [[nodiscard]] const std::vector<std::uint8_t>& texels() const { return texels_; }

private:
    [[nodiscard]] vec3 texel(ivec2 place, bool clamped) const;
    ivec2 size_;
    bool isPartlyTransparent_ = false;
    std::vector<std::uint8_t> texels_;
};

/// The image that colours a part of the object's mesh; nullptr: none.
const ColorImage* colorImageOfPart(const Scene& scene, const Object& object, std::size_t part);

/// True if the part takes the colours of its vertices. A material of the scene's own list replaces them, as it replaces images.
bool usesVertexColors(const Scene& scene, const Object& object, std::size_t part);

/// True if a part of the object has not the same colour all over.
bool hasOwnColors(const Scene& scene, const Object& object);
/// True if that is so of any object.
bool hasOwnColors(const Scene& scene);

/// The diffuse reflectance at a point of a triangle of the object, given by the weights of the corners.
vec3 diffuseAt(const Scene& scene, const Object& object, std::uint32_t triangle, const dvec3& barycentric);

} // namespace shadowlab::scene
