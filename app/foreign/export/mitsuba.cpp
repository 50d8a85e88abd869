// For Mitsuba 3: a scene in XML, a PLY file for each mesh, and a script that asks Mitsuba's rays for visibility. Mitsuba takes its
// samples anywhere in a pixel and cannot leave shadows out, so its pictures are not judged; the rays of the script go through pixel centres.
// SPDX-License-Identifier: MIT
#include <bit>
#include <set>
#include <utility>

#include "app/drawing/markup.h"
#include "app/foreign/export/format.h"
#include "app/foreign/export/left_out.h"
#include "app/foreign/export/light_words.h"
#include "app/foreign/export/numbers.h"
#include "app/foreign/export/plain_scene_json.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab::foreign {

namespace {

void appendBytes(std::string& file, const void* bytes, std::size_t count) { file.append(static_cast<const char*>(bytes), count); }

/// PLY, binary: positions, normals and places in an image, then triangles. Row 0 of Mitsuba's images is at v = 0.
std::string plyFile(const PlainMesh& mesh) {
    static_assert(std::endian::native == std::endian::little, "PLY is written as the numbers lie in memory");
    const bool hasPlaces = !mesh.texcoords.empty();
    std::string file = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.positions.size()) + "\n";
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
        file += std::string("property float ") + name + "\n";
    if (hasPlaces) file += "property float u\nproperty float v\n";
    file += "element face " + std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        appendBytes(file, &mesh.positions[i], sizeof(vec3));
        appendBytes(file, &mesh.normals[i], sizeof(vec3));
        const vec2 place = hasPlaces ? vec2(mesh.texcoords[i].x, 1 - mesh.texcoords[i].y) : vec2(0);
        if (hasPlaces) appendBytes(file, &place, sizeof(vec2));
    }
    for (const uvec3& triangle : mesh.triangles) {
        file += '\3';
        appendBytes(file, &triangle, sizeof(uvec3));
    }
    return file;
}

std::string rgb(const std::string& name, const dvec3& color) { return "<rgb name=\"" + name + "\" value=\"" + text(color) + "\"/>"; }
std::string number(const std::string& name, double value) { return "<float name=\"" + name + "\" value=\"" + text(value) + "\"/>"; }
std::string lookAt(const dvec3& origin, const dvec3& target, const dvec3& up) {
    return "<transform name=\"to_world\"><lookat origin=\"" + text(origin) + "\" target=\"" + text(target) + "\" up=\"" + text(up) + "\"/></transform>";
}
std::string namedComment(const std::string& name) {
    std::string words = drawing::escapedMarkup(name);
    for (std::size_t at = words.find("--"); at != std::string::npos; at = words.find("--"))
        words.replace(at, 2, "- "); // no comment holds two of them
    return "  <!-- " + words + " -->\n";
}

std::string sensorText(const ExportJob& job) {
    const PlainEye& eye = job.scene.eye;
    return "  <default name=\"width\" value=\"" + std::to_string(job.size.x) + "\"/>\n  <default name=\"height\" value=\"" + std::to_string(job.size.y) +
           "\"/>\n  <default name=\"spp\" value=\"64\"/>\n  <sensor type=\"perspective\">\n    " + lookAt(eye.position, eye.position - eye.back, eye.up) +
           "\n    " + number("fov", eye.fovYDegrees) + "<string name=\"fov_axis\" value=\"y\"/>\n    " + number("near_clip", eye.near) +
           number("far_clip", eye.far) +
           "\n    <sampler type=\"independent\"><integer name=\"sample_count\" value=\"$spp\"/></sampler>\n"
           "    <film type=\"hdrfilm\"><integer name=\"width\" value=\"$width\"/><integer name=\"height\" value=\"$height\"/><rfilter type=\"box\"/></film>\n"
           "  </sensor>\n";
}

std::string emitterText(const scene::Light& light) {
    const dvec3 strength = dvec3(light.color) * light.intensity;
    const std::string start = namedComment(light.name) + "  <emitter type=\"";
    const dvec3 aside = std::abs(light.directionWorld.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
    switch (light.type) {
    case scene::LightType::directional:
        return start + "directional\"><vector name=\"direction\" value=\"" + text(light.directionWorld) + "\"/>" + rgb("irradiance", strength) + "</emitter>\n";
    case scene::LightType::spot:
        return start + "spot\">" + lookAt(light.positionWorld, light.positionWorld + light.directionWorld, aside) + rgb("intensity", strength) +
               number("cutoff_angle", light.coneDegrees / 2) + number("beam_width", light.coneDegrees / 2 - light.edgeDegrees) + "</emitter>\n";
    case scene::LightType::point:
        return start + "point\"><point name=\"position\" value=\"" + text(light.positionWorld) + "\"/>" + rgb("intensity", strength) + "</emitter>\n";
    case scene::LightType::rect:
    case scene::LightType::sphere: break; // their surfaces are among the meshes
    }
    return "";
}

/// The file of an image's holes, beside its own: "textures/leaf.png" has "textures/leaf-holes.png".
std::string holesFile(std::string file) {
    file.insert(file.size() - 4, "-holes"); // before ".png"
    return file;
}

std::string bitmap(const std::string& name, const PlainMaterial& plain, const PlainScene& scene, bool isMask) {
    std::string file = scene.images[static_cast<std::size_t>(plain.image)].file;
    if (isMask) file = holesFile(std::move(file));
    return "<texture type=\"bitmap\" name=\"" + name + "\"><string name=\"filename\" value=\"" + file + "\"/><string name=\"wrap_mode\" value=\"" +
           (plain.clamped ? "clamp" : "repeat") + "\"/>" +
           (isMask ? "<string name=\"filter_type\" value=\"nearest\"/><boolean name=\"raw\" value=\"true\"/>" : "") + "</texture>";
}

std::string bsdfText(const PlainMaterial& plain, const PlainScene& scene) {
    const scene::Material& m = plain.values;
    std::string dull = "<bsdf type=\"diffuse\">" +
                       (plain.hasColors ? bitmap("reflectance", plain, scene, false) : rgb("reflectance", dvec3(m.diffuse))) + "</bsdf>";
    if (isGlass(plain)) return "<bsdf type=\"dielectric\">" + number("int_ior", m.ior) + number("ext_ior", 1) + "</bsdf>";
    if (isMirror(plain))
        dull = "<bsdf type=\"blendbsdf\">" + number("weight", m.reflectivity) + dull +
               "<bsdf type=\"conductor\"><string name=\"material\" value=\"none\"/></bsdf></bsdf>";
    dull = "<bsdf type=\"twosided\">" + dull + "</bsdf>";
    if (plain.hasHoles) dull = "<bsdf type=\"mask\">" + bitmap("opacity", plain, scene, true) + dull + "</bsdf>";
    return dull;
}

std::string shapeText(const ExportJob& job, std::size_t index) {
    const PlainMesh& mesh = job.scene.meshes[index];
    const PlainMaterial& material = job.scene.materials[mesh.material];
    const std::string shines_ =
        shines(material) ? "<emitter type=\"area\">" + rgb("radiance", dvec3(material.values.emission)) + "</emitter>" : "";
    return namedComment(mesh.name) + "  <shape type=\"ply\"><string name=\"filename\" value=\"" + meshFile(job.stem, index) + "\"/>" +
           bsdfText(material, job.scene) + shines_ + "</shape>\n";
}

bool needsPaths(const PlainScene& scene) {
    for (const PlainMaterial& material : scene.materials)
        if (isMirror(material) || isGlass(material)) return true;
    return false;
}

/// Mitsuba reads no alpha: holes are pictures of their own, black where there is a hole.
void writeMasks(const ExportJob& job) {
    std::set<int> images; // several materials may share one
    for (const PlainMaterial& material : job.scene.materials)
        if (material.hasHoles) images.insert(material.image);
    for (const int index : images) {
        PlainImage mask = job.scene.images[static_cast<std::size_t>(index)];
        mask.file = holesFile(std::move(mask.file));
        for (std::size_t at = 0; at < mask.image.rgba.size(); at += image::kChannels) {
            for (std::size_t c = 0; c < 3; ++c)
                mask.image.rgba[at + c] = mask.image.rgba[at + 3];
            mask.image.rgba[at + 3] = 255;
        }
        image::writeWhole(job.folder / mask.file, image::encodePng(mask.image));
    }
}

void writeMitsuba(const ExportJob& job) {
    std::string xml = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<scene version=\"3.0.0\">\n  <integrator type=\"" +
                      std::string(needsPaths(job.scene) ? "path\"><integer name=\"max_depth\" value=\"12\"/></integrator>\n" : "direct\"/>\n") + sensorText(job);
    for (const scene::Light& light : job.scene.lights)
        xml += emitterText(light);
    image::makeFolders(job.folder / "meshes");
    for (std::size_t i = 0; i < job.scene.meshes.size(); ++i) {
        xml += shapeText(job, i);
        image::writeWhole(job.folder / meshFile(job.stem, i), plyFile(job.scene.meshes[i]));
    }
    writeImages(job);
    writeMasks(job);
    image::writeWhole(job.folder / (job.stem + ".xml"), xml + "</scene>\n");
    if (job.scene.lights.empty()) return;
    std::string script = filledIn(templateText("mitsuba_visibility.py.in"), "FILE", "visibility.py");
    script = filledIn(std::move(script), "SCENE", plainSceneJson(job.scene, job.size, ImagesAs::files, MeshesAs::files));
    image::writeWhole(job.folder / "visibility.py", script);
}

std::vector<std::string> leftOutOfMitsuba(const PlainScene& scene) {
    LeftOut list(scene);
    list.add("pixel centres and pictures without shadows: a sample lies anywhere in its pixel. `visibility.py` asks for visibility itself");
    list.noAmbient();
    list.noBackground();
    list.noExposure();
    list.meshes([](const PlainMesh& mesh) { return !mesh.castsShadow; },
                "casts no shadow in the scene (`castsShadow`: false); in `scene.xml` it does, in `visibility.py` it does not");
    list.noReceivesShadow();
    list.soften("the soft edge of the cone falls off in a straight line");
    list.materials(shines, "lights other things, and from its front alone");
    list.materials(hasHighlight, "has no highlight");
    list.materials(isBlurred, "mirrors and glass are clear, rays are not spread");
    list.materials(isGlass, "mirrors by Fresnel's equations; nested media have no priority");
    if (needsPaths(scene)) list.add("that light is direct: because of mirrors or glass paths are followed, and diffuse surfaces light each other");
    list.materials([](const PlainMaterial& m) { return m.hasColors; }, "the colours of its image are not multiplied by the material's own");
    list.materials([](const PlainMaterial& m) { return m.hasHoles; }, "its holes are in `scene.xml`, but not in `visibility.py`");
    list.meshes([](const PlainMesh& mesh) { return !mesh.colors.empty(); }, "has no colours at its corners here");
    return list.take();
}

std::string howToMitsuba(const PlainScene& scene, ivec2 size) {
    const std::string pixels = " -D width=" + std::to_string(size.x) + " -D height=" + std::to_string(size.y);
    std::string text_ = "With Mitsuba 3 (`pip install mitsuba numpy`). These files are written after its documentation; no test of Shadowlab runs them.\n\n"
                        "    mitsuba" + pixels + " -o look.exr scene.xml\n    mitsuba" + pixels + " -o calibration.exr calibration.xml\n"
                        "    python3 -c 'import mitsuba as mi; mi.set_variant(\"scalar_rgb\"); mi.util.write_bitmap(\"calibration.png\", mi.Bitmap(\"calibration.exr\"))'\n";
    for (const std::string& light : lightWords(scene.lights))
        text_ += "    python3 visibility.py --light " + light + " --size " + std::to_string(size.x) + "x" + std::to_string(size.y) + " -o visibility-" +
                 light + ".png\n";
    return text_;
}

} // namespace

const Format kMitsuba{"mitsuba", "Mitsuba 3", "`scene.xml`, `calibration.xml` with `meshes/` and, for visibility, `visibility.py`",
                      "images of materials lie in `textures/`", false, writeMitsuba, leftOutOfMitsuba, howToMitsuba};

} // namespace shadowlab::foreign
