// SPDX-License-Identifier: MIT
#include "tests/foreign/foreign_scenes.h"

#include <cstdio>

namespace foreign_renderer {

namespace {

/// As it stands in the file and in the program: rounded to float once.
Vec rounded(Vec v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

int addThing(Scene& scene, const char* name, bool closed, double albedo) {
    scene.things.push_back({name, closed, albedo});
    return static_cast<int>(scene.things.size()) - 1;
}
void addTri(Scene& scene, int thing, Vec a, Vec b, Vec c) { scene.triangles.push_back({rounded(a), rounded(b), rounded(c), thing}); }
void addQuad(Scene& scene, int thing, Vec a, Vec b, Vec c, Vec d) {
    addTri(scene, thing, a, b, c);
    addTri(scene, thing, a, c, d);
}

/// Counter-clockwise seen from where cross(u, v) points.
void addSheet(Scene& scene, const char* name, Vec centre, Vec u, Vec v, double albedo = 0.7) {
    const int thing = addThing(scene, name, false, albedo);
    addQuad(scene, thing, centre - 0.5 * u - 0.5 * v, centre + 0.5 * u - 0.5 * v, centre + 0.5 * u + 0.5 * v, centre - 0.5 * u + 0.5 * v);
}

void addBox(Scene& scene, const char* name, Vec centre, Vec size, double turnDegrees, double albedo = 0.8) {
    const int thing = addThing(scene, name, true, albedo);
    const double angle = turnDegrees * 3.14159265358979 / 180;
    const auto corner = [&](int i) {
        const Vec p{(i & 1 ? 0.5 : -0.5) * size.x, (i & 2 ? 0.5 : -0.5) * size.y, (i & 4 ? 0.5 : -0.5) * size.z};
        return centre + Vec{p.x * std::cos(angle) + p.z * std::sin(angle), p.y, -p.x * std::sin(angle) + p.z * std::cos(angle)};
    };
    const int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& face : faces)
        addQuad(scene, thing, corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3]));
}

void addBall(Scene& scene, const char* name, Vec centre, double radius, int around) {
    const int thing = addThing(scene, name, true, 0.75);
    const int bands = around / 2;
    const auto at = [&](int band, int i) {
        const double polar = 3.14159265358979 * band / bands, angle = 2 * 3.14159265358979 * (i % around) / around;
        if (band == 0) return centre + Vec{0, radius, 0};
        if (band == bands) return centre - Vec{0, radius, 0};
        return centre + radius * Vec{std::sin(polar) * std::cos(angle), std::cos(polar), -std::sin(polar) * std::sin(angle)};
    };
    for (int band = 0; band < bands; ++band)
        for (int i = 0; i < around; ++i) {
            if (band > 0) addTri(scene, thing, at(band, i), at(band + 1, i + 1), at(band, i + 1));
            if (band + 1 < bands) addTri(scene, thing, at(band, i), at(band + 1, i), at(band + 1, i + 1));
        }
}

Scene blocks() {
    Scene scene{"blocks", {0.9, 0.95, 1.6}, {0, 0.12, 0}};
    scene.light = {-0.8, 1.5, 0.7};
    addSheet(scene, "floor", {0, 0, 0}, {0, 0, 5}, {5, 0, 0});
    addBox(scene, "block", {-0.25, 0.15, 0.1}, {0.25, 0.3, 0.25}, 25);
    addBox(scene, "plank", {0.3, 0.42, -0.2}, {0.5, 0.04, 0.16}, -20);
    addBox(scene, "post", {0.3, 0.2, -0.2}, {0.05, 0.4, 0.05}, 10);
    addSheet(scene, "card", {0.15, 0.2, 0.4}, {0.02, 0, 0.3}, {0, 0.34, 0.03}); // turns its front to the light
    addSheet(scene, "back card", {-0.15, 0.22, -0.4}, {0.35, 0, 0.1}, {0.02, -0.4, 0}); // and this one its back
    return scene;
}

Scene canopy() {
    Scene scene{"canopy", {0.2, 0.8, 2.4}, {0.1, 0.35, -0.6}};
    scene.light = {0.5, -1, -0.3};
    scene.isSun = true;
    scene.intensity = 2;
    addSheet(scene, "ground", {0, 0, 0}, {0, 0, 9}, {9, 0, 0});
    addBox(scene, "roof", {-0.5, 1.55, 2.55}, {2.2, 0.08, 1.6}, 0);
    addBox(scene, "wall", {-0.65, 0.25, -0.5}, {0.12, 0.5, 0.9}, 15);
    addBox(scene, "fence", {0.35, 0.06, 0.2}, {0.02, 0.12, 0.8}, -10);
    addBall(scene, "ball", {0.35, 0.3, -0.5}, 0.22, 16);
    addSheet(scene, "flag", {0.05, 0.75, -0.9}, {0.5, 0, 0.1}, {0, -0.35, 0.02});
    addSheet(scene, "sign", {0.85, 0.4, -0.2}, {0.1, 0, 0.3}, {0, -0.4, 0.05});
    addSheet(scene, "awning", {-0.2, 0.95, -0.3}, {0.4, 0.05, 0}, {0, 0.05, 0.45});
    return scene;
}

Scene stairs() {
    Scene scene{"stairs", {-1.3, 1.2, 1.5}, {0.1, 0.2, -0.1}};
    scene.light = {0.9, 1.7, 0.9};
    scene.intensity = 14;
    addSheet(scene, "floor", {0, 0, 0}, {0, 0, 5}, {5, 0, 0}, 0.6);
    addBox(scene, "step 1", {0, 0.05, -0.4}, {1.0, 0.1, 0.6}, 0);
    addBox(scene, "step 2", {0, 0.15, -0.5}, {1.0, 0.1, 0.4}, 0, 0.7);
    addBox(scene, "step 3", {0, 0.25, -0.6}, {1.0, 0.1, 0.2}, 0);
    addBall(scene, "ball", {0.2, 0.35, 0.2}, 0.16, 20);
    addSheet(scene, "leaf", {-0.25, 0.45, 0.1}, {0.3, 0.1, 0}, {0, 0.05, -0.3});   // its front upward, to the light
    addSheet(scene, "petal", {0.35, 0.6, -0.3}, {0.3, 0.05, 0.05}, {0, 0.1, 0.35}); // its back
    return scene;
}

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}
std::string list(Vec v) { return "[" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + "]"; }

} // namespace

std::vector<Scene> scenes() { return {blocks(), canopy(), stairs()}; }

std::map<std::string, std::string> filesOf(const Scene& scene) {
    std::map<std::string, std::string> files;
    std::string objects, materials;
    for (std::size_t i = 0; i < scene.things.size(); ++i) {
        std::string obj;
        int vertices = 0;
        for (const Tri& tri : scene.triangles) {
            if (tri.thing != static_cast<int>(i)) continue;
            for (const Vec& corner : {tri.a, tri.b, tri.c})
                obj += "v " + number(corner.x) + " " + number(corner.y) + " " + number(corner.z) + "\n";
            obj += "f " + std::to_string(vertices + 1) + " " + std::to_string(vertices + 2) + " " + std::to_string(vertices + 3) + "\n";
            vertices += 3;
        }
        const std::string file = "thing" + std::to_string(i) + ".obj";
        files[file] = obj;
        materials += (i ? ", " : "") + ("\"m" + std::to_string(i)) + "\": {\"diffuse\": " + list({scene.things[i].albedo, scene.things[i].albedo, scene.things[i].albedo}) + "}";
        objects += std::string(i ? ",\n" : "") + "{\"name\": \"" + scene.things[i].name + "\", \"mesh\": \"" + file + "\", \"material\": \"m" + std::to_string(i) + "\"}";
    }
    const std::string light = scene.isSun ? "\"type\": \"directional\", \"direction\": " : "\"type\": \"point\", \"position\": ";
    files["scene.json"] = "{\"camera\": {\"position\": " + list(scene.eye) + ", \"target\": " + list(scene.target) + ", \"fovYDegrees\": " + number(scene.fovYDegrees) +
                          ", \"near\": 0.05},\n\"ambient\": " + list({scene.ambient, scene.ambient, scene.ambient}) + ",\n\"lights\": [{\"name\": \"key\", " + light + list(scene.light) +
                          ", \"intensity\": " + number(scene.intensity) + "}],\n\"materials\": {" + materials + "},\n\"objects\": [" + objects + "]}\n";
    return files;
}

} // namespace foreign_renderer
