// The probe of one pixel, and the remark on a mesh.
// SPDX-License-Identifier: MIT
#include "techniques/planar/probe/probe.h"

#include <algorithm>
#include <cmath>

#include "techniques/exact_judge.h"
#include "techniques/foundation/base/look.h"
#include "techniques/planar/technique.h"
#include "techniques/probe_decision.h"
#include "techniques/probed/plane_probe.h"

namespace shadowlab::planar {

namespace {

constexpr std::size_t kListedCovers = 12; ///< as lines of text; the drawing has all

std::string texts(const dvec3& v) { return "(" + probeText(v.x) + ", " + probeText(v.y) + ", " + probeText(v.z) + ")"; }

void tell(Probe& probe, const PlaneProbe& plane, bool shadows) {
    const auto add = [&](std::string label, std::string value) {
        probe.facts.push_back({std::move(label), std::move(value), ""});
    };
    const dvec4& l = plane.lightWorld;
    add("light P_L, homogeneous", "(" + probeText(l.x) + ", " + probeText(l.y) + ", " + probeText(l.z) + ", " +
                                      probeText(l.w) + (l.w == 0 ? "), a direction" : ")"));
    probe.facts.push_back(
        probeFact("N.P_L + D: height of the light", plane.lightHeight, l.w == 0 ? "(a cosine)" : "m"));
    std::size_t listed = 0;
    for (const PlaneProbe::Cover& cover : plane.covers) {
        if (++listed > kListedCovers) {
            add("more triangles", std::to_string(plane.covers.size() - kListedCovers));
            break;
        }
        const std::string height = probeText(cover.height), weight = probeText(cover.weight);
        add("triangle " + std::to_string(cover.triangle) + " of " + cover.object,
            "point P = " + texts(cover.placeWorld) + " m, N.P + D = " + height + " m, w' = " + weight +
                (cover.casts ? ": it throws the shadow here" : ": no shadow, " + cover.why));
    }
    if (plane.covers.empty()) add("casters", "none on the light's line through the point");
    if (shadows && !plane.clips) add("clipping", "off: what is beyond the light or below the plane is drawn, too");
}

/// The triangles that the line meets, and the plane's own point joined to them.
std::vector<SceneShape> coverShapes(const PlaneProbe& plane, const dvec3& pointWorld) {
    SceneShape casting{"throws the shadow", look::kOccluded, SceneShape::Kind::faces, {}};
    SceneShape others{"not between light and plane", look::kPassedOver, SceneShape::Kind::lines, {}};
    SceneShape way{"to its shadow", look::kOccluded, SceneShape::Kind::lines, {}};
    for (const PlaneProbe::Cover& cover : plane.covers) {
        if (cover.casts) {
            casting.pointsWorld.insert(casting.pointsWorld.end(), cover.cornersWorld.begin(), cover.cornersWorld.end());
            way.pointsWorld.insert(way.pointsWorld.end(), {cover.placeWorld, pointWorld});
        } else if (std::abs(cover.height) > plane.contact) {
            for (std::size_t i = 0; i < 3; ++i)
                others.pointsWorld.insert(others.pointsWorld.end(),
                                          {cover.cornersWorld[i], cover.cornersWorld[(i + 1) % 3]});
        }
    }
    return {std::move(casting), std::move(way), std::move(others)};
}

/// Of a point that lies on no plane that receives: the planes that do.
PlaneProbe withoutReceiver(const scene::Scene& scene, const Choice& choice, int light) {
    PlaneProbe probe;
    probe.receives = false;
    probe.lightWorld = scene::homogeneousPositionWorld(scene.light(light));
    for (const ChosenReceiver& one : choice.receivers) {
        const scene::Object& object = scene.objects[one.receiver.object];
        probe.others.push_back({object.name, planeOf(*one.receiver.face, scene::worldFromMesh(object))});
    }
    return probe;
}

/// The reason why an answer is wrong: a safeguard that the settings have switched off.
std::string whyWrong(const PlaneProbe& plane, bool isLit) {
    const auto falseCast = std::ranges::find_if(plane.covers, [](const auto& cover) {
        return !cover.casts && cover.why.find("anti-shadow") != std::string::npos;
    });
    if (!isLit && falseCast != plane.covers.end())
        return falseCast->object + " casts an anti-shadow: " + falseCast->why;
    return "the line to the light passes an edge, or the plane, more closely than heights are known";
}

} // namespace

Probe Planar::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    const auto exact = exactJudge(snapshot);
    const auto hit = exact->eyeHit(view.camera, dvec2(pixel) + 0.5, view.size);
    if (!hit) return probe;
    prepare(snapshot, Deadline::max());
    const gl::EyeMatrices eye = gl::eyeMatrices(view.camera, view.size);
    const Choice choice = choose(receivers_.inView(*snapshot, eye, scene::objectBounds(*snapshot)), params_.receivers,
                                 apartInPicture(view.size));
    const bool asked = light >= 0 && light < static_cast<int>(snapshot->lights.size());
    const auto truth = asked ? exact->visibility(*hit, view.camera, light) : trace::Visibility::noSurface;
    const double gate = truth == trace::Visibility::turnedAway ? 0 : 1;
    for (const ChosenReceiver& one : choice.receivers) {
        if (one.receiver.object != hit->object || !contains(one.receiver.face->runs, hit->triangle)) continue;
        const dmat4 worldFromMesh = scene::worldFromMesh(snapshot->objects[hit->object]);
        probe.facts.push_back({"receiver plane", equation(planeOf(*one.receiver.face, worldFromMesh)), ""});
        probe.facts.push_back({"stencil number", std::to_string(one.tag), ""});
        if (!asked) return probe;
        const scene::Light& source = snapshot->light(light);
        const dvec4 lightWorld = scene::homogeneousPositionWorld(source);
        if (glm::dot(planeOf(*one.receiver.face, worldFromMesh), lightWorld) == 0) {
            probe.facts.push_back({"projection", "none: the light lies in the plane", ""});
            addDecision(probe, 0, truth, "");
            return probe;
        }
        probe.add(probePlane(*snapshot, casters_, one, eye, lightWorld, hit->positionWorld));
        probe.find<PlaneProbe>()->clips = params_.clip;
        const bool unclipped = !params_.clip;
        const bool shadows = std::ranges::any_of(probe.find<PlaneProbe>()->covers, [&](const PlaneProbe::Cover& cover) {
            const bool ownObject =
                cover.object == snapshot->objects[hit->object].name; // never drawn where nothing is clipped
            return cover.casts || (unclipped && !ownObject && std::abs(cover.height) > probe.find<PlaneProbe>()->contact);
        });
        tell(probe, *probe.find<PlaneProbe>(), shadows);
        for (SceneShape& shape : coverShapes(*probe.find<PlaneProbe>(), hit->positionWorld))
            probe.visited.push_back(std::move(shape));
        if (isSampled(source))
            addDecider(probe, "the shadows of many points of the light; told is that of its centre");
        else
            addDecision(probe, shadows ? 0 : gate, truth, whyWrong(*probe.find<PlaneProbe>(), !shadows));
        return probe;
    }
    probe.facts.push_back({"receiver plane", "none: the technique draws no shadow here", ""});
    if (asked) {
        probe.add(withoutReceiver(*snapshot, choice, light));
        for (const PlaneProbe::Other& other : probe.find<PlaneProbe>()->others)
            probe.facts.push_back({"plane of " + other.object, equation(other.planeWorld), ""});
        addDecision(probe, gate, truth,
                    "the surface is no plane that receives, and planar shadows fall on planes alone");
    }
    return probe;
}

namespace {

std::string percent(double share) {
    const double rounded = std::round(100 * share);
    if (share > 0 && rounded < 1) return "less than 1 %";
    if (share < 1 && rounded > 99) return "more than 99 %";
    return std::to_string(static_cast<int>(rounded)) + " %";
}

} // namespace

std::string Planar::remark(const scene::MeshReport& report, const scene::Mesh& mesh) const {
    const std::string holes = report.hasHoles ? "; casts the holes that an alpha map cuts as holes" : "";
    const FlatFaces found = flatFaces(mesh);
    const double rest = found.smoothArea + found.facetArea + found.leftOverArea;
    if (rest <= 0 || found.area <= 0)
        return "receives shadows on all of it: " + std::to_string(found.faces.size()) +
               (found.faces.size() == 1 ? " flat face" : " flat faces") + holes;
    std::string why;
    const auto add = [&](double area, const std::string& reason) {
        if (area > 0) why += (why.empty() ? "" : ", ") + percent(area / found.area) + " " + reason;
    };
    add(found.smoothArea, "is shaded as curved");
    add(found.facetArea, "are facets that meet at less than 30 degrees");
    add(found.leftOverArea, "are faces beyond the 2048 largest");
    if (found.faces.empty())
        return "casts, but receives no shadows, not even its own, for there is no plane: " + why + holes;
    return "receives shadows on " + std::to_string(found.faces.size()) +
           (found.faces.size() == 1 ? " flat face, " : " flat faces, ") + percent((found.area - rest) / found.area) +
           " of its area; on the rest there are none: " + why + holes;
}

} // namespace shadowlab::planar
