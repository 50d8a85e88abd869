// SPDX-License-Identifier: MIT
#include "app/commands/shadow_json.h"

#include <cmath>

namespace shadowlab::commands {

namespace {

using Json = nlohmann::ordered_json;

Json vector(const dvec3& v) { return {v.x, v.y, v.z}; }
Json vector(const dvec4& v) { return {v.x, v.y, v.z, v.w}; }
Json texel(const ivec2& t) { return {t.x, t.y}; }
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }
Json orNull(const std::string& text) { return text.empty() ? Json() : Json(text); }

const char* nameOf(VolumeProbe::Part part) {
    switch (part) {
    case VolumeProbe::Part::side: return "side";
    case VolumeProbe::Part::topCap: return "front cap";
    case VolumeProbe::Part::bottomCap: return "back cap";
    }
    return "";
}

} // namespace

Json decisionJson(const Probe& probe) {
    if (!probe.decision) return {};
    return {{"visibility", probe.decision->visibility},
            {"turnedAway", probe.decision->isTurnedAway},
            {"error", orNull(probe.decision->why)}};
}

Json volumeJson(const Probe& probe) {
    if (!probe.volume) return {};
    const VolumeProbe& volume = *probe.volume;
    Json faces = Json::array();
    for (const VolumeProbe::Crossing& crossing : volume.crossings) {
        const bool isSide = crossing.part == VolumeProbe::Part::side;
        faces.push_back({{"object", crossing.object},
                         {"part", nameOf(crossing.part)},
                         {"edge", isSide ? Json{crossing.of[0], crossing.of[1]} : Json()},
                         {"triangle", isSide ? Json() : Json(crossing.of[0])},
                         {"distance", number(crossing.distance)},
                         {"sign", crossing.sign},
                         {"beyond", crossing.beyond},
                         {"way", crossing.way == VolumeProbe::Way::pass ? "z-pass" : "z-fail"},
                         {"counted", crossing.counted},
                         {"uncounted", orNull(crossing.uncounted)}});
    }
    return {{"zPass", {{"n_f", volume.frontsBefore}, {"n_b", volume.backsBefore}}},
            {"zFail", {{"n_f", volume.frontsBeyond}, {"n_b", volume.backsBeyond}}},
            {"eyeIn", volume.eyeCount},
            {"start", volume.start},
            {"count", volume.count},
            {"stencil", volume.stencil},
            {"faces", faces}};
}

Json mapJson(const Probe& probe) {
    if (!probe.map) return {};
    const MapProbe& map = *probe.map;
    Json taps = Json::array();
    for (const MapProbe::Tap& tap : map.taps)
        taps.push_back({{"texel", texel(tap.texel)},
                        {"stored", tap.stored},
                        {"compared", tap.compared},
                        {"weight", tap.weight},
                        {"lit", tap.isLit}});
    return {{"map", map.layerName},
            {"layer", map.layer},
            {"resolution", map.resolution},
            {"texel", texel(map.texel)},
            {"texelWidth", map.texelMetres},
            {"str", vector(map.str)},
            {"first", map.first},
            {"stored", map.stored},
            {"compared", map.compared},
            {"metres",
             {{"first", map.firstMetres},
              {"stored", map.storedMetres},
              {"point", map.pointMetres},
              {"compared", map.comparedMetres}}},
            {"blocker", map.blockerWorld ? vector(*map.blockerWorld) : Json()},
            {"taps", taps}};
}

Json planeJson(const Probe& probe) {
    if (!probe.plane) return {};
    const PlaneProbe& plane = *probe.plane;
    Json covers = Json::array();
    for (const PlaneProbe::Cover& cover : plane.covers)
        covers.push_back({{"object", cover.object},
                          {"triangle", cover.triangle},
                          {"point", vector(cover.placeWorld)},
                          {"height", cover.height},
                          {"weight", cover.weight},
                          {"casts", cover.casts},
                          {"why", orNull(cover.why)}});
    return {{"plane", vector(plane.planeWorld)},
            {"light", vector(plane.lightWorld)},
            {"lightHeight", plane.lightHeight},
            {"covers", covers}};
}

} // namespace shadowlab::commands
