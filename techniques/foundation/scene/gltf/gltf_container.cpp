// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/gltf/gltf_container.h"

#include <cstdint>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

namespace {

constexpr std::size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942; // "JSON" and "BIN\0", little-endian

std::uint32_t littleEndian32(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

[[noreturn]] void refuseContainer(const std::filesystem::path& file, std::size_t at, const std::string& why) {
    throw Error(ExitStatus::badInput, shownPath(file) + ": byte " + std::to_string(at) + ": " + why + "; export the model again");
}

} // namespace

GltfContainer gltfContainer(std::string given, const std::filesystem::path& file) {
    GltfContainer container;
    if (!given.starts_with("glTF")) {
        container.json = std::move(given);
        return container;
    }
    container.bytes = std::move(given);
    std::string_view bytes = container.bytes;
    if (bytes.size() < kHeaderBytes) refuseContainer(file, bytes.size(), "the file ends within the header of a .glb");
    if (const std::uint32_t version = littleEndian32(bytes, 4); version != 2)
        refuseContainer(file, 4, "is a .glb of version " + std::to_string(version) + ", and only version 2 (glTF 2.0) is read");
    const std::uint32_t length = littleEndian32(bytes, 8);
    if (length > bytes.size())
        refuseContainer(file, 8,
                        "the header says " + counted(length, "byte") + ", but the file has only " + std::to_string(bytes.size()) +
                            ": it was cut off");
    bytes = bytes.substr(0, length); // what stands behind is not part of it

    bool hasJson = false;
    for (std::size_t at = kHeaderBytes; at < bytes.size();) {
        if (bytes.size() - at < kChunkHeaderBytes) {
            if (hasJson) break; // padding
            refuseContainer(file, at, "the file ends within the header of a chunk");
        }
        const std::uint32_t size = littleEndian32(bytes, at), type = littleEndian32(bytes, at + 4);
        at += kChunkHeaderBytes;
        if (size > bytes.size() - at)
            refuseContainer(file, at - kChunkHeaderBytes,
                            "a chunk is said to have " + counted(size, "byte") + ", but only " + std::to_string(bytes.size() - at) +
                                " follow");
        if (!hasJson && type != kJsonChunk) refuseContainer(file, at - 4, "the first chunk of a .glb must be the JSON one");
        if (!hasJson)
            container.json = bytes.substr(at, size), hasJson = true;
        else if (type == kBinaryChunk && !container.hasBinary)
            container.binaryAt = at, container.binarySize = size, container.hasBinary = true;
        at += size;
    }
    if (!hasJson) refuseContainer(file, bytes.size(), "the .glb holds no chunk of JSON");
    return container;
}

} // namespace shadowlab::scene
