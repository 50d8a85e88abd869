// For POV-Ray: one file in its scene language. What kind of picture, and of which light, are variables that the command line declares.
//
// POV-Ray's world is left-handed by habit alone: its camera takes the vectors that it is given, so right, up and direction are those of
// the scene and nothing is mirrored.
//
// Numbers are metres, and each length is multiplied by Metre, so that POV-Ray's unit is a centimetre. Its shadow rays pass over what stands
// nearer than a thousandth of its unit (3.7.0.10: 0.00099 is passed over, 0.00101 is not). Were that a millimetre, one would see it
// where a shadow begins at its caster.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "app/foreign/export/format.h"
#include "app/foreign/export/left_out.h"
#include "app/foreign/export/light_words.h"
#include "app/foreign/export/numbers.h"
#include "techniques/foundation/image/output_file.h"

namespace shadowlab::foreign {

namespace {

/// How many of POV-Ray's units a metre has, and its name in the file.
constexpr double kUnitsPerMetre = 100;
const std::string kMetre = " * Metre";

std::string povVector(const dvec3& v) { return "<" + text(v) + ">"; }
std::string povVector(const vec3& v) { return "<" + text(v) + ">"; }
std::string povVector(const vec2& v) { return "<" + text(v.x) + ", " + text(v.y) + ">"; }

/// A comment of one line; names may hold anything.
std::string comment(const std::string& words) {
    std::string line = "// ";
    for (const char c : words)
        line += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    return line + "\n";
}

std::string povHeader(const ExportJob& job) {
    std::string list;
    for (std::size_t i = 0; i < job.scene.lights.size(); ++i)
        list += comment("  " + std::to_string(i + 1) + "  " + job.scene.lights[i].name);
    return comment(job.scene.name + ", written by Shadowlab for POV-Ray 3.7; README.md says how it is drawn.") +
           "// Declare=Picture=0  the scene as it is, by direct light\n"
           "//                 1  the same without mirrors and glass; of all lights one alone casts shadows\n"
           "//                 2  the same, and no light casts shadows\n"
           "//                 3  white where one light is seen, black in shadow, whatever the angle\n"
           "// Declare=Light=N    that one light, in pictures 1 to 3 the first where nothing is said; in picture 0 it shines alone, 0: all\n" +
           list +
           "#version 3.7;\n"
           "#ifndef (Picture) #declare Picture = 0; #end\n"
           "#ifndef (Light) #declare Light = 0; #end\n"
           "#declare White = (Picture = 3);\n"
           "#declare One = (Picture != 0 & Light = 0 ? 1 : Light);\n"
           "#macro Shines(Number) (One = 0 | One = Number | Picture = 1 | Picture = 2) #end\n"
           // A shadowless light has neither cone nor front. So the one keeps its kind, and in picture 2 objects cast nothing.
           "#macro Casts(Number) (Picture = 0 | Picture = 3 | One = Number) #end\n\n"
           "// Units in a metre. Shadow rays pass over what stands nearer than a thousandth of a unit: a hundredth of a millimetre here.\n"
           "#declare Metre = " + text(kUnitsPerMetre) + ";\n"
           "global_settings { assumed_gamma 1.0 ambient_light rgb 1 max_trace_level 12 }\n";
}

std::string povEye(const PlainScene& scene) {
    const PlainEye& eye = scene.eye;
    const std::string height = text(2 * std::tan(glm::radians(eye.fovYDegrees) / 2));
    return "#if (White) background { rgbt <0, 0, 0, 1> } #else background { rgb " + povVector(dvec3(scene.background) * double(scene.exposure)) +
           " } #end\n"
           "camera {\n  perspective\n  location " + povVector(eye.position) + kMetre + "\n  direction " + povVector(-eye.back) + "\n  right " +
           povVector(eye.right) + " * " + height + " * image_width / image_height\n  up " + povVector(eye.up) + " * " + height + "\n}\n\n";
}

/// A directional light comes from so far away that nothing lies behind its place.
dvec3 sunPlace(const PlainScene& scene, const scene::Light& light) {
    constexpr double kAway = 4;
    double reach = 0;
    for (const PlainMesh& mesh : scene.meshes)
        for (const vec3& position : mesh.positions)
            reach = std::max(reach, glm::length(dvec3(position) - scene.eye.position));
    return scene.eye.position - light.directionWorld * kAway * std::max(reach, 1.0);
}

std::string shapeOf(const scene::Light& light, const dvec3& place, bool isHard) {
    if (light.type == scene::LightType::directional) return " parallel point_at " + povVector(place + light.directionWorld) + kMetre;
    if (light.type == scene::LightType::spot) {
        const double half = light.coneDegrees / 2, full = isHard ? half : half - light.edgeDegrees;
        return " spotlight point_at " + povVector(place + light.directionWorld) + kMetre + " radius " + text(full) + " falloff " + text(half) + " tightness 0";
    }
    if (light.type == scene::LightType::rect) // to its front alone
        return " spotlight point_at " + povVector(place + scene::rectNormalWorld(light)) + kMetre + " radius 90 falloff 90 tightness " + (isHard ? "0" : "1"); // the cosine at the lamp
    return "";
}

std::string areaOf(const scene::Light& light) {
    if (light.type == scene::LightType::rect)
        return " area_light " + povVector(light.edgeUWorld) + kMetre + ", " + povVector(light.edgeVWorld) + kMetre + ", 9, 9 adaptive 2 jitter";
    if (light.type != scene::LightType::sphere) return "";
    const std::string across = text(2 * light.radius);
    return " area_light <" + across + ", 0, 0>" + kMetre + ", <0, " + across + ", 0>" + kMetre + ", 9, 9 adaptive 2 jitter circular orient";
}

std::string povLight(const PlainScene& scene, std::size_t index) {
    // POV-Ray weakens a light by 2 / (1 + (d / f)^2) at the distance d. With f this small, in metres, that is 2 f^2 / d^2.
    constexpr double kFade = 1e-3;
    const scene::Light& light = scene.lights[index];
    const bool isSun = light.type == scene::LightType::directional;
    const dvec3 place = isSun ? sunPlace(scene, light) : light.positionWorld;
    // Its diffuse reflection knows no 1 / pi: it is in the light.
    const dvec3 color = dvec3(light.color) * scene::pointIntensity(light) * double(scene.exposure) / glm::pi<double>();
    const std::string start = "  light_source { " + povVector(place) + kMetre + ", rgb ";
    const std::string fade = isSun ? "" : " * " + text(0.5 / (kFade * kFade)) + " fade_distance " + text(kFade) + kMetre + " fade_power 2";
    const std::string number = std::to_string(index + 1), shadow = " #if (!Casts(" + number + ")) shadowless #end }\n";
    return comment(light.name) + "#if (Shines(" + number + "))\n#if (White)\n" + start + "1" + shapeOf(light, place, true) + shadow + "#else\n" + start +
           povVector(color) + fade + shapeOf(light, place, false) + (scene::hasArea(light) ? " #if (Picture = 0)" + areaOf(light) + " #end" : "") + shadow +
           "#end\n#end\n";
}

std::string imageText(const PlainMaterial& material, const PlainScene& scene) {
    return "png \"" + scene.images[static_cast<std::size_t>(material.image)].file + "\"" + (material.clamped ? " once" : "");
}

/// A texture of that body, and nothing where the material's image has holes.
std::string cutTexture(const PlainMaterial& material, const PlainScene& scene, const std::string& body) {
    if (!material.hasHoles) return "texture { " + body + " }";
    return "texture { uv_mapping image_pattern { " + imageText(material, scene) +
           " use_alpha } texture_map { [0.5 " + body + "] [0.5 pigment { rgbt 1 } finish { Clear }] } }";
}

/// White; the surface of the light that shines is turned away from its centre, or lies in one plane with it. `lamp`: whose surface it
/// is; -1: of none.
std::string whiteTexture(const PlainMaterial& material, const PlainScene& scene, int lamp) {
    const std::string white = lamp < 0 ? "1" : "#if (One = " + std::to_string(lamp + 1) + ") 0 #else 1 #end";
    return cutTexture(material, scene, "pigment { rgb " + white + " } finish { Flat }");
}

std::string pigmentText(const PlainMaterial& material, const PlainScene& scene) {
    const scene::Material& m = material.values;
    if (!material.hasColors) {
        const vec3 color = m.diffuse == vec3(0) ? vec3(1) : m.diffuse;
        return "pigment { rgbt <" + text(color) + ", " + (isGlass(material) ? "#if (Picture = 0) " + text(m.transparency) + " #else 0 #end" : "0") + "> }";
    }
    // Between texels next to a hole its alpha would count as well.
    return "pigment { uv_mapping image_map { " + imageText(material, scene) + " gamma srgb" + (material.hasHoles ? "" : " interpolate 2") + " } }";
}

std::string lookTexture(const PlainMaterial& material, const PlainScene& scene, bool isLamp) {
    const scene::Material& m = material.values;
    const auto exposure = double(scene.exposure);
    const bool isBlack = m.diffuse == vec3(0);
    // What does not depend on light is a share of the pigment, for each colour: ambient light is one already, emission is divided by it.
    dvec3 glow(0);
    for (int c = 0; c < 3; ++c) {
        const double pigment = isBlack ? 1 : double(m.diffuse[c]);
        if (!isBlack) glow[c] = double(scene.ambient[c]) * exposure;
        if (pigment > 0) glow[c] += double(m.emission[c]) * exposure / pigment;
    }
    std::string finish = "finish { ambient 0 emission rgb " + povVector(glow) + " diffuse " + (isBlack || isLamp ? "0" : "1");
    if (hasHighlight(material) && m.shininess > 0) // of their highlight the peak is the number, without the cosine
        finish += " specular " + text((m.specular.x + m.specular.y + m.specular.z) / 3 * (m.shininess + 8) / 8) + " roughness " + text(1 / m.shininess);
    if (isMirror(material)) finish += " #if (Picture = 0) reflection { " + text(m.reflectivity) + " } #end";
    return cutTexture(material, scene, pigmentText(material, scene) + " " + finish + " }");
}

std::string povMaterial(const PlainScene& scene, std::size_t index, int lamp) {
    const PlainMaterial& material = scene.materials[index];
    const std::string interior = isGlass(material) ? " interior { ior " + text(material.values.ior) + " }" : "";
    return comment(material.values.name) + "#if (White)\n#declare Material_" + std::to_string(index + 1) + " = material { " +
           whiteTexture(material, scene, lamp) + " }\n#else\n#declare Material_" + std::to_string(index + 1) + " = material { " +
           lookTexture(material, scene, lamp >= 0) + interior + " }\n#end\n";
}

template <typename Vector>
void appendBlock(std::string& text_, const char* name, const std::vector<Vector>& vectors) {
    text_ += std::string("  ") + name + " { " + std::to_string(vectors.size());
    for (const Vector& v : vectors)
        text_ += ",\n" + povVector(v);
    text_ += " }\n";
}

std::string povMesh(const PlainMesh& mesh) {
    std::string text_ = comment(mesh.name) + "mesh2 {\n";
    appendBlock(text_, "vertex_vectors", mesh.positions);
    text_ += "#if (!White)\n";
    appendBlock(text_, "normal_vectors", mesh.normals);
    text_ += "#end\n";
    if (!mesh.texcoords.empty()) appendBlock(text_, "uv_vectors", mesh.texcoords);
    text_ += "  face_indices { " + std::to_string(mesh.triangles.size());
    for (const uvec3& triangle : mesh.triangles)
        text_ += ",\n<" + std::to_string(triangle.x) + ", " + std::to_string(triangle.y) + ", " + std::to_string(triangle.z) + ">";
    return text_ + " }\n  material { Material_" + std::to_string(mesh.material + 1) + " }" + (mesh.castsShadow ? " #if (Picture = 2) no_shadow #end" : " no_shadow") + "\n  scale Metre\n}\n";
}

void writePov(const ExportJob& job) {
    const PlainScene& scene = job.scene;
    std::string file = povHeader(job) + povEye(scene);
    file += "#declare Clear = finish { ambient 0 emission 0 diffuse 0 }\n#declare Flat = finish { ambient 0 emission 0 diffuse 1 brilliance 0 }\n\n";
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        file += povLight(scene, i);
    std::vector<int> lampOf(scene.materials.size(), -1);
    for (const PlainMesh& mesh : scene.meshes)
        lampOf[mesh.material] = mesh.emitterOfLight;
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        file += povMaterial(scene, i, lampOf[i]);
    for (const PlainMesh& mesh : scene.meshes)
        file += povMesh(mesh);
    writeImages(job);
    image::writeWhole(job.folder / (job.stem + ".pov"), file);
}

std::vector<std::string> leftOutOfPov(const PlainScene& scene) {
    LeftOut list(scene);
    list.noReceivesShadow();
    list.noNear();
    const auto hasSide = [](const scene::Light& light) { return light.type == scene::LightType::spot || light.type == scene::LightType::rect; };
    if (scene.lights.size() > 1)
        list.lights(hasSide, "in pictures 1 and 2 of another light it shines to all sides, because a light that casts no shadow has no cone");
    list.soften("the soft edge of the cone falls off along another curve; in picture 3 the cone ends where it ends here");
    list.lights([](const scene::Light& light) { return scene::hasArea(light); },
                "in picture 0 its shadow has a penumbra, of 9 x 9 points; its strength falls off as that of a point at its centre");
    list.materials([](const PlainMaterial& m) { return shines(m) && m.values.emits == scene::EmittingSides::front; }, "shines from both sides");
    list.materials(hasHighlight, "the highlight has no colour and no cosine");
    list.materials(isBlurred, "mirrors and glass are clear, rays are not spread");
    list.materials(isGlass, "lets light through to what lies behind it, in picture 0; in the others it is solid");
    list.materials([](const PlainMaterial& m) { return m.clamped; }, "nothing is drawn beyond the border of its image, in place of its last texels");
    list.materials([](const PlainMaterial& m) { return m.hasColors; }, "the colours of its image are not multiplied by the material's own");
    list.meshes([](const PlainMesh& mesh) { return !mesh.colors.empty(); }, "has no colours at its corners here");
    return list.take();
}

std::string howToPov(const PlainScene& scene, ivec2 size) {
    const std::string start = "    povray +W" + std::to_string(size.x) + " +H" + std::to_string(size.y) + " -D -A +FN16 File_Gamma=srgb ";
    std::string text_ = "With POV-Ray 3.7 (tried with 3.7.0.10; `apt install povray`), in this folder:\n\n" + start + "+Iscene.pov +Olook.png\n" +
                        start + "+Icalibration.pov +Ocalibration.png\n";
    const std::vector<std::string> words = lightWords(scene.lights);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const std::string of = " Declare=Light=" + std::to_string(i + 1) + " ";
        text_ += start + "+Iscene.pov Declare=Picture=1" + of + "+Oshaded-" + words[i] + ".png\n";
        text_ += start + "+Iscene.pov Declare=Picture=2" + of + "+Ounshadowed-" + words[i] + ".png\n";
        text_ += start + "+UA +Iscene.pov Declare=Picture=3" + of + "+Ovisibility-" + words[i] + ".png\n";
    }
    return text_ + "\nPictures are sRGB with 16 bits a channel. `-A` leaves antialiasing out, so that each pixel is the ray through its centre. In "
                   "pictures 1 to 3 a light with an area is a point at its centre; in picture 3 normals are those of the triangles. "
                   "The file counts in metres and multiplies each length by `Metre`, 100 of POV-Ray's units, because its shadow rays pass over what stands "
                   "nearer than a thousandth of its unit.\n";
}

} // namespace

const Format kPov{"pov", "POV-Ray", "`scene.pov`, `calibration.pov`: scripts", "images of materials lie in `textures/`", true, writePov, leftOutOfPov, howToPov};

} // namespace shadowlab::foreign
