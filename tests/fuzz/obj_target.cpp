// A mesh with its materials: OBJ text, a NUL byte, MTL text (which the OBJ calls m.mtl), as OSS-Fuzz has it for tinyobjloader.
// Where the text begins with the byte order mark of UTF-16, a NUL character of two bytes stands between.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>

#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/use_scene.h"

namespace shadowlab::fuzz {

namespace {

/// Where the OBJ text ends, and how many bytes stand between it and the MTL text.
std::pair<std::size_t, std::size_t> endOfMesh(std::string_view bytes) {
    if (!bytes.starts_with("\xff\xfe") && !bytes.starts_with("\xfe\xff")) return {bytes.find('\0'), 1};
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
        if (bytes[i] == '\0' && bytes[i + 1] == '\0') return {i, 2};
    return {bytes.size(), 2};
}

} // namespace

Outcome feed(std::string_view bytes) {
    scene::LoadOptions options{.assetsRoot = SHADOWLAB_SOURCE_DIR "/assets", .allowed = {}, .limits = smallLimits()};
    const auto [found, between] = endOfMesh(bytes);
    const std::size_t end = std::min(found, bytes.size());
    const std::filesystem::path file = written("made-up.obj", bytes.substr(0, end));
    written("m.mtl", bytes.substr(std::min(end + between, bytes.size())));
    return outcomeOf([&] {
        // One way for each text: normals change no triangle.
        constexpr std::array kModes{scene::NormalMode::file, scene::NormalMode::flat, scene::NormalMode::smooth};
        scene::ObjFile obj = scene::loadObj(file, kModes[bytes.size() % kModes.size()], options);
        useMesh(scene::sharedMesh(std::move(obj.mesh)));
        for (scene::Mesh& piece : obj.furtherPieces)
            useMesh(scene::sharedMesh(std::move(piece)));
        options.limits.triangles += 1000; // of the floor that it is put on
        useScene(scene::stageObj(file, options));
    });
}

} // namespace shadowlab::fuzz
