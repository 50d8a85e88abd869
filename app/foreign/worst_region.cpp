// SPDX-License-Identifier: MIT
#include "app/foreign/worst_region.h"

#include <algorithm>
#include <map>

namespace shadowlab::foreign {

namespace {

using judge::Verdict;

constexpr int kApart = 3; // pixels: acne's stripes are closer, two objects' shadows are not

bool isWrongAt(const Evidence& evidence, std::size_t i) {
    const Verdict verdict = evidence.judgement.verdicts[i];
    return verdict == Verdict::falseLit || verdict == Verdict::falseShadow;
}

struct Found {
    Region region;
    std::map<std::uint32_t, int> objects;
    bool hasFirst = false;
};

void addPixel(const Evidence& evidence, ivec2 pixel, Found& found) {
    const std::size_t i = evidence.truth.index(pixel.x, pixel.y);
    Region& region = found.region;
    if (region.pixels == 0) region.corner = pixel, region.size = ivec2(1), region.firstWrong = pixel;
    const ivec2 end = glm::max(region.corner + region.size, pixel + 1);
    region.corner = glm::min(region.corner, pixel);
    region.size = end - region.corner;
    ++region.pixels;
    ++(evidence.judgement.verdicts[i] == Verdict::falseLit ? region.falseLit : region.falseShadow);
    const auto isBefore = [](ivec2 a, ivec2 b) { return a.y != b.y ? a.y < b.y : a.x < b.x; };
    const bool core = evidence.boundaryPx.values[i] > judge::kCorePx;
    region.core += core;
    // The first of the core errors; until there is one, the first of all.
    if (core && (!found.hasFirst || isBefore(pixel, region.firstWrong))) region.firstWrong = pixel, found.hasFirst = true;
    if (!found.hasFirst && isBefore(pixel, region.firstWrong)) region.firstWrong = pixel;
    ++found.objects[evidence.truth.objects[i]];
}

} // namespace

std::optional<Region> worstRegion(const Evidence& evidence) {
    const ivec2 size = evidence.size();
    judge::Grid<std::uint8_t> seen(size.x, size.y);
    std::optional<Found> worst;
    std::vector<ivec2> open;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            if (seen.at(x, y) || !isWrongAt(evidence, evidence.truth.index(x, y))) continue;
            Found found;
            seen.at(x, y) = 1;
            open.assign(1, {x, y});
            while (!open.empty()) {
                const ivec2 from = open.back();
                open.pop_back();
                addPixel(evidence, from, found);
                const ivec2 least = glm::max(from - kApart, ivec2(0)), most = glm::min(from + kApart, size - 1);
                for (int v = least.y; v <= most.y; ++v)
                    for (int u = least.x; u <= most.x; ++u)
                        if (!seen.at(u, v) && isWrongAt(evidence, evidence.truth.index(u, v))) {
                            seen.at(u, v) = 1;
                            open.push_back({u, v});
                        }
            }
            const auto rank = [](const Found& one) { return std::pair(one.region.core, one.region.pixels); };
            if (!worst || rank(found) > rank(*worst)) worst = std::move(found);
        }
    if (!worst) return std::nullopt;
    Region region = std::move(worst->region);
    const auto most = std::ranges::max_element(worst->objects, {}, [](const auto& entry) { return entry.second; });
    if (most->first != trace::kNoPrimitive) region.object = evidence.tracer.scene().objects[most->first].name;
    return region;
}

std::vector<std::uint8_t> samplesIn(const Evidence& evidence, const Region& region) {
    std::vector<std::uint8_t> within;
    for (const Sample& sample : evidence.samples) {
        const ivec2 from = sample.pixel - region.corner;
        within.push_back(from.x >= 0 && from.y >= 0 && from.x < region.size.x && from.y < region.size.y ? 1 : 0);
    }
    return within;
}

} // namespace shadowlab::foreign
