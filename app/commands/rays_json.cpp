// SPDX-License-Identifier: MIT
#include "app/commands/rays_json.h"

namespace shadowlab::commands {

namespace {

using Json = nlohmann::ordered_json;

Json vector(const dvec2& v) { return {v.x, v.y}; }
Json vector(const dvec3& v) { return {v.x, v.y, v.z}; }
Json orNull(const std::optional<dvec3>& v) { return v ? vector(*v) : Json(); }
Json orNull(const std::string& text) { return text.empty() ? Json() : Json(text); }
Json orNull(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

Json vectors(const std::vector<dvec3>& list) {
    Json json = Json::array();
    for (const dvec3& v : list)
        json.push_back(vector(v));
    return json;
}

Json sampleJson(const RaysProbe::Sample& sample) {
    Json json{
        {"place", vector(sample.place)},
        {"subpixel", sample.subpixel ? Json{vector((*sample.subpixel)[0]), vector((*sample.subpixel)[1])} : Json()},
        {"from", vector(sample.fromWorld)},
        {"to", sample.meets ? vector(sample.toWorld) : Json()},
        {"object", orNull(sample.object)},
        {"time", sample.time},
        {"I", vector(sample.intensity)},
        {"reflected", orNull(sample.reflectedWorld)},
        {"refracted", orNull(sample.refractedWorld)},
        {"onLight", orNull(sample.onLightWorld)},
        {"arrives", sample.onLightWorld ? Json(sample.arrives) : Json()}};
    return json;
}

} // namespace

Json samplesJson(const Probe& probe) {
    if (!probe.rays) return {};
    const RaysProbe& rays = *probe.rays;
    Json samples = Json::array(), movers = Json::array();
    for (const RaysProbe::Sample& sample : rays.samples)
        samples.push_back(sampleJson(sample));
    for (const RaysProbe::Mover& mover : rays.movers)
        movers.push_back({{"object", mover.object}, {"velocity", vector(mover.velocityWorld)}});
    return {{"count", rays.count},
            {"aperture", rays.aperture},
            {"focus", rays.focus},
            {"shutter", rays.shutter},
            {"movers", movers},
            {"glossDegrees", rays.glossDegrees},
            {"translucencyDegrees", rays.translucencyDegrees},
            {"exactShare", orNull(rays.exactShare)},
            {"sampledShare", orNull(rays.sampledShare())},
            {"mean", vector(rays.mean())},
            {"rays", samples}};
}

Json structureJson(const Probe& probe) {
    if (!probe.structure) return {};
    const StructureProbe& structure = *probe.structure;
    Json volumes = Json::array(), cells = Json::array();
    for (const StructureProbe::Volume& volume : structure.volumes)
        volumes.push_back({{"level", volume.level},
                           {"parent", volume.parent < 0 ? Json() : Json(volume.parent)},
                           {"ball", volume.isBall},
                           {"lower", vector(volume.lowerWorld)},
                           {"upper", vector(volume.upperWorld)},
                           {"object", orNull(volume.object)},
                           {"asked", volume.isAsked},
                           {"entered", volume.isEntered}});
    for (const StructureProbe::Cell& cell : structure.cells)
        cells.push_back({{"at", {cell.at.x, cell.at.y, cell.at.z}},
                         {"lower", vector(cell.lowerWorld)},
                         {"upper", vector(cell.upperWorld)},
                         {"objects", cell.objects}});
    return {{"volumes", volumes},
            {"counts", {structure.counts.x, structure.counts.y, structure.counts.z}},
            {"cells", cells}};
}

Json equationsJson(const Probe& probe) {
    if (!probe.equations) return {};
    const Probe::Equations& equations = *probe.equations;
    return {{"n", equations.count},
            {"patches", equations.patches},
            {"rho", vectors(equations.reflectance)},
            {"E", vectors(equations.emission)},
            {"B", vectors(equations.radiosity)},
            {"F", equations.formFactors},
            {"fromOthers", vectors(equations.fromOthers)}};
}

} // namespace shadowlab::commands
