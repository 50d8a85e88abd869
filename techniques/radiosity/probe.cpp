// SPDX-License-Identifier: MIT
#include "techniques/radiosity/probe.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/exact_judge.h"
#include "techniques/foundation/base/look.h"
#include "techniques/probed/patch_exchange.h"
#include "techniques/probed/radiosity_equations.h"
#include "techniques/probed/seen_point.h"

namespace shadowlab::radiosity {

namespace {

double degrees(double cosine) { return glm::degrees(std::acos(glm::clamp(cosine, -1.0, 1.0))); }

PatchProbe asProbed(const RoomCache& cache, const Sources& sources, const LightBalance& balance, std::uint32_t j) {
    const Patch& patch = cache.room().allPatches()[j];
    const dvec3& originWorld = cache.room().world().originWorld;
    PatchProbe probed;
    probed.object = cache.room().objectOf(patch).name;
    for (const dvec3& corner : patch.polygon.corners())
        probed.cornersWorld.push_back(originWorld + corner);
    probed.centreWorld = originWorld + patch.centre;
    probed.normalWorld = patch.normal;
    probed.area = patch.area;
    probed.emission = sources.emission[j];
    probed.reflectance = sources.reflectance[j];
    probed.radiosity = balance.radiosity()[j];
    return probed;
}

/// The outline of a patch and its normal, drawn as long as the patch is wide.
SceneShape outline(const PatchProbe& patch, std::string label, const vec3& colorLinear) {
    SceneShape shape{std::move(label), colorLinear, SceneShape::Kind::lines, {}};
    for (std::size_t i = 0; i < patch.cornersWorld.size(); ++i)
        for (const std::size_t corner : {i, (i + 1) % patch.cornersWorld.size()})
            shape.pointsWorld.push_back(patch.cornersWorld[corner]);
    const dvec3 tipWorld = patch.centreWorld + std::sqrt(patch.area) * patch.normalWorld;
    shape.pointsWorld.insert(shape.pointsWorld.end(), {patch.centreWorld, tipWorld});
    return shape;
}

/// The lecture's figure of two patches, in numbers.
void describePair(const RoomCache& cache, const Sources& sources, const LightBalance& balance, std::uint32_t j,
                  std::uint32_t k, Probe& probe) {
    const PatchProbe& from = probe.find<PatchExchange>()->j;
    const PatchProbe& to = probe.find<PatchExchange>()->k.emplace(asProbed(cache, sources, balance, k));
    const dvec3 way = to.centreWorld - from.centreWorld;
    const double r = glm::length(way);
    const double cosJ = glm::dot(from.normalWorld, way) / r, cosK = -glm::dot(to.normalWorld, way) / r;
    const double exchanged = cache.exchange().matrix(j, k);
    probe.find<PatchExchange>()->formFactorJk = exchanged / from.area;
    probe.find<PatchExchange>()->formFactorKj = exchanged / to.area;
    probe.facts.push_back(probeCount("k: the other patch", k));
    probe.facts.push_back({"of", to.object, ""});
    probe.facts.push_back(probeFact("dA_k", to.area, "m^2"));
    probe.facts.push_back(probeFact("r", r, "m"));
    probe.facts.push_back(probeFact("phi_j", degrees(cosJ), "degrees"));
    probe.facts.push_back(probeFact("phi_k", degrees(cosK), "degrees"));
    probe.facts.push_back(probeFact("F_jk", exchanged / from.area));
    probe.facts.push_back(probeFact("F_kj", exchanged / to.area));
    probe.facts.push_back(probeFact("cos phi_j cos phi_k dA_k / (pi r^2)",
                                    std::max(0.0, cosJ) * std::max(0.0, cosK) * to.area / (glm::pi<double>() * r * r)));
    probe.facts.push_back(probeFact("irradiance of j by k", exchanged / from.area * balance.radiosity()[k], "W/m^2"));
    probe.visited.push_back(
        {"r", look::kEqualDepth, SceneShape::Kind::lines, {from.centreWorld, to.centreWorld}});
    probe.visited.push_back(outline(to, "patch k", look::kPatchK));
}

// As many rows and columns as fit on a slide.
constexpr std::size_t kMostEquations = 5;

/// The patches whose equations are listed: j, its partner, and those that send j most of its light.
std::vector<std::uint32_t> chosenPatches(const RoomCache& cache, const LightBalance& balance, std::uint32_t j,
                                         std::optional<std::uint32_t> partner) {
    const std::size_t count = cache.room().patches().size();
    std::vector<std::pair<double, std::uint32_t>> givers;
    for (std::uint32_t k = 0; k < count; ++k) {
        const dvec3& radiosity = balance.radiosity()[k];
        if (k != j && k != partner)
            givers.emplace_back(-cache.exchange().matrix(j, k) * (radiosity.r + radiosity.g + radiosity.b), k);
    }
    std::vector<std::uint32_t> chosen{j};
    if (partner && *partner != j && *partner < count) chosen.push_back(*partner);
    const std::size_t more = std::min(givers.size(), kMostEquations - chosen.size());
    std::partial_sort(givers.begin(), givers.begin() + static_cast<std::ptrdiff_t>(more), givers.end());
    for (std::size_t i = 0; i < more; ++i)
        chosen.push_back(givers[i].second);
    std::ranges::sort(chosen);
    return chosen;
}

void describeEquations(const RoomCache& cache, const Sources& sources, const LightBalance& balance,
                       std::vector<std::uint32_t> chosen, Probe& probe) {
    RadiosityEquations& equations = probe.add(RadiosityEquations{});
    const std::vector<dvec3> radiosity = balance.exchanged();
    equations.count = static_cast<std::uint32_t>(cache.room().patches().size());
    for (const std::uint32_t i : chosen) {
        equations.patches.push_back(i + 1);
        equations.reflectance.push_back(sources.reflectance[i]);
        equations.emission.push_back(sources.first(i));
        equations.radiosity.push_back(radiosity[i]);
        std::vector<double>& row = equations.formFactors.emplace_back();
        dvec3 others(0.0);
        const double area = cache.room().allPatches()[i].area;
        for (const std::uint32_t k : chosen)
            row.push_back(cache.exchange().matrix(i, k) / area);
        for (std::uint32_t k = 0; k < equations.count; ++k)
            if (!std::ranges::binary_search(chosen, k))
                others += cache.exchange().matrix(i, k) / area * radiosity[k];
        equations.fromOthers.push_back(others);
    }
}

} // namespace

std::optional<std::uint32_t> patchSeen(const RoomCache& cache, const scene::Snapshot& snapshot, const View& view,
                                       ivec2 pixel) {
    const auto seen = exactJudge(snapshot)->eyeHit(view.camera, dvec2(pixel) + 0.5, view.size);
    if (!seen) return std::nullopt;
    const scene::Scene& scene = *snapshot;
    const trace::EyeHit& hit = *seen;
    const scene::Mesh& mesh = *scene.objects[hit.object].mesh;
    const dmat4 worldFromMesh = scene::worldFromMesh(scene.objects[hit.object]);
    std::array<dvec3, 3> corners{}, cornersWorld{};
    dvec3 positionMesh(0);
    for (int i = 0; i < 3; ++i) {
        corners[i] = dvec3(mesh.positionsMesh[mesh.triangles[hit.triangle][i]]);
        cornersWorld[i] = transformPoint(worldFromMesh, corners[i]);
        positionMesh += hit.barycentric[i] * corners[i];
    }
    const dvec3 frontWorld = glm::cross(cornersWorld[1] - cornersWorld[0], cornersWorld[2] - cornersWorld[0]);
    std::uint32_t triangle = hit.triangle;
    for (std::uint32_t o = 0; o < hit.object; ++o)
        triangle += static_cast<std::uint32_t>(scene.objects[o].mesh->triangles.size());
    return patchAt(cache.cells(), triangle, glm::dot(frontWorld, hit.geometricNormalWorld) > 0, vec3(positionMesh));
}

std::optional<std::uint32_t> brightestGiver(const RoomCache& cache, const LightBalance& balance, std::uint32_t j) {
    std::optional<std::uint32_t> best;
    double most = 0;
    for (std::uint32_t k = 0; k < cache.room().patches().size(); ++k) {
        const dvec3& radiosity = balance.radiosity()[k];
        const double given = cache.exchange().matrix(j, k) * (radiosity.r + radiosity.g + radiosity.b);
        if (given > most) {
            most = given;
            best = k;
        }
    }
    return best;
}

void describePatch(const RoomCache& cache, const Sources& sources, const LightBalance& balance, std::uint32_t j,
                   int light, std::optional<std::uint32_t> partner, Probe& probe) {
    const Patch& patch = cache.room().allPatches()[j];
    const std::size_t exchanging = cache.room().patches().size();
    const dvec3 radiosity = balance.radiosity()[j], arriving = balance.irradiance()[j];
    const dvec3 fromPatches = arriving - sources.irradiance(j);
    probe.facts.push_back(probeCount("j: patch", j,
                                     j < exchanging ? "of " + std::to_string(exchanging) + " that exchange light"
                                                    : "which exchanges light with no other"));
    probe.facts.push_back(probeFact("dA_j", patch.area, "m^2"));
    probe.facts.push_back(probeFact("E, emitted", sources.emission[j], "W/m^2"));
    probe.facts.push_back(probeFact("rho, reflected share", sources.reflectance[j]));
    probe.facts.push_back(probeFact("irradiance by lights", sources.fromLights[j], "W/m^2"));
    probe.facts.push_back(probeFact("irradiance from outside", sources.fromOutside[j], "W/m^2"));
    probe.facts.push_back(probeFact("irradiance by patches", fromPatches, "W/m^2"));
    probe.facts.push_back(probeFact("B, radiosity", radiosity, "W/m^2"));
    probe.facts.push_back(probeFact("radiant flux B dA_j", radiosity * patch.area, "W"));
    probe.facts.push_back(probeFact("radiant energy in a second", radiosity * patch.area, "J"));
    probe.facts.push_back(probeFact("I = B / pi, intensity", radiosity / glm::pi<double>(), "W/(m^2 sr)"));
    if (light >= 0) {
        const double share = cache.light(light).seenArea[j];
        probe.find<SeenPoint>()->lightShare = share;
        probe.facts.push_back(probeFact("visible share of the light", share));
    }
    PatchExchange& exchange = probe.add(PatchExchange{asProbed(cache, sources, balance, j)});
    probe.visited.push_back(outline(exchange.j, "patch j", look::kPatchJ));
    if (j >= exchanging) {
        probe.facts.push_back({"form factors", "none: nothing lies before it", ""});
        return;
    }
    probe.facts.push_back(probeFact("sum of form factors", cache.exchange().rowSums[j]));
    if (balance.solver()) {
        const dvec3 bound = balance.solver()->errorBound().largest;
        probe.facts.push_back(probeFact("error of B by solving, at most", bound, "W/m^2"));
    }
    describeEquations(cache, sources, balance, chosenPatches(cache, balance, j, partner), probe);
    if (partner && *partner != j && *partner < exchanging) describePair(cache, sources, balance, j, *partner, probe);
}

} // namespace shadowlab::radiosity
