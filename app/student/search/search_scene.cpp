// SPDX-License-Identifier: MIT
#include "app/student/search/search_scene.h"

#include <array>
#include <limits>
#include <set>
#include <string_view>

#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::student {

namespace {

struct NamedMaterial {
    std::string_view name, text;
};

constexpr std::array kMaterials = std::to_array<NamedMaterial>({
    {"ground", R"("diffuse": [0.68, 0.66, 0.63])"},
    {"accent", R"("diffuse": [0.68, 0.17, 0.04])"},
    {"blue", R"("diffuse": [0.05, 0.2, 0.42])"},
    {"mirror", R"("diffuse": [0.02, 0.02, 0.02], "reflectivity": 0.8)"},
    {"glass", R"("diffuse": [0, 0, 0], "reflectivity": 0.1, "transparency": 0.9, "ior": 1.5)"},
    {"clear", R"("diffuse": [0, 0, 0], "transparency": 1, "ior": 1.5)"},
    {"black", R"("diffuse": [0, 0, 0])"},
    {"shining", R"("diffuse": [0, 0, 0], "emission": [2.4, 2.4, 2.4])"},
    {"glowing", R"("diffuse": [0.5, 0.6, 0.7], "emission": [0.6, 0.48, 0.36], "emits": "both")"},
});

std::string text(double number) { return scene::numberText(number + 0.0); } // not -0
std::string text(const dvec3& v, std::string_view between) {
    return text(v.x) + std::string(between) + text(v.y) + std::string(between) + text(v.z);
}
std::string list(const dvec3& v) { return "[" + text(v, ", ") + "]"; }

std::string meshText(const SearchObject& object) {
    std::string obj;
    const double side = object.isMirrored ? -1 : 1;
    for (const dvec3& corner : object.cornersWorld)
        obj += "v " + text({side * corner.x, corner.y, corner.z}, " ") + "\n";
    for (const uvec3& t : object.triangles)
        obj += "f " + std::to_string(t.x + 1) + " " + std::to_string((object.isMirrored ? t.z : t.y) + 1) + " " +
               std::to_string((object.isMirrored ? t.y : t.z) + 1) + "\n";
    return obj;
}

std::string lightText(const SearchLight& light) {
    return "{\"name\": \"" + light.name + "\", \"type\": " + (light.isSun ? "\"directional\", \"direction\": " : "\"point\", \"position\": ") +
           list(light.place) + ", \"intensity\": " + text(light.intensity) + "}";
}

/// "a,\n    b" between brackets.
std::string block(const std::vector<std::string>& lines, char open, char close) {
    std::string all(1, open);
    for (const std::string& line : lines)
        all += (all.size() > 1 ? ",\n    " : "\n    ") + line;
    return all + (lines.empty() ? "" : "\n  ") + close;
}

} // namespace

int triangleCount(const SearchScene& scene) {
    std::size_t count = 0;
    for (const SearchObject& object : scene.objects)
        count += object.triangles.size();
    return static_cast<int>(count);
}

SearchScene tidied(SearchScene scene) {
    std::erase_if(scene.objects, [](const SearchObject& object) { return object.triangles.empty(); });
    constexpr unsigned kUnused = std::numeric_limits<unsigned>::max();
    for (SearchObject& object : scene.objects) {
        std::vector<unsigned> newIndex(object.cornersWorld.size(), kUnused);
        std::vector<dvec3> used;
        for (uvec3& triangle : object.triangles)
            for (int i = 0; i < 3; ++i) {
                unsigned& index = newIndex[triangle[i]];
                if (index == kUnused) {
                    index = static_cast<unsigned>(used.size());
                    used.push_back(object.cornersWorld[triangle[i]]);
                }
                triangle[i] = index;
            }
        object.cornersWorld = std::move(used);
    }
    return scene;
}

std::map<std::string, std::string> filesOf(const SearchScene& scene, const std::string& stem, const std::string& comment) {
    std::map<std::string, std::string> files;
    std::vector<std::string> lights, materials, objects;
    std::set<std::string> used;
    for (const SearchLight& light : scene.lights)
        lights.push_back(lightText(light));
    for (const SearchObject& object : scene.objects) {
        const std::string mesh = stem + "-" + object.name + ".obj";
        files.emplace(mesh, meshText(object));
        used.insert(object.material);
        objects.push_back("{\"name\": \"" + object.name + "\", \"mesh\": \"" + mesh + "\", \"material\": \"" + object.material + "\"" +
                          (object.castsShadow ? "" : ", \"castsShadow\": false") + (object.isMirrored ? ", \"scale\": [-1, 1, 1]" : "") + "}");
    }
    for (const NamedMaterial& material : kMaterials)
        if (used.contains(std::string(material.name)))
            materials.push_back("\"" + std::string(material.name) + "\": {" + std::string(material.text) + "}");
    const dvec3 ambient = scene.isRoom ? dvec3(0.0) : dvec3(0.08, 0.08, 0.09);
    files.emplace(stem + ".json", "// " + comment + "\n{\n  \"camera\": {\"position\": " + list(scene.eyeWorld) + ", \"target\": " +
                                      list(scene.targetWorld) + ", \"fovYDegrees\": " + text(scene.fovYDegrees) +
                                      "},\n  \"ambient\": " + list(ambient) + ",\n  \"background\": " +
                                      list(dvec3(scene.background)) + ",\n  \"lights\": " +
                                      block(lights, '[', ']') + ",\n  \"materials\": " + block(materials, '{', '}') +
                                      ",\n  \"objects\": " + block(objects, '[', ']') + "\n}\n");
    return files;
}

} // namespace shadowlab::student
