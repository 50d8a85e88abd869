// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/gltf/gltf_schema.h"

#include <algorithm>
#include <array>

namespace shadowlab::scene {

namespace {

using enum GltfKey::Kind;
constexpr double kMost = 9007199254740991.0; // 2^53 - 1: whole numbers up to here are exact in double

constexpr GltfKey keyText(std::string_view name) { return {.name = name, .kind = text}; }
constexpr GltfKey keyShare(std::string_view name, double most = 1, std::size_t count = 0) {
    return {.name = name, .kind = share, .least = 0, .most = most, .count = count};
}
/// Two numbers that stay finite when they are multiplied with texture coordinates.
constexpr GltfKey keyPair(std::string_view name) { return {.name = name, .kind = share, .least = -1e15, .most = 1e15, .count = 2}; }
constexpr GltfKey keyCount(std::string_view name, double least, bool isRequired) {
    return {.name = name, .kind = integer, .isRequired = isRequired, .least = least, .most = kMost};
}
constexpr GltfKey keyReference(std::string_view name, std::string_view of, bool isRequired = false) {
    return {.name = name, .kind = reference, .isRequired = isRequired, .of = of};
}
constexpr GltfKey keyObject(std::string_view name, std::span<const GltfKey> schema, bool isRequired = false) {
    return {.name = name, .kind = object, .isRequired = isRequired, .schema = schema};
}
constexpr GltfKey keyIgnored(std::string_view name, std::string_view note = {}) { return {.name = name, .note = note}; }
constexpr GltfKey keyExtensions(std::span<const GltfKey> known) { return {.name = "extensions", .kind = extensions, .schema = known}; }
constexpr std::span<const GltfKey> kNone{};

constexpr std::array kAsset{GltfKey{.name = "version", .kind = text, .isRequired = true}, keyText("minVersion"), keyText("generator"),
                            keyText("copyright"), keyExtensions(kNone)};

constexpr std::array kBuffer{keyText("uri"), keyText("name"), keyCount("byteLength", 1, true), keyExtensions(kNone)};
constexpr std::array kBufferView{keyReference("buffer", "buffers", true),
                                 keyCount("byteOffset", 0, false),
                                 keyCount("byteLength", 1, true),
                                 GltfKey{.name = "byteStride", .kind = integer, .least = 4, .most = 252, .multipleOf = 4},
                                 keyIgnored("target"),
                                 keyIgnored("name"),
                                 keyExtensions(kNone)};

constexpr std::array kSparseIndices{keyReference("bufferView", "bufferViews", true), keyCount("byteOffset", 0, false),
                                    GltfKey{.name = "componentType", .kind = integer, .isRequired = true, .of = "5121|5123|5125"},
                                    keyExtensions(kNone)};
constexpr std::array kSparseValues{keyReference("bufferView", "bufferViews", true), keyCount("byteOffset", 0, false),
                                   keyExtensions(kNone)};
constexpr std::array kSparse{keyCount("count", 1, true), keyObject("indices", kSparseIndices, true),
                             keyObject("values", kSparseValues, true), keyExtensions(kNone)};
constexpr std::array kAccessor{
    keyReference("bufferView", "bufferViews"),
    keyCount("byteOffset", 0, false),
    GltfKey{.name = "normalized", .kind = flag},
    GltfKey{.name = "componentType", .kind = integer, .isRequired = true, .of = "5120|5121|5122|5123|5125|5126"},
    keyCount("count", 1, true),
    GltfKey{.name = "type", .kind = text, .isRequired = true, .of = "SCALAR|VEC2|VEC3|VEC4|MAT2|MAT3|MAT4"},
    keyObject("sparse", kSparse),
    keyIgnored("min"),
    keyIgnored("max"),
    keyIgnored("name"),
    keyExtensions(kNone)};

constexpr std::array kPrimitive{GltfKey{.name = "attributes", .kind = attributes, .isRequired = true, .of = "accessors"},
                                keyReference("indices", "accessors"),
                                keyReference("material", "materials"),
                                GltfKey{.name = "mode", .kind = integer, .least = 0, .most = 6},
                                keyIgnored("targets", "morph targets are left out; the mesh is shown without them"),
                                keyExtensions(kNone)};
constexpr std::array kMesh{GltfKey{.name = "primitives", .kind = objects, .isRequired = true, .schema = kPrimitive}, keyText("name"),
                           keyIgnored("weights"), keyExtensions(kNone)};

constexpr std::array kNodeLight{keyReference("light", "lights", true)};
constexpr std::array kNodeExtensions{keyObject("KHR_lights_punctual", kNodeLight)};
constexpr std::array kNode{keyText("name"),
                           GltfKey{.name = "children", .kind = references, .of = "nodes"},
                           keyReference("mesh", "meshes"),
                           keyReference("camera", "cameras"),
                           keyIgnored("skin", "skins are left out; the mesh is shown as it is modelled"),
                           GltfKey{.name = "matrix", .kind = numbers, .count = 16},
                           GltfKey{.name = "translation", .kind = numbers, .count = 3},
                           GltfKey{.name = "rotation", .kind = numbers, .count = 4},
                           GltfKey{.name = "scale", .kind = numbers, .count = 3},
                           keyIgnored("weights"),
                           keyExtensions(kNodeExtensions)};
constexpr std::array kScene{GltfKey{.name = "nodes", .kind = references, .of = "nodes"}, keyText("name"), keyExtensions(kNone)};

constexpr std::array kTransform{keyPair("offset"), GltfKey{.name = "rotation", .kind = number}, keyPair("scale"),
                                keyCount("texCoord", 0, false)};
constexpr std::array kTextureInfoExtensions{keyObject("KHR_texture_transform", kTransform)};
constexpr std::array kTextureInfo{keyReference("index", "textures", true), keyCount("texCoord", 0, false),
                                  keyExtensions(kTextureInfoExtensions)};
constexpr std::array kPbr{
    keyShare("baseColorFactor", 1, 4), keyObject("baseColorTexture", kTextureInfo),         keyShare("metallicFactor"),
    keyShare("roughnessFactor"),       keyObject("metallicRoughnessTexture", kTextureInfo), keyExtensions(kNone)};

constexpr std::array kTransmission{
    keyShare("transmissionFactor"),
    keyIgnored("transmissionTexture", "the image of a transmission is left out; its factor counts everywhere")};
constexpr std::array kIor{GltfKey{.name = "ior", .kind = number}};
constexpr std::array kStrength{keyShare("emissiveStrength", 1e15)};
constexpr std::array kVolume{keyShare("thicknessFactor", 1e15), keyIgnored("thicknessTexture"),
                             keyIgnored("attenuationDistance", "the colour that light takes on within a volume is left out"),
                             keyIgnored("attenuationColor")};
constexpr std::array kSpecular{
    keyShare("specularFactor"), keyShare("specularColorFactor", 1e15, 3),
    keyIgnored("specularTexture", "the image of a specular strength is left out; its factor counts everywhere"),
    keyIgnored("specularColorTexture", "the image of a specular colour is left out; its factor counts everywhere")};
constexpr std::array kGlossiness{
    keyShare("diffuseFactor", 1, 4), keyObject("diffuseTexture", kTextureInfo), keyShare("specularFactor", 1, 3),
    keyShare("glossinessFactor"),
    keyIgnored("specularGlossinessTexture", "the image of specular and glossiness is left out; its factors count everywhere")};
constexpr std::array kMaterialExtensions{keyObject("KHR_materials_transmission", kTransmission),
                                         keyObject("KHR_materials_ior", kIor),
                                         keyObject("KHR_materials_emissive_strength", kStrength),
                                         keyObject("KHR_materials_unlit", kNone),
                                         keyObject("KHR_materials_volume", kVolume),
                                         keyObject("KHR_materials_specular", kSpecular),
                                         keyObject("KHR_materials_pbrSpecularGlossiness", kGlossiness)};
constexpr std::array kMaterial{keyText("name"),
                               keyObject("pbrMetallicRoughness", kPbr),
                               keyIgnored("normalTexture", "normal maps are left out; the surface is shaded as it is modelled"),
                               keyIgnored("occlusionTexture", "occlusion maps are left out; shadows are computed here"),
                               keyObject("emissiveTexture", kTextureInfo),
                               keyShare("emissiveFactor", 1, 3),
                               GltfKey{.name = "alphaMode", .kind = text, .of = "OPAQUE|MASK|BLEND"},
                               keyShare("alphaCutoff", 1e15),
                               GltfKey{.name = "doubleSided", .kind = flag},
                               keyExtensions(kMaterialExtensions)};

constexpr std::array kTextureExtensions{
    keyIgnored("KHR_texture_basisu", "a KTX2 image is left out"), keyIgnored("EXT_texture_webp", "a WebP image is left out"),
    keyIgnored("EXT_texture_avif", "an AVIF image is left out"), keyIgnored("MSFT_texture_dds", "a DDS image is left out")};
constexpr std::array kTexture{keyReference("sampler", "samplers"), keyReference("source", "images"), keyIgnored("name"),
                              keyExtensions(kTextureExtensions)};
constexpr std::array kImage{keyText("uri"), keyText("mimeType"), keyReference("bufferView", "bufferViews"), keyText("name"),
                            keyExtensions(kNone)};
constexpr std::array kSampler{GltfKey{.name = "magFilter", .kind = integer, .of = "9728|9729"},
                              GltfKey{.name = "minFilter", .kind = integer, .of = "9728|9729|9984|9985|9986|9987"},
                              GltfKey{.name = "wrapS", .kind = integer, .of = "33071|33648|10497"},
                              GltfKey{.name = "wrapT", .kind = integer, .of = "33071|33648|10497"},
                              keyIgnored("name"),
                              keyExtensions(kNone)};

constexpr std::array kPerspective{keyIgnored("aspectRatio"), GltfKey{.name = "yfov", .kind = number, .isRequired = true},
                                  GltfKey{.name = "zfar", .kind = number}, GltfKey{.name = "znear", .kind = number, .isRequired = true},
                                  keyExtensions(kNone)};
constexpr std::array kOrthographic{GltfKey{.name = "xmag", .kind = number, .isRequired = true},
                                   GltfKey{.name = "ymag", .kind = number, .isRequired = true},
                                   GltfKey{.name = "zfar", .kind = number, .isRequired = true},
                                   GltfKey{.name = "znear", .kind = number, .isRequired = true}, keyExtensions(kNone)};
constexpr std::array kCamera{GltfKey{.name = "type", .kind = text, .isRequired = true, .of = "perspective|orthographic"},
                             keyObject("perspective", kPerspective), keyObject("orthographic", kOrthographic), keyText("name"),
                             keyExtensions(kNone)};

constexpr std::array kSpot{GltfKey{.name = "innerConeAngle", .kind = number}, GltfKey{.name = "outerConeAngle", .kind = number}};
constexpr std::array kLight{keyText("name"),
                            keyShare("color", 1e15, 3),
                            keyShare("intensity", 1e15),
                            GltfKey{.name = "type", .kind = text, .isRequired = true, .of = "directional|point|spot"},
                            keyObject("spot", kSpot),
                            keyIgnored("range", "the range of a light is left out: light falls off with the "
                                                "square of the distance, without an end"),
                            keyExtensions(kNone)};
constexpr std::array kLights{GltfKey{.name = "lights", .kind = objects, .isRequired = true, .schema = kLight}};
constexpr std::array kFileExtensions{keyObject("KHR_lights_punctual", kLights),
                                     keyIgnored("KHR_materials_variants", "variants of materials are left out; the first is shown")};

constexpr GltfKey keyArray(std::string_view name, std::span<const GltfKey> schema, bool isPassedOn = true) {
    return {.name = name, .kind = objects, .schema = schema, .isPassedOn = isPassedOn};
}
constexpr std::array kFile{keyObject("asset", kAsset, true),
                           keyIgnored("extensionsUsed"),
                           keyIgnored("extensionsRequired"),
                           keyArray("buffers", kBuffer, false),
                           keyArray("bufferViews", kBufferView),
                           keyArray("accessors", kAccessor),
                           keyArray("meshes", kMesh),
                           keyArray("nodes", kNode),
                           keyArray("scenes", kScene),
                           keyReference("scene", "scenes"),
                           keyArray("materials", kMaterial),
                           keyArray("textures", kTexture),
                           keyArray("images", kImage, false),
                           keyArray("samplers", kSampler),
                           keyArray("cameras", kCamera),
                           keyIgnored("skins"),
                           keyIgnored("animations", "animations are left out; the scene is shown at rest"),
                           keyExtensions(kFileExtensions)};

constexpr std::array<std::string_view, 10> kServed{"KHR_lights_punctual",   "KHR_texture_transform",
                                                   "KHR_mesh_quantization", "KHR_materials_transmission",
                                                   "KHR_materials_ior",     "KHR_materials_emissive_strength",
                                                   "KHR_materials_unlit",   "KHR_materials_specular",
                                                   "KHR_materials_volume",  "KHR_materials_pbrSpecularGlossiness"};

} // namespace

std::span<const GltfKey> gltfSchema() { return kFile; }

bool isServedExtension(std::string_view name) { return std::ranges::find(kServed, name) != kServed.end(); }

} // namespace shadowlab::scene
