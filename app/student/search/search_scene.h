// A scene as the search for a failing one keeps it: a few polygons of world space and lights, which can be taken away one by one, and
// written as files that every command reads.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::student {

struct SearchObject {
    std::string name, material = "ground"; ///< one of the materials in search_scene.cpp
    std::vector<dvec3> cornersWorld{};
    std::vector<uvec3> triangles{}; ///< counter-clockwise seen from their front
    bool castsShadow = true;
    bool isWhole = false; ///< taken away altogether or not at all: half of a floor is a strange sight
    bool isMirrored = false; ///< written as the mirror image, under a scale of -1
};

struct SearchLight {
    std::string name;
    bool isSun = false;
    dvec3 place{0.0}; ///< of a lamp, in world space; of the sun the way that its light travels
    double intensity = 1;
};

struct SearchScene {
    dvec3 eyeWorld{0, 2, 6}, targetWorld{0.0};
    double fovYDegrees = 45;
    bool isRoom = false; ///< dark but for what shines in it: without ambient light, before a black background
    double background = 0.3;
    std::vector<SearchLight> lights;
    std::vector<SearchObject> objects;
};

int triangleCount(const SearchScene& scene);

/// Without vertices that no triangle has, without objects that have no triangles.
SearchScene tidied(SearchScene scene);

/// Names of files and their texts: STEM.json, and a STEM-OBJECT.obj for each object. `comment`: the first line of the scene.
std::map<std::string, std::string> filesOf(const SearchScene& scene, const std::string& stem, const std::string& comment);

} // namespace shadowlab::student
