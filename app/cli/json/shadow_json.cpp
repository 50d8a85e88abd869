// SPDX-License-Identifier: MIT
#include "app/cli/json/probe_parts.h"

#include <algorithm>
#include <cmath>

#include "techniques/probed/map_probe.h"
#include "techniques/probed/plane_probe.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::cli {

namespace {

Json texel(const ivec2& t) { return {t.x, t.y}; }

Json tapsJson(const std::vector<MapProbe::Tap>& taps) {
    Json json = Json::array();
    for (const MapProbe::Tap& tap : taps)
        json.push_back({{"texel", texel(tap.texel)},
                        {"place", {tap.placeTexels.x, tap.placeTexels.y}},
                        {"stored", tap.stored},
                        {"compared", tap.compared},
                        {"weight", tap.weight},
                        {"lit", tap.isLit}});
    return json;
}

Json searchJson(const MapProbe& map) {
    if (!map.search) return {};
    const MapProbe::BlockerSearch& search = *map.search;
    const bool any = search.found > 0;
    return {{"looks", tapsJson(search.looks)},
            {"found", search.found},
            {"d_r", search.receiverMetres},
            {"d_b", any ? Json(search.blockerMetres) : Json()},
            {"w_L", search.lightMetres},
            {"w", any ? Json(search.penumbraMetres) : Json()},
            {"searchRadiusTexels", search.searchTexels},
            {"filterRadiusTexels", any ? Json(search.kernelTexels) : Json()}};
}

Json momentsJson(const MapProbe& map) {
    if (!map.moments) return {};
    Json read = Json::object(), bounds = Json::array();
    for (const auto& [name, value] : map.moments->read)
        read[name] = numberJson(value);
    for (const MapProbe::Moments::Bound& bound : map.moments->bounds)
        bounds.push_back({{"of", bound.of},
                          {"compared", numberJson(bound.compared)},
                          {"mean", numberJson(bound.mean)},
                          {"variance", numberJson(bound.variance)},
                          {"visibility", numberJson(bound.visibility)}});
    return {{"z", map.moments->depth},
            {"read", read},
            {"bounds", bounds},
            {"bound", numberJson(map.moments->unreduced)},
            {"visibility", numberJson(map.moments->visibility)}};
}

const char* nameOfPart(VolumeProbe::Part part) {
    switch (part) {
    case VolumeProbe::Part::side: return "side";
    case VolumeProbe::Part::topCap: return "top cap";
    case VolumeProbe::Part::bottomCap: return "bottom cap";
    }
    return "";
}

} // namespace

Json decisionJson(const Probe& probe) {
    if (!probe.decision) return {};
    const auto& blocker = probe.decision->blocker;
    return {{"visibility", probe.decision->visibility},
            {"turnedAway", probe.decision->isTurnedAway},
            {"error", textJson(probe.decision->why)},
            {"blocker", blocker ? Json{{"object", blocker->object}, {"triangle", blocker->triangle}} : Json()}};
}

Json volumeJson(const Probe& probe) {
    if (!probe.find<VolumeProbe>()) return {};
    const VolumeProbe& volume = *probe.find<VolumeProbe>();
    Json faces = Json::array();
    for (const VolumeProbe::Crossing& crossing : volume.crossings) {
        const bool isSide = crossing.part == VolumeProbe::Part::side;
        faces.push_back({{"object", crossing.object},
                         {"part", nameOfPart(crossing.part)},
                         {"edge", isSide ? Json{crossing.of[0], crossing.of[1]} : Json()},
                         {"triangle", isSide ? Json() : Json(crossing.of[0])},
                         {"distance", numberJson(crossing.distance)},
                         {"sign", crossing.sign},
                         {"beyond", crossing.beyond},
                         {"way", crossing.method == CountMethod::zPass ? "z-pass" : "z-fail"},
                         {"counted", crossing.counted},
                         {"uncounted", textJson(crossing.uncounted)}});
    }
    Json casters = Json::array();
    for (const VolumeProbe::Caster& caster : volume.casters)
        casters.push_back({{"object", caster.object},
                           {"picked", caster.isPicked},
                           {"holdsThePoint", caster.holdsThePoint},
                           {"triangles", caster.facing.size()},
                           {"towardLight", std::ranges::count_if(caster.facing, [](int sign) { return sign > 0; })},
                           {"outlineEdges", caster.outline.size()},
                           {"topCap", caster.topCap.size() / 3},
                           {"sides", caster.sides.size() / 3},
                           {"bottomCap", caster.bottomCap.size() / 3},
                           {"distance", caster.distance ? Json(*caster.distance) : Json()},
                           {"endPlane", caster.endWorld ? vectorJson(*caster.endWorld) : Json()}});
    return {{"zPass", {{"n_f", volume.frontsBefore}, {"n_b", volume.backsBefore}}},
            {"zFail", {{"n_f", volume.frontsBeyond}, {"n_b", volume.backsBeyond}}},
            {"eyeIn", volume.eyeCount},
            {"start", volume.start},
            {"count", volume.count},
            {"stencil", volume.stencil},
            {"faces", faces},
            {"casters", casters}};
}

Json mapJson(const Probe& probe) {
    if (!probe.find<MapProbe>()) return {};
    const MapProbe& map = *probe.find<MapProbe>();
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row)
        rows.push_back(vectorJson(glm::transpose(map.lightClipFromLightRelative)[row]));
    return {{"map", map.layerName},
            {"layer", map.layer},
            {"originWorld", vectorJson(map.originWorld)},
            {"lightClipFromLightRelative", rows},
            {"resolution", map.resolution},
            {"texel", texel(map.texel)},
            {"texelWidth", map.texelMetres},
            {"str", vectorJson(map.str)},
            {"first", map.first},
            {"stored", map.stored},
            {"compared", map.compared},
            {"metres",
             {{"first", map.firstMetres},
              {"stored", map.storedMetres},
              {"point", map.pointMetres},
              {"compared", map.comparedMetres}}},
            {"blocker", map.blockerWorld ? vectorJson(*map.blockerWorld) : Json()},
            {"taps", tapsJson(map.taps)},
            {"search", searchJson(map)},
            {"moments", momentsJson(map)}};
}

Json passesJson(const Probe& probe) {
    if (probe.passes.empty()) return {};
    Json passes = Json::array();
    for (const Probe::DrawnPass& pass : probe.passes)
        passes.push_back({{"id", pass.id},
                          {"light", pass.light < 0 ? Json() : Json(pass.light)},
                          {"triangles", pass.triangles},
                          {"what", pass.what}});
    return passes;
}

Json planeJson(const Probe& probe) {
    if (!probe.find<PlaneProbe>()) return {};
    const PlaneProbe& plane = *probe.find<PlaneProbe>();
    Json covers = Json::array();
    for (const PlaneProbe::Cover& cover : plane.covers)
        covers.push_back({{"object", cover.object},
                          {"triangle", cover.triangle},
                          {"point", vectorJson(cover.placeWorld)},
                          {"height", cover.height},
                          {"weight", cover.weight},
                          {"casts", cover.casts},
                          {"why", textJson(cover.why)}});
    if (!plane.receives) {
        Json others = Json::array();
        for (const PlaneProbe::Other& other : plane.others)
            others.push_back({{"object", other.object}, {"plane", vectorJson(other.planeWorld)}});
        return {
            {"plane", Json()}, {"light", vectorJson(plane.lightWorld)}, {"others", others}, {"covers", Json::array()}};
    }
    return {{"plane", vectorJson(plane.planeWorld)},
            {"light", vectorJson(plane.lightWorld)},
            {"lightHeight", plane.lightHeight},
            {"covers", covers}};
}

} // namespace shadowlab::cli
