// SPDX-License-Identifier: MIT
#include "app/picture/pixel_verdict.h"

#include <algorithm>

#include "app/picture/labels.h"
#include "app/picture/verdict_reasons.h"
#include "techniques/probed/map_probe.h"
#include "techniques/probed/patch_exchange.h"
#include "techniques/probed/plane_probe.h"
#include "techniques/probed/rays_probe.h"
#include "techniques/probed/seen_point.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::picture {

namespace {

PixelLight lightOf(double visibility) {
    return visibility <= 0 ? PixelLight::inShadow : visibility >= 1 ? PixelLight::lit : PixelLight::partlyLit;
}

PixelLight lightOf(trace::Visibility truth) {
    switch (truth) {
    case trace::Visibility::lit: return PixelLight::lit;
    case trace::Visibility::shadowed: return PixelLight::inShadow;
    case trace::Visibility::turnedAway: return PixelLight::turnedAway;
    case trace::Visibility::noSurface: break;
    }
    return PixelLight::unknown;
}

std::string wordsOf(PixelLight light) {
    switch (light) {
    case PixelLight::lit: return "LIT";
    case PixelLight::partlyLit: return "PARTLY LIT";
    case PixelLight::inShadow: return "IN SHADOW";
    case PixelLight::turnedAway: return "TURNED AWAY";
    case PixelLight::unknown: break;
    }
    return "NO ANSWER";
}

constexpr const char* kFacesAway = "no direct light: the surface faces away from it, or is outside its cone";

/// Node of the first surface's shadow ray to the light.
const Probe::Node* shadowRay(const Probe& probe, int light) {
    const auto found = std::ranges::find_if(probe.tree, [&](const Probe::Node& node) {
        return node.parent == 0 && node.light == light && node.light >= 0;
    });
    return found == probe.tree.end() ? nullptr : &*found;
}

std::string colorText(const dvec3& color) {
    return fixed(color.r, 3) + ", " + fixed(color.g, 3) + ", " + fixed(color.b, 3);
}

void decideByRays(const Probe& probe, const SeenPoint& seen, PixelVerdict& verdict, std::string& reason) {
    verdict.isOfTechnique = true;
    const auto* const rays = probe.find<RaysProbe>();
    const std::optional<double> sampled = rays ? rays->sampledShare() : std::nullopt;
    const bool isTurnedAway = seen.truth == trace::Visibility::turnedAway;
    if (sampled && !(isTurnedAway && *sampled == 0)) {
        const auto sent =
            std::ranges::count_if(rays->samples, [](const auto& s) { return s.onLightWorld.has_value(); });
        const auto arrived =
            std::ranges::count_if(rays->samples, [](const auto& s) { return s.onLightWorld && s.arrives; });
        verdict.light = lightOf(*sampled);
        reason = std::to_string(arrived) + " of " + std::to_string(sent) + " sampled shadow rays reach " + seen.lightName;
        verdict.sums.push_back("share of the light, sampled = " + percentOf(*sampled) +
                               (rays->exactShare ? "; exact = " + percentOf(*rays->exactShare) : ""));
        return;
    }
    const Probe::Node& ray = *shadowRay(probe, seen.light);
    if (isTurnedAway) {
        verdict.light = PixelLight::turnedAway;
        reason = kFacesAway;
    } else if (seen.lightShare) {
        verdict.light = lightOf(*seen.lightShare);
        reason = percentOf(*seen.lightShare) + " of " + seen.lightName + " is seen";
    } else {
        verdict.light =
            ray.role == Probe::Role::blocked && seen.receivesShadow ? PixelLight::inShadow : PixelLight::lit;
        reason = seen.receivesShadow ? "the shadow ray to " + seen.lightName + " " +
                                           (verdict.light == PixelLight::lit ? "arrives" : "is " + ray.end)
                                     : "the surface receives no shadows, so no shadow ray is sent";
    }
}

void addRaySums(const Probe& probe, int light, std::vector<std::string>& sums) {
    const Probe::Node& root = probe.tree.front();
    if (const Probe::Node* const ray = shadowRay(probe, light))
        sums.push_back("the light adds I = " + colorText(ray->intensity) + " to what " + root.surface +
                       " sends to the eye");
    int children = 0;
    for (const Probe::Node& node : probe.tree)
        children += node.parent == 0 && node.light < 0;
    sums.push_back("eye ray: I = " + colorText(root.intensity) +
                   (children ? ", with the rays that it splits into" : ""));
}

void decideByPatch(const PatchProbe& patch, const SeenPoint& seen, PixelVerdict& verdict, std::string& reason) {
    verdict.isOfTechnique = true;
    verdict.light = seen.truth == trace::Visibility::turnedAway && *seen.lightShare == 0 ? PixelLight::turnedAway
                                                                                         : lightOf(*seen.lightShare);
    // Of the whole patch: with other patches the same pixel has another share.
    reason = "the patch of " + shortNumber(patch.area, 2) + " m^2 on " + patch.object + " sees " + percentOf(*seen.lightShare) + " of " +
             seen.lightName;
}

void addPatchSums(const PatchProbe& patch, std::vector<std::string>& sums) {
    sums.push_back("B = E + rho times what arrives = " + colorText(patch.radiosity) + " W/m^2");
    sums.push_back("E = " + colorText(patch.emission) + " W/m^2; rho = " + colorText(patch.reflectance));
}

std::string decidedReason(const Probe& probe, const Decision& decision, const SeenPoint& seen) {
    if (!seen.receivesShadow) return "the surface receives no shadows";
    if (probe.find<VolumeProbe>()) return volumeReason(*probe.find<VolumeProbe>());
    if (decision.blocker)
        return "triangle " + std::to_string(decision.blocker->triangle) + " of " + decision.blocker->object +
               " is in the way";
    if (probe.find<Decider>()) return "no triangle is in the way";
    if (probe.find<MapProbe>()) return mapReason(*probe.find<MapProbe>(), decision.visibility);
    if (probe.find<PlaneProbe>()) return planeReason(*probe.find<PlaneProbe>(), decision.visibility > 0.5);
    return percentOf(decision.visibility) + " of the light arrives";
}

} // namespace

PixelVerdict pixelVerdict(const Probe& probe) {
    PixelVerdict verdict;
    const auto* const seen = probe.find<SeenPoint>();
    if (!seen) {
        verdict.sentence = "NO ANSWER: the technique does not tell which point the pixel shows";
        return verdict;
    }
    if (seen->object.empty()) {
        verdict.sentence = "BACKGROUND: the eye ray meets nothing";
        return verdict;
    }
    const auto* const volume = probe.find<VolumeProbe>();
    const auto* const map = probe.find<MapProbe>();
    const auto* const plane = probe.find<PlaneProbe>();
    const auto* const exchange = probe.find<PatchExchange>();
    std::string reason;
    if (seen->light < 0) {
        verdict.sentence = "NO LIGHT: the scene has none to ask about";
    } else if (probe.decision) {
        const Decision& decision = *probe.decision;
        verdict.isOfTechnique = true;
        verdict.isWrong = !decision.why.empty();
        const bool isTurnedAway = decision.isTurnedAway && decision.visibility == 0;
        verdict.light = isTurnedAway ? PixelLight::turnedAway : lightOf(decision.visibility);
        reason = isTurnedAway ? kFacesAway : decidedReason(probe, decision, *seen);
    } else if (exchange && seen->lightShare) {
        decideByPatch(exchange->j, *seen, verdict, reason);
    } else if (shadowRay(probe, seen->light)) {
        decideByRays(probe, *seen, verdict, reason);
    } else {
        verdict.light = lightOf(seen->truth);
        const auto* const decider = probe.find<Decider>();
        verdict.sentence = (verdict.light == PixelLight::turnedAway ? "" : "TRULY ") + wordsOf(verdict.light) + ": " +
                           (decider ? "the technique takes " + decider->who
                                    : "the exact answer; the technique tells nothing of its own");
    }
    if (verdict.sentence.empty())
        verdict.sentence = (!verdict.isWrong                   ? wordsOf(verdict.light)
                            : probe.decision->visibility > 0.5 ? "FALSE LIT"
                                                               : "FALSE SHADOW") +
                           ": " + reason;
    if (verdict.isWrong) verdict.sums.push_back("why it is wrong: " + probe.decision->why);
    if (volume) addVolumeSums(*volume, verdict.light == PixelLight::turnedAway, verdict.sums);
    if (map) addMapSums(*map, verdict.sums);
    if (plane) addPlaneSums(*plane, verdict.sums);
    if (exchange) addPatchSums(exchange->j, verdict.sums);
    if (!probe.tree.empty() && seen->light >= 0) addRaySums(probe, seen->light, verdict.sums);
    return verdict;
}

} // namespace shadowlab::picture
