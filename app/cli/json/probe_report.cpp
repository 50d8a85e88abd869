// SPDX-License-Identifier: MIT
#include "app/cli/json/probe_report.h"

#include <algorithm>

#include "app/cli/json/json_values.h"
#include "app/cli/json/probe_parts.h"
#include "app/cli/text_table.h"
#include "app/picture/pixel_verdict.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/probed/patch_exchange.h"

namespace shadowlab::cli {

namespace {

constexpr std::size_t kLongestName = 200; ///< characters of a name out of a file; no terminal shows more

/// Lines of equal columns, each behind that many blanks.
std::string factLines(const std::vector<Probe::Fact>& facts, std::size_t indent) {
    std::size_t widest = 0;
    for (const Probe::Fact& fact : facts)
        widest = std::max(widest, fact.label.size());
    std::string text;
    for (const Probe::Fact& fact : facts)
        text += std::string(indent, ' ') + fact.label + std::string(widest - fact.label.size() + 2, ' ') +
                scene::shown(fact.value, kLongestName) + (fact.unit.empty() ? "" : " " + fact.unit) + "\n";
    return text;
}

std::size_t depthOf(const std::vector<Probe::Node>& tree, std::size_t index) {
    std::size_t depth = 0;
    for (int parent = tree[index].parent; parent >= 0; parent = tree[static_cast<std::size_t>(parent)].parent)
        ++depth;
    return depth;
}

/// A ray, and below it all that come from it.
void addRay(const std::vector<Probe::Node>& tree, std::size_t index, std::string& text) {
    const Probe::Node& node = tree[index];
    const std::size_t indent = 4 * depthOf(tree, index);
    std::string heading = node.label;
    if (!node.surface.empty()) heading += " to " + node.surface + " on " + scene::shown(node.object, kLongestName);
    if (!node.end.empty()) heading += ": " + scene::shown(node.end, kLongestName);
    text += "\n" + std::string(indent, ' ') + heading + "\n" + factLines(node.facts, indent + 2);
    for (std::size_t i = index + 1; i < tree.size(); ++i)
        if (tree[i].parent == static_cast<int>(index)) addRay(tree, i, text);
}

Json factsJson(const std::vector<Probe::Fact>& facts) {
    Json json = Json::array();
    for (const Probe::Fact& fact : facts) {
        Json value = fact.value;
        if (fact.numbers.size() == 1) value = fact.numbers.front();
        if (fact.numbers.size() > 1) value = fact.numbers;
        json.push_back({{"label", fact.label}, {"value", value}, {"unit", fact.unit}});
    }
    return json;
}

const char* nameOfRole(Probe::Role role) {
    switch (role) {
    case Probe::Role::eye: return "eye";
    case Probe::Role::reflection: return "reflection";
    case Probe::Role::refraction: return "refraction";
    case Probe::Role::arriving: return "shadow ray that arrives";
    case Probe::Role::blocked: return "shadow ray that does not arrive";
    }
    return "";
}

Json patchJson(const PatchProbe& patch) {
    Json corners = Json::array();
    for (const dvec3& corner : patch.cornersWorld)
        corners.push_back(vectorJson(corner));
    return {{"object", patch.object},
            {"corners", corners},
            {"centre", vectorJson(patch.centreWorld)},
            {"normal", vectorJson(patch.normalWorld)},
            {"area", patch.area},
            {"emission", vectorJson(patch.emission)},
            {"reflectance", vectorJson(patch.reflectance)},
            {"radiosity", vectorJson(patch.radiosity)}};
}

Json exchangeJson(const Probe& probe) {
    const auto* const exchange = probe.find<PatchExchange>();
    if (!exchange) return {};
    Json json{{"j", patchJson(exchange->j)}, {"k", Json()}, {"F_jk", Json()}, {"F_kj", Json()}};
    if (!exchange->k) return json;
    json["k"] = patchJson(*exchange->k);
    json["F_jk"] = exchange->formFactorJk;
    json["F_kj"] = exchange->formFactorKj;
    return json;
}

} // namespace

std::string probeText(const ProbedPixel& probed) {
    const picture::PixelVerdict verdict = picture::pixelVerdict(probed.probe);
    std::string text = scene::shown(verdict.sentence, kLongestName) + "\n";
    for (const std::string& sum : verdict.sums)
        text += "  " + scene::shown(sum, kLongestName) + "\n";
    text += "\n" + scene::shown(probed.scene, kLongestName) + ", " + probed.technique + ", " +
                       std::to_string(probed.size.x) + " x " + std::to_string(probed.size.y) + " pixels";
    if (!probed.light.empty()) text += ", light " + scene::shown(probed.light, kLongestName);
    text += "\n\n" + factLines(probed.probe.facts, 0);
    if (!probed.probe.tree.empty()) addRay(probed.probe.tree, 0, text);
    return text;
}

std::string probeJson(const ProbedPixel& probed) {
    Json vectors = Json::object(), rays = Json::array(), tree = Json::array();
    for (const Probe::Vector& one : probed.probe.vectors)
        vectors[one.label] = vectorJson(one.directionWorld);
    for (const Probe::Segment& segment : probed.probe.geometry)
        rays.push_back({{"label", segment.label},
                        {"role", nameOfRole(segment.role)},
                        {"from", vectorJson(segment.fromWorld)},
                        {"to", vectorJson(segment.toWorld)},
                        {"endless", segment.isEndless}});
    for (const Probe::Node& node : probed.probe.tree)
        tree.push_back({{"parent", node.parent < 0 ? Json() : Json(node.parent)},
                        {"label", node.label},
                        {"role", nameOfRole(node.role)},
                        {"sign", textJson(node.sign)},
                        {"surface", textJson(node.surface)},
                        {"object", textJson(node.object)},
                        {"end", textJson(node.end)},
                        {"ray", node.segment < 0 ? Json() : Json(node.segment)},
                        {"facts", factsJson(node.facts)}});
    const picture::PixelVerdict verdict = picture::pixelVerdict(probed.probe);
    const Json json{{"verdict", verdict.sentence},
                    {"sums", verdict.sums},
                    {"scene", probed.scene},
                    {"technique", probed.technique},
                    {"light", textJson(probed.light)},
                    {"size", {probed.size.x, probed.size.y}},
                    {"pixel", {probed.pixel.x, probed.pixel.y}},
                    {"partner", probed.partner ? Json{probed.partner->x, probed.partner->y} : Json()},
                    {"facts", factsJson(probed.probe.facts)},
                    {"vectors", vectors},
                    {"rays", rays},
                    {"tree", tree},
                    {"exchange", exchangeJson(probed.probe)},
                    {"equations", equationsJson(probed.probe)},
                    {"samples", samplesJson(probed.probe)},
                    {"structure", structureJson(probed.probe)},
                    {"decision", decisionJson(probed.probe)},
                    {"volume", volumeJson(probed.probe)},
                    {"map", mapJson(probed.probe)},
                    {"plane", planeJson(probed.probe)},
                    {"passes", passesJson(probed.probe)}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace shadowlab::cli
