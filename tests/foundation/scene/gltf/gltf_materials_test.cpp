// Materials of glTF files: factors, images wherever they are stored, holes, and the numbers that shading makes of metal and roughness.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "tests/foundation/scene/gltf/gltf_file.h"

namespace shadowlab::scene {
namespace {

std::string png(int width, int height, const std::vector<image::Color8>& texels, bool opaque = true) {
    image::Image picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.set(x, y, texels[static_cast<std::size_t>(y * width + x)]);
    const std::vector<std::uint8_t> bytes = image::encodePng(picture, {.opaque = opaque, .text = {}});
    return {bytes.begin(), bytes.end()};
}

/// Red and green above blue and white.
std::string fourColors() { return png(2, 2, {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 255, 255}}); }

/// A triangle with texture coordinates, and a material to be filled in.
MadeGltf textured() {
    MadeGltf made;
    made.primitive()["attributes"]["TEXCOORD_0"] = made.add<float>({0, 0, 1, 0, 0, 1}, 5126, "VEC2", 3);
    made.material()["name"] = "m";
    return made;
}

/// Lays an image on the material.
Json& useImage(MadeGltf& made, const Json& image) {
    made.json["images"] = {image};
    made.json["textures"] = {{{"source", 0}}};
    Json& use = made.material()["pbrMetallicRoughness"]["baseColorTexture"];
    use["index"] = 0;
    return use;
}

Material materialOf(const MadeGltf& made) { return made.parsed().materials.at(0); }

constexpr float kFloat = 1e-6f; // of numbers about 1 that were rounded to float a few times

void expectNear(const vec3& found, const vec3& expected, float tolerance, const std::string& what) {
    EXPECT_LE(glm::length(found - expected), tolerance) << what << ": " << found.x << " " << found.y << " " << found.z;
}

TEST(GltfMaterials, WhatIsNoMetalIsDiffuseUnderAHighlightOfFourPercent) {
    MadeGltf made;
    made.material()["pbrMetallicRoughness"] = {{"baseColorFactor", {0.5, 0.25, 0, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 0.5}};
    const Material material = materialOf(made);
    EXPECT_EQ(material.diffuse, vec3(0.5f, 0.25f, 0));
    expectNear(material.specular, vec3(0.04f), kFloat, "((1.5 - 1) / (1.5 + 1))^2");
    EXPECT_EQ(material.shininess, 30) << "2 / 0.5^4 - 2";
    EXPECT_EQ(material.reflectivity, 0);
    EXPECT_EQ(material.emits, EmittingSides::front);
    EXPECT_TRUE(material.ofMesh);
}

TEST(GltfMaterials, ASmoothMetalMirrorsAndARoughOneIsDiffuse) {
    const auto metal = [](double roughness) {
        MadeGltf made;
        made.material()["pbrMetallicRoughness"] = {{"baseColorFactor", {0.9, 0.6, 0.3, 1}}, {"roughnessFactor", roughness}};
        return materialOf(made);
    };
    const Material smooth = metal(0), half = metal(0.5), rough = metal(1);
    EXPECT_EQ(smooth.diffuse, vec3(0));
    EXPECT_EQ(smooth.specular, vec3(dvec3(0.9, 0.6, 0.3)));
    EXPECT_NEAR(smooth.reflectivity, 0.6, kFloat) << "the mean of the base colour";
    EXPECT_EQ(smooth.glossDegrees, 0);
    EXPECT_EQ(rough.diffuse, vec3(dvec3(0.9, 0.6, 0.3)));
    EXPECT_EQ(rough.specular, vec3(0));
    EXPECT_EQ(rough.reflectivity, 0);
    expectNear(half.diffuse + half.specular, vec3(dvec3(0.9, 0.6, 0.3)), kFloat, "no light is lost between the two");
    EXPECT_NEAR(half.reflectivity, 0.75 * 0.6, kFloat) << "1 - 0.5^2";
    // cos(a)^30 is one half where a is half of the angle between the rays.
    EXPECT_NEAR(std::pow(std::cos(half.glossDegrees / 2 * std::acos(-1.0) / 180), 30), 0.5, 1e-9);
}

TEST(GltfMaterials, ExtensionsThatAreServed) {
    MadeGltf made;
    Json& material = made.material();
    material["emissiveFactor"] = {1, 0.5, 0};
    material["doubleSided"] = true;
    material["pbrMetallicRoughness"] = {{"metallicFactor", 0}, {"roughnessFactor", 0}};
    material["extensions"] = {{"KHR_materials_emissive_strength", {{"emissiveStrength", 6}}},
                              {"KHR_materials_transmission", {{"transmissionFactor", 0.75}}},
                              {"KHR_materials_ior", {{"ior", 2}}}};
    const Material glass = materialOf(made);
    EXPECT_EQ(glass.emission, vec3(6, 3, 0));
    EXPECT_EQ(glass.emits, EmittingSides::both);
    EXPECT_EQ(glass.transparency, 0.75);
    EXPECT_EQ(glass.ior, 2);
    EXPECT_EQ(glass.diffuse, vec3(0.25f));
    EXPECT_NEAR(glass.reflectivity, 1.0 / 9, kFloat) << "((2 - 1) / (2 + 1))^2";
    material["extensions"].erase("KHR_materials_ior");
    EXPECT_EQ(materialOf(made).ior, 1) << "a sheet without thickness bends no rays";
    material["extensions"]["KHR_materials_volume"]["thicknessFactor"] = 0.1;
    EXPECT_EQ(materialOf(made).ior, 1.5);
    material["extensions"] = {{"KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {1, 0.5, 0}}}}};
    expectNear(materialOf(made).specular, vec3(0.02f, 0.01f, 0), kFloat, "0.04 times factor and colour");
    material["extensions"] = {{"KHR_materials_unlit", Json::object()}};
    EXPECT_EQ(materialOf(made).specular, vec3(0));
    EXPECT_TRUE(contains(joinedNotes(made.parsed().notes), "materials[0]: is unlit")) << joinedNotes(made.parsed().notes);
    material["extensions"] = {{"KHR_materials_pbrSpecularGlossiness",
                               {{"diffuseFactor", {0.5, 0.5, 0.5, 1}}, {"specularFactor", {0.2, 0.2, 0.2}}, {"glossinessFactor", 0.5}}}};
    expectNear(materialOf(made).diffuse, vec3(0.4f), kFloat, "what the specular colour leaves");
    EXPECT_EQ(materialOf(made).shininess, 30);
}

TEST(GltfMaterials, AnImageIsTheSameWhereverItIsStored) {
    const TempFolder folder;
    folder.write("a b.png", fourColors());
    std::string notes;
    const auto colorsOf = [&](const Json& image, const std::string& held) {
        MadeGltf made = textured();
        Json where = image;
        if (!held.empty()) where["bufferView"] = made.view(held);
        useImage(made, where);
        const GltfFile file = parseGltf(made.text(), folder.path() / "made.gltf", NormalMode::file, {});
        notes += joinedNotes(file.notes);
        return file.materials.at(0).colorImage;
    };
    const auto beside = colorsOf({{"uri", "a%20b.png"}}, ""),
               embedded = colorsOf({{"uri", "data:image/png;base64," + base64(fourColors())}}, ""),
               inBuffer = colorsOf({{"mimeType", "image/png"}}, fourColors());
    EXPECT_EQ(notes, "");
    const auto misnamed = colorsOf({{"uri", "A%20B.PNG"}}, "");
    EXPECT_TRUE(contains(notes, "\"A%20B.PNG\" is not there; \"a b.png\" is read in its place")) << notes;
    ASSERT_TRUE(beside && embedded && inBuffer && misnamed);
    EXPECT_EQ(beside->at({0.25, 0.75}, false), vec3(1, 0, 0)) << "the first row is the upper one";
    EXPECT_EQ(beside->texels(), embedded->texels());
    EXPECT_EQ(beside->texels(), inBuffer->texels());
    EXPECT_EQ(beside->texels(), misnamed->texels());
}

TEST(GltfMaterials, UpperLeftIsUpperLeft) {
    MadeGltf made = textured();
    useImage(made, {{"bufferView", made.view(fourColors())}});
    Scene scene;
    const GltfFile file = made.parsed();
    scene.materials = file.materials;
    Object object;
    object.mesh = file.objects.at(0).mesh;
    object.partMaterials = file.objects[0].partMaterials;
    // glTF's (0.25, 0.25) is the centre of the first texel of the upper row: red.
    EXPECT_EQ(diffuseAt(scene, object, 0, {0.5, 0.25, 0.25}), vec3(1, 0, 0));
    EXPECT_EQ(diffuseAt(scene, object, 0, {0.0, 0.75, 0.25}), vec3(0, 1, 0)) << "(0.75, 0.25), the second of it";
}

TEST(GltfMaterials, TransformsOfTexturesScaleAndMove) {
    MadeGltf made = textured();
    Json& use = useImage(made, {{"bufferView", made.view(fourColors())}});
    made.json["textures"][0]["sampler"] = 0;
    made.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33071}}};
    use["extensions"]["KHR_texture_transform"] = {{"offset", {0.5, 0.25}}, {"scale", {2, 4}}};
    const Material material = materialOf(made);
    EXPECT_TRUE(material.colorPlacement.clamped);
    // At (u, v) of glTF the image is read at (0.5 + 2u, 0.25 + 4v), counted from the upper edge.
    const dvec2 place = material.colorPlacement.at({0.1, 1 - 0.1}); // (0.1, 0.1), as the mesh holds it
    EXPECT_NEAR(place.x, 0.7, 1e-12);
    EXPECT_NEAR(1 - place.y, 0.65, 1e-12);
    use["extensions"]["KHR_texture_transform"]["rotation"] = 0.5;
    EXPECT_TRUE(contains(joinedNotes(made.parsed().notes), "is scaled and moved, but not turned"));
}

TEST(GltfMaterials, TheSetOfCoordinatesThatTheTextureNames) {
    MadeGltf made = textured();
    made.primitive()["attributes"]["TEXCOORD_1"] = made.add<float>({0.5f, 0.5f, 1, 1, 0.25f, 0}, 5126, "VEC2", 3);
    Json& use = useImage(made, {{"bufferView", made.view(fourColors())}});
    EXPECT_EQ(made.parsed().objects.at(0).mesh->texcoords.at(0), vec2(0, 1));
    use["texCoord"] = 1;
    EXPECT_EQ(made.parsed().objects.at(0).mesh->texcoords.at(0), vec2(0.5f, 0.5f));
    use["texCoord"] = 2;
    const GltfFile none = made.parsed();
    EXPECT_FALSE(none.objects.at(0).mesh->parts.at(0).hasTexcoords);
    EXPECT_TRUE(contains(joinedNotes(none.notes), "no texture coordinates for the image")) << joinedNotes(none.notes);
}

TEST(GltfMaterials, MasksCutWhereAlphaIsBelowTheCutoff) {
    const std::string alphas = png(4, 1, {{9, 9, 9, 0}, {9, 9, 9, 60}, {9, 9, 9, 128}, {9, 9, 9, 255}}, false);
    const auto holes = [&](double cutoff, double factor, const char* mode) {
        MadeGltf made = textured();
        useImage(made, {{"bufferView", made.view(alphas)}});
        made.material()["alphaMode"] = mode;
        if (cutoff >= 0) made.material()["alphaCutoff"] = cutoff;
        made.material()["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, factor};
        const Material material = materialOf(made);
        std::string found;
        for (int texel = 0; texel < 4; ++texel)
            found += material.alphaMask && material.alphaMask->isHole({(texel + 0.5) / 4, 0.5}, false) ? 'o' : '#';
        return found;
    };
    EXPECT_EQ(holes(-1, 1, "MASK"), "oo##") << "one half, where none is given";
    EXPECT_EQ(holes(0.2, 1, "MASK"), "o###") << "60 of 255 is 0.235";
    EXPECT_EQ(holes(0.9, 1, "MASK"), "ooo#");
    EXPECT_EQ(holes(0.2, 0.5, "MASK"), "oo##") << "half of 0.235 is less than 0.2";
    EXPECT_EQ(holes(0.2, 1, "OPAQUE"), "####");
    EXPECT_EQ(holes(0.2, 1, "BLEND"), "oo##") << "at one half, with a note";
}

TEST(GltfMaterials, AConstantAlphaIsTransparencyOrNothing) {
    MadeGltf made;
    made.material()["alphaMode"] = "BLEND";
    made.material()["pbrMetallicRoughness"] = {{"baseColorFactor", {1, 1, 1, 0.25}}, {"metallicFactor", 0}};
    EXPECT_EQ(materialOf(made).transparency, 0.75);
    EXPECT_EQ(materialOf(made).ior, 1);
    made.addNode({{"mesh", 1}});
    made.json["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}});
    made.material()["alphaMode"] = "MASK";
    const GltfFile file = made.parsed();
    EXPECT_EQ(file.objects.size(), 1u) << "what is a hole all over is left out";
    EXPECT_TRUE(contains(joinedNotes(file.notes), "its alpha is less than its cutoff everywhere")) << joinedNotes(file.notes);
}

TEST(GltfMaterials, ImagesOfMetalAndEmissionCountWithTheirMean) {
    MadeGltf made = textured();
    // Roughness is in green, metal in blue: means 0.4 and 0.2.
    useImage(made, {{"bufferView", made.view(png(2, 1, {{0, 51, 0, 255}, {0, 153, 102, 255}}))}});
    Json& material = made.material();
    material["pbrMetallicRoughness"] = {{"metallicRoughnessTexture", {{"index", 0}}}, {"baseColorFactor", {0.5, 0.5, 0.5, 1}}};
    const Material mean = materialOf(made);
    EXPECT_NEAR(mean.shininess, 2 / std::pow(0.4, 4) - 2, 1e-4) << "a few roundings of numbers about 76";
    expectNear(mean.diffuse, vec3(static_cast<float>(0.5 * (1 - 0.2 * (1 - 0.16)))), kFloat, "base (1 - m (1 - alpha))");
    material["emissiveFactor"] = {1, 1, 1};
    material["emissiveTexture"] = {{"index", 0}};
    expectNear(materialOf(made).emission,
               vec3(0, (image::linearFromSrgb(51) + image::linearFromSrgb(153)) / 2, image::linearFromSrgb(102) / 2), kFloat,
               "linear light");
    const std::string notes = joinedNotes(made.parsed().notes);
    EXPECT_TRUE(contains(notes, "the image of metal and roughness counts with its mean")) << notes;
    EXPECT_TRUE(contains(notes, "the image of its emission counts with its mean colour")) << notes;
}

TEST(GltfMaterials, ImagesThatCannotBeShownAreNoted) {
    const auto notesOn = [](const Json& image, const std::string& held = "") {
        MadeGltf made = textured();
        Json where = image;
        if (!held.empty()) where["bufferView"] = made.view(held);
        useImage(made, where);
        const GltfFile file = made.parsed();
        EXPECT_EQ(file.objects.size(), 1u);
        EXPECT_EQ(file.materials.at(0).colorImage, nullptr);
        return joinedNotes(file.notes);
    };
    EXPECT_TRUE(contains(notesOn({}, "RIFF....WEBPVP8 "), "images[0]: is left out: it is a WebP image"));
    EXPECT_TRUE(contains(notesOn({}, "\xabKTX 20\xbb\r\n\x1a\n0123"), "it is a KTX2 image"));
    EXPECT_TRUE(contains(notesOn({}, "rubbish"), "images[0]: is left out: it is neither PNG nor JPEG"));
    EXPECT_TRUE(contains(notesOn({{"uri", "none.png"}}), "images[0]: is left out: \"none.png\" cannot be read: No such file"));
    EXPECT_TRUE(contains(notesOn({{"uri", "http://x.org/a.png"}}), "is an address"));
    EXPECT_TRUE(contains(notesOn({{"uri", "data:image/png;base64,*"}}), "not well-formed base64"));
    EXPECT_TRUE(contains(notesOn({{"name", "nothing"}}), "neither a uri nor a bufferView"));
    MadeGltf made = textured();
    useImage(made, {{"bufferView", made.view(fourColors())}});
    made.json["textures"][0] = {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}};
    EXPECT_TRUE(contains(joinedNotes(made.parsed().notes), "a KTX2 image is left out")) << joinedNotes(made.parsed().notes);
}

} // namespace
} // namespace shadowlab::scene
