// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/pack/pack_gltf.h"

#include <algorithm>

#include "techniques/foundation/scene/gltf/gltf_container.h"
#include "techniques/foundation/scene/gltf/gltf_files.h"
#include "techniques/foundation/scene/gltf/gltf_uris.h"
#include "techniques/foundation/scene/json/write_scene.h"
#include "techniques/foundation/scene/pack/replaced_text.h"

namespace shadowlab::scene {

namespace {

/// A .glb with another text in its first chunk, which is padded with blanks to a multiple of four bytes.
std::string withJson(const std::string& bytes, std::size_t formerSize, std::string json) {
    constexpr std::size_t kHeaders = 20; // of the file, and of the first chunk
    json.append((4 - json.size() % 4) % 4, ' ');
    const auto inBytes = [](std::size_t number) {
        std::string text;
        for (int i = 0; i < 4; ++i)
            text += static_cast<char>(number >> (8 * i) & 0xff);
        return text;
    };
    const std::string rest = bytes.substr(kHeaders + formerSize);
    return bytes.substr(0, 8) + inBytes(kHeaders + json.size() + rest.size()) + inBytes(json.size()) + bytes.substr(16, 4) + json + rest;
}

/// The text with the new places of its files, and copies of these. The file was read before without a fault.
std::string packedText(const std::filesystem::path& file, const LoadOptions& options, const std::filesystem::path& folder,
                       PackedFiles& files) {
    const GltfContainer container = gltfContainer(readFile(file, options.limits.fileBytes), file);
    const JsonDocument document(container.json, file, options.limits.jsonDepth);
    GltfFiles beside(file, options);
    std::vector<std::pair<const JsonValue*, std::string>> places; // a URI, and the new one
    const auto copy = [&](std::string_view array, const std::filesystem::path& into) {
        const JsonValue* elements = gltfMember(document.root(), array);
        for (const JsonValue& element : elements ? elements->items : std::vector<JsonValue>{}) {
            const JsonValue* uri = gltfMember(element, "uri");
            if (!uri || isDataUri(uri->string)) continue;
            const auto found = beside.find(document, *uri).canonical;
            if (!found) continue;
            const std::filesystem::path place = files.add(*found, into, found->filename().string(), [&](const std::filesystem::path&) {
                return readFile(*found, options.limits.fileBytes);
            });
            places.emplace_back(uri, percentEncoded(place.lexically_relative(folder).generic_string()));
        }
    };
    copy("buffers", folder);
    copy("images", folder / "textures");
    if (places.empty()) return container.bytes.empty() ? container.json : container.bytes;
    std::ranges::sort(places, {}, [](const auto& place) { return place.first->offset; });
    ReplacedText replaced(document.text());
    for (const auto& [uri, place] : places)
        replaced.replace(ReplacedText::tokenAt(document.text(), uri->offset), textInJson(place));
    std::string text = std::move(replaced).finish();
    return container.bytes.empty() ? text : withJson(container.bytes, container.json.size(), std::move(text));
}

} // namespace

std::filesystem::path packGltf(const std::filesystem::path& file, const LoadOptions& options, PackedFiles& files) {
    return files.add(std::filesystem::weakly_canonical(file), "meshes", file.filename().string(),
                     [&](const std::filesystem::path& place) { return packedText(file, options, place.parent_path(), files); });
}

} // namespace shadowlab::scene
