// SPDX-License-Identifier: MIT
#include "app/picture/digest.h"

#include <array>
#include <cstdio>
#include <type_traits>

#include "techniques/foundation/base/fnv.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/surface_color.h"

namespace shadowlab::picture {

namespace {

class Hash {
public:
    void add(const void* bytes, std::size_t count) { value_ = fnv(bytes, count, value_); }
    void add(const std::string& text) {
        add(text.data(), text.size());
        add(text.size());
    }
    /// Numbers and vectors of numbers: types without gaps, whose bytes are their value.
    template <typename T>
    requires std::is_trivially_copyable_v<T>
    void add(const T& value) { add(&value, sizeof value); }
    template <typename T>
    void add(const std::vector<T>& values) {
        for (const T& value : values)
            add(value);
        add(values.size());
    }
    [[nodiscard]] std::string digits() const {
        std::array<char, 20> text{};
        std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(value_));
        return text.data();
    }

private:
    std::uint64_t value_ = kFnvBasis;
};

void add(Hash& hash, const scene::Camera& camera) {
    hash.add(camera.positionWorld), hash.add(camera.targetWorld), hash.add(camera.upWorld);
    hash.add(camera.fovYDegrees), hash.add(camera.near), hash.add(camera.far);
}

void add(Hash& hash, const scene::Light& light) {
    hash.add(light.name), hash.add(static_cast<int>(light.type)), hash.add(light.positionWorld);
    hash.add(light.directionWorld), hash.add(light.edgeUWorld), hash.add(light.edgeVWorld), hash.add(light.radius);
    hash.add(light.coneDegrees), hash.add(light.edgeDegrees), hash.add(light.color), hash.add(light.intensity);
}

void add(Hash& hash, const scene::Material& material) {
    hash.add(material.name), hash.add(material.diffuse), hash.add(material.specular), hash.add(material.shininess),
        hash.add(material.emission);
    hash.add(material.reflectivity), hash.add(material.transparency), hash.add(material.ior);
    hash.add(material.priority), hash.add(material.glossDegrees), hash.add(material.translucencyDegrees);
    hash.add(material.emits), hash.add(material.alphaMask ? 1 : 0);
    if (material.alphaMask) hash.add(material.alphaMask->size()), hash.add(material.alphaMask->texels());
    hash.add(material.colorImage ? 1 : 0);
    if (material.colorImage) hash.add(material.colorImage->size()), hash.add(material.colorImage->texels());
    for (const scene::ImagePlacement& placement : {material.alphaPlacement, material.colorPlacement})
        hash.add(dvec3(placement.scale, placement.clamped ? 1 : 0)), hash.add(dvec3(placement.offset, 0));
    hash.add(material.ofMesh ? 1 : 0);
}

void add(Hash& hash, const scene::Mesh& mesh) {
    hash.add(mesh.positionsMesh), hash.add(mesh.normalsMesh), hash.add(mesh.texcoords), hash.add(mesh.colors), hash.add(mesh.triangles);
    for (const scene::MeshPart& part : mesh.parts) {
        hash.add(part.firstTriangle), hash.add(part.triangleCount);
        hash.add(part.hasTexcoords ? 1 : 0);
    }
    hash.add(mesh.parts.size());
}

void add(Hash& hash, const scene::Object& object) {
    add(hash, *object.mesh);
    hash.add(object.name), hash.add(scene::worldFromMesh(object)), hash.add(object.velocityWorld),
        hash.add(object.partMaterials);
    hash.add(object.castsShadow ? 1 : 0), hash.add(object.receivesShadow ? 1 : 0);
    hash.add(object.emitterOfLight);
}

} // namespace

std::string digestOf(const scene::Scene& scene) {
    Hash hash;
    add(hash, scene.camera);
    hash.add(scene.ambient), hash.add(scene.background), hash.add(scene.exposure);
    for (const scene::Light& light : scene.lights)
        add(hash, light);
    hash.add(scene.lights.size());
    for (const scene::Material& material : scene.materials)
        add(hash, material);
    hash.add(scene.materials.size());
    for (const scene::Object& object : scene.objects)
        add(hash, object);
    hash.add(scene.objects.size());
    return hash.digits();
}

std::string digestOf(const std::string& text) {
    return digestOf(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::string digestOf(std::span<const std::uint8_t> bytes) {
    Hash hash;
    hash.add(bytes.data(), bytes.size());
    return hash.digits();
}

} // namespace shadowlab::picture
