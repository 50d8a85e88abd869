// Scene files: read, used, written down and read again.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/json/write_scene.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/use_scene.h"

namespace shadowlab::fuzz {

namespace {

/// A scene that was written down and read again is the same, but for directions: a unit vector made unit again may change in
/// its last bit.
void requireSame(const scene::Scene& a, const scene::Scene& b) {
    require(a.camera == b.camera && a.ambient == b.ambient && a.background == b.background && a.exposure == b.exposure,
            "camera and exposure come back");
    require(a.viewpoints == b.viewpoints, "views come back");
    require(a.lights.size() == b.lights.size() && a.materials.size() == b.materials.size() &&
                a.objects.size() == b.objects.size(),
            "nothing is lost or added");
    for (std::size_t i = 0; i < a.lights.size(); ++i) {
        scene::Light light = b.lights[i];
        light.directionWorld = a.lights[i].directionWorld;
        require(light == a.lights[i], "lights come back");
    }
    for (std::size_t i = 0; i < a.materials.size(); ++i)
        require(a.materials[i].name == b.materials[i].name && a.materials[i].diffuse == b.materials[i].diffuse &&
                    a.materials[i].emission == b.materials[i].emission && a.materials[i].ior == b.materials[i].ior,
                "materials come back");
    for (std::size_t i = 0; i < a.objects.size(); ++i)
        require(a.objects[i].name == b.objects[i].name &&
                    a.objects[i].worldFromObject == b.objects[i].worldFromObject &&
                    a.objects[i].mesh->positionsMesh == b.objects[i].mesh->positionsMesh &&
                    a.objects[i].partMaterials == b.objects[i].partMaterials,
                "objects come back");
}

} // namespace

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
            requireSame(*snapshot, *scene::parseSceneJson(text, folder / "made-up.json", options));
        } catch (const std::runtime_error& error) { // no Fault, which is a logic_error
            throw Fault(std::string("a scene that was written is refused: ") + error.what());
        }
    });
}

} // namespace shadowlab::fuzz
