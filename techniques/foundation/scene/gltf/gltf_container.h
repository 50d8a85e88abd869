// The container of a glTF file: JSON text alone (.gltf), or JSON and binary data in chunks (.glb).
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace shadowlab::scene {

struct GltfContainer {
    std::string json;
    bool hasBinary = false; ///< has the file a binary chunk, as only a .glb can?
    [[nodiscard]] std::string_view binary() const { return std::string_view(bytes).substr(binaryAt, binarySize); }

    std::string bytes; ///< of a .glb
    std::size_t binaryAt = 0, binarySize = 0;
};

/// Which of the two it is, the first four bytes say, and not the file's name. Throws Error (badInput) for a header or a chunk
/// that the bytes do not hold.
GltfContainer gltfContainer(std::string bytes, const std::filesystem::path& file);

} // namespace shadowlab::scene
