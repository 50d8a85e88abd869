// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/holes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

namespace {

/// Does the chosen number of this texel, of 0 to 1, make it solid?
bool isSolid(const image::Color8& texel, bool hasAlpha, const MaskChoice& choice) {
    using enum MaskChoice::Channel;
    const auto numberOf = [&](MaskChoice::Channel channel) {
        switch (channel) {
        case red: return 10000 * texel.r;
        case green: return 10000 * texel.g;
        case blue: return 10000 * texel.b;
        case alpha: return 10000 * texel.a;
        default: return 2126 * texel.r + 7152 * texel.g + 722 * texel.b;
        }
    };
    const int number = numberOf(choice.channel != alphaOrBrightness ? choice.channel : hasAlpha ? alpha : brightness);
    constexpr int kOne = 255 * 10000; // whole numbers as long as nothing is scaled: exactly one half is solid
    if (choice.base == 0 && choice.gain == 1) return 2 * number >= kOne;
    return choice.base + choice.gain * number / kOne >= 0.5;
}

/// 0 .. count - 1: in which of `count` equal pieces of the image the coordinate lies.
int pieceOf(double coordinate, int count, bool clamped) {
    const double within = clamped ? std::clamp(coordinate, 0.0, 1.0) : coordinate - std::floor(coordinate);
    // Just below a whole number the difference rounds up to 1; that is the last piece, not the first.
    return std::min(static_cast<int>(within * count), count - 1);
}

} // namespace

AlphaMask::AlphaMask(const image::PictureFile& picture, const MaskChoice& choice)
    : size_(picture.image.width, picture.image.height) {
    texels_.reserve(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y));
    for (int y = size_.y; y-- > 0;)
        for (int x = 0; x < size_.x; ++x)
            texels_.push_back(isSolid(picture.image.at(x, y), picture.hasAlpha, choice) ? 255 : 0);
}

bool AlphaMask::isHole(const dvec2& place, bool clamped) const {
    const int column = pieceOf(place.x, size_.x, clamped), row = pieceOf(place.y, size_.y, clamped);
    return texels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_.x) +
                   static_cast<std::size_t>(column)] == 0;
}

const AlphaMask* maskOfPart(const Scene& scene, const Object& object, std::size_t part) {
    return object.mesh->parts[part].hasTexcoords ? scene.materials[object.partMaterials[part]].alphaMask.get()
                                                 : nullptr;
}

bool hasHoles(const Scene& scene, const Object& object) {
    for (std::size_t part = 0; part < object.mesh->parts.size(); ++part)
        if (maskOfPart(scene, object, part)) return true;
    return false;
}

bool isInHole(const Scene& scene, const Object& object, std::uint32_t triangle, const dvec3& barycentric) {
    const Mesh& mesh = *object.mesh;
    const std::size_t part = partOf(mesh, triangle);
    const AlphaMask* mask = maskOfPart(scene, object, part);
    if (!mask) return false;
    const uvec3& corners = mesh.triangles[triangle];
    dvec2 texcoord(0.0);
    for (int corner = 0; corner < 3; ++corner)
        texcoord += barycentric[corner] * dvec2(mesh.texcoords[corners[corner]]);
    const ImagePlacement& placement = scene.materials[object.partMaterials[part]].alphaPlacement;
    return mask->isHole(placement.at(texcoord), placement.clamped);
}

std::string noteOnWholePart(const Material& material, const MeshPart& part) {
    if (!material.alphaMask || part.hasTexcoords) return "";
    return "material '" + shown(material.name) + "': no holes are cut in " + counted(part.triangleCount, "triangle") +
           " without texture coordinates (vt)";
}

} // namespace shadowlab::scene
