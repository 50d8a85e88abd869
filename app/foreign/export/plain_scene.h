// A scene as any renderer understands it: triangles in the world, materials, lights and a camera. No instances, no transforms, no
// mirrored meshes: each part of each object is a list of triangles of its own, wound counter-clockwise as seen from its front.
// Every exporter writes this and nothing else.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "techniques/foundation/image/image.h"
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::foreign {

/// One part of an object, of one material. Positions are floats in metres, in the world less PlainScene::originWorld.
struct PlainMesh {
    std::string name; ///< of the object; several may have one name
    std::vector<vec3> positions;
    std::vector<vec3> normals;   ///< for shading; unit, one per position, on the front
    std::vector<vec2> texcoords; ///< places in the material's images, (0, 0) the lower left corner; empty: no image
    std::vector<vec3> colors;    ///< linear RGB, multiplied with the material's; empty: none
    std::vector<uvec3> triangles;
    std::uint32_t material = 0; ///< index into PlainScene::materials
    bool castsShadow = true, receivesShadow = true;
    int emitterOfLight = -1; ///< it is the surface of that light; -1: of none
    bool isClosed = false; ///< from outside no back face is seen
};

/// An image that materials use, as it lies on the surface: row 0 at the top.
struct PlainImage {
    std::string file;   ///< "textures/1.png", as the files that are written name it
    image::Image image; ///< colours in sRGB; alpha 0 where there is a hole, else 255
};

struct PlainMaterial {
    scene::Material values; ///< without its images
    int image = -1;         ///< index into PlainScene::images: colour and holes in one; -1: none
    bool hasHoles = false, hasColors = false; ///< what of the image counts
    bool clamped = false;   ///< beyond its border the image goes on as at the border; else it repeats
};

struct PlainEye {
    dvec3 position{0.0};                   ///< in the world less the origin
    dvec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1}; ///< unit, right-handed; it looks along -back
    double fovYDegrees = 45, near = 0.1, far = 100;   ///< far: beyond everything there is
};

struct PlainScene {
    std::string name;
    dvec3 originWorld{0.0}; ///< what has been subtracted from all positions: nought unless the scene lies far from there
    PlainEye eye;
    vec3 ambient{0.0f}, background{0.0f};
    float exposure = 1;
    std::vector<scene::Light> lights; ///< positions less the origin
    std::vector<PlainMaterial> materials;
    std::vector<PlainImage> images;
    std::vector<PlainMesh> meshes;
    std::vector<std::vector<std::uint32_t>> usefulCasters; ///< for each light the meshes whose shadow can fall on something
    dvec3 lower{0.0}, upper{0.0}; ///< the box around all that is not flat and large: what shadow maps should cover
    std::vector<std::string> lost; ///< what of the scene even this does not say, a sentence each
};

/// `scene` as its camera sees it.
PlainScene plainScene(const scene::Scene& scene);

} // namespace shadowlab::foreign
