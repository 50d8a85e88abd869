// A mesh with its materials: OBJ text, a NUL byte, MTL text (which the OBJ calls m.mtl), as OSS-Fuzz has it for tinyobjloader.
// SPDX-License-Identifier: MIT
#include <array>

#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/use_scene.h"

namespace shadowlab::fuzz {

Outcome feed(std::string_view bytes) {
    scene::LoadOptions options{.assetsRoot = SHADOWLAB_SOURCE_DIR "/assets", .allowed = {}, .limits = smallLimits()};
    const std::size_t end = std::min(bytes.find('\0'), bytes.size());
    const std::filesystem::path file = written("made-up.obj", bytes.substr(0, end));
    written("m.mtl", bytes.substr(std::min(end + 1, bytes.size())));
    return outcomeOf([&] {
        // One way for each text: normals change no triangle.
        constexpr std::array kModes{scene::NormalMode::file, scene::NormalMode::flat, scene::NormalMode::smooth};
        scene::ObjFile obj = scene::loadObj(file, kModes[bytes.size() % kModes.size()], options);
        useMesh(scene::sharedMesh(std::move(obj.mesh)));
        options.limits.triangles += 1000; // of the floor that it is put on
        useScene(scene::stageObj(file, options));
    });
}

} // namespace shadowlab::fuzz
