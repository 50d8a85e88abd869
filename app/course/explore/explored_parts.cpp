// SPDX-License-Identifier: MIT
#include "app/course/explore/explored_parts.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "app/drawing/drawing.h"
#include "app/figures/figures.h"
#include "app/picture/labels.h"
#include "app/picture/pixel_verdict.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::course {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kLongestFact = 2000; ///< characters; names out of a file could be of any length

std::vector<std::uint8_t> deflated(const std::string& text) {
    std::vector<std::uint8_t> bytes(compressBound(static_cast<uLong>(text.size())));
    uLongf length = static_cast<uLongf>(bytes.size());
    if (compress2(bytes.data(), &length, reinterpret_cast<const Bytef*>(text.data()), static_cast<uLong>(text.size()),
                  Z_BEST_COMPRESSION) != Z_OK)
        throw std::bad_alloc();
    bytes.resize(length);
    return bytes;
}

} // namespace

Json legendJson(const picture::Panel& panel) {
    Json legend = Json::array();
    if (!picture::hasScale(panel.kind))
        for (const KeyEntry& entry : panel.display.key)
            legend.push_back({drawing::colorText(entry.colorLinear), entry.label});
    return legend;
}

Json scaleJson(const picture::Panel& panel) {
    if (!picture::hasScale(panel.kind)) return {};
    const std::string unit = panel.display.unit.empty() ? "" : " " + panel.display.unit;
    Json colors = Json::array();
    for (const vec3& color : picture::paletteOf(panel.kind))
        colors.push_back(drawing::colorText(color));
    return {{"from", picture::shortNumber(panel.display.minimum)},
            {"to", picture::shortNumber(panel.display.maximum) + unit},
            {"colors", std::move(colors)}};
}

image::Image centred(const image::Image& picture, ivec2 size) {
    if (picture.width == size.x && picture.height == size.y) return picture;
    image::Image whole(size.x, size.y);
    image::blit(whole, (size.x - picture.width) / 2, (size.y - picture.height) / 2, picture);
    return whole;
}

std::vector<dvec2> askedPoints(int wanted) {
    std::vector<dvec2> points;
    if (wanted <= 0) return points;
    const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(wanted / lab::kPlacesAspect))));
    const int columns = std::max(1, static_cast<int>(std::lround(double(wanted) / rows)));
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            points.emplace_back((column + 0.5) / columns, (row + 0.5) / rows);
    return points;
}

std::vector<std::uint8_t> answerOf(picture::Slot& slot, const scene::Snapshot& snapshot, const View& view, int light,
                                   const image::Font& font, const image::Font& bold) {
    const Probe probe = slot.technique->probe(snapshot, view, *view.picked, light);
    const picture::PixelVerdict verdict = picture::pixelVerdict(probe);
    Json facts = Json::array();
    for (const std::string& sum : verdict.sums)
        facts.push_back({"", scene::shown(sum, kLongestFact)});
    for (const Probe::Fact& fact : probe.facts)
        facts.push_back({fact.label, scene::shown(fact.value, kLongestFact) + (fact.unit.empty() ? "" : " " + fact.unit)});
    std::string figure;
    try {
        figure = figures::findFigure("pixel").draw({probe, slot.info->id, *snapshot, view, light, font, bold}).document();
    } catch (const Error& error) {
        if (error.status() == ExitStatus::bug) throw;
        // The pixel shows no surface, or what it shows has nothing to draw: the verdict says so.
    }
    const Json answer{{"verdict", scene::shown(verdict.sentence, kLongestFact)}, {"facts", std::move(facts)}, {"figure", figure}};
    return deflated(answer.dump(-1, ' ', false, Json::error_handler_t::replace));
}

} // namespace shadowlab::course
