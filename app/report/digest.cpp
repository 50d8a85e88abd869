// SPDX-License-Identifier: MIT
#include "app/report/digest.h"

#include <array>
#include <cstdio>
#include <type_traits>

namespace shadowlab::report {

namespace {

/// FNV-1a with 64 bits (Fowler, Noll and Vo).
class Hash {
public:
    void add(const void* bytes, std::size_t count) {
        const auto* byte = static_cast<const unsigned char*>(bytes);
        for (std::size_t i = 0; i < count; ++i)
            value_ = (value_ ^ byte[i]) * 1099511628211ull;
    }
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
    std::uint64_t value_ = 14695981039346656037ull;
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
    hash.add(material.diffuse), hash.add(material.specular), hash.add(material.shininess), hash.add(material.emission);
    hash.add(material.reflectivity), hash.add(material.transparency), hash.add(material.ior);
    hash.add(material.priority), hash.add(material.glossDegrees), hash.add(material.translucencyDegrees);
}

void add(Hash& hash, const scene::Object& object) {
    hash.add(object.mesh->positionsMesh), hash.add(object.mesh->normalsMesh), hash.add(object.mesh->triangles);
    hash.add(scene::worldFromMesh(object)), hash.add(object.velocityWorld), hash.add(object.partMaterials);
    hash.add(object.castsShadow ? 1 : 0), hash.add(object.receivesShadow ? 1 : 0);
}

} // namespace

std::string digestOf(const scene::Scene& scene) {
    Hash hash;
    add(hash, scene.camera);
    hash.add(scene.ambient), hash.add(scene.background), hash.add(scene.exposure);
    for (const scene::Light& light : scene.lights)
        add(hash, light);
    for (const scene::Material& material : scene.materials)
        add(hash, material);
    for (const scene::Object& object : scene.objects)
        add(hash, object);
    return hash.digits();
}

std::string digestOf(const std::string& text) {
    Hash hash;
    hash.add(text.data(), text.size());
    return hash.digits();
}

} // namespace shadowlab::report
