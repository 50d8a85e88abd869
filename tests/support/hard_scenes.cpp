// SPDX-License-Identifier: MIT
#include "tests/support/hard_scenes.h"

#include <cmath>
#include <random>

#include "tests/support/scenes.h"

namespace shadowlab::testing {

namespace {

class Builder {
public:
    Builder(HardClass hardClass, unsigned number, bool directional)
        : class_(hardClass), directional_(directional), random_(1000 * static_cast<unsigned>(hardClass) + number + 1) {}

    scene::Scene build() {
        scene_ = floorScene();
        light_ = point({-3, 3}, {2.5, 6}, {-3, 3});
        scene_.camera.positionWorld = point({-3, 3}, {1.5, 4}, {4, 7});
        scene_.camera.targetWorld = point({-0.5, 0.5}, {0, 1}, {-0.5, 0.5});
        switch (class_) {
        case HardClass::soup: soup(); break;
        case HardClass::torus: torus(dvec3(0, 1.25, 0), 1.0, 0.4, false); break;
        case HardClass::nonManifold: fans(); break;
        case HardClass::lightInMesh:
            torus(dvec3(0, 1.5, 0), 1.5, 0.6, number() < 0.5);
            light_ = grid({1.5 + 0.2 * number(), 1.5 + 0.2 * number(), 0.1 * number()});
            break;
        case HardClass::lightOnVertexOrPlane: lightOnSomething(); break;
        case HardClass::eyeInSoup:
            soup();
            scene_.camera.positionWorld = point({-1, 1}, {0.5, 1.5}, {-1, 1});
            scene_.camera.targetWorld =
                scene_.camera.positionWorld + point({-1, 1}, {-0.6, 0.1}, {-1, 1}) + dvec3(0.01);
            break;
        }
        addObject(scene_, triangleSoup(corners_));
        if (directional_ && class_ != HardClass::lightInMesh)
            scene_.lights.push_back(directionalLight(grid(-light_)));
        else
            scene_.lights.push_back(pointLight(light_));
        return scene_;
    }

private:
    double number() { return std::uniform_real_distribution<double>(0, 1)(random_); }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
    static dvec3 grid(const dvec3& p) { return glm::round(p * 4096.0) / 4096.0; }
    dvec3 point(dvec2 x, dvec2 y, dvec2 z) {
        return grid({glm::mix(x.x, x.y, number()), glm::mix(y.x, y.y, number()), glm::mix(z.x, z.y, number())});
    }
    dvec3 nearby() { return point({-2, 2}, {0.25, 2.5}, {-2, 2}); }
    void triangle(const dvec3& a, const dvec3& b, const dvec3& c) {
        if (number() < 0.5 && class_ != HardClass::torus)
            corners_.insert(corners_.end(), {a, c, b}); // winding is nobody's business
        else
            corners_.insert(corners_.end(), {a, b, c});
    }
    void soup() {
        for (int i = whole(5, 34); i > 0; --i)
            triangle(nearby(), nearby(), nearby());
    }
    void torus(const dvec3& centre, double major, double minor, bool holes) {
        constexpr int kAround = 10, kTube = 7;
        const auto at = [&](int i, int j) {
            const double a = 2 * M_PI * i / kAround, t = 2 * M_PI * j / kTube, r = major + minor * std::cos(t);
            return grid(centre + dvec3(r * std::cos(a), minor * std::sin(t), r * std::sin(a)));
        };
        const int hole = whole(0, kAround * kTube - 1);
        for (int i = 0; i < kAround; ++i)
            for (int j = 0; j < kTube; ++j) {
                if (holes && i * kTube + j == hole) continue;
                corners_.insert(corners_.end(), {at(i, j), at(i, j + 1), at(i + 1, j + 1)});
                corners_.insert(corners_.end(), {at(i, j), at(i + 1, j + 1), at(i + 1, j)});
            }
    }
    /// Three to six triangles on one edge, some of them twice, and a vertex on a neighbour's edge.
    void fans() {
        for (int fan = whole(2, 5); fan > 0; --fan) {
            const dvec3 a = nearby(), b = nearby();
            for (int i = whole(3, 6); i > 0; --i) {
                const dvec3 c = nearby();
                triangle(a, b, c);
                if (number() < 0.2) triangle(a, b, c);
                if (number() < 0.3) triangle(grid(0.5 * (a + c)), a, nearby());
            }
        }
    }
    /// The light exactly in a vertex, or in the plane of a face; or the eye exactly in the plane of a silhouette.
    void lightOnSomething() {
        soup();
        const dvec3 a = corners_[0], b = corners_[1], c = corners_[2];
        switch (whole(0, 2)) {
        case 0: light_ = a; break;
        case 1: light_ = a + 2.0 * (b - a) + (c - a); break;
        case 2: scene_.camera.positionWorld = a + (a - light_) + 0.5 * (b - a); break;
        }
    }

    HardClass class_;
    bool directional_;
    std::mt19937 random_;
    scene::Scene scene_;
    dvec3 light_{0.0};
    std::vector<dvec3> corners_;
};

} // namespace

std::string toText(HardClass hardClass) {
    switch (hardClass) {
    case HardClass::soup: return "soup";
    case HardClass::torus: return "torus";
    case HardClass::nonManifold: return "non-manifold";
    case HardClass::lightInMesh: return "light in mesh";
    case HardClass::lightOnVertexOrPlane: return "light on vertex or plane";
    case HardClass::eyeInSoup: return "eye in soup";
    }
    return "";
}

scene::Scene hardScene(HardClass hardClass, unsigned number, bool directional) {
    return Builder(hardClass, number, directional).build();
}

} // namespace shadowlab::testing
