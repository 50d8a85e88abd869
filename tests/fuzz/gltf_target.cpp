// A glTF file, as JSON or as a .glb, read from memory: nothing is written, and nothing lies beside it.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "techniques/foundation/scene/gltf/load_gltf.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/use_scene.h"

namespace shadowlab::fuzz {

namespace {

/// What all that follows relies on. Cheap enough for every file that is taken.
void requireSoundFile(const scene::GltfFile& file) {
    require(!file.objects.empty(), "a file that was taken shows something");
    std::set<std::string> names;
    for (const scene::GltfObject& object : file.objects) {
        require(names.insert(object.name).second, "objects have names of their own");
        require(object.mesh && !object.mesh->triangles.empty(), "an object has triangles");
        require(object.partMaterials.size() == object.mesh->parts.size(), "a material for each part");
        for (const std::uint32_t material : object.partMaterials)
            require(material == scene::GltfObject::kNoMaterial || material < file.materials.size(), "materials that there are");
        for (const uvec3& triangle : object.mesh->triangles)
            require(std::max({triangle.x, triangle.y, triangle.z}) < object.mesh->positionsMesh.size(), "triangles name vertices");
    }
    for (const scene::Material& material : file.materials) {
        require(std::isfinite(material.diffuse.x + material.specular.x + material.emission.x + material.shininess),
                "materials are numbers");
        require(material.reflectivity >= 0 && material.transparency >= 0 && material.reflectivity + material.transparency <= 1 + 1e-6,
                "no surface sends on more light than it gets"); // but for rounding of float
    }
    for (const scene::Light& light : file.lights)
        require(std::isfinite(light.intensity) && std::abs(glm::length(light.directionWorld) - 1) < 1e-9, "lights have a direction");
    for (const scene::Viewpoint& viewpoint : file.viewpoints)
        require(scene::hasView(viewpoint.camera), "cameras have a view");
}

/// A stage, volumes and rays take far longer than reading: they are made of one file in this many, chosen by its bytes.
constexpr unsigned kUsedOneIn = 64;

bool isUsed(std::string_view bytes) {
    return std::accumulate(bytes.begin(), bytes.end(), 0u,
                           [](unsigned sum, char c) { return 31 * sum + static_cast<unsigned char>(c); }) %
               kUsedOneIn ==
           0;
}

} // namespace

Outcome feed(std::string_view bytes) {
    static const std::filesystem::path file = ownFolder() / "made-up.gltf";
    static const scene::LoadOptions options{.assetsRoot = {}, .allowed = {}, .limits = smallLimits()};
    return outcomeOf([&] {
        constexpr std::array kModes{scene::NormalMode::file, scene::NormalMode::flat, scene::NormalMode::smooth};
        scene::GltfFile gltf = scene::parseGltf(std::string(bytes), file, kModes[bytes.size() % kModes.size()], options);
        requireSoundFile(gltf);
        if (isUsed(bytes)) useScene(scene::stagedGltf(std::move(gltf), file, options));
    });
}

} // namespace shadowlab::fuzz
