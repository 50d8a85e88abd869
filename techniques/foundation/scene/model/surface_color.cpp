// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/surface_color.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shadowlab::scene {

namespace {

/// Linear light of each of the 256 numbers that a file can hold.
const std::array<float, 256>& linearOfBytes() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t byte = 0; byte < values.size(); ++byte)
            values[byte] = image::linearFromSrgb(static_cast<std::uint8_t>(byte));
        return values;
    }();
    return table;
}

std::uint8_t withGain(std::uint8_t byte, const ImageGain& gain) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(255.0 * gain.base + gain.gain * byte, 0.0, 255.0)));
}

int wrapped(int texel, int count, bool clamped) {
    if (clamped) return std::clamp(texel, 0, count - 1);
    const int within = texel % count;
    return within < 0 ? within + count : within;
}

} // namespace

ColorImage::ColorImage(const image::Image& image, const ImageGain& gain) : size_(image.width, image.height) {
    texels_.reserve(image.rgba.size());
    for (int y = size_.y; y-- > 0;)
        for (int x = 0; x < size_.x; ++x) {
            const image::Color8 texel = image.at(x, y);
            for (const std::uint8_t byte : {texel.r, texel.g, texel.b})
                texels_.push_back(withGain(byte, gain));
            texels_.push_back(255);
            isPartlyTransparent_ = isPartlyTransparent_ || texel.a < 255;
        }
}

vec3 ColorImage::texel(ivec2 place, bool clamped) const {
    const auto column = static_cast<std::size_t>(wrapped(place.x, size_.x, clamped));
    const auto row = static_cast<std::size_t>(wrapped(place.y, size_.y, clamped));
    const std::uint8_t* bytes = &texels_[4 * (row * static_cast<std::size_t>(size_.x) + column)];
    const std::array<float, 256>& linear = linearOfBytes();
    return {linear[bytes[0]], linear[bytes[1]], linear[bytes[2]]};
}

vec3 ColorImage::at(const dvec2& place, bool clamped) const {
    // Whole repetitions are taken off first, so that far from zero nothing overflows an int.
    const dvec2 within = clamped ? glm::clamp(place, 0.0, 1.0) : place - glm::floor(place);
    const dvec2 inTexels = within * dvec2(size_) - 0.5; // centres of texels are at whole numbers
    const ivec2 lower(glm::floor(inTexels));
    const vec2 share(inTexels - dvec2(lower));
    const vec3 below = glm::mix(texel(lower, clamped), texel(lower + ivec2(1, 0), clamped), share.x);
    const vec3 above = glm::mix(texel(lower + ivec2(0, 1), clamped), texel(lower + ivec2(1, 1), clamped), share.x);
    return glm::mix(below, above, share.y);
}

const ColorImage* colorImageOfPart(const Scene& scene, const Object& object, std::size_t part) {
    return object.mesh->parts[part].hasTexcoords ? scene.materials[object.partMaterials[part]].colorImage.get() : nullptr;
}

bool usesVertexColors(const Scene& scene, const Object& object, std::size_t part) {
    return !object.mesh->colors.empty() && scene.materials[object.partMaterials[part]].ofMesh;
}

bool hasOwnColors(const Scene& scene, const Object& object) {
    for (std::size_t part = 0; part < object.mesh->parts.size(); ++part)
        if (colorImageOfPart(scene, object, part) || usesVertexColors(scene, object, part)) return true;
    return false;
}

bool hasOwnColors(const Scene& scene) {
    return std::ranges::any_of(scene.objects, [&](const Object& object) { return hasOwnColors(scene, object); });
}

vec3 diffuseAt(const Scene& scene, const Object& object, std::uint32_t triangle, const dvec3& barycentric) {
    const Mesh& mesh = *object.mesh;
    const std::size_t part = partOf(mesh, triangle);
    const Material& material = scene.materials[object.partMaterials[part]];
    const uvec3& corners = mesh.triangles[triangle];
    vec3 diffuse = material.diffuse;
    if (usesVertexColors(scene, object, part)) {
        dvec3 color(0.0);
        for (int corner = 0; corner < 3; ++corner)
            color += barycentric[corner] * dvec3(mesh.colors[corners[corner]]);
        diffuse *= vec3(color);
    }
    if (const ColorImage* image = colorImageOfPart(scene, object, part)) {
        dvec2 texcoord(0.0);
        for (int corner = 0; corner < 3; ++corner)
            texcoord += barycentric[corner] * dvec2(mesh.texcoords[corners[corner]]);
        diffuse *= image->at(material.colorPlacement.at(texcoord), material.colorPlacement.clamped);
    }
    return diffuse;
}

} // namespace shadowlab::scene
