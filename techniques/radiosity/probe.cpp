// SPDX-License-Identifier: MIT
#include "techniques/radiosity/probe.h"

#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/look.h"

namespace shadowlab::radiosity {

namespace {

double degrees(double cosine) { return glm::degrees(std::acos(glm::clamp(cosine, -1.0, 1.0))); }

SceneShape outline(const Patch& patch, const dvec3& originWorld, std::string label, const vec3& colorLinear) {
    SceneShape shape{std::move(label), colorLinear, SceneShape::Kind::lines, {}};
    for (std::size_t i = 0; i < patch.polygon.count(); ++i)
        for (const dvec3& corner : {patch.polygon[i], patch.polygon[(i + 1) % patch.polygon.count()]})
            shape.pointsWorld.push_back(originWorld + corner);
    return shape;
}

/// The lecture's figure of two surfaces, in numbers.
void describePair(const KeptRoom& kept, const LightBalance& balance, std::uint32_t j, std::uint32_t k, Probe& probe) {
    const PreparedExchange& exchange = kept.exchange();
    const Patch &from = kept.room().patches()[j], &to = kept.room().patches()[k];
    const dvec3 way = to.centre - from.centre, origin = kept.room().world().originWorld;
    const double r = glm::length(way);
    const double cosJ = glm::dot(from.normal, way) / r, cosK = -glm::dot(to.normal, way) / r;
    const double exchanged = exchange.matrix(j, k);
    probe.facts.push_back(probeCount("k: the other patch", k));
    probe.facts.push_back({"of", kept.room().objectOf(to).name, ""});
    probe.facts.push_back(probeFact("dA_k", to.area, "m^2"));
    probe.facts.push_back(probeFact("r", r, "m"));
    probe.facts.push_back(probeFact("phi_j", degrees(cosJ), "degrees"));
    probe.facts.push_back(probeFact("phi_k", degrees(cosK), "degrees"));
    probe.facts.push_back(probeFact("F_jk", exchanged / from.area));
    probe.facts.push_back(probeFact("F_kj", exchanged / to.area));
    probe.facts.push_back(probeFact("cos phi_j cos phi_k dA_k / (pi r^2)",
                                    std::max(0.0, cosJ) * std::max(0.0, cosK) * to.area / (glm::pi<double>() * r * r)));
    probe.facts.push_back(probeFact("irradiance of j by k", exchanged / from.area * balance.radiosity()[k], "W/m^2"));
    probe.geometry.push_back({"r", origin + from.centre, origin + to.centre, Probe::Role::arriving});
    probe.geometry.push_back(
        {"N_j", origin + from.centre, origin + from.centre + 0.3 * r * from.normal, Probe::Role::reflection});
    probe.geometry.push_back(
        {"N_k", origin + to.centre, origin + to.centre + 0.3 * r * to.normal, Probe::Role::refraction});
    probe.visited.push_back(outline(to, origin, "patch k", look::kRefractionRay));
}

} // namespace

std::optional<std::uint32_t> patchSeen(const KeptRoom& kept, const scene::Scene& scene, const trace::EyeHit& hit) {
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
    return patchAt(kept.cells(), triangle, glm::dot(frontWorld, hit.geometricNormalWorld) > 0, vec3(positionMesh));
}

std::optional<std::uint32_t> brightestGiver(const KeptRoom& kept, const LightBalance& balance, std::uint32_t j) {
    std::optional<std::uint32_t> best;
    double most = 0;
    for (std::uint32_t k = 0; k < kept.room().patches().size(); ++k) {
        const dvec3& radiosity = balance.radiosity()[k];
        const double given = kept.exchange().matrix(j, k) * (radiosity.r + radiosity.g + radiosity.b);
        if (given > most) {
            most = given;
            best = k;
        }
    }
    return best;
}

void describePatch(const KeptRoom& kept, const Sources& sources, const LightBalance& balance, std::uint32_t j,
                   int light, std::optional<std::uint32_t> partner, Probe& probe) {
    const Patch& patch = kept.room().allPatches()[j];
    const std::size_t exchanging = kept.room().patches().size();
    const dvec3 radiosity = balance.radiosity()[j], arriving = balance.irradiance()[j];
    const dvec3 fromPatches = arriving - sources.irradiance(j);
    probe.facts.push_back(probeCount("j: patch", j, "of " + std::to_string(sources.size())));
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
    if (light >= 0) probe.facts.push_back(probeFact("visible share of the light", kept.light(light).seenArea[j]));
    probe.visited.push_back(outline(patch, kept.room().world().originWorld, "patch j", look::kReflectionRay));
    if (j >= exchanging) {
        probe.facts.push_back({"form factors", "none: nothing lies before it", ""});
        return;
    }
    probe.facts.push_back(probeFact("sum of form factors", kept.exchange().rowSums[j]));
    if (balance.solver()) {
        const dvec3 bound = balance.solver()->errorBound().largest;
        probe.facts.push_back(probeFact("error of B by solving, at most", bound, "W/m^2"));
    }
    if (partner && *partner != j && *partner < exchanging) describePair(kept, balance, j, *partner, probe);
}

} // namespace shadowlab::radiosity
