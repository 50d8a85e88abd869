// SPDX-License-Identifier: MIT
#include "app/cli/json/probe_parts.h"
#include "techniques/probed/radiosity_equations.h"
#include "techniques/probed/rays_probe.h"
#include "techniques/probed/structure_probe.h"

namespace shadowlab::cli {

namespace {

Json vectors(const std::vector<dvec3>& list) {
    Json json = Json::array();
    for (const dvec3& v : list)
        json.push_back(vectorJson(v));
    return json;
}

Json sampleJson(const RaysProbe::Sample& sample) {
    Json json{{"place", vectorJson(sample.place)},
              {"subpixel",
               sample.subpixel ? Json{vectorJson((*sample.subpixel)[0]), vectorJson((*sample.subpixel)[1])} : Json()},
              {"from", vectorJson(sample.fromWorld)},
              {"to", sample.meets ? vectorJson(sample.toWorld) : Json()},
              {"object", textJson(sample.object)},
              {"time", sample.time},
              {"I", vectorJson(sample.intensity)},
              {"reflected", vectorJson(sample.reflectedWorld)},
              {"refracted", vectorJson(sample.refractedWorld)},
              {"onLight", vectorJson(sample.onLightWorld)},
              {"arrives", sample.onLightWorld ? Json(sample.arrives) : Json()}};
    return json;
}

} // namespace

Json samplesJson(const Probe& probe) {
    if (!probe.find<RaysProbe>()) return {};
    const RaysProbe& rays = *probe.find<RaysProbe>();
    Json samples = Json::array(), movers = Json::array();
    for (const RaysProbe::Sample& sample : rays.samples)
        samples.push_back(sampleJson(sample));
    for (const RaysProbe::Mover& mover : rays.movers)
        movers.push_back({{"object", mover.object}, {"velocity", vectorJson(mover.velocityWorld)}});
    return {{"count", rays.count},
            {"aperture", rays.aperture},
            {"focus", rays.focus},
            {"shutter", rays.shutter},
            {"movers", movers},
            {"glossDegrees", rays.glossDegrees},
            {"translucencyDegrees", rays.translucencyDegrees},
            {"exactShare", numberJson(rays.exactShare)},
            {"sampledShare", numberJson(rays.sampledShare())},
            {"mean", vectorJson(rays.mean())},
            {"rays", samples}};
}

Json structureJson(const Probe& probe) {
    if (!probe.find<StructureProbe>()) return {};
    const StructureProbe& structure = *probe.find<StructureProbe>();
    Json volumes = Json::array(), cells = Json::array();
    for (const StructureProbe::Volume& volume : structure.volumes)
        volumes.push_back({{"level", volume.level},
                           {"parent", volume.parent < 0 ? Json() : Json(volume.parent)},
                           {"ball", volume.isBall},
                           {"lower", vectorJson(volume.lowerWorld)},
                           {"upper", vectorJson(volume.upperWorld)},
                           {"object", textJson(volume.object)},
                           {"asked", volume.isAsked},
                           {"entered", volume.isEntered}});
    for (const StructureProbe::Cell& cell : structure.cells)
        cells.push_back({{"at", {cell.at.x, cell.at.y, cell.at.z}},
                         {"lower", vectorJson(cell.lowerWorld)},
                         {"upper", vectorJson(cell.upperWorld)},
                         {"objects", cell.objects}});
    return {{"volumes", volumes},
            {"counts", {structure.counts.x, structure.counts.y, structure.counts.z}},
            {"cells", cells}};
}

Json equationsJson(const Probe& probe) {
    if (!probe.find<RadiosityEquations>()) return {};
    const RadiosityEquations& equations = *probe.find<RadiosityEquations>();
    return {{"n", equations.count},
            {"patches", equations.patches},
            {"rho", vectors(equations.reflectance)},
            {"E", vectors(equations.emission)},
            {"B", vectors(equations.radiosity)},
            {"F", equations.formFactors},
            {"fromOthers", vectors(equations.fromOthers)}};
}

} // namespace shadowlab::cli
