// glTF files for tests: numbers go into a buffer, and the JSON around them is put together key by key.
// SPDX-License-Identifier: MIT
#pragma once
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "techniques/foundation/scene/gltf/load_gltf.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::scene {

using Json = nlohmann::json;

inline std::string base64(const std::string& bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

template <typename Number>
std::string bytesOf(const std::vector<Number>& numbers) {
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

/// A file under construction. One triangle at first: (0,0,0), (1,0,0), (0,1,0), shown by one node.
struct MadeGltf {
    Json json = Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "accessors": [], "bufferViews": []})");
    std::string buffer;

    MadeGltf() { add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, 5126, "VEC3", 3); }

    /// A view of its own, on a multiple of four bytes; its index.
    int view(const std::string& bytes) {
        buffer.append((4 - buffer.size() % 4) % 4, '\0');
        json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
        buffer += bytes;
        return static_cast<int>(json["bufferViews"].size()) - 1;
    }
    /// An accessor of its own; its index.
    template <typename Number>
    int add(const std::vector<Number>& numbers, int componentType, const std::string& type, int count, bool normalized = false) {
        Json accessor{{"bufferView", view(bytesOf(numbers))}, {"componentType", componentType}, {"type", type}, {"count", count}};
        if (normalized) accessor["normalized"] = true;
        json["accessors"].push_back(accessor);
        return static_cast<int>(json["accessors"].size()) - 1;
    }
    Json& primitive() { return json["meshes"][0]["primitives"][0]; }
    Json& material() {
        primitive()["material"] = 0;
        return json["materials"][0];
    }
    /// The light of a node of its own.
    Json& light(const Json& node = Json::object()) {
        Json& lights = json["extensions"]["KHR_lights_punctual"]["lights"];
        lights.push_back(Json::object());
        Json carrier = node;
        carrier["extensions"]["KHR_lights_punctual"]["light"] = lights.size() - 1;
        addNode(carrier);
        return lights.back();
    }
    void addNode(const Json& node) {
        json["nodes"].push_back(node);
        json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
    }

    [[nodiscard]] std::string text() const {
        Json whole = json;
        if (!whole.contains("buffers"))
            whole["buffers"] = {{{"byteLength", buffer.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer)}}};
        return whole.dump(1);
    }
    /// As a .glb: its JSON, and the buffer in a chunk.
    [[nodiscard]] std::string glb() const {
        Json whole = json;
        whole["buffers"] = {{{"byteLength", buffer.size()}}};
        std::string text = whole.dump(), binary = buffer;
        text.append((4 - text.size() % 4) % 4, ' ');
        binary.append((4 - binary.size() % 4) % 4, '\0');
        const auto number = [](std::size_t value) { return bytesOf<std::uint32_t>({static_cast<std::uint32_t>(value)}); };
        return "glTF" + number(2) + number(12 + 8 + text.size() + 8 + binary.size()) + number(text.size()) + "JSON" + text +
               number(binary.size()) + std::string("BIN\0", 4) + binary;
    }
    [[nodiscard]] GltfFile parsed(NormalMode mode = NormalMode::file, const LoadOptions& options = {}) const {
        return parseGltf(text(), "made.gltf", mode, options);
    }
};

/// Places of all corners of an object's triangles in the world, in order.
inline std::vector<dvec3> cornersWorld(const GltfObject& object) {
    std::vector<dvec3> corners;
    for (const uvec3& triangle : object.mesh->triangles)
        for (int i = 0; i < 3; ++i)
            corners.emplace_back(object.worldFromNode *
                                 dvec4(object.mesh->originObject + dvec3(object.mesh->positionsMesh[triangle[i]]), 1.0));
    return corners;
}

inline std::string joinedNotes(const std::vector<std::string>& notes) {
    std::string all;
    for (const std::string& note : notes)
        all += note + "\n";
    return all;
}

} // namespace shadowlab::scene
