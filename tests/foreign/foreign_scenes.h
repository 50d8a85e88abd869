// Scenes for a renderer that shares no code with the program, and the files that the program reads the same scenes from.
// Nothing of the program is used: vectors, shapes and numbers are its own.
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace foreign_renderer {

struct Vec {
    double x = 0, y = 0, z = 0;
};
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(Vec a) { return std::sqrt(dot(a, a)); }
inline Vec unit(Vec a) { return (1 / length(a)) * a; }

struct Tri {
    Vec a, b, c; ///< counter-clockwise from the front
    int thing = 0;
};

struct Thing {
    std::string name;
    bool closed = true;
    double albedo = 0.8;
};

struct Scene {
    std::string name;
    Vec eye, target{0, 0, 0}, up{0, 1, 0};
    double fovYDegrees = 40;
    Vec light;                ///< place, or of a sun the way its light travels
    bool isSun = false;
    double intensity = 10, ambient = 0.1;
    std::vector<Thing> things;
    std::vector<Tri> triangles;
};

/// Each has closed casters, an open sheet that turns its back to the light, and one that turns its front to it.
std::vector<Scene> scenes();

/// The scene for the program: "scene.json", and an OBJ file for each thing.
std::map<std::string, std::string> filesOf(const Scene& scene);

} // namespace foreign_renderer
