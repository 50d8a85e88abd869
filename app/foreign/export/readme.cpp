// SPDX-License-Identifier: MIT
#include "app/foreign/export/readme.h"

#include <algorithm>

#include "app/foreign/export/light_words.h"
#include "app/foreign/export/numbers.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::foreign {

namespace {

std::string sizeText(ivec2 size) { return std::to_string(size.x) + "x" + std::to_string(size.y); }

std::string eyeText(const PlainEye& eye, ivec2 size) {
    return "## The camera\n\n"
           "A pinhole. The world is right-handed, y points up. The eye looks along minus `back`; `right` and `up` are those of the picture.\n\n"
           "| | |\n|---|---|\n"
           "| position | " + text(eye.position) + " |\n"
           "| right | " + text(eye.right) + " |\n"
           "| up | " + text(eye.up) + " |\n"
           "| back | " + text(eye.back) + " |\n"
           "| full vertical angle | " + text(eye.fovYDegrees) + " degrees |\n"
           "| near plane | " + text(eye.near) + " m: nothing nearer is seen |\n\n"
           "Row 0 is at the top. Pixel (x, y) of a picture of W x H pixels has its centre at (x + 0.5, y + 0.5), counted from the upper left corner, and "
           "is what the ray through that centre meets: one sample, no filter. With t = tan(angle / 2) the ray goes along\n\n"
           "    right * t * W/H * (2 (x + 0.5) / W - 1) + up * t * (1 - 2 (y + 0.5) / H) - back\n\n"
           "The shape of the picture decides about the horizontal angle. The commands above draw " + sizeText(size) +
           "; the calibration board belongs to that size.\n\n";
}

/// A name in a table: signs that end a cell or a row are put otherwise.
std::string cell(const std::string& name) {
    std::string words;
    for (const char c : name)
        words += c == '|' ? "\\|" : std::string(1, static_cast<unsigned char>(c) < ' ' ? ' ' : c);
    return words;
}

std::string lightText(const scene::Light& light, const std::string& word) {
    std::string row = "| " + cell(light.name) + " | " + word + " | " + std::string(scene::toText(light.type)) + " | ";
    const dvec3 strength = dvec3(light.color) * light.intensity;
    row += light.type == scene::LightType::directional ? "from " + text(-light.directionWorld) : text(light.positionWorld);
    if (light.type == scene::LightType::spot)
        row += ", along " + text(light.directionWorld) + ", full cone " + text(light.coneDegrees) + " degrees, soft within " + text(light.edgeDegrees);
    if (light.type == scene::LightType::rect)
        row += ", edges " + text(light.edgeUWorld) + " and " + text(light.edgeVWorld) + ", shines along " + text(scene::rectNormalWorld(light));
    if (light.type == scene::LightType::sphere) row += ", radius " + text(light.radius);
    const char* unit = light.type == scene::LightType::directional ? "irradiance, W/m²"
                       : scene::hasArea(light)                     ? "radiance, W/(m² sr)"
                                                                   : "radiant intensity, W/sr";
    return row + " | " + text(strength) + " (" + unit + ") |\n";
}

std::string unitText(const PlainScene& plain) {
    std::string text_ = "## Units and colours\n\n"
                        "Metres. Colours and light are linear RGB with the primaries of sRGB; no photometric factor is in them. A white dull surface of "
                        "reflectance ρ under the irradiance E has the radiance ρ E / π. A picture is the radiance times the exposure (" +
                        text(plain.exposure) + "), cut at 1 and encoded as sRGB; ambient light adds " + text(plain.ambient) +
                        " times the reflectance everywhere; the background is " + text(plain.background) + ".\n\n";
    if (plain.originWorld != dvec3(0))
        text_ += "The scene lies far from the origin, where single precision is coarse. So " + text(plain.originWorld) +
                 " has been subtracted from all positions.\n\n";
    text_ += "| light | in names of files | kind | where | red, green, blue |\n|---|---|---|---|---|\n";
    const std::vector<std::string> words = lightWords(plain.lights);
    for (std::size_t i = 0; i < words.size(); ++i)
        text_ += lightText(plain.lights[i], words[i]);
    return text_ + "\n";
}

std::string judgeText(const Format& format, const PlainScene& plain, const std::string& scene) {
    if (plain.lights.empty()) return "";
    const std::string option = lightOption(plain.lights.front().name) + (scene::hasArea(plain.lights.front()) ? " --by-centre" : "");
    const std::string word = lightWords(plain.lights).front();
    std::string text_ = "## How it is judged\n\n"
                        "Visibility is asked for one light at a time. A surface that the light shines on from behind, as the eye sees it, has none: that "
                        "is decided by the triangle, not by shading normals. In this folder:\n\n"
                        "    shadowlab judge visibility-" + word + ".png " + scene + option + " --calibration calibration.png\n";
    if (format.drawsUnshadowed)
        text_ += "    shadowlab judge shaded-" + word + ".png " + scene + option + " --reference unshadowed-" + word + ".png --calibration calibration.png\n\n"
                 "The first takes a picture that is white where the light is seen and black in shadow. The second takes one with the shadows of that light "
                 "alone, and beside it the same without: where it is darker, there is shadow. Neither is antialiased.\n\n";
    else
        text_ += "\nIt takes a picture that is white where the light is seen and black in shadow.\n\n";
    if (std::ranges::any_of(plain.lights, scene::hasArea))
        text_ += "Of a light with an area `judge` asks which share of the area is seen. The pictures above take such a light for a point at its centre: they "
                 "are judged with --by-centre.\n\n";
    return text_;
}

} // namespace

std::string readmeText(const Format& format, const PlainScene& plain, const std::string& scene, const std::string& command, ivec2 size) {
    std::uint64_t triangles = 0;
    for (const PlainMesh& mesh : plain.meshes)
        triangles += mesh.triangles.size();
    std::string text_ = "# " + plain.name + ", for " + std::string(format.program) + "\n\nMade by\n\n    " + command + "\n\n" +
                        std::string(format.files) + (plain.images.empty() ? "" : "; " + std::string(format.images)) + ". " + scene::counted(triangles, "triangle") + " in " +
                        scene::counted(plain.meshes.size(), "part") +
                        ", each in world coordinates, wound counter-clockwise as seen from its front, and seen from both sides. "
                        "`calibration` is a board of squares and greys for the same camera: by its picture size, orientation, pixel centres and the "
                        "encoding of light are checked before anything is judged. It shows a code of this camera, so that the board of another is refused. Behind "
                        "it all is black, whatever the program's background.\n\n";
    text_ += "## Making pictures\n\n" + format.howTo(plain, size) + "\n";
    text_ += judgeText(format, plain, scene) + eyeText(plain.eye, size) + unitText(plain);
    text_ += "## What is not said here\n\n";
    std::vector<std::string> missing = plain.lost;
    const std::vector<std::string> ofFormat = format.leftOut(plain);
    missing.insert(missing.end(), ofFormat.begin(), ofFormat.end());
    for (const std::string& sentence : missing)
        text_ += "- " + sentence + ".\n";
    if (missing.empty()) text_ += "Nothing of this scene is left out.\n";
    return text_;
}

} // namespace shadowlab::foreign
