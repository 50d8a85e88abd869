// SPDX-License-Identifier: MIT
#include "app/figures/volume/caster_solid.h"

#include <algorithm>
#include <cmath>

#include "app/figures/panels.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/look.h"
#include "techniques/foundation/image/image.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::figures {

namespace {

constexpr std::size_t kCoarse = 900; ///< triangles: of more the edges would be all that is seen

[[noreturn]] void nothingToDraw(const FigureSource& source) {
    const Probe& probe = source.probe;
    if (probe.geometry.empty()) throw Error(ExitStatus::badInput, "the pixel shows the background; choose another");
    if (source.scene.lights.empty())
        throw Error(ExitStatus::badInput,
                    "scene '" + source.scene.name + "' has no lights, so nothing is extruded; choose another scene");
    if (!probe.find<VolumeProbe>())
        throw Error(ExitStatus::badInput, std::string(source.technique) +
                                              " makes no shadow volumes; ask shadow-volume, shadow-volume-zpass or "
                                              "shadow-volume-zfail");
    throw Error(ExitStatus::badInput, "the pixel shows no caster, and is in no shadow; choose one that is either");
}

/// Of a ray and a triangle, after Moeller and Trumbore (1997): does it meet it farther away than its start?
bool meetsTriangle(const dvec3& from, const dvec3& way, const CasterSolid::Corners& c) {
    const dvec3 u = c[1] - c[0], v = c[2] - c[0], p = glm::cross(way, v);
    const double area = glm::dot(u, p);
    if (area == 0) return false;
    const dvec3 t = from - c[0], q = glm::cross(t, u);
    const double a = glm::dot(t, p) / area, b = glm::dot(way, q) / area, distance = glm::dot(v, q) / area;
    const double least = 1e-6 * std::sqrt(glm::dot(u, u) + glm::dot(v, v)); // the place's own triangle
    return a >= 0 && b >= 0 && a + b <= 1 && distance > least;
}

} // namespace

CasterSolid::Corners CasterSolid::corners(std::size_t triangle) const {
    const uvec3& t = object->mesh->triangles[triangle];
    return {verticesWorld[t.x], verticesWorld[t.y], verticesWorld[t.z]};
}

dvec3 CasterSolid::centre(std::size_t triangle) const {
    const Corners c = corners(triangle);
    return (c[0] + c[1] + c[2]) / 3.0;
}

dvec3 CasterSolid::normal(std::size_t triangle) const {
    const Corners c = corners(triangle);
    // Of a mirrored object the corners run the other way round.
    return glm::normalize(glm::cross(c[1] - c[0], c[2] - c[0])) * (scene::isMirrored(*object) ? -1.0 : 1.0);
}

double CasterSolid::cosine(std::size_t triangle) const { return glm::dot(normal(triangle), toLight(centre(triangle))); }

bool CasterSolid::isClosed() const { return scene::reportMesh(*object->mesh, topology).isClosed(); }

CasterSolid casterSolid(const FigureSource& source, bool shadowing) {
    const Probe& probe = source.probe;
    if (probe.geometry.size() < 2 || !probe.find<VolumeProbe>() || probe.find<VolumeProbe>()->casters.empty() || source.light < 0)
        nothingToDraw(source);
    const std::vector<VolumeProbe::Caster>& all = probe.find<VolumeProbe>()->casters;
    // By either rule a caster that is only one of the two: the pixel may show a thing that shadows itself.
    const auto found = std::ranges::find_if(all, [&](const VolumeProbe::Caster& caster) {
        return shadowing ? caster.holdsThePoint && !caster.isPicked : caster.isPicked;
    });
    CasterSolid solid;
    solid.caster = found == all.end() ? &all.front() : &*found;
    solid.object = &source.scene.objects[solid.caster->object];
    const dmat4 worldFromMesh = scene::worldFromMesh(*solid.object);
    for (const vec3& position : solid.object->mesh->positionsMesh)
        solid.verticesWorld.push_back(transformPoint(worldFromMesh, dvec3(position)));
    solid.topology = scene::buildTopology(*solid.object->mesh);
    solid.lightWorld = scene::homogeneousPositionWorld(source.scene.light(source.light));
    return solid;
}

std::size_t nearestTriangle(const CasterSolid& solid, const dvec3& pointWorld) {
    std::size_t best = 0;
    double least = 1e300;
    for (std::size_t t = 0; t < solid.triangles(); ++t) {
        const auto [a, b, c] = solid.corners(t);
        // The point of the triangle that is nearest, by its shares of the corners, clamped one after the other: exact
        // within the triangle, and near enough beside it.
        const dvec3 u = b - a, v = c - a, w = pointWorld - a;
        const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), area = uu * vv - uv * uv;
        const double s = area > 0 ? (vv * glm::dot(w, u) - uv * glm::dot(w, v)) / area : 0;
        const double r = area > 0 ? (uu * glm::dot(w, v) - uv * glm::dot(w, u)) / area : 0;
        const double share = glm::clamp(s, 0.0, 1.0), other = glm::clamp(r, 0.0, 1.0 - share);
        const double away = glm::length(w - share * u - other * v);
        if (away >= least) continue;
        least = away;
        best = t;
    }
    return best;
}

std::string paleColor(const vec3& linear, double paleness) {
    vec3 mixed;
    for (int i = 0; i < 3; ++i) { // as the eye sees it: of what is stored, not of light
        const double stored = image::srgbFromLinear(linear[i]) / 255.0;
        mixed[i] = image::linearFromSrgb(static_cast<std::uint8_t>(std::lround(255 * glm::mix(stored, 1.0, paleness))));
    }
    return drawing::colorText(mixed);
}

SideColors facingColors(double paleness) {
    return {paleColor(look::kTowardLight, paleness), paleColor(look::kAwayFromLight, paleness)};
}

SideColors capColors(double paleness) { return {paleColor(look::kTopCap, paleness), paleColor(look::kOtherLight, paleness)}; }

void drawTriangles(drawing::Drawing& drawing, const SpaceView& view, const CasterSolid& solid,
                   std::span<const std::size_t> triangles, const SideColors& colors) {
    const bool isClosed = solid.isClosed(), isMirrored = scene::isMirrored(*solid.object);
    struct Seen {
        double depth;
        std::size_t triangle;
    };
    std::vector<Seen> seen;
    for (const std::size_t t : triangles) {
        if (isClosed && view.showsFront(solid.corners(t)) == isMirrored) continue; // other sides hide it
        seen.push_back({view.depth(solid.centre(t)), t});
    }
    std::ranges::stable_sort(seen, std::greater<>(), &Seen::depth);
    const bool isCoarse = seen.size() < kCoarse;
    std::vector<dvec2> run; // of one colour
    for (std::size_t i = 0; i < seen.size(); ++i) {
        std::vector<dvec2> corners;
        for (const dvec3& corner : solid.corners(seen[i].triangle))
            corners.push_back(view(corner));
        const bool facesLight = solid.facesLight(seen[i].triangle);
        const std::string& color = facesLight ? colors.toward : colors.away;
        if (isCoarse) {
            drawing.path(corners, true, color, {"#8c8c8c", 1, false});
            continue;
        }
        run.insert(run.end(), corners.begin(), corners.end());
        if (i + 1 == seen.size() || solid.facesLight(seen[i + 1].triangle) != facesLight) {
            drawing.surface(run, color, 1);
            run.clear();
        }
    }
}

bool isHidden(const CasterSolid& solid, const dvec3& placeWorld, const dvec3& towardViewerWorld) {
    for (std::size_t t = 0; t < solid.triangles(); ++t)
        if (meetsTriangle(placeWorld, towardViewerWorld, solid.corners(t))) return true;
    return false;
}

void drawLightSign(drawing::Drawing& drawing, drawing::Labels& labels, const SpaceView& view, const dvec3& drawnWorld,
                   const std::string& rest) {
    const dvec2 at = view(drawnWorld);
    drawing.circle(at, 13, drawing::colorText(look::kChosenLight), {"#1a1a1a", 3, false}, "light");
    labels.avoid({at - 15.0, dvec2(30)});
    labels.place(drawing, at, drawing::LabelText{"P", "L", rest}, {.size = drawing::kLetter, .isBold = true}, 18);
}

} // namespace shadowlab::figures
