// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/holes.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

namespace {

/// Is this texel solid? Alpha of at least one half of 255, or that much brightness; in whole numbers.
bool isSolid(const image::Color8& texel, bool hasAlpha) {
    if (hasAlpha) return 2 * texel.a >= 255;
    return 2 * (2126 * texel.r + 7152 * texel.g + 722 * texel.b) >= 255 * 10000;
}

/// 0 .. count - 1: in which of `count` equal pieces of the image the coordinate lies.
int pieceOf(double coordinate, int count) {
    const double within = coordinate - std::floor(coordinate);
    // Just below a whole number the difference rounds up to 1; that is the last piece, not the first.
    return std::min(static_cast<int>(within * count), count - 1);
}

/// Reads a PNG without a name; removes the colon after the empty name from an error message.
template <typename Read>
auto nameless(const Read& read) {
    try {
        return read();
    } catch (const Error& error) {
        constexpr std::size_t kAfterColon = 2; // ": not a readable PNG ..."
        throw Error(error.status(),
                    std::string(error.what()).substr(kAfterColon) +
                        (error.status() == ExitStatus::overLimit ? ", or set --limit image-side=VALUE" : ""));
    }
}

/// Before anything is allocated for the pixels. A file of some kilobytes may unpack to gigabytes.
void requireMemoryForMask(const image::PngSize& size, std::uint64_t fileBytes, const Limits& limits) {
    const std::uint64_t texels = std::uint64_t{size.width} * size.height;
    if (const std::uint64_t needed = memoryForAlphaMap(texels, fileBytes, limits); needed > limits.memoryBytes)
        throw Error(ExitStatus::overLimit, std::to_string(size.width) + " x " + std::to_string(size.height) +
                                               " pixels, for which " + beyondMemory(needed, limits.memoryBytes) +
                                               "; scale it down, or set --limit memory=VALUE");
}

} // namespace

AlphaMask::AlphaMask(const image::DecodedPng& png) : size_(png.image.width, png.image.height) {
    texels_.reserve(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y));
    for (int y = size_.y; y-- > 0;)
        for (int x = 0; x < size_.x; ++x)
            texels_.push_back(isSolid(png.image.at(x, y), png.hasAlpha) ? 255 : 0);
}

bool AlphaMask::isHole(dvec2 texcoord) const {
    const int column = pieceOf(texcoord.x, size_.x), row = pieceOf(texcoord.y, size_.y);
    return texels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_.x) +
                   static_cast<std::size_t>(column)] == 0;
}

std::shared_ptr<const AlphaMask> AlphaMasks::load(const std::filesystem::path& canonical, const Limits& limits) {
    if (const auto found = known_.find(canonical); found != known_.end()) return found->second;
    if (const auto found = failed_.find(canonical); found != failed_.end()) throw found->second;
    image::keepInput(canonical); // also if it cannot be read: it is still an input
    try {
        return known_[canonical] = read(canonical, limits);
    } catch (const Error& error) {
        failed_.emplace(canonical, error);
        throw;
    }
}

std::shared_ptr<const AlphaMask> AlphaMasks::read(const std::filesystem::path& canonical, const Limits& limits) {
    const std::string text = readFile(canonical, limits.imageFileBytes, "image-file");
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    const image::PngLimits pngLimits{.side = limits.imageSide, .fileBytes = limits.imageFileBytes, .withTexts = false};
    constexpr std::string_view kNoName;
    Limits soFar = limits;
    soFar.texels += texels_;
    requireMemoryForMask(nameless([&] { return image::pngSize(bytes, kNoName, pngLimits); }), bytes.size(), soFar);
    auto mask =
        std::make_shared<const AlphaMask>(nameless([&] { return image::decodePng(bytes, kNoName, pngLimits); }));
    texels_ += mask->texels().size();
    return mask;
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
    const auto after = std::ranges::upper_bound(mesh.parts, triangle, {}, &MeshPart::firstTriangle);
    const AlphaMask* mask = maskOfPart(scene, object, static_cast<std::size_t>(after - mesh.parts.begin() - 1));
    if (!mask) return false;
    const uvec3& corners = mesh.triangles[triangle];
    dvec2 texcoord(0.0);
    for (int corner = 0; corner < 3; ++corner)
        texcoord += barycentric[corner] * dvec2(mesh.texcoords[corners[corner]]);
    return mask->isHole(texcoord);
}

std::string noteOnWholePart(const Material& material, const MeshPart& part) {
    if (!material.alphaMask || part.hasTexcoords) return "";
    return "material '" + shown(material.name) + "': no holes are cut in " + counted(part.triangleCount, "triangle") +
           " without texture coordinates (vt)";
}

} // namespace shadowlab::scene
