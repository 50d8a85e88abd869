// Scene files: read, used, written down and read again.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/write_scene.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/use_scene.h"

namespace shadowlab::fuzz {

Outcome feed(std::string_view bytes) {
    const scene::LoadOptions options{
        .assetsRoot = SHADOWLAB_SOURCE_DIR "/assets", .allowed = {}, .limits = smallLimits()};
    // Where models lie beside it, though not there itself.
    const std::filesystem::path folder = options.assetsRoot / "scenes";
    return outcomeOf([&] {
        const scene::Snapshot snapshot = scene::parseSceneJson(std::string(bytes), folder / "made-up.json", options);
        useScene(snapshot);
        const std::string text = scene::sceneText(*snapshot, snapshot->camera, folder);
        if (text.size() > options.limits.sceneFileBytes) return; // what is written is longer than what was read
        try {
            const scene::Snapshot again = scene::parseSceneJson(text, folder / "made-up.json", options);
            require(scene::sceneText(*again, again->camera, folder) == text, "a scene is read as it was written");
        } catch (const std::runtime_error& error) {
            throw Fault(std::string("a scene that was written is refused: ") + error.what());
        }
    });
}

} // namespace shadowlab::fuzz
