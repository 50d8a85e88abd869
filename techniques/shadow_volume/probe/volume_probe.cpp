// The probe of one pixel: every volume face that the line from the eye crosses, and how it is counted.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "techniques/exact_judge.h"
#include "techniques/foundation/base/look.h"
#include "techniques/foundation/scene/query/view/depth_fit.h"
#include "techniques/probe_decision.h"
#include "techniques/probed/volume_probe.h"
#include "techniques/shadow_volume/cull/eye_line.h"
#include "techniques/shadow_volume/probe/crossed_faces.h"
#include "techniques/shadow_volume/probe/shapes.h"
#include "techniques/shadow_volume/volume_technique.h"

namespace shadowlab::shadow_volume {

namespace {

using Crossing = VolumeProbe::Crossing;

// A face at the depth of the point lies beyond it, because equal depths fail the test LESS. Distances are ratios of sums of
// a few products of doubles; equal ones agree to within this share of them.
constexpr double kSamePlace = 0x1p-40;

constexpr std::size_t kListedFaces = 24; ///< as lines of text; the JSON has all

VolumeProbe::Part partOf(CrossedFace::Part part) {
    return part == CrossedFace::Part::side        ? VolumeProbe::Part::side
           : part == CrossedFace::Part::bottomCap ? VolumeProbe::Part::bottomCap
                                                  : VolumeProbe::Part::topCap;
}

/// The rules of the technique, applied to one face.
struct Rules {
    CountRules rules;
    double pointDistance = 0, axisShare = 1; ///< of the point; metres along the eye's axis for a metre along the line
    double cutBefore = 0, near = 0, far = 0; ///< metres along the axis: the drawn near plane, and the far one (0: none)
    bool eyeIsBeyondEnd = false;

    /// +1, -1 or 0, and why 0 where that is a teaching fault.
    void count(Crossing& crossing, bool isOwnTriangle) const {
        const double depth = crossing.distance * axisShare;
        const bool isTop = crossing.part == VolumeProbe::Part::topCap,
                   isBottom = crossing.part == VolumeProbe::Part::bottomCap;
        if (crossing.method == CountMethod::zPass) {
            if (crossing.beyond) return;
            if (isBottom && !eyeIsBeyondEnd) return;
            if (isTop && !(rules.pass.corrected && depth < near)) return;
            if (!rules.pass.corrected && depth < cutBefore) {
                crossing.uncounted = "cut off by the near plane";
                return;
            }
            crossing.counted = crossing.sign;
            return;
        }
        if (!crossing.beyond) return;
        if ((isTop || isBottom) && !rules.fail.caps) {
            crossing.uncounted = "caps are left out";
            return;
        }
        if (isTop && isOwnTriangle && rules.fail.lessOrEqual) {
            crossing.uncounted = "at the surface's own depth, which passes the test LEQUAL";
            return;
        }
        if (!isTop && far > 0 && !rules.fail.clamp && depth > far) {
            crossing.uncounted = "cut off by the far plane";
            return;
        }
        crossing.counted = -crossing.sign;
    }
};

/// Which faces have been drawn when the stencil is read.
enum class Drawn { bothAtOnce, oneSide, oneSideThenTheOther };

/// The count as the stencil does it, face by face: it wraps around, or it saturates.
int stencilOf(std::span<const Crossing> drawn, const StencilRule& rule, int start, Drawn how, bool backFirst) {
    const int mask = static_cast<int>(rule.mask());
    int value = start & mask;
    const auto add = [&](const Crossing& crossing) {
        if (!rule.wrap && ((crossing.counted > 0 && value == mask) || (crossing.counted < 0 && value == 0))) return;
        value = (value + crossing.counted) & mask;
    };
    for (const int step : {0, 1}) {
        for (const Crossing& crossing : drawn)
            if (how == Drawn::bothAtOnce || (crossing.sign < 0) == ((step == 0) == backFirst)) add(crossing);
        if (how != Drawn::oneSideThenTheOther) break;
    }
    return value;
}

void addCaps(VolumeProbe& probe, const LightSection& section, const scene::Scene& scene, const CasterVolume& caster,
             const VolumeEnd& end, const scene::Light& light) {
    const scene::Object& object = scene.objects[caster.object];
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    const auto n = static_cast<std::uint32_t>(object.mesh->positionsMesh.size());
    const auto add = [&](const std::vector<std::uint32_t>& list, int sign) {
        for (std::size_t i = 0; i + 2 < list.size(); i += 3) {
            std::array<dvec3, 3> corners{};
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t vertex = list[i + c];
                corners[c] = transformPoint(worldFromMesh, dvec3(object.mesh->positionsMesh[vertex % n]));
                if (vertex >= n) corners[c] = dvec3(pushedWorld(corners[c], light, end));
            }
            if (const auto cut = cutBy(section, corners)) probe.caps.push_back({(*cut)[0], (*cut)[1], sign});
        }
    };
    add(caster.volume.topCap, 1);
    add(caster.volume.topCapReversed, 1);
    if (end.planeWorld || end.distance) add(caster.volume.bottomCap, -1);
}

std::string faceText(const Crossing& crossing, bool isInfinite) {
    const std::string what =
        crossing.part == VolumeProbe::Part::side
            ? "side of edge " + std::to_string(crossing.of[0]) + "-" + std::to_string(crossing.of[1])
        : crossing.part == VolumeProbe::Part::topCap ? "top cap, triangle " + std::to_string(crossing.of[0])
                                                     : "bottom cap, triangle " + std::to_string(crossing.of[0]);
    std::string text = std::string(crossing.sign > 0 ? "+1 front" : "-1 back") + ", " + what + " of " +
                       crossing.object + ", " +
                       (isInfinite ? "at infinity" : "at " + probeText(crossing.distance) + " m") +
                       (crossing.beyond ? ", beyond the point" : ", before the point");
    if (!crossing.uncounted.empty()) text += "; not counted: " + crossing.uncounted;
    return text;
}

std::string sumText(int more, int less, const char* first, const char* second) {
    return std::string(first) + " = " + std::to_string(more) + ", " + second + " = " + std::to_string(less) + ": " +
           std::to_string(more) + " - " + std::to_string(less) + " = " + std::to_string(more - less) +
           (more == less ? ", lit" : ", in shadow");
}

} // namespace

VolumeProbe VolumeTechnique::probeVolumes(const scene::Scene& scene, const View& view, const trace::EyeHit& hit,
                                          int light) {
    const scene::Light& source = scene.light(light);
    const dvec3& eyeWorld = view.camera.positionWorld;
    const EyeLine line{eyeWorld, glm::normalize(hit.positionWorld - eyeWorld)};
    // The matrices that a frame draws with: see Frame.
    const scene::Camera tight =
        scene::withTightNear(view.camera, scene, casters_.bounds(), static_cast<double>(view.size.x) / view.size.y);
    const gl::EyeMatrices eye = gl::eyeMatrices(usesNearPlaneOfView() ? view.camera : tight, view.size);
    findReceivers(scene, eye);
    const LightSection section =
        lightSection(eyeWorld, hit.positionWorld, scene::homogeneousPositionWorld(source), hit.geometricNormalWorld);

    Rules rules{.rules = this->rules(), .pointDistance = hit.distance};
    rules.axisShare = glm::dot(line.directionWorld, glm::normalize(view.camera.targetWorld - eyeWorld));
    rules.cutBefore = view.camera.near;
    rules.near = tight.near;
    if (failRule().farPlane) rules.far = scene::farDepth(casters_.bounds(), eye.viewFromWorld, tight.near);

    VolumeProbe probe;
    for (const CasterVolume& caster : casters_.of(light)) {
        const CountMethod method = countMethodOf(scene, eyeWorld, caster, light);
        const VolumeInView seen = inView(eye, caster, source);
        const bool isPicked = caster.object == hit.object;
        if (isPicked && (caster.useful || !params_.cull)) {
            probe.casters.push_back(describedCaster(scene, source, caster, shownVolume(), seen.end));
            probe.casters.back().isPicked = true;
        }
        probe.eyeCount += eyeCount(scene, caster, seen.end, source, eyeWorld);
        if (!seen.any || !counts(caster, method)) continue;
        if (method == CountMethod::zPass && passRule().corrected)
            probe.start += eyeCount(scene, caster, seen.end, source, eyeWorld);
        addCaps(probe, section, scene, caster, seen.end, source);
        rules.eyeIsBeyondEnd =
            seen.end.distance || (seen.end.planeWorld && glm::dot(*seen.end.planeWorld, dvec4(eyeWorld, 1.0)) > 0);
        int holding = eyeCount(scene, caster, seen.end, source, eyeWorld); // volumes of the caster that the point is in
        for (const CrossedFace& face : crossedFaces(scene, caster, seen.end, source, line)) {
            Crossing crossing;
            crossing.object = scene.objects[caster.object].name;
            crossing.part = partOf(face.part);
            bool own = false;
            if (crossing.part == VolumeProbe::Part::side) {
                const SilhouetteEdge& edge = edgeOfSide(caster, face.triangle);
                crossing.of = {edge.a, edge.b};
            } else {
                const std::uint32_t triangle = triangleOfCap(caster, face.part, face.triangle);
                crossing.of = {triangle, triangle};
                own = crossing.part == VolumeProbe::Part::topCap && caster.object == hit.object &&
                      triangle == hit.triangle;
            }
            crossing.distance = face.distance;
            crossing.sign = face.facesEye ? 1 : -1;
            crossing.beyond = own || face.distance >= hit.distance * (1 - kSamePlace);
            crossing.method = method;
            crossing.cornersWorld.assign(face.cornersWorld.begin(), face.cornersWorld.end());
            rules.count(crossing, own);
            if (!crossing.beyond) holding += crossing.sign;
            probe.crossings.push_back(std::move(crossing));
        }
        if (holding == 0) continue;
        if (probe.casters.empty() || probe.casters.back().object != caster.object)
            probe.casters.push_back(describedCaster(scene, source, caster, shownVolume(), seen.end));
        probe.casters.back().isPicked = isPicked;
        probe.casters.back().holdsThePoint = true;
    }
    // In the order in which they are drawn (FaceCounter): first what depth pass counts, then the others, and of either the
    // top caps of all volumes at the end. For a stencil that saturates the order matters.
    std::ranges::stable_sort(probe.crossings, {}, [](const Crossing& c) {
        return std::pair(c.method == CountMethod::zFail, c.part == VolumeProbe::Part::topCap);
    });
    probe.count = probe.start;
    for (const Crossing& crossing : probe.crossings) {
        probe.count += crossing.counted;
        int& number = crossing.beyond ? (crossing.sign > 0 ? probe.frontsBeyond : probe.backsBeyond)
                                      : (crossing.sign > 0 ? probe.frontsBefore : probe.backsBefore);
        ++number;
    }
    const bool backFirst = counting_.first.culled == GL_FRONT;
    const auto stencil = [&](Drawn how) {
        return stencilOf(probe.crossings, params_.stencil, probe.start, how, backFirst);
    };
    probe.stencilCleared = probe.start & static_cast<int>(params_.stencil.mask());
    probe.stencilBetween = stencil(Drawn::oneSide);
    probe.stencil = countsInFloats(light) ? static_cast<int>(probe.count != 0)
                                          : stencil(params_.twoSided ? Drawn::bothAtOnce : Drawn::oneSideThenTheOther);
    std::ranges::stable_sort(probe.crossings, {}, &Crossing::distance);
    return probe;
}

/// The reason why the count is wrong; only if there is no other is it rounding at an edge.
std::string VolumeTechnique::whyWrong(const VolumeProbe& volume, bool isLit) const {
    const auto uncounted = [&](std::string_view why) {
        return std::ranges::count_if(volume.crossings, [&](const Crossing& c) { return c.uncounted == why; });
    };
    for (const char* why : {"cut off by the near plane", "cut off by the far plane", "caps are left out",
                            "at the surface's own depth, which passes the test LEQUAL"})
        if (const auto faces = uncounted(why); faces > 0)
            return std::to_string(faces) + (faces == 1 ? " face is" : " faces are") + " missing from the count (" +
                   why + ")";
    const bool passes =
        std::ranges::any_of(volume.crossings, [](const Crossing& c) { return c.method == CountMethod::zPass; }) ||
        volume.crossings.empty();
    if (passes && !passRule().corrected && volume.eyeCount != volume.start)
        return "the eye is in " + std::to_string(volume.eyeCount) + (volume.eyeCount == 1 ? " volume" : " volumes") +
               ", but the count before the point starts at 0";
    if (volume.count != 0 && isLit)
        return "the count is " + std::to_string(volume.count) + ", but the stencil's " +
               std::to_string(params_.stencil.bits) + " bits hold 0";
    if (volume.count == 0 && !isLit) return "the count is 0, but the stencil stuck at an end";
    if (endsAtDistance() && isLit) return "the volumes end at " + probeText(params_.extrusion) + " m, before the point";
    return "the line passes an edge more closely than the faces' positions are known";
}

Probe VolumeTechnique::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    const auto exact = exactJudge(snapshot);
    const auto hit = exact->eyeHit(view.camera, dvec2(pixel) + 0.5, view.size);
    if (!hit || light < 0 || light >= static_cast<int>(snapshot->lights.size())) return probe;
    prepare(snapshot, Deadline::max());
    probe.facts.push_back(probeCount("casting triangles between the point and the light",
                                     static_cast<std::uint64_t>(exact->crossings(*hit, light))));
    const VolumeProbe& volume = probe.add(probeVolumes(*snapshot, view, *hit, light));
    const auto add = [&](std::string label, std::string value) {
        probe.facts.push_back({std::move(label), std::move(value), ""});
    };
    probe.facts.push_back(probeCount("volumes that the eye is in", static_cast<std::uint64_t>(volume.eyeCount)));
    add("z-pass, eye to point", sumText(volume.frontsBefore, volume.backsBefore, "n_f", "n_b"));
    add("z-fail, point to infinity", sumText(volume.backsBeyond, volume.frontsBeyond, "n_b", "n_f"));
    const auto addNumber = [&](std::string label, int number, const std::string& remark = "") {
        probe.facts.push_back({std::move(label), std::to_string(number) + remark, "", {static_cast<double>(number)}});
    };
    addNumber("count of this technique", volume.count,
              volume.start ? ", which started at " + std::to_string(volume.start) : "");
    addNumber("stencil, cleared", volume.stencilCleared);
    addNumber(counting_.first.culled == GL_FRONT ? "stencil after the back faces" : "stencil after the front faces",
              volume.stencilBetween);
    addNumber("stencil", volume.stencil, countsInFloats(light) ? ", from a count in floats: not zero" : "");
    for (const VolumeProbe::Caster& caster : volume.casters)
        add(caster.isPicked ? "caster that the pixel shows" : "caster whose volume holds the point",
            casterText(*snapshot, caster));
    std::size_t listed = 0;
    for (const Crossing& crossing : volume.crossings) {
        if (++listed > kListedFaces) {
            add("more faces", std::to_string(volume.crossings.size() - kListedFaces));
            break;
        }
        add("face " + std::to_string(listed), faceText(crossing, std::isinf(crossing.distance)));
    }
    const auto truth = exact->visibility(*hit, view.camera, light);
    // Pixels repaired with rays show the truth in the end.
    const bool counted = snapshot->objects[hit->object].receivesShadow;
    const bool isLit = truth != trace::Visibility::turnedAway && (!counted || volume.stencil == 0);
    addDecision(probe, isLit ? 1 : 0, truth, whyWrong(volume, isLit));
    for (SceneShape& shape : crossedShapes(*snapshot, volume))
        probe.visited.push_back(std::move(shape));
    return probe;
}

} // namespace shadowlab::shadow_volume
