// SPDX-License-Identifier: MIT
#include "tests/support/random_scenes.h"

#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/scenes.h"

namespace shadowlab::testing {

namespace {

class Builder {
public:
    explicit Builder(unsigned number) : random_(number + 1) {}

    scene::Scene build() {
        scene_.name = "random";
        scene_.materials.emplace_back();
        scene_.ambient = vec3(0.1f);
        if (chance(0.8)) addObject(scene_, scene::makeQuad({real(4, 16), real(4, 16)}));
        for (int i = whole(1, 8); i > 0; --i)
            object();
        for (int i = whole(1, 4); i > 0; --i)
            light();
        eye();
        scene::addEmitterSurfaces(scene_);
        return scene_;
    }

private:
    double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
    bool chance(double share) { return real(0, 1) < share; }
    dvec3 within(double x, double lowY, double highY, double z) {
        return {real(-x, x), real(lowY, highY), real(-z, z)};
    }
    dvec3 direction() {
        const dvec3 axis = within(1, -1, 1, 1);
        return glm::length(axis) > 0.1 ? glm::normalize(axis) : dvec3(0, 1, 0);
    }

    scene::Mesh mesh() {
        switch (whole(0, 4)) {
        case 0: return scene::makeBox({real(0.2, 2), real(0.2, 2), real(0.2, 2)});
        case 1: return scene::makeSphere(real(0.2, 1), 2 * whole(3, 8));
        case 2: return scene::makeTorus(real(0.5, 1.2), real(0.1, 0.4), {whole(5, 16), whole(3, 8)});
        case 3: return scene::makeQuad({real(0.5, 4), real(0.5, 4)});
        default: return triangleSoup(corners());
        }
    }
    std::vector<dvec3> corners() {
        std::vector<dvec3> corners;
        for (int i = 3 * whole(1, 12); i > 0; --i)
            corners.push_back(within(1, -1, 1, 1));
        return corners;
    }
    void object() {
        // One in five stands far from all others: beside the view, behind the eye, or far above.
        const dvec3 place = chance(0.2) ? within(40, -2, 30, 40) : within(4, 0, 4, 4);
        dmat4 worldFromObject = translation(place);
        if (chance(0.5)) worldFromObject = glm::rotate(worldFromObject, real(0, 6.3), direction());
        if (chance(0.3)) worldFromObject = glm::scale(worldFromObject, within(1, 0.5, 1.5, 1) + dvec3(1.5, 0, 1.5));
        if (chance(0.2)) worldFromObject = glm::scale(worldFromObject, dvec3(-1, 1, 1));
        scene::Object& made = addObject(scene_, mesh(), worldFromObject);
        made.castsShadow = chance(0.85);
        made.receivesShadow = chance(0.85);
    }
    void light() {
        scene::Light light;
        light.name = "light" + std::to_string(scene_.lights.size() + 1);
        light.type = static_cast<scene::LightType>(whole(0, 4));
        light.positionWorld = chance(0.2) ? within(30, -5, 30, 30) : within(4, 0.1, 7, 4);
        light.directionWorld = chance(0.7) ? glm::normalize(within(0.7, -1, -0.5, 0.7)) : direction();
        light.coneDegrees = real(10, 150);
        light.edgeDegrees = chance(0.5) ? real(0, 5) : 0;
        light.edgeUWorld = real(0.2, 2) * glm::normalize(glm::cross(light.directionWorld, dvec3(0.3, 0.2, 1)));
        light.edgeVWorld = real(0.2, 2) * glm::normalize(glm::cross(light.directionWorld, light.edgeUWorld));
        light.radius = real(0.1, 0.6);
        light.intensity = light.type == scene::LightType::directional ? 0.5 : 10;
        scene_.lights.push_back(light);
    }
    void eye() {
        scene_.camera.positionWorld = chance(0.3) ? within(3, 0.1, 3, 3) : within(9, 0.2, 8, 9);
        scene_.camera.targetWorld = chance(0.8) ? within(2, 0, 2, 2) : within(9, -3, 9, 9);
        scene_.camera.fovYDegrees = real(20, 100);
        scene_.camera.near = chance(0.5) ? 0.01 : real(0.05, 1);
    }

    std::mt19937 random_;
    scene::Scene scene_;
};

} // namespace

scene::Scene randomScene(unsigned number) { return Builder(number).build(); }

} // namespace shadowlab::testing
