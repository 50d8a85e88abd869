// Holes in surfaces: an image that cuts them (lace, leaves, wire mesh painted on a few triangles instead of modelled), and the parts
// of a scene's objects that have such an image.
//
// This is the one definition of where a hole is, to the texel, for rays and for the graphics card (shaders/cut_holes.glsl uses the
// same formula): the nearest texel of the image, which repeats without end and has its lowest row at v = 0; a hole where alpha is
// less than one half. Nothing is interpolated: a point is in the hole or on the surface.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/math/types.h"
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::image {
struct DecodedPng;
}

namespace shadowlab::scene {

struct Limits;

class AlphaMask {
public:
    /// The image's alpha where it has any, else its brightness (0.2126 R + 0.7152 G + 0.0722 B of the stored numbers).
    explicit AlphaMask(const image::DecodedPng& png);

    [[nodiscard]] bool isHole(dvec2 texcoord) const;
    [[nodiscard]] ivec2 size() const { return size_; }
    /// One byte per texel, 255 solid and 0 hole, rows from the bottom: as OpenGL counts them.
    [[nodiscard]] const std::vector<std::uint8_t>& texels() const { return texels_; }

private:
    ivec2 size_;
    std::vector<std::uint8_t> texels_;
};

/// Reads masks, each file once.
class AlphaMasks {
public:
    /// `limits.texels` is the number of texels that other masks have used. Throws Error (badInput, overLimit): "not a
    /// readable PNG: ...; save it again", without the file's name, which the caller knows as the user wrote it.
    std::shared_ptr<const AlphaMask> load(const std::filesystem::path& canonical, const Limits& limits);

private:
    std::shared_ptr<const AlphaMask> read(const std::filesystem::path& canonical, const Limits& limits);

    std::map<std::filesystem::path, std::shared_ptr<const AlphaMask>> known_;
    std::map<std::filesystem::path, Error>
        failed_;               ///< the errors of files that are no masks; many materials may name one file
    std::uint64_t texels_ = 0; ///< of them all
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
