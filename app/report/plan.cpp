// SPDX-License-Identifier: MIT
#include "app/report/plan.h"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "techniques/foundation/base/error.h"

namespace shadowlab::report {

namespace {

std::vector<std::string> words(std::string_view text) {
    std::istringstream stream{std::string(text)};
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    return words;
}

bool isFor(const Sweep& sweep, const scene::Light& light) {
    switch (sweep.lights) {
    case Sweep::Lights::withArea: return scene::hasArea(light);
    case Sweep::Lights::directional: return light.type == scene::LightType::directional;
    case Sweep::Lights::any: break;
    }
    return true;
}

/// The number itself; of what is no number its place among the values.
double valueOf(const std::string& text, std::size_t place) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() ? value : static_cast<double>(place);
}

} // namespace

std::vector<PointKey> pointsOf(const TechniqueInfo& technique, const scene::Light& light, bool quick) {
    const std::string id(technique.id);
    std::vector<PointKey> points;
    for (const Sweep& sweep : technique.sweeps) {
        if (!isFor(sweep, light) || (quick && sweep.onlyFull)) continue;
        PointKey point{id, words(sweep.settings), std::string(sweep.title), std::string(sweep.varies), 0};
        if (sweep.varies.empty()) points.push_back(point);
        const std::vector<std::string> values = words(sweep.values);
        const std::vector<std::string> chosen = quick && !sweep.quick.empty() ? words(sweep.quick) : values;
        for (const std::string& value : chosen) {
            PointKey varied = point;
            varied.settings.push_back(varied.varies + "=" + value);
            varied.value = valueOf(value, static_cast<std::size_t>(std::ranges::find(values, value) - values.begin()));
            points.push_back(std::move(varied));
        }
    }
    if (points.empty()) points.push_back({id, {}, "", "", 0});
    return points;
}

Shard shardFrom(const std::string& text) {
    const auto refuse = [&] {
        throw Error(ExitStatus::usage, "--shard: '" + text +
                                           "' is not I/N with 1 <= I <= N <= 10000; write 2/5 for the "
                                           "second of five");
    };
    Shard shard;
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) refuse();
    const auto number = [&](std::size_t from, std::size_t to, int& value) {
        const auto [end, error] = std::from_chars(text.data() + from, text.data() + to, value);
        if (error != std::errc{} || end != text.data() + to) refuse();
    };
    number(0, slash, shard.number);
    number(slash + 1, text.size(), shard.count);
    constexpr int kMost = 10000; // far more machines than are used for one report, and few enough for an int
    if (shard.number < 1 || shard.number > shard.count || shard.count > kMost) refuse();
    return shard;
}

std::vector<PlannedGroup> shardOf(const Plan& plan, const Shard& shard) {
    std::vector<PlannedGroup> groups;
    int dealt = 0;
    for (const PlannedGroup& group : plan.groups) {
        PlannedGroup part = group;
        part.points.clear();
        for (const PointKey& point : group.points)
            if (point.technique != kYardstick && dealt++ % shard.count == shard.number - 1)
                part.points.push_back(point);
        const bool isAlone = group.points.size() == 1 && shard.number == 1;
        if (part.points.empty() && !isAlone) continue;
        part.points.insert(part.points.begin(), group.points.front());
        groups.push_back(std::move(part));
    }
    return groups;
}

std::string difference(const Plan& a, const Plan& b) {
    if (a.program != b.program) return "of version " + a.program + ", this is " + b.program;
    if (a.build != b.build) return "made by another build of the program, or with other shaders, plug-ins or fonts";
    if (a.size != b.size)
        return "of pictures of " + std::to_string(a.size.x) + "x" + std::to_string(a.size.y) + ", not " +
               std::to_string(b.size.x) + "x" + std::to_string(b.size.y);
    if (a.isQuick != b.isQuick) return a.isQuick ? "a quick one" : "not a quick one";
    if (a.renderer != b.renderer) return "drawn by '" + a.renderer + "', not '" + b.renderer + "'";
    if (a.furtherWords != b.furtherWords) return "made with other --backend, --software, --allow, --plugin or --limit";
    return "of other scenes, techniques or lights";
}

} // namespace shadowlab::report
