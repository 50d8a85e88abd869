// SPDX-License-Identifier: MIT
#include "tests/foreign/foreign_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace foreign_renderer {

namespace {

constexpr double kFar = 1e4, kNone = std::numeric_limits<double>::infinity();

struct Hit {
    double t = kNone;
    int tri = -1;
};

/// t of the hit, or kNone.
double meet(const Tri& tri, Vec from, Vec way) {
    const Vec e1 = tri.b - tri.a, e2 = tri.c - tri.a, p = cross(way, e2);
    const double det = dot(e1, p);
    if (det == 0) return kNone;
    const Vec s = from - tri.a, q = cross(s, e1);
    const double u = dot(s, p) / det, v = dot(way, q) / det;
    return u < 0 || v < 0 || u + v > 1 ? kNone : dot(e2, q) / det;
}

class Renderer {
public:
    Renderer(const Scene& scene, const Settings& settings) : scene_(scene), set_(settings) {
        forward_ = unit(scene.target - scene.eye);
        right_ = unit(cross(forward_, scene.up));
        up_ = cross(right_, forward_);
        light_ = scene.isSun ? unit(unit(scene.light) + settings.lightOffset) : scene.light + settings.lightOffset;
        for (const Tri& tri : scene.triangles)
            casts_.push_back(tri.thing != settings.withoutThing && (settings.onlyThing < 0 || tri.thing == settings.onlyThing) && !(settings.cullsCasters && side(tri, towardLight(tri.a)) < 0));
        if (settings.method == Method::map) drawMap();
        if (settings.method == Method::zfail || settings.method == Method::zpass) buildVolumes();
    }

    /// What a point of the picture shows.
    struct Seen {
        bool surface = false;
        double visible = 0, added = 0, ambient = 0;
    };
    [[nodiscard]] Seen at(double x, double y) const {
        const double half = std::tan(scene_.fovYDegrees * 3.14159265358979323846 / 360);
        const Vec way = forward_ + ((2 * x / set_.width - 1) * half * set_.width / set_.height) * right_ + ((1 - 2 * y / set_.height) * half) * up_;
        Hit hit;
        for (std::size_t i = 0; i < scene_.triangles.size(); ++i) {
            const double t = meet(scene_.triangles[i], scene_.eye, way);
            if (!(t > 0.05 && t < hit.t)) continue;
            if (set_.cullsView && side(scene_.triangles[i], Vec{} - way) < 0) continue;
            hit = {t, static_cast<int>(i)};
        }
        if (hit.tri < 0) return {};
        const Tri& tri = scene_.triangles[static_cast<std::size_t>(hit.tri)];
        const Vec point = scene_.eye + hit.t * way;
        Vec normal = unit(cross(tri.b - tri.a, tri.c - tri.a));
        if (set_.reversed) normal = Vec{} - normal;
        if (set_.normalsToViewer && dot(normal, way) > 0) normal = Vec{} - normal;
        const Vec toLight = towardLight(point);
        const double cosine = dot(normal, unit(toLight)), albedo = scene_.things[static_cast<std::size_t>(tri.thing)].albedo;
        Seen seen{true, 0, 0, scene_.ambient * albedo};
        if (cosine <= 0 || !isInCone(toLight)) return seen;
        seen.added = albedo / 3.14159265358979323846 * scene_.intensity * cosine / (scene_.isSun ? 1 : dot(toLight, toLight));
        seen.visible = isLit(point, hit, way) ? 1 : 0;
        return seen;
    }

private:
    /// +1 or -1: does the triangle turn its front to that way?
    [[nodiscard]] int side(const Tri& tri, Vec way) const {
        const double d = dot(cross(tri.b - tri.a, tri.c - tri.a), way);
        return (d > 0) != set_.reversed ? 1 : -1;
    }
    [[nodiscard]] Vec towardLight(Vec point) const { return scene_.isSun ? Vec{} - light_ : light_ - point; }

    [[nodiscard]] bool isInCone(Vec toLight) const {
        if (set_.coneDegrees >= 360) return true;
        return dot(unit(Vec{} - toLight), unit(scene_.target - scene_.light)) >= std::cos(set_.coneDegrees * 3.14159265358979323846 / 360);
    }
    [[nodiscard]] bool isLit(Vec point, const Hit& hit, Vec eyeWay) const {
        switch (set_.method) {
        case Method::rays: return raysSay(point, hit);
        case Method::map: return mapSays(point, hit);
        case Method::zfail:
        case Method::zpass: {
            const int count = countOf(hit, eyeWay);
            return set_.asksGreaterZero ? count <= 0 : count == 0;
        }
        }
        return true;
    }

    [[nodiscard]] bool raysSay(Vec point, const Hit& hit) const {
        const Vec way = towardLight(point);
        if (!scene_.isSun && length(way) > set_.lightFar) return true;
        for (std::size_t i = 0; i < scene_.triangles.size(); ++i) {
            if (static_cast<int>(i) == hit.tri || !casts_[i] || (!set_.selfShadows && scene_.triangles[i].thing == scene_.triangles[static_cast<std::size_t>(hit.tri)].thing)) continue;
            const double t = meet(scene_.triangles[i], point, way);
            if (!scene_.isSun && (1 - t) * length(way) < set_.lightNear) continue;
            if (t > 1e-10 && t < (scene_.isSun ? kNone : 1) && t * length(way) > set_.bias) return false;
        }
        return true;
    }

    // The map: texels hold the distance to the first caster along the ray through their centre.
    void drawMap() {
        Vec lower{kNone, kNone, kNone}, upper{-kNone, -kNone, -kNone};
        for (const Tri& tri : scene_.triangles)
            if (scene_.things[static_cast<std::size_t>(tri.thing)].name != "floor" && scene_.things[static_cast<std::size_t>(tri.thing)].name != "ground")
                for (const Vec& v : {tri.a, tri.b, tri.c}) {
                    lower = {std::min(lower.x, v.x), std::min(lower.y, v.y), std::min(lower.z, v.z)};
                    upper = {std::max(upper.x, v.x), std::max(upper.y, v.y), std::max(upper.z, v.z)};
                }
        const Vec centre = 0.5 * (lower + upper);
        const double radius = 0.5 * length(upper - lower);
        mapForward_ = scene_.isSun ? light_ : unit(centre - light_);
        mapRight_ = unit(cross(mapForward_, std::abs(mapForward_.y) > 0.9 ? Vec{1, 0, 0.2} : Vec{0, 1, 0.1}));
        mapUp_ = cross(mapRight_, mapForward_);
        mapOrigin_ = scene_.isSun ? centre - (4 * radius) * mapForward_ : light_;
        mapHalf_ = (scene_.isSun ? radius : radius / length(centre - light_) * 1.1) * set_.mapPart;
        if (set_.raysInMap) return;
        const std::size_t n = static_cast<std::size_t>(set_.texels);
        map_.assign(n * n, kNone);
        for (std::size_t i = 0; i < scene_.triangles.size(); ++i) {
            if (!casts_[i]) continue;
            const Tri& tri = scene_.triangles[i];
            double least[2] = {kNone, kNone}, most[2] = {-kNone, -kNone};
            bool behind = false;
            for (const Vec& v : {tri.a, tri.b, tri.c}) {
                double place[2];
                behind = behind || !placeInMap(v, place);
                for (int k = 0; k < 2; ++k) least[k] = std::min(least[k], place[k]), most[k] = std::max(most[k], place[k]);
            }
            const auto bound = [&](double value) { return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(set_.texels))); };
            const int x0 = behind ? 0 : bound(std::floor(least[0])), x1 = behind ? set_.texels : bound(std::ceil(most[0]));
            const int y0 = behind ? 0 : bound(std::floor(least[1])), y1 = behind ? set_.texels : bound(std::ceil(most[1]));
            for (int y = y0; y < y1; ++y)
                for (int x = x0; x < x1; ++x) {
                    const double u = (2 * (x + 0.5) / set_.texels - 1) * mapHalf_, v = (2 * (y + 0.5) / set_.texels - 1) * mapHalf_;
                    const Vec from = scene_.isSun ? mapOrigin_ + u * mapRight_ + v * mapUp_ : mapOrigin_;
                    const Vec way = scene_.isSun ? mapForward_ : mapForward_ + u * mapRight_ + v * mapUp_;
                    const double t = meet(tri, from, way);
                    double& texel = map_[static_cast<std::size_t>(y) * n + static_cast<std::size_t>(x)];
                    if (t > 0 && t < kNone) texel = std::min(texel, t); // depth along the map's axis
                }
        }
    }
    bool placeInMap(Vec point, double place[2]) const {
        const Vec from = point - mapOrigin_;
        const double depth = dot(from, mapForward_), w = scene_.isSun ? 1 : depth;
        if (w <= 1e-6) return false;
        place[0] = (dot(from, mapRight_) / (w * mapHalf_) + 1) / 2 * set_.texels;
        place[1] = (dot(from, mapUp_) / (w * mapHalf_) + 1) / 2 * set_.texels;
        return true;
    }
    [[nodiscard]] bool mapSays(Vec point, const Hit& hit) const {
        double place[2];
        if (!placeInMap(point, place)) return !set_.darkOutside;
        const int x = static_cast<int>(std::floor(place[0])), y = static_cast<int>(std::floor(place[1]));
        if (x < 0 || y < 0 || x >= set_.texels || y >= set_.texels) return !set_.darkOutside;
        if (set_.raysInMap) return raysSay(point, hit);
        return dot(point - mapOrigin_, mapForward_) - set_.bias <= map_[static_cast<std::size_t>(y) * static_cast<std::size_t>(set_.texels) + static_cast<std::size_t>(x)];
    }

    // Volumes: faces wound so that their fronts look outward.
    struct Face {
        Tri tri;
        int cap = -1;  ///< triangle of the scene that this front cap is
        bool isBackCap = false;
        int weight = 1;
    };
    [[nodiscard]] Vec farAway(Vec v) const { return scene_.isSun ? v + kFar * light_ : light_ + kFar * (v - light_); }
    void buildVolumes() {
        using Key = std::tuple<double, double, double>;
        const auto key = [](Vec v) { return Key{v.x, v.y, v.z}; };
        struct Edge {
            Vec from, to;
            int count = 0;
        };
        std::map<std::tuple<int, Key, Key>, Edge> edges;
        for (std::size_t i = 0; i < scene_.triangles.size(); ++i) {
            if (!casts_[i]) continue;
            Tri tri = scene_.triangles[i];
            if (side(tri, towardLight(tri.a)) < 0) {
                if (scene_.things[static_cast<std::size_t>(tri.thing)].closed) continue;
                std::swap(tri.b, tri.c); // an open sheet shades on both sides
            }
            faces_.push_back({tri, static_cast<int>(i), false, 1});
            faces_.push_back({{farAway(tri.a), farAway(tri.c), farAway(tri.b), tri.thing}, -1, true, 1});
            const Vec corners[3] = {tri.a, tri.b, tri.c};
            for (int k = 0; k < 3; ++k) {
                Vec from = corners[k], to = corners[(k + 1) % 3];
                int way = 1;
                if (key(to) < key(from)) std::swap(from, to), way = -1;
                Edge& edge = edges[{tri.thing, key(from), key(to)}];
                edge.from = from, edge.to = to;
                edge.count += way;
            }
        }
        for (const auto& [where, edge] : edges) {
            if (edge.count == 0) continue;
            Vec from = edge.from, to = edge.to;
            if (edge.count < 0) std::swap(from, to);
            // The lit triangle is on the left of from -> to; outside is on the right.
            const int weight = std::abs(edge.count), thing = std::get<0>(where);
            faces_.push_back({{from, farAway(from), farAway(to), thing}, -1, false, weight});
            faces_.push_back({{from, farAway(to), to, thing}, -1, false, weight});
        }
    }
    [[nodiscard]] int countOf(const Hit& hit, Vec way) const {
        int count = 0;
        for (const Face& face : faces_) {
            if ((face.cap >= 0 && !set_.frontCap) || (face.isBackCap && !set_.backCap)) continue;
            const double t = face.cap == hit.tri ? hit.t : meet(face.tri, scene_.eye, way);
            if (t == kNone) continue;
            const bool leaves = dot(cross(face.tri.b - face.tri.a, face.tri.c - face.tri.a), way) > 0;
            if ((set_.onlyFrontSides && leaves) || (set_.onlyBackSides && !leaves)) continue;
            if (set_.method == Method::zfail ? t >= hit.t : t > 0.05 && t < hit.t)
                count += face.weight * (leaves == (set_.method == Method::zfail) ? 1 : -1);
        }
        return count;
    }

    const Scene& scene_;
    Settings set_;
    Vec forward_, right_, up_, light_;
    std::vector<bool> casts_;
    Vec mapForward_, mapRight_, mapUp_, mapOrigin_;
    double mapHalf_ = 1;
    std::vector<double> map_;
    std::vector<Face> faces_;
};

double encoded(Curve curve, double light) {
    const double l = std::clamp(light, 0.0, 1.0);
    const auto srgb = [](double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; };
    switch (curve) {
    case Curve::srgb: return srgb(l);
    case Curve::linear: return l;
    case Curve::power22: return std::pow(l, 1 / 2.2);
    case Curve::twice: return srgb(srgb(l));
    }
    return l;
}

} // namespace

Pictures render(const Scene& scene, const Settings& settings) {
    const Renderer renderer(scene, settings);
    const std::size_t pixels = static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height);
    Pictures pictures;
    for (Picture* const one : {&pictures.visibility, &pictures.shaded, &pictures.unshadowed})
        *one = {settings.width, settings.height, std::vector<std::uint8_t>(pixels)};
    for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x) {
            double visible = 0, shaded = 0, unshadowed = 0;
            for (int k = 0; k < settings.samples * settings.samples; ++k) {
                const double n = settings.samples, dx = (k % settings.samples + 0.5) / n - 0.5, dy = (k / settings.samples + 0.5) / n - 0.5;
                const Renderer::Seen seen = renderer.at(x + settings.centre + dx, y + settings.centre + dy);
                visible += seen.visible / (n * n);
                shaded += (seen.ambient + seen.visible * seen.added) / (n * n);
                unshadowed += (seen.ambient + seen.added) / (n * n);
            }
            const int row = settings.flipRows ? settings.height - 1 - y : y, column = settings.flipColumns ? settings.width - 1 - x : x;
            const std::size_t i = static_cast<std::size_t>(row) * static_cast<std::size_t>(settings.width) + static_cast<std::size_t>(column);
            pictures.visibility.grey[i] = static_cast<std::uint8_t>(std::lround(255 * visible));
            pictures.shaded.grey[i] = static_cast<std::uint8_t>(std::lround(255 * encoded(settings.curve, shaded)));
            pictures.unshadowed.grey[i] = static_cast<std::uint8_t>(std::lround(255 * encoded(settings.curve, unshadowed)));
        }
    return pictures;
}

} // namespace foreign_renderer
