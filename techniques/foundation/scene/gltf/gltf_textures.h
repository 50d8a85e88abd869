// The images of a glTF file, and how its textures lay them on surfaces.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "techniques/foundation/scene/gltf/gltf_model.h"
#include "techniques/foundation/scene/load/image_files.h"

namespace shadowlab::scene {

/// A use of a texture, `"baseColorTexture": {...}`, as far as a surface can show it.
struct GltfTexture {
    std::filesystem::path image; ///< its file, or a name that stands for bytes within this file
    std::size_t imageIndex = 0;
    ImagePlacement placement;
    int texcoordSet = 0;
};

class GltfTextures {
public:
    GltfTextures(const std::filesystem::path& file, GltfSource& source, const tinygltf::Model& model, const GltfBuffers& buffers,
                 GltfFiles& files, const LoadOptions& options);

    /// The texture that a material uses there; nothing where it uses none, or none that can be shown, which is noted.
    std::optional<GltfTexture> find(int texture, int texcoordSet, const tinygltf::ExtensionMap& extensions);

    /// The image as colours, and as a mask that is solid where alpha times `gain` is at least one half. Null where it cannot be read,
    /// which is noted.
    std::shared_ptr<const ColorImage> colors(const GltfTexture& texture);
    std::shared_ptr<const AlphaMask> mask(const GltfTexture& texture, double gain);

    /// Mean of the image's colours, linear; of its numbers as they are where not `isColor`.
    std::optional<vec3> mean(const GltfTexture& texture, bool isColor);

private:
    template <typename Make>
    auto readOrNote(const GltfTexture& texture, const Make& make) -> decltype(make());
    std::optional<vec3> computedMean(const GltfTexture& texture, bool isColor);
    std::optional<std::filesystem::path> imagePath(std::size_t image);
    [[nodiscard]] ImagePlacement placementOf(int texture, const tinygltf::ExtensionMap& extensions);

    const std::filesystem::path& file_;
    GltfSource& source_;
    const tinygltf::Model& model_;
    const GltfBuffers& buffers_;
    GltfFiles& files_;
    const LoadOptions& options_;
    ImageFiles images_;
    std::vector<std::optional<std::optional<std::filesystem::path>>> paths_; ///< of images that were asked for
    std::map<std::pair<std::size_t, bool>, std::optional<vec3>> means_;      ///< many materials may use one image
    std::vector<std::unique_ptr<std::string>> decoded_;                      ///< from data: URIs
};

} // namespace shadowlab::scene
