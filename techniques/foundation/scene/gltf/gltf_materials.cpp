// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/gltf/gltf_materials.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/gltf/unique_names.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

namespace {

/// The numbers of a material, whichever of the two descriptions it has.
struct Surface {
    vec3 base{1.0f};
    double alpha = 1.0; ///< opacity
    double metallic = 1.0, roughness = 1.0;
    vec3 headOn{0.04f}; ///< F0 of what is no metal
    std::optional<GltfTexture> texture;
    vec3 textureMean{1.0f};
};

vec3 colorOf(const std::vector<double>& numbers, const vec3& otherwise) {
    return numbers.size() >= 3 ? vec3(dvec3(numbers[0], numbers[1], numbers[2])) : otherwise;
}

std::vector<double> numbersOf(const tinygltf::Value& extension, const char* key) {
    std::vector<double> numbers;
    if (!extension.Has(key)) return numbers;
    const tinygltf::Value& array = extension.Get(key);
    for (std::size_t i = 0; i < array.ArrayLen(); ++i)
        numbers.push_back(array.Get(static_cast<int>(i)).GetNumberAsDouble());
    return numbers;
}

float brightness(const vec3& color) { return (color.r + color.g + color.b) / 3.0f; }

class MaterialMaker {
public:
    MaterialMaker(GltfSource& source, const tinygltf::Model& model, GltfTextures& textures, std::size_t index)
        : source_(source), textures_(textures), index_(index), given_(model.materials[index]) {}

    GltfMaterial make() {
        const Surface surface = extension("KHR_materials_pbrSpecularGlossiness") ? fromGlossiness() : fromMetalness();
        setReflection(surface);
        if (surface.texture)
            if ((material_.colorImage = textures_.colors(*surface.texture))) {
                material_.diffuseMap = surface.texture->image.string();
                material_.colorPlacement = surface.texture->placement;
                result_.texcoordSet = surface.texture->texcoordSet;
            }
        setEmission();
        setTransmission(surface);
        setOpacity(surface);
        return std::move(result_);
    }

private:
    [[nodiscard]] const tinygltf::Value* extension(const char* name) const {
        const auto found = given_.extensions.find(name);
        return found == given_.extensions.end() ? nullptr : &found->second;
    }
    [[nodiscard]] double factor(const char* extensionName, const char* key, double otherwise) const {
        const tinygltf::Value* found = extension(extensionName);
        return found ? gltfNumber(*found, key, otherwise) : otherwise;
    }
    void note(const std::string& what) { source_.note("materials", index_, what); }

    void useTexture(Surface& surface, int texture, int set, const tinygltf::ExtensionMap& extensions) {
        surface.texture = textures_.find(texture, set, extensions);
        if (!surface.texture) return;
        if (const auto mean = textures_.mean(*surface.texture, true)) surface.textureMean = *mean;
    }

    Surface fromMetalness() {
        const tinygltf::PbrMetallicRoughness& pbr = given_.pbrMetallicRoughness;
        Surface surface;
        surface.base = colorOf(pbr.baseColorFactor, vec3(1.0f));
        surface.alpha = pbr.baseColorFactor.size() == 4 ? pbr.baseColorFactor[3] : 1.0;
        surface.metallic = pbr.metallicFactor;
        surface.roughness = pbr.roughnessFactor;
        useTexture(surface, pbr.baseColorTexture.index, pbr.baseColorTexture.texCoord, pbr.baseColorTexture.extensions);
        const tinygltf::TextureInfo& rough = pbr.metallicRoughnessTexture;
        if (const auto texture = textures_.find(rough.index, rough.texCoord, rough.extensions))
            if (const auto mean = textures_.mean(*texture, false)) {
                surface.roughness *= mean->g;
                surface.metallic *= mean->b;
                note("the image of metal and roughness counts with its mean, the same all over the surface");
            }
        const double ior = indexOfRefraction();
        surface.headOn = vec3(static_cast<float>(ior == 0 ? 1.0 : (ior - 1) * (ior - 1) / ((ior + 1) * (ior + 1))));
        if (const tinygltf::Value* specular = extension("KHR_materials_specular"))
            surface.headOn = glm::min(surface.headOn * colorOf(numbersOf(*specular, "specularColorFactor"), vec3(1.0f)), vec3(1.0f)) *
                             static_cast<float>(gltfNumber(*specular, "specularFactor", 1.0));
        return surface;
    }

    /// The older description, from before 2021: a specular colour, and gloss, which is 1 - roughness.
    Surface fromGlossiness() {
        const tinygltf::Value& glossy = *extension("KHR_materials_pbrSpecularGlossiness");
        const std::vector<double> diffuse = numbersOf(glossy, "diffuseFactor");
        Surface surface;
        surface.base = colorOf(diffuse, vec3(1.0f));
        surface.alpha = diffuse.size() == 4 ? diffuse[3] : 1.0;
        surface.metallic = 0;
        surface.roughness = 1.0 - gltfNumber(glossy, "glossinessFactor", 1.0);
        surface.headOn = colorOf(numbersOf(glossy, "specularFactor"), vec3(1.0f));
        if (glossy.Has("diffuseTexture")) {
            const tinygltf::Value& texture = glossy.Get("diffuseTexture");
            tinygltf::ExtensionMap extensions;
            if (texture.Has("extensions"))
                for (const std::string& key : texture.Get("extensions").Keys())
                    extensions[key] = texture.Get("extensions").Get(key);
            useTexture(surface, static_cast<int>(gltfNumber(texture, "index", -1)), static_cast<int>(gltfNumber(texture, "texCoord", 0)),
                       extensions);
        }
        surface.base *= 1.0f - std::max({surface.headOn.r, surface.headOn.g, surface.headOn.b});
        return surface;
    }

    /// 1.5 where none is given; 0 stands for an F0 of 1.
    double indexOfRefraction() {
        const double ior = factor("KHR_materials_ior", "ior", 1.5);
        if (ior == 0 || (ior >= 1 && ior <= 10)) return ior;
        note("its index of refraction, " + numberText(ior) + ", is not within 1 to 10; 1.5 is taken");
        return 1.5;
    }

    void setReflection(const Surface& surface) {
        constexpr double kSharpest = 1e6; // as for shininess in scene files
        const double width = surface.roughness * surface.roughness;
        const double exponent = std::clamp(2.0 / std::max(width * width, 1e-6) - 2.0, 0.0, kSharpest);
        const double mirrored = surface.metallic * (1.0 - width); // of what the surface reflects
        const vec3 metal = surface.base * surface.textureMean;
        material_.diffuse = surface.base * static_cast<float>(1.0 - mirrored);
        material_.specular = surface.headOn * static_cast<float>(1.0 - surface.metallic) + metal * static_cast<float>(mirrored);
        material_.shininess = static_cast<float>(exponent);
        material_.reflectivity = mirrored * brightness(metal);
        if (material_.reflectivity > 0 && exponent < kSharpest && surface.roughness > 0) {
            // Half of the lobe is left at this angle of the halfway vector, and at twice of it between the rays.
            const double halfway = std::acos(std::exp2(-1.0 / std::max(exponent, 1e-3)));
            material_.glossDegrees = std::min(2.0 * halfway * 180.0 / glm::pi<double>(), 90.0);
        }
        if (extension("KHR_materials_unlit")) {
            note("is unlit (KHR_materials_unlit); it is shown as a diffuse surface, since it would take no shadow");
            material_.diffuse = surface.base;
            material_.specular = vec3(0.0f);
            material_.reflectivity = material_.glossDegrees = 0;
        }
    }

    void setEmission() {
        material_.emission = colorOf(given_.emissiveFactor, vec3(0.0f)) *
                             static_cast<float>(factor("KHR_materials_emissive_strength", "emissiveStrength", 1.0));
        material_.emits = given_.doubleSided ? EmittingSides::both : EmittingSides::front;
        if (material_.emission == vec3(0.0f)) return;
        const tinygltf::TextureInfo& image = given_.emissiveTexture;
        if (const auto texture = textures_.find(image.index, image.texCoord, image.extensions))
            if (const auto mean = textures_.mean(*texture, true)) {
                material_.emission *= *mean;
                note("the image of its emission counts with its mean colour, the same all over the surface");
            }
    }

    /// Without a volume or an index of refraction of its own a surface is a thin sheet, which bends no rays.
    void setTransmission(const Surface& surface) {
        const double transmission = factor("KHR_materials_transmission", "transmissionFactor", 0.0) * (1.0 - surface.metallic);
        if (transmission <= 0) return;
        const bool isSolid = extension("KHR_materials_ior") || factor("KHR_materials_volume", "thicknessFactor", 0.0) > 0;
        const double ior = indexOfRefraction();
        material_.ior = isSolid && ior >= 1 ? ior : 1.0;
        material_.transparency = transmission * brightness(surface.base * surface.textureMean);
        material_.diffuse *= static_cast<float>(1.0 - transmission);
        material_.reflectivity =
            std::min(std::max<double>(material_.reflectivity, brightness(surface.headOn)), 1.0 - material_.transparency);
    }

    void setOpacity(const Surface& surface) {
        if (given_.alphaMode == "MASK") {
            const double cutoff = given_.alphaCutoff;
            if (surface.texture && cutoff > 0 && surface.alpha > 0)
                cut(*surface.texture, 0.5 * surface.alpha / cutoff);
            else if (surface.alpha < cutoff)
                result_.isInvisible = true, note("its alpha is less than its cutoff everywhere; it is left out");
        } else if (given_.alphaMode == "BLEND") {
            if (surface.alpha < 1) {
                material_.transparency = std::max(material_.transparency, 1.0 - surface.alpha);
                if (!extension("KHR_materials_transmission")) material_.ior = 1.0; // what is blended bends no rays
                material_.reflectivity = std::min(material_.reflectivity, 1.0 - material_.transparency);
            }
            if (surface.texture && cut(*surface.texture, 1.0))
                note("its image is blended by its alpha (alphaMode BLEND); here it is a hole where alpha is less than one half");
        }
    }

    /// Cuts holes where alpha times `gain` is less than one half. False where there are none.
    bool cut(const GltfTexture& texture, double gain) {
        const std::shared_ptr<const AlphaMask> mask = textures_.mask(texture, gain);
        if (!mask || std::ranges::find(mask->texels(), 0) == mask->texels().end()) return false;
        material_.alphaMask = mask;
        material_.alphaMap = texture.image.string();
        material_.alphaPlacement = texture.placement;
        return true;
    }

    GltfSource& source_;
    GltfTextures& textures_;
    std::size_t index_;
    const tinygltf::Material& given_;
    GltfMaterial result_;
    Material& material_ = result_.material;
};

} // namespace

std::vector<GltfMaterial> gltfMaterials(GltfSource& source, const tinygltf::Model& model, GltfTextures& textures) {
    std::vector<GltfMaterial> materials;
    UniqueNames names;
    for (std::size_t i = 0; i < model.materials.size(); ++i) {
        materials.push_back(MaterialMaker(source, model, textures, i).make());
        Material& material = materials.back().material;
        const std::string& own = model.materials[i].name;
        material.name = names.unique(own.empty() ? "material " + std::to_string(i) : own);
        material.ofMesh = true;
    }
    return materials;
}

} // namespace shadowlab::scene
