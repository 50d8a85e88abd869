// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/gltf/gltf_textures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/picture_file.h"
#include "techniques/foundation/scene/gltf/gltf_uris.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

GltfTextures::GltfTextures(const std::filesystem::path& file, GltfSource& source, const tinygltf::Model& model,
                           const GltfBuffers& buffers, GltfFiles& files, const LoadOptions& options)
    : file_(file), source_(source), model_(model), buffers_(buffers), files_(files), options_(options),
      paths_(source.elements("images").size()) {}

std::optional<GltfTexture> GltfTextures::find(int texture, int texcoordSet, const tinygltf::ExtensionMap& extensions) {
    if (texture < 0) return std::nullopt;
    const int image = model_.textures[static_cast<std::size_t>(texture)].source;
    if (image < 0) { // the format of the image that an extension names was noted
        source_.note("textures", static_cast<std::size_t>(texture), "names no PNG or JPEG image; it is left out");
        return std::nullopt;
    }
    const auto index = static_cast<std::size_t>(image);
    if (!paths_[index]) paths_[index] = imagePath(index);
    if (!*paths_[index]) return std::nullopt;
    GltfTexture found{**paths_[index], index, placementOf(texture, extensions), texcoordSet};
    if (const auto transform = extensions.find("KHR_texture_transform"); transform != extensions.end())
        found.texcoordSet = static_cast<int>(gltfNumber(transform->second, "texCoord", texcoordSet));
    return found;
}

std::optional<std::filesystem::path> GltfTextures::imagePath(std::size_t image) {
    const JsonValue& keys = source_.elements("images")[image];
    const JsonValue *uri = gltfMember(keys, "uri"), *view = gltfMember(keys, "bufferView"), *name = gltfMember(keys, "name");
    const auto leftOut = [&](const std::string& why) {
        source_.note("images", image, "is left out: " + why);
        return std::nullopt;
    };
    std::string_view bytes;
    if (view) {
        const tinygltf::BufferView& part = model_.bufferViews[static_cast<std::size_t>(view->number)];
        bytes = buffers_.bytes(static_cast<std::size_t>(part.buffer)).substr(part.byteOffset, part.byteLength);
    } else if (uri && isDataUri(uri->string)) {
        auto decoded = bytesOfDataUri(uri->string);
        if (!decoded) return leftOut("its data: URI is not well-formed base64");
        bytes = *decoded_.emplace_back(std::make_unique<std::string>(std::move(*decoded)));
    } else if (uri) {
        GltfFiles::Found found = files_.find(source_.document(), *uri);
        if (!found.canonical) return leftOut(inQuotes(uri->string) + " " + found.fault);
        return found.canonical;
    } else
        return leftOut("it has neither a uri nor a bufferView");
    if (const std::string_view format = image::otherFormat(bytes); !format.empty())
        return leftOut("it is a " + std::string(format) + " image; only PNG and JPEG are read");
    // No file can have this name: the glTF file stands where a folder would have to be.
    std::string own = name && !name->string.empty() ? name->string : "image " + std::to_string(image);
    std::ranges::replace(own, '/', '_');
    std::filesystem::path path(file_.native() + "/" + own);
    if (images_.holds(path)) path += " (" + std::to_string(image) + ")";
    images_.hold(path, bytes);
    return path;
}

ImagePlacement GltfTextures::placementOf(int texture, const tinygltf::ExtensionMap& extensions) {
    const auto index = static_cast<std::size_t>(texture);
    ImagePlacement placement;
    if (const int sampler = model_.textures[index].sampler; sampler >= 0) {
        const auto at = static_cast<std::size_t>(sampler);
        const tinygltf::Sampler& how = model_.samplers[at];
        const auto isClamped = [](int wrap) { return wrap == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE; };
        placement.clamped = isClamped(how.wrapS) && isClamped(how.wrapT);
        if (isClamped(how.wrapS) != isClamped(how.wrapT))
            source_.note("samplers", at, "clamps an image along one axis alone; it is repeated along both");
        if (how.wrapS == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT || how.wrapT == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT)
            source_.note("samplers", at, "mirrors an image at each repetition; it is repeated without that");
        if (how.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST)
            source_.note("samplers", at, "asks for the nearest texel of an image (magFilter 9728); its colours are interpolated");
    }
    dvec2 scale(1.0), offset(0.0);
    if (const auto transform = extensions.find("KHR_texture_transform"); transform != extensions.end()) {
        const auto pairOf = [&](const char* key, dvec2& pair) {
            if (!transform->second.Has(key)) return;
            for (std::size_t i = 0; i < 2; ++i)
                pair[static_cast<int>(i)] = transform->second.Get(key).Get(static_cast<int>(i)).GetNumberAsDouble();
        };
        pairOf("scale", scale), pairOf("offset", offset);
        if (gltfNumber(transform->second, "rotation", 0) != 0)
            source_.note("textures", index, "is turned by KHR_texture_transform; it is scaled and moved, but not turned");
    }
    // Texture coordinates of glTF count from the upper edge of the image. Those of the mesh were turned over when it was read: what is
    // left is offset + scale (1 - v), counted from the lower edge.
    placement.scale = scale;
    placement.offset = {offset.x, 1.0 - offset.y - scale.y};
    if (!placement.clamped) placement.offset.y -= std::floor(placement.offset.y); // whole repetitions are the same
    return placement;
}

template <typename Make>
auto GltfTextures::readOrNote(const GltfTexture& texture, const Make& make) -> decltype(make()) {
    try {
        return make();
    } catch (const Error& error) {
        source_.note("images", texture.imageIndex, "is left out: it is " + std::string(error.what()));
        return nullptr;
    }
}

std::shared_ptr<const ColorImage> GltfTextures::colors(const GltfTexture& texture) {
    return readOrNote(texture, [&] { return images_.colors(texture.image, {}, options_.limits); });
}

std::shared_ptr<const AlphaMask> GltfTextures::mask(const GltfTexture& texture, double gain) {
    const MaskChoice choice{MaskChoice::Channel::alpha, 0.0, gain};
    return readOrNote(texture, [&] { return images_.mask(texture.image, choice, options_.limits); });
}

std::optional<vec3> GltfTextures::mean(const GltfTexture& texture, bool isColor) {
    const auto [entry, isNew] = means_.try_emplace({texture.imageIndex, isColor});
    if (isNew) entry->second = computedMean(texture, isColor);
    return entry->second;
}

std::optional<vec3> GltfTextures::computedMean(const GltfTexture& texture, bool isColor) {
    const std::shared_ptr<const ColorImage> image = colors(texture);
    if (!image) return std::nullopt;
    std::array<double, 256> values{};
    for (std::size_t byte = 0; byte < values.size(); ++byte)
        values[byte] = isColor ? image::linearFromSrgb(static_cast<std::uint8_t>(byte)) : static_cast<double>(byte) / 255.0;
    const std::vector<std::uint8_t>& texels = image->texels();
    dvec3 sum(0.0);
    for (std::size_t i = 0; i < texels.size(); i += 4)
        sum += dvec3(values[texels[i]], values[texels[i + 1]], values[texels[i + 2]]);
    return vec3(sum * (4.0 / static_cast<double>(texels.size())));
}

} // namespace shadowlab::scene
